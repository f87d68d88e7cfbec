"""Large samples: what the page says, what fails, and that an interrupted run goes on."""

import re
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))

import large_samples  # noqa: E402

from galileo_sym.verify import measure  # noqa: E402
from galileo_sym.verify.back_ends import NumpyFunctions  # noqa: E402
from galileo_sym.verify.functions import FUNCTIONS  # noqa: E402
from galileo_sym.verify.reference import reference  # noqa: E402
from galileo_sym.verify.strata import strata_names  # noqa: E402
from galileo_sym.verify.ulp import ulp_error  # noqa: E402

NAME = "chord.synchronous_circle"
STRATA = [
    (NAME, force_set, s) for force_set in FUNCTIONS[NAME].force_sets for s in strata_names(FUNCTIONS[NAME], force_set)
]
RUN = ["--points", "5", "--processes", "1"]


class Wrong(NumpyFunctions):
    """The last output is twice the right one."""

    def evaluate(self, function, force_set, arguments):
        *others, last = super().evaluate(function, force_set, arguments)
        return (*others, 2 * last)


@pytest.fixture(autouse=True)
def one_function(monkeypatch):
    """All is one function, by NumPy."""
    monkeypatch.setattr(large_samples, "select_functions", lambda names: [NAME])
    monkeypatch.setattr(large_samples, "available_back_ends", lambda tell: [NumpyFunctions()])


def test_every_output_has_a_row_whose_error_is_that_at_its_input(tmp_path, capsys):
    assert large_samples.main(["--check"], tmp_path) == 1
    assert large_samples.main(RUN, tmp_path) == 0
    lines = (tmp_path / "docs" / "large_samples.md").read_text().splitlines()
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("| `")]
    function = FUNCTIONS[NAME]
    assert [(force_set, output) for _, force_set, output, *_ in rows] == [
        (force_set, output) for force_set in function.force_sets for output in function.outputs
    ]
    for _, force_set, output, points, error, stratum, _, at in rows:
        point = {name: float.fromhex(text) for name, text in re.findall(r"(\w+)=(\S+)", at)}
        place = function.outputs.index(output)
        exact = reference(NAME, {**dict.fromkeys(function.absent_forces(force_set), 0.0), **point})[place]
        arrays = {name: np.array([value]) for name, value in point.items()}
        value = NumpyFunctions().evaluate(function, force_set, arrays)[place][0]
        assert ulp_error(value, exact) <= float(error.split()[1]) <= 1.01 * ulp_error(value, exact) + 1e-9
        assert int(points) >= 5 * 4
        assert (NAME, force_set, stratum) in STRATA
    assert not (tmp_path / "build" / "large_samples.jsonl").exists()
    assert large_samples.main(["--check"], tmp_path) == 0
    page = tmp_path / "docs" / "large_samples.md"
    page.write_text(page.read_text().replace(large_samples.digest(), "0123456789abcdef"))
    assert large_samples.main(["--check"], tmp_path) == 1
    assert "stale" in capsys.readouterr().out


def test_what_fails_is_told_and_no_page_written(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(large_samples, "available_back_ends", lambda tell: [Wrong()])
    assert large_samples.main(RUN, tmp_path) == 1
    assert f"failed: {NAME} drag typical: numpy: exceeds its bound" in capsys.readouterr().out
    assert not (tmp_path / "docs").exists()


def test_an_interrupted_run_goes_on_where_it_stopped(tmp_path, monkeypatch, capsys):
    taken, most = [], 7

    def take(task):
        if len(taken) == most:
            raise KeyboardInterrupt
        taken.append((task.function, task.force_set, task.stratum))
        return measure.take_sample(task)

    monkeypatch.setattr("galileo_sym.verify.run.take_sample", take)
    with pytest.raises(KeyboardInterrupt):
        large_samples.main(RUN, tmp_path)
    state = tmp_path / "build" / "large_samples.jsonl"
    state.write_text(state.read_text() + '{"place": ["cut off"')
    most = len(STRATA) + 1
    assert large_samples.main(RUN, tmp_path) == 0
    assert taken == STRATA
    assert "anew" not in capsys.readouterr().err


def test_what_was_found_with_another_seed_is_left(tmp_path, monkeypatch, capsys):
    state = tmp_path / "build" / "large_samples.jsonl"
    state.parent.mkdir()
    state.write_text('{"sources": "0123456789abcdef", "points": 5, "seed": 2014}\n')
    assert large_samples.main(RUN, tmp_path) == 0
    assert "anew" in capsys.readouterr().err
