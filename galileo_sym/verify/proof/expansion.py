"""Exact expansions: polynomials in one argument and in rounding errors, with rational coefficients.

A term is (power of the argument, symbols) -> coefficient; the symbols are the numbers of rounding errors and of the low
part of the argument, each bounded in absolute value. Powers may be negative: 1/x is exact where x keeps away from 0.
"""

from fractions import Fraction
from itertools import count
from math import prod


class Symbols:
    """The argument's range and the bounds of all symbols introduced so far."""

    def __init__(self, lower, upper):
        self.lower, self.upper = lower, upper
        self.bounds = {}
        self._numbers = count()
        self._ranges = {}

    def fresh(self, bound):
        """Return an expansion that is one new symbol of this bound; 0 if the bound is."""
        if not bound:
            return Expansion({})
        number = next(self._numbers)
        self.bounds[number] = bound
        return Expansion({(0, (number,)): Fraction(1)})

    def range_of_power(self, power):
        """Return the least and greatest value of the argument to this power."""
        if power not in self._ranges:
            ends = sorted([self.lower**power, self.upper**power])
            if power > 0 and power % 2 == 0 and self.lower < 0 < self.upper:
                ends[0] = Fraction(0)
            self._ranges[power] = tuple(ends)
        return self._ranges[power]

    def range(self, expansion):
        """Return bounds of an expansion, term by term."""
        low = high = either = Fraction(0)
        for (power, symbols), coefficient in expansion.terms.items():
            least, greatest = self.range_of_power(power)
            if symbols:
                either += abs(coefficient) * max(-least, greatest) * prod(map(self.bounds.get, symbols))
            elif coefficient > 0:
                low, high = low + coefficient * least, high + coefficient * greatest
            else:
                low, high = low + coefficient * greatest, high + coefficient * least
        return low - either, high + either

    def largest(self, expansion):
        """Return a bound of the absolute value."""
        return max(map(abs, self.range(expansion)))

    def least(self, expansion):
        """Return a lower bound of the absolute value."""
        low, high = self.range(expansion)
        return max(low, -high, Fraction(0))


class Expansion:
    """A sum of terms, exact; those of coefficient 0 are left out."""

    def __init__(self, terms):
        self.terms = {key: coefficient for key, coefficient in terms.items() if coefficient}

    @classmethod
    def of(cls, value):
        """Return a constant."""
        return cls({(0, ()): value})

    @classmethod
    def argument(cls, power=1):
        """Return the argument, or a power of it."""
        return cls({(power, ()): Fraction(1)})

    def __add__(self, other):
        terms = dict(self.terms)
        for key, coefficient in other.terms.items():
            terms[key] = terms.get(key, 0) + coefficient
        return Expansion(terms)

    def __neg__(self):
        return Expansion({key: -coefficient for key, coefficient in self.terms.items()})

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        terms = {}
        for (k, mine), a in self.terms.items():
            for (m, theirs), b in other.terms.items():
                key = k + m, tuple(sorted(mine + theirs))
                terms[key] = terms.get(key, 0) + a * b
        return Expansion(terms)

    def inverse(self):
        """Return 1/this, or None unless this is one term without symbols."""
        if len(self.terms) != 1:
            return None
        (((power, symbols), coefficient),) = self.terms.items()
        return None if symbols else Expansion({(-power, ()): 1 / coefficient})

    def without_symbols(self):
        """Return {power: coefficient} of the terms free of rounding errors."""
        return {power: coefficient for (power, symbols), coefficient in self.terms.items() if not symbols}
