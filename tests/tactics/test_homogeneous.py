"""Hypotheses put to use, and f(cos(a) u) = cos(a) f(u) solved: each tactic refuses what does not fit."""

import pytest
import sympy as sp
from sympy import And, Eq, Function, Ge, Gt, Implies, Interval, Lt, Max, acos, cos, oo, sin

from galileo_sym.ledger import DerivationError, ForAll, Independent, Premise, StrictlyIncreasing
from galileo_sym.tactics import (
    by_differentiation,
    conclusions,
    homogeneous,
    independent_sides,
    instantiate,
    ladder_order,
    modus_ponens,
    proportional_below,
    same_argument,
)

x, y, a = sp.symbols("x y a", real=True)
u, v, w, c = sp.symbols("u v w c", positive=True)
f, h = Function("f", real=True), Function("h", real=True)
SCALING = Eq(f(u * cos(a)), cos(a) * f(u))
refused = pytest.raises(DerivationError)


class TestInstantiate:
    SMALL = ForAll(Lt(f(x), 1), x, Interval.Ropen(0, u))

    def test_a_place_inside(self):
        assert instantiate(self.SMALL, u / 2) == Lt(f(u / 2), 1)
        assert instantiate(self.SMALL, v, [Lt(v, u)]) == Lt(f(v), 1)
        assert instantiate(self.SMALL, Max(v, w), [Lt(v, u), Gt(u, w)]) == Lt(f(Max(v, w)), 1)

    @pytest.mark.parametrize("place", [u, 2 * u, -v, v, Max(v, w)])
    def test_a_place_that_may_be_outside(self, place):
        with refused:
            instantiate(self.SMALL, place, [Lt(w, u)])

    def test_a_weak_order_does_not_do_at_an_open_end(self):
        with refused:
            instantiate(self.SMALL, v, [Ge(u, v)])

    def test_the_claim_must_be_general(self):
        with refused:
            instantiate(StrictlyIncreasing(f(x), x, Interval(0, u)), u)


def test_modus_ponens():
    implication = Implies(And(Gt(x, 0), Gt(y, 0)), Gt(x + y, 0))
    assert modus_ponens(implication, (Gt(x, 0), Gt(y, 0))) == Gt(x + y, 0)
    with refused:
        modus_ponens(implication, (Gt(x, 0),))
    with refused:
        modus_ponens(Gt(x, 0), (Gt(x, 0),))


def test_conclusions_where_the_condition_is_met():
    told = Premise("test", And(Eq(y, x), Implies(Lt(x, 0), And(Lt(y, 1), Gt(y, -1)))))
    assert conclusions(told, x, -u).statement == And(Eq(y, x), Lt(y, 1), Gt(y, -1))
    for variable, place in ((x, u), (x, v - u), (y, -u)):
        with refused:
            conclusions(told, variable, place)


def test_a_value_taken_once():
    rising = StrictlyIncreasing(f(x), x, Interval(0, oo))
    assert same_argument(rising, Eq(f(v), f(w)), v, w) == Eq(v, w)
    for claim, equal, one in [
        (rising, Eq(f(v), f(2 * w)), v),  # another value
        (rising, Eq(f(-v), f(w)), -v),  # outside
        (ForAll(Gt(f(x), 0), x, Interval(0, oo)), Eq(f(v), f(w)), v),  # not monotone
    ]:
        with refused:
            same_argument(claim, equal, one, w)


class TestHomogeneous:
    def test_both_sides_are_independent_of_the_angle(self):
        left, right = independent_sides(Eq(f(u * cos(a)) / cos(a), h(u)), a)
        assert (left, right) == (Independent(f(u * cos(a)) / cos(a), a), Independent(h(u), a))
        assert homogeneous(left, f) == SCALING

    def test_a_side_that_depends_on_the_angle_openly_or_not(self):
        with refused:
            independent_sides(Eq(f(u), sin(a)), a)
        with refused:
            independent_sides(Eq(f(u * cos(a)), h(u)), a, hidden=(h,))

    def test_another_weight_gives_another_equation(self):
        assert homogeneous(Independent(f(u * cos(a)) / cos(a) ** 2, a), f) == Eq(f(u * cos(a)), cos(a) ** 2 * f(u))

    def test_proportional_below(self):
        assert proportional_below(SCALING, f, a, v, Gt(u, Max(v, w))) == Eq(u * f(v), v * f(u))

    @pytest.mark.parametrize(
        ("equation", "above"),
        [
            (SCALING, Gt(u, w)),  # says nothing of v
            (SCALING, Gt(v, u)),  # v is too fast
            (Eq(f(u * cos(a)), cos(a) ** 2 * f(u)), Gt(u, v)),  # f = v^2 satisfies this
            (Eq(f(u * sin(a)), sin(a) * f(u)), Gt(u, v)),
            (Eq(h(u * cos(a)), cos(a) * f(u)), Gt(u, v)),
        ],
    )
    def test_what_does_not_fit(self, equation, above):
        with refused:
            proportional_below(equation, f, a, v, above)

    def test_the_angle_chosen_is_right(self):
        """A force that is not linear shows it: at a = acos(v/u) the equation is about f(v) and f(u) alone."""
        quadratic = SCALING.subs(a, acos(v / u)).replace(f, lambda s: s**2)
        assert quadratic == Eq(v**2, u * v)

    def test_by_differentiation(self):
        law, solution = by_differentiation(SCALING, f, a, v)
        assert law == Eq(v * f(v).diff(v), f(v))
        assert solution == Eq(f(v), sp.Symbol("C1") * v)
        with refused:
            by_differentiation(Eq(f(u * cos(a)), cos(a) ** 2 * f(u)), f, a, v)


def test_order_by_the_ladder():
    assert ladder_order(c * x, sp.exp(c * x), x) == Lt(c * x, sp.exp(c * x))
    with refused:
        ladder_order(sp.exp(x), c * x, x)
