"""Negative controls: each move with what is right, and with the one thing wrong that must not pass."""

import mpmath
import pytest
import sympy as sp
from sympy import Eq, Ge, Gt, Interval, LambertW, Lt, Rational, cos, exp, sin

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.ledger.derivation import recording
from galileo_sym.primitives import flight_factor, phi1
from galileo_sym.tactics import (
    at_rest,
    check_root,
    elementary_limit,
    eliminate,
    eliminate_angle,
    eliminate_one,
    introduce,
    limit_by_parameter,
    limits_at_zero,
    same_order,
    simplify_inside,
    sum_of_series,
    taylor_of_motion,
    twin_at_zero,
    undo,
    unhide,
)
from galileo_sym.tactics.taylor_steps import taylor_integrate

x, y, z = sp.symbols("x y z", real=True)
p, q, k, g = sp.symbols("p q k g", positive=True)
t = sp.Symbol("t", nonnegative=True)
n = sp.Symbol("n", integer=True, nonnegative=True)
s = sp.Function("s")
V = s(t).diff(t)
FALL = Eq(V.diff(t), g - k * V, evaluate=False)
REST = at_rest(s(t))
PRODUCT = x * exp(x)
RISING = StrictlyIncreasing(PRODUCT, x, Interval(-1, sp.oo))
FALLING = StrictlyDecreasing(PRODUCT, x, Interval(-sp.oo, -1))
U_OF_S = -p / (1 - exp(-p))
PARABOLA = x * z - x**2 * (1 + z**2)  # its envelope over z is x^2 + y = 1/4
PHI1_AT_0 = limits_at_zero(phi1(-p).rewrite(exp), p, 1, -Rational(1, 2))


def _series(equation, start=REST):
    return sum_of_series(taylor_of_motion(equation, s(t), start, n))


# the move with what is right
RIGHT = {
    "order of values": lambda: same_order(RISING, p, q),
    "order of values, falling": lambda: same_order(FALLING, -2 - p, -2 - q),
    "order of places told": lambda: same_order(RISING, x, q, inside={x: Interval(0, 1)}),
    "resultant": lambda: eliminate_one(PARABOLA - y, sp.diff(PARABOLA, z), z, (x, y), {x: "x > 0"}),
    "basis": lambda: eliminate([x * (y - z), z - 1], (z,), (x, y), {x: "x > 0"}),
    "angle": lambda: eliminate_angle(Eq(x, cos(p)), Eq(y, sin(p)), p, (x, y)),
    "limit from below": lambda: limit_by_parameter(U_OF_S + p, y, -1, "-", p, U_OF_S, 0),
    "undo": lambda: undo(RISING, Eq(LambertW(q) * exp(LambertW(q)), q), Ge(LambertW(q), -1), x),
    "series": lambda: _series(FALL),
    "root": lambda: check_root(Eq(x**2, 2, evaluate=False), x, sp.sqrt(2)),
    "primitive": lambda: introduce(LambertW(-(1 + p) * exp(-1 - p)), flight_factor(p)),
    "twin": lambda: twin_at_zero(g * phi1(-k), k, {phi1: PHI1_AT_0}, exp),
    "steps": lambda: taylor_integrate(FALL, s(t), REST, {g: 1, k: 2}, [1]),
}
# and with one thing wrong
WRONG = {
    "order: nothing is said of monotony": lambda: same_order(Gt(x, 0), p, q),
    "order: a place outside": lambda: same_order(RISING, -2 - p, q),
    "order: a place of which nothing is known": lambda: same_order(RISING, x, q),
    "order: a place in too large a range": lambda: same_order(RISING, x, q, inside={x: Interval(-2, 1)}),
    "resultant: a spurious factor left in": lambda: eliminate_one(PARABOLA - y, sp.diff(PARABOLA, z), z, (x, y)),
    "resultant: another factor named": lambda: eliminate_one(
        PARABOLA - y, sp.diff(PARABOLA, z), z, (x, y), {y: "y > 0"}
    ),
    "resultant: no common root": lambda: eliminate_one(z, z + 1, z, (x, y)),
    "resultant: always a common root": lambda: eliminate_one(z * x, z * y, z, (x, y)),
    "basis: a spurious factor left in": lambda: eliminate([x * (y - z), z - 1], (z,), (x, y)),
    "basis: a factor that does not occur": lambda: eliminate([x * (y - z), z - 1], (z,), (x, y), {x: "", y: ""}),
    "angle: equations that contradict each other": lambda: eliminate_angle(
        Eq(x, cos(p)), Eq(x + 1, cos(p)), p, (x, y)
    ),
    "limit: the other side": lambda: limit_by_parameter(U_OF_S + p, y, -1, "+", p, U_OF_S, 0),
    "limit: another point": lambda: limit_by_parameter(U_OF_S + p, y, 0, "-", p, U_OF_S, 0),
    "limit: through W": lambda: elementary_limit((LambertW(x * exp(x)) + 1) / (x + 1), x, -1, "-"),
    "undo: the wrong half": lambda: undo(FALLING, Eq(LambertW(q) * exp(LambertW(q)), q), Ge(LambertW(q), -1), x),
    "series: a law that is not linear": lambda: _series(Eq(V.diff(t), g - k * V**2)),
    "series: coefficients that change": lambda: _series(Eq(V.diff(t), g - k * t * V)),
    "series: a recurrence of three terms": lambda: _series(Eq(V.diff(t), g - k * V - s(t))),
    "series: no law of motion": lambda: _series(Eq(s(t), g * t)),
    "series: an initial value missing": lambda: _series(FALL, {s(0): 0}),
    "root: none": lambda: check_root(Eq(x**2, 2, evaluate=False), x, sp.sqrt(3)),
    "primitive: the other branch": lambda: introduce(LambertW(-(1 + p) * exp(-1 - p), -1), flight_factor(p)),
    "twin: not a multiple of the force": lambda: twin_at_zero(phi1(1 - k), k, {phi1: PHI1_AT_0}, exp),
    "steps: a symbol without value": lambda: taylor_integrate(FALL, s(t), REST, {g: 1}, [1]),
    "steps: a law that is not linear": lambda: taylor_integrate(
        Eq(V.diff(t), g - V**2), s(t), REST, {g: 1}, [1]
    ),
}  # fmt: skip


@pytest.mark.parametrize("move", RIGHT.values(), ids=RIGHT)
def test_what_is_right_passes(move):
    assert move() is not None


@pytest.mark.parametrize("move", WRONG.values(), ids=WRONG)
def test_what_is_wrong_is_refused(move):
    with pytest.raises(DerivationError):
        move()


def test_every_move_has_a_wrong_one():
    assert {name.split(":")[0].split()[0] for name in WRONG} == {name.split()[0] for name in RIGHT}


class TestResults:
    """What the moves return, held against values found by hand."""

    def test_order(self):
        assert same_order(RISING, p, q) == sp.Equivalent(Lt(p * exp(p), q * exp(q)), Lt(p, q))
        falls = same_order(FALLING, -2 - p, -2 - q)
        assert any(isinstance(e, sp.StrictGreaterThan) and e.has(exp) for e in falls.args)

    def test_resultant(self):
        found = eliminate_one(PARABOLA - y, sp.diff(PARABOLA, z), z, (x, y), {x: "x > 0"})
        assert sp.expand(found.lhs / sp.Poly(found.lhs, x, y).coeff_monomial(y) - (x**2 + y - Rational(1, 4))) == 0

    def test_series_of_a_fall(self):
        assert sp.simplify(_series(FALL) - (g * t / k - g / k**2 * (1 - exp(-k * t)))) == 0

    def test_series_of_a_throw_without_drag_ends(self):
        thrown = _series(Eq(V.diff(t), -g), {s(0): p, V.subs(t, 0): q})
        assert sp.expand(thrown - (p + q * t - g * t**2 / 2)) == 0

    def test_series_of_first_order(self):
        assert sp.simplify(_series(Eq(V, g - k * s(t)), {s(0): p}) - (g / k + (p - g / k) * exp(-k * t))) == 0

    def test_the_recurrence_is_told(self):
        with recording() as record:
            taylor_of_motion(FALL, s(t), REST, n)
        (told,) = record.steps
        left, right = (side.subs({n: 7, g: 2, k: 3, t: 5}) for side in told.statement.args)
        assert left == right != 0

    def test_steps_enclose_and_shrink(self):
        exact = {g: 3, k: 20}
        ((far, _),) = taylor_integrate(FALL, s(t), REST, exact, [Rational(5, 2)], digits=50)
        with mpmath.workdps(90):
            truth = mpmath.mpf(3) * 5 / 40 - mpmath.mpf(3) / 400 * (1 - mpmath.exp(-50))
            assert truth in far
            assert truth * (1 + mpmath.mpf(10) ** -50) not in far
            assert mpmath.mpf(far.delta) < mpmath.mpf(10) ** -50

    def test_steps_of_an_oscillation(self):
        """Both lower derivatives are in the law, which the series in symbols refuses."""
        swing = Eq(V.diff(t), -4 * s(t))
        ((place, speed),) = taylor_integrate(swing, s(t), {s(0): 1, V.subs(t, 0): 0}, {}, [3])
        with mpmath.workdps(60):
            assert mpmath.cos(6) in place
            assert -2 * mpmath.sin(6) in speed

    def test_unhide_keeps_a_positive_root_real(self):
        hidden = sp.Symbol("c", positive=True)
        assert unhide(1 / sp.sqrt(hidden), {hidden: cos(x)}).subs(x, 0) == 1

    def test_simplify_inside_keeps_the_branch(self):
        tidy = simplify_inside(LambertW(p * exp(q) * exp(-q), -1) + p - p)
        assert tidy == LambertW(p, -1)
