"""The result of the mutation tests as data and as a page: counts, tables, and every mutant that was not refuted."""

from __future__ import annotations

import hashlib
import platform
from collections import Counter, defaultdict
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OUTCOMES = ("refuted", "equal", "indifferent", "surviving")
SOURCES = ("derivations", "galileo_sym/ledger", "galileo_sym/tactics", "galileo_sym/primitives")
MUTATORS = ("statement_mutants", "claim_mutants", "mutants", "indifferent", "mutation")

INTRODUCTION = """# Mutation tests

Made by `make mutants`, which exits with 1 if any mutant survives; not written by hand.

Each entry's statement is changed in one place at a time and held against the derivation by `compare`: a mutant must
be refuted at a point, or proved to say the same (*equal*). Then each premise of each derivation is replaced by a wrong
one: nothing may still be proved. *Indifferent* is a premise's sign or factor that the result rightly does not depend
on, where another wrong version of the same premise is noticed. What is neither, an error or an answer that does not
come in time, *survives*.

Operators: `tests/derivations/statement_mutants.py`, `claim_mutants.py`, `mutants.py`.
"""


def sources() -> str:
    """A hash of the derivations, of what carries them out, and of the mutation operators."""
    paths = [p for name in SOURCES for p in sorted((ROOT / name).rglob("*")) if p.suffix in (".py", ".toml")]
    paths += [ROOT / "tests" / "derivations" / f"{name}.py" for name in MUTATORS]
    total = hashlib.sha256()
    for path in paths:
        total.update(path.relative_to(ROOT).as_posix().encode() + hashlib.sha256(path.read_bytes()).digest())
    return total.hexdigest()


def result_of(trials, entries, wall, processes) -> dict:
    """What is committed: when, with what, of which derivations, and what became of the mutants."""
    return {
        "date": datetime.now(timezone.utc).date().isoformat(),
        "sources": sources(),
        "versions": {"python": platform.python_version(), **{name: version(name) for name in ("sympy", "mpmath")}},
        "run": {"wall": wall, "processes": processes},
        "entries": list(entries),
        "counts": {
            what: {by: _counts(t, key) for by, key in (("paper", "paper"), ("operator", "operator"))}
            for what, t in _subjects(trials).items()
        },
        "not refuted": [_short(t) for t in trials if t["outcome"] != "refuted"],
    }


def _subjects(trials):
    return {
        "statements": [t for t in trials if t["subject"] == "statement"],
        "premises": [t for t in trials if t["subject"] != "statement"],
    }


def _counts(trials, key):
    found = defaultdict(Counter)
    for trial in trials:
        name = trial["entry"].split(".")[0] if key == "paper" else trial[key]
        found[name][trial["outcome"]] += 1
    return {name: {o: found[name][o] for o in OUTCOMES} for name in sorted(found)}


def _short(trial):
    kept = {k: trial[k] for k in ("entry", "subject", "operator", "outcome", "how")}
    return kept if trial["outcome"] == "indifferent" else {**kept, "mutant": trial["mutant"]}


def joined(committed, found, entries) -> dict:
    """The committed result with the trials of entries it lacked, for all `entries`, in their order.

    Raises ValueError if it holds entries that are no more, or some are still missing: then a whole run is due.
    """
    if sorted(committed["entries"] + found["entries"]) != sorted(entries):
        raise ValueError("the committed result is not of these entries: run `make mutants`")
    trials = sorted(committed["not refuted"] + found["not refuted"], key=lambda t: entries.index(t["entry"]))
    counts = {
        what: {by: _sum(committed["counts"][what][by], rows) for by, rows in tables.items()}
        for what, tables in found["counts"].items()
    }
    run = committed["run"]
    run = {**run, "tried later": run.get("tried later", 0) + len(found["entries"])}
    return {**committed, "run": run, "entries": list(entries), "counts": counts, "not refuted": trials}


def _sum(first, second):
    names = sorted({*first, *second})
    return {n: {o: first.get(n, {}).get(o, 0) + second.get(n, {}).get(o, 0) for o in OUTCOMES} for n in names}


def surviving(result) -> int:
    """How many mutants survive."""
    return sum(t["outcome"] == "surviving" for t in result["not refuted"])


def page(result) -> str:
    """The page for readers."""
    run = result["run"]
    versions = ", ".join(f"{name} {number}" for name, number in result["versions"].items())
    later = f", {run['tried later']} of them tried later by themselves" if "tried later" in run else ""
    lines = [
        INTRODUCTION,
        f"{result['date']}, {versions}; {len(result['entries'])} entries{later}, {run['wall']} minutes on "
        f"{run['processes']} processes; sources {result['sources'][:16]}.",
        "",
    ]
    for what, tables in result["counts"].items():
        for by, rows in tables.items():
            lines += [f"## Mutants of {what}, by {by}", "", *_table(by, rows, what == "premises"), ""]
    indifferent = [t for t in result["not refuted"] if t["outcome"] == "indifferent"]
    lines += ["## Indifferent", "", "| entry | premise | change |", "|---|---|---|"]
    lines += [f"| {t['entry']} | {t['subject']} | {t['operator']} |" for t in indifferent]
    lines += ["", "The mutants shown equal are listed in `tests/derivations/mutation_result.json`.", ""]
    return "\n".join(lines)


def _table(by, rows, premises):
    columns = [o for o in OUTCOMES if premises or o != "indifferent"]
    total = {o: sum(row[o] for row in rows.values()) for o in columns}
    lines = [f"| {by} | tried | {' | '.join(columns)} |", "|---" * (len(columns) + 2) + "|"]
    for name, row in (*rows.items(), ("**all**", total)):
        counts = [row[o] for o in columns]
        lines.append(f"| {name} | {sum(counts)} | {' | '.join(map(str, counts))} |")
    return lines


def told(result) -> str:
    """The tables for a terminal, and the survivors."""
    lines = []
    for what, tables in result["counts"].items():
        for by, rows in tables.items():
            lines += [f"{what}, by {by}", *_table(by, rows, what == "premises"), ""]
    for t in result["not refuted"]:
        if t["outcome"] == "surviving":
            lines.append(f"SURVIVES {t['entry']} ({t['subject']}, {t['operator']}): {t['mutant']}\n    {t['how']}")
    return "\n".join(lines)
