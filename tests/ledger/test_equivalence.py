"""What is the same is shown so; what is not never is, however near it comes."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from small_ledger import p, q, r
from sympy import And, Eq, Ge, Gt, Interval, LambertW, Le, Limit, Lt, Ne, Or, Rational, cos, exp, sin, sqrt, tan

from galileo_sym.ledger import ExactlyOneRoot, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.ledger.equivalence import equivalent

a = sp.Symbol("a", positive=True)
n = sp.Symbol("n", nonzero=True, real=True)
W0, W1 = LambertW(q), LambertW(q, -1)


def _eq(left, right):
    return Eq(left, right, evaluate=False)


SAME = {
    "sides swapped": (_eq(p, q), _eq(q, p)),
    "all on one side": (_eq(p, q + r), _eq(p - q - r, sp.S.Zero)),
    "negated": (_eq(p, q), _eq(-q, -p)),
    "times a positive": (_eq(p, q), _eq(a * p, a * q)),
    "times a nonzero": (_eq(p, q), _eq(n * p, n * q)),
    "expanded": (_eq((q + r) ** 2, p), _eq(q**2 + 2 * q * r + r**2, p)),
    "common denominator": (_eq(q, 1 / p + 1 / a), _eq(q, (a + p) / (a * p))),
    "roots": (_eq(p, sqrt(2 * a / (1 + a))), _eq(p, sqrt(2) * sqrt(a) / sqrt(1 + a))),
    "root of a product": (_eq(p, sqrt(a**3 * (1 + a))), _eq(p, a * sqrt(a + a**2))),
    "double angle": (_eq(q, 2 * sin(r) * cos(r)), _eq(q, sin(2 * r))),
    "squares of sine and cosine": (_eq(q, (sin(r) + cos(r)) ** 2 - 1), _eq(q, 2 * sin(r) * cos(r))),
    "tangent": (_eq(q, cos(r) * (1 - p * tan(r))), _eq(q, cos(r) - p * sin(r))),
    "powers of e": (_eq(q, exp(r) * exp(2 * p)), _eq(q, exp(r + 2 * p))),
    "hyperbolic": (_eq(q, sp.sinh(r)), _eq(q, (exp(r) - exp(-r)) / 2)),
    "W e^W": (_eq(r, W0 * exp(W0)), _eq(r, q)),
    "q/W is e^W": (_eq(r, q / W0), _eq(r, exp(W0))),
    "q/W of the other branch": (_eq(r, q / W1), _eq(r, exp(W1))),
    "slope of W": (_eq(r, W0 / (q * (1 + W0))), _eq(r, exp(-W0) / (1 + W0))),
    "argument of W": (_eq(r, LambertW(-exp(-1 - p))), _eq(r, LambertW(-exp(-1) / exp(p)))),
    "inequality turned": (Gt(q, r, evaluate=False), Lt(r, q, evaluate=False)),
    "inequality scaled": (Gt(q, r, evaluate=False), Gt(a * q, a * r, evaluate=False)),
    "inequality to one side": (Le(q, r, evaluate=False), Ge(r - q, 0, evaluate=False)),
    "unequal": (Ne(q, r, evaluate=False), Ne(2 * q, 2 * r, evaluate=False)),
    "parts in another order": (And(_eq(q, p), Gt(r, 0)), And(Lt(0, r), _eq(p, q))),
    "a monotone function": (
        StrictlyIncreasing((q + 1) ** 2, q, Interval(0, p)),
        StrictlyIncreasing(q**2 + 2 * q + 1, q, Interval(0, p)),
    ),
    "limits": (_eq(Limit((q + 1) ** 2, q, 0, "+"), 1), _eq(Limit(q**2 + 2 * q + 1, q, 0, "+"), 1)),
    "tuples": (_eq(sp.Tuple(q, (r + 1) ** 2), sp.Tuple(p, a)), _eq(sp.Tuple(q, r**2 + 2 * r + 1), sp.Tuple(p, a))),
}


@pytest.mark.parametrize(("one", "other"), SAME.values(), ids=SAME)
def test_the_same_is_shown(one, other):
    assert equivalent(one, other)
    assert equivalent(other, one)


NEAR_MISSES = {
    "sign": (_eq(q, r), _eq(q, -r)),
    "factor": (_eq(q, r), _eq(q, 2 * r)),
    "exponent": (_eq(q, r**2), _eq(q, r**3)),
    "a tiny term": (_eq(q, r), _eq(q, r + Rational(1, 10**40))),
    "a square loses the sign": (_eq(q, r), _eq(q**2, r**2)),
    "a factor that may vanish": (_eq(q, p), _eq(q * r, p * r)),
    "a root that may be negative": (_eq(q, sqrt(r**2)), _eq(q, r)),
    "a denominator that may vanish": (_eq(q, p), _eq(q / r, p / r)),
    "factor 0": (_eq(q, r), _eq(sp.S.Zero, 0 * q)),
    "sine for cosine": (_eq(q, sin(r)), _eq(q, cos(r))),
    "double angle without the 2": (_eq(q, sin(r) * cos(r)), _eq(q, sin(2 * r))),
    "other branch": (_eq(r, W0), _eq(r, W1)),
    "other branch in e^W": (_eq(r, q / W0), _eq(r, exp(W1))),
    "W without its e": (_eq(r, LambertW(-exp(-1 - p))), _eq(r, LambertW(-exp(-p)))),
    "W(q e^q) is not always q": (_eq(r, LambertW(q * exp(q))), _eq(r, q)),
    "strict or not": (Gt(q, r, evaluate=False), Ge(q, r, evaluate=False)),
    "inequality turned": (Gt(q, r, evaluate=False), Gt(r, q, evaluate=False)),
    "inequality negated on both sides": (Gt(q, r, evaluate=False), Gt(-q, -r, evaluate=False)),
    "inequality times a sign": (Gt(q, r, evaluate=False), Gt(n * q, n * r, evaluate=False)),
    "and for or": (And(_eq(q, p), Gt(r, 0)), Or(_eq(q, p), Gt(r, 0))),
    "a part less": (And(_eq(q, p), Gt(r, 0)), And(_eq(q, p), Gt(r, 0), Lt(r, p))),
    "one part twice": (And(Gt(q, 0), Gt(r, 0)), And(Gt(q, 0), Gt(2 * q, 0, evaluate=False))),
    "rising for falling": (StrictlyIncreasing(q, q, Interval(0, p)), StrictlyDecreasing(q, q, Interval(0, p))),
    "another interval": (StrictlyIncreasing(q, q, Interval(0, p)), StrictlyIncreasing(q, q, Interval(0, 2 * p))),
    "an open end": (StrictlyIncreasing(q, q, Interval(0, p)), StrictlyIncreasing(q, q, Interval.Ropen(0, p))),
    "another root": (ExactlyOneRoot(q - p, q, Interval(0, 9)), ExactlyOneRoot(q - 2 * p, q, Interval(0, 9))),
    "the side of a limit": (_eq(Limit(1 / q, q, 0, "+"), r), _eq(Limit(1 / q, q, 0, "-"), r)),
    "the point of a limit": (_eq(Limit(q, q, 0, "+"), r), _eq(Limit(q, q, 1, "+"), r)),
    "tuple swapped": (_eq(sp.Tuple(q, r), sp.Tuple(p, a)), _eq(sp.Tuple(q, r), sp.Tuple(a, p))),
    "premise and conclusion": (sp.Implies(Gt(q, 0), Gt(r, 0)), sp.Implies(Gt(r, 0), Gt(q, 0))),
    "equation and inequality": (_eq(q, r), Ne(q, r, evaluate=False)),
    "true": (_eq(q, r), sp.true),
}


@pytest.mark.parametrize(("one", "other"), NEAR_MISSES.values(), ids=NEAR_MISSES)
def test_a_near_miss_is_not_shown(one, other):
    assert equivalent(one, other) is None
    assert equivalent(other, one) is None


COEFFICIENTS = st.lists(st.integers(-6, 6), min_size=3, max_size=4)


def _polynomial(coefficients, x):
    return sum(c * x**i for i, c in enumerate(coefficients))


@settings(max_examples=60, deadline=None)
@given(COEFFICIENTS, st.integers(-5, 5), st.sampled_from([-3, -1, Rational(1, 7), 2]))
def test_a_polynomial_is_the_same_about_any_point(coefficients, shift, factor):
    about = sp.Poly(_polynomial(coefficients, r + shift), r).as_expr().xreplace({r: r - shift})
    plain, other = _eq(q, _polynomial(coefficients, r)), _eq(factor * q, factor * about)
    assert equivalent(plain, other)


@settings(max_examples=60, deadline=None)
@given(COEFFICIENTS, COEFFICIENTS)
def test_polynomials_are_the_same_only_if_their_coefficients_are(one, other):
    length = max(len(one), len(other))
    padded = [c + [0] * (length - len(c)) for c in (one, other)]
    shown = equivalent(_eq(q, _polynomial(one, r)), _eq(q, sp.expand(_polynomial(other, r))))
    assert bool(shown) is (padded[0] == padded[1])


@settings(max_examples=10, deadline=None)
@given(st.integers(1, 4), st.integers(1, 4), st.sampled_from([(1, 1), (1, -1), (-1, 1), (-1, -1)]))
def test_addition_theorems_need_the_right_signs(i, j, signs):
    outer, inner = signs
    added = sin(i * r) * cos(j * p) + outer * cos(i * r) * sin(j * p)
    shown = equivalent(_eq(q, added), _eq(q, sin(i * r + inner * j * p)))
    assert bool(shown) is (outer == inner)
