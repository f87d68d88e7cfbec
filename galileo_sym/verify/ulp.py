"""Errors of floating-point results in ulps of the exact result, as upper bounds from an enclosure."""

import math
from decimal import ROUND_CEILING, Context
from typing import NamedTuple

from flint import arb

from .enclosure import with_bits

_BITS = 400
_TWO = arb(2)


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


def ulp_exponent(size, form=BINARY64):
    """The e with 2**e = one unit in the last place of a number, a point `size` >= 0.

    Below the normal range it is the smallest subnormal number, above the largest finite number the largest unit.
    """
    if size.is_zero():
        return form.lowest
    mantissa, exponent = size.man_exp()
    return int(min(max(mantissa.bit_length() + exponent - form.precision, form.lowest), form.highest))


def size_of(enclosure):
    """The magnitude that sets the unit, a point: the smallest in the enclosure, or its scale."""
    return enclosure.ball.abs_lower() if enclosure.scale is None else enclosure.scale


def _rounds_to_infinity(size, form):
    """Whether the nearest number of the format to a magnitude, a point, is infinite."""
    return size >= ((1 << (form.precision + 1)) - 1) * _TWO ** (form.highest - 1)


@with_bits(_BITS)
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
    ball = enclosure.ball
    if ball.is_nan():
        return 0.0 if math.isnan(value) else math.inf
    if math.isnan(value):
        return math.inf
    if not ball.is_finite():
        return 0.0 if ball == value else math.inf
    measured = arb(value)
    if math.isinf(value):
        if not (ball > 0 if value > 0 else ball < 0):
            return math.inf
        if _rounds_to_infinity(ball.abs_lower(), form):
            return 0.0
        measured = math.copysign(1.0, value) * _TWO ** (form.highest + form.precision)
    unit = ulp_exponent(size_of(enclosure), form)
    quotient = (measured - ball).abs_upper() * _TWO**-unit
    rounded = float(quotient)
    return math.nextafter(rounded, math.inf) if quotient > rounded else rounded


def representable(enclosure, form=BINARY64):
    """Whether the exact result lies in the range of the format: not below its subnormals, not rounded to infinity."""
    near, far = math.ldexp(1.0, form.lowest + 2), math.ldexp(1.0, form.highest + form.precision - 2)
    return near < float(size_of(enclosure)) < far or _in_range(enclosure, form)


@with_bits(_BITS)
def _in_range(enclosure, form):
    if enclosure.ball.is_zero() or not enclosure.ball.is_finite():
        return True
    size = size_of(enclosure)
    return size >= _TWO**form.lowest and not _rounds_to_infinity(size, form)


def rounded_up(error, digits=3):
    """An error rounded up to so many significant decimal digits, for a certificate or a table."""
    if math.isinf(error):
        return error
    return float(Context(prec=digits, rounding=ROUND_CEILING).create_decimal(error))
