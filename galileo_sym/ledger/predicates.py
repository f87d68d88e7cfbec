"""Claims that are not equations: monotony, uniqueness, maxima, curves traced once, independence.

Each is a frozen SymPy object that knows how to be tried numerically. A tactic proves one by returning it.
"""

from __future__ import annotations

from itertools import pairwise

import sympy as sp
from sympy.logic.boolalg import BooleanFunction


class Claim(BooleanFunction):
    """A statement about a function as a whole; subclasses name their arguments and give `trials`."""

    @classmethod
    def eval(cls, *args):
        return None

    @property
    def bound_symbols(self):
        """Variables that the claim quantifies."""
        return {self.args[1]}

    @property
    def free_symbols(self):
        return super().free_symbols - self.bound_symbols

    def trials(self):
        """Quantifier-free consequences: pairs of a Boolean and the values of the variables it is to be tried at."""
        raise NotImplementedError

    def check_dimensions(self, agree):
        """Call `agree` with expressions that must have one dimension."""
        f, x, interval = self.args[:3]
        agree(f)
        ends = [e for e in (interval.start, interval.end) if e.is_finite is not False]
        agree(x, *ends)


FIRST, SECOND = sp.Dummy("first", real=True), sp.Dummy("second", real=True)


# Shifts that make a grid uneven, so that no period of a function falls in with it.
_UNEVEN = [sp.Rational(n, 1000) for n in (137, -291, 377, -59, 223, -411, 83, -171, 319)]


def spread(interval, count=9):
    """Points across an interval, unevenly; open ends approached and infinite ones reached far out."""
    low, high = interval.start, interval.end
    far = [sp.Integer(10) ** sp.Rational(30 * i - 15 * (count - 1), count - 1) for i in range(count)]
    if low is sp.S.NegativeInfinity and high is sp.S.Infinity:
        return [*(-f for f in reversed(far)), sp.S.Zero, *far]
    if high is sp.S.Infinity:
        return [*([] if interval.left_open else [low]), *(low + f for f in far)]
    if low is sp.S.NegativeInfinity:
        return [*(high - f for f in reversed(far)), *([] if interval.right_open else [high])]
    inset = sp.Rational(1, 10**4)
    left = inset if interval.left_open else 0
    right = inset if interval.right_open else 0
    grid = [sp.Integer(0), *((i + _UNEVEN[i % len(_UNEVEN)]) / sp.Integer(count - 1) for i in range(1, count - 1)), 1]
    return [low + (high - low) * (left + g * (1 - left - right)) for g in grid]


class Monotone(Claim):
    """A function whose values along an interval are in strict order."""

    order = None

    def trials(self):
        f, x, interval = self.args
        ordered = self.order(f.subs(x, FIRST), f.subs(x, SECOND), evaluate=False)
        return [(ordered, {FIRST: a, SECOND: b}) for a, b in pairwise(spread(interval))]


def _at_open_ends(interval, end):
    """A point very near to an open end (0: the lower, 1: the upper): a root may hide there."""
    place, open_there = ((interval.start, interval.left_open), (interval.end, interval.right_open))[end]
    width = interval.end - interval.start
    if not open_there or width.is_infinite:
        return []
    return [place + (1 - 2 * end) * width * sp.Rational(1, 10**20)]


class StrictlyIncreasing(Monotone):
    """``StrictlyIncreasing(f, x, interval)``."""

    order = sp.StrictLessThan


class StrictlyDecreasing(Monotone):
    """``StrictlyDecreasing(f, x, interval)``."""

    order = sp.StrictGreaterThan


class ExactlyOneRoot(Claim):
    """``ExactlyOneRoot(f, x, interval)``: f vanishes exactly once in the interval (at a closed end, it may be)."""

    def trials(self):
        f, x, interval = self.args
        points = [*_at_open_ends(interval, 0), *spread(interval, 12), *_at_open_ends(interval, 1)]
        return [(OneSignChange(f, x, sp.Tuple(*points)), {})]


class OneSignChange(Claim):
    """``OneSignChange(f, x, points)``: along the points f changes sign, or vanishes at a point, once."""

    def signs_of(self, sign, size):
        """Whether it is so, with `sign` and `size` giving the sign and the absolute value of f at a value of x.

        Where the size is smallest between points of one sign, two roots may be close together: it is followed down.
        """
        f, x, points = self.args
        signs = [sign(f, x, p) for p in points]
        if signs.count(0) + sum(a * b < 0 for a, b in pairwise(signs)) != 1:
            return False
        sizes = [size(f, x, p) for p in points]
        for i in range(1, len(points) - 1):
            alone = signs[i - 1] == signs[i] == signs[i + 1] and sizes[i] < min(sizes[i - 1], sizes[i + 1])
            if alone and sign(f, x, _lowest(lambda p: size(f, x, p), points[i - 1], points[i + 1])) != signs[i]:
                return False
        return True


def _lowest(size, low, high, rounds=36):
    """Where a size is smallest between two places, if it first falls and then rises."""
    first, last = sp.S.Zero, sp.S.One
    for _ in range(rounds):
        third = (last - first) / 3
        if size(low + (high - low) * (first + third)) < size(low + (high - low) * (last - third)):
            last -= third
        else:
            first += third
    return low + (high - low) * (first + last) / 2


class UniqueMaximum(Claim):
    """``UniqueMaximum(f, x, interval, place)``: f is largest at `place`, and nowhere else."""

    def trials(self):
        f, x, interval, place = self.args
        below = sp.StrictLessThan(f, f.subs(x, place), evaluate=False)
        beside = sp.Or(sp.Eq(x, place, evaluate=False), below, evaluate=False)
        near = [place + (end - place) * sp.Rational(1, 1000) for end in (interval.start, interval.end) if end.is_finite]
        return [(beside, {x: p}) for p in (*spread(interval), *near)]


class Independent(Claim):
    """``Independent(f, x)``: the value of f does not depend on x."""

    def trials(self):
        f, x = self.args
        same = sp.Eq(f.subs(x, FIRST), f.subs(x, SECOND), evaluate=False)
        side = -1 if x.is_negative else 1
        values = [sp.Rational(side * n, 7919) for n in (1583, 4525, 11003, 2741)]
        return [(same, {FIRST: a, SECOND: b}) for a, b in pairwise(values)]

    def check_dimensions(self, agree):
        agree(self.args[0])


def _at(relation, place):
    """A relation at a place, unevaluated: to decide it is the business of the trial."""
    return (
        relation.func(*(side.xreplace(place) for side in relation.args), evaluate=False) if relation.args else relation
    )


class TracesOnce(Claim):
    """``TracesOnce((X, Y), q, interval, curve, region, (x, y), inverse)``.

    As q runs through the interval the point (X(q), Y(q)) runs once through exactly those points (x, y) of `curve`
    that lie in `region`; `inverse` gives q from (x, y), inside the interval. A closed curve ends where it began: the
    ends of a closed interval may both give one point, where `inverse` need not have a value; it counts once.
    """

    @property
    def bound_symbols(self):
        return {self.args[1], *self.args[5]}

    def trials(self):
        (px, py), q, interval, curve, region, (x, y), inverse = self.args
        here = {x: px, y: py}
        parts = [_at(curve, here), _at(region, here), sp.Eq(inverse.xreplace(here), q, evaluate=False)]
        traced = [(part, {q: p}) for p in spread(interval)[1:-1] for part in parts]
        return traced + self._complete()

    def _complete(self):
        """Points of the circle that lie in the region are all on the trace."""
        (px, py), q, interval, curve, region, (x, y), inverse = self.args
        squares = sp.Poly(sp.expand(curve.lhs - curve.rhs), x, y)
        lead = squares.coeff_monomial(x**2)
        a, b = (-squares.coeff_monomial(c) / (2 * lead) for c in (x, y))
        radius = sp.sqrt(a**2 + b**2 - squares.coeff_monomial(1) / lead)
        there = {x: a + radius * sp.cos(FIRST), y: b + radius * sp.sin(FIRST)}
        back = inverse.xreplace(there)
        trace = [sp.Eq(f.xreplace({q: back}), there[c], evaluate=False) for f, c in ((px, x), (py, y))]
        after, before = sp.Gt if interval.left_open else sp.Ge, sp.Lt if interval.right_open else sp.Le
        inside = [after(back, interval.start, evaluate=False), before(back, interval.end, evaluate=False)]
        on_it = sp.And(*trace, *inside, evaluate=False)
        reached = on_it if region == sp.true else sp.Or(sp.Not(_at(region, there)), on_it, evaluate=False)
        return [(reached, {FIRST: sp.Rational(n, 7919)}) for n in (1583, 9473, 19001, 27011, 37003, 45007)]

    def check_dimensions(self, agree):
        (px, py), _, _, _, _, (x, y), _ = self.args
        agree(px, py, x, y)
