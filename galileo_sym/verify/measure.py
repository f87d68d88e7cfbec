"""Sample a stratum with certain references, and measure a back end's errors on the sample."""

import math
from dataclasses import dataclass

import numpy as np

from .functions import FUNCTIONS
from .reference import reference
from .sampling import Draw
from .strata import fixed_strata, random_strata
from .ulp import representable, ulp_error

_TRIES_PER_POINT = 40


class VacuousStratumError(Exception):
    """A stratum yields too few points with a result that floating point can hold."""


@dataclass(frozen=True)
class Task:
    """One stratum of one kernel to be sampled.

    Attributes
    ----------
    function, force_set, stratum : str
        Which; the function by its full name.
    points : int
        How many points to draw; strata that are lists have their own number.
    seed : int
        Of the draw.
    recorded : dict of str to float or None
        A worst input recorded earlier, tried as well.
    """

    function: str
    force_set: str
    stratum: str
    points: int
    seed: int
    recorded: dict | None = None


@dataclass(frozen=True)
class Sample:
    """Points of a stratum and their references.

    Attributes
    ----------
    task : Task
        What was asked for.
    arguments : dict of str to list of float
        The kernel's arguments, in order.
    references : list of tuple of Enclosure
        One enclosure an output for each point. The recorded worst input, if any, comes last.
    """

    task: Task
    arguments: dict
    references: list

    @property
    def size(self):
        """How many points there are besides the recorded worst input."""
        return len(self.references) - (self.task.recorded is not None)


@dataclass(frozen=True)
class Measurement:
    """Errors of one back end on a sample.

    Attributes
    ----------
    error : float
        The largest, in ulp.
    output : str
        The output it is of.
    worst : dict of str to float
        The input it occurs at.
    recorded_error : float or None
        The error at the recorded worst input.
    """

    error: float
    output: str
    worst: dict
    recorded_error: float | None


def _drawn(function, task, stratum):
    """Points of a random stratum with representable results, and their references."""
    names = function.arguments(task.force_set)
    absent = dict.fromkeys(function.absent_forces(task.force_set), 0.0)
    draw = Draw(f"{task.seed}:{task.function}:{task.force_set}:{task.stratum}")
    found = []
    for _ in range(_TRIES_PER_POINT * task.points):
        if len(found) == task.points:
            break
        values = stratum.draw(draw, set(names))
        point = {name: values[name] for name in names}
        results = reference(task.function, point | absent)
        if all(map(representable, results)):
            found.append((point, results))
    if len(found) < task.points:
        raise VacuousStratumError(
            f"{task.function} [{task.force_set}], stratum {task.stratum}: only {len(found)} of {task.points} points "
            f"have a representable result after {_TRIES_PER_POINT} tries a point; widen the stratum"
        )
    return found


def take_sample(task):
    """Draw the points of a task and compute their references.

    Parameters
    ----------
    task : Task
        With a known function, force set and stratum.

    Returns
    -------
    Sample

    Raises
    ------
    VacuousStratumError
        If too few of the points drawn have representable results.
    """
    function = FUNCTIONS[task.function]
    names = function.arguments(task.force_set)
    absent = dict.fromkeys(function.absent_forces(task.force_set), 0.0)
    lists = fixed_strata(function, task.force_set)
    if task.stratum in lists:
        points = [{name: point[name] for name in names} for point in lists[task.stratum]]
        found = [(point, reference(task.function, point | absent)) for point in points]
    else:
        drawn = {stratum.name: stratum for stratum in random_strata(function, task.force_set)}
        found = _drawn(function, task, drawn[task.stratum])
    if task.recorded is not None:
        found.append((task.recorded, reference(task.function, task.recorded | absent)))
    arguments = {name: [point[name] for point, _ in found] for name in names}
    return Sample(task, arguments, [results for _, results in found])


def evaluate(sample, back_end):
    """A back end's results on a sample: a tuple of arrays, one for each output."""
    function = FUNCTIONS[sample.task.function]
    arrays = {name: np.array(values) for name, values in sample.arguments.items()}
    return back_end.evaluate(function, sample.task.force_set, arrays)


def measure(sample, results):
    """Errors of the results of a back end.

    Parameters
    ----------
    sample : Sample
        The points and references.
    results : tuple of ndarray
        As from `evaluate`.

    Returns
    -------
    Measurement
    """
    outputs = FUNCTIONS[sample.task.function].outputs
    largest, at, of = -1.0, 0, outputs[0]
    last = 0.0
    for index, exact in enumerate(sample.references):
        last = 0.0
        for name, values, enclosure in zip(outputs, results, exact, strict=True):
            error = ulp_error(values[index], enclosure)
            last = max(last, error)
            if error > largest:
                largest, at, of = error, index, name
    worst = {name: values[at] for name, values in sample.arguments.items()}
    return Measurement(largest, of, worst, None if sample.task.recorded is None else last)


def first_difference(first, second):
    """The first point at which two back ends differ in bits; any NaN equals any other.

    Returns
    -------
    int or None
        Its index, or None if they agree.
    """
    for one, other in zip(first, second, strict=True):
        differing = (one.view(np.uint64) != other.view(np.uint64)) & ~(np.isnan(one) & np.isnan(other))
        if differing.any():
            return int(np.flatnonzero(differing)[0])
    return None


def as_hex(point):
    """A point with its floats written exactly."""
    return {name: float(value).hex() for name, value in point.items()}


def from_hex(point):
    """The inverse of `as_hex`; ValueError if a value is no finite hexadecimal float."""
    values = {name: float.fromhex(text) for name, text in point.items()}
    if not all(map(math.isfinite, values.values())):
        raise ValueError("infinite or NaN input")
    return values
