"""Arithmetic on sums of two doubles, about 2**-76 relative, for numbers of ordinary size: nothing over- or underflows.

NumPy has no fused multiply-add. So the first part of a factor is cut to 26 bits, which makes products of such parts
exact; the second part takes up the rest, and its products are so small that plain arithmetic does.
"""

import numpy as np

from ._chunks import extent

_HIGH = np.int64(-(1 << 27))  # the bits of a double but the last 27 of its fraction
_FELT = 2.0**-400


def cut(x):
    """The leading 26 bits of doubles."""
    return (x.view(np.int64) & _HIGH).view(np.float64)


class Pair:
    """The unevaluated sum p + q, |q| below 2**-15 of |p|; q None is 0; `short` says whether p has 26 bits at most.

    `x` is the nearest double; `high` its leading 26 bits, or p if that is short, `low` what is left of the sum.
    """

    __slots__ = ("_high", "_low", "p", "q", "short", "x")

    def __init__(self, p, q=None, short=False):
        self.p, self.q, self.short = p, q, short
        self.x = p if q is None else p + q
        self._high, self._low = (p, q) if short else (None, None)

    def _cut(self):
        high = cut(self.x)
        low = self.p - high
        if self.q is not None:
            low += self.q
        self._low, self._high = low, high  # in this order: another thread may look at the high part

    @property
    def high(self):
        """The leading bits."""
        if self._high is None:
            self._cut()
        return self._high

    @property
    def low(self):
        """What is left."""
        if self._high is None:
            self._cut()
        return self._low

    @property
    def rest(self):
        """What the nearest double leaves, or None."""
        return None if self.q is None else (self.p - self.x) + self.q


def load(x):
    """Doubles as pairs."""
    return Pair(x)


def rate(x):
    """Rates as pairs; 0 where no time of ordinary size makes them felt, as subnormal numbers are slow."""
    return Pair(x if extent(x)[0] >= _FELT else np.where(x >= _FELT, x, 0.0))


def constant(value):
    """A number that is a double."""
    return Pair(np.float64(value))


def mul(a, b):
    """Product."""
    q = a.high * b.low
    q += a.low * b.x
    return Pair(a.high * b.high, q)


def div(a, b):
    """Quotient; exactly 1 for equal operands."""
    high = cut(a.x / b.x)
    rest = a.high - high * b.high  # both are exact
    rest += a.low - high * b.low
    rest /= b.x
    return Pair(high, rest, short=True)


def sqrt(a):
    """Square root."""
    s = np.sqrt(a.x)
    high = cut(s)
    rest = a.high - high * high
    rest += a.low
    rest /= s + high
    return Pair(high, rest, short=True)


def add(a, b):
    """Sum; accurate in relation to the larger operand."""
    s = a.high + b.high
    t = s - a.high
    rest = (a.high - (s - t)) + (b.high - t)
    rest += a.low + b.low
    return Pair(s, rest)


def sub(a, b):
    """Difference."""
    s = a.high - b.high
    t = s - a.high
    rest = (a.high - (s - t)) - (b.high + t)
    rest += a.low - b.low
    return Pair(s, rest)


def scale(a, k):
    """a * 2**k, exactly."""
    unit = 2.0**k
    return Pair(unit * a.p, None if a.q is None else unit * a.q, a.short)
