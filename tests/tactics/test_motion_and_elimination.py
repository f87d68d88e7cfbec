"""Motions solved from rest, unknowns eliminated, equations solved: what cannot be shown is refused."""

import pytest
import sympy as sp
from sympy import Eq, cos, exp, sin, sqrt

from galileo_sym.ledger import DerivationError
from galileo_sym.tactics import (
    at_rest,
    eliminate,
    eliminate_angle,
    integrate_from_zero,
    isolate,
    solve_motion,
    start_of,
    substitute,
)

x, y, r = sp.symbols("x y r", real=True)
p, q, k, g = sp.symbols("p q k g", positive=True)
t = sp.Symbol("t", nonnegative=True)
s = sp.Function("s")
VELOCITY = s(t).diff(t)
refused = pytest.raises(DerivationError)


def _eq(left, right):
    return Eq(left, right, evaluate=False)


class TestMotion:
    FALL = _eq(s(t).diff(t, 2), g - k * VELOCITY)

    def test_a_fall_with_drag_from_rest(self):
        """Held against a solution found by hand."""
        found = solve_motion(self.FALL, s(t), at_rest(s(t)))
        assert sp.simplify(found.rhs - (g * t / k - g / k**2 * (1 - exp(-k * t)))) == 0

    def test_the_initial_values_count(self):
        thrown = solve_motion(self.FALL, s(t), {s(0): p, VELOCITY.subs(t, 0): q}).rhs
        assert sp.simplify(thrown.subs(t, 0) - p) == 0
        assert sp.simplify(sp.diff(thrown, t).subs(t, 0) - q) == 0
        assert sp.simplify(thrown - solve_motion(self.FALL, s(t), at_rest(s(t))).rhs) != 0

    def test_a_solver_that_misses_is_caught(self, monkeypatch):
        wrong = {"equation": g * t**2 / 2, "start": 1 + g * t / k - g / k**2 * (1 - exp(-k * t))}
        for expression in wrong.values():
            monkeypatch.setattr(sp, "dsolve", lambda *_, e=expression, **__: Eq(s(t), e))
            with refused:
                solve_motion(self.FALL, s(t), at_rest(s(t)))

    def test_a_speed_at_the_start_that_is_missed_is_caught(self, monkeypatch):
        drifting = g * t / k - g / k**2 * (1 - exp(-k * t)) + (1 - exp(-k * t))
        monkeypatch.setattr(sp, "dsolve", lambda *_, **__: Eq(s(t), drifting))
        with refused:
            solve_motion(self.FALL, s(t), at_rest(s(t)))

    def test_the_start_is_found_among_equations(self):
        rest = [Eq(x, s(t)), Eq(s(0), 0), Eq(VELOCITY.subs(t, 0), q)]
        assert start_of(rest, s(t)) == {s(0): 0, VELOCITY.subs(t, 0): q}

    def test_integration_from_zero(self):
        assert integrate_from_zero(_eq(VELOCITY, g * t), s(t)).rhs.equals(g * t**2 / 2)
        with refused:
            integrate_from_zero(_eq(s(t), g * t), s(t))


class TestElimination:
    def test_a_line_from_two_equations(self):
        assert eliminate([_eq(x, 2 * r), _eq(y, 3 * r)], (r,), (x, y)).lhs.equals(3 * x - 2 * y)

    def test_an_angle_gives_the_unit_circle(self):
        found = eliminate_angle(_eq(x, sin(r)), _eq(y, cos(r)), r, (x, y))
        assert sp.expand(found.lhs / sp.Poly(found.lhs, x).LC() - (x**2 + y**2 - 1)) == 0

    def test_a_spurious_factor_must_be_named(self):
        equations = [_eq(x * (x - y) * 2, r), _eq(r, sp.S.Zero)]
        with pytest.raises(DerivationError, match="more than one factor"):
            eliminate(equations, (r,), (x, y))
        assert eliminate(equations, (r,), (x, y), spurious={x: "x > 0"}).lhs.equals(x - y)

    def test_a_factor_that_does_not_occur_cannot_be_removed(self):
        with pytest.raises(DerivationError, match="do not occur"):
            eliminate([_eq(x, r), _eq(y, r)], (r,), (x, y), spurious={x + y: "never"})

    @pytest.mark.parametrize("equations", [[_eq(x, r)], [_eq(x, r), _eq(y, r), _eq(x, 2 * r)]])
    def test_too_few_or_too_many_equations(self, equations):
        with pytest.raises(DerivationError, match="equations are left"):
            eliminate(equations, (r,), (x, y))


class TestSolving:
    def test_assumptions_choose_the_root(self):
        assert isolate(_eq(p**2, 4 * q), p).rhs.equals(2 * sqrt(q))

    def test_a_second_root_must_be_named(self):
        with pytest.raises(DerivationError, match="say which to drop"):
            isolate(_eq(x**2, 3 * x), x)
        assert isolate(_eq(x**2, 3 * x), x, drop={0: "the start"}).rhs == 3

    def test_a_root_that_is_none_cannot_be_dropped(self):
        with pytest.raises(DerivationError, match="not among"):
            isolate(_eq(x**2, 3 * x), x, drop={1: "none"})

    def test_no_root(self):
        with refused:
            isolate(_eq(p, -q - 1), p)

    def test_hidden_parts_come_back(self):
        c = sp.Symbol("c", positive=True)
        root = isolate(_eq(q, p**2 * cos(r)), p, hide={cos(r): c}).rhs
        assert sp.simplify(root**2 - q / cos(r)) == 0
        assert root.subs({q: 2, r: 1}).is_positive

    def test_substitution_on_both_sides(self):
        assert substitute(_eq(p * q, q**2), {q: 2}) == _eq(2 * p, sp.Integer(4))
