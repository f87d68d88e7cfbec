"""Hold the imports against the floors of docs/design.md: the tree as it is installed, checked by import-linter.

`derivations/` and `generated/` stand at the top of the repository and are installed below the package, so the linter
is given a copy of the tree as it is installed. It runs without `site`: an editable install puts a finder before every
path, and the linter would look at something else than the copy.
"""

import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MOUNTED = ("derivations", "generated")
LINT = "from importlinter.cli import lint_imports_command; lint_imports_command()"
NO_CHAPTERS = ("__init__", "notation", "shared")  # how the names of what chapters may import end


def unlisted_chapters():
    """Chapters that the contract of independence in pyproject.toml does not name."""
    contract = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    paths = sorted(p for p in (ROOT / "derivations").glob("*/*.py") if not p.stem.endswith(NO_CHAPTERS))
    names = [f"galileo_sym.{'.'.join(p.relative_to(ROOT).with_suffix('').parts)}" for p in paths]
    return [name for name in names if f'"{name}"' not in contract]


def main() -> int:
    """Copy, lint, and return the linter's exit code; 1 if a chapter is not under the contract."""
    forgotten = unlisted_chapters()
    if forgotten:
        print(f"pyproject.toml: add to the contract that chapters never import each other: {', '.join(forgotten)}")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder)
        shutil.copytree(ROOT / "galileo_sym", tree / "galileo_sym", ignore=shutil.ignore_patterns("__pycache__"))
        for name in MOUNTED:
            shutil.copytree(ROOT / name, tree / "galileo_sym" / name, ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copy(ROOT / "pyproject.toml", tree)
        paths = os.pathsep.join([folder, sysconfig.get_path("purelib"), sysconfig.get_path("platlib")])
        return subprocess.run(
            [sys.executable, "-S", "-c", LINT, "--no-cache"],
            cwd=tree,
            env={**os.environ, "PYTHONPATH": paths},
            check=False,
        ).returncode


if __name__ == "__main__":
    sys.exit(main())
