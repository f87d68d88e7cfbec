"""Claims about a function near a point: an extremum, or what holds on one side; and coefficients that all vanish."""

from __future__ import annotations

from itertools import pairwise

import sympy as sp

from .predicates import FIRST, SECOND, Claim

# "for some h > 0" is tried very near
BESIDE = [sp.S.Zero, *(sp.Rational(n, 10**e) for n, e in ((1, 16), (7, 16), (3, 9), (1, 4), (1, 3)))]
FURTHER = [sp.Rational(n, 10**e) for n, e in ((2, 17), (5, 9), (1, 4))]
AT_IT_AND_NEAR = [sp.S.Zero, *(sp.Rational(n, 10**e) for n, e in ((1, 30), (7, 16), (3, 9)))]


class LocalExtremum(Claim):
    """``LocalExtremum(f, x, place)``: near the place f is nowhere below, or nowhere above, its value there."""

    def trials(self):
        f, x, place = self.args
        left, right = (f.subs(x, place + away) - f.subs(x, place) for away in (-FIRST, SECOND))
        same_side = sp.Ge(left * right, 0, evaluate=False)
        return [(same_side, {FIRST: a, SECOND: b}) for a in FURTHER for b in FURTHER]

    def check_dimensions(self, agree):
        f, x, place = self.args
        agree(f)
        agree(x, place)


class MonotoneBeside(Claim):
    """``MonotoneBeside(f, x, place, side, direction)``: f is strictly monotone on an interval that ends at the place.

    The interval is to the right (`side` 1) or to the left (-1), closed at the place; f increases there if `direction`,
    which is not 0, is positive, and decreases if it is negative.
    """

    def trials(self):
        f, x, place, side, direction = self.args
        gain = f.subs(x, place + SECOND) - f.subs(x, place + FIRST)
        ordered = sp.Gt(gain * direction, 0, evaluate=False)
        ends = [(a, b) if side > 0 else (-b, -a) for a, b in pairwise(BESIDE)]
        return [(ordered, {FIRST: a, SECOND: b}) for a, b in ends]

    def check_dimensions(self, agree):
        f, x, place, _, direction = self.args
        agree(f)
        agree(direction)
        agree(x, place)


class HoldsBeside(Claim):
    """``HoldsBeside(statement, x, place, side)``: the statement holds for every x of some interval.

    The interval ends at the place, which belongs to it, and is to its right (`side` 1) or to its left (-1).
    """

    def trials(self):
        statement, x, place, side = self.args
        return [(statement, {x: place + side * away}) for away in AT_IT_AND_NEAR]

    def check_dimensions(self, agree):
        _, x, place, _ = self.args
        agree(x, place)


class AllZero(Claim):
    """``AllZero(term, i, first, last)``: the term is 0 for every whole number i from `first` to `last`."""

    def trials(self):
        term, i, first, last = self.args
        beyond = sp.Gt(i, last, evaluate=False)
        gone = sp.Or(beyond, sp.Eq(term, 0, evaluate=False), evaluate=False)
        return [(gone, {i: first + n}) for n in range(8)]

    def check_dimensions(self, agree):
        term, i, first, last = self.args
        agree(term)
        agree(i, first, last)
