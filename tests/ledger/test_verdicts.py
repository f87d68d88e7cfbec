"""From a declaration to a verdict: each kind is reached by what it is meant for, and by nothing less."""

import pickle
from dataclasses import FrozenInstanceError

import pytest
import small_ledger as small
import sympy as sp
from small_ledger import SOME, TWICE, a, b, chapter, entry, f, h, p, q, r
from sympy import And, Eq, Gt, Interval, Lt

from galileo_sym.derivations.chord.notation import g
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    Domain,
    Erratum,
    Kind,
    Ledger,
    StrictlyIncreasing,
    Verdict,
)

BY_ANGLE = 2 * sp.sinh(sp.asinh(p) / 3)  # the real root of x^3 + 3 x = 2 p
BY_ROOTS = sp.cbrt(sp.sqrt(p**2 + 1) + p) - sp.cbrt(sp.sqrt(p**2 + 1) - p)


def test_the_kinds_are_those_of_the_contract():
    names = {"proved", "certified", "checked", "refuted", "vacuous", "error", "law", "definition"}
    assert {kind.value for kind in Kind} == names
    assert {kind.value for kind in Kind if kind.sound} == {"proved", "certified", "law", "definition"}


def test_a_verdict_cannot_be_changed():
    verdict = Verdict(Kind.REFUTED, "by hand", 1.5, {"x": "2"})
    with pytest.raises(FrozenInstanceError):
        verdict.kind = Kind.PROVED
    with pytest.raises(TypeError):
        verdict.counterexample["x"] = "3"


@pytest.mark.parametrize("example", [None, {"x": "2"}])
def test_a_verdict_survives_pickling(example):
    verdict = Verdict(Kind.REFUTED, "by hand", 1.5, example)
    again = pickle.loads(pickle.dumps(verdict))
    assert (again.kind, again.method, again.seconds, again.counterexample) == (Kind.REFUTED, "by hand", 1.5, example)


def test_a_verdict_keeps_its_own_copy_of_the_counterexample():
    example = {"x": "2"}
    verdict = Verdict(Kind.REFUTED, counterexample=example)
    example["x"] = "3"
    assert dict(verdict.counterexample) == {"x": "2"}


def test_a_true_result_of_another_form_is_proved():
    assert entry(Eq(q, (p + 1) ** 2), result=Eq(q, p**2 + 2 * p + 1)).verdict.kind is Kind.PROVED


def test_agreement_in_numbers_alone_is_not_proved():
    """SymPy does not know the two forms of a cubic's root, by thirds of an angle and by cube roots, for the same."""
    verdict = entry(Eq(q, BY_ANGLE), result=Eq(q, BY_ROOTS)).verdict
    assert verdict.kind is Kind.CHECKED
    assert not verdict.holds


def test_a_wrong_print_is_refuted_at_a_point_that_violates_it():
    verdict = entry(Eq(q, 2 * p + p**2), result=TWICE).verdict
    assert verdict.kind is Kind.REFUTED
    assert "printed" in verdict.method
    values = {name: sp.Float(v) for name, v in verdict.counterexample.items()}
    assert abs(values["q"] - 2 * values["p"]) < 1e-9 * values["q"]
    assert abs(values["q"] - (2 * values["p"] + values["p"] ** 2)) > 1e-9 * values["q"]


@pytest.mark.parametrize("false", [Eq(q, 3 * p), Gt(q, 1), Lt(q, 2 * p), sp.false])
def test_a_false_step_refutes_a_true_result(false):
    verdict = entry(TWICE, steps=[Eq(q / 2, p), false]).verdict
    assert verdict.kind is Kind.REFUTED
    assert "on the way" in verdict.method


def test_a_step_wrong_at_the_edge_of_the_assumptions_alone_is_found():
    edge = Domain({q: Interval(0, 1)})
    inside = Domain({q: Interval.open(0, 1)})
    assert entry(Eq(r, q), edge, steps=[Gt(q, 0)]).verdict.kind is Kind.REFUTED
    assert entry(Eq(r, q), inside, steps=[Gt(q, 0)]).verdict.kind is Kind.PROVED


EMPTY = {
    "no number": Domain({p: sp.S.EmptySet}),
    "reversed": Domain({p: Interval.open(1, 0)}),
    "dependent": Domain({p: POSITIVE, r: Interval.open(p, p)}),
    "a piece": Domain({p: sp.Union(Interval(1, 2), sp.S.EmptySet, evaluate=False)}),
    "none of a list": Domain({p: sp.FiniteSet()}),
}


@pytest.mark.parametrize("domain", EMPTY.values(), ids=EMPTY)
def test_assumptions_without_a_point_make_a_verdict_vacuous(domain):
    assert entry(TWICE, domain).verdict.kind is Kind.VACUOUS


def test_assumptions_without_a_point_make_comparison_and_erratum_vacuous():
    nothing = Domain({p: sp.S.EmptySet})
    assert entry(TWICE, nothing).compare(Eq(q, 3 * p)).kind is Kind.VACUOUS
    bad = entry(TWICE, erratum=Erratum(("E1",), "none", Eq(q, 3 * p), nothing))
    assert bad.erratum_verdict.kind is Kind.VACUOUS


def test_the_printed_form_of_an_erratum_is_refuted_only_if_it_is_false():
    assert entry(TWICE, erratum=Erratum(("E1",), "no 3", Eq(q, 3 * p))).erratum_verdict.kind is Kind.REFUTED
    assert entry(TWICE, erratum=Erratum(("E1",), "no 2", Eq(q, p + p))).erratum_verdict.kind is Kind.CHECKED
    assert entry(TWICE, erratum=Erratum(("E1",), "wording")).erratum_verdict is None


LENGTHS = Domain({a: POSITIVE, h: NONNEGATIVE})
INHOMOGENEOUS = {
    "sum": Eq(b, a + a**2),
    "sides": Eq(b, a / h),
    "exponential": Eq(b, a * sp.exp(a)),
    "exponent": Eq(b, a * a**q),
    "inequality": Gt(a, h),
    "derivative": Eq(f(h).diff(h), a),
    "claim": StrictlyIncreasing(a + h, h, Interval(0, sp.oo)),
    "ends of a claim": StrictlyIncreasing(a * h, h, Interval(0, a)),
    "tuple": Eq(sp.Tuple(b, q), sp.Tuple(a, a)),
    "part": And(Eq(b, a), Gt(a, 1)),
}


@pytest.mark.parametrize("statement", INHOMOGENEOUS.values(), ids=INHOMOGENEOUS)
def test_unequal_dimensions_are_an_error(statement):
    verdict = entry(statement, LENGTHS).verdict
    assert verdict.kind is Kind.ERROR
    assert "Inhomogeneous" in verdict.method


def test_unequal_dimensions_in_a_step_are_an_error():
    verdict = entry(Eq(b, a), LENGTHS, steps=[Eq(b, a + h - h, evaluate=False), Gt(a, h**2)]).verdict
    assert verdict.kind is Kind.ERROR
    assert "Inhomogeneous" in verdict.method


def test_a_symbol_without_a_dimension_is_an_error():
    stranger = sp.Symbol("stranger", positive=True)
    verdict = entry(Eq(q, p * stranger), Domain({p: POSITIVE, stranger: POSITIVE})).verdict
    assert verdict.kind is Kind.ERROR
    assert "stranger" in verdict.method


def test_homogeneous_statements_pass():
    moving = Eq(f(h).diff(h, 2), a / h**2 * sp.exp(-b / a) + sp.sqrt(a**2 + a * b) / h**2)
    domain = Domain({a: POSITIVE, h: Interval.open(0, sp.oo), b: POSITIVE}, where={f(h).diff(h, 2): moving.rhs})
    assert entry(moving, domain).verdict.kind is Kind.PROVED


def two(first, second_printed, derivation, *, steps_of_first=()):
    """A ledger in which stable.test.second is derived from stable.test.first."""
    made = chapter()
    made.derive("stable.test.first", TWICE, SOME)(lambda: first)
    made.derive("stable.test.second", second_printed, SOME)(derivation)
    return Ledger([made])["stable.test.second"]


SQUARE = Eq(r, 4 * p**2)


def test_a_premise_that_is_used_can_prove():
    def derivation(stable__test__first):
        return Eq(r, sp.expand(stable__test__first.of(q) ** 2))

    assert two(TWICE, SQUARE, derivation).verdict.kind is Kind.PROVED
    assert two(TWICE, SQUARE, derivation).premises == ("stable.test.first",)


def test_a_premise_that_is_not_used_is_an_error():
    def derivation(stable__test__first):
        return SQUARE

    verdict = two(TWICE, SQUARE, derivation).verdict
    assert verdict.kind is Kind.ERROR
    assert "never used: stable.test.first" in verdict.method


def test_nothing_is_proved_from_what_is_refuted():
    def derivation(stable__test__first):
        return Eq(r, sp.expand(stable__test__first.of(q) ** 2))

    verdict = two(Eq(q, 3 * p), Eq(r, 9 * p**2), derivation).verdict
    assert verdict.kind is Kind.ERROR
    assert "stable.test.first is refuted" in verdict.method


def test_nothing_is_proved_from_what_is_only_checked():
    made = chapter()
    made.derive("stable.test.first", Eq(q, BY_ANGLE), SOME)(lambda: Eq(q, BY_ROOTS))

    @made.derive("stable.test.second", Eq(r, 2 * BY_ANGLE), SOME)
    def second(stable__test__first):
        return Eq(r, 2 * stable__test__first.rhs)

    @made.derive("stable.test.third", Eq(r, 2 * BY_ANGLE), SOME)
    def third(stable__test__second):
        return stable__test__second.equation

    ledger = Ledger([made])
    assert ledger["stable.test.second"].verdict.kind is Kind.ERROR
    assert ledger["stable.test.third"].verdict.kind is Kind.ERROR


def test_a_derivation_that_raises_is_an_error_not_a_crash():
    made = chapter()

    @made.derive("stable.test.entry", TWICE, SOME)
    def derivation():
        return 1 / 0

    verdict = Ledger([made])["stable.test.entry"].verdict
    assert verdict.kind is Kind.ERROR
    assert "ZeroDivisionError" in verdict.method


@pytest.mark.parametrize("result", [2 * p, 7, "Eq(q, 2*p)", (TWICE,)])
def test_a_derivation_must_return_a_statement(result):
    verdict = entry(TWICE, result=result).verdict
    assert verdict.kind is Kind.ERROR
    assert "not a statement" in verdict.method


def test_a_step_must_be_a_statement():
    verdict = entry(TWICE, steps=[2 * p]).verdict
    assert verdict.kind is Kind.ERROR
    assert "not a statement" in verdict.method


def test_a_premise_of_the_wrong_kind_is_an_error():
    def derivation(stable__test__first):
        return Eq(r, stable__test__first.of(b))

    verdict = two(TWICE, SQUARE, derivation).verdict
    assert verdict.kind is Kind.ERROR
    assert "does not say what b is" in verdict.method


def test_a_quantity_without_a_value_is_an_error():
    verdict = entry(Gt(q + p, 7)).verdict
    assert verdict.kind is Kind.ERROR
    assert "no value for q" in verdict.method


def test_an_equation_is_not_given():
    made = Chapter("chord.test", small.notation, "a chapter of the tests")
    with pytest.raises(ValueError, match="derive it"):
        made.given("chord.eq21", Eq(q, p), Domain({g: POSITIVE}))
    with pytest.raises(ValueError, match="derive it"):
        made.given("stable.test.entry", TWICE, SOME)
    made.given("chord.eq25", TWICE, SOME)
    assert Ledger([made])["chord.eq25"].verdict.kind is Kind.DEFINITION


@pytest.mark.parametrize(("value", "kind"), [(2 * p, Kind.DEFINITION), (p, Kind.REFUTED)])
def test_what_is_given_must_be_true_of_what_is_put_in(value, kind):
    made = Chapter("chord.test", small.notation, "a chapter of the tests")
    made.given("chord.eq25", TWICE, Domain(SOME.ranges, where={q: value}))
    assert Ledger([made])["chord.eq25"].verdict.kind is kind


def test_a_law_without_a_point_is_vacuous():
    made = Chapter("chord.test", small.notation, "a chapter of the tests")
    made.given("chord.eq25", TWICE, Domain({p: sp.S.EmptySet}))
    assert Ledger([made])["chord.eq25"].verdict.kind is Kind.VACUOUS


def test_a_definition_that_is_not_homogeneous_is_an_error():
    made = Chapter("chord.test", small.notation, "a chapter of the tests")
    made.given("chord.eq25", Eq(b, p), SOME)
    assert Ledger([made])["chord.eq25"].verdict.kind is Kind.ERROR


@pytest.mark.parametrize("empty", [sp.true, sp.false])
def test_a_print_that_says_nothing_is_refused(empty):
    with pytest.raises(ValueError, match="evaluate=False"):
        entry(empty)
