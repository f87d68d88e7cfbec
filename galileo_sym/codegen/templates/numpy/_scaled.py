"""Arithmetic on scaled pairs (hi + lo) * 2**e: no intermediate over- or underflow, about 2**-100 relative error.

The same operations in the same order as in the C support header, so that both give the same bits: only + - * / and
square root of doubles, exact products (by splitting here, by fma there), frexp and ldexp.
"""

from typing import NamedTuple

import numpy as np

ZERO_EXPONENT = -(2**24)  # of 0: below that of any number, so that sums align on the other operand
INFINITE_EXPONENT = 2**20  # stands for an infinite argument: a result keeps it, or cancels it, as its limit does
LIMIT = 2**18  # exponents of results beyond it stand for infinity or 0
_SPLITTER = 134217729.0  # 2**27 + 1


class Scaled(NamedTuple):
    """The unevaluated number (hi + lo) * 2**e, |lo| <= ulp(hi)/2; arrays of float64, float64 and int32."""

    hi: np.ndarray
    lo: np.ndarray
    e: np.ndarray


ZERO = Scaled(np.float64(0.0), np.float64(0.0), np.int32(ZERO_EXPONENT))


def constant(value):
    """Return a power of two, or another number of moderate size, as a scaled pair."""
    return Scaled(np.float64(value), np.float64(0.0), np.int32(0))


def load(x):
    """Return x >= 0 as a scaled pair, exactly; infinity becomes a number beyond all finite ones."""
    m, e = np.frexp(x)
    infinite = np.isinf(x)
    e = np.where(infinite, INFINITE_EXPONENT, np.where(x == 0.0, ZERO_EXPONENT, e)).astype(np.int32)
    return Scaled(np.where(infinite, 0.5, m), np.zeros_like(m), e)


def fast_two_sum(a, b):
    """Return a + b rounded, and the rest, for |a| >= |b| or a = 0."""
    s = a + b
    return s, b - (s - a)


def two_sum(a, b):
    """Return a + b rounded, and the rest."""
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def _halves(a):
    t = _SPLITTER * a
    high = t - (t - a)
    return high, a - high


def two_prod(a, b):
    """Return a b rounded, and the rest, for factors and product of moderate size."""
    p = a * b
    ah, al = _halves(a)
    bh, bl = _halves(b)
    return p, ((ah * bh - p) + ah * bl + al * bh) + al * bl


def pair_mul(ah, al, bh, bl):
    """Product of two pairs."""
    p, q = two_prod(ah, bh)
    return fast_two_sum(p, q + (ah * bl + al * bh))


def pair_add(ah, al, bh, bl):
    """Sum of two pairs; accurate in relation to the larger operand."""
    s, t = two_sum(ah, bh)
    u, v = two_sum(al, bl)
    s, t = fast_two_sum(s, t + u)
    return fast_two_sum(s, t + v)


def mul(a, b):
    """Product."""
    return Scaled(*pair_mul(a.hi, a.lo, b.hi, b.lo), a.e + b.e)


def div(a, b):
    """Quotient, b != 0; exactly 1 for equal operands."""
    q = a.hi / b.hi
    p, t = two_prod(q, b.hi)
    rest = (((a.hi - p) - t) + a.lo) - q * b.lo
    return Scaled(*fast_two_sum(q, rest / b.hi), a.e - b.e)


def sqrt(a):
    """Square root, a > 0."""
    odd = a.e & 1
    hi, lo = np.ldexp(a.hi, odd), np.ldexp(a.lo, odd)
    s = np.sqrt(hi)
    p, t = two_prod(s, s)
    rest = ((hi - p) - t) + lo
    return Scaled(*fast_two_sum(s, rest / (s + s)), (a.e - odd) >> 1)


def add(a, b):
    """Sum."""
    e = np.maximum(a.e, b.e)
    i, j = np.maximum(a.e - e, -400), np.maximum(b.e - e, -400)
    return Scaled(*pair_add(np.ldexp(a.hi, i), np.ldexp(a.lo, i), np.ldexp(b.hi, j), np.ldexp(b.lo, j)), e)


def neg(a):
    """Opposite."""
    return Scaled(-a.hi, -a.lo, a.e)


def sub(a, b):
    """Difference."""
    return add(a, neg(b))


def scale(a, k):
    """Return a * 2**k, exactly."""
    return Scaled(a.hi, a.lo, a.e + np.int32(k))


def plain(a):
    """Return a pair of doubles for a number that is only looked up: 0 below 2**-120, some large number above 2**100."""
    e = np.minimum(a.e, 200)
    small = e < -120
    e = np.where(small, 0, e)
    return np.ldexp(np.where(small, 0.0, a.hi), e), np.ldexp(np.where(small, 0.0, a.lo), e)


def rounded(a):
    """Return the nearest double of a scaled pair as one, normalised."""
    m, e = np.frexp(a.hi)
    return Scaled(m, np.zeros_like(m), a.e + e)


def select(mask, a, b):
    """Lanes of a where mask holds, of b elsewhere."""
    return Scaled(*(np.where(mask, x, y) for x, y in zip(a, b, strict=True)))


def _round_subnormal(hi, lo, e):
    """Round hi + lo to a multiple of the smallest double: once, where rounding hi again would be twice."""
    e = np.maximum(e, -1200)
    unit = np.ldexp(1.0, -1074 - e)
    big = unit * 2.0**52
    s, t = fast_two_sum(big, np.abs(hi))
    return np.copysign(np.ldexp((s + (t + np.copysign(1.0, hi) * lo)) - big, e), hi)


def store(a):
    """Return the nearest double, with the flags of one rounding; limits at infinite arguments come without a flag."""
    hi, lo, e = np.broadcast_arrays(a.hi, a.lo, a.e)
    beyond = np.abs(e) > LIMIT
    limit = np.copysign(np.where(e > 0, np.inf, 0.0), hi)
    result = np.where(beyond, limit, np.ldexp(np.where(beyond, 0.0, hi), np.where(beyond, 0, e)))
    subnormal = (np.abs(result) <= 2.0**-1022) & (hi != 0.0) & ~beyond
    if np.any(subnormal):
        result[subnormal] = _round_subnormal(hi[subnormal], lo[subnormal], e[subnormal])
    return result
