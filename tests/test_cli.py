"""The command line: exit codes, nearest names, the shape of its JSON, and what a fresh process imports."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import sympy as sp
from sympy import Eq

from galileo_sym import __version__
from galileo_sym.cli import main
from galileo_sym.ledger import ONE, POSITIVE, Chapter, Domain, Erratum, Ledger, Notation
from galileo_sym.store import FOLDER

ROOT = Path(__file__).resolve().parent.parent
KEYS = {"id", "paper", "kind", "verdict", "method", "premises", "seconds"}
KINDS = {"proved", "certified", "checked", "refuted", "vacuous", "error", "law", "definition"}


def call(capsys, *words):
    """Exit code, standard output and standard error of a command."""
    try:
        code = main(list(words))
    except SystemExit as end:
        code = end.code
    out, err = capsys.readouterr()
    return code, out, err


def fresh(*words):
    """A command in a process of its own."""
    return subprocess.run([sys.executable, *words], cwd=ROOT, capture_output=True, text=True, timeout=120, check=False)


notation = Notation("small")
p = notation.symbol("p", ONE, "a positive number", positive=True)
q = notation.symbol("q", ONE, "a number")
SOME = Domain({p: POSITIVE})
TWICE = Eq(q, 2 * p)
HYPOTENUSE = sp.sqrt(p**2 + 1)  # the two forms of a cubic's real root are equal in numbers only
FAILURES = {
    "refuted": (Eq(q, 3 * p), TWICE, SOME, None),
    "checked": (
        Eq(q, 2 * sp.sinh(sp.asinh(p) / 3)),
        Eq(q, sp.cbrt(HYPOTENUSE + p) - sp.cbrt(HYPOTENUSE - p)),
        SOME,
        None,
    ),
    "vacuous": (TWICE, TWICE, Domain({p: sp.S.EmptySet}), None),
    "error": (TWICE, 2 * p, SOME, None),
    "proved": (TWICE, TWICE, SOME, Erratum(("E1",), "not false at all", TWICE)),
}


@pytest.fixture
def other_ledger(monkeypatch, tmp_path):
    """Put a ledger of one entry in the place of the papers', and no verdicts of theirs."""
    monkeypatch.setenv(FOLDER, str(tmp_path))

    def put(printed, result, domain, erratum):
        made = Chapter("stable.small", notation, "a chapter of the tests")
        made.derive("stable.test.entry", printed, domain, erratum=erratum)(lambda: result)
        monkeypatch.setattr(Ledger, "load", lambda: Ledger([made]))

    return put


def test_what_is_proved_ends_with_0(capsys):
    code, out, _ = call(capsys, "derive", "chord.eq1")
    assert code == 0
    assert out.startswith("chord.eq1")
    assert "proved" in out
    assert "1 entries: 1 proved" in out


@pytest.mark.parametrize("kind", FAILURES)
def test_what_is_not_proved_ends_with_1(capsys, other_ledger, kind):
    other_ledger(*FAILURES[kind])
    code, out, _ = call(capsys, "derive", "--json")
    assert code == 1
    assert [row["verdict"] for row in json.loads(out)] == [kind]


def test_a_refuted_entry_is_printed_with_its_counterexample(capsys, other_ledger):
    other_ledger(*FAILURES["refuted"])
    code, out, _ = call(capsys, "derive")
    assert code == 1
    assert "p = " in out
    assert "q = " in out


def test_a_printed_form_that_is_not_false_is_reported(capsys, other_ledger):
    other_ledger(*FAILURES["proved"])
    code, out, _ = call(capsys, "derive")
    assert code == 1
    assert "the printed form is not refuted" in out


@pytest.mark.parametrize(
    ("words", "near"),
    [
        (("derive", "chord.eqn21"), "chord.eq21"),
        (("derive", "chord.eq1", "chord.galileio"), "chord.galileo"),
        (("derive", "--sow"), "--show"),
        (("derve", "chord.eq1"), "derive"),
        (("emit", "--chek"), "--check"),
        (("verify", "chord.descent_tme"), "chord.descent_time"),
        (("verify", "--stratum", "typicl"), "typical"),
    ],
)
def test_bad_usage_ends_with_2_and_names_the_nearest(capsys, words, near):
    code, out, err = call(capsys, *words)
    assert code == 2
    assert near in err
    assert not out


@pytest.mark.parametrize("words", [(), ("derive", "--json=1"), ("verify", "--points", "0"), ("emit", "-o")])
def test_other_bad_usage_ends_with_2(capsys, words):
    code, out, err = call(capsys, *words)
    assert code == 2
    assert err
    assert not out


def test_json_has_a_row_for_each_entry(capsys):
    code, out, _ = call(capsys, "derive", "chord.eq1", "chord.eq4", "chord.law.frictionless", "--json")
    assert code == 0
    rows = {row["id"]: row for row in json.loads(out)}
    assert set(rows) == {"chord.eq1", "chord.eq4", "chord.law.frictionless"}
    for row in rows.values():
        assert set(row) >= KEYS
        assert row["paper"] == "chord"
        assert row["verdict"] in KINDS
        assert isinstance(row["premises"], list)
        assert row["seconds"] >= 0
    assert rows["chord.eq1"]["premises"] == ["chord.setup", "chord.law.frictionless"]
    assert rows["chord.eq1"]["verdict"] == "proved"
    assert rows["chord.law.frictionless"]["verdict"] == "law"
    assert rows["chord.eq4"]["erratum"]["ids"] == ["C10"]
    assert rows["chord.eq4"]["erratum"]["printed"] == "refuted"
    assert "erratum" not in rows["chord.eq1"]


def test_show_tells_the_steps(capsys):
    code, out, _ = call(capsys, "derive", "chord.eq21", "--show")
    assert code == 0
    for words in ("printed", "assuming", "from", "1. (19)", "2. (20)", "result", "verdict", "proved", "erratum"):
        assert words in out


@pytest.mark.xdist_group("projectile")  # whose results are what is emitted
def test_emit_check_finds_a_changed_file(capsys, tmp_path):
    copy = tmp_path / "generated"
    shutil.copytree(ROOT / "generated", copy, ignore=shutil.ignore_patterns("__pycache__"))
    changed = copy / "c" / "chord.c"
    changed.write_text(changed.read_text() + "\n")
    code, out, _ = call(capsys, "emit", "--check", "-o", str(copy), "--json")
    assert code == 1
    assert any("chord.c" in line for line in json.loads(out)["differences"])
    assert changed.read_text().endswith("\n\n"), "a check writes nothing"


@pytest.mark.parametrize("words", [("--help",), ("--version",), ("derive", "--help"), ("verify", "--help")])
def test_help_loads_no_mathematics(words):
    script = """
import sys
from galileo_sym.cli import main
try:
    main(sys.argv[1:])
finally:
    heavy = {"sympy", "mpmath", "numpy", "scipy", "flint", "matplotlib"} & set(sys.modules)
    print("loaded:", *sorted(heavy), file=sys.stderr)
"""
    done = fresh("-c", script, *words)
    assert done.returncode == 0
    assert done.stdout
    assert done.stderr == "loaded:\n"


def test_verifying_without_flint_says_what_it_needs(capsys, monkeypatch):
    monkeypatch.setattr("galileo_sym.commands.find_spec", lambda name: None if name == "flint" else name)
    code, _, err = call(capsys, "verify", "chord.max_angle")
    assert code == 2
    assert "pip install python-flint" in err


def test_the_package_runs_as_a_module():
    assert fresh("-m", "galileo_sym", "--version").stdout == f"galileo-sym {__version__}\n"
    unknown = fresh("-m", "galileo_sym", "derive", "chord.eqn21")
    assert unknown.returncode == 2
    assert "chord.eq21" in unknown.stderr


def test_a_chapter_is_a_script_that_tells_its_derivations():
    done = fresh("derivations/chord/galileo.py")
    assert done.returncode == 0, done.stderr
    for words in ("chord.eq1 ", "chord.eq11 ", "Integrate the law from rest at A.", "verdict   proved: solve motion"):
        assert words in done.stdout
    assert "chord.eq12" not in done.stdout
