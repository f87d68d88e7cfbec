"""`python -m galileo_sym.verify.proof`: prove the bounds from the emitted C, or hold the committed ones against it."""

import argparse
import hashlib
import os
import sys
from concurrent.futures import ProcessPoolExecutor
from contextlib import nullcontext
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from galileo_sym.files import write_whole
from galileo_sym.libraries import CompilationError, NoCompilerError
from galileo_sym.verify.native import NativeLibrary

from . import table
from .approximation import Unproved as UnprovedApproximation
from .approximation_equations import EQUATIONS
from .binary64 import Overflow
from .bounds import prove
from .dispatch import primitives
from .emitted import RefusedSource, parse
from .frame_banks import Banks
from .frame_bounds import prove_frame
from .frame_dispatch import frames
from .frame_forms import FORMS
from .meanings import require_meanings
from .references import NoReference
from .replay import Unproved
from .samples import errors, frame_points, points

FAILURES = (RefusedSource, Unproved, UnprovedApproximation, Overflow, NoReference, CompilationError)


def sources_in(folder):
    """Return the texts of the C that is proved, and of what serves it, by name."""
    return {name: (folder / name).read_bytes().decode() for name in (*table.SOURCES, *table.SERVED)}


def _hashes(sources):
    """What the bounds are of: the C, and the proof itself."""
    prover = "".join(path.read_text(encoding="utf-8") for path in sorted(Path(__file__).parent.glob("*.py")))
    texts = sources | {"galileo_sym/verify/proof": prover}
    return {name: hashlib.sha256(text.encode()).hexdigest() for name, text in texts.items()}


@dataclass(frozen=True)
class Primitive:
    """How one primitive is proved and sampled."""

    prove: object
    points: object


def proofs(sources):
    """What can be proved of some C.

    Parameters
    ----------
    sources : dict of str to str
        The texts of the C by name, as from `sources_in`.

    Returns
    -------
    dict of str to Primitive
        None in place of a primitive whose definition the proof does not have.
    """
    kernels, framed, vector = (sources[name] for name in table.SOURCES)
    require_meanings(vector)
    emitted, frame = parse(kernels), parse(framed)
    banks = Banks(frame)
    known = {
        name: Primitive(partial(prove, emitted, name), partial(points, served)) if name in EQUATIONS else None
        for name, served in primitives(emitted).items()
    }
    for name, served in frames(frame).items():
        proof = Primitive(partial(prove_frame, frame, name, banks), partial(frame_points, served))
        known[name] = proof if name in FORMS else None
    return known


def _over_limit(name, record):
    return [
        f"{name}: {row['function']}, piece {row['piece']}: {row['total']} ulp, more than the {table.LIMIT} allowed"
        for row in record["rows"]
        if not row["total"] <= table.LIMIT
    ]


def stale(known, folder, page):
    """Say what is wrong with the committed bounds, without proving them anew.

    Parameters
    ----------
    known : dict or None
        The content of proofs.json.
    folder : Path
        The emitted code.
    page : str
        The text of docs/proofs.md.

    Returns
    -------
    list of str
        One line a fault: another C file, a primitive without a bound, a bound above the limit, another page.
    """
    if known is None:
        return ["there is no table of proved bounds"]
    sources = sources_in(folder)
    faults = [
        f"{name} has changed since its bounds were proved"
        for name, sha256 in _hashes(sources).items()
        if known["sha256"].get(name) != sha256
    ]
    served, proved = proofs(sources), known["primitives"]
    due = {name for name, primitive in served.items() if primitive}
    faults += [f"{name} has no proved bound" for name in sorted(due - set(proved))]
    faults += [f"{name} is proved and not emitted" for name in sorted(set(proved) - set(served))]
    if known["not proved"] != sorted(set(served) - due):
        faults.append("the primitives that are not proved are others")
    faults += [fault for name, record in proved.items() for fault in _over_limit(name, record)]
    if page != table.page(known):
        faults.append("docs/proofs.md does not show the committed bounds")
    return faults


def refuted(name, draw, bound, library, count, seed):
    """Hold a proved bound against samples.

    Parameters
    ----------
    name : str
        The primitive.
    draw : callable
        Takes count and seed; its arguments.
    bound : float
        In ulps.
    library : NativeLibrary
        The compiled primitives.
    count, seed : int
        Of the draw.

    Returns
    -------
    tuple
        The largest error found, and a list of one line if it is more than the bound, else none.
    """
    x = draw(count, seed)
    worst, at = max(zip(errors(name, x, library.primitive(name, x)), x, strict=True))
    lines = [f"{name}: {worst} ulp at {float(at).hex()}, where {bound} was proved"]
    return worst, lines if not worst <= bound else []


def _library(folder):
    try:
        return NativeLibrary(folder / "c")
    except NoCompilerError as cause:
        print(f"no samples: {cause}")
        return None


def _attempt(prove):
    """Return the record of a primitive, and why there is none."""
    try:
        return table.entry(prove()), None
    except FAILURES as cause:
        return None, cause


def _records(known, names):
    """Yield each name, its record and why there is none; several are proved on all cores, in this order."""
    with ProcessPoolExecutor(os.cpu_count()) if len(names) > 1 else nullcontext() as pool:
        for name, (record, cause) in zip(
            names, (pool.map if pool else map)(_attempt, [known[name].prove for name in names]), strict=True
        ):
            yield name, record, cause


def _proved(known, names, folder, count, seed):
    """Prove and sample; return the records by name and the lines of what failed."""
    records, faults, library = {}, [], _library(folder)
    for name in names:
        if known[name] is None:
            print(_unknown(name), flush=True)
    for name, record, cause in _records(known, [name for name in names if known[name]]):
        if cause:
            faults.append(f"{name}: {cause}")
            continue
        records[name] = record
        faults += _over_limit(name, record)
        shown = f"{name:16} {record['total']:.4f} ulp proved"
        if library:
            try:
                worst, lines = refuted(name, known[name].points, record["total"], library, count, seed)
                faults += lines
                shown += f", >= {worst:.4f} sampled"
            except FAILURES as cause:
                faults.append(f"{name}: {cause}")
        print(shown, flush=True)
    return records, faults


def _arguments(argv):
    parser = argparse.ArgumentParser(prog="python -m galileo_sym.verify.proof", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="primitives to prove, writing nothing; all by default")
    parser.add_argument("--check", action="store_true", help="hold the committed bounds against the emitted C")
    parser.add_argument("--points", type=int, default=1000, help="samples of each primitive (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the samples (default: %(default)s)")
    chosen = parser.parse_args(argv)
    if chosen.check and chosen.names:
        parser.error("--check is of the whole table: leave the names out")
    if chosen.points < 4:
        parser.error("--points: four at least")
    return parser, chosen


def main(argv=None):
    """Run the command.

    Parameters
    ----------
    argv : list of str, optional
        Arguments; those of the process by default.

    Returns
    -------
    int
        0 if all is proved (with --check: if the committed bounds are of this C), 1 if not; usage errors exit with 2.
    """
    parser, chosen = _arguments(argv)
    folder, page = table.folder(), table.page_path()
    try:
        if chosen.check:
            text, committed = page.read_text(encoding="utf-8") if page.is_file() else "", table.read()
            for name in (committed or {}).get("not proved", ()):
                print(_unknown(name))
            return said(stale(committed, folder, text), "prove anew: make prove")
        sources = sources_in(folder)
        known = proofs(sources)
        if unknown := [name for name in chosen.names if name not in known]:
            parser.error(f"no primitive {', '.join(unknown)}; there are {', '.join(known)}")
        records, faults = _proved(known, chosen.names or known, folder, chosen.points, chosen.seed)
    except FAILURES as cause:
        return said([str(cause)], "nothing is proved")
    if not faults and not chosen.names:
        write_whole(table.json_path(), table.content(_hashes(sources), records, set(known) - set(records)).encode())
        write_whole(page, table.page(table.read()).encode())
    return said(faults, "nothing was written")


def _unknown(name):
    return f"{name:16} not proved: its definition is not in approximation_equations.py or frame_forms.py"


def said(faults, advice):
    """Print what failed and what to do, and return the exit code."""
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults:
        print(advice, file=sys.stderr)
    return 1 if faults else 0
