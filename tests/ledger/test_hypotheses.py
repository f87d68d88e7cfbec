"""Hypotheses: tried on what is put in, handed on to what is derived, discharged by an implication."""

import pytest
import small_ledger as small
from small_ledger import a, b, f, h, p, q
from sympy import Eq, Gt, Implies, Interval, Lt, cos, oo

from galileo_sym.ledger import POSITIVE, Domain, ForAll, Kind, Ledger
from galileo_sym.ledger.dimensions import Inhomogeneous, check
from galileo_sym.ledger.numeric import holds

LEVEL = Interval.open(0, 1)
STEADY = ForAll(Eq(f(h), a), h, Interval.open(0, oo))
UNAWARE = Domain({a: POSITIVE}, where={f(h): a})
SUPPOSING = Domain({a: POSITIVE}, where={f(h): a}, supposing=(STEADY,))


@pytest.mark.parametrize(
    ("statement", "true"),
    [
        (ForAll(Gt(q + 1, 0), q, LEVEL), True),
        (ForAll(Lt(q, p), q, LEVEL), False),
        (ForAll(Lt(q, 10**6), q, Interval(0, oo)), False),
        (ForAll(ForAll(Lt(q * p, 1), q, LEVEL), p, LEVEL), True),
        (ForAll(ForAll(Lt(q + p, 1), q, LEVEL), p, LEVEL), False),
    ],
)
def test_for_all_is_tried_across_the_interval(statement, true):
    assert holds(statement, {p: Interval(0, 1).end / 2}) is true


def test_the_inside_of_for_all_must_be_homogeneous():
    with pytest.raises(Inhomogeneous):
        check(ForAll(Eq(f(h), h), h, LEVEL), small.notation.dimensions)


def _ledger(domain, result=None, printed=None):
    """An entry that supposes STEADY, and one derived from it."""
    made = small.chapter()

    @made.derive("stable.test.first", Eq(f(h), a), SUPPOSING)
    def first():
        return Eq(f(h), a)

    printed = printed or Eq(2 * f(h), 2 * a)

    @made.derive("stable.test.second", printed, domain, premises=("stable.test.first",))
    def second(before):
        doubled = Eq(2 * before.lhs, 2 * before.rhs, evaluate=False)
        return Implies(STEADY, doubled) if result else doubled

    return Ledger([made])


def test_a_hypothesis_is_part_of_the_assumptions():
    entry = _ledger(SUPPOSING)["stable.test.first"]
    assert STEADY in entry.assumptions.args
    assert entry.verdict.kind is Kind.PROVED


def test_a_hypothesis_must_hold_of_what_is_put_in():
    moving = Domain({a: POSITIVE}, where={b: 2 * a, f(h): a * cos(h)}, supposing=(STEADY,))
    verdict = small.entry(Eq(b, 2 * a), moving).verdict
    assert verdict.kind is Kind.VACUOUS
    assert "supposed" in verdict.method


def test_what_is_derived_supposes_the_same():
    assert _ledger(SUPPOSING)["stable.test.second"].verdict.kind is Kind.PROVED
    verdict = _ledger(UNAWARE)["stable.test.second"].verdict
    assert verdict.kind is Kind.ERROR
    assert "supposes more" in verdict.method


def test_or_says_so():
    printed = Implies(STEADY, Eq(2 * f(h), 2 * a))
    entry = _ledger(UNAWARE, result=True, printed=printed)["stable.test.second"]
    assert entry.verdict.kind is Kind.PROVED


def test_another_condition_does_not_discharge_it():
    other = ForAll(Eq(f(h), a), h, Interval(0, oo))
    made = _ledger(UNAWARE).chapters["stable.small"]

    @made.derive(
        "stable.test.third",
        Implies(other, Eq(f(h), a)),
        Domain({a: POSITIVE}, where={f(h): a}),
        premises=("stable.test.first",),
    )
    def third(before):
        return Implies(other, before.equation)

    assert "supposes more" in Ledger([made])["stable.test.third"].verdict.method
