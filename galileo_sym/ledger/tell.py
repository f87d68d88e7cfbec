"""An entry told in words and formulas, for a terminal."""

from __future__ import annotations

import sympy as sp

from .book import Ledger
from .check import POINTS


def tell(entry) -> str:
    """The derivation of an entry: statement, assumptions, premises, steps, result, verdict."""
    lines = [
        f"{entry.id}  {entry.label}",
        f"  printed   {_flat(entry.printed)}",
        f"  assuming  {_flat(entry.assumptions)}",
    ]
    if entry.premises:
        lines.append(f"  from      {', '.join(entry.premises)}")
    if entry.doc:
        lines += [f"  {line}" for line in entry.doc.splitlines()]
    for number, step in enumerate(entry.steps, 1):
        lines += [f"    {number}. {step.text}", f"       {_flat(step.statement)}"]
    if entry.steps and entry.verdict.holds:
        points = len(entry.declaration.domain.points(POINTS, entry.id))
        lines.append(f"    (each step holds at {points} points of the assumptions, to 50 digits)")
    if entry.declaration.function is not None and entry.result is not None:
        lines.append(f"  result    {_flat(entry.result)}")
    lines.append(f"  verdict   {entry.verdict}")
    if entry.erratum:
        lines.append(f"  erratum   {', '.join(entry.erratum.ids)}: {entry.erratum.text}")
        if entry.erratum_verdict:
            lines += [f"            printed: {_flat(entry.erratum.printed)}", f"            {entry.erratum_verdict}"]
    return "\n".join(lines) + "\n"


def _flat(expr):
    return sp.sstr(expr)


def tell_chapter(name: str) -> None:
    """Print the derivations of a chapter: what a chapter does when it is run as a script."""
    for entry in Ledger.load().select([name]):
        print(tell(entry))
