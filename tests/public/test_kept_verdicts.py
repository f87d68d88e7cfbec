"""Verdicts kept from one run to the next: used where nothing changed, and only there."""

import json
import os
import sqlite3
import subprocess
import sys
import textwrap

import pytest

from galileo_sym.store import FOLDER, Store

CHAPTERS = {
    "below": """
        @chapter.derive("beyond.below", Eq(p, p * 1, evaluate=False), Domain({p: POSITIVE}))
        def below():
            return Eq(p, p * 1, evaluate=False)
    """,
    "middle": """
        @chapter.derive("beyond.middle", Eq(2 * p, p + p, evaluate=False), Domain({p: POSITIVE}))
        def middle(beyond__below):
            beyond__below.statement
            return Eq(2 * p, p + p, evaluate=False)
    """,
    "beside": """
        @chapter.derive("beyond.beside", Eq(3 * p, p + 2 * p, evaluate=False), Domain({p: POSITIVE}))
        def beside():
            return Eq(3 * p, p + 2 * p, evaluate=False)
    """,
}
HEAD = """
from sympy import Eq
from galileo_sym.ledger import POSITIVE, Chapter, Domain
from small_papers.words import notation, p
chapter = Chapter("{name}", notation, "a chapter of the tests")
"""
WORDS = """
from galileo_sym.ledger import ONE, Notation
notation = Notation("small")
p = notation.symbol("p", ONE, "a number", positive=True)
"""
PRINTS = """
import json
from galileo_sym.ledger import Ledger
from galileo_sym.ledger.fingerprint import fingerprints
print(json.dumps(fingerprints(Ledger.load("small_papers"))))
"""


def run(*words, folder, **more):
    environment = {**os.environ, FOLDER: str(folder), **more}
    done = subprocess.run([sys.executable, *words], capture_output=True, text=True, check=False, env=environment)
    return done.returncode, done.stdout, done.stderr


def derive(*words, folder):
    return run("-m", "galileo_sym", "derive", *words, folder=folder)


def doctor(folder, verdict):
    """Change every verdict that is kept."""
    with sqlite3.connect(folder / "findings.sqlite") as table:
        for key, text in table.execute("SELECT key, value FROM kept").fetchall():
            value = json.loads(text)
            if "verdict" in value:
                table.execute(
                    "UPDATE kept SET value = ? WHERE key = ?", (json.dumps(value | {"verdict": verdict}), key)
                )


@pytest.mark.xdist_group("kept verdicts")
def test_a_second_run_takes_what_is_kept_and_a_fresh_one_does_not(tmp_path):
    first = derive("chord.eq1", folder=tmp_path)
    assert first[0] == 0
    assert derive("chord.eq1", folder=tmp_path) == first
    doctor(tmp_path, "refuted")
    assert derive("chord.eq1", folder=tmp_path)[0] == 1
    code, out, _ = derive("chord.eq1", "--fresh", folder=tmp_path)
    assert (code, "1 proved" in out) == (0, True)
    assert derive("chord.eq1", folder=tmp_path)[0] == 0


@pytest.mark.xdist_group("kept verdicts")
def test_what_is_kept_needs_no_sympy_and_what_is_not_is_derived(tmp_path):
    code = "import sys; from galileo_sym.cli import main; main(sys.argv[1:]); print('sympy' in sys.modules)"
    words = ("-c", code, "derive", "chord.eq1")
    assert run(*words, folder=tmp_path)[1].endswith("True\n")
    assert run(*words, folder=tmp_path)[1].endswith("False\n")
    assert run(*words[:-1], "chord.eq3", folder=tmp_path)[1].endswith("True\n")
    unknown = derive("chord.eqn1", folder=tmp_path)
    assert (unknown[0], "chord.eq1" in unknown[2]) == (2, True)


@pytest.mark.parametrize("broken", ["a file that is no table", "a folder in the way"])
def test_a_store_that_cannot_be_used_is_told_and_done_without(tmp_path, broken):
    target = tmp_path / "findings.sqlite"
    target.write_text("no table " * 100) if "file" in broken else target.mkdir()
    code, out, err = derive("chord.eq7", folder=tmp_path)
    assert code == 0
    assert "1 proved" in out
    assert err.count("\n") == 1
    assert "verdicts are not kept in" in err
    assert FOLDER in err


def test_values_come_back_as_they_were(tmp_path, monkeypatch):
    monkeypatch.setenv(FOLDER, str(tmp_path / "new folder"))
    Store().put({"a": [1, "x"], "b": None})
    assert Store().get(["a", "b", "c"]) == {"a": [1, "x"], "b": None}


@pytest.fixture
def small_papers(tmp_path):
    """A package of three chapters, one of which builds on another."""
    package = tmp_path / "small_papers"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "words.py").write_text(WORDS)
    for name, body in CHAPTERS.items():
        (package / f"{name}.py").write_text(HEAD.format(name=name) + textwrap.dedent(body))
    return package


def changed_by_editing(package, name):
    before = _prints(package)
    with open(package / name, "a") as file:
        file.write("# a remark\n")
    after = _prints(package)
    return {identifier for identifier in before if before[identifier] != after[identifier]}


def _prints(package):
    code, out, err = run("-c", PRINTS, folder=package, PYTHONPATH=str(package.parent))
    assert code == 0, err
    return json.loads(out)


@pytest.mark.parametrize(
    ("edited", "rerun"),
    [
        ("below.py", {"beyond.below", "beyond.middle"}),
        ("middle.py", {"beyond.middle"}),
        ("beside.py", {"beyond.beside"}),
        ("__init__.py", set()),
    ],
)
def test_editing_a_chapter_reruns_it_and_what_depends_on_it(small_papers, edited, rerun):
    assert changed_by_editing(small_papers, edited) == rerun


def test_editing_what_all_chapters_import_reruns_all(small_papers):
    assert changed_by_editing(small_papers, "words.py") == {"beyond.below", "beyond.middle", "beyond.beside"}
