"""`galileo-sym bench`: measure, tell, and write what was measured."""

import difflib
import sys
from pathlib import Path
from typing import NamedTuple

from galileo_sym.files import write_whole
from galileo_sym.libraries import CompilationError

from . import core, growth, parallel, plot, report, small, targets
from .cases import SPECIAL, TYPICAL, cases
from .contestants import ours
from .machine import stamp
from .page import page
from .peers import peers
from .typed import Lambdified, SciPy


class Plan(NamedTuple):
    """How much is measured.

    Attributes
    ----------
    size : Size
        Of the core.
    long : int
        Elements for threads.
    sizes : tuple of int
        Elements for throughput.
    rounds : int
        For long arrays, and for imports.
    """

    size: core.Size
    long: int
    sizes: tuple
    rounds: int


WHOLE = Plan(core.Size(10_000, 31, 1000), 10_000_000, growth.THROUGHPUT, 7)
QUICK = Plan(core.Size(1000, 5, 60), 100_000, growth.THROUGHPUT[:3], 3)


class Document(NamedTuple):
    """All that was measured, as it goes into JSON."""

    stamp: dict
    way: str
    size: core.Size
    rows: list
    scalings: list
    latencies: dict
    imported: small.Import
    points: list
    targets: list
    notes: list
    problems: list


class UnknownNameError(Exception):
    """A name is not known; the message gives the nearest ones."""


def chosen_cases(names):
    """The cases of functions.

    Parameters
    ----------
    names : sequence of str
        Functions by full name, papers, ``special``; all if empty.

    Raises
    ------
    UnknownNameError
        With the nearest names.
    """
    every = list(cases().values())
    known = {name for case in every for name in (case.full_name, case.paper)}
    for name in names:
        if name not in known:
            near = difflib.get_close_matches(name, sorted(known), n=3, cutoff=0.4)
            raise UnknownNameError(f"unknown function {name!r}; nearest: {', '.join(near or sorted(known))}")
    return [case for case in every if not names or {case.full_name, case.paper} & set(names)]


def _gather(chosen, plan, with_peers, sizes, notes, problems, progress):
    """Measure everything; the parts of a `Document` from `way` to `targets`."""
    own = ours(notes.append)
    contestants = [*own, Lambdified(), SciPy(), *(peers(chosen, notes.append) if with_peers else [])]
    found = core.measure(chosen, contestants, {one.name for one in own}, plan.size, progress)
    by_name = {one.name: one for one in own}
    fast = by_name.get(targets.OURS, by_name[targets.NUMPY])
    keys = {case.key: case for case in chosen}
    in_threads = [keys[key] for key in parallel.CASES if key in keys]
    scalings = parallel.measure(in_threads, fast, plan.long, plan.rounds, plan.size.points, notes.append)
    problems += [f"{one.contestant}, {one.case}: other bits by {one.way}" for one in scalings if not one.same]
    public = [case for case in chosen if case.paper != SPECIAL and case.stratum == TYPICAL]
    latencies = small.latency(public, plan.size.rounds)
    imported = small.importing(plan.rounds)
    long = [by_name[name] for name in (targets.OURS, targets.NUMPY) if name in by_name]
    in_growth = [keys[key] for key in growth.CASES if key in keys]
    points = growth.measure(in_growth, long, sizes, plan.rounds, plan.size.points, notes.append, progress)
    problems += found.problems
    notes += found.notes
    held = targets.of_rows(found.rows) + targets.of_rest(scalings, latencies, imported)
    return fast.way, plan.size, found.rows, scalings, latencies, imported, points, held


def run(
    names=(),
    *,
    rounds=None,
    points=None,
    quick=False,
    with_peers=False,
    with_growth=False,
    strict=False,
    output=None,
    publish=None,
    json_output=False,
    progress=None,
    out=None,
    err=None,
):
    """Measure run time and error of all contestants.

    Parameters
    ----------
    names : sequence of str
        Functions by full name, papers, ``special``; all if empty.
    rounds : int, optional
        Interleaved rounds.
    points : int, optional
        Elements of an array.
    quick : bool
        Fewer rounds, shorter arrays, fewer sampled points.
    with_peers : bool
        Also the printed formulas compiled with other libraries' Lambert W.
    with_growth : bool
        Arrays from 1 to 1e8 elements, as far as memory allows.
    strict : bool
        A target that is not held counts as a failure.
    output : Path, optional
        Folder for bench.json and bench.svg; build/bench by default.
    publish : Path, optional
        Folder in which benchmark.md and benchmark.svg are renewed.
    json_output : bool
        Print one JSON object instead of tables.
    progress : callable, optional
        Called with (done, in all, what comes next).
    out, err : text files, optional
        Standard output and standard error by default.

    Returns
    -------
    int
        0 if all was measured; 1 if the package's own code fails, or if `strict` and a target is not held; 2 on unknown
        names.
    """
    out, err = out or sys.stdout, err or sys.stderr
    plan = QUICK if quick else WHOLE
    size = plan.size._replace(points=points or plan.size.points, rounds=rounds or plan.size.rounds)
    plan = plan._replace(size=size)
    try:
        chosen = chosen_cases(names)
    except UnknownNameError as cause:
        print(f"galileo-sym bench: {cause}", file=err)
        return 2
    when, notes, problems = stamp(), [], []
    sizes = growth.GROWTH if with_growth else plan.sizes
    try:
        parts = _gather(chosen, plan, with_peers, sizes, notes, problems, progress)
    except CompilationError as cause:
        print(f"galileo-sym bench: {cause}", file=err)
        return 1
    document = Document(when, *parts, notes, problems)
    print(report.as_json(document) if json_output else report.text(document), file=out)
    for place in _write(document, Path(output or "build/bench"), publish):
        print(f"written: {place}", file=err)
    failed = problems or (strict and any(one.held is False for one in document.targets))
    return 1 if failed else 0


def _write(document, folder, publish):
    """Write JSON, plot and page; what was written."""
    write_whole(folder / "bench.json", (report.as_json(document) + "\n").encode())
    written = [folder / "bench.json"]
    drawn = plot.can_plot() and plot.pareto(document.rows, document.stamp, folder / "bench.svg")
    if drawn:
        written.append(folder / "bench.svg")
    if publish is not None:
        write_whole(publish / "benchmark.md", page(document, "benchmark.svg" if drawn else None).encode())
        written.append(publish / "benchmark.md")
    if publish is not None and drawn:
        write_whole(publish / "benchmark.svg", (folder / "bench.svg").read_bytes())
        written.append(publish / "benchmark.svg")
    return written
