"""Entries named on the command line: by id, by chapter, or by the beginning of a chapter's name."""

from __future__ import annotations

import difflib
from collections.abc import Mapping


class UnknownEntry(KeyError):
    """There is no entry or chapter of that name; the message gives the nearest ones."""

    def __init__(self, name, known):
        near = difflib.get_close_matches(name, known, n=4, cutoff=0.4)
        hint = f"; nearest: {', '.join(near)}" if near else ""
        super().__init__(f"no entry or chapter {name!r}{hint}")

    def __str__(self):
        return self.args[0]


def choose(names: list[str], chapters: Mapping[str, str]) -> list[str]:
    """Ids that are meant by `names` (all for none), among those of a mapping of ids to their chapters."""
    if not names:
        return list(chapters)
    chosen: dict[str, None] = {}
    for name in names:
        chosen |= dict.fromkeys(_named(name, chapters))
    return list(chosen)


def _named(name, chapters):
    if name in chapters:
        return [name]
    inside = [i for i, chapter in chapters.items() if f"{chapter}.".startswith(f"{name}.")]
    if not inside:
        raise UnknownEntry(name, [*chapters, *dict.fromkeys(chapters.values())])
    return inside
