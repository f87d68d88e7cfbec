"""Claims of analysis: a function is continuous; a power series represents it everywhere."""

from __future__ import annotations

import sympy as sp
from sympy.core.relational import Relational

from .breaking import breaking_places
from .predicates import FIRST, SECOND, Claim, spread

STEP = sp.Rational(1, 10**40)  # between places whose values must be near each other
NEAR = sp.Rational(1, 10**12)


class Continuous(Claim):
    """``Continuous(f, x, interval)``: at a closed end, continuous from inside."""

    def trials(self):
        f, x, interval = self.args
        here, beside = f.subs(x, FIRST), f.subs(x, SECOND)
        near = sp.Lt((beside - here) ** 2, NEAR**2 * (1 + here**2), evaluate=False)
        places = [*spread(interval), *_seams(f, x, interval), *breaking_places(f, x, interval)]
        pairs = [(place, place + aside) for place in places for aside in (STEP, -STEP)]
        return [(near, {FIRST: a, SECOND: b}) for a, b in pairs if interval.contains(b) == sp.true]


def _seams(f, x, interval):
    """Places where the branches of a Piecewise meet."""
    meet = {end for r in f.atoms(Relational) if x in r.args for end in r.args if end != x and end.is_number}
    return [place for place in sorted(meet, key=sp.default_sort_key) if interval.contains(place) == sp.true]


class PowerSeries(Claim):
    """``PowerSeries(f, x, place, coefficient, n)``: f is the sum of coefficient (x - place)^n, for every real x.

    At `place`, where the formula of f may be 0/0, the sum is the first coefficient.
    """

    @property
    def bound_symbols(self):
        return {self.args[1], self.args[4]}

    def trials(self):
        f, x, place, coefficient, n = self.args
        same = sp.Eq(f, sp.Sum(coefficient * (x - place) ** n, (n, 0, sp.oo)), evaluate=False)
        return [(same, {x: place + sp.Rational(*away)}) for away in ((-7, 1), (-1, 3), (1, 2), (41, 10), (12, 1))]

    def check_dimensions(self, agree):
        f, x, place, coefficient, _ = self.args
        agree(x, place)
        agree(f, coefficient)
