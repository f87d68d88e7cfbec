"""The tables of coverage: every item of the inventory is counted, and what is missing or weak shows."""

from galileo_sym import coverage
from galileo_sym.ledger.inventory import Item


def item(identifier, kind, *errata, printed=True):
    return Item(identifier, "paper", "(1)", "1", kind, "", "", errata, printed)


def row(identifier, verdict, kind="equation", **more):
    return {"id": identifier, "paper": "paper", "kind": kind, "verdict": verdict, **more}


ITEMS = {
    i.id: i
    for i in (
        item("a", "equation"),
        item("b", "equation", "S2"),
        item("c", "equation"),
        item("d", "law"),
        item("e", "figure", "S10"),
        item("f", "claim", printed=False),
        item("g", "equation"),
    )
}
ERRATUM = {"ids": ["S2"], "text": "a | b", "printed": "refuted", "counterexample": {"x": "1"}, "method": ""}
ROWS = [
    row("a", "proved"),
    row("b", "checked", erratum=ERRATUM),
    row("d", "law", "law"),
    row("f", "certified", "claim"),
    row("g", "law"),
    row("stable.h", "proved", "stable"),
]


def cells(line):
    return [cell.strip() for cell in line.strip("|").split(" | ")]


def test_what_is_missing_checked_or_given_against_the_inventory_counts_as_anything_else():
    lines = [cells(line) for line in coverage.tables(ROWS, ITEMS).splitlines()]
    counts = {tuple(line[:2]): line[2:] for line in lines if line[0] == "paper" and line[1] != "kind"}
    assert counts[("paper", "equation")] == ["4", "3", "1", "0", "0", "3"]
    assert counts[("paper", "law")] == ["1", "1", "0", "0", "1", "0"]
    assert counts[("paper", "claim (supporting)")] == ["1", "1", "0", "1", "0", "0"]
    assert counts[("paper", "stable (not printed)")] == ["1", "1", "1", "0", "0", "0"]
    assert ("paper", "figure") not in counts
    assert ["both", "all", "7", "6", "2", "1", "1", "3"] in lines


def test_gaps_are_the_items_without_a_sound_entry():
    assert coverage.gaps(ROWS, ITEMS) == ["b", "c", "g"]
    assert coverage.gaps(ROWS, {"a": ITEMS["a"], "e": ITEMS["e"]}) == []


def test_each_erratum_names_its_entry_or_says_that_there_is_none():
    text = coverage.tables(ROWS, ITEMS)
    assert "| S2 | `b` | checked | refuted at x = 1 | a \\| b |" in text
    assert "| S10 | no entry |  |  | concerns `e` |" in text
