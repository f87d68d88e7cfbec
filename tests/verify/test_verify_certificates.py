"""Certificates that do not fit fail and are renewed; no update leaves less than there was."""

import json

import pytest
from verify_few_points import NAME, POINTS, edit, rename_stratum, verify

from galileo_sym import files
from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.strata import strata_names

pytestmark = pytest.mark.usefixtures("few_points")


def test_no_certificate(folder):
    code, text = verify(folder)
    assert code == 1
    assert f"{NAME}: no certificate; run `galileo-sym verify --update`" in text
    assert not folder.exists()


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
        (loosen, "claims 9.0 ulp where the function claims 1.0"),
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
        (give("measured", 1e9), "measured maximum 1000000000.0 is not between 0 and its bound 1.0"),
        (give("measured", -5), "measured maximum -5 is not between 0 and its bound 1.0"),
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
