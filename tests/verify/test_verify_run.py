"""The whole run on stand-in back ends: what holds, and every way in which a back end must fail."""

import json
import math
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from verify_few_points import NAME, near_zero, verify
from verify_stand_in import Rounded, Weakened

from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.strata import strata_names

pytestmark = pytest.mark.usefixtures("few_points")


def test_a_certificate_holds_what_it_was_made_from(certified):
    code, text = verify(certified)
    assert code == 0
    assert "all held" in text
    for force_set in ("free", "drag"):
        for stratum in strata_names(FUNCTIONS[NAME], force_set):
            assert stratum in text


def test_certificate_content(certified):
    content = json.loads((certified / f"{NAME}.json").read_text())
    assert list(content) == ["function", "date", "seed", "measured", "unit", "force_sets"]
    assert content["date"] == "2026-01-02"
    assert list(content["force_sets"]) == ["free", "drag"]
    for force_set, strata in content["force_sets"].items():
        assert list(strata) == strata_names(FUNCTIONS[NAME], force_set)
        for record in strata.values():
            assert list(record) == ["bound", "measured", "output", "worst", "points", "back_ends"]
            assert record["bound"] == 1.0
            assert 0 <= record["measured"] <= 0.501
            assert list(record["worst"]) == list(FUNCTIONS[NAME].arguments(force_set))
            assert all(math.isfinite(float.fromhex(text)) for text in record["worst"].values())
            assert record["points"] >= 1
            assert record["back_ends"] == ["rounded"]


def test_update_twice_writes_the_same_bytes(certified):
    before = (certified / f"{NAME}.json").read_bytes()
    assert verify(certified, update=True)[0] == 0
    assert (certified / f"{NAME}.json").read_bytes() == before
    assert list(certified.iterdir()) == [certified / f"{NAME}.json"]


def test_verifying_writes_nothing_and_processes_do_not_matter(certified, monkeypatch):
    before = (certified / f"{NAME}.json").read_bytes()
    monkeypatch.setattr("galileo_sym.verify.run._WORTH_A_PROCESS", 0)
    code, text = verify(certified, processes=2)
    assert code == 0
    assert text == verify(certified)[1]
    assert (certified / f"{NAME}.json").read_bytes() == before


# --- negative controls -----------------------------------------------------------------------------------------------


def test_eight_ulps_on_one_stratum_are_found(certified):
    code, text = verify(certified, Weakened(8, near_zero))
    assert code == 1
    failed = [line for line in text.splitlines() if line.startswith("failed:")]
    assert failed
    assert all("[drag] theta-near-0" in line or "[drag] extreme" in line for line in failed)
    assert any("[drag] theta-near-0" in line and "exceeds its bound" in line for line in failed)


@pytest.mark.parametrize("name", list(FUNCTIONS))
def test_eight_ulps_are_found_in_every_function(folder, name):
    weak = Weakened(8, lambda force_set, point: True)
    code, text = verify(folder, weak, names=(name,), update=True)
    assert code == 1
    assert text.count("exceeds its bound") >= len(FUNCTIONS[name].force_sets)
    assert not folder.exists()


def test_eight_ulps_pass_where_a_certificate_would_not_be_held(folder):
    """The control of the control: the same run with an honest back end holds."""
    assert verify(folder, Rounded(), names=("chord",), update=True)[0] == 0


def test_an_update_does_not_certify_what_fails(certified):
    before = (certified / f"{NAME}.json").read_bytes()
    assert verify(certified, Weakened(8, near_zero), update=True)[0] == 1
    assert (certified / f"{NAME}.json").read_bytes() == before


@pytest.fixture
def generous(monkeypatch, request):
    """A function that claims four ulps, so that errors between its record and its claim can be told."""
    monkeypatch.setitem(FUNCTIONS, NAME, replace(FUNCTIONS[NAME], bound=4.0))
    return request.getfixturevalue("certified")


def test_a_recorded_worst_input_may_not_get_worse(generous):
    certified = generous
    recorded = json.loads((certified / f"{NAME}.json").read_text())["force_sets"]["drag"]["typical"]["worst"]
    worst = {name: float.fromhex(text) for name, text in recorded.items()}
    weak = Weakened(2, lambda force_set, point: force_set == "drag" and point == worst)
    code, text = verify(certified, weak, seed=77)
    assert code == 1
    assert "[drag] typical, weakened: worse than recorded" in text
    # renewing accepts it, since it is below the bound, and keeps that input
    assert verify(certified, weak, seed=77, update=True)[0] == 0
    renewed = json.loads((certified / f"{NAME}.json").read_text())["force_sets"]["drag"]["typical"]
    assert renewed["worst"] == recorded
    assert renewed["measured"] > 1.4
    assert verify(certified, weak, seed=78)[0] == 0


def test_back_ends_of_the_same_bits_are_one_row(certified):
    code, text = verify(certified, Rounded(), Rounded("twin"))
    assert code == 0
    assert text.count("rounded = twin") == text.count("twin") > 0
    _, text = verify(certified, Rounded(), Weakened(1, near_zero, name="other"))
    assert 0 < text.count("rounded = other") < text.count("other")


def test_a_back_end_that_raises_fails(certified):
    class Broken(Rounded):
        def evaluate(self, function, force_set, arguments):
            if force_set == "drag":
                raise TypeError("no such kernel")
            return super().evaluate(function, force_set, arguments)

    code, text = verify(certified, Broken())
    assert code == 1
    assert "TypeError: no such kernel" in text
    assert verify(certified, Broken(), update=True)[0] == 1


def test_a_back_end_of_nans_fails(certified):
    class Undefined(Rounded):
        def evaluate(self, function, force_set, arguments):
            return tuple(np.full_like(array, np.nan) for array in super().evaluate(function, force_set, arguments))

    code, text = verify(certified, Undefined())
    assert code == 1
    assert "exceeds its bound" in text


# --- names, options, output ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("names", "options", "message"),
    [
        (("chord.desent_time",), {}, "chord.descent_time"),
        (("flight_time",), {}, "did you mean projectile.flight_time?"),
        (("chrod",), {}, "did you mean chord"),
        (("zzz",), {}, "known: chord.descent_time"),
        ((NAME,), {"strata": ("tipical",)}, "did you mean typical"),
        ((NAME,), {"strata": ("near-theta-max",)}, "unknown stratum 'near-theta-max'"),
        ((NAME,), {"points": 0}, "at least 1"),
    ],
)
def test_bad_usage(folder, names, options, message):
    code, text = verify(folder, names=names, **options)
    assert code == 2
    assert message in text


def test_json(certified):
    code, text = verify(certified, json_output=True)
    content = json.loads(text)
    assert code == 0
    assert content["held"] is True
    assert len(content["rows"]) == sum(len(strata_names(FUNCTIONS[NAME], name)) for name in ("free", "drag"))
    first = content["rows"][0]
    assert first["function"] == NAME
    assert float.fromhex(first["worst"]["theta"]) > 0
    code, text = verify(certified, Weakened(8, near_zero), json_output=True)
    assert code == 1
    assert json.loads(text)["held"] is False


def test_progress_counts_every_stratum(certified):
    seen = []
    verify(certified, progress=lambda *state: seen.append(state))
    assert [done for done, _, _ in seen] == list(range(1, len(seen) + 1))
    assert {total for _, total, _ in seen} == {len(seen)}
    assert all(NAME in label for _, _, label in seen)


def test_points_depend_on_nothing_but_the_seed():
    script = (
        "from galileo_sym.verify.measure import Task, take_sample\n"
        "for s in ('extreme', 'near-theta-max', 'interval-ends'):\n"
        "    sample = take_sample(Task('chord.position', 'friction_drag', s, 5, 3))\n"
        "    print([[v.hex() for v in values] for values in sample.arguments.values()])\n"
    )
    outputs = {
        subprocess.run(
            [sys.executable, "-c", script],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("0", "1")
    }
    assert len(outputs) == 1
    assert outputs.pop().count("0x") == 3 * 5 * 5
