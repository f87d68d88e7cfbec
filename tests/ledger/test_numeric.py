"""Statements tried in numbers: certain where floating point would be fooled."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from small_ledger import f, h, p, q, r
from sympy import Eq, Ge, Gt, Interval, LambertW, Le, Limit, Lt, Ne, Rational, cos, exp, oo, sin, sqrt

from galileo_sym.ledger import (
    Continuous,
    ExactlyOneRoot,
    Independent,
    StrictlyDecreasing,
    StrictlyIncreasing,
    TracesOnce,
    UniqueMaximum,
)
from galileo_sym.ledger.numeric import Untestable, holds

TINY = sp.Integer(10) ** -200
LARGE = sp.Integer(10) ** 120


def _raw(kind, *sides):
    return kind(*sides, evaluate=False)


SMALL = sp.Integer(10) ** -9  # the smallest distance at which the ledger tries
CONJUGATE = 1 / (sqrt(p**2 + 1) + p)
CANCELLING = {
    "series of exp": (exp(q) - 1 - q, q**2 / 2 + q**3 / 6, {q: SMALL}, False),
    "1 - cos": (1 - cos(q), 2 * sin(q / 2) ** 2, {q: TINY}, True),
    "1 - cos, first order": (1 - cos(q), q**2 / 2, {q: SMALL}, False),
    "difference of squares": ((p + 1) ** 2 - p**2 - 2 * p, q, {p: LARGE, q: 1}, True),
    "difference of squares, off by one": ((p + 1) ** 2 - p**2 - 2 * p, q, {p: 10**12, q: 2}, False),
    "240 digits lost inside a product": (q * (sqrt(p**2 + 1) - p), q * CONJUGATE, {p: LARGE, q: 3}, True),
    "240 digits lost inside, factor wrong": (q * (sqrt(p**2 + 1) - p), q * CONJUGATE / 2, {p: LARGE, q: 3}, False),
    "400 digits lost inside a product": (
        p * (exp(q) - 1 - q) / q**2,
        p * (exp(q) - 1 - q) / q / q,
        {p: 1, q: TINY},
        True,
    ),
    "400 digits lost inside, third for half": (2 * ((exp(q) - 1 - q) / q**2), 2 * sp.S.One / 3, {q: TINY}, False),
    "a difference in digit 45": (1 + q, sp.S.One, {q: sp.Integer(10) ** -45}, False),
}


@pytest.mark.parametrize(("left", "right", "point", "true"), CANCELLING.values(), ids=CANCELLING)
def test_equations_that_cancel(left, right, point, true):
    assert holds(_raw(Eq, left, right), point) is true
    assert holds(_raw(Eq, right, left), point) is true
    assert holds(_raw(Ne, left, right), point) is not true


ZERO = (p + 1) ** 2 - p**2 - 2 * p - 1


@pytest.mark.parametrize("at", [Rational(1, 3), sp.pi, LARGE, TINY])
@pytest.mark.parametrize(("kind", "true"), [(Gt, False), (Ge, True), (Lt, False), (Le, True), (Eq, True), (Ne, False)])
def test_strict_inequalities_fail_at_equality(kind, true, at):
    assert holds(_raw(kind, ZERO, sp.S.Zero), {p: at}) is true


@pytest.mark.parametrize("gap", [TINY, -TINY, LARGE, -LARGE])
def test_the_smallest_gap_decides_an_inequality(gap):
    assert holds(_raw(Gt, (p + q) ** 2 - p**2 - 2 * p * q, q**2 - gap), {p: 1, q: Rational(1, 3)}) is bool(gap > 0)
    assert holds(_raw(Lt, (p + q) ** 2 - p**2 - 2 * p * q, q**2 - gap), {p: 1, q: Rational(1, 3)}) is bool(gap < 0)


def test_series_inequalities_near_zero():
    tiny = {q: sp.Integer(10) ** -60}
    assert holds(_raw(Gt, exp(q), 1 + q + q**2 / 2), tiny)
    assert not holds(_raw(Gt, exp(q), 1 + q + q**2 / 2 + q**3 / 5), tiny)


@pytest.mark.parametrize(
    ("expr", "at", "side", "value", "true"),
    [
        (sp.Abs(q) / q, 0, "+", 1, True),
        (sp.Abs(q) / q, 0, "-", -1, True),
        (sp.Abs(q) / q, 0, "-", 1, False),
        ((exp(q) - 1 - q) / q**2, 0, "+", Rational(1, 2), True),
        ((exp(q) - 1 - q) / q**2, 0, "+", Rational(1, 3), False),
        (sin(q) / q, 0, "+", 1, True),
        (1 / q, oo, "-", 0, True),
        (q / (1 + q), oo, "-", 1, True),
        (q / (1 + q), oo, "-", 2, False),
        (1 / q, 0, "+", oo, True),
        (1 / q, 0, "-", oo, False),
        (1 / q, 0, "-", -oo, True),
        (sp.Abs(q), 0, "+", oo, False),
    ],
)
def test_limits_have_a_side(expr, at, side, value, true):
    assert holds(_raw(Eq, Limit(expr, q, at, side), sp.sympify(value)), {}) is true


W0, W1 = LambertW(q), LambertW(q, -1)


@pytest.mark.parametrize("at", [-Rational(1, 3), -Rational(1, 10**30), -exp(-1 - Rational(1, 10**30))])
def test_the_two_branches_of_w_are_told_apart(at):
    point = {q: at}
    assert holds(_raw(Eq, W0 * exp(W0), q), point)
    assert holds(_raw(Eq, W1 * exp(W1), q), point)
    assert holds(_raw(Gt, W0, sp.Integer(-1)), point)
    assert holds(_raw(Lt, W1, sp.Integer(-1)), point)
    assert not holds(_raw(Eq, W0, W1), point)
    assert holds(_raw(Lt, W1, W0), point)


def test_what_is_not_real_satisfies_no_inequality():
    assert not holds(_raw(Ge, W0, sp.Integer(-100)), {q: -1})
    assert not holds(_raw(Le, sqrt(q), sp.Integer(100)), {q: -1})
    assert not holds(_raw(Gt, sp.log(q), sp.Integer(-100)), {q: -1})


def test_a_division_by_zero_satisfies_no_equation():
    assert not holds(_raw(Eq, 1 / q, r), {q: 0, r: 5})


@pytest.mark.parametrize("statement", [_raw(Eq, q, r), _raw(Gt, q, r), _raw(Eq, f(h), q)])
def test_a_missing_value_is_said(statement):
    with pytest.raises(Untestable, match="no value"):
        holds(statement, {q: 1})


def test_a_number_is_not_a_statement():
    with pytest.raises(Untestable, match="not a statement"):
        holds(q + 1, {q: 1})


YES, NO = _raw(Gt, q, sp.S.Zero), _raw(Lt, q, sp.S.Zero)


@pytest.mark.parametrize(
    ("statement", "true"),
    [
        (sp.And(YES, YES), True),
        (sp.And(YES, NO, evaluate=False), False),
        (sp.Or(NO, YES, evaluate=False), True),
        (sp.Or(NO, NO, evaluate=False), False),
        (sp.Not(NO, evaluate=False), True),
        (sp.Implies(NO, NO, evaluate=False), True),
        (sp.Implies(YES, NO, evaluate=False), False),
        (sp.Equivalent(YES, NO, evaluate=False), False),
        (sp.Equivalent(NO, Eq(q, 7), evaluate=False), True),
        (Eq(sp.Tuple(q, 2 * q), sp.Tuple(1, 2), evaluate=False), True),
        (Eq(sp.Tuple(q, 2 * q), sp.Tuple(1, 3), evaluate=False), False),
    ],
)
def test_logic(statement, true):
    assert holds(statement, {q: sp.S.One}) is true


HALF_LINE, UNIT = Interval(0, oo), Interval(0, 1)
CIRCLE = Eq(q**2 + r**2, 1)
CLAIMS = {
    "rises": (StrictlyIncreasing(p * q, q, UNIT), True),
    "rises, denied": (StrictlyIncreasing(-p * q, q, UNIT), False),
    "constant is not rising": (StrictlyIncreasing(p + 0 * q, q, UNIT), False),
    "rises, then falls": (StrictlyIncreasing(q * (1 - q), q, UNIT), False),
    "falls on the half line": (StrictlyDecreasing(exp(-q / 10**9), q, HALF_LINE), True),
    "falls only at first": (StrictlyDecreasing(q**2 - q, q, HALF_LINE), False),
    "one root": (ExactlyOneRoot(q**2 - p, q, HALF_LINE), True),
    "two roots": (ExactlyOneRoot((q - p / 9) * (q - p / 2), q, UNIT), False),
    "no root": (ExactlyOneRoot(q + p, q, HALF_LINE), False),
    "a root at a closed end": (ExactlyOneRoot(q, q, UNIT), True),
    "a root at an open end": (ExactlyOneRoot(q, q, Interval.open(0, 1)), False),
    "a maximum": (UniqueMaximum(q * (1 - q), q, UNIT, Rational(1, 2)), True),
    "a maximum elsewhere": (UniqueMaximum(q * (1 - q), q, UNIT, Rational(1, 3)), False),
    "a minimum": (UniqueMaximum(q * (q - 1), q, UNIT, Rational(1, 2)), False),
    "a maximum that is not the only one": (UniqueMaximum(p + 0 * q, q, UNIT, Rational(1, 2)), False),
    "two roots between points": (ExactlyOneRoot((q - p / 3) * (q - p / 3 - p / 300), q, UNIT), False),
    "three roots, two of them close": (
        ExactlyOneRoot((q - p / 9) * ((q - 4 * p / 7) ** 2 - p / 10**6), q, UNIT),
        False,
    ),
    "one root, and a dip that is none": (
        ExactlyOneRoot((q - p / 9) * ((q - 4 * p / 7) ** 2 + p / 10**6), q, UNIT),
        True,
    ),
    "continuous with corners": (Continuous(sp.Abs(q - Rational(1, 3)) + q * sp.sign(q), q, Interval(-1, 1)), True),
    "a jump at 1/3": (Continuous(sp.sign(q - Rational(1, 3)), q, UNIT), False),
    "a jump where e^q is 2": (Continuous(sp.Heaviside(exp(q) - 2), q, UNIT), False),
    "steps": (Continuous(sp.floor(7 * q + Rational(1, 2)), q, UNIT), False),
    "a pole at 1/3": (Continuous(1 / (q - Rational(1, 3)), q, UNIT), False),
    "a pole at an open end": (Continuous(1 / q, q, Interval.open(0, 1)), True),
    "an arctangent that jumps": (Continuous(sp.atan(1 / (2 * q**2 - 1)), q, UNIT), False),
    "independent": (Independent((p + q) ** 2 - q**2 - 2 * p * q, q), True),
    "dependent": (Independent(p + q / 10**30, q), False),
}


@pytest.mark.parametrize(("claim", "true"), CLAIMS.values(), ids=CLAIMS)
def test_claims(claim, true):
    assert holds(claim, {p: sp.S.One}) is true


def _trace(**other):
    parts = {
        "point": sp.Tuple(sin(p), cos(p)),
        "interval": Interval(0, sp.pi),
        "curve": CIRCLE,
        "region": Ge(q, 0),
        "inverse": sp.acos(r),
    } | other
    return TracesOnce(
        parts["point"], p, parts["interval"], parts["curve"], parts["region"], sp.Tuple(q, r), parts["inverse"]
    )


@pytest.mark.parametrize(
    ("claim", "true"),
    [
        (_trace(), True),
        (_trace(curve=Eq(q**2 + r**2, 2)), False),
        (_trace(region=Le(q, 0)), False),
        (_trace(interval=Interval(0, 2 * sp.pi)), False),
        (_trace(inverse=sp.asin(q)), False),
        (_trace(point=sp.Tuple(sin(2 * p), cos(2 * p))), False),
    ],
)
def test_tracing(claim, true):
    assert holds(claim, {}) is true


@settings(max_examples=60, deadline=None)
@given(roots=st.lists(st.fractions(-4, 4, max_denominator=9), min_size=2, max_size=4), at=st.fractions(-4, 4))
def test_the_sign_of_a_product_is_that_of_its_roots(roots, at):
    """The expanded polynomial is compared with the exact sign from the factors."""
    product = sp.prod([q - Rational(x) for x in roots])
    exact = sp.sign(product.subs(q, Rational(at)))
    expanded = sp.expand(product)
    point = {q: Rational(at)}
    assert holds(_raw(Gt, expanded, sp.S.Zero), point) is bool(exact == 1)
    assert holds(_raw(Lt, expanded, sp.S.Zero), point) is bool(exact == -1)
    assert holds(_raw(Eq, expanded, sp.S.Zero), point) is bool(exact == 0)


def test_what_has_no_value_at_a_point_is_in_no_order_there():
    unless = sp.Or(_raw(Eq, q, 1), _raw(Lt, 1 / (q - 1), 5))
    assert holds(unless, {q: 1})
    assert not holds(_raw(Lt, 1 / (q - 1), 5), {q: 1})
    assert not holds(_raw(Ge, 1 / (q - 1), 5), {q: 1})
