"""Print what verification found: a table for people, JSON for programs."""

import json
import math

_HEADINGS = ("function", "forces", "stratum", "points", "back end", "max ulp", "bound", "verdict", "worst input")


def _cells(row):
    worst = " ".join(f"{name}={value}" for name, value in row.worst.items())
    measured = f"≥ {row.measured:.3g}" + (f" ({row.output})" if row.output in {"x", "y", "X", "Y", "R"} else "")
    place = (row.function, row.force_set, row.stratum, str(row.points), row.back_end)
    return (*place, measured, "" if row.compared else f"{row.bound:g}", row.verdict, worst)


def table(rows):
    """The rows as lines of text with aligned columns.

    Parameters
    ----------
    rows : list of Row
        In the order to be shown.
    """
    lines = [_HEADINGS, *map(_cells, rows)]
    # the worst input comes last and is as long as it is
    widths = [max(len(line[column]) for line in lines) for column in range(len(_HEADINGS) - 1)]
    return "\n".join(
        "  ".join([*(cell.ljust(width) for cell, width in zip(line, widths, strict=False)), line[-1]]) for line in lines
    )


def _finite(value):
    return value if math.isfinite(value) else str(value)


def as_json(rows, problems, notes, seed, held):
    """The same as one JSON object; infinite errors are written as the string "inf"."""
    content = {
        "held": held,
        "seed": seed,
        "notes": notes,
        "problems": problems,
        "rows": [{**row.as_dict(), "measured": _finite(row.measured), "bound": _finite(row.bound)} for row in rows],
    }
    return json.dumps(content, indent=2, allow_nan=False)


def summary(rows, problems, updated):
    """The last lines for people: problems, and whether all held."""
    failed = [row for row in rows if row.failed]
    lines = [f"problem: {problem}" for problem in problems]
    lines.extend(
        f"failed: {row.function} [{row.force_set}] {row.stratum}, {row.back_end}: {row.verdict}" for row in failed
    )
    lines.extend(f"certificate written: {name}" for name in updated)
    rows = [row for row in rows if not row.compared]
    points = sum(row.points for row in rows)
    state = "all held" if not failed and not problems else f"{len(failed)} failed, {len(problems)} problems"
    lines.append(f"{len(rows)} strata, {points} points: {state}")
    return "\n".join(lines)
