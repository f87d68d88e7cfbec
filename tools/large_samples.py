"""Verify the public functions at many points a stratum, and write what was found to docs/large_samples.md.

    python tools/large_samples.py [FUNCTION ...] [--points N] [--seed S] [--processes P] [--check]

Exits with 1 if anything fails, and writes no page then; of some functions only, the table is printed. An interrupted
run goes on where it stopped. `--check` only says whether the page is of the code that is emitted now; 1 if it is not.
"""

import argparse
import datetime
import hashlib
import json
import os
import sys
from pathlib import Path

from galileo_sym.files import write_whole
from galileo_sym.progress import progress_bar
from galileo_sym.verify.back_ends import available_back_ends, generated_folder
from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.judge import judge
from galileo_sym.verify.measure import Task, as_hex, evaluate, largest
from galileo_sym.verify.run import DEFAULT_SEED, samples
from galileo_sym.verify.selection import UnknownNameError, select_functions, select_strata
from galileo_sym.verify.ulp import rounded_up

ROOT = Path(__file__).resolve().parent.parent
EMITTED = ("*.py", "*.c", "*.h")
MARK = "Emitted code: "
HEAD = """\
# The public functions at many points

Made by `make large-samples` on {date}; not written by hand. Seed {seed}, {points} points in each stratum of
`galileo_sym/verify` (typical inputs, tiny and huge forces, range ends, singular places ...), {total} in all; strata
that are lists have their own number. Each back end ({back_ends}) is held against certain enclosures in ball arithmetic.
They may differ in the last place: in C multiplications are fused with additions.

Errors are sampled maxima, rounded up: the true maximum is at least about as large. Their unit is an ulp of the exact
result, but for those with a number: {units}.

{mark}{sources}.

| function | forces | output | points | worst error | stratum | back end | at |
|---|---|---|---|---|---|---|---|
"""


def digest():
    """Return a hash of the emitted code."""
    folder, total = generated_folder(), hashlib.sha256()
    for path in sorted(path for kind in EMITTED for path in folder.rglob(kind)):
        total.update(f"{path.relative_to(folder).as_posix()} {path.stat().st_size} ".encode() + path.read_bytes())
    return total.hexdigest()[:16]


def measured(sample, back_ends):
    """Return what one stratum gave: its points, what failed, and of each output the worst error and where."""
    rows, _ = judge(sample, back_ends, None)
    faults = [f"{row.back_end}: {row.verdict}, {row.measured} ulp at {row.worst}" for row in rows if row.failed]
    found = {"points": sample.size, "faults": faults, "outputs": {}}
    if faults:
        return found
    results = [(back_end.name, evaluate(sample, back_end)) for back_end in back_ends]
    for place, output in enumerate(FUNCTIONS[sample.task.function].outputs):
        worst = max(((*largest(sample, values, place), name) for name, values in results), key=lambda one: one[0])
        error, index, name = worst
        found["outputs"][output] = {"error": error, "back end": name, "at": as_hex(sample.point(index))}
    return found


def earlier(state, run):
    """Return what an interrupted run of the same kind has found, by function, force set and stratum."""
    if not state.exists():
        return {}
    first, *lines = state.read_text(encoding="utf-8").splitlines(keepends=True)
    if json.loads(first) != run:
        print("what an interrupted run found is of other code, points or seed: all is measured anew", file=sys.stderr)
        return {}
    whole = [line for line in lines if line.endswith("\n")]  # the last one may be cut off
    return {tuple(row["place"]): row for row in map(json.loads, whole)}


def explore(places, run, state, processes):
    """Return what was found in every stratum, those of an interrupted run included."""
    found = earlier(state, run)
    tasks = [Task(*place, run["points"], run["seed"]) for place in places if place not in found]
    back_ends = available_back_ends(lambda sentence: print(sentence, file=sys.stderr))
    content = [json.dumps(run), *(json.dumps(row) for row in found.values())]
    write_whole(state, ("\n".join(content) + "\n").encode())
    with progress_bar("large samples") as progress, open(state, "a", encoding="utf-8") as file:
        for done, (position, sample) in enumerate(samples(tasks, processes), 1):
            task = tasks[position]
            place = (task.function, task.force_set, task.stratum)
            found[place] = {"place": place, **measured(sample, back_ends)}
            print(json.dumps(found[place]), file=file, flush=True)
            if progress is not None:
                progress(done, len(tasks), " ".join(place))
    return {place: found[place] for place in places}, [back_end.name for back_end in back_ends]


def table(found, notes):
    """Return the table's lines: a row for each function, set of forces and output; `notes` number the units."""
    kernels = {}
    for (name, force_set, stratum), row in found.items():
        kernels.setdefault((name, force_set), []).append((stratum, row))
    lines = []
    for (name, force_set), strata in kernels.items():
        points = sum(row["points"] for _, row in strata)
        for output in FUNCTIONS[name].outputs:
            stratum, row = max(strata, key=lambda one: one[1]["outputs"][output]["error"])
            worst = row["outputs"][output]
            unit = FUNCTIONS[name].unit.get(output)
            note = f" ({notes.index(unit) + 1})" if unit else ""
            at = " ".join(f"{argument}={value}" for argument, value in worst["at"].items())
            cells = (f"`{name}`", force_set, output, points, f"≥ {rounded_up(worst['error'])}{note}", stratum)
            lines.append("| " + " | ".join(map(str, (*cells, worst["back end"], at))) + " |")
    return lines


def page(found, run, back_ends):
    """Return the page as Markdown."""
    notes = list(dict.fromkeys(unit for name, _, _ in found for unit in FUNCTIONS[name].unit.values()))
    head = HEAD.format(
        date=datetime.date.today().isoformat(),
        total=sum(row["points"] for row in found.values()),
        back_ends=", ".join(back_ends),
        units="; ".join(f"({number}) {unit}" for number, unit in enumerate(notes, 1)) or "none here",
        mark=MARK,
        **run,
    )
    return head + "\n".join(table(found, notes)) + "\n"


def check(target):
    """Say whether a page is of the code that is emitted now; the exit code."""
    text = target.read_text(encoding="utf-8") if target.exists() else ""
    held = f"{MARK}{digest()}." in text
    print(f"{target.name}: {'of the code that is emitted now' if held else 'stale; run make large-samples'}")
    return int(not held)


def arguments_of(arguments):
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="FUNCTION", help="functions or papers; all if none is given")
    parser.add_argument("--points", type=int, default=100_000, help="points to sample in each stratum")
    parser.add_argument("--seed", type=int, default=DEFAULT_SEED, help="of the sample")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--check", action="store_true", help="say whether the page is of the emitted code")
    chosen = parser.parse_args(arguments)
    if chosen.points < 1 or chosen.processes < 1:
        parser.error("--points and --processes are positive numbers")
    try:
        return chosen, select_strata(select_functions(chosen.names), ())
    except UnknownNameError as cause:
        parser.error(str(cause))


def main(arguments=None, root=ROOT) -> int:
    """Measure, tell, write; the exit code."""
    chosen, places = arguments_of(arguments)
    target, state = root / "docs" / "large_samples.md", root / "build" / "large_samples.jsonl"
    if chosen.check:
        return check(target)
    run = {"sources": digest(), "points": chosen.points, "seed": chosen.seed}
    found, back_ends = explore(places, run, state, chosen.processes)
    failed = {place: row["faults"] for place, row in found.items() if row["faults"]}
    for place, faults in failed.items():
        print(f"failed: {' '.join(place)}: {'; '.join(faults)}")
    if failed:
        state.unlink()  # what failed is measured again
        return 1
    text = page(found, run, back_ends)
    if chosen.names:
        print(text, end="")
    else:
        write_whole(target, text.encode())
        state.unlink()
    return 0


if __name__ == "__main__":
    sys.exit(main())
