"""The core of the benchmark: all contestants on all cases, errors first, then times in interleaved rounds."""

import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from . import accuracy
from .timing import Job, against, fitting, interleaved

BASE = "numpy.exp"
ARRAYS, SCALARS = "arrays", "scalars"
_PATIENCE = 2e7  # ns: slow contestants get fewer elements, so that a call takes no longer


class Row(NamedTuple):
    """What was measured of one contestant on one case.

    Attributes
    ----------
    case : str
        Key of the case.
    contestant : str
    layout : str
        Whether all arguments are arrays, or those after the positional ones numbers.
    count : int
        Elements of a call.
    ns, ratio : Spread
        Nanoseconds an element; times those of numpy.exp in the same round.
    ulp, lost : float
        As in `accuracy.Error`.
    """

    case: str
    contestant: str
    layout: str
    count: int
    ns: tuple
    ratio: tuple
    ulp: float
    lost: float


@dataclass
class Found:
    """Rows, and what went wrong: `problems` with this package's own code, `notes` on others."""

    rows: list = field(default_factory=list)
    problems: list = field(default_factory=list)
    notes: list = field(default_factory=list)


class Size(NamedTuple):
    """How much is measured.

    Attributes
    ----------
    points : int
        Elements of an array.
    rounds : int
    sample : int
        Points at which errors are measured.
    """

    points: int
    rounds: int
    sample: int


def exponential(count):
    """The job that ratios are to: numpy.exp on as many doubles, into an array made before."""
    x, out = np.random.default_rng(0).uniform(-10.0, 10.0, count), np.empty(count)
    return Job(lambda: np.exp(x, out=out), count)


def with_scalars(case, arguments):
    """The arguments after the positional ones as numbers, those of the point whose last positional one is largest.

    At those every other point has a result: a steeper chord slides with less friction, and what reaches farther
    reaches all that is nearer.
    """
    at = int(np.argmax(np.abs(arguments[case.positional[-1]])))
    return {name: x if name in case.positional else float(x[at]) for name, x in arguments.items()}


def layouts(case, contestant, arguments):
    """The forms in which a contestant is called on a case: arguments by layout."""
    found = {ARRAYS: arguments}
    if 0 < len(case.positional) < len(case.arguments) and contestant.takes_numbers(case):
        found[SCALARS] = with_scalars(case, arguments)
    return found


def errors(cases, contestants, own, size, found):
    """The error of each contestant on each case it can evaluate, by key and name; failures go to `found`."""
    wrong = {}
    for case in cases:
        serving = [one for one in contestants if one.serves(case)]
        samples = {single: accuracy.take(case, size.sample, single) for single in {one.single for one in serving}}
        for one in serving:
            sample = samples[one.single]
            try:
                error = accuracy.judge(one.results(case, sample.arguments), sample)
            except Exception as cause:  # any failure of a contestant is a finding, and the others still count
                list_ = found.problems if one.name in own else found.notes
                list_.append(f"{one.name}, {case.key}: {type(cause).__name__}: {cause}")
                continue
            if one.name in own and error.lost:
                found.problems.append(f"{one.name}, {case.key}: no number at {error.lost:.1%} of the sampled points")
            wrong[case.key, one.name] = error
    return wrong


def _first(arguments, count):
    """So many elements of the arrays among arguments."""
    return {name: x[:count] if isinstance(x, np.ndarray) else x for name, x in arguments.items()}


def jobs(case, contestants, wrong, points):
    """What is timed of a case: jobs by contestant and layout, and the base."""
    drawn = case.points(points)
    made = {(BASE, ARRAYS): exponential(points)}
    for one in contestants:
        if (case.key, one.name) not in wrong:
            continue
        most = min(points, one.most or points)
        for layout, arguments in layouts(case, one, drawn).items():

            def make(count, one=one, arguments=arguments):
                return one.prepare(case, _first(arguments, count))

            count = fitting(make, most, _PATIENCE)
            made[one.name, layout] = Job(make(count), count)
    return made


def measure(cases, contestants, own, size, progress: Callable | None = None):
    """Measure errors and times.

    Parameters
    ----------
    cases : list of Case
    contestants : list of Contestant
    own : set of str
        Names of the contestants that are this package's own code.
    size : Size
    progress : callable, optional
        Called with (rounds done, rounds in all, "").

    Returns
    -------
    Found
    """
    found = Found()
    wrong = errors(cases, contestants, own, size, found)
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        groups = {case.key: jobs(case, contestants, wrong, size.points) for case in cases}
        samples = interleaved(groups, size.rounds, progress)
    for key, made in groups.items():
        timings = against(samples[key], (BASE, ARRAYS))
        for (name, layout), timing in timings.items():
            error = wrong.get((key, name), accuracy.Error(float("nan"), 0.0))
            found.rows.append(Row(key, name, layout, made[name, layout].count, *timing, *error))
    return found
