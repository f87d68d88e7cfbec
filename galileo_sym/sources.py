"""Hashes of the sources that derivations depend on, without importing them: this module loads no SymPy."""

from __future__ import annotations

import hashlib
import platform
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, version
from importlib.resources import files
from pathlib import Path

MACHINERY = ("ledger", "tactics", "primitives")
LIBRARIES = ("sympy", "mpmath", "python-flint", "gmpy2")  # the last two change SymPy's arithmetic where installed


def digest(paths: Iterable[Path]) -> str:
    """One hash of the contents of files, in the order given."""
    total = hashlib.sha256()
    for path in paths:
        total.update(hashlib.sha256(path.read_bytes()).digest())
    return total.hexdigest()


def machinery() -> str:
    """Of what carries out and checks derivations: ledger, tactics, primitives, and the libraries' versions."""
    root = Path(__file__).parent
    own = [root / "rows.py", root / "multiprecision.py"]
    sources = digest([*own, *(path for name in MACHINERY for path in _below(root / name))])
    return f"{sources} {platform.python_version()} {[f'{name} {_version(name)}' for name in LIBRARIES]}"


def everything() -> str:
    """Of the machinery and of all chapters."""
    chapters = Path(str(files("galileo_sym.derivations")))
    return hashlib.sha256(f"{machinery()} {digest(_below(chapters))}".encode()).hexdigest()


def _below(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".py", ".toml"))


def _version(name):
    try:
        return version(name)
    except PackageNotFoundError:
        return "absent"
