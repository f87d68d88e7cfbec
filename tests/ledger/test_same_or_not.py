"""Ways in which two statements are the same, or are not: systems, bounds, limits, cases, equivalences."""

import pytest
import sympy as sp
from small_ledger import SOME, entry, f, p, q, r
from sympy import And, Eq, Equivalent, Ge, Gt, LambertW, Le, Limit, Lt, Or, acos, cos, exp, oo, sin

from galileo_sym.ledger import POSITIVE, REAL, Domain, Kind
from galileo_sym.ledger.equivalence import equivalent, is_zero

pytestmark = pytest.mark.xdist_group("compare")

CIRCLES = And(Eq((q - p) ** 2 + r**2, p**2 + 1), Eq((q + p) ** 2 + r**2, p**2 + 1))
SAME_SYSTEM = {
    "a multiple subtracted": And(Eq((q - p) ** 2 + r**2, p**2 + 1), Eq(p * q, 0)),
    "solved": And(Eq(q, 0), Eq(r**2, 1)),
}
OTHER_SYSTEM = {
    "a root lost": And(Eq(q, 0), Eq(r, 1)),
    "a root gained": And(Eq(q, 0), Eq(r**3, r)),
    "one equation for two": And(Eq((q - p) ** 2 + r**2, p**2 + 1), Eq(2 * (q - p) ** 2 + 2 * r**2, 2 * p**2 + 2)),
    "not polynomial": And(Eq(sin(q), 0), Eq(r**2, 1)),
}


@pytest.mark.parametrize("other", SAME_SYSTEM.values(), ids=SAME_SYSTEM)
def test_systems_with_the_same_solutions_are_equivalent(other):
    assert equivalent(CIRCLES, other)


@pytest.mark.parametrize("other", OTHER_SYSTEM.values(), ids=OTHER_SYSTEM)
def test_systems_with_other_solutions_are_not(other):
    assert equivalent(CIRCLES, other) is None


def test_only_what_is_not_zero_is_divided_by():
    plain = And(Eq(q, 0), Eq(r, q))
    assert equivalent(And(Eq(p * q, 0), Eq(r, q)), plain)
    assert equivalent(And(Eq(r * q, 0), Eq(r, q + 1)), And(Eq(q, 0), Eq(r, q + 1))) is None


def test_tuples_are_compared_by_component():
    pair = Eq(sp.Tuple(q, r), sp.Tuple(p, 2 * p), evaluate=False)
    assert equivalent(pair, Eq(sp.Tuple(r, p), sp.Tuple(2 * p, q), evaluate=False))
    assert equivalent(pair, Eq(sp.Tuple(q, r), sp.Tuple(2 * p, p), evaluate=False)) is None


def test_roots_and_unknown_functions_count_as_quantities():
    root = sp.sqrt(p + 1)
    pair = Eq(sp.Tuple(q, r), sp.Tuple(p * root, p), evaluate=False)
    assert equivalent(pair, Eq(sp.Tuple(q, p), sp.Tuple(r * root, r), evaluate=False))
    assert equivalent(pair, Eq(sp.Tuple(q, p), sp.Tuple(r * root, -r), evaluate=False)) is None
    assert equivalent(And(Eq(f(q), p), Eq(r, f(q))), And(Eq(f(q), r), Eq(r, p)))
    assert equivalent(And(Eq(f(q), p), Eq(r, f(q))), And(Eq(f(r), p), Eq(r, f(q)))) is None


def test_rounding_is_not_taken_for_a_difference():
    """With W(u e^u) = u, for -1 < u < 0, both sides are 0 but for the last digits."""
    u = sp.Symbol("u", negative=True)
    w = LambertW(u * exp(u))
    assert is_zero((w - u) / (u * (u + 1)) - ((w + 1) / (u + 1) - 1) / u)
    assert is_zero((w - u) / (u * (u + 1)) - ((w + 1) / (u + 1) - 2) / u) is None


LIMITS = {
    "what vanishes": (Limit(p + q, q, 0), Limit(p + q * cos(q), q, 0), True),
    "at infinity": (Limit(1 / q, q, oo), Limit(1 / q + exp(-q), q, oo), True),
    "what does not vanish": (Limit(p + q, q, 0), Limit(p + cos(q), q, 0), False),
    "another place": (Limit(p + q, q, 0), Limit(p + q, q, 1), False),
    "the other side": (Limit(1 / q, q, 0, "+"), Limit(1 / q, q, 0, "-"), False),
    "through W, where SymPy is wrong": (Limit(p, q, 0), Limit(p + q * LambertW(q - exp(-1)), q, 0), False),
}


@pytest.mark.parametrize(("one", "other", "same"), LIMITS.values(), ids=LIMITS)
def test_limits_of_functions_that_come_together(one, other, same):
    assert (equivalent(Eq(one, p, evaluate=False), Eq(other, p, evaluate=False)) is not None) == same


def kind(printed, other, domain=SOME):
    """The verdict on another statement."""
    verdict = entry(printed, domain).compare(other)
    assert (verdict.kind is Kind.REFUTED) == (verdict.counterexample is not None)
    return verdict.kind


AT_LEAST = Ge(p + 1 / p, 2, evaluate=False)
BOUNDS = {
    "looser": Ge(p + 1 / p, 1, evaluate=False),
    "stricter": Ge(p + 1 / p, 3, evaluate=False),
    "not attained": Gt(p + 1 / p, 2, evaluate=False),
    "reversed": Le(p + 1 / p, 2, evaluate=False),
}


@pytest.mark.parametrize("other", BOUNDS.values(), ids=BOUNDS)
def test_another_bound_is_refuted(other):
    assert kind(AT_LEAST, other) is Kind.REFUTED


def test_a_value_between_two_bounds_tells_them_apart():
    shown = entry(AT_LEAST).compare(BOUNDS["looser"]).counterexample
    assert float(shown["p - 2 + 1/p"]) == -0.5


def test_the_same_bound_is_proved():
    assert kind(AT_LEAST, Le(2, (p**2 + 1) / p, evaluate=False)) is Kind.PROVED


def test_a_part_that_follows_from_another_makes_no_difference():
    both = And(Gt(p + 1, 1, evaluate=False), Gt(2 * p + 2, 2, evaluate=False), evaluate=False)
    loose = And(Gt(p + 1, 1, evaluate=False), Gt(2 * p + 2, 1, evaluate=False), evaluate=False)
    assert kind(both, loose) is Kind.PROVED
    assert kind(both, And(Gt(p + 1, 1, evaluate=False), Gt(2 * p + 2, 3, evaluate=False))) is Kind.REFUTED


def test_what_follows_from_the_parts_that_are_shared():
    said = And(Eq(q, p), Eq(r, q**2))
    assert kind(said, And(Eq(q, p), Eq(r, p**2))) is Kind.PROVED
    assert kind(said, And(Eq(q, p), Eq(r, p**3))) is Kind.REFUTED


SIGN = Domain({p: POSITIVE, r: sp.FiniteSet(-1, 1)})


def test_a_sign_is_put_in_case_by_case():
    assert kind(Eq(q, (p + r) ** 2), Eq(q, (r * p + 1) ** 2), SIGN) is Kind.PROVED
    assert kind(Eq(q, (p + r) ** 2), Eq(q, (p + 1) ** 2), SIGN) is Kind.REFUTED


LAMBERT = Eq(LambertW(q * exp(q), -1), q)


def test_what_holds_for_every_value_holds_for_its_multiples():
    twice = Eq(LambertW(2 * q * exp(2 * q), -1), 2 * q)
    assert kind(LAMBERT, twice, Domain({q: sp.Interval(-oo, -1)})) is Kind.PROVED
    negative = Eq(LambertW(-q * exp(-q), -1), -q)
    assert kind(LAMBERT, negative, Domain({q: sp.Interval(-oo, -1)})) is Kind.REFUTED


def test_multiples_that_lead_outside_say_nothing():
    """acos(cos(q)) = q holds from 0 to pi, and 2 q goes further."""
    arc = sp.Interval(0, sp.pi)
    assert kind(Eq(acos(cos(q)), q), Eq(acos(cos(2 * q)), 2 * q), Domain({q: arc})) is Kind.REFUTED


ROOTS = Equivalent(Eq(q**2, p**2), Or(Eq(q, p), Eq(q, -p)), evaluate=False)
PLANE = Domain({p: POSITIVE, q: REAL})


@pytest.mark.parametrize(
    "other",
    [
        Equivalent(Eq(q**2, p**2), Eq(q, p), evaluate=False),
        Equivalent(Eq(q**2, p**2), Or(Eq(q, p), Eq(q, -2 * p)), evaluate=False),
        Equivalent(Eq(q**3, p**3), Or(Eq(q, p), Eq(q, -p)), evaluate=False),
    ],
    ids=["a root lost", "another root", "another equation"],
)
def test_a_wrong_equivalence_is_refuted_at_a_root(other):
    """No point at random is a root."""
    verdict = entry(ROOTS, PLANE).compare(other)
    assert verdict.kind is Kind.REFUTED
    assert abs(sp.Float(verdict.counterexample["q"])) >= sp.Float(verdict.counterexample["p"]) * 0.999


def test_an_equivalence_is_tried_where_a_bound_is_reached():
    line = Domain({q: REAL})
    said = Equivalent(Ge(q, -1, evaluate=False), Ge(q**3, -1, evaluate=False), evaluate=False)
    assert kind(said, Equivalent(Gt(q, -1, evaluate=False), Ge(q**3, -1, evaluate=False)), line) is Kind.REFUTED
    assert kind(said, Equivalent(Ge(q, -1, evaluate=False), Lt(-2, q**3, evaluate=False)), line) is Kind.REFUTED


def test_a_side_without_a_value_equals_nothing():
    """The gamma function has a pole at 0."""
    at_pole = Domain({p: sp.FiniteSet(1)}, where={q: p, r: p - 1})
    assert kind(Eq(q, p), Eq(q, p * sp.gamma(r)), at_pole) is Kind.REFUTED
