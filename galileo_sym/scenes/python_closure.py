"""Of the emitted NumPy modules only what some code reaches, in order; of dictionaries the entries it names."""

from __future__ import annotations

import ast
from functools import cache
from importlib import resources
from typing import NamedTuple

_SOURCES = (
    ("galileo_sym.generated", "_tables.py"),
    ("galileo_sym.generated", "_scaled.py"),
    ("galileo_sym.generated", "_kernel.py"),
    ("galileo_sym.generated", "_angle.py"),
    ("galileo_sym.generated", "_primitives.py"),
    ("galileo_sym.scenes", "factors.py"),
)


class Definition(NamedTuple):
    """A definition of a module: its name, its syntax and its text."""

    name: str
    node: ast.AST
    text: str


@cache
def definitions():
    """Return what the modules define, in order; a name is defined once.

    Raises
    ------
    ValueError
        If two modules define one name.
    """
    found = {}
    for package, path in _SOURCES:
        text = (resources.files(package) / path).read_text(encoding="utf-8")
        for node in ast.parse(text).body:
            if not isinstance(node, ast.FunctionDef | ast.ClassDef | ast.Assign):
                continue
            name = node.targets[0].id if isinstance(node, ast.Assign) else node.name
            if name in found:
                raise ValueError(f"{name} is defined in {path}, and before: emitted scenes need different names")
            found[name] = Definition(name, node, ast.get_source_segment(text, node))
    return tuple(found.values())


def closure(code):
    """Return the text of all definitions that code reaches.

    Parameters
    ----------
    code : str
        Python that names them.
    """
    known = {found.name: found for found in definitions()}
    wanted, left, words = set(), *_reached(ast.parse(code))
    dictionaries = {name for name, found in known.items() if isinstance(getattr(found.node, "value", None), ast.Dict)}
    while left:
        name = left.pop()
        if name not in known or name in wanted:
            continue
        wanted.add(name)
        if name not in dictionaries:
            names, strings = _reached(known[name].node)
            left |= names - wanted
            words |= strings
    left = {
        n for name in wanted & dictionaries for entry in _entries(known[name], words) for n in _reached(entry[1])[0]
    }
    missing = (left & set(known)) - wanted
    if missing:
        raise ValueError(f"dictionaries of emitted modules name {', '.join(sorted(missing))}, which nothing else does")
    return "\n\n\n".join(
        _pruned(found, words) if found.name in dictionaries else found.text
        for found in definitions()
        if found.name in wanted
    )


def _reached(node):
    """The names that code takes from outside of it, and the strings in it."""
    nodes = list(ast.walk(node))
    bound = {one.arg for one in nodes if isinstance(one, ast.arg)}
    bound |= {one.id for one in nodes if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store)}
    names = {one.id for one in nodes if isinstance(one, ast.Name)}
    strings = {one.value for one in nodes if isinstance(one, ast.Constant) and isinstance(one.value, str)}
    return names - (bound if isinstance(node, ast.FunctionDef) else set()), strings


def _entries(found, words):
    pairs = zip(found.node.value.keys, found.node.value.values, strict=True)
    return [(key, value) for key, value in pairs if key.value in words]


def _pruned(found, words):
    """A dictionary with the entries that are named."""
    lines = found.text.split("\n")
    first = found.node.lineno
    kept = [
        "\n".join(lines[key.lineno - first : value.end_lineno - first + 1]) for key, value in _entries(found, words)
    ]
    return "\n".join([lines[0], *kept, lines[-1]])
