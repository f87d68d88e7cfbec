"""Each tactic is asked for something false that its form would allow: it must see that a condition is not met."""

import pytest
import sympy as sp
from sympy import Eq, Ge, Gt, Interval, Le, Limit, Lt, Rational, atan, cos, exp, oo, pi, sin, sqrt, tan

from galileo_sym.ledger import DerivationError, ForAll, Independent, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.ledger.analysis import Continuous
from galileo_sym.tactics import (
    arguments_reversed,
    bound_by_end,
    compose_monotone,
    elementary_limit,
    homogeneous,
    inner_monotone,
    instantiate,
    isolate,
    least_value,
    limit_of_inverse,
    limit_with_part,
    one_root,
    read_circle,
    solve_angle,
    solve_motion,
    undo,
    unique_maximum,
)
from galileo_sym.tactics.places import ordered, require_inside

w, x, y, z, a, q = sp.symbols("w x y z a q", real=True)
k, n, t = sp.symbols("k n t", positive=True)
f, s, W = sp.Function("f"), sp.Function("s"), sp.Function("W")
LINE, HALF, AFTER = Interval(-oo, oo), Interval(0, oo), Interval.open(0, oo)
JUMP = x + atan(1 / x)  # increases on both sides of 0, from 0- to -pi/2, and anew from pi/2 at 0+


def _eq(left, right):
    return Eq(left, right, evaluate=False)


FALSE_CONCLUSIONS = {
    "n - 5x rises with n, not with x": lambda: compose_monotone(
        StrictlyIncreasing(n - 5 * x, n, LINE), StrictlyIncreasing(x, x, Interval(0, 1))
    ),
    "x^2 is continuous, not monotone": lambda: compose_monotone(
        StrictlyDecreasing(-n, n, LINE), Continuous(x**2, x, Interval(-1, 1))
    ),
    "-x does not rise, though 10x - x does": lambda: inner_monotone(
        StrictlyIncreasing(9 * x, x, LINE), StrictlyIncreasing(n + 10 * x, n, LINE), -x, LINE
    ),
    "x + atan(1/x) has no root above 0": lambda: one_root(
        StrictlyIncreasing(JUMP, x, AFTER), 0, ends=(Eq(Limit(JUMP, x, 0, "-"), -pi / 2), Eq(Limit(JUMP, x, oo), oo))
    ),
    "sin(9x) + x = 1/2 has several roots": lambda: one_root(
        Continuous(-sin(9 * x) - x, x, Interval(0, 2)), -Rational(1, 2)
    ),
    "z - x is not least at x = 0": lambda: least_value(
        StrictlyDecreasing(z - x, x, Interval(-oo, 0)), StrictlyIncreasing(z - x, z, HALF)
    ),
    "x - z is not largest at x = 0": lambda: unique_maximum(
        StrictlyIncreasing(x - z, x, Interval(-1, 0)), StrictlyDecreasing(x - z, z, Interval(0, 1))
    ),
    "-z^2 is not positive": lambda: bound_by_end(Continuous(-(x**2), x, HALF), z, Gt(z, 0, evaluate=False)),
    "w^3 - w takes values twice": lambda: undo(
        Continuous(w**3 - w, w, HALF), _eq(W(q) ** 3 - W(q), q), Ge(W(q), 0, evaluate=False), z
    ),
    "2 is no arctangent": lambda: limit_of_inverse(
        StrictlyIncreasing(atan(w), w, HALF),
        _eq(atan(W(q)), q),
        Ge(W(q), 0, evaluate=False),
        Gt(sp.Integer(2), 0, evaluate=False),
    ),
    "W_(-1) has no value at 1": lambda: limit_of_inverse(
        StrictlyDecreasing(w * exp(w), w, Interval(-oo, -1)),
        _eq(W(q) * exp(W(q)), q),
        Le(W(q), -1, evaluate=False),
        Gt(sp.Integer(1), -exp(-1), evaluate=False),
    ),
    "x <= z does not make them different": lambda: arguments_reversed(
        StrictlyDecreasing(-x, x, LINE), Le(-x, -z, evaluate=False), x, _eq(-z, -z), z
    ),
    "a positive number does not come to 0 from below": lambda: elementary_limit(
        t / sqrt(2 * (t - 1 + exp(-t))), t, 0, "-"
    ),
    "s may depend on the angle": lambda: homogeneous(Independent(f(s(t) * cos(a)) / cos(a), a), f, hidden=(s,)),
    "x*k does not rise with k for x = 1/k": lambda: instantiate(
        ForAll(StrictlyIncreasing(x * k, k, AFTER), x, AFTER), 1 / k
    ),
    "s = 0 solves it, too": lambda: solve_motion(Eq(s(t).diff(t), 3 * s(t) ** Rational(2, 3)), s(t), {s(0): sp.S.Zero}),
    "s' at first is not said": lambda: solve_motion(Eq(s(t).diff(t, 2), k), s(t), {s(0): sp.S.Zero}),
    "a sine does not settle": lambda: elementary_limit(sin(1 / x), x, 0),
    "y/x is a quotient of zeros": lambda: limit_with_part(y / x, y, 0, x, 0),
    "a y/x is, too": lambda: limit_with_part(a * y / x, y, 0, x, 0),
    "the tangent is 1 in every half turn": lambda: isolate(_eq(tan(x), a), x),
    "w e^w takes values twice": lambda: isolate(_eq(w * exp(w), sp.Symbol("plain")), w),
    "sin x = a is no equation for the tangent": lambda: solve_angle(_eq(sin(x), a), x, Interval(0, 1)),
    "the tangent is periodic": lambda: solve_angle(_eq(tan(x), a), x, Interval(0, pi)),
    "a circle without points": lambda: read_circle(_eq(x**2 + y**2 + k, sp.S.Zero), x, y),
    "1 is not below 1": lambda: require_inside(sp.S.One, Interval.Ropen(0, 1)),
    "a place known to be at most 1 may be 1": lambda: require_inside(x, Interval.Ropen(-oo, 1), [Le(x, 1)]),
}


@pytest.mark.parametrize("ask", FALSE_CONCLUSIONS.values(), ids=FALSE_CONCLUSIONS)
def test_what_is_false_is_refused(ask):
    with pytest.raises(DerivationError):
        ask()


def test_an_angle_is_solved_for():
    acute = Interval.open(0, pi / 2)
    assert solve_angle(_eq(k * (cos(x) - n * sin(x)), sp.S.Zero), x, acute) == _eq(x, atan(1 / n))
    assert solve_angle(_eq(tan(x), -n), x, Interval.open(-pi / 2, 0)) == _eq(x, -atan(n))
    with pytest.raises(DerivationError, match="roots"):
        solve_angle(_eq(tan(x), -n), x, acute)


def test_an_arctangent_of_something_positive_is_acute():
    assert ordered(atan(n), pi / 2, strict=True)
    assert ordered(0, atan(n), strict=True)
    assert not ordered(atan(x), 0, strict=False)
    assert not ordered(atan(n), pi / 3, strict=True)
    assert ordered(x, y, strict=True, known=[Lt(x, y)])
