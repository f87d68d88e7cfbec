"""The certificate of scenes: complete, within its bound, held by fresh points; an error of 8 ulp is found."""

import json

import numpy as np
import pytest

from galileo_sym import scene_certificate
from galileo_sym.cli import main
from galileo_sym.scenes import Scene

ROWS = json.loads(scene_certificate.path().read_text())["rows"]


def test_the_committed_certificate_is_complete_and_within_its_bound():
    places = [(row["system"], row["forces"], row["stratum"]) for row in ROWS]
    wanted = {
        (system, scene_certificate.force_set(system, forces), stratum)
        for system, forces in scene_certificate.variants()
        for stratum in scene_certificate.strata(forces)
    }
    assert set(places) == wanted
    assert len(places) == len(wanted) == 4 * 6 + 2
    assert all(row["measured"] <= row["bound"] == scene_certificate.BOUND for row in ROWS)
    assert {row["stratum"] for row in ROWS if not row["measured"]} == {"before 0", "at rest"}  # nothing moves: exact
    assert all("numpy" in row["back_ends"] and row["points"] >= scene_certificate.POINTS for row in ROWS)
    assert {row["subsets"] for row in ROWS} == {2**8 - 1, 2**6 - 1, 2**4 - 1}


@pytest.fixture
def numpy_alone(monkeypatch):
    monkeypatch.setattr(scene_certificate, "_back_ends", lambda scene: {"numpy": scene})


@pytest.mark.usefixtures("numpy_alone")
@pytest.mark.parametrize("stratum", ["typical", "arrived"])
@pytest.mark.parametrize(("system", "forces"), scene_certificate.variants())
def test_fresh_points_and_the_worst_one_recorded_are_within_the_bound(system, forces, stratum):
    name = scene_certificate.force_set(system, forces)
    (row,) = (r for r in ROWS if (r["system"], r["forces"], r["stratum"]) == (system, name, stratum))
    recorded = scene_certificate.from_hex(row["worst"])
    fresh = scene_certificate.measure(system, forces, stratum, 8, 77, recorded)
    assert row["measured"] * 0.99 <= fresh["measured"] <= scene_certificate.BOUND


@pytest.mark.usefixtures("numpy_alone")
def test_an_error_of_8_ulp_is_found(monkeypatch):
    before = Scene.__call__
    monkeypatch.setattr(
        Scene, "__call__", lambda self, **given: tuple(x + 8 * np.spacing(x) for x in before(self, **given))
    )
    assert scene_certificate.measure("chord", ("gamma",), "typical", 4, 1)["measured"] > 6.0


@pytest.mark.usefixtures("numpy_alone")
@pytest.mark.parametrize("stratum", ["arrived", "before 0", "at rest"])
def test_a_bead_that_does_not_stay_is_found(monkeypatch, stratum):
    """Scenes that go on for ever, with times before 0 counted from 0."""
    before = Scene.__init__
    monkeypatch.setattr(
        Scene, "__init__", lambda self, *names, **given: before(self, *names, **given | {"until": "forever"})
    )
    if stratum == "before 0":
        at = Scene.__call__
        monkeypatch.setattr(Scene, "__call__", lambda self, *, t, theta: at(self, t=np.abs(t), theta=theta))
    if stratum == "at rest":
        monkeypatch.setitem(scene_certificate.STRATA, stratum, scene_certificate.STRATA["arrived"])
    assert scene_certificate.measure("chord", ("mu",), stratum, 8, 1)["measured"] > scene_certificate.BOUND


@pytest.mark.usefixtures("numpy_alone")
def test_the_command_holds_scenes_beside_functions(monkeypatch, capsys):
    monkeypatch.setattr(scene_certificate, "variants", lambda: [("projectile", ())])
    assert main(["verify", "scenes", "--points", "8"]) == 0
    assert "scenes: all held" in capsys.readouterr().out
    monkeypatch.setattr(scene_certificate, "BOUND", 0.1)
    assert main(["verify", "scenes", "--points", "8", "--json"]) == 1
    told = json.loads(capsys.readouterr().out)["scenes"]
    assert not told["held"]
    assert "errs by" in told["problems"][0]


@pytest.mark.usefixtures("numpy_alone")
def test_an_update_is_written_only_if_all_held(monkeypatch, tmp_path):
    monkeypatch.setattr(scene_certificate, "variants", lambda: [("projectile", ())])
    monkeypatch.setattr(scene_certificate, "path", lambda: tmp_path / "scenes.json")
    rows, problems = scene_certificate.verify(points=8, update=False)
    assert "not in the certificate" in problems[0]
    rows, problems = scene_certificate.verify(points=8, update=True, date="2026-11-24")
    assert problems == []
    assert json.loads((tmp_path / "scenes.json").read_text())["rows"] == rows
    monkeypatch.setattr(scene_certificate, "BOUND", 0.1)
    before = (tmp_path / "scenes.json").read_bytes()
    assert scene_certificate.verify(points=8, update=True)[1]
    assert (tmp_path / "scenes.json").read_bytes() == before
