"""The largest error of a contestant on a sample of a case: in ulp of its own format, against certain references."""

import math
from typing import NamedTuple

import numpy as np

from galileo_sym.verify.screening import Rounded, error_bounds, rounded
from galileo_sym.verify.ulp import BINARY32, BINARY64, representable

_TRIES_PER_POINT = 3
_SEED = 1  # other points than those that are timed
_WIDER = BINARY64.precision - BINARY32.precision


class TooFewPoints(Exception):
    """A case has too few points whose results the format can hold."""


class Sample(NamedTuple):
    """Points of a case: arguments by name, as arrays of float64, and the exact results of each output."""

    arguments: dict
    exact: tuple


class Error(NamedTuple):
    """What a contestant got wrong.

    Attributes
    ----------
    ulp : float
        The largest error over its finite results; the true maximum is at least about that. NaN if none is finite.
    lost : float
        Share of the points at which it gave no number where there is one, or a number where there is none.
    """

    ulp: float
    lost: float


def take(case, count, single=False):
    """Draw points with representable results.

    Parameters
    ----------
    case : Case
    count : int
    single : bool
        Whether arguments and results are those of binary32.

    Returns
    -------
    Sample

    Raises
    ------
    TooFewPoints
    """
    form = BINARY32 if single else BINARY64
    drawn = case.points(_TRIES_PER_POINT * count, _SEED)
    if single:
        with np.errstate(all="ignore"):
            drawn = {name: values.astype(np.float32).astype(float) for name, values in drawn.items()}
    kept, exact = [], []
    for values in zip(*(drawn[name].tolist() for name in case.arguments), strict=True):
        point = dict(zip(case.arguments, values, strict=True))
        if not all(map(math.isfinite, values)) or case.outside(point):
            continue
        results = case.exact(point)
        if all(representable(one, form) for one in results):
            kept.append(values)
            exact.append([rounded(one) for one in results])
            if len(kept) == count:
                break
    else:
        raise TooFewPoints(f"{case.key}: only {len(kept)} of {count} points have a result that the format can hold")
    columns = np.array(kept).T
    return Sample(
        {name: columns[place].copy() for place, name in enumerate(case.arguments)},
        tuple(_as_rounded([row[place] for row in exact]) for place in range(len(case.outputs))),
    )


def _as_rounded(rows):
    value, rest, unit = np.array(rows).T
    return Rounded(value.copy(), rest.copy(), unit.astype(int))


def _single(exact):
    """The same results with units of binary32: values stay doubles, rests become shares of the larger unit."""
    unit = np.clip(exact.unit + _WIDER, BINARY32.lowest, BINARY32.highest)
    return Rounded(exact.value, np.ldexp(exact.rest, exact.unit - unit), unit)


def judge(results, sample):
    """Hold results against a sample.

    Parameters
    ----------
    results : tuple of ndarray
        One for each output; of float32 or float64, which sets the unit.
    sample : Sample

    Returns
    -------
    Error
    """
    worst, lost = [], np.zeros(len(sample.exact[0].value), dtype=bool)
    for values, exact in zip(results, sample.exact, strict=True):
        single = values.dtype == np.float32
        _, upper = error_bounds(values.astype(float), _single(exact) if single else exact)
        is_number, is_due = np.isfinite(values), np.isfinite(exact.value)
        lost |= is_number != is_due
        if (is_number & is_due).any():
            worst.append(float(upper[is_number & is_due].max()))
    return Error(max(worst, default=math.nan), float(lost.mean()))
