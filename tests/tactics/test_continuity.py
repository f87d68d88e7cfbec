"""Continuity, limits that follow from it, L'Hôpital's rule, entire series: what is shown, and what must not be."""

import pytest
import sympy as sp
from sympy import Eq, Ge, Gt, Interval, LambertW, Limit, Ne, Rational, Sum, asin, exp, factorial, oo, sin

from galileo_sym.ledger import Continuous, DerivationError, PowerSeries, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.ledger.numeric import holds
from galileo_sym.tactics import (
    affine_series,
    closed_at_end,
    continuous_inverse,
    continuous_on,
    divide_series,
    entire_series,
    filled_in,
    inner_monotone,
    limit_inside,
    limit_of_parts,
    limit_of_ratio,
    slope_at_gap,
    with_tail,
)

x, z, q = sp.symbols("x z q", real=True)
n = sp.Symbol("n", integer=True, nonnegative=True)
f = sp.Function("f", real=True)
WHOLE, BEYOND = Interval(-oo, oo), Interval(0, oo)
W = Continuous(LambertW(q), q, Interval(-exp(-1), oo))
RISES = StrictlyIncreasing(z * exp(z), z, Interval(-1, oo))
ROUND_TRIP = Eq(LambertW(q) * exp(LambertW(q)), q, evaluate=False)
VALUES = Ge(LambertW(q), -1)

TRUE = {
    "a jump filled": Continuous(sp.Piecewise((1, Eq(x, 0)), (sin(x) / x, True)), x, Interval(-1, 1)),
    "W up to its branch point": W,
    "e^x": PowerSeries(exp(x), x, 0, 1 / factorial(n), n),
    "about another place": PowerSeries(exp(x), x, 1, exp(1) / factorial(n), n),
}
FALSE = {
    "a jump": Continuous(sp.Piecewise((0, x < Rational(1, 3)), (1, True)), x, Interval(0, 1)),
    "a wrong value at one place": Continuous(sp.Piecewise((2, Eq(x, 0)), (sin(x) / x, True)), x, Interval(-1, 1)),
    "a wrong value at an end": Continuous(sp.Piecewise((1, Eq(x, 0)), (x, True)), x, BEYOND),
    "one coefficient wrong": PowerSeries(exp(x), x, 0, 1 / factorial(n) + sp.KroneckerDelta(n, 7), n),
    "a series of another function": PowerSeries(exp(x), x, 0, 1 / factorial(n + 1), n),
}


@pytest.mark.parametrize("claim", TRUE.values(), ids=TRUE)
def test_true_claims_hold(claim):
    assert holds(claim, {})


@pytest.mark.parametrize("claim", FALSE.values(), ids=FALSE)
def test_false_claims_fail(claim):
    assert not holds(claim, {})


def test_infinite_sums_in_numbers():
    assert holds(Eq(Sum(x**n / factorial(n), (n, 0, oo)), exp(x)), {x: sp.Integer(-20)})
    assert not holds(Eq(Sum(x**n / factorial(n), (n, 1, oo)), exp(x)), {x: sp.Integer(-20)})


def test_series_of_a_polynomial_times_an_exponential():
    for expr, place in ((x * exp(x), -1), (x**3 * exp(-x), 2)):
        coefficient = entire_series(expr, x, place, n).args[3]
        for i in range(6):
            wanted = sp.diff(expr, x, i).subs(x, place) / factorial(i)
            assert sp.simplify(coefficient.subs(n, i) - wanted) == 0
    series = entire_series((x**2 + 1) * exp(2 * x), x, 0, n)
    taylor = sp.series((x**2 + 1) * exp(2 * x), x, 0, 8).removeO()
    assert [series.args[3].subs(n, i) for i in range(8)] == [taylor.coeff(x, i) for i in range(8)]
    assert holds(series, {})
    scaled = affine_series(series, 3, -3)
    assert holds(scaled, {})
    assert holds(divide_series(scaled, 1), {})
    head = with_tail(series, 2, x)
    assert head.has(Sum)
    assert head.subs(x, 0).doit() == 1


@pytest.mark.parametrize("expr", [exp(x**2), exp(x) / x, sin(x), sp.Abs(x), exp(x) + exp(2 * x), x**3])
def test_no_general_series_of_others(expr):
    with pytest.raises(DerivationError):
        entire_series(expr, x, 0, n)


def test_no_division_where_a_pole_is():
    with pytest.raises(DerivationError):
        divide_series(entire_series(exp(x), x, 0, n), 1)


def test_the_inverse_of_a_rising_function():
    assert continuous_inverse(RISES, ROUND_TRIP, VALUES) == W


WRONG_INVERSES = {
    "falls": (StrictlyDecreasing(*RISES.args), ROUND_TRIP, VALUES),
    "on another half": (StrictlyIncreasing(z * exp(z), z, Interval(0, oo)), ROUND_TRIP, VALUES),
    "of another function": (RISES, Eq(LambertW(q) * exp(2 * LambertW(q)), q, evaluate=False), VALUES),
    "of another value": (RISES, Eq(ROUND_TRIP.lhs, 2 * q, evaluate=False), VALUES),
    "bounded": (
        StrictlyIncreasing(-exp(-z), z, Interval(-1, oo)),
        Eq(-exp(-f(q)), q, evaluate=False),
        Ge(f(q), -1),
    ),
}


@pytest.mark.parametrize("given", WRONG_INVERSES.values(), ids=WRONG_INVERSES)
def test_what_is_no_inverse(given):
    with pytest.raises(DerivationError):
        continuous_inverse(*given)


def test_compositions():
    expr = asin(x / (x**2 - 1))
    facts = [Ne(x**2 - 1, 0), Gt(x / (x**2 - 1), -1), sp.Lt(x / (x**2 - 1), 1)]
    for lacking in facts:
        with pytest.raises(DerivationError):
            continuous_on(expr, x, BEYOND, facts=[e for e in facts if e != lacking])
    assert continuous_on(expr, x, BEYOND, facts=facts).args[0] == expr
    assert continuous_on(LambertW(x**2), x, WHOLE, known=[W], facts=[Ge(x**2, -exp(-1))])
    with pytest.raises(DerivationError):
        continuous_on(LambertW(x), x, WHOLE, known=[W])
    with pytest.raises(DerivationError):
        continuous_on(sp.floor(x), x, WHOLE)


def test_limits_of_continuous_functions():
    limit = limit_inside(W, LambertW((x**2 - 1) * exp(-1)), x, 0)
    assert (limit.lhs.args[2], limit.rhs) == (0, -1)
    with pytest.raises(DerivationError):
        limit_inside(W, LambertW(x - 1), x, 0)
    assert limit_of_parts(1 / (1 + f(x)), {f(x): 2}) == Rational(1, 3)
    with pytest.raises(DerivationError):
        limit_of_parts(1 / (1 + f(x)), {f(x): -1})
    with pytest.raises(DerivationError):
        limit_of_parts(x * f(x), {f(x): 2})


SLOPES = (exp(x), sp.cos(x))


def ratio(ends=(0, 0), slopes=SLOPES, limits=(1, 1)):
    """(e^x - 1)/sin x at 0, from these hypotheses."""
    parts = exp(x) - 1, sin(x)
    at = [Eq(Limit(p, x, 0, "+"), e, evaluate=False) for p, e in zip(parts, ends, strict=True)]
    told = [Eq(Limit(p, x, 0, "+"), e, evaluate=False) for p, e in zip(slopes, limits, strict=True)]
    return limit_of_ratio(at, slopes, told)


def test_lhopital():
    assert ratio() == Eq(Limit((exp(x) - 1) / sin(x), x, 0, "+"), 1, evaluate=False)
    for wrong in ({"ends": (1, 0)}, {"ends": (0, 1)}, {"slopes": (exp(x), 1)}, {"limits": (1, 0)}, {"limits": (oo, 1)}):
        with pytest.raises(DerivationError):
            ratio(**wrong)


def test_single_places_are_filled_in_with_limits():
    pieces = Continuous(f(x), x, sp.Union(Interval.open(0, 1), Interval.open(1, oo), evaluate=False))
    limits = [Eq(Limit(f(x), x, 0, "+"), 5), Eq(Limit(f(x), x, 1, "+"), 7), Eq(Limit(f(x), x, 1, "-"), 7)]
    whole = filled_in(pieces, {sp.S.Zero: 5, sp.S.One: 7}, limits)
    assert whole.args[2] == BEYOND
    assert whole.args[0].subs(x, 1) == 7
    for lacking in limits:
        with pytest.raises(DerivationError):
            filled_in(pieces, {sp.S.Zero: 5, sp.S.One: 7}, [e for e in limits if e != lacking])
    with pytest.raises(DerivationError):
        filled_in(pieces, {sp.S.Zero: 5, sp.S.One: 8}, limits)


def test_monotony_of_an_inner_function_and_at_an_end():
    outer = StrictlyDecreasing(1 / z, z, Interval.open(0, oo))
    both = StrictlyIncreasing(1 / f(x), x, Interval.open(0, oo))
    inner = inner_monotone(both, outer, f(x), Interval.open(1, 2))
    assert inner == StrictlyDecreasing(f(x), x, Interval.open(0, oo))
    with pytest.raises(DerivationError):
        inner_monotone(both, outer, f(x), Interval(-1, 2))
    with pytest.raises(DerivationError):
        inner_monotone(sp.Not(both), outer, f(x), Interval.open(1, 2))
    assert closed_at_end(inner, Continuous(f(z), z, BEYOND)) == StrictlyDecreasing(f(z), z, BEYOND)
    with pytest.raises(DerivationError):
        closed_at_end(inner, Continuous(f(2 * z), z, BEYOND))
    with pytest.raises(DerivationError):
        closed_at_end(inner, sp.Not(Continuous(f(z), z, BEYOND)))


def test_a_slope_at_a_place_left_out():
    slope = Eq(sp.Derivative(f(x), x), exp(x), evaluate=False)
    function, formula = Continuous(f(z), z, BEYOND), Continuous(exp(x), x, WHOLE)
    assert slope_at_gap(slope, function, formula, sp.S.One) == slope
    for given in ((function, formula, sp.S.Zero), (function, Continuous(x, x, WHOLE), sp.S.One)):
        with pytest.raises(DerivationError):
            slope_at_gap(slope, *given)
