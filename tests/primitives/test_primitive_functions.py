"""The primitives as SymPy functions: value at 0, derivative, closed form, printing."""

import mpmath
import pytest
from sympy import E, Float, LambertW, Rational, S, Symbol, cos, exp, latex, limit, pi, series, sin, sqrt

from galileo_sym.primitives import (
    FUNCTIONS,
    best_angle,
    best_sine,
    best_time,
    branch_factor,
    descent_factor,
    driving,
    flight_factor,
    max_range_factor,
    phi1,
    phi2,
    range_balance,
    range_factor,
    range_loss,
    w0_offset,
    wm1_offset,
)

OFFSETS = (w0_offset, wm1_offset)  # like the square root at 0
ONE_ARGUMENT = [f for name, f in FUNCTIONS.items() if name != "driving"]
SMOOTH = [f for f in ONE_ARGUMENT if f not in OFFSETS]
AT_ZERO = {
    phi1: 1,
    phi2: Rational(1, 2),
    descent_factor: 1,
    flight_factor: 1,
    range_factor: 1,
    range_balance: 1,
    range_loss: Rational(4, 3),
    max_range_factor: 1,
    best_sine: sqrt(2) / 2,
    best_angle: pi / 4,
    best_time: sqrt(2),
    branch_factor: E,
    w0_offset: 0,
    wm1_offset: 0,
}
SLOPE_AT_ZERO = {
    phi1: Rational(1, 2),
    phi2: Rational(1, 6),
    descent_factor: Rational(1, 6),
    flight_factor: Rational(-1, 3),
    range_factor: Rational(-4, 3),
    range_balance: Rational(-4, 3),
    range_loss: Rational(-28, 9),
    max_range_factor: -2 * sqrt(2) / 3,
    best_sine: Rational(-1, 6),
    best_angle: -sqrt(2) / 6,
    best_time: Rational(-2, 3),
    branch_factor: -E,
}
x = Symbol("x", positive=True)


@pytest.mark.parametrize("function", ONE_ARGUMENT, ids=lambda f: f.__name__)
def test_value_at_zero(function):
    assert function(S.Zero) == AT_ZERO[function]


@pytest.mark.parametrize("function", ONE_ARGUMENT, ids=lambda f: f.__name__)
@pytest.mark.parametrize("point", [Rational(1, 7), Rational(3, 2), Rational(19, 2)])
def test_derivative_is_the_slope(function, point):
    with mpmath.workdps(60):
        step = Rational(1, 10**15)
        slope = (function(point + step).evalf(60) - function(point - step).evalf(60)) / (2 * step)
        derivative = function(x).diff(x).subs(x, point).evalf(60)
    assert abs(derivative - slope) < Float("1e-25")


@pytest.mark.parametrize("function", ONE_ARGUMENT, ids=lambda f: f.__name__)
@pytest.mark.parametrize("point", [Rational(1, 7), Rational(3, 2), Rational(19, 2)])
def test_closed_form(function, point):
    closed = function(x).rewrite(exp if function in (phi1, phi2) else LambertW)
    assert not closed.has(function)
    assert abs(closed.subs(x, point).evalf(50) - function(point).evalf(50)) < Float("1e-45")


@pytest.mark.parametrize("function", [phi1, phi2])
def test_value_at_zero_is_the_limit_of_the_closed_form(function):
    assert limit(function(x).rewrite(exp), x, 0) == function(S.Zero)


@pytest.mark.parametrize("function", SMOOTH, ids=lambda f: f.__name__)
def test_evaluation_keeps_all_digits_of_tiny_arguments(function):
    rise = function(Rational(1, 10**40)).evalf(70) - function(S.Zero).evalf(70)
    assert abs(rise * 10**40 - SLOPE_AT_ZERO[function].evalf(40)) < Float("1e-25")


def test_evaluation_of_an_unknown_is_left_alone():
    assert phi1(x).evalf() == phi1(x)


@pytest.mark.parametrize("function", ONE_ARGUMENT, ids=lambda f: f.__name__)
def test_latex_prints_the_name(function):
    assert latex(function(x)) == rf"{function.latex_name}\left(x\right)"
    assert latex(function(x) ** 2) == rf"{function.latex_name}^{{2}}\left(x\right)"


@pytest.mark.parametrize(("function", "sign"), [(w0_offset, 1), (wm1_offset, -1)])
def test_offsets_begin_like_a_square_root(function, sign):
    """W = -1 + p - p**2/3 + ... with p = sqrt(2 x) or its opposite, and no digit lost for tiny x."""
    p = Float("1e-20", 70)
    rest = function(p**2 / 2).evalf(70) - (sign * p - p**2 / 3 + sign * p**3 / 36)
    assert abs(rest) < Float("1e-79")


def test_branch_factor_at_the_zero_of_w():
    assert abs(branch_factor(sqrt(2)).evalf(40) - 1) < Float("1e-39")
    assert abs(branch_factor(2).evalf(40) - exp(-LambertW(exp(-1))).evalf(40)) < Float("1e-38")


def test_driving():
    theta, mu = Symbol("theta", real=True), Symbol("mu", positive=True)
    n = driving(theta, mu)
    assert driving(0, mu) == 1
    assert driving(theta, 0) == cos(theta)
    assert n.rewrite(cos).subs(theta, -1) == cos(1) - mu * sin(1)
    assert n.diff(theta).subs(theta, -1).doit() == sin(1) + mu * cos(1)
    assert n.diff(mu).subs(theta, -1) == -sin(1)
    assert abs(driving(Rational(1, 2), 2).evalf(40) - (cos(Rational(1, 2)) - 2 * sin(Rational(1, 2))).evalf(40)) < 1e-39
    assert "driving" in latex(n)


def test_a_wrong_argument_index_is_refused():
    with pytest.raises(Exception, match="Invalid operation"):
        phi1(x).fdiff(2)


def test_exponential_functions_match_their_series():
    z = Symbol("z")
    for function, first in ((phi1, 1), (phi2, Rational(1, 2))):
        closed = series(function(z).rewrite(exp), z, 0, 2).removeO()
        assert closed.subs(z, 0) == first
