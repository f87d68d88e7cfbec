"""The table of contents of both papers: what each id is called, where it is printed, and of what kind it is."""

from __future__ import annotations

import functools
import sys
from dataclasses import dataclass
from importlib.resources import files

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


@dataclass(frozen=True)
class Item:
    """One equation, claim, lemma, limit or figure; `printed` is False for facts that only support a proof."""

    id: str
    paper: str
    label: str
    section: str
    kind: str
    statement: str
    assumptions: str
    errata: tuple[str, ...] = ()
    printed: bool = True


@functools.cache
def inventory() -> dict[str, Item]:
    """Items by id, in the order of the papers, supporting facts last."""
    text = files("galileo_sym.derivations").joinpath("inventory.toml").read_text(encoding="utf-8")
    table = tomllib.loads(text)
    rows = [(row, True) for row in table["item"]] + [(row, False) for row in table["support"]]
    return {row["id"]: _item(row, printed) for row, printed in rows}


def _item(row, printed):
    keys = ("id", "paper", "label", "section", "kind", "statement", "assumptions")
    return Item(**{k: row[k] for k in keys}, errata=tuple(row.get("errata", "").split()), printed=printed)
