"""Of the emitted C only what some code reaches: types, macros, tables and functions, each made static, in order."""

from __future__ import annotations

import re
from functools import cache
from importlib import resources
from typing import NamedTuple

_SOURCES = ("galileo_support.h", "tables.c", "primitives.c")
_WORD = re.compile(r"\b[A-Za-z_]\w*\b")
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_GUARD = re.compile(r"GALILEO_\w+_H")
_KINDS = ("include", "condition", "macro", "type", "table", "function")  # in this order they may use one another


class Definition(NamedTuple):
    """A definition on the top level of a source: its kind, the name it defines and its text, comment included."""

    kind: str
    name: str
    text: str


@cache
def definitions():
    """Return what the sources of the arithmetic and the primitives define, in order: a tuple of `Definition`."""
    emitted = resources.files("galileo_sym.generated") / "c"
    paths = [*(emitted / name for name in _SOURCES), resources.files("galileo_sym.scenes") / "templates" / "scene.c"]
    return tuple(found for path in paths for found in _parsed(path.read_text(encoding="utf-8")))


def closure(code):
    """Return the text of all definitions that code reaches, with the standard headers and conditions on compilers.

    Parameters
    ----------
    code : str
        C that names them.
    """
    known = {found.name: found for found in definitions()}
    wanted, left = set(), set(_WORD.findall(_COMMENT.sub("", code)))
    while left:
        name = left.pop()
        if name in known and name not in wanted:
            wanted.add(name)
            left |= set(_WORD.findall(_COMMENT.sub("", known[name].text))) - wanted
    always = {found.name: found for found in definitions() if found.kind in ("include", "condition")}
    chosen = [*always.values(), *(found for found in definitions() if found.name in wanted)]
    parts = ("".join(_spaced(found) for found in chosen if found.kind == kind) for kind in _KINDS)
    return "\n".join(part for part in parts if part)


def _spaced(found):
    return found.text if found.kind in ("include", "macro") else f"{found.text}\n"


def _parsed(text):
    """The definitions of a source; declarations of what is defined elsewhere are left out."""
    found, comment = [], ""
    for lines in _items(text.splitlines(keepends=True)):
        item = "".join(lines)
        if item.startswith("/*"):
            comment = item
            continue
        kind, name = _classified(item)
        if kind:
            own = comment if kind in ("table", "function", "type") else ""
            found.append(Definition(kind, name, own + _static(kind, item)))
        comment = ""
    return found


def _items(lines):
    """Lines of the top level that belong together."""
    item, end = [], None
    for line in lines:
        if not item and not line.strip():
            continue
        if not item:
            end = _end_of(line)
        item.append(line)
        if end(line):
            yield item
            item = []


def _end_of(line):
    """A test of the line that ends the item which begins with this one."""
    bare = _COMMENT.sub("", line).rstrip()
    if line.startswith("/*"):
        return lambda last: last.rstrip().endswith("*/")
    if line.startswith("#if") and not _GUARD.search(line):
        return lambda last: last.startswith("#endif")
    if line.startswith("#"):
        return lambda last: not last.rstrip().endswith("\\")
    if bare.endswith((";", "}")):
        return lambda last: True
    if line.startswith("extern") or ("(" in line and not bare.endswith((")", "{"))):
        return lambda last: last.rstrip().endswith(";") or last.startswith("}")
    return lambda last: last.startswith("}")


def _classified(item):
    """Kind and name of an item; None for what defines nothing here."""
    first = item.partition("\n")[0]
    if item.startswith("#include <"):
        return "include", first
    if item.startswith("#if"):
        return (None, None) if _GUARD.search(first) else ("condition", first)
    if item.startswith("#define"):
        name = item.split()[1].partition("(")[0]
        return (None, None) if _GUARD.fullmatch(name) else ("macro", name)
    if item.startswith(("#", "extern")):
        return None, None
    if item.startswith("typedef"):
        return "type", item.rstrip().rstrip(";").split()[-1]
    if "{" not in item:
        return None, None  # the prototype of a function
    before = _COMMENT.sub("", item).partition("{")[0]
    if "=" in before:
        return "table", re.search(r"(\w+)\s*(?:\[[^=]*)?=", before).group(1)
    return "function", re.search(r"(\w+)\(", before).group(1)


def _static(kind, text):
    if kind not in ("table", "function") or text.startswith("static"):
        return text
    return f"static {text}"
