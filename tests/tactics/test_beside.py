"""Tactics of Theorem 1: series of symbolic order, signs beside a point, theorems applied; and the claims they make."""

import pytest
import sympy as sp
from sympy import Eq, Interval, Mod, Ne, Subs, Sum, exp, oo

from galileo_sym.ledger import Continuous, DerivationError, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.ledger.local import AllZero, LocalExtremum, MonotoneBeside
from galileo_sym.ledger.numeric import holds
from galileo_sym.tactics import (
    even_at_extremum,
    extremum_between,
    monotone_beside,
    negative_root,
    said_of,
    split_series,
    take_out,
    value_at_centre,
    value_near,
)

x, x_0, q = sp.symbols("x x_0 q", real=True)
h, p = sp.symbols("h p", positive=True)
N = sp.Symbol("N", integer=True, positive=True)
i = sp.Symbol("i", integer=True, nonnegative=True)
a, f, F, g, y = (sp.Function(name, real=True) for name in ("a", "f", "F", "g", "y"))
X = x - x_0
SERIES = Sum(a(i) * X**i, (i, 0, oo))
TAIL = Sum(a(i) * X ** (i - N), (i, N, oo))
AT_CENTRE = Eq(Subs(F(x), x, x_0), a(N))
NEAR = value_near(Eq(F(x), TAIL), AT_CENTRE, Ne(a(N), 0))


@pytest.mark.parametrize(
    ("claim", "truth"),
    [
        (LocalExtremum(x**4 * exp(x), x, 0), True),
        (LocalExtremum(x**3 + x**4, x, 0), False),
        (LocalExtremum(x**2 + x * sp.Rational(1, 10**6), x, 0), False),
        (MonotoneBeside(x**2 - x**3, x, 0, 1, 1), True),
        (MonotoneBeside(x**2 - x**3, x, 0, -1, 1), False),
        (MonotoneBeside(x**3, x, 0, -1, 1), True),
        (AllZero(i * (i - 1) * (i - 2), i, 1, 2), True),
        (AllZero(i * (i - 1) * (i - 2), i, 1, 3), False),
        (AllZero(i, i, 1, 0), True),
    ],
)
def test_claims_near_a_point_are_tried(claim, truth):
    assert holds(claim, {}) is truth


def test_series_of_symbolic_order():
    constant, tail = split_series(SERIES, AllZero(a(i), i, 1, N - 1))
    assert constant == a(0)
    assert take_out(tail, X**N) == TAIL
    assert value_at_centre(TAIL, x, x_0) == a(N)


@pytest.mark.parametrize("gap", [AllZero(a(i), i, 2, N), AllZero(a(2 * i), i, 1, N)])
def test_other_terms_are_not_left_out(gap):
    with pytest.raises(DerivationError):
        split_series(SERIES, gap)


@pytest.mark.parametrize("power", [X ** (N + 1), X ** (N - 1)])
def test_no_other_power_is_taken_out(power):
    with pytest.raises(DerivationError):
        take_out(Sum(a(i) * X**i, (i, N, oo)), power)


def test_a_laurent_series_has_no_value_at_its_centre():
    with pytest.raises(DerivationError):
        value_at_centre(Sum(a(i) * X ** (i - N), (i, N - 1, oo)), x, x_0)


@pytest.mark.parametrize(
    ("value", "nonzero"),
    [(2 * a(N), Ne(2 * a(N), 0)), (a(N), Ne(a(N + 1), 0)), (a(N), Eq(a(N), 0)), (a(N + 1), Ne(a(N + 1), 0))],
)
def test_the_sign_near_a_point_needs_its_value_there(value, nonzero):
    with pytest.raises(DerivationError):
        value_near(Eq(F(x), TAIL), Eq(Subs(F(x), x, x_0), value), nonzero)


def test_odd_order_changes_the_sign():
    odd, product = even_at_extremum(X**N * F(x), x, N, NEAR, h).args
    assert odd == Eq(Mod(N, 2), 1)
    assert product.subs(N, 3).subs({F(x_0 + h): 5, F(x_0 - h): 2}) == (-10 * h**6 < 0)
    with pytest.raises(DerivationError):
        even_at_extremum(X ** (2 * N) * F(x), x, N, NEAR, h)
    with pytest.raises(DerivationError):
        even_at_extremum(1 + X**N * F(x), x, N, NEAR, h)
    for far in (F(2 * x), F(x + 1), F(x) * F(0)):
        with pytest.raises(DerivationError, match="not known near"):
            even_at_extremum(X**N * far, x, N, NEAR, h)


def test_monotone_on_both_sides():
    right, left = monotone_beside(Eq(f(x), a(0) + X**N * F(x)), x, N, NEAR)
    assert right == MonotoneBeside(f(x), x, x_0, 1, a(N))
    assert left == MonotoneBeside(f(x), x, x_0, -1, (-1) ** (N - 1) * a(N))
    for wrong in (X ** (N - 2) * F(x), X ** (N + 1) * F(x), x + X**N * F(x), X**N * (F(x) - a(N)), -(X**N) * F(x)):
        with pytest.raises(DerivationError):
            monotone_beside(Eq(f(x), a(0) + wrong), x, N, NEAR)


def test_the_root_of_an_even_power():
    even = Eq(Mod(N, 2), 0)
    turn = (y(x) - x_0) / X
    power, below = Eq((y(x) - x_0) ** N / X**N, p), sp.Le(turn, 0)
    assert negative_root(power, N, even, below) == Eq(turn, -(p ** (1 / N)))
    for equation, parity, sign in (
        (power, Eq(Mod(N, 2), 1), below),
        (power, ~even, below),
        (power, even, sp.Ge(turn, 0)),
        (power, even, sp.Le(turn, 1)),
        (Eq(2 * power.lhs, p), even, below),
    ):
        with pytest.raises(DerivationError):
            negative_root(equation, N, parity, sign)


def test_an_extremum_lies_between_opposite_ways():
    falling = StrictlyDecreasing(x**2, x, Interval(-oo, 0))
    rising = StrictlyIncreasing(x**2, x, Interval(0, oo))
    assert extremum_between(falling, rising) == LocalExtremum(x**2, x, 0)
    whole = Continuous(x**2, x, Interval(-oo, 0))
    away = StrictlyIncreasing(x**2, x, Interval.open(0, oo))
    for pair in ((rising, falling), (falling, falling), (falling, away), (whole, rising)):
        with pytest.raises(DerivationError):
            extremum_between(*pair)


def test_a_theorem_said_of_a_function():
    told = said_of(Eq(f(x) + y(x_0), a(N)), {f(x): x**2, y(x): g(x), a(i): i}, {x_0: sp.Integer(3), N: sp.Integer(2)})
    assert told == Eq(x**2 + g(3), 2)
