"""b d/a - 1 - log(-c d/a) in integers, where pairs are not enough: is there a root, and how far from a double one.

It is 0 only if c d = -a and b d = a: the logarithm of a rational number other than 1 is irrational. Fixed point with
384 bits after the point, rounded down at every step, to the same bits as in C.
"""

import numpy as np

from ._scaled import Scaled, fast_two_sum

_BITS = 384


def _integer(x):
    """Integer m, 0 or of 53 bits, and exponent e with |x| = m 2**e."""
    m, e = np.frexp(abs(x))
    return int(np.ldexp(m, 53)), int(e) - 53


def _atanh(z):
    """Inverse hyperbolic tangent of 0 <= z < 1/2."""
    square, power, total, order = (z * z) >> _BITS, z, 0, 1
    while power:
        total += power // order
        power, order = (power * square) >> _BITS, order + 2
    return total


def _log(above, below, exponent):
    """Logarithm of above/below 2**exponent, for integers with a quotient between 1/4 and 2."""
    while 3 * above < 2 * below:
        above, exponent = 2 * above, exponent - 1
    if 3 * above > 4 * below:
        below, exponent = 2 * below, exponent + 1
    gap = abs(above - below)
    near = 2 * _atanh((gap << _BITS) // (above + below))
    return (near if above >= below else -near) + 2 * exponent * _atanh((1 << _BITS) // 3)


def _one_excess(a, b, c, d):
    """The value for one equation as (hi, lo, e); hi = 0 for a double root."""
    (ma, ea), (mb, eb), (mc, ec), (md, ed) = map(_integer, (a, b, c, d))
    bits = _BITS + eb + ed - ea
    quotient = mb * md << bits if bits >= 0 else mb * md >> -bits
    quotient //= ma
    quotient = -quotient if ((a < 0) ^ (b < 0)) ^ (d < 0) else quotient
    value = quotient - (1 << _BITS) - _log(mc * md, ma << 53, ec + ed - ea + 53)
    n = abs(value).bit_length()
    digits = (abs(value) << 106) >> n
    hi, lo = np.ldexp(float(digits >> 53), -53), np.ldexp(float(digits & (2**53 - 1)), -106)
    sign = -1.0 if value < 0 else 1.0
    return sign * hi, sign * lo, n - _BITS


def excess(a, b, c, d):
    """The values for flat arrays of equations with c d/a < 0 and |b d/a| < 2**16, as a scaled pair."""
    values = [_one_excess(*equation) for equation in zip(a, b, c, d, strict=True)]
    hi, lo, e = (np.array(part) for part in zip(*values, strict=True))
    return Scaled(*fast_two_sum(hi, lo), e.astype(np.int32))
