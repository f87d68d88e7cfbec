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


def _ratio(row):
    return number(row.ratio.median)


def _error(row):
    """An error as a lower bound of the true maximum, with the share of results that are no numbers."""
    text = "-" if math.isnan(row.ulp) else f"≥ {number(row.ulp)}"
    return f"{text}, {row.lost:.0%} lost" if row.lost else text


def _pivoted(rows, heading, cell):
    """A line for each case, a column for each contestant, and the headings above."""
    names = list(dict.fromkeys(row.contestant for row in rows))
    found = {(row.case, row.contestant): cell(row) for row in rows}
    yield (heading, *names)
    for case in dict.fromkeys(row.case for row in rows):
        yield case, *(found.get((case, name), "-") for name in names)


def _with_spread(lines, rows):
    """With a last column: the widest quartiles of a line, as a share of the median."""
    headings, *lines = lines
    yield (*headings, "spread")
    for line in lines:
        widest = max((r.ratio.high - r.ratio.low) / r.ratio.median for r in rows if r.case == line[0])
        yield (*line, f"{widest:.0%}")


def row_tables(rows):
    """Tables of all rows: by title, lines of cells with the headings first."""
    rows = [row for row in rows if row.contestant != BASE]
    arrays, numbers = ([row for row in rows if row.layout == layout] for layout in (ARRAYS, SCALARS))
    times, fixed = _pivoted(arrays, "arrays", _ratio), _pivoted(numbers, "arrays, then numbers", _ratio)
    found = {
        "Time, × exp: all arguments arrays": _with_spread(times, arrays),
        "Time, × exp: numbers after the positional arguments": _with_spread(fixed, numbers),
        "Largest error sampled, ulp": _pivoted(arrays, "arrays", _error),
    }
    return {title: list(lines) for title, lines in found.items()}


def target_cells(targets):
    """Cells of the table of targets."""
    for one in targets:
        yield one.text, f"{number(one.limit)} {one.unit}".strip(), number(one.measured), _HELD[one.held]


TARGET_HEADINGS = ("target", "limit", "measured", "")


def _scaling_cells(scalings):
    for one in scalings:
        same = "same bits" if one.same else "other bits"
        yield one.case, one.way, str(one.count), f"{number(one.gain.median)} times", same


def _growth_cells(points):
    """A line for each case and contestant, a column for each number of elements, in ns an element."""
    sizes = sorted({point.count for point in points})
    found = {(point.case, point.contestant, point.count): point.ns.median for point in points}
    yield ("ns an element", "contestant", *(f"1e{round(math.log10(size))}" for size in sizes))
    for case, name in dict.fromkeys((point.case, point.contestant) for point in points):
        yield case, name, *(number(found.get((case, name, size), math.nan)) for size in sizes)


def tables(document):
    """All tables of a `Document`: by title, lines of cells with the headings first; empty ones are left out."""
    found = {
        "Targets": [TARGET_HEADINGS, *target_cells(document.targets)],
        **row_tables(document.rows),
        "Two threads": [("case", "way", "elements", "gain", "result"), *_scaling_cells(document.scalings)],
        "Growth": list(_growth_cells(document.points)),
        "Calls with numbers": [("case", "ns"), *((k, number(s.median)) for k, s in document.latencies.items())],
    }
    return {title: lines for title, lines in found.items() if len(lines) > 1}


def text(document):
    """Tables for the terminal, the targets last."""
    found = tables(document)
    stamp = ", ".join(f"{name} {value}" for name, value in document.stamp.items())
    parts = [stamp, *(f"{title}\n{columns(found[title])}" for title in [*list(found)[1:], "Targets"])]
    parts.append("\n".join(f"missing: {sentence}" for sentence in document.notes))
    parts.append("\n".join(f"problem: {sentence}" for sentence in document.problems))
    return "\n\n".join([*filter(None, parts), summary(document)])


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
