"""The floors of the architecture: held by the tree as it is, broken by an import that goes up or across."""

import importlib
import pkgutil
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from galileo_sym import derivations
from galileo_sym.ledger import Chapter
from galileo_sym.ledger.inventory import tomllib

ROOT = Path(__file__).resolve().parent.parent
PARTS = ("galileo_sym", "derivations", "generated", "tools")

PLANTED = {
    "the ledger looks up at the tactics": ("galileo_sym/ledger/verdict.py", "import galileo_sym.tactics"),
    "a tactic looks up at a chapter": (
        "galileo_sym/tactics/solve.py",
        "import galileo_sym.derivations.chord.notation",
    ),
    "one chapter imports another": (
        "derivations/chord/rescaled.py",
        "import galileo_sym.derivations.chord.spindle",
    ),
    "codegen imports verify": ("galileo_sym/codegen/schedule.py", "import galileo_sym.verify.ulp"),
    "a public numeric module imports the ledger": ("galileo_sym/chord.py", "import galileo_sym.ledger"),
    "emitted code imports the primitives": ("generated/chord.py", "import galileo_sym.primitives"),
}


@pytest.fixture
def tree(tmp_path):
    """A copy of the sources."""
    for part in PARTS:
        shutil.copytree(ROOT / part, tmp_path / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    return tmp_path


def check(root):
    return subprocess.run(
        [sys.executable, root / "tools" / "check_floors.py"], capture_output=True, text=True, timeout=120, check=False
    )


def test_the_floors_hold(tree):
    done = check(tree)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "0 broken" in done.stdout


@pytest.mark.parametrize(("path", "line"), PLANTED.values(), ids=PLANTED)
def test_an_import_that_goes_up_or_across_is_found(tree, path, line):
    victim = tree / path
    victim.write_text(f"{victim.read_text()}\n{line}\n")
    done = check(tree)
    assert done.returncode == 1
    assert "1 broken" in done.stdout or "2 broken" in done.stdout
    assert Path(path).stem in done.stdout


def test_every_chapter_is_held_apart_from_the_others():
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"][
        "contracts"
    ]
    apart = {m for c in contracts if c["type"] == "independence" for m in c["modules"]}
    modules = pkgutil.walk_packages(derivations.__path__, "galileo_sym.derivations.")
    chapters = {
        m.name for m in modules if isinstance(getattr(importlib.import_module(m.name), "chapter", None), Chapter)
    }
    assert len(chapters) > 10
    assert chapters <= apart
