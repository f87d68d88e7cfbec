"""Interleaved rounds: every job is timed once a round, in rotated order, so that a slow moment slows all alike."""

import gc
import time
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

_LEAST = 100_000  # ns: a shorter job is repeated within one measurement, so that the clock's own cost is small
_MOST_REPEATS = 1000
_TRIED = 1000
_LONG = 10_000_000  # ns: a longer job finds nothing in the cache anyway


@dataclass(frozen=True)
class Job:
    """A call to be timed, and how many elements it computes."""

    call: object
    count: int


class Spread(NamedTuple):
    """A median between its quartiles."""

    median: float
    low: float
    high: float


class Timing(NamedTuple):
    """Nanoseconds an element, and how many times the base of the same round that is."""

    ns: Spread
    ratio: Spread


def spread(values):
    """Median and quartiles of numbers."""
    low, middle, high = np.percentile(values, (25, 50, 75)).tolist()
    return Spread(middle, low, high)


def _elapsed(job, repeats):
    start = time.perf_counter_ns()
    for _ in range(repeats):
        job.call()
    return (time.perf_counter_ns() - start) / (repeats * job.count)


def _plan(job):
    """How often a job is called in one measurement, and whether it is called once before: what is long need not be."""
    once = _elapsed(job, 1) * job.count
    if once < _LONG:
        once = max(1.0, _elapsed(job, 1) * job.count)
    return int(min(_MOST_REPEATS, max(1, _LEAST // once))), once < _LONG


def interleaved(groups, rounds, progress=None):
    """Time jobs in interleaved rounds.

    Parameters
    ----------
    groups : dict of (object to dict of (str to Job))
        Jobs that are compared stand in one group, and run one after the other.
    rounds : int
        How often each job is measured, each time after a call that is not.
    progress : callable, optional
        Called with (rounds done, rounds in all, "").

    Returns
    -------
    dict of (object to dict of (str to list of float))
        Nanoseconds an element, one number a round.
    """
    plans = {place: {name: _plan(job) for name, job in jobs.items()} for place, jobs in groups.items()}
    found = {place: {name: [] for name in jobs} for place, jobs in groups.items()}
    collecting = gc.isenabled()
    gc.disable()
    try:
        for done in range(rounds):
            for place in rotated(list(groups), done):
                for name in rotated(list(groups[place]), done):
                    job, (repeats, warm) = groups[place][name], plans[place][name]
                    if warm:
                        job.call()  # what ran before has left other data in the cache
                    found[place][name].append(_elapsed(job, repeats))
            if progress is not None:
                progress(done + 1, rounds, "")
    finally:
        if collecting:
            gc.enable()
    return found


def fitting(make, count, limit):
    """The largest number of elements, up to `count`, of which one call takes no longer than a limit.

    Parameters
    ----------
    make : callable
        Takes a number of elements, gives a call without arguments.
    count : int
    limit : float
        Nanoseconds; estimated from a call of at most a thousand elements.
    """
    tried = min(count, _TRIED)
    job = Job(make(tried), tried)
    job.call()
    return max(1, min(count, int(limit / max(_elapsed(job, 1), 1e-3))))


def rotated(items, by):
    """A list begun at another place."""
    start = by % len(items) if items else 0
    return items[start:] + items[:start]


def against(samples, base):
    """Timings of a group, each round held against the base of that round.

    Parameters
    ----------
    samples : dict of str to list of float
        As from `interleaved`, of one group.
    base : str
        The job that ratios are to.

    Returns
    -------
    dict of str to Timing
    """
    unit = np.array(samples[base])
    return {name: Timing(spread(values), spread(np.array(values) / unit)) for name, values in samples.items()}
