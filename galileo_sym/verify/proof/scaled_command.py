"""`python -m galileo_sym.verify.proof.scaled_command`: prove the scaled layer's tables, or hold what is committed.

The scaled layer serves the public functions; its look-up is proved from the emitted C on every piece of every table.
What is committed is the worst of each table: generated/certificates/tables.json, and docs/table_proofs.md made from it.
"""

import argparse
import hashlib
import json
import os
import sys
from concurrent.futures import ProcessPoolExecutor
from math import log2

from galileo_sym.files import write_whole

from . import scaled_source, table
from .approximation import Unproved as UnprovedApproximation
from .binary64 import Overflow
from .command import said
from .emitted import RefusedSource
from .replay import Unproved
from .scaled_bounds import table_bounds

SOURCES = ("c/tables.c", "c/galileo_support.h", "c/primitives.c")
LIMIT = 2.0**-57  # of the error of hi + lo: no table may be allowed more
FAILURES = (RefusedSource, Unproved, UnprovedApproximation, Overflow)
_PAGE = """\
# Proved bounds of the scaled layer's tables

Made by `make prove` from `generated/c/tables.c` and `gs_lookup` in `generated/c/primitives.c`; `make prove-check`
refuses it if they have changed. The public functions evaluate their primitives by these tables, as pairs hi + lo; the
NumPy back end has the same bits. Upper bounds over all pieces and all x + x_lo in them, relative to the value (absolute
on the first piece of log1p, where the value is 0 at 0):

- **approximation**: the error of the pieces' exact polynomials (ball arithmetic);
- **rounding**: that of all operations of `gs_lookup` (exact replay, line by line);
- **pair**: the error of hi + lo, both halves joined.

Taken for granted: IEEE binary64 to nearest, a compiler that keeps every operation (`-ffp-contract=off`), and a correct
`fma`.

| table | pieces | from 0 to | approximation | rounding | pair | worst piece |
| --- | ---: | ---: | ---: | ---: | ---: | ---: |
"""


def json_path():
    """Return where the committed bounds are."""
    return table.folder() / "certificates" / "tables.json"


def page_path():
    """Return where their page is."""
    return table.folder().parent / "docs" / "table_proofs.md"


def source(folder):
    """Return the parsed C of the scaled layer, and the SHA-256 of what is proved: of the look-up, and of each table."""
    parsed = scaled_source.read(*((folder / name).read_bytes().decode() for name in SOURCES))
    hashes = {name: _hash(found.pieces, found.end) for name, found in parsed.tables.items()}
    return parsed, _hash(parsed.lookup), hashes


def _hash(*parts):
    return hashlib.sha256(repr(parts).encode()).hexdigest()


def record(rows):
    """Return the record of a table: the worst of each bound over its pieces.

    Parameters
    ----------
    rows : list of TableBound

    Returns
    -------
    dict
        Ready for JSON; every number is rounded up.
    """
    worst = max(rows, key=lambda row: row.pair)
    return {
        "pieces": len(rows),
        "end": float(rows[-1].upper),
        "approximation": table.relative(max(row.approximation for row in rows)),
        "rounding": table.relative(max(row.rounding for row in rows)),
        "pair": table.relative(worst.pair),
        "worst": worst.piece,
    }


def page(known):
    """Return the page of a tables.json, the worst table first."""

    def exponent(bound):
        return f"2^{log2(bound):.2f}"

    lines = []
    for name, found in sorted(known["tables"].items(), key=lambda item: -item[1]["pair"]):
        bounds = (exponent(found[part]) for part in ("approximation", "rounding", "pair"))
        cells = (name, str(found["pieces"]), f"{found['end']:.6g}", *bounds, str(found["worst"]))
        lines.append(f"| {' | '.join(cells)} |\n")
    return _PAGE + "".join(lines)


def stale(known, folder, text):
    """Say what is wrong with the committed bounds, without proving them anew.

    Parameters
    ----------
    known : dict or None
        The content of tables.json.
    folder : Path
        The emitted code.
    text : str
        Of docs/table_proofs.md.

    Returns
    -------
    list of str
        One line a fault: another look-up or table, one without a bound, a bound above the limit, another page.
    """
    if known is None:
        return ["there are no proved bounds of the scaled layer's tables"]
    _, lookup, hashes = source(folder)
    faults = [] if known["lookup"] == lookup else ["gs_lookup has changed since its bounds were proved"]
    tables = known["tables"]
    faults += [f"the table {name} has no proved bound" for name in sorted(set(hashes) - set(tables))]
    faults += [f"the table {name} is proved and not emitted" for name in sorted(set(tables) - set(hashes))]
    for name in sorted(set(tables) & set(hashes)):
        if tables[name]["sha256"] != hashes[name]:
            faults.append(f"the table {name} has changed since its bound was proved")
        if not tables[name]["pair"] <= LIMIT:
            faults.append(f"the table {name} errs by up to {tables[name]['pair']}, more than the {LIMIT} allowed")
    if text != page(known):
        faults.append("docs/table_proofs.md does not show the committed bounds")
    return faults


def _prove(lookup, found):
    try:
        return record(table_bounds(lookup, found)), None
    except FAILURES as cause:
        return None, f"the table {found.name}: {cause}"


def _proved(parsed, names, hashes):
    """Prove the tables named, the long ones first, on all cores; return the records and what failed."""
    order = sorted(names, key=lambda name: -len(parsed.tables[name].pieces))
    records, faults = {}, []
    with ProcessPoolExecutor(max_workers=os.cpu_count()) as pool:
        made = pool.map(_prove, [parsed.lookup] * len(order), [parsed.tables[name] for name in order])
        for name, (found, fault) in zip(order, made, strict=True):
            if fault:
                faults.append(fault)
                continue
            records[name] = {"sha256": hashes[name], **found}
            print(f"{name:18} {found['pieces']:4} pieces, hi + lo within 2^{log2(found['pair']):.2f}", flush=True)
    return records, faults


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
    parser = argparse.ArgumentParser(prog="python -m galileo_sym.verify.proof.scaled_command", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="TABLE", help="tables to prove, writing nothing; all by default")
    parser.add_argument("--check", action="store_true", help="hold the committed bounds against the emitted C")
    chosen = parser.parse_args(argv)
    folder, committed, shown = table.folder(), json_path(), page_path()
    try:
        if chosen.check:
            known = json.loads(committed.read_text(encoding="utf-8")) if committed.is_file() else None
            text = shown.read_text(encoding="utf-8") if shown.is_file() else ""
            return said(stale(known, folder, text), "prove anew: make prove")
        parsed, lookup, hashes = source(folder)
    except RefusedSource as cause:
        return said([str(cause)], "nothing is proved")
    if unknown := [name for name in chosen.names if name not in parsed.tables]:
        parser.error(f"no table {', '.join(unknown)}; there are {', '.join(parsed.tables)}")
    records, faults = _proved(parsed, chosen.names or list(parsed.tables), hashes)
    if not faults and not chosen.names:
        known = {"lookup": lookup, "tables": {name: records[name] for name in parsed.tables}}
        write_whole(committed, (json.dumps(known, indent=1) + "\n").encode())
        write_whole(shown, page(known).encode())
    return said(faults, "nothing was written")


if __name__ == "__main__":
    sys.exit(main())
