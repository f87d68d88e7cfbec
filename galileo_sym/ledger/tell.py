"""An entry told in words and formulas, for a terminal."""

from __future__ import annotations

import sympy as sp

from .book import Ledger
from .check import POINTS

WIDTH = 150  # of a line of the chain; longer statements are cut


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


def tell_chain(entry, ledger) -> str:
    """What an entry stands on, laws and definitions first: a line for each statement, as derived."""
    wanted = {e.id for e in ledger.with_premises([entry])} - {entry.id}
    below = [e for e in ledger.in_order() if e.id in wanted]
    if not below:
        return ""
    width = max(len(e.id) for e in below)
    lines = [f"    {e.id:{width}s}  {_cut(_flat(e.result), WIDTH - width)}" for e in below]
    return "\n".join(["  stands on, in the order of derivation (tell each with its own id)", *lines]) + "\n"


def _cut(text, width):
    return text if len(text) <= width else text[: width - 1] + "…"


def _flat(expr):
    return sp.sstr(expr)


def tell_chapter(name: str) -> None:
    """Print the derivations of a chapter: what a chapter does when it is run as a script."""
    for entry in Ledger.load().select([name]):
        print(tell(entry))
