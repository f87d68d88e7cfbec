"""The content a verdict depends on, as one hash: sources, versions, and the fingerprints of the premises."""

from __future__ import annotations

import ast
import functools
import hashlib
import sys
from pathlib import Path

from galileo_sym.sources import digest, machinery


def fingerprints(ledger) -> dict[str, str]:
    """A hash for each entry: it changes when its chapter, what that imports, or anything it is derived from does."""
    found: dict[str, str] = {}
    tools = machinery()
    for entry in ledger.in_order():
        parts = [tools, _chapter(entry.chapter.module, ledger.package), repr(entry.declaration.item)]
        parts += [f"{i} {found[i]}" for i in entry.premises]
        found[entry.id] = hashlib.sha256("\n".join([entry.id, *parts]).encode()).hexdigest()
    return found


@functools.cache
def _chapter(module: str, package: str) -> str:
    """Of a chapter's file and of all files of the package of chapters that it imports, directly or not."""
    seen: set[str] = set()
    waiting = [module]
    while waiting:
        name = waiting.pop()
        if name not in seen:
            seen.add(name)
            waiting += [m for m in _imports(name) if m.startswith(f"{package}.") and m in sys.modules]
    return digest(Path(sys.modules[name].__file__) for name in sorted(seen))


@functools.cache
def _imports(name):
    tree = ast.parse(Path(sys.modules[name].__file__).read_bytes())
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return found
