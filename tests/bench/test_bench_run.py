"""`galileo-sym bench`: what it tells and writes, and its exit codes."""

import json

import pytest

from galileo_sym import cli, commands
from galileo_sym.bench import contestants, run

pytest.importorskip("scipy")  # an extra
pytestmark = pytest.mark.xdist_group("catalogue")

FEW = ("bench", "--quick", "--rounds", "2", "--points", "100")


@pytest.fixture
def place(tmp_path, monkeypatch):
    """A folder with docs/ in which the command runs; no case for threads or growth takes long."""
    (tmp_path / "docs").mkdir()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(run, "QUICK", run.QUICK._replace(long=1000, sizes=(1, 10), rounds=1))
    return tmp_path


def test_a_quick_run(place, capsys):
    code = cli.main([*FEW, "--functions", "lambert.w0", "special.sin", "--json", "--publish"])
    found = json.loads(capsys.readouterr().out)
    assert code == 0
    assert found == json.loads((place / "build" / "bench" / "bench.json").read_text())
    rows = {(row["case"], row["contestant"]): row for row in found["rows"]}
    for case in ("lambert.w0", "special.sin"):
        for name in ("NumPy", "NumPy, float32", "lambdify", "SciPy", "numpy.exp"):
            row = rows[case, name]
            assert row["ns"]["low"] <= row["ns"]["median"] <= row["ns"]["high"]
            assert row["ns"]["median"] > 0
            assert row["count"] == 100
        assert rows[case, "NumPy"]["ulp"] < 2
        assert rows[case, "numpy.exp"]["ratio"]["median"] == 1
    assert all(one["same"] for one in found["scalings"])
    assert {point["count"] for point in found["points"]} == {1, 10}
    assert any(one["text"] == "import beyond NumPy" for one in found["targets"])
    page = (place / "docs" / "benchmark.md").read_text()
    assert "| lambert.w0 | " in page
    assert found["stamp"]["date"] in page
    drawing = (place / "docs" / "benchmark.svg").read_text()
    assert "<svg" in drawing
    assert found["stamp"]["date"] in drawing


def test_a_table_for_people_and_a_failure_of_ours(place, capsys, monkeypatch):
    """A contestant of another's that fails is noted; one of this package fails the command."""

    def fails(self, case, arguments):
        raise ValueError("on purpose")

    words = [*FEW, "--functions", "special.sin"]
    with monkeypatch.context() as patch:
        patch.setattr("galileo_sym.bench.typed.SciPy.prepare", fails)
        assert cli.main(words) == 0
        told = capsys.readouterr().out
        assert "missing: SciPy, special.sin: ValueError: on purpose" in told
        assert "special.sin: time" in told
    monkeypatch.setattr(contestants.NumpyKernels, "prepare", fails)
    assert cli.main(words) == 1
    assert "problem: NumPy, special.sin: ValueError: on purpose" in capsys.readouterr().out


def test_a_target_that_is_not_held_counts_if_strict(place, capsys, monkeypatch):
    monkeypatch.setattr("galileo_sym.bench.targets.IMPORT_MS", 0.0)
    words = [*FEW, "--functions", "special.sin"]
    assert cli.main(words) == 0
    assert "not held" in capsys.readouterr().out
    assert cli.main([*words, "--strict"]) == 1


def test_bad_usage(place, capsys, monkeypatch):
    assert cli.main([*FEW, "--functions", "chord.descend_time"]) == 2
    assert "nearest: chord.descent_time" in capsys.readouterr().err
    (place / "docs").rmdir()
    assert cli.main([*FEW, "--publish"]) == 2
    monkeypatch.setattr(commands, "find_spec", lambda name: None)
    assert cli.main([*FEW]) == 2
    assert "pip install" in capsys.readouterr().err
