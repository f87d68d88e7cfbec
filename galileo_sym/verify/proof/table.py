"""The committed results: generated/certificates/proofs.json, and docs/proofs.md made from it."""

import json
from decimal import ROUND_CEILING, Context, Decimal
from importlib.util import find_spec
from pathlib import Path

from .pieces import PAIR

LIMIT = 0.75  # ulp: no primitive may be allowed more
SOURCES = ("c/galileo_kernels.h", "c/galileo_frames.h", "c/galileo_vector.h")
SERVED = ("c/galileo_loops.h", "c/galileo_blocks.h", "c/special.c")  # what stands between them and their callers
_RELATIVE = Context(prec=3, rounding=ROUND_CEILING)
_ULP = Decimal("0.0001")

_HEAD = """\
# Proved bounds of the primitives

Made by `make prove` from `generated/c/galileo_kernels.h` and `galileo_frames.h`; `make prove-check` refuses it if these
have changed.
These are upper bounds for binary64, not samples:

- **approximation**: the error of the piece's exact polynomial, relative to the function (ball arithmetic);
- **rounding**: that of all emitted operations but the last, in ulps (exact replay, line by line);
- **total**: the error of the result in ulps of the true value, the last rounding included;
- **pair**: the error of hi + lo, relative.

The form `..._near_pair` takes x + x_lo, |x_lo| no more than half an ulp of x. Far forms: the worst over all binades up
to the largest double. The ranges of a frame (`..._range0`) look banks of pieces up with arguments of their own: their
rows hold for the whole range, and a bank's errors are in them, its approximation's and what a series leaves out in the
first column; where the result is subnormal an error relative to it is no measure. The summary is of f(x), x a double.
No bound may exceed {limit} ulp. Taken for granted: IEEE binary64 to nearest, a compiler that keeps every operation
(`-ffp-contract=off`), and a correct `fma`.
"""


def folder():
    """Return the `generated` folder of this installation."""
    return Path(find_spec("galileo_sym.generated").origin).parent


def json_path():
    """Return where the committed bounds are."""
    return folder() / "certificates" / "proofs.json"


def page_path():
    """Return where the page of bounds is: docs/ stands beside generated/."""
    return folder().parent / "docs" / "proofs.md"


def _ratio(value, context):
    return context.divide(Decimal(value.numerator), Decimal(value.denominator))


def relative(value):
    """Return a rational rounded up to three digits."""
    return float(_ratio(value, _RELATIVE))


def _ulps(value):
    """Return a rational rounded up to four decimals."""
    exact = _ratio(value, Context(prec=40, rounding=ROUND_CEILING))
    return float(exact.quantize(_ULP, rounding=ROUND_CEILING))


def entry(rows):
    """Return the record of one primitive.

    Parameters
    ----------
    rows : list of Proved

    Returns
    -------
    dict
        Ready for JSON; every number is rounded up.
    """
    shown = [
        {
            "function": row.function,
            "piece": row.piece,
            "from": float(row.lower).hex(),
            "to": float(row.upper).hex(),
            "approximation": relative(row.approximation),
            "rounding": _ulps(row.rounding),
            "total": _ulps(row.total),
            "pair": relative(row.pair),
        }
        for row in rows
    ]
    public = [row["total"] for row in shown if not row["function"].endswith(PAIR)]
    return {"total": max(public), "rows": shown}


def content(hashes, entries, unknown=()):
    """Return the text of proofs.json: a line for each row; and the names of primitives that the proof does not know."""
    records = []
    for name, record in entries.items():
        rows = ",\n".join(f"   {json.dumps(row)}" for row in record["rows"])
        records.append(f'  {json.dumps(name)}: {{"total": {record["total"]}, "rows": [\n{rows}\n  ]}}')
    primitives = ",\n".join(records)
    head = f' "sha256": {json.dumps(hashes)},\n "not proved": {json.dumps(sorted(unknown))},\n'
    return f'{{\n{head} "primitives": {{\n{primitives}\n }}\n}}\n'


def _number(text):
    return f"{float.fromhex(text):.6g}"


def _line(*cells):
    return "| " + " | ".join(cells) + " |\n"


def _cells(row):
    piece = "" if row["piece"] is None else str(row["piece"])
    ends = (_number(row["from"]), _number(row["to"]))
    return (
        row["function"],
        piece,
        *ends,
        f"{row['approximation']:.3g}",
        f"{row['rounding']:.4f}",
        f"{row['total']:.4f}",
        f"{row['pair']:.3g}",
    )


def page(known):
    """Return the page of a proofs.json: a summary, then every piece of each primitive, the worst first.

    Parameters
    ----------
    known : dict
        The content of proofs.json.
    """
    heading = ("function", "piece", "from", "to", "approximation", "rounding", "total", "pair")
    rule = ("---", *("---:",) * (len(heading) - 1))
    lines = [_HEAD.format(limit=LIMIT), "\n", _line("primitive", "total"), _line("---", "---:")]
    order = sorted(known["primitives"].items(), key=lambda item: (-item[1]["total"], item[0]))
    lines += [_line(name, f"{record['total']:.4f}") for name, record in order]
    lines += [_line(name, "not proved") for name in known["not proved"]]
    for name, record in order:
        rows = sorted(record["rows"], key=lambda row: -row["total"])
        lines += [f"\n## {name}\n\n", _line(*heading), _line(*rule), *(_line(*_cells(row)) for row in rows)]
    return "".join(lines)


def read(path=None):
    """Return the content of proofs.json, or None if there is none."""
    path = json_path() if path is None else path
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None


def proved_bound(name, path=None):
    """The committed bound of a primitive's error.

    Parameters
    ----------
    name : str
        Such as "descent_factor".
    path : Path, optional
        Another proofs.json.

    Returns
    -------
    float
        In ulps of the true value, for every double x >= 0.

    Raises
    ------
    KeyError
        If no bound of that name is committed.
    """
    return (read(path) or {"primitives": {}})["primitives"][name]["total"]
