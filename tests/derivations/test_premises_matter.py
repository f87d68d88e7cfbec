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
}
INVARIANT = {**CENTRE_ALONE, **ROOT_ALONE, **SIGN_ALONE}


def _pairs(everything):
    ledger = Ledger.load()
    for entry in ledger.values():
        if entry.declaration.function is None:
            continue
        quick = entry.chapter.name.startswith(QUICK) and not entry.id.endswith(".at-zero")
        quick = quick or entry.id in HEADLINES
        if everything or quick:
            group = pytest.mark.xdist_group(f"premises of {entry.chapter.name.split('.')[0]}")
            yield from (pytest.param(entry.id, p, id=f"{entry.id}<-{p}", marks=group) for p in entry.premises)


def pytest_generate_tests(metafunc):
    if "premise" in metafunc.fixturenames:
        metafunc.parametrize(("identifier", "premise"), list(_pairs(metafunc.config.getoption("--all-mutants"))))


def test_a_wrong_premise_is_noticed(ledger, identifier, premise):
    entry = ledger[identifier]
    truths = {i: ledger[i].result for i in entry.premises}
    truth = truths[premise]
    mutant = wrong(truth)
    assert mutant != truth
    if (identifier, premise) in INVARIANT:
        assert not noticed(entry, truths, premise, mutant), "no longer an exception: take it off the list"
        mutant = INVARIANT[identifier, premise](truth)
    assert noticed(entry, truths, premise, mutant)


def test_the_exceptions_are_premises():
    ledger = Ledger.load()
    assert all(premise in ledger[identifier].premises for identifier, premise in INVARIANT)


@pytest.mark.xdist_group("premises of chord")
def test_the_true_premises_are_not_noticed(ledger):
    """The trial itself does not cry wolf."""
    for identifier in ("chord.eq1", "chord.eq21", "chord.eq36", "chord.claim.spindle"):
        entry = ledger[identifier]
        truths = {i: ledger[i].result for i in entry.premises}
        assert not any(noticed(entry, truths, premise, truths[premise]) for premise in truths)
