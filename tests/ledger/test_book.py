"""The ledger as a mapping: ids, premises by id, names that are nearly right, nothing derived before it is asked for."""

import pytest
from small_ledger import SOME, TWICE, chapter, notation, p, q, r
from sympy import Eq

from galileo_sym.ledger import Chapter, Domain, Erratum, Kind, Ledger, Notation, UnknownEntry
from galileo_sym.ledger.inventory import inventory

SQUARE = Eq(r, 4 * p**2)


def test_loading_derives_nothing():
    fresh = Ledger.load()
    assert "chord.eq21" in fresh
    assert not [e.id for e in fresh.values() if {"_outcome", "own_verdict", "verdict"} & set(vars(e))]


def test_an_entry_derives_its_premises_and_no_more():
    fresh = Ledger.load()
    assert fresh["chord.eq1"].result is not None
    derived = {e.id for e in fresh.values() if "_outcome" in vars(e)}
    assert derived == {"chord.eq1", "chord.setup", "chord.law.frictionless"}


def test_a_derivation_runs_once():
    calls = []
    made = chapter()

    @made.derive("stable.test.entry", TWICE, SOME)
    def derivation():
        calls.append(1)
        return TWICE

    entry = Ledger([made])["stable.test.entry"]
    assert not calls
    assert (entry.result, entry.verdict.kind, entry.verdict.kind) == (TWICE, Kind.PROVED, Kind.PROVED)
    assert calls == [1]


def test_iteration_gives_ids(ledger):
    ids = list(ledger)
    assert len(ids) == len(set(ids)) == len(ledger)
    assert all(ledger[i].id == i for i in ids)
    assert {"chord.eq21", "chord.law.friction", "stable.chord.distance.drag"} <= set(ids)


def test_premises_are_entries_and_form_no_circle(ledger):
    def depth(identifier, above=()):
        assert identifier not in above, f"{identifier} is derived from itself"
        return 1 + max((depth(i, (*above, identifier)) for i in ledger[identifier].premises), default=0)

    assert max(map(depth, ledger)) > 5


@pytest.mark.parametrize(
    ("wrong", "near"),
    [
        ("chord.eqn21", "chord.eq21"),
        ("chord.galileio", "chord.galileo"),
        ("stable.distance.drag", "chord.distance.drag"),
    ],
)
def test_an_unknown_name_is_answered_with_the_nearest(ledger, wrong, near):
    for ask in (lambda: ledger[wrong], lambda: ledger.select([wrong])):
        with pytest.raises(UnknownEntry) as raised:
            ask()
        assert near in str(raised.value)
        assert wrong in str(raised.value)


def test_an_unknown_name_is_a_key_error(ledger):
    assert "chord.eq999" not in ledger
    with pytest.raises(KeyError):
        ledger["chord.eq999"]


def test_entries_are_chosen_by_id_chapter_or_paper(ledger):
    everything = {e.id for e in ledger.select([])}
    chord = {e.id for e in ledger.select(["chord"])}
    galileo = {e.id for e in ledger.select(["chord.galileo"])}
    assert everything == set(ledger)
    assert chord == {i for i in ledger if i.startswith("chord.")}
    assert {"chord.eq1", "chord.eq11"} <= galileo < chord
    assert "chord.eq12" not in galileo
    assert [e.id for e in ledger.select(["chord.eq9", "chord.galileo"])].count("chord.eq9") == 1


def test_one_id_twice_is_refused():
    made = chapter()
    made.derive("stable.test.entry", TWICE, SOME)(lambda: TWICE)
    with pytest.raises(ValueError, match="declared twice"):
        made.derive("stable.test.entry", SQUARE, SOME)(lambda: SQUARE)


def test_one_id_in_two_chapters_is_refused():
    chapters = [Chapter(name, notation, "a chapter of the tests") for name in ("stable.one", "stable.two")]
    for made in chapters:
        made.derive("stable.test.entry", TWICE, SOME)(lambda: TWICE)
    with pytest.raises(ValueError, match="two chapters"):
        Ledger(chapters)


def test_a_premise_that_no_chapter_declares_is_refused():
    made = chapter()

    @made.derive("stable.test.entry", TWICE, SOME)
    def derivation(stable__test__absent):
        return stable__test__absent.equation

    with pytest.raises(ValueError, match=r"stable\.test\.absent, which no chapter declares"):
        Ledger([made])


def test_an_id_must_be_in_the_inventory():
    with pytest.raises(ValueError, match="not in the inventory"):
        Chapter("chord.test", notation, "a chapter of the tests").derive("chord.eq999", TWICE, SOME)(lambda: TWICE)


def test_names_of_arguments_are_ids():
    chord = Notation("chord", notation.symbols, notation.functions, notation.dimensions)
    made = Chapter("chord.test", chord, "a chapter of the tests")
    made.given("chord.eq25", TWICE, SOME)

    @made.derive("chord.claim.slides-iff", SQUARE, SOME)
    def one(eq25):
        return Eq(r, eq25.of(q) ** 2)

    @made.derive("stable.test.entry", SQUARE, SOME)
    def other(chord__claim__slides_iff):
        return chord__claim__slides_iff.equation

    ledger = Ledger([made])
    assert ledger["chord.claim.slides-iff"].premises == ("chord.eq25",)
    assert ledger["stable.test.entry"].premises == ("chord.claim.slides-iff",)
    assert ledger["stable.test.entry"].verdict.kind is Kind.PROVED


def test_an_entry_says_what_it_is(ledger):
    entry, item = ledger["chord.eq24"], inventory()["chord.eq24"]
    assert (entry.paper, entry.kind, entry.label) == (item.paper, item.kind, item.label)
    assert entry.erratum.ids == item.errata == ("C4",)
    assert entry.doc
    assert {s.name for s in entry.assumptions.free_symbols} == {"g", "mu", "t", "theta"}


def test_judging_many_tells_of_each_once():
    made = chapter()
    made.derive("stable.test.first", TWICE, SOME)(lambda: TWICE)
    made.derive("stable.test.second", SQUARE, SOME)(lambda stable__test__first: Eq(r, stable__test__first.of(q) ** 2))
    ledger, told = Ledger([made]), []
    ledger.judge([ledger["stable.test.second"]], progress=lambda *news: told.append(news))
    assert sorted(i for _, _, i in told) == ["stable.test.first", "stable.test.second"]
    assert {(done, total) for done, total, _ in told} == {(1, 2), (2, 2)}
    ledger.judge(list(ledger.values()), progress=lambda *news: told.append(news))
    assert len(told) == 2


def test_an_erratum_is_told():
    made = chapter()
    note = Erratum(("E7",), "twice, not three times", Eq(q, 3 * p), Domain(SOME.ranges))
    made.derive("stable.test.entry", TWICE, SOME, erratum=note)(lambda: TWICE)
    entry = Ledger([made])["stable.test.entry"]
    assert entry.erratum is note
    assert entry.verdict.kind is Kind.PROVED
    assert entry.erratum_verdict.kind is Kind.REFUTED
    assert set(entry.erratum_verdict.counterexample) == {"p", "q"}
