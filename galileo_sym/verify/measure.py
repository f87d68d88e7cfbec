"""Sample a stratum with certain references, and measure a back end's errors on the sample."""

import math
from array import array
from dataclasses import dataclass

import numpy as np

from .functions import FUNCTIONS
from .reference import reference
from .sampling import Draw
from .screening import Rounded, error_bounds, rounded
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
    arguments : dict of str to ndarray
        The kernel's arguments, in order; of the recorded worst input, if any, last.
    exact : tuple of Rounded
        The results that belong to them, for each output.
    """

    task: Task
    arguments: dict
    exact: tuple

    @property
    def size(self):
        """How many points there are besides the recorded worst input."""
        return len(self.exact[0].value) - (self.task.recorded is not None)

    def point(self, index):
        """The arguments of one point, as floats."""
        return {name: float(values[index]) for name, values in self.arguments.items()}

    def references(self, index):
        """Enclosures of the results at one point: found again, as keeping those of all points takes much more room."""
        return _references(self.task, self.point(index))


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


def _references(task, point):
    absent = FUNCTIONS[task.function].absent_forces(task.force_set)
    return reference(task.function, {**point, **dict.fromkeys(absent, 0.0)})


def _drawn(task, names, stratum):
    """Points of a random stratum with representable results, and their references."""
    draw = Draw(f"{task.seed}:{task.function}:{task.force_set}:{task.stratum}")
    variables, found = set(names), 0
    for _ in range(_TRIES_PER_POINT * task.points):
        values = stratum.draw(draw, variables)
        point = {name: values[name] for name in names}
        results = _references(task, point)
        if all(map(representable, results)):
            yield point, results
            found += 1
            if found == task.points:
                return
    raise VacuousStratumError(
        f"{task.function} [{task.force_set}], stratum {task.stratum}: only {found} of {task.points} points "
        f"have a representable result after {_TRIES_PER_POINT} tries a point; widen the stratum"
    )


def _points(task, names):
    """All points of a task with their references, the recorded worst input last."""
    function = FUNCTIONS[task.function]
    lists = fixed_strata(function, task.force_set)
    if task.stratum in lists:
        listed = [{name: point[name] for name in names} for point in lists[task.stratum]]
        yield from ((point, _references(task, point)) for point in listed)
    else:
        drawn = {stratum.name: stratum for stratum in random_strata(function, task.force_set)}
        yield from _drawn(task, names, drawn[task.stratum])
    if task.recorded is not None:
        yield task.recorded, _references(task, task.recorded)


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
    arguments, exact = array("d"), [array("d") for _ in function.outputs]  # rows one after the other
    for point, results in _points(task, names):
        arguments.extend(point[name] for name in names)
        for column, enclosure in zip(exact, results, strict=True):
            column.extend(rounded(enclosure))
    columns = np.array(arguments).reshape(-1, len(names)).T.copy()
    return Sample(task, dict(zip(names, columns, strict=True)), tuple(map(_as_rounded, exact)))


def _as_rounded(column):
    value, rest, unit = np.array(column).reshape(-1, 3).T.copy()
    return Rounded(value, rest, unit.astype(int))


def evaluate(sample, back_end):
    """A back end's results on a sample: a tuple of arrays, one for each output."""
    function = FUNCTIONS[sample.task.function]
    return back_end.evaluate(function, sample.task.force_set, sample.arguments)


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
    found = [largest(sample, results, place) for place in range(len(results))]
    error, at, of = max(((e, i, place) for place, (e, i) in enumerate(found)), key=lambda one: one[0])
    recorded = None if sample.task.recorded is None else max(_errors(sample, results, -1))
    return Measurement(error, FUNCTIONS[sample.task.function].outputs[of], sample.point(at), recorded)


def largest(sample, results, place):
    """The largest error of one output, and the index of the point it occurs at.

    Parameters
    ----------
    sample : Sample
        The points and references.
    results : tuple of ndarray
        As from `evaluate`.
    place : int
        Which of the outputs.

    Returns
    -------
    error : float
        In ulp.
    index : int
    """
    lower, upper = error_bounds(results[place], sample.exact[place])
    error, at = -1.0, 0
    for index in np.flatnonzero(upper >= lower.max()):
        here = ulp_error(results[place][index], sample.references(index)[place])
        if here > error:
            error, at = here, index
        if error >= upper.max():
            break
    return error, at


def _errors(sample, results, index):
    """The errors of one point, for each output."""
    exact = sample.references(index)
    return [ulp_error(values[index], enclosure) for values, enclosure in zip(results, exact, strict=True)]


def same_bits(first, second):
    """Whether two back ends agree in all bits; any NaN equals any other."""
    return all(
        np.all((one.view(np.uint64) == other.view(np.uint64)) | (np.isnan(one) & np.isnan(other)))
        for one, other in zip(first, second, strict=True)
    )


def as_hex(point):
    """A point with its floats written exactly."""
    return {name: float(value).hex() for name, value in point.items()}


def from_hex(point):
    """The inverse of `as_hex`; ValueError if a value is no finite hexadecimal float."""
    values = {name: float.fromhex(text) for name, text in point.items()}
    if not all(map(math.isfinite, values.values())):
        raise ValueError("infinite or NaN input")
    return values
