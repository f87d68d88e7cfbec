"""What is committed of the runs: a row a primitive, with date, machine and sources; and the page made of it."""

import json
import platform
from datetime import datetime, timezone
from importlib.metadata import version
from math import log2
from pathlib import Path

from exhaustive import certain
from exhaustive.emitted import digest, singles_digest
from galileo_sym import processor
from galileo_sym.files import write_whole
from galileo_sym.primitives.kernels import KERNELS

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "tests" / "data" / "exhaustive.json"
PAGE = ROOT / "docs" / "exhaustive.md"
FAULTS = ("wrong", "unsettled", "differing")

INTRODUCTION = """# Every binary32 input

Made by `make exhaustive`, `make same-bits` and `make singles`; not written by hand.

Each primitive's binary32 function is tried at all 2^32 inputs. A value is right if it is the float nearest to the exact
one; NaN for NaN and for what is outside of the domain; the limit at 0, -0 and infinity. The reference solves the
definition in double-double (`tools/exhaustive/`: power series, doubling of the argument, Newton's method; no
coefficient of ours, nothing of libm but square roots) and errs by less than 2^-64, relatively. What lies within 2^-50
of a midpoint of two floats is settled by the sign of the definition in Arb balls instead. In one of sixteen stretches
of 256 inputs the other vector version for this machine is held to the same bits.
"""


SAME_BITS = """Random bits of all numbers, dense ones where most arguments lie, and the hard cases of `tests/data/`, in
every version by every compiler: plain C99, one number at a time with FMA, AVX2, AVX-512, as far as the machine goes."""


SINGLES = """What `gs_special_NAME_nf` calls is quicker: plain double arithmetic where that settles the rounding, else
the pairs that are tried above. Here both are held to the same bits: in the widest version at all 2^32 inputs, with four
lanes in one of 16 stretches of 2^20 inputs, with one in one of 256."""


def stamp():
    """Return what is said of every run: day, machine, versions."""
    return {
        "date": datetime.now(timezone.utc).date().isoformat(),
        "machine": processor.name(),
        "python": platform.python_version(),
        "flint": version("python-flint"),
    }


def kept():
    """Return the committed results by kind, each {primitive: row}."""
    empty = {"exhaustive": {}, "same_bits": {}, "singles": {}}
    return empty | json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else empty


def faults(found):
    """Return how many inputs are at fault."""
    return sum(found[kind] for kind in FAULTS)


def stale(name, what="exhaustive"):
    """Return whether the committed result of a primitive is missing, or of other sources than the emitted ones."""
    of = singles_digest if what == "singles" else digest
    return kept()[what].get(name, {}).get("sources") != of(name)


def _keep(what, name, row):
    result = kept()
    result[what][name] = row
    result[what] = {key: result[what][key] for key in KERNELS if key in result[what]}
    write_whole(KEPT, (json.dumps(result, indent=1) + "\n").encode())
    write_whole(PAGE, page(result).encode())


def keep_exhaustive(found, sources):
    """Commit the result of a whole run."""
    inputs = {kind: [f"{bits:08x}" for bits in found["inputs"][kind]] for kind in ("hard", *FAULTS)}
    _keep("exhaustive", found["primitive"], {**found, "inputs": inputs, "sources": sources, **stamp()})


def keep_same_bits(name, row, sources):
    """Commit the result of a comparison of versions."""
    _keep("same_bits", name, {**row, "sources": sources, **stamp()})


def keep_singles(name, row, sources):
    """Commit the result of a comparison of the quick functions with those by pairs."""
    _keep("singles", name, {**row, "sources": sources, **stamp()})


def _table(head, rows):
    return ["| " + " | ".join(row) + " |" for row in (head, ["---"] * len(head), *rows)]


def _exhaustive_row(name, row):
    distance, bits = row["nearest"]
    return [
        name,
        str(row["right"] + row["refused"] + row["by_arb"] + faults(row)),
        *(str(row[key]) for key in ("right", "by_arb", "refused", *FAULTS)),
        f"2^{log2(distance):.1f} at {certain.of_bits(bits).hex()}",
        f"{row['seconds']:.0f} s",
        row["date"],
        row["sources"][:16],
    ]


def page(result):
    """Return the page as text."""
    heads = ["primitive", "inputs", "right by the reference", "right by Arb", "NaN, as due", *FAULTS]
    heads += ["nearest midpoint, by the reference", "elapsed on one busy core", "date", "sources"]
    lines = [INTRODUCTION, *_table(heads, [_exhaustive_row(n, r) for n, r in result["exhaustive"].items()]), ""]
    lines += ["## The same bits", "", SAME_BITS, ""]
    heads = ["primitive", "inputs in binary64", "in binary32", "versions", "other bits", "time", "date", "sources"]
    rows = [
        [
            name,
            f"{row['binary64']}",
            f"{row['binary32']}",
            ", ".join(row["versions"]),
            str(row["differing"]),
            f"{row['seconds']:.0f} s",
            row["date"],
            row["sources"][:16],
        ]
        for name, row in result["same_bits"].items()
    ]
    lines += [*_table(heads, rows), "", "## The quick functions", "", SINGLES, ""]
    heads = ["primitive", "inputs", "other bits", "time", "date", "sources"]
    rows = [
        [
            name,
            ", ".join(f"{version} {count}" for version, count in row["inputs"].items()),
            str(row["differing"]),
            f"{row['seconds']:.0f} s",
            row["date"],
            row["sources"][:16],
        ]
        for name, row in result["singles"].items()
    ]
    lines += [*_table(heads, rows), ""]
    machines = sorted({r["machine"] for rows in result.values() for r in rows.values()})
    lines += [f"Machine: {'; '.join(machines)}.", ""]
    return "\n".join(lines)
