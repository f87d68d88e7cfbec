"""Which points of a sample can hold its largest error: bounds of all errors at once, from floats.

Of each exact result there is kept the nearest float, the rest in units of the error, and that unit; so all errors are
known to 2**-30 of themselves without any work in many digits, and only the few largest are found from the enclosures.
"""

import math
from functools import cache
from typing import NamedTuple

import numpy as np
from flint import arb

from .ulp import size_of, ulp_exponent

_SHARE = 2.0**-30  # more than all roundings and widths below make together
_PART = 2.0**-34  # of a unit: enclosures are within 2**-90 of the result, units are above 2**-54 of it


class Rounded(NamedTuple):
    """Exact results as arrays, one element a point.

    Attributes
    ----------
    value : ndarray of float
        The float nearest the result; NaN where there is none.
    rest : ndarray of float
        The result less `value`, in units; 0 only if that is exact.
    unit : ndarray of int
        Exponent of the unit, a power of two.
    """

    value: np.ndarray
    rest: np.ndarray
    unit: np.ndarray


@cache
def _power(exponent):
    return arb(2) ** exponent


def rounded(enclosure):
    """Value, rest and unit of one certain enclosure, as floats and an integer."""
    ball, scale = enclosure
    value = float(ball)
    if not math.isfinite(value):
        # of a finite result beyond the range nothing is known here
        return value, math.nan if ball.is_finite() else 0.0, 0
    fraction, exponent = math.frexp(value if scale is None else float(scale))
    if 0.5 < abs(fraction) < 1:  # well inside a binade
        unit = min(max(exponent - 53, -1074), 971)
    else:
        unit = ulp_exponent(size_of(enclosure))
    away = ball - value
    rest = 0.0 if away.is_zero() else float(away * _power(-unit)) or math.ulp(0.0)
    return value, rest, unit


def error_bounds(results, exact):
    """Lower and upper bounds of the errors of results, in units.

    Parameters
    ----------
    results : ndarray of float
    exact : Rounded

    Returns
    -------
    lower, upper : ndarray of float
        0 and inf where the errors have to be found from the enclosures.
    """
    with np.errstate(all="ignore"):
        same = (results == exact.value) | (np.isnan(results) & np.isnan(exact.value))
        away = np.ldexp(np.where(same, 0.0, results - exact.value), -exact.unit)
        error = np.abs(away - exact.rest)
        slack = _SHARE * error + np.where(exact.rest == 0, 0.0, _PART)
        open_ = ~np.isfinite(error)
        return np.where(open_, 0.0, np.maximum(error - slack, 0.0)), np.where(open_, np.inf, error + slack)
