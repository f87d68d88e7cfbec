"""What each command of the command line does, and prints."""

from __future__ import annotations

import json
import os
import sys
from collections import Counter
from contextlib import nullcontext, redirect_stdout
from io import StringIO

from galileo_sym.progress import progress_bar

PROCESSES = min(2, os.cpu_count() or 1)


class UsageError(Exception):
    """The command cannot be carried out as it was called; the message gives cause and remedy."""


def derive(options) -> int:
    """Rerun derivations and print a row for each, or tell them."""
    from galileo_sym.ledger import Ledger, UnknownEntry, tell, tell_chain

    ledger = Ledger.load()
    try:
        entries = ledger.select(options.names)
    except UnknownEntry as problem:
        raise UsageError(problem) from None
    with _bar(options, "derive") as progress:
        ledger.judge(entries, PROCESSES, progress)
    if options.json:
        print(json.dumps([_as_row(e) | (_steps(e) if options.show else {}) for e in entries], indent=2))
    elif options.show:
        print("\n".join(tell(e) + tell_chain(e, ledger) for e in entries))
    else:
        _print_table(entries)
    return 0 if all(_holds(e) for e in entries) else 1


def _bar(options, title):
    return nullcontext() if options.json else progress_bar(title)


def _holds(entry):
    """The verdict is sound, and what the erratum says to be false in print is refuted."""
    printed = entry.erratum_verdict
    return entry.verdict.holds and (printed is None or printed.kind.value == "refuted")


def _as_row(entry):
    verdict, printed = entry.verdict, entry.erratum_verdict
    row = {
        "id": entry.id,
        "paper": entry.paper,
        "kind": entry.kind,
        "label": entry.label,
        "verdict": verdict.kind.value,
        "method": verdict.method,
        "premises": list(entry.premises),
        "seconds": round(verdict.seconds, 3),
        "counterexample": verdict.counterexample and dict(verdict.counterexample),
    }
    if entry.erratum:
        row["erratum"] = {
            "ids": list(entry.erratum.ids),
            "text": entry.erratum.text,
            "printed": printed and printed.kind.value,
        }
    return row


def _steps(entry):
    return {"steps": [{"text": step.text, "statement": str(step.statement)} for step in entry.steps]}


def _print_table(entries):
    width = max((len(e.id) for e in entries), default=0)
    for entry in entries:
        verdict = entry.verdict
        note = f"  erratum {', '.join(entry.erratum.ids)}" if entry.erratum else ""
        print(f"{entry.id:{width}s}  {verdict.kind.value:10s}  {verdict.seconds:6.2f} s  {verdict.method}{note}")
        if verdict.counterexample:
            print(" " * width + f"  at {', '.join(f'{k} = {v}' for k, v in verdict.counterexample.items())}")
        if entry.erratum_verdict and entry.erratum_verdict.kind.value != "refuted":
            print(" " * width + f"  the printed form is not refuted: {entry.erratum_verdict}")
    counts = Counter(e.verdict.kind.value for e in entries)
    print(f"{len(entries)} entries: " + ", ".join(f"{n} {kind}" for kind, n in counts.most_common()))


def emit(options) -> int:
    """Write generated/, or say what in it differs from what would be written."""
    from galileo_sym.catalogue import NotDerived
    from galileo_sym.codegen import emit as writer

    try:
        if options.check:
            lines, key, none = writer.check(options.output), "differences", "up to date"
        else:
            lines, key, none = writer.emit(options.output), "written", "nothing to write: up to date"
    except NotDerived as problem:
        print(f"galileo-sym emit: {problem}", file=sys.stderr)
        return 1
    except (writer.WrongVersion, OSError) as problem:
        raise UsageError(problem) from None
    print(json.dumps({key: lines}, indent=2) if options.json else "\n".join(lines or [none]))
    return 1 if options.check and lines else 0


def verify(options) -> int:
    """Measure errors in ulp, and hold them against the certificates."""
    from galileo_sym.verify import run

    with _bar(options, "verify") as progress:
        return run.run(
            options.names,
            points=options.points or run.DEFAULT_POINTS,
            seed=run.DEFAULT_SEED if options.seed is None else options.seed,
            update=options.update,
            json_output=options.json,
            strata=options.stratum,
            progress=progress,
            processes=PROCESSES,
        )


DEFAULTS = {
    "names": [],
    "show": False,
    "check": False,
    "output": None,
    "points": None,
    "seed": None,
    "stratum": [],
    "update": False,
}


def everything(options) -> int:
    """Derive, emit, verify; go on after a failure, and say at the end which failed."""
    vars(options).update(DEFAULTS)
    outcomes, documents = {}, {}
    for name in ("derive", "emit", "verify"):
        print(f"== {name}", file=sys.stderr)
        with redirect_stdout(StringIO()) if options.json else nullcontext() as text:
            outcomes[name] = COMMANDS[name](options)
        if options.json:
            documents[name] = json.loads(text.getvalue())
    if options.json:
        print(json.dumps(documents, indent=2))
    failed = [name for name, code in outcomes.items() if code]
    print(f"failed: {', '.join(failed)}" if failed else "all held", file=sys.stderr)
    return 1 if failed else 0


COMMANDS = {"derive": derive, "emit": emit, "verify": verify, "all": everything}
