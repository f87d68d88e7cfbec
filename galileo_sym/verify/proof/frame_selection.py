"""Comparisons, selections, signs and the bits of doubles in a replay: what the ranges of the operands decide."""

from dataclasses import dataclass
from fractions import Fraction

from .binary64 import DIGITS, RN, exponent, power
from .expansion import Expansion
from .relative import dominant
from .replay import Replay, Value, given

_NORMAL = power(-1022)


class Undecided(Exception):
    """A comparison comes out either way on this cell."""


@dataclass(frozen=True)
class Mask:
    """A comparison whose result is known."""

    holds: bool


class Selection(Replay):
    """The part of `FrameReplay` that computes nothing; what is open is asked of the choices, one after the other."""

    def __init__(self, function, symbols, parameters, tables, index, choices):
        self._choices = iter(choices)
        super().__init__(function, symbols, parameters, tables, index)

    def _choose(self):
        for choice in self._choices:
            return choice
        raise Undecided(f"{self.name}, {self.line}")

    def _order(self, a, b):
        """Whether a >= b, by the ranges or by choice."""
        difference = a.rounded - b.rounded
        for monomial in ((), dominant(self.symbols, difference)):
            if not self.symbols.range_of(monomial)[0] > 0:
                continue
            low, high = self.symbols.range(difference.over(monomial))
            if low >= 0 or high < 0:
                return low >= 0
        return self._choose()

    def at_least(self, a, b):
        """Whether a >= b."""
        return Mask(self._order(a, b))

    def less(self, a, b):
        """Whether a < b."""
        return Mask(not self._order(a, b))

    def min(self, a, b):
        """The smaller."""
        if self.symbols.range(a.rounded - b.rounded)[1] <= 0:
            return a
        return b if self._order(a, b) else a

    def max(self, a, b):
        """The larger."""
        return a if self._order(a, b) else b

    def _sign(self, value):
        low, high = self.symbols.range(value.rounded)
        if low < 0 < high:
            self._stop("a sign is open")
        return -1 if high <= 0 and low < 0 else 1

    def abs(self, a):
        """The absolute value."""
        return a if self._sign(a) > 0 else Value(-a.exact, -a.rounded, a.step, ("gs_abs", a))

    def flip(self, a, x):
        """a, or its negative where x is negative."""
        return a if self._sign(x) > 0 else Value(-a.exact, -a.rounded, a.step, ("gs_flip", a, x))

    def _binades(self, x):
        """Return the exponents that a positive normal double may have."""
        low, high = self.symbols.range(x.rounded)
        if not low >= _NORMAL:
            self._stop("the exponent of what may not be positive and normal")
        return exponent(RN(low)), exponent(RN(high))

    def exponent(self, x):
        """The k of x = m 2^k, 2 <= m < 4."""
        first, last = (e - 1 for e in self._binades(x))
        name = f"exponent({self.shown(x.rounded.ideal())})"
        return given(self.symbols.atom(Fraction(first), Fraction(last), name), Fraction(1))

    def mantissa(self, x):
        """The m of x = m 2^k, 2 <= m < 4."""
        first, last = self._binades(x)
        ends = Fraction(2), Fraction(4) - power(2 - DIGITS)
        if first == last:
            scale = power(1 - first)
            low, high = self.symbols.range(x.rounded * Expansion.of(scale))
            ends = max(ends[0], low), min(ends[1], high)
        name = f"mantissa({self.shown(x.rounded.ideal())})"
        return given(self.symbols.atom(*ends, name), power(2 - DIGITS))
