"""Time as a function of the number of elements: throughput from a hundred on, growth from a single one on."""

import os
from typing import NamedTuple

import numpy as np

from .core import BASE, exponential
from .parallel import tiled
from .timing import Job, interleaved, spread

THROUGHPUT = tuple(10**power for power in range(2, 8))
GROWTH = tuple(10**power for power in range(9))
CASES = (
    "chord.descent_time drag",
    "chord.descent_time friction_drag",
    "chord.distance drag",
    "projectile.flight_time drag",
    "projectile.horizontal_range drag",
    "projectile.best_angle",
    "lambert.w0",
)
_SHARE = 0.6  # of the memory that is free
_PATIENCE = 8.0  # seconds that one measurement may take
_SECONDS = 20.0  # and all rounds of one size together


class Point(NamedTuple):
    """Nanoseconds an element of arrays of so many elements."""

    case: str
    contestant: str
    count: int
    ns: tuple


def free_memory():
    """Bytes that can be had, or None where the system does not say."""
    try:
        return os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (ValueError, OSError, AttributeError):
        return None


def needed(case, count):
    """Bytes of the arguments, of results, and of the array that is compared with."""
    return 8 * count * (len(case.arguments) + 2 * len(case.outputs) + 2)


def measure(cases, contestants, sizes, rounds, drawn, tell, progress=None):
    """Times for each size.

    Parameters
    ----------
    cases : list of Case
    contestants : list of Contestant
    sizes : sequence of int
        Elements, in increasing order.
    rounds : int
        At most; long arrays get fewer, at least one.
    drawn : int
        Points that are drawn, and repeated.
    tell : callable
        Called with a sentence for what is left out: too long, or too large for the memory that is free.
    progress : callable, optional
        Called with (sizes done, sizes in all, what comes next).

    Returns
    -------
    list of Point
    """
    found, pace = [], {}
    for done, (case, count) in enumerate([(case, count) for case in cases for count in sizes]):
        if progress is not None:
            progress(done, len(cases) * len(sizes), f"{case.key}, {count}")
        memory = free_memory()
        if memory is not None and needed(case, count) > _SHARE * memory:
            tell(f"{case.key}, {count} elements: {needed(case, count) / 1e9:.1f} GB are not free")
            continue
        arguments = tiled(case, count, drawn)
        jobs = {BASE: exponential(count)}
        for one in contestants:
            if count * pace.get((case.key, one.name), 0.0) > 1e9 * _PATIENCE:
                tell(f"{case.key}, {count} elements: {one.name} would take longer than {_PATIENCE:.0f} s")
            else:
                jobs[one.name] = Job(one.prepare(case, arguments), count)
        longest = count * sum(pace.get((case.key, name), 0.0) for name in jobs) / 1e9
        here = max(1, min(rounds, int(_SECONDS / (2 * longest)) if longest else rounds))
        with np.errstate(all="ignore"):
            samples = interleaved({case.key: jobs}, here)[case.key]
        for name, values in samples.items():
            found.append(Point(case.key, name, count, spread(values)))
            pace[case.key, name] = found[-1].ns.median
    return found
