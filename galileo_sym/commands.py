"""What each command of the command line does, and prints."""

from __future__ import annotations

import json
import os
import sys
from contextlib import nullcontext, redirect_stdout
from importlib.util import find_spec
from io import StringIO
from pathlib import Path

from galileo_sym.names import UnknownEntry
from galileo_sym.progress import progress_bar
from galileo_sym.rows import as_row, holds, listing

PROCESSES = min(2, os.cpu_count() or 1)
SCENES = "scenes"  # beside the names of functions, where errors are measured


class UsageError(Exception):
    """The command cannot be carried out as it was called; the message gives cause and remedy."""


def derive(options) -> int:
    """Say of each entry whether it is proved: in rows, at length, in tables, in a drawing."""
    from galileo_sym.kept import known_rows
    from galileo_sym.store import Store

    if options.coverage and options.names:
        raise UsageError("--coverage counts the whole of both papers: name no entries with it")
    store = Store()
    try:
        rows = None if options.fresh or options.show else known_rows(options.names, store)
        told = None
        if rows is None:
            rows, told = _derived(options, store)
    except UnknownEntry as problem:
        raise UsageError(problem) from None
    missing = _coverage(rows, options.json) if options.coverage else []
    if options.json:
        print(json.dumps(told or rows, indent=2))
    elif not options.coverage:
        print("\n".join(told) if told else listing(rows))
    if options.graph:
        print(*_drawn(rows, options.output), sep="\n", file=sys.stderr)
    return 0 if all(map(holds, rows)) and not missing else 1


def _derived(options, store):
    """Rows, and what --show tells; None without it."""
    from galileo_sym.findings import judged
    from galileo_sym.ledger import tell, tell_chain

    with _bar(options, "derive") as progress:
        ledger, entries = judged(options.names, store, fresh=options.fresh, progress=progress)
    rows = [as_row(e) for e in entries]
    if not options.show:
        return rows, None
    if options.json:
        return rows, [row | _steps(entry) for row, entry in zip(rows, entries, strict=True)]
    return rows, [tell(e) + tell_chain(e, ledger) for e in entries]


def _steps(entry):
    return {"steps": [{"text": step.text, "statement": str(step.statement)} for step in entry.steps]}


def _coverage(rows, quiet):
    """Print the tables; returns the items that have no sound entry."""
    from galileo_sym import coverage
    from galileo_sym.ledger.inventory import inventory

    if not quiet:
        print(coverage.tables(rows, inventory()))
    missing = coverage.gaps(rows, inventory())
    if missing:
        print(f"not proved: {', '.join(missing)}", file=sys.stderr)
    return missing


def _drawn(rows, folder):
    from galileo_sym import graph

    return graph.write(rows, folder or ".")


def _bar(options, title):
    return nullcontext() if options.json else progress_bar(title)


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
    contenders = _contenders() if options.typed_in else []
    if find_spec("flint") is None:
        raise UsageError("references are computed with Arb by python-flint: pip install python-flint")
    codes, told = [], {}
    functions = [name for name in options.names if name != SCENES]
    if functions or not options.names:
        with redirect_stdout(StringIO()) if options.json else nullcontext() as text:
            codes.append(_verify_functions(options, functions, contenders))
        if codes == [2]:
            return 2
        told = json.loads(text.getvalue()) if options.json else {}
    if SCENES in options.names or not (options.names or options.stratum):
        rows, problems = _verify_scenes(options)
        codes.append(1 if problems else 0)
        told[SCENES] = {"held": not problems, "problems": problems, "rows": rows}
    if options.json:
        print(json.dumps(told, indent=2))
    return max(codes)


def _verify_functions(options, names, contenders):
    from galileo_sym.verify import run

    with _bar(options, "verify") as progress:
        return run.run(
            names,
            points=options.points or run.DEFAULT_POINTS,
            seed=run.DEFAULT_SEED if options.seed is None else options.seed,
            update=options.update,
            json_output=options.json,
            strata=options.stratum,
            progress=progress,
            processes=PROCESSES,
            contenders=contenders,
        )


def _verify_scenes(options):
    """Rows and problems of the certificate of scenes; printed if they are not to be JSON."""
    from galileo_sym import scene_certificate as certificate

    seed = certificate.SEED if options.seed is None else options.seed
    rows, problems = certificate.verify(options.points or certificate.POINTS, seed, options.update)
    if not options.json:
        certificate.tell(rows, problems)
    return rows, problems


def _contenders():
    """The printed formulas as they are; SciPy has the Lambert W that they need."""
    if find_spec("scipy") is None:
        raise UsageError("--typed-in evaluates the printed formulas with SciPy: pip install scipy")
    from galileo_sym.typed_in import TypedIn

    return [TypedIn()]


_FOR_BENCH = {
    "flint": "errors are measured against Arb by python-flint: pip install python-flint",
    "scipy": "printed formulas are evaluated with SciPy: pip install scipy",
}


def bench(options) -> int:
    """Measure run time against error."""
    for package, need in _FOR_BENCH.items():
        if find_spec(package) is None:
            raise UsageError(need)
    docs = Path("docs")
    if options.publish and not docs.is_dir():
        raise UsageError("--publish renews a page in docs/: run it at the top of the repository")
    if options.publish and find_spec("matplotlib") is None:
        raise UsageError("--publish draws with matplotlib: pip install matplotlib")
    from galileo_sym.bench.run import run

    with _bar(options, "bench") as progress:
        return run(
            options.functions,
            rounds=options.rounds,
            points=options.points,
            quick=options.quick,
            with_peers=options.peers,
            with_growth=options.growth,
            strict=options.strict,
            output=options.output,
            publish=docs if options.publish else None,
            json_output=options.json,
            progress=progress,
        )


def scene(options) -> int:
    """Say what a scene computes, or write it as a file."""
    from galileo_sym.scenes import Scene

    constants = dict(options.set)
    if len(constants) < len(options.set):
        raise UsageError("--set names a constant twice: leave out one of them")
    if bool(options.emit) != bool(options.output):
        raise UsageError("--emit LANGUAGE and -o PATH go together: give both")
    try:
        shown = Scene(options.system, over=options.over, outputs=options.outputs, until=options.until, **constants)
        lengths = dict(map(_length, options.lengths or []))
        told = shown.explain(**lengths)
        counts = shown.cost(**(lengths or dict.fromkeys(shown.over, 1)))
        if options.emit:
            shown.emit(options.emit, options.output)
    except (TypeError, ValueError) as problem:
        raise UsageError(problem) from None
    if options.json:
        told = json.dumps(_as_document(shown, counts), indent=2)
    print(told if options.json or not options.emit else options.output)
    return 0


def _length(text):
    name, _, number = text.partition("=")
    if not number.isdigit():
        raise UsageError(f"--lengths {text}: write the name of an axis, '=' and a whole number")
    return name, int(number)


def _as_document(shown, counts):
    """A scene and its plan, as JSON can hold them."""
    steps = [
        {"name": step.name, "over": step.axes, "operation": step.operation, "gives": step.text}
        for step in (*shown.plan.steps, *shown.plan.all_results)
    ]
    return {
        "system": shown.system,
        "forces": shown.forces,
        "over": shown.over,
        "outputs": shown.outputs,
        "until": shown.until,
        "constants": shown.constants,
        "steps": steps,
        "counts": [{"over": axes, **found} for axes, found in counts.items()],
    }


DEFAULTS = {
    "names": [],
    "show": False,
    "coverage": False,
    "graph": False,
    "check": False,
    "output": None,
    "points": None,
    "seed": None,
    "stratum": [],
    "update": False,
    "typed_in": False,
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


COMMANDS = {"derive": derive, "emit": emit, "verify": verify, "bench": bench, "scene": scene, "all": everything}
