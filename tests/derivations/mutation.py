"""Mutants tried: of each statement against its entry, and of each premise in the derivation that stands on it."""

from __future__ import annotations

import hashlib
import signal
import time
from contextlib import contextmanager
from dataclasses import asdict, dataclass

import sympy as sp
from indifferent import INVARIANT
from mutants import noticed, sign_changed, wrong
from statement_mutants import mutants

from galileo_sym.ledger import Kind
from galileo_sym.ledger.equivalence import equivalent

PATIENCE = 60  # seconds for one mutant

REFUTED = "refuted"  # a statement with a counterexample; a wrong premise that leaves nothing proved
EQUAL = "equal"  # shown to say the same
INDIFFERENT = "indifferent"  # a premise's sign or factor that the result does not depend on, while on another it does
SURVIVING = "surviving"  # anything else: neither refuted nor shown equal, an error, no answer in time


# Mutants of a part that another entry has, too, and for which it is shown equal there: W_(-1)(u e^u) = u for u <= -1.
SHOWN_IN = {
    ("beyond.hills.level", "symbol doubled"): "projectile.claim.trivial-root",
    ("beyond.slopes.level", "symbol doubled"): "projectile.claim.trivial-root",
}


class TooLong(BaseException):
    """No answer in time; no handler of errors takes it for one."""


@dataclass(frozen=True)
class Trial:
    """What became of one mutant."""

    entry: str
    subject: str  # "statement", or the premise's id
    operator: str
    outcome: str
    how: str
    mutant: str
    seconds: float

    def as_dict(self):
        """Plain data."""
        return asdict(self)


@contextmanager
def within(seconds):
    """Raise `TooLong` after some time, in the main thread of a process; systems without alarms wait on."""
    if not hasattr(signal, "SIGALRM"):
        yield
        return

    def stop(*_):
        raise TooLong

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def chosen(share: int, *names) -> bool:
    """Whether a mutant belongs to a sample of one in `share`: by the hash of its names, so always the same ones."""
    return int.from_bytes(hashlib.sha256("\n".join(names).encode()).digest()[:4], "big") % share == 0


def try_statements(ledger, identifier: str, share: int = 1) -> list[Trial]:
    """The entry's own printed statement, which must be proved equal, and its mutants, or a sample of them."""
    entry = ledger[identifier]
    found = [_tried(entry, "none", entry.printed)]
    if found[0].outcome != EQUAL:
        return [_renamed(found[0])]
    for mutant in mutants(entry.printed, entry.declaration.notation.dimensions):
        if chosen(share, entry.id, mutant.operator, str(mutant.statement)):
            found.append(_tried(entry, mutant.operator, mutant.statement))
            if found[-1].outcome == SURVIVING and (entry.id, mutant.operator) in SHOWN_IN:
                found[-1] = _tried_in(ledger, entry, mutant)
    return found[1:]


def _tried_in(ledger, entry, mutant):
    """The changed part in the place of the same part of another entry."""
    elsewhere = ledger[SHOWN_IN[entry.id, mutant.operator]]
    changed = {
        old: new for old, new in _changed_parts(entry.printed, mutant.statement) if old in elsewhere.printed.args
    }
    parts = [changed.get(part, part) for part in elsewhere.printed.args]
    trial = _tried(elsewhere, mutant.operator, sp.And(*parts, evaluate=False))
    shown = bool(changed) and trial.outcome == EQUAL
    outcome, how = (EQUAL, f"{elsewhere.id}, {trial.how}") if shown else (SURVIVING, trial.how)
    return Trial(entry.id, "statement", mutant.operator, outcome, how, str(mutant.statement), trial.seconds)


def _changed_parts(printed, mutant):
    ours, theirs = (set(s.args) if isinstance(s, sp.And) else {s} for s in (printed, mutant))
    return zip(ours - theirs, theirs - ours, strict=False)


def _renamed(control):
    return Trial(control.entry, "statement", "the printed statement", SURVIVING, control.how, control.mutant, 0.0)


def _tried(entry, operator, statement):
    start = time.perf_counter()
    try:
        with within(PATIENCE):
            verdict = entry.compare(statement)
            outcome, how = _outcome(verdict), f"{verdict.kind.value}: {verdict.method}"
    except TooLong:
        outcome, how = SURVIVING, f"no answer in {PATIENCE} s"
    return Trial(entry.id, "statement", operator, outcome, how, str(statement), time.perf_counter() - start)


def _outcome(verdict):
    if verdict.kind is Kind.REFUTED and verdict.counterexample is not None:
        return REFUTED
    return EQUAL if verdict.kind is Kind.PROVED else SURVIVING


def try_premises(ledger, identifier: str, share: int = 1) -> list[Trial]:
    """Each premise of an entry, or a sample of them, made wrong: by a factor, by a sign, and as `INVARIANT` says."""
    entry = ledger[identifier]
    if entry.declaration.function is None:
        return []
    return [t for p in entry.premises if chosen(share, identifier, p) for t in _try_premise(ledger, identifier, p)]


def _try_premise(ledger, identifier, premise):
    truth = ledger[premise].result
    wrongs = {"factor 2, reversed or denied": wrong(truth), "sign changed": sign_changed(truth)}
    listed = INVARIANT.get((identifier, premise))
    if listed is not None:
        wrongs["as listed"] = listed(truth)
    trials = [_trial(ledger, identifier, premise, o, truth, m) for o, m in wrongs.items() if m != truth]
    depends = any(t.outcome == REFUTED for t in trials)
    return [_excused(t, depends, listed) for t in trials]


def _trial(ledger, identifier, premise, operator, truth, mutant):
    start = time.perf_counter()
    try:
        with within(PATIENCE):
            seen = noticed(ledger, identifier, premise, mutant)
            same = not seen and equivalent(truth, mutant) is not None
        outcome = REFUTED if seen else EQUAL if same else SURVIVING
        how = {REFUTED: "nothing is proved", EQUAL: "says the same", SURVIVING: "still proved"}[outcome]
    except TooLong:
        outcome, how = SURVIVING, f"no answer in {PATIENCE} s"
    return Trial(identifier, premise, operator, outcome, how, str(mutant), time.perf_counter() - start)


def _excused(trial, depends, listed):
    """A sign, or a factor that is on the list, may be indifferent, if the result depends on the premise otherwise."""
    free = trial.operator == "sign changed" or (listed is not None and trial.operator != "as listed")
    if trial.how != "still proved" or not (depends and free):
        return trial
    return Trial(**{**trial.as_dict(), "outcome": INDIFFERENT, "how": "the result does not depend on it"})
