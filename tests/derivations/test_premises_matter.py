"""Every premise feeds its result: with one premise made wrong at a time, nothing is proved any more.

By default a sample of the premises, one in `SHARE`, always the same; `--all-mutants` tries all, `make mutants` changed
signs, too.
"""

import pytest
from indifferent import INVARIANT
from mutants import noticed, wrong
from mutation import chosen

from galileo_sym.ledger import Ledger

SHARE = 24
CONTROLS = ("chord.eq1", "chord.eq21", "chord.eq36", "chord.claim.spindle", "stable.chord.distance.drag")


def _rows():
    """What is derived, each entry with the mark that keeps those of a paper, which share premises, in one process."""
    for entry in Ledger.load().values():
        if entry.declaration.function is not None and entry.premises:
            yield entry, pytest.mark.xdist_group(f"premises of {entry.chapter.name.split('.')[0]}")


def _sampled(identifier, premise):
    return chosen(SHARE, identifier, premise) and not identifier.endswith(".at-zero")  # limits take seconds each


def pytest_generate_tests(metafunc):
    everything = metafunc.config.getoption("--all-mutants")
    if "premise" in metafunc.fixturenames:
        rows = [(e.id, p, group) for e, group in _rows() for p in e.premises if everything or _sampled(e.id, p)]
        pairs = [pytest.param(i, p, id=f"{i}<-{p}", marks=group) for i, p, group in rows]
        metafunc.parametrize(("identifier", "premise"), pairs)
    if "control" in metafunc.fixturenames:
        entries = [(e.id, group) for e, group in _rows() if everything or e.id in CONTROLS]
        metafunc.parametrize("control", [pytest.param(i, marks=group) for i, group in entries])


def test_a_wrong_premise_is_noticed(ledger, identifier, premise):
    truth = ledger[premise].result
    mutant = wrong(truth)
    assert mutant != truth
    if (identifier, premise) in INVARIANT:
        assert not noticed(ledger, identifier, premise, mutant), "no longer an exception: take it off the list"
        mutant = INVARIANT[identifier, premise](truth)
    assert noticed(ledger, identifier, premise, mutant)


def test_the_exceptions_are_premises():
    ledger = Ledger.load()
    assert all(premise in ledger[identifier].premises for identifier, premise in INVARIANT)


def test_the_true_premises_are_not_noticed(ledger, control):
    """The trial itself does not cry wolf."""
    premise = ledger[control].premises[0]
    assert not noticed(ledger, control, premise, ledger[premise].result)
