"""The command that explains a scene: what it prints, as JSON too, and its exit codes."""

import json

import pytest

from galileo_sym import Scene
from galileo_sym.cli import main

SPINDLE = ("scene", "chord", "--over", "t,theta", "--outputs", "x,y", "--set", "g=9.81", "mu=0.36")


def call(capsys, *words):
    """Exit code, standard output and standard error of a command."""
    try:
        code = main(list(words))
    except SystemExit as end:
        code = end.code
    return code, *capsys.readouterr()


def test_a_scene_is_explained(capsys):
    scene = Scene("chord", over=("t", "theta"), outputs=("x", "y"), g=9.81, mu=0.36)
    assert call(capsys, *SPINDLE) == (0, f"{scene.explain()}\n", "")
    code, text, _ = call(capsys, *SPINDLE, "--lengths", "t=1000,theta=1000")
    assert (code, text) == (0, f"{scene.explain(t=1000, theta=1000)}\n")


def test_json_holds_the_plan_and_the_counts(capsys):
    code, text, _ = call(capsys, *SPINDLE, "--set", "gamma=0.5", "--lengths", "t=10,theta=20", "--json")
    document = json.loads(text)
    assert code == 0
    assert document["forces"] == ["friction", "drag"]
    assert document["constants"] == {"g": 9.81, "mu": 0.36, "gamma": 0.5}
    assert {"over": ["t", "theta"], "multiply": 400} in document["counts"]
    assert [step["name"] for step in document["steps"]][-2:] == ["x", "y"]


def test_a_scene_is_written_as_a_file(capsys, tmp_path):
    path = str(tmp_path / "spindle.c")
    assert call(capsys, *SPINDLE, "--emit", "c", "-o", path) == (0, f"{path}\n", "")
    assert "void spindle(size_t n_t, const double *restrict t," in (tmp_path / "spindle.c").read_text()


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--set", "gama=1"), "nearest: gamma"),
        (("--set", "mu=0.3"), "twice"),
        (("--set", "mu"), "not a name, '=' and a number"),
        (("--outputs", "z"), "no output of chord scenes"),
        (("--lengths", "t=3"), "theta= is missing"),
        (("--lengths", "t=three"), "a whole number"),
        (("--emit", "c"), "go together"),
        (("--emit", "fortran", "-o", "spindle.f"), "no language"),
        (("--until", "arrival"), "give diameter="),
    ],
)
def test_bad_usage_is_exit_code_2(capsys, words, told):
    code, text, message = call(capsys, *SPINDLE, *words)
    assert (code, text) == (2, "")
    assert told in message
