"""Entries as plain rows: what `galileo-sym derive` prints, and keeps from one run to the next."""

from __future__ import annotations

from collections import Counter


def as_row(entry) -> dict:
    """An entry with its verdict, and that of the printed slip, in what JSON can hold."""
    verdict = entry.verdict
    row = {
        "id": entry.id,
        "paper": entry.paper,
        "chapter": entry.chapter.name,
        "kind": entry.kind,
        "label": entry.label,
        "verdict": verdict.kind.value,
        "method": verdict.method,
        "premises": list(entry.premises),
        "seconds": round(verdict.seconds, 3),
        "counterexample": verdict.counterexample and dict(verdict.counterexample),
    }
    if entry.erratum:
        row["erratum"] = {"ids": list(entry.erratum.ids), "text": entry.erratum.text, **_printed(entry.erratum_verdict)}
    return row


def _printed(verdict):
    """The verdict of the statement as printed; None where nothing printed is false."""
    if verdict is None:
        return {"printed": None, "method": "", "counterexample": None}
    example = verdict.counterexample and dict(verdict.counterexample)
    return {"printed": verdict.kind.value, "method": verdict.method, "counterexample": example}


def holds(row: dict) -> bool:
    """The verdict is sound, and what the erratum says to be false in print is refuted."""
    sound = row["verdict"] in ("proved", "certified", "law", "definition")
    return sound and row.get("erratum", {}).get("printed") in (None, "refuted")


def listing(rows: list[dict]) -> str:
    """A line for each entry: id, verdict, time, method; then how many there are of each verdict."""
    width = max((len(row["id"]) for row in rows), default=0)
    lines = [line for row in rows for line in _lines(row, width)]
    counts = Counter(row["verdict"] for row in rows)
    return "\n".join([*lines, f"{len(rows)} entries: " + ", ".join(f"{n} {kind}" for kind, n in counts.most_common())])


def _lines(row, width):
    erratum = row.get("erratum", {})
    note = f"  erratum {', '.join(erratum['ids'])}" if erratum else ""
    yield f"{row['id']:{width}s}  {row['verdict']:10s}  {row['seconds']:6.2f} s  {row['method']}{note}"
    if row["counterexample"]:
        yield " " * width + f"  at {place(row['counterexample'])}"
    if erratum.get("printed") not in (None, "refuted"):
        yield " " * width + f"  the printed form is not refuted: {erratum['printed']}: {erratum['method']}"


def place(counterexample: dict) -> str:
    """A counterexample in a line."""
    return ", ".join(f"{name} = {value}" for name, value in counterexample.items())
