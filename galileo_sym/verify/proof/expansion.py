"""Exact expansions: polynomials in atoms and in rounding errors, with rational coefficients.

A term is (monomial, symbols) -> coefficient. An atom is a real number in a known range, such as the argument; a
monomial is a sorted tuple of (atom, power), and powers may be negative where the atom keeps away from 0. The symbols
are the numbers of rounding errors and of low parts, each bounded in absolute value.
"""

from fractions import Fraction
from functools import cache
from itertools import count
from math import prod

_NONE = -(10**6)
_BITS = 160  # kept of a bound
ARGUMENT = 0  # the number of the first atom


@cache
def times(a, b):
    """Return the product of two monomials."""
    powers = dict(a)
    for atom, power in b:
        powers[atom] = powers.get(atom, 0) + power
    return tuple(sorted((atom, power) for atom, power in powers.items() if power))


@cache
def over(a, b):
    """Return the quotient of two monomials."""
    return times(a, tuple((atom, -power) for atom, power in b))


def above(value):
    """Return a dyadic rational no less than a value, and equal to it if that has few digits."""
    top, bottom = value.numerator, value.denominator
    shift = _BITS - (abs(top).bit_length() - bottom.bit_length())
    if shift >= 0:
        return Fraction(-(-(top << shift) // bottom), 1 << shift)
    return Fraction(-(-top // (bottom << -shift)) << -shift)


def binades(value):
    """Return an n with value < 2^n, for a value >= 0, and hardly more than that; for 0 one below all others."""
    return value.numerator.bit_length() - value.denominator.bit_length() + 1 if value else _NONE


class Symbols:
    """The ranges of the atoms and the bounds of all symbols introduced so far."""

    def __init__(self, lower, upper):
        self.atoms = {ARGUMENT: (lower, upper)}
        self.names = {ARGUMENT: "x"}
        self.bounds = {}
        self.marked = set()
        self._numbers = count()
        self._ranges, self._binades = {}, {}

    def atom(self, lower, upper, name):
        """Return an expansion that is one new atom, of this range."""
        number = len(self.atoms)
        self.atoms[number], self.names[number] = (lower, upper), name
        return Expansion.argument(1, number)

    def fresh(self, bound, marked=False):
        """Return an expansion that is one new symbol of this bound; 0 if the bound is. Some are marked, to be told."""
        if not bound:
            return Expansion({})
        number = next(self._numbers)
        self.bounds[number] = above(bound)
        if marked:
            self.marked.add(number)
        return Expansion({((), (number,)): Fraction(1)})

    def shown(self, monomial):
        """Return a monomial as text."""
        return " ".join(sorted(self.names[atom] + (f"^{k}" if k != 1 else "") for atom, k in monomial))

    def range_of(self, monomial):
        """Return the least and greatest value of a monomial."""
        if monomial not in self._ranges:
            low = high = Fraction(1)
            for atom, power in monomial:
                ends = self._power(atom, power)
                products = [a * b for a in (low, high) for b in ends]
                low, high = min(products), max(products)
            self._ranges[monomial] = -above(-low), above(high)
        return self._ranges[monomial]

    def size(self, key, coefficient):
        """Return an n with 2^n above a term's absolute value."""
        monomial, errors = key
        if monomial not in self._binades:
            low, high = self.range_of(monomial)
            self._binades[monomial] = binades(max(-low, high))
        for number in errors:
            if number not in self._binades:
                self._binades[number] = binades(self.bounds[number])
        return binades(abs(coefficient)) + self._binades[monomial] + sum(map(self._binades.get, errors))

    def _power(self, atom, power):
        lower, upper = self.atoms[atom]
        ends = sorted([lower**power, upper**power])
        if power > 0 and power % 2 == 0 and lower < 0 < upper:
            ends[0] = Fraction(0)
        return ends

    def range(self, expansion):
        """Return bounds of an expansion: term by term, those with the same symbols added up first."""
        sums = {}
        for (monomial, symbols), coefficient in expansion.terms.items():
            least, greatest = self.range_of(monomial)
            if coefficient < 0:
                least, greatest = greatest, least
            low, high = sums.get(symbols, (0, 0))
            sums[symbols] = low + coefficient * least, high + coefficient * greatest
        low, high = sums.pop((), (Fraction(0), Fraction(0)))
        either = sum(
            (max(-a, b) * prod(map(self.bounds.get, symbols)) for symbols, (a, b) in sums.items()), Fraction(0)
        )
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
        return cls({((), ()): value})

    @classmethod
    def argument(cls, power=1, atom=ARGUMENT):
        """Return an atom, or a power of it; the first by default."""
        return cls({(((atom, power),), ()): Fraction(1)})

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
                key = times(k, m), tuple(sorted(mine + theirs))
                terms[key] = terms.get(key, 0) + a * b
        return Expansion(terms)

    def over(self, monomial):
        """Return the quotient by a monomial."""
        return Expansion({(over(mine, monomial), symbols): c for (mine, symbols), c in self.terms.items()})

    def inverse(self):
        """Return 1/this, or None unless this is one term without symbols."""
        if len(self.terms) != 1:
            return None
        (((monomial, symbols), coefficient),) = self.terms.items()
        return None if symbols else Expansion({(over((), monomial), ()): 1 / coefficient})

    def ideal(self):
        """Return the terms free of symbols."""
        return Expansion({key: coefficient for key, coefficient in self.terms.items() if not key[1]})

    def powers(self):
        """Return {power of the argument: coefficient} of the terms free of symbols, where it is the only atom."""
        return {dict(monomial).get(ARGUMENT, 0): c for (monomial, symbols), c in self.terms.items() if not symbols}
