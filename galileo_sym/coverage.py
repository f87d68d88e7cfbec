"""What of both papers stands in the ledger, and which entry shows each erratum: two tables."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping

from galileo_sym.rows import place

GIVEN = ("law", "definition")
COLUMNS = ("paper", "kind", "items", "present", "proved", "certified", "given", "anything else")
NOT_DERIVED = "figure"  # figures are drawn, not derived


def tables(rows: list[dict], items: Mapping) -> str:
    """Both tables, as Markdown.

    Parameters
    ----------
    rows : list of dict
        Of all entries.
    items : mapping
        The inventory: items by id.
    """
    return "\n".join([*_markdown(COLUMNS, _coverage(rows, items)), "", *_markdown(ERRATA, _errata(rows, items))])


def gaps(rows: list[dict], items: Mapping) -> list[str]:
    """Ids of the inventory's items that have no entry, or one that is neither proved nor rightly given."""
    known = {row["id"]: row for row in rows}
    wanted = [item for item in items.values() if item.kind != NOT_DERIVED]
    return [item.id for item in wanted if _standing(item, known.get(item.id)) == COLUMNS[-1]]


def _standing(item, row):
    """The column in which an item, or an entry that is none, is counted."""
    verdict = row and row["verdict"]
    if verdict in ("proved", "certified"):
        return verdict
    return "given" if verdict in GIVEN and item is not None and item.kind == verdict else COLUMNS[-1]


def _coverage(rows, items):
    known = {row["id"]: row for row in rows}
    groups: dict[tuple, list] = {}
    for item in items.values():
        if item.kind != NOT_DERIVED:
            kind = item.kind if item.printed else f"{item.kind} (supporting)"
            groups.setdefault((item.paper, kind), []).append((item, known.get(item.id)))
    for row in rows:
        if row["id"] not in items:
            groups.setdefault((row["paper"], f"{row['kind']} (not printed)"), []).append((None, row))
    lines = [(paper, kind, *_counts(found)) for (paper, kind), found in sorted(groups.items())]
    return [*lines, ("both", "all", *(sum(line[n] for line in lines) for n in range(2, len(COLUMNS))))]


def _counts(found):
    columns = Counter(_standing(item, row) for item, row in found)
    return len(found), sum(row is not None for _, row in found), *(columns[name] for name in COLUMNS[4:])


ERRATA = ("erratum", "shown by", "verdict", "as printed", "correction")


def _errata(rows, items):
    numbers = {number for item in items.values() for number in item.errata}
    with_erratum = [(row, row["erratum"]) for row in rows if "erratum" in row]
    numbers |= {number for _, erratum in with_erratum for number in erratum["ids"]}
    for number in sorted(numbers, key=lambda n: (n[0], int(n[1:]))):
        found = [(row, erratum) for row, erratum in with_erratum if number in erratum["ids"]]
        for row, erratum in found:
            yield number, f"`{row['id']}`", row["verdict"], _as_printed(erratum), erratum["text"]
        if not found:
            yield number, "no entry", "", "", _of_figures(number, items)


def _as_printed(erratum):
    if erratum["printed"] is None:
        return "not false"
    where = erratum["counterexample"]
    return f"{erratum['printed']} at {place(where)}" if where else erratum["printed"]


def _of_figures(number, items):
    return "concerns " + ", ".join(f"`{item.id}`" for item in items.values() if number in item.errata)


def _markdown(heads: Iterable, lines: Iterable):
    yield "| " + " | ".join(heads) + " |"
    yield "|" + "---|" * len(tuple(heads))
    for line in lines:
        yield "| " + " | ".join(str(cell).replace("|", "\\|") for cell in line) + " |"
