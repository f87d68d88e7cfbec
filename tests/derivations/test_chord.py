"""The chord chapters: every entry proved, every equation of sections 1 to 3 there, errata recorded and refuted."""

import pytest
import sympy as sp

from galileo_sym.ledger import Kind, Ledger, tell
from galileo_sym.ledger.inventory import inventory

pytestmark = pytest.mark.xdist_group("chord")

CHORD = [e.id for e in Ledger.load().select(["chord"])]
ITEMS = inventory()
GIVEN = {"law": Kind.LAW, "definition": Kind.DEFINITION}
# laws in the inventory's table of contents, here derived from Newton's law
DERIVED = {"chord.eq12", "chord.eq14", "chord.eq28", "chord.eq40"}
# the list of errata speaks of (2)-(4) and of (12)-(14); the inventory marks only the outer ones
WITHIN = {"chord.eq4": {"C10"}, "chord.eq13": {"C1", "C2"}}
SECTIONS = ("1", "2", "3")  # complete now; the later ones grow


@pytest.mark.parametrize("identifier", CHORD)
def test_entry_is_proved(ledger, identifier):
    entry = ledger[identifier]
    assert entry.verdict.kind is (GIVEN[entry.kind] if _given(identifier) else Kind.PROVED), tell(entry)


def _given(identifier):
    return ITEMS[identifier].kind in GIVEN and identifier not in DERIVED


@pytest.mark.parametrize("identifier", CHORD)
def test_only_laws_and_definitions_are_without_derivation(ledger, identifier):
    assert (ledger[identifier].declaration.function is None) is _given(identifier)


def test_every_statement_of_sections_1_to_3_is_there(ledger):
    wanted = {
        i.id
        for i in ITEMS.values()
        if i.paper == "chord" and i.kind != "figure" and i.printed and i.section.split(".")[0].strip() in SECTIONS
    }
    assert {f"chord.eq{n}" for n in range(1, 28)} <= wanted
    assert not wanted - set(ledger)


@pytest.mark.parametrize("identifier", [i for i in CHORD if ITEMS[i].errata])
def test_errata_are_recorded_and_what_is_printed_is_refuted(ledger, identifier):
    entry = ledger[identifier]
    assert entry.erratum is not None
    assert set(entry.erratum.ids) == set(ITEMS[identifier].errata)
    assert entry.erratum.text
    if entry.erratum.printed is None:
        assert entry.erratum_verdict is None
    else:
        assert entry.erratum_verdict.kind is Kind.REFUTED
        assert entry.erratum_verdict.counterexample


def test_no_erratum_is_invented(ledger):
    unmarked = {i: set(ledger[i].erratum.ids) for i in CHORD if ledger[i].erratum and not ITEMS[i].errata}
    assert unmarked == WITHIN


@pytest.mark.parametrize("identifier", sorted(DERIVED))
def test_motion_is_derived_from_newtons_law(ledger, identifier):
    """Only laws and definitions are at the bottom, a law among them."""
    waiting, seen = [identifier], set()
    while waiting:
        i = waiting.pop()
        seen.add(i)
        waiting += [j for j in ledger[i].premises if j not in seen]
    bottom = {ITEMS[i].kind for i in seen if not ledger[i].declaration.function}
    assert "law" in bottom
    assert bottom <= set(GIVEN)


def test_the_steps_to_21_can_be_followed(ledger):
    entry = ledger["chord.eq21"]
    assert [s.text for s in entry.steps][:2] == ["(19)", "(20)"]
    left = entry.steps[-1].statement
    assert left.rhs == 0
    assert not left.has(sp.sin, sp.cos)
    told = tell(entry)
    for words in ("chord.eq21", "chord.eq19, chord.eq20", "eliminate", "C5", "proved"):
        assert words in told
