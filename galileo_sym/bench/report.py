"""Print what was measured: tables for people, one JSON object for programs."""

import json
import math

from .core import ARRAYS, BASE, SCALARS
from .targets import with_numbers

_HELD = {True: "held", False: "not held", None: "not measured"}


def columns(lines, gap="  "):
    """Lines of cells with aligned columns; the first left, the others right."""
    widths = [max(len(line[place]) for line in lines) for place in range(len(lines[0]))]
    return "\n".join(
        gap.join([line[0].ljust(widths[0]), *(cell.rjust(w) for cell, w in zip(line[1:], widths[1:], strict=True))])
        for line in lines
    )


def number(value):
    """Three digits that mean something; a dash for what was not measured."""
    if math.isnan(value):
        return "-"
    if value and not 1e-2 <= abs(value) < 1e5:
        return f"{value:.1e}"
    return f"{value:.{max(0, 2 - math.floor(math.log10(abs(value))))}f}" if value else "0"


def shown_error(ulp, lost):
    """An error as a lower bound of the true maximum, with the share of results that are no numbers."""
    text = "-" if math.isnan(ulp) else f"≥ {number(ulp)}"
    return f"{text}, {lost:.0%} lost" if lost else text


def row_cells(rows):
    """Cells of the table of rows, a line for each case and contestant; the base apart."""
    scalars = {(row.case, row.contestant): row.ratio.median for row in rows if row.layout == SCALARS}
    for row in rows:
        if row.layout != ARRAYS or row.contestant == BASE:
            continue
        yield (
            row.case,
            row.contestant,
            number(row.ns.median),
            f"{number(row.ns.low)} to {number(row.ns.high)}",
            number(row.ratio.median),
            number(scalars.get((row.case, row.contestant), math.nan)),
            shown_error(row.ulp, row.lost),
        )


ROW_HEADINGS = ("case", "contestant", "ns", "quartiles", "× exp", "× exp, numbers", "max ulp")


def target_cells(targets):
    """Cells of the table of targets."""
    for one in targets:
        yield one.text, f"{number(one.limit)} {one.unit}".strip(), number(one.measured), _HELD[one.held]


TARGET_HEADINGS = ("target", "limit", "measured", "")


def scaling_cells(scalings):
    """Cells of the table of threads."""
    for one in scalings:
        same = "same bits" if one.same else "other bits"
        yield one.case, one.way, str(one.count), f"{number(one.gain.median)} times", same


def growth_cells(points):
    """A line for each case and contestant, a column for each number of elements, in ns an element."""
    sizes = sorted({point.count for point in points})
    found = {(point.case, point.contestant, point.count): point.ns.median for point in points}
    yield ("ns an element", "contestant", *(f"1e{round(math.log10(size))}" for size in sizes))
    for case, name in dict.fromkeys((point.case, point.contestant) for point in points):
        yield case, name, *(number(found.get((case, name, size), math.nan)) for size in sizes)


def text(document):
    """Tables for the terminal.

    Parameters
    ----------
    document : Document

    Returns
    -------
    str
    """
    parts = [columns([ROW_HEADINGS, *row_cells(document.rows)])]
    if document.scalings:
        parts.append(columns([("two threads", "way", "elements", "gain", ""), *scaling_cells(document.scalings)]))
    if document.points:
        parts.append(columns(list(growth_cells(document.points))))
    cells = [(key, number(spread.median)) for key, spread in document.latencies.items()]
    parts.append(columns([("call with numbers", "ns"), *cells]))
    parts.append(columns([TARGET_HEADINGS, *target_cells(document.targets)]))
    parts += [f"missing: {sentence}" for sentence in document.notes]
    parts += [f"problem: {sentence}" for sentence in document.problems]
    return "\n\n".join([*parts, summary(document)])


def summary(document):
    """The last line: how many targets are held."""
    count = {held: sum(one.held is held for one in document.targets) for held in _HELD}
    state = "; ".join(f"{count[held]} {word}" for held, word in _HELD.items() if count[held])
    return f"targets: {state}" + (f"; {len(document.problems)} problems" if document.problems else "")


def _plain(value):
    """What JSON can hold: tuples with names as objects, numbers that are not finite as text."""
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if hasattr(value, "_asdict"):
        return {name: _plain(part) for name, part in value._asdict().items()}
    if isinstance(value, dict):
        return {str(name): _plain(part) for name, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(part) for part in value]
    return value


def as_json(document):
    """The same as one JSON object."""
    content = _plain(document) | {"numbers": _plain(with_numbers(document.rows))}
    return json.dumps(content, indent=1, allow_nan=False)
