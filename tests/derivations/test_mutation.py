"""A sample of the mutation run, and its machinery: no wrong statement passes, nor is a true one called wrong."""

import json
import sys
import time
from pathlib import Path

import pytest
import sympy as sp
from claim_mutants import claims
from mutation import EQUAL, INDIFFERENT, REFUTED, SURVIVING, TooLong, chosen, try_premises, try_statements, within
from statement_mutants import mutants
from sympy import Derivative, Eq, Ge, LambertW, Limit, cos, exp, sin

from galileo_sym.ledger import (
    ONE,
    POSITIVE,
    Chapter,
    Domain,
    ExactlyOneRoot,
    Independent,
    Ledger,
    Notation,
    StrictlyIncreasing,
    UniqueMaximum,
)

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))

import mutation_report  # noqa: E402
import mutation_run  # noqa: E402

notation = Notation("small")
p = notation.symbol("p", ONE, "a positive number", positive=True)
q = notation.symbol("q", ONE, "a number")
r = notation.symbol("r", ONE, "another number")
y = notation.function("y", ONE, "a function")

ENTRIES, SHARE = 24, 8  # one entry in 24, and one in 8 of its mutants


def _sampled():
    """Entries by hash, but not those with limits, which take seconds each."""
    ids = [i for i in Ledger.load() if chosen(ENTRIES, i) and not i.endswith(".at-zero")]
    return [pytest.param(i, marks=pytest.mark.xdist_group(f"premises of {i.split('.')[0]}")) for i in ids]


@pytest.mark.parametrize("identifier", _sampled())
def test_no_mutant_of_a_statement_survives(ledger, identifier):
    assert [t for t in try_statements(ledger, identifier, SHARE) if t.outcome == SURVIVING] == []


ENTRY = "stable.test.entry"


def one(printed, domain, result=None):
    """A ledger of one entry."""
    made = Chapter("stable.small", notation, "a chapter of the tests")
    made.derive(ENTRY, printed, domain)(lambda: printed if result is None else result)
    return Ledger([made])


TRIPLE = Eq(q, 3 * p)


def two(derivation, first=TRIPLE):
    """A ledger of two entries, r = 9 p^2 derived from the first."""
    second = Eq(r, 9 * p**2)
    made = Chapter("stable.small", notation, "a chapter of the tests")
    made.derive("stable.test.first", first, Domain({p: POSITIVE}))(lambda: first)
    made.derive("stable.test.second", second, Domain({p: POSITIVE}))(derivation)
    return Ledger([made])


def outcomes(trials):
    """The outcomes by operator."""
    return {t.operator: t.outcome for t in trials}


def test_a_statement_tried_at_one_point_only_is_found_out():
    """Where q = r = 0 all multiples are the same: a blind entry."""
    nowhere = {q: sp.S.Zero, r: sp.S.Zero}
    blind = outcomes(try_statements(one(Eq(q, 3 * r), Domain({p: POSITIVE}, where=nowhere)), ENTRY))
    assert blind["factor 2"] == blind["side negated"] == SURVIVING
    seeing = outcomes(try_statements(one(Eq(q, 3 * r), Domain({p: POSITIVE}, where={q: 3 * p, r: p})), ENTRY))
    assert set(seeing.values()) == {REFUTED}


def test_an_entry_that_is_not_proved_is_found_out_before_its_mutants():
    wrong = one(Eq(q, 2 * p), Domain({p: POSITIVE}), Eq(q, 3 * p))
    assert outcomes(try_statements(wrong, ENTRY)) == {"the printed statement": SURVIVING}


def test_a_mutant_that_says_the_same_is_not_called_refuted(ledger):
    """2 sin a cos a = sin 2a holds for a = 2 theta and a = -theta, too."""
    found = try_statements(ledger, "chord.eq7")
    same = {t.operator for t in found if t.outcome == EQUAL}
    assert same == {"sign of a symbol", "symbol doubled"}
    assert all(t.outcome == REFUTED for t in found if t.operator not in same)


def test_a_derivation_that_types_the_answer_is_found_out():
    def typed(stable__test__first):
        _ = stable__test__first.statement
        return Eq(r, 9 * p**2)

    trials = try_premises(two(typed), "stable.test.second")
    assert set(outcomes(trials).values()) == {SURVIVING}
    assert len(trials) == 2


def test_a_sign_that_does_not_matter_is_told_from_a_premise_that_does_not():
    def squared(stable__test__first):
        return Eq(r, sp.expand(stable__test__first.rhs**2))

    found = outcomes(try_premises(two(squared), "stable.test.second"))
    assert found == {"factor 2, reversed or denied": REFUTED, "sign changed": INDIFFERENT}


def test_a_true_premise_is_not_counted_as_noticed():
    """0 = q - 3 p with both signs changed is no wrong premise."""

    def solved(stable__test__first):
        return Eq(r, sp.solve(stable__test__first.equation, q)[0] ** 2)

    found = try_premises(two(solved, first=Eq(q - 3 * p, 0)), "stable.test.second")
    assert outcomes(found)["factor 2, reversed or denied"] == REFUTED  # q - 3 p = 1


RICH = sp.And(
    Eq(y(q), p**2 * cos(r) + sin(2 * r) * exp(-q) + LambertW(p)),
    Eq(Derivative(y(q), q), p + r),
    Eq(Limit(p * q, q, 1, "+"), p),
    Ge(p, 0, evaluate=False),
    evaluate=False,
)


def test_each_operator_changes_the_statement_in_one_place():
    found = mutants(RICH, notation.dimensions)
    operators = {m.operator for m in found}
    assert operators >= {
        "side negated", "factor 2", "factor 1 + 1e-20", "shifted by 1", "equality denied", "sign of a term",
        "term dropped", "exponent + 1", "other branch of W", "sine for cosine", "sign of an exponent",
        "other derivative", "limit elsewhere", "limit of another function", "sign of a symbol", "symbol doubled",
        "quantities swapped", "order reversed", "bound not attained", "bound off by 1", "denied",
    }  # fmt: skip
    assert RICH not in [m.statement for m in found]
    assert len({m.statement for m in found}) == len(found)
    one_part = [m for m in found if m.operator != "denied"]
    assert all(len(set(RICH.args) - set(m.statement.args)) == 1 for m in one_part)


HALF_LINE = sp.Interval.open(0, sp.oo)
CLAIMS = {
    "order": StrictlyIncreasing(p * q, q, HALF_LINE),
    "root": ExactlyOneRoot(q - p, q, HALF_LINE),
    "maximum": UniqueMaximum(-((q - p) ** 2), q, HALF_LINE, p),
    "independence": Independent(p**2, q),
}


@pytest.mark.parametrize("claim", CLAIMS.values(), ids=CLAIMS)
def test_a_changed_claim_is_refuted(claim):
    entry = one(claim, Domain({p: POSITIVE}))[ENTRY]
    changed = list(claims(claim))
    assert changed
    assert all(entry.compare(other).counterexample for _, other in changed)


def test_a_mutant_without_an_answer_is_stopped_and_no_handler_takes_it_for_an_error():
    def wait():
        for _ in range(3000):
            try:
                time.sleep(0.01)
            except Exception:  # as derivations and comparisons do
                continue

    start = time.monotonic()
    with within(1), pytest.raises(TooLong):
        wait()
    assert time.monotonic() < start + 10


TRIAL = {"entry": "chord.eq1", "subject": "statement", "operator": "factor 2", "how": "by hand", "mutant": "x"}


@pytest.mark.parametrize(("outcome", "code"), [(REFUTED, 0), (EQUAL, 0), (SURVIVING, 1)])
def test_the_run_fails_if_a_mutant_survives(monkeypatch, capsys, outcome, code):
    monkeypatch.setattr(mutation_run, "run", lambda ids, processes: ([{**TRIAL, "outcome": outcome}], "0:01"))
    assert mutation_run.main(["chord.eq1"]) == code
    assert ("SURVIVES chord.eq1" in capsys.readouterr().out) == bool(code)


def test_entries_tried_later_join_the_committed_result():
    """In the ledger's order, with all counts added; what is not of the ledger's entries is refused."""
    trials = [{**TRIAL, "entry": name, "outcome": EQUAL} for name in ("chord.eq1", "chord.eq2", "stable.new")]
    whole = mutation_report.result_of(trials, ["chord.eq1", "chord.eq2", "stable.new"], "0:02", 1)
    first = mutation_report.result_of([trials[0], trials[2]], ["chord.eq1", "stable.new"], "0:02", 1)
    later = mutation_report.result_of([trials[1]], ["chord.eq2"], "0:01", 1)
    result = mutation_report.joined(first, later, whole["entries"])
    assert result["counts"] == whole["counts"]
    assert result["not refuted"] == whole["not refuted"]
    assert result["entries"] == whole["entries"]
    assert "3 entries, 1 of them tried later by themselves, 0:02 minutes" in mutation_report.page(result)
    with pytest.raises(ValueError, match="make mutants"):
        mutation_report.joined(first, later, ["chord.eq2", "stable.new"])


def test_the_committed_result_is_of_all_entries_and_nothing_survives():
    result = json.loads(mutation_run.RESULT.read_text(encoding="utf-8"))
    assert result["entries"] == list(Ledger.load())
    assert mutation_report.surviving(result) == 0
    statements = result["counts"]["statements"]["paper"].values()
    assert sum(n for row in statements for n in row.values()) > 1500
    assert mutation_run.PAGE.read_text(encoding="utf-8") == mutation_report.page(result)
