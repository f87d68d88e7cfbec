"""Binary64 on exact rationals: ulps, the error of a rounding, grids."""

import math
from fractions import Fraction

DIGITS = 53
SMALLEST = Fraction(1, 2**1074)  # the least subnormal: every double is a multiple of it
LARGEST = Fraction(2**1024 - 2**971)
_LEAST_EXPONENT = -1022
_ROOT_BITS = 200
_OVERFLOW = Fraction(2**1024 - 2**970)  # what rounds to infinity


class Overflow(ArithmeticError):
    """An operation may overflow."""


def power(exponent):
    """Return 2^exponent, exact."""
    return Fraction(2**exponent) if exponent >= 0 else Fraction(1, 2**-exponent)


def exponent(value):
    """Return the e with 2^e <= abs value < 2^(e+1)."""
    top, bottom = abs(value.numerator), value.denominator
    guess = top.bit_length() - bottom.bit_length()
    return guess if power(guess) <= abs(value) else guess - 1


def ulp(value):
    """Return the distance between doubles in the binade of a value; the least subnormal for 0 and below."""
    if not value:
        return SMALLEST
    return power(max(exponent(value), _LEAST_EXPONENT) - DIGITS + 1)


def rounding_error(largest):
    """Bound of abs(RN(v) - v) over all abs v <= largest.

    Half an ulp of the binade below a bound that is a power of two, since that itself is a double; and never more than
    abs v, since 0 is a double.

    Raises
    ------
    Overflow
        If the largest may round to infinity.
    """
    if largest >= _OVERFLOW:
        raise Overflow("an operation may overflow")
    if not largest:
        return Fraction(0)
    top = exponent(largest)
    below = power(top - 1) if largest == power(top) else power(top)
    return min(ulp(below) / 2, largest)


def grid(value):
    """Return the largest power of two of which a double is a multiple; None for 0."""
    if not value:
        return None
    return Fraction(value.numerator & -value.numerator, value.denominator)


def RN(value):
    """Return a rational rounded to nearest, ties to even: the division of integers rounds so."""
    return Fraction(value.numerator / value.denominator)


def root_bound(value, up):
    """Return a lower or an upper bound of a square root, good to 200 bits."""
    shift = 2 * max(0, _ROOT_BITS - exponent(value) // 2) if value else 0
    scaled = value * power(shift)
    return (math.isqrt(scaled.numerator // scaled.denominator) + up) * power(-shift // 2)


def before(value):
    """Return the greatest double below a positive one."""
    return Fraction(math.nextafter(float(value), 0.0))


def double_of_bits(bits):
    """Return the exact value of the positive finite double with these bits."""
    field, mantissa = bits >> (DIGITS - 1), bits & (2 ** (DIGITS - 1) - 1)
    return (2 ** (DIGITS - 1) * (field > 0) + mantissa) * power(max(field, 1) - 1075)
