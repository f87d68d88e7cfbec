"""The whole run on stand-in back ends: what holds, and every way in which it must fail."""

import io
import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest
from verify_stand_in import Rounded, Weakened

from galileo_sym import files
from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.run import run
from galileo_sym.verify.strata import strata_names

POINTS = 6
NAME = "projectile.flight_time"


@pytest.fixture(autouse=True)
def _few_points_by_default(monkeypatch):
    monkeypatch.setattr("galileo_sym.verify.run.DEFAULT_POINTS", POINTS)


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "certificates"


def verify(folder, *back_ends, names=(NAME,), **options):
    """Exit code and output of a run with few points."""
    out, err = io.StringIO(), io.StringIO()
    options = {"points": POINTS, "processes": 1, "date": "2026-01-02"} | options
    code = run(names, back_ends=list(back_ends) or [Rounded()], certificates=folder, out=out, err=err, **options)
    return code, out.getvalue() + err.getvalue()


@pytest.fixture
def certified(folder):
    code, text = verify(folder, update=True)
    assert code == 0, text
    return folder


def edit(folder, change, name=NAME):
    path = folder / f"{name}.json"
    content = json.loads(path.read_text())
    change(content)
    path.write_text(json.dumps(content))


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
            assert record["bound"] == 4.0
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


def near_zero(force_set, point):
    return force_set == "drag" and 0 < point["theta"] < 2.0**-9


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


def test_a_recorded_worst_input_may_not_get_worse(certified):
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


def test_back_ends_must_agree_to_the_bit(certified):
    other = Weakened(1, near_zero, name="other")
    code, text = verify(certified, Rounded(), other)
    assert code == 1
    assert "bits differ from rounded, first at theta=0x1." in text
    code, text = verify(certified, Rounded(), Rounded("twin"))
    assert code == 0
    assert "rounded = twin" in text


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


# --- certificates that do not fit ------------------------------------------------------------------------------------


def test_no_certificate(folder):
    code, text = verify(folder)
    assert code == 1
    assert f"{NAME}: no certificate; run `galileo-sym verify --update`" in text
    assert not folder.exists()


def rename_stratum(content):
    content["force_sets"]["drag"]["tipical"] = content["force_sets"]["drag"].pop("typical")


def loosen(content):
    content["force_sets"]["drag"]["typical"]["bound"] = 9.0


def drop_force_set(content):
    del content["force_sets"]["drag"]


def spoil_worst(content):
    content["force_sets"]["drag"]["typical"]["worst"]["k"] = "soon"


def other_arguments(content):
    del content["force_sets"]["drag"]["typical"]["worst"]["k"]


def strange_force(content):
    content["force_sets"]["magnetism"] = {}


def leave_domain(content):
    content["force_sets"]["drag"]["typical"]["worst"]["v"] = "-0x1p+0"


def overflow_worst(content):
    content["force_sets"]["drag"]["typical"]["worst"]["v"] = "0x1p+9999"


def give(key, value):
    """A change of one value in one record."""

    def change(content):
        content["force_sets"]["drag"]["typical"][key] = value

    return change


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (rename_stratum, "tipical: unknown stratum"),
        (rename_stratum, "[drag] typical: not in the certificate"),
        (loosen, "claims 9.0 ulp where the function claims 4.0"),
        (drop_force_set, "[drag]: not in the certificate"),
        (spoil_worst, "unreadable record"),
        (other_arguments, "its worst input has other arguments"),
        (strange_force, "unknown force set 'magnetism'"),
        (leave_domain, "its worst input lies outside the domain (v)"),
        (overflow_worst, "unreadable record"),
        (give("bound", "nan"), "must be finite numbers"),
        (give("bound", float("nan")), "must be finite numbers"),
        (give("bound", True), "must be finite numbers"),
        (give("measured", "-5"), "must be finite numbers"),
        (give("measured", float("nan")), "must be finite numbers"),
        (give("measured", 1e9), "measured maximum 1000000000.0 is not between 0 and its bound 4.0"),
        (give("measured", -5), "measured maximum -5 is not between 0 and its bound 4.0"),
        (give("output", "weight"), "unreadable record (output 'weight'"),
        (give("points", "many"), "unreadable record (output 'time', points 'many'"),
        (give("back_ends", None), "unreadable record"),
    ],
)
def test_certificates_that_do_not_fit_fail_and_are_renewed(certified, change, message):
    edit(certified, change)
    code, text = verify(certified)
    assert code == 1
    assert message in text
    assert verify(certified, update=True)[0] == 0
    assert verify(certified)[0] == 0


def test_unreadable_and_stale_certificates(certified):
    (certified / f"{NAME}.json").write_text("{")
    (certified / "chord.pendulum.json").write_text("{}")
    code, text = verify(certified)
    assert code == 1
    assert "unreadable certificate" in text
    assert "chord.pendulum.json belongs to no function" in text


def test_an_interrupted_update_leaves_old_certificates_whole(certified, monkeypatch):
    before = (certified / f"{NAME}.json").read_bytes()

    def interrupted(source, target):
        raise KeyboardInterrupt

    monkeypatch.setattr(files.os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        verify(certified, update=True, date="2026-03-04")
    assert (certified / f"{NAME}.json").read_bytes() == before
    assert list(certified.iterdir()) == [certified / f"{NAME}.json"]


def test_updating_one_stratum_keeps_the_others(certified):
    assert verify(certified, update=True, seed=5, strata=("typical",))[0] == 0
    content = json.loads((certified / f"{NAME}.json").read_text())
    assert list(content["force_sets"]["drag"]) == strata_names(FUNCTIONS[NAME], "drag")
    assert verify(certified)[0] == 0


# --- updates that would leave less than there was --------------------------------------------------------------------


def test_single_strata_are_merged_into_whole_certificates_only(certified):
    path = certified / f"{NAME}.json"
    path.write_text("{")
    code, text = verify(certified, update=True, strata=("typical",))
    assert code == 2
    assert "needs a whole certificate" in text
    assert "leave --stratum out" in text
    assert path.read_text() == "{"
    path.unlink()
    assert verify(certified, update=True, strata=("typical",))[0] == 2
    assert not path.exists()
    assert verify(certified, update=True)[0] == 0


def test_a_damaged_stratum_can_be_renewed_alone(certified):
    whole = (certified / f"{NAME}.json").read_bytes()
    edit(certified, rename_stratum)
    assert verify(certified, update=True, strata=("scenes",))[0] == 2
    assert verify(certified, update=True, strata=("typical",))[0] == 0
    assert (certified / f"{NAME}.json").read_bytes() == whole


def test_records_are_not_replaced_by_those_of_fewer_points(certified, monkeypatch):
    before = (certified / f"{NAME}.json").read_bytes()
    code, text = verify(certified, update=True, points=POINTS - 1)
    assert code == 2
    assert f"it takes {POINTS} points at least: leave --points out" in text
    assert (certified / f"{NAME}.json").read_bytes() == before
    # lists of points have their own number, and a record of no more points may be renewed with as few
    assert verify(certified, update=True, points=POINTS - 1, strata=("scenes",))[0] == 0
    monkeypatch.setattr("galileo_sym.verify.run.DEFAULT_POINTS", POINTS + 1)
    assert verify(certified, update=True, points=POINTS)[0] == 0


def test_no_certificate_begins_with_fewer_points_than_the_default(folder):
    assert verify(folder, update=True, points=POINTS - 1)[0] == 2
    assert not folder.exists()


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
