"""Errors of floating-point results in ulps of the exact result, as upper bounds from an enclosure."""

import math
from decimal import ROUND_CEILING, Context
from typing import NamedTuple

from mpmath import libmp


class Format(NamedTuple):
    """A binary interchange format of IEEE 754.

    Attributes
    ----------
    precision : int
        Bits of the significand, the hidden one included.
    lowest : int
        Exponent of the smallest subnormal number, 2**lowest.
    highest : int
        Exponent of the largest unit in the last place, 2**highest.
    """

    precision: int
    lowest: int
    highest: int


BINARY64 = Format(53, -1074, 971)
BINARY32 = Format(24, -149, 104)


def ulp_exponent(raw, form=BINARY64):
    """The e with 2**e = one unit in the last place of a number in mpmath's raw form.

    Below the normal range it is the smallest subnormal number, above the largest finite number the largest unit.
    """
    if raw == libmp.fzero:
        return form.lowest
    return min(max(raw[2] + raw[3] - form.precision, form.lowest), form.highest)


def _difference(measured, enclosure):
    """The largest distance between a raw number and a point of an enclosure, exactly."""
    low = libmp.mpf_abs(libmp.mpf_sub(measured, enclosure.low))
    high = libmp.mpf_abs(libmp.mpf_sub(measured, enclosure.high))
    return low if libmp.mpf_gt(low, high) else high


def _least(enclosure):
    """The smallest magnitude in an enclosure, in raw form."""
    if libmp.mpf_sign(enclosure.low) * libmp.mpf_sign(enclosure.high) <= 0:
        return libmp.fzero
    low, high = libmp.mpf_abs(enclosure.low), libmp.mpf_abs(enclosure.high)
    return high if libmp.mpf_lt(high, low) else low


def _rounds_to_infinity(raw, form):
    """Whether the nearest number of the format to a raw magnitude is infinite."""
    limit = libmp.from_man_exp((1 << (form.precision + 1)) - 1, form.highest - 1)
    return libmp.mpf_ge(raw, limit)


def ulp_error(value, enclosure, form=BINARY64):
    """Upper bound of the error of `value` in ulps of the exact result.

    Parameters
    ----------
    value : float
        The result to judge, a number of the format `form`.
    enclosure : Enclosure
        Holds the exact result. Where its `scale` is given, the unit is the ulp of that instead of the result's own.
    form : Format
        `BINARY64` or `BINARY32`.

    Returns
    -------
    float
        |value - exact| / ulp(exact), rounded up. A unit is 2**lowest where the exact result is subnormal or 0. If the
        enclosure spans a binade boundary the smaller unit counts. An infinity is right where the exact result rounds
        to it, and stands for 2**(highest + precision) elsewhere. NaN and infinities of the wrong sign err by inf, as
        does a number where there is no result.
    """
    value = float(value)
    if enclosure.low == libmp.fnan:
        return 0.0 if math.isnan(value) else math.inf
    if math.isnan(value):
        return math.inf
    if enclosure.low in (libmp.finf, libmp.fninf):
        return 0.0 if libmp.from_float(value) == enclosure.low else math.inf
    least = _least(enclosure)
    measured = libmp.from_float(value)
    if math.isinf(value):
        if (value > 0) != (libmp.mpf_sign(enclosure.low) > 0):
            return math.inf
        if _rounds_to_infinity(least, form):
            return 0.0
        measured = libmp.from_man_exp(1 if value > 0 else -1, form.highest + form.precision)
    unit = ulp_exponent(least if enclosure.scale is None else enclosure.scale, form)
    quotient = libmp.mpf_shift(_difference(measured, enclosure), -unit)
    if quotient[2] + quotient[3] > 1023:
        return math.inf
    rounded = libmp.to_float(quotient, strict=True, rnd=libmp.round_down)
    return rounded if libmp.from_float(rounded) == quotient else math.nextafter(rounded, math.inf)


def representable(enclosure, form=BINARY64):
    """Whether the exact result lies in the range of the format: not below its subnormals, not rounded to infinity."""
    if enclosure.low == enclosure.high == libmp.fzero:
        return True
    if enclosure.low in (libmp.finf, libmp.fnan):
        return True
    size = _least(enclosure) if enclosure.scale is None else enclosure.scale
    return size != libmp.fzero and size[2] + size[3] > form.lowest and not _rounds_to_infinity(size, form)


def rounded_up(error, digits=3):
    """An error rounded up to so many significant decimal digits, for a certificate or a table."""
    if math.isinf(error):
        return error
    return float(Context(prec=digits, rounding=ROUND_CEILING).create_decimal(error))
