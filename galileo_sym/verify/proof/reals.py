"""Real numbers that the C writes as a few doubles: recognised part by part, what is left kept as a bound."""

from fractions import Fraction
from functools import cache

from flint import arb, ctx

from .binary64 import power

_BITS = 600
_CLOSE = power(-30)  # a double this close to what is left of a real number is its next part


def enclosure(ball):
    """Return a lower and an upper bound of a ball, exact."""

    def rational(end):
        mantissa, exponent = end.man_exp()
        return Fraction(int(mantissa)) * power(int(exponent))

    return rational(ball.lower()), rational(ball.upper())


@cache
def table():
    """Return {name: (lower, upper)} of the real numbers that are recognised."""
    saved, ctx.prec = ctx.prec, _BITS
    try:
        two = arb(2)
        found = {"1/e": arb(-1).exp(), "pi/2": arb.pi() / 2, "log(2)": two.log(), "log(2)/16": two.log() / 16}
        found |= {f"2^(-{j}/16)": two ** (arb(-j) / 16) for j in range(16)}
        return {name: enclosure(ball) for name, ball in found.items()}
    finally:
        ctx.prec = saved


class Reals:
    """The real numbers met in one replay, as atoms.

    A double that is close to one of them is that number less what is left; the next double that is close to what is
    left takes part of it. That holds whatever the doubles are: a wrong one leaves more.

    Parameters
    ----------
    symbols : Symbols
    sixteenths : range
        The j of which one is meant where a table of 2^(-j/16) is picked from.
    x : Fraction, optional
        The argument where it is one double: what it leaves of a real number is an atom then, no symbol.
    """

    def __init__(self, symbols, sixteenths=range(0), x=None):
        self.symbols, self._sixteenths, self._x = symbols, sixteenths, x
        self._left = {name: (ends, None) for name, ends in table().items() if not name.startswith("2^")}
        self._known = {}
        self._atoms = {}
        self._each = None

    def atom(self, name):
        """Return the real number of this name."""
        if name not in self._atoms:
            self._atoms[name] = self.symbols.atom(*table()[name], name)
        return self._atoms[name]

    def expansion(self, value):
        """Return the expansion of a double as such a number and what is left of it; None if it is close to none."""
        if value not in self._known:
            self._known[value] = self._part(value)
        return self._known[value]

    def _part(self, value):
        for name, ((low, high), left) in self._left.items():
            if max(abs(low - value), abs(high - value)) < _CLOSE * abs(value):
                whole = self.atom(name) if left is None else left
                ends = low - value, high - value
                rest = self._rest(name, value, ends)
                self._left[name] = ends, rest
                return whole - rest
        return None

    def _rest(self, name, value, ends):
        if value == self._x:
            return self.symbols.atom(*ends, f"{name} - x")
        return self.symbols.fresh(max(map(abs, ends)))

    def picked(self, values):
        """Return the expansion of what is picked from a table: a part of 2^(-j/16), as above, for whichever j it is."""
        if self._each is None:
            ends = [table()[f"2^(-{j}/16)"] for j in self._sixteenths]
            whole = self.symbols.atom(min(low for low, _ in ends), max(high for _, high in ends), "2^(-j/16)")
        else:
            ends, whole = self._each
        chosen = [values[j] for j in self._sixteenths]
        left = [(low - value, high - value) for (low, high), value in zip(ends, chosen, strict=True)]
        rest = self.symbols.fresh(max(max(map(abs, pair)) for pair in left))
        self._each = left, rest
        return whole - rest
