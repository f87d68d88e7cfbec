"""Series about a minimum, limits put together from known ones, compositions, and waves; each with what it refuses."""

import pytest
import sympy as sp
from sympy import Eq, Gt, Interval, Rational, cos, exp, oo, pi, sin

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.tactics import (
    as_wave,
    compose_monotone,
    limit_by_parameter,
    limit_of_inverse,
    limit_with_part,
    revert_minimum,
    taylor,
    undo_arctangent,
)

h, p, x, y, q, w = sp.symbols("h p x y q w", real=True)
mu = sp.Symbol("mu", positive=True)
W = sp.Function("W")


def test_taylor_about_a_point():
    assert sp.expand(taylor(sp.log(x), x, 1, 3) - ((x - 1) - (x - 1) ** 2 / 2 + (x - 1) ** 3 / 3)) == 0
    with pytest.raises(DerivationError, match="derivative 1"):
        taylor(sp.sqrt(x), x, 0, 1)


def test_reversion_has_the_known_series_of_lambert_w_on_both_sides():
    """W = -1 + p - p^2/3 + 11 p^3/72 - 43 p^4/540, and the same with -p (Corless et al. 1996)."""
    to_fifth = sum(sp.diff(w * exp(w + 1), w, k).subs(w, -1) / sp.factorial(k) * h**k for k in range(6))
    known = [1, -Rational(1, 3), Rational(11, 72), -Rational(43, 540)]
    upper, lower = revert_minimum(to_fifth, h, p)
    for series, sign in ((upper, 1), (lower, -1)):
        assert sp.expand(series - sum(a * (sign * p) ** (k + 1) for k, a in enumerate(known))) == 0


@pytest.mark.parametrize("shape", [h + h**2 + h**3, -(h**2) + h**3, 3 + h**2])
def test_no_reversion_without_a_minimum_or_beyond_what_is_known(shape):
    with pytest.raises(DerivationError, match="minimum"):
        revert_minimum(shape, h, p)


def test_an_approach_with_a_vanishing_slope_is_decided_by_the_next_derivative():
    assert limit_by_parameter(h, q, 0, "+", h, h**2, 0) == 0
    with pytest.raises(DerivationError, match="side"):
        limit_by_parameter(h, q, 0, "-", h, h**2, 0)
    assert limit_by_parameter(h, q, 0, "-", h, h**3, 0, "-") == 0


def test_limit_with_a_part_whose_limit_is_known():
    part = sp.Symbol("part", real=True)
    assert limit_with_part(sin(x) / x * part**2 + x * part, part, sp.Integer(3), x, 0) == 9
    with pytest.raises(DerivationError, match="without bound"):
        limit_with_part(part / x, part, sp.S.Zero, x, 0)
    with pytest.raises(DerivationError, match="polynomial"):
        limit_with_part(exp(part) * x, part, sp.S.One, x, 0)


RISES = StrictlyIncreasing(w * exp(w), w, Interval(-1, oo))
ROUND_TRIP = Eq(W(q) * exp(W(q)), q)
VALUES = sp.Ge(W(q), -1, evaluate=False)
ABOVE = Gt(mu, -exp(-1), evaluate=False)


def test_the_inverse_of_a_rising_function_is_continuous():
    assert limit_of_inverse(RISES, ROUND_TRIP, VALUES, ABOVE) == W(mu)


@pytest.mark.parametrize(
    ("claim", "round_trip", "values", "above"),
    [
        (StrictlyDecreasing(*RISES.args), ROUND_TRIP, VALUES, ABOVE),
        (StrictlyIncreasing(w * exp(w), w, Interval(0, oo)), ROUND_TRIP, VALUES, ABOVE),
        (RISES, Eq(2 * W(q) * exp(W(q)), q), VALUES, ABOVE),
        (RISES, ROUND_TRIP, sp.Le(W(q), -1, evaluate=False), ABOVE),
        (RISES, ROUND_TRIP, VALUES, sp.Ge(mu, -exp(-1), evaluate=False)),
        (RISES, ROUND_TRIP, VALUES, Gt(mu, -1, evaluate=False)),
    ],
)
def test_no_limit_of_what_is_not_shown_to_be_the_inverse_there(claim, round_trip, values, above):
    with pytest.raises(DerivationError):
        limit_of_inverse(claim, round_trip, values, above)


def test_compositions_of_monotone_functions():
    falls = StrictlyDecreasing(1 / y, y, Interval.open(0, oo))
    inner = StrictlyDecreasing(1 - x, x, Interval.Ropen(0, 1))
    assert compose_monotone(falls, inner) == StrictlyIncreasing(1 / (1 - x), x, Interval.Ropen(0, 1))
    with pytest.raises(DerivationError, match="nothing"):
        compose_monotone(falls, StrictlyDecreasing(1 - x, x, Interval(0, 1)))
    with pytest.raises(DerivationError, match="nothing"):
        compose_monotone(falls, StrictlyDecreasing(1 - x, x, Interval.Ropen(0, 2)))


@pytest.mark.parametrize(
    ("turn", "expr"), [(sin, 3 + 4 * sin(2 * x) - 3 * cos(2 * x)), (cos, 1 - sin(2 * x) + cos(2 * x))]
)
def test_a_sine_and_a_cosine_make_one_wave(turn, expr):
    wave = as_wave(expr, 2 * x, turn)
    for place in (Rational(1, 3), Rational(-7, 5), Rational(31, 7)):
        whole = wave.level + wave.amplitude * wave.turn(2 * x + wave.offset)
        assert abs(sp.N((whole - expr).subs(x, place), 40)) < 1e-35


@pytest.mark.parametrize("expr", [cos(2 * x) - sin(2 * x), sin(2 * x) ** 2 + sin(2 * x), sin(x) + sin(2 * x)])
def test_no_wave_of_unknown_direction_or_of_another_angle(expr):
    with pytest.raises(DerivationError):
        as_wave(expr, 2 * x, sin)


def test_arctangents_of_acute_angles_are_undone():
    acute = Interval.open(0, pi / 2)
    assert undo_arctangent(sp.atan(1 / sp.tan(x)), x, acute) == pi / 2 - x
    assert undo_arctangent(2 * sp.atan(sp.tan(x)), x, acute) == 2 * x
    for arc, within in ((sp.atan(2 * sp.tan(x)), acute), (sp.atan(sp.tan(x)), Interval.open(0, pi))):
        with pytest.raises(DerivationError):
            undo_arctangent(arc, x, within)
