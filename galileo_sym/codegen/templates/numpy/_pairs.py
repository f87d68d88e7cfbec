"""Arithmetic on pairs hi + lo, about 2**-100 relative, for numbers of ordinary size: nothing over- or underflows.

NumPy has no fused multiply-add: factors are cut in halves whose products are exact. A number in several products is cut
once.
"""

import numpy as np

_HIGH = np.int64(-(1 << 27))  # the bits of a double but the last 27 of its fraction


def halves(a):
    """The leading 26 bits of doubles, and the rest."""
    high = (a.view(np.int64) & _HIGH).view(np.float64)
    return high, a - high


class Pair:
    """The unevaluated sum hi + lo, |lo| <= ulp(hi)/2; lo None is 0."""

    __slots__ = ("_halves", "hi", "lo")

    def __init__(self, hi, lo=None):
        self.hi, self.lo, self._halves = hi, lo, None

    @property
    def halves(self):
        """Those of hi."""
        if self._halves is None:
            self._halves = halves(self.hi)
        return self._halves


def load(x):
    """Doubles as pairs."""
    return Pair(x)


def constant(value):
    """A number that is a double."""
    return Pair(np.float64(value))


def _settled(s, e):
    """The sum of s and what is small beside it."""
    r = s + e
    return Pair(r, (s - r) + e)


def _sum(*parts):
    """The sum of those that are there, or None."""
    total = None
    for part in parts:
        total = part if total is None else total if part is None else total + part
    return total


def _cross(a, b):
    """a b, or None where b is 0."""
    return None if b is None else a * b


def _product_rest(a, b, p):
    """The exact rest of p = a b, of the first parts of two pairs."""
    (ah, al), (bh, bl) = a.halves, b.halves
    return ((ah * bh - p) + ah * bl + al * bh) + al * bl


def mul(a, b):
    """Product."""
    p = a.hi * b.hi
    return _settled(p, _sum(_product_rest(a, b, p), _cross(a.hi, b.lo), _cross(b.hi, a.lo)))


def div(a, b):
    """Quotient; exactly 1 for equal operands."""
    q = Pair(a.hi / b.hi)
    p = q.hi * b.hi
    rest = _sum((a.hi - p) - _product_rest(q, b, p), a.lo)
    if b.lo is not None:
        rest = rest - q.hi * b.lo
    return _settled(q.hi, rest / b.hi)


def sqrt(a):
    """Square root."""
    s = Pair(np.sqrt(a.hi))
    p = s.hi * s.hi
    rest = _sum((a.hi - p) - _product_rest(s, s, p), a.lo)
    return _settled(s.hi, rest / (s.hi + s.hi))


def _two_sum(a, b):
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def add(a, b):
    """Sum; accurate in relation to the larger operand."""
    s, t = _two_sum(a.hi, b.hi)
    if a.lo is None or b.lo is None:
        return _settled(s, _sum(t, a.lo, b.lo))
    u, v = _two_sum(a.lo, b.lo)
    first = _settled(s, t + u)
    return _settled(first.hi, first.lo + v)


def sub(a, b):
    """Difference."""
    return add(a, Pair(-b.hi, None if b.lo is None else -b.lo))


def scale(a, k):
    """a * 2**k, exactly."""
    unit = 2.0**k
    return Pair(unit * a.hi, None if a.lo is None else unit * a.lo)
