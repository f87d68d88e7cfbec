"""Every premise feeds its result: with one premise made wrong at a time, nothing is proved any more.

By default the premises of the chord paper, of the stable forms but for their limits at zero drag, and of three
results of the projectile paper; `make mutants` tries those of every entry.
"""

from functools import partial

import pytest
from mutants import noticed, opposite, scaled, shifted, wrong

from galileo_sym.ledger import Ledger

QUICK = ("chord.", "stable.chord", "stable.projectile")  # chapters
HEADLINES = ("projectile.res3", "projectile.thm3", "projectile.range.full")
CONTROLS = ("chord.eq1", "chord.eq21", "chord.eq36", "chord.claim.spindle", "stable.chord.distance.drag")

# Where doubling a right side rightly changes nothing, another mutant must be noticed.
CENTRE_ALONE = {
    ("chord.claim.centre-accel", "chord.eq9"): partial(scaled, name="g"),
    ("chord.claim.centre-off-axis", "chord.eq21"): partial(scaled, name="mu"),
    ("chord.claim.centre-accel-mu", "chord.eq21"): partial(scaled, name="mu"),
    ("chord.claim.centre-line-angle", "chord.eq21"): partial(scaled, name="mu"),
    ("chord.eq23", "chord.eq21"): partial(scaled, name="mu"),
}
ROOT_ALONE = {
    ("chord.eq13", "chord.eq12"): partial(scaled, name="mu"),
    ("projectile.nodrag.impact", "projectile.nodrag.y"): partial(scaled, name="g"),
    ("projectile.impact.eq", "projectile.drag.y"): partial(scaled, name="g"),
    ("projectile.claim.trivial-root", "projectile.impact.time"): partial(scaled, name="u"),
    ("projectile.limit.rewrite", "projectile.limit.statement"): partial(scaled, name="u"),
    ("projectile.limit.nodrag", "projectile.range.u"): partial(scaled, name="u"),
}
SIGN_ALONE = {
    ("projectile.support.branch-thm3", "projectile.def.alpha"): opposite,
    ("projectile.lemma.c.denominator", "projectile.lemma.c.second"): shifted,
    ("projectile.lemma.d.step1", "projectile.def.uyR"): partial(scaled, name="k"),
    ("projectile.thm2.a", "projectile.lemma.e"): opposite,
    ("projectile.thm2.factor-increasing", "projectile.def.uyR"): partial(scaled, name="k"),
    ("projectile.thm2.stationary", "projectile.lemma.f.second"): partial(scaled, name="k"),
    ("projectile.thm2.stationary", "projectile.thm2.limit-0"): opposite,
    ("projectile.thm2.b", "projectile.lemma.f.second"): opposite,
    ("projectile.mono.inv-increasing", "projectile.mono.deriv2"): opposite,
    ("projectile.mono.inv-increasing", "projectile.mono.alpha2"): shifted,
    ("beyond.pure-flight.best-angle", "beyond.pure-flight.independent"): opposite,
}
INVARIANT = {**CENTRE_ALONE, **ROOT_ALONE, **SIGN_ALONE}


def _entries(everything):
    """Entries to be tried, each with the mark that keeps those of a paper, which share premises, in one process."""
    for entry in Ledger.load().values():
        if entry.declaration.function is None or not entry.premises:
            continue
        quick = entry.chapter.name.startswith(QUICK) and not entry.id.endswith(".at-zero")
        if everything or quick or entry.id in HEADLINES:
            yield entry, pytest.mark.xdist_group(f"premises of {entry.chapter.name.split('.')[0]}")


def pytest_generate_tests(metafunc):
    everything = metafunc.config.getoption("--all-mutants")
    if "premise" in metafunc.fixturenames:
        rows = [(e.id, p, group) for e, group in _entries(everything) for p in e.premises]
        pairs = [pytest.param(i, p, id=f"{i}<-{p}", marks=group) for i, p, group in rows]
        metafunc.parametrize(("identifier", "premise"), pairs)
    if "control" in metafunc.fixturenames:
        entries = [(e.id, group) for e, group in _entries(everything) if everything or e.id in CONTROLS]
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
