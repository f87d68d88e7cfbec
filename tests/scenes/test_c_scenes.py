"""Emitted and compiled scenes: C that compiles alone under both compilers, without a warning, and agrees with NumPy."""

import os
import pickle
import shutil
import subprocess
import sys

import numpy as np
import pytest
from scene_grids import OUTPUTS, axes, scene

from galileo_sym import Scene
from galileo_sym.libraries import NoCompilerError, find_compiler
from galileo_sym.scenes.c_source import source
from galileo_sym.scenes.compiled import Compiled
from galileo_sym.store import FOLDER

STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-ffp-contract=off")
SPINDLE = Scene("chord", over=("t", "theta"), outputs=("x", "y"), g=9.81, mu=0.36, gamma=0.5)


@pytest.fixture(autouse=True)
def _compiler(monkeypatch):
    """Compilers are quick here."""
    monkeypatch.setattr("galileo_sym.scenes.compiled._FLAGS", ("-std=c99", "-O1", "-ffp-contract=off", "-fPIC"))
    try:
        find_compiler()
    except NoCompilerError as cause:
        pytest.skip(f"compiled scenes are not tested: {cause}")


def agree(one, other, ulp=1):
    """Numbers within some ulp, the same infinities, NaN in the same places."""
    for a, b in zip(one, other, strict=True):
        finite = np.isfinite(b)
        np.testing.assert_array_equal(np.isnan(a), np.isnan(b))
        np.testing.assert_array_equal(np.where(finite, 0.0, a), np.where(finite, 0.0, b))
        assert np.all(np.abs(a[finite] - b[finite]) <= ulp * np.spacing(np.abs(b[finite])))


@pytest.mark.parametrize(("system", "force_set"), [("chord", "friction_drag"), ("projectile", "drag")])
def test_c_and_numpy_agree_at_the_ends_of_the_range_too(system, force_set, tmp_path, monkeypatch):
    monkeypatch.setenv(FOLDER, str(tmp_path))
    shown = scene(system, force_set, OUTPUTS[system])
    given = {name: np.append(values, np.nan) for name, values in axes(system).items()}
    with np.errstate(over="ignore", under="ignore"):
        agree(shown.compile()(**given), shown(**given))


@pytest.mark.parametrize(
    ("system", "force_set", "over", "until", "more"),
    [
        ("chord", "friction_drag", ("gamma", "t", "theta"), "arrival", {}),
        ("chord", "friction", ("mu", "theta"), "arrival", {"t": 0.3}),
        ("projectile", "drag", ("theta", "t"), "landing", {}),
        ("projectile", "free", ("v", "theta", "g"), "landing", {"t": 0.3}),
    ],
)
def test_other_axes_and_motions_that_end(system, force_set, over, until, more, tmp_path, monkeypatch):
    monkeypatch.setenv(FOLDER, str(tmp_path))
    values = {
        "t": np.linspace(-0.5, 6.0, 14),
        "theta": axes(system)["theta"],
        "g": np.array([1e-200, 9.81]),
        "gamma": np.array([0.0, 0.7, 40.0]),
        "mu": np.array([0.0, 0.3, 5.0]),
        "v": np.array([1.0, 5e3]),
    }
    shown = scene(system, force_set, OUTPUTS[system], over, until, **more)
    given = {name: values[name] for name in over}
    with np.errstate(invalid="ignore", under="ignore"):
        agree(shown.compile()(**given), shown(**given), ulp=2)


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_emitted_c_compiles_alone_and_holds_no_more_than_it_needs(compiler, tmp_path):
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    SPINDLE.emit("c", tmp_path / "spindle.c")
    text = (tmp_path / "spindle.c").read_text()
    for more in ("-O0", "-O3"):
        command = [compiler, *STRICT, more, "-c", "spindle.c", "-o", "spindle.o"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")
    assert "gs_phi2m" in text
    for absent in ("phi1m", "phi0m", "gs_sqrt", "malloc(", "errno", "galileo.h"):
        assert absent not in text
    assert text == source(SPINDLE.separate_plan, "spindle")


def test_without_drag_the_emitted_c_has_no_table_of_it():
    whole, lean = (source(s.separate_plan, "f") for s in (SPINDLE, SPINDLE.without("drag")))
    assert len(lean.splitlines()) < len(whole.splitlines()) / 1.5
    assert "gs_lookup" not in lean


def test_an_emitted_file_is_named_as_its_function(tmp_path):
    for name in ("the-spindle.c", "int.c", "lambda.c", "gs_mul.c"):
        with pytest.raises(ValueError, match="no name of a function"):
            SPINDLE.emit("c", tmp_path / name)
    with pytest.raises(ValueError, match="no language"):
        SPINDLE.emit("fortran", tmp_path / "spindle.f90")
    assert list(tmp_path.iterdir()) == []


def test_the_library_is_kept_by_content_and_by_two_processes_at_once(tmp_path):
    words = (
        "from galileo_sym import Scene; "
        "print(Scene('chord', over=('t', 'theta'), outputs='x', g=9.81, mu=0.36).compile().library)"
    )
    command, environment = [sys.executable, "-c", words], {**os.environ, FOLDER: str(tmp_path)}
    both = [subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    paths = [process.communicate(timeout=60)[0].strip() for process in both]
    assert paths[0] == paths[1]
    assert [str(path) for path in tmp_path.rglob("*.so")] == paths[:1]


def test_a_compiled_scene_is_called_as_the_scene(tmp_path, monkeypatch):
    monkeypatch.setenv(FOLDER, str(tmp_path))
    made, t, theta = SPINDLE.compile(), np.linspace(0, 1, 6), np.linspace(-1, 1, 8)
    assert isinstance(made, Compiled)
    x, y = SPINDLE(t=t, theta=theta)
    out = np.empty((6, 8), np.float32), np.empty((8, 6)).T
    found = made(t=t, theta=theta, out=out)
    assert found[1] is out[1]
    np.testing.assert_array_equal(out[0], x.astype(np.float32))
    np.testing.assert_array_equal(out[1], y)
    np.testing.assert_array_equal(made(t=t.reshape(2, 3), theta=theta)[0], x.reshape(2, 3, 8))
    np.testing.assert_array_equal(made(grid=False, t=t, theta=theta[:6]), SPINDLE(grid=False, t=t, theta=theta[:6]))
    assert isinstance(made(t=0.5, theta=0.2)[0], np.float64)
    assert pickle.loads(pickle.dumps(made)).scene == SPINDLE
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
        made(t=[-1.0], theta=theta)
    with pytest.raises(TypeError, match="give theta="):
        made(t=t)


def test_without_a_compiler_numpy_serves_and_says_so(monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.warns(RuntimeWarning, match="no-such-compiler"):
        assert SPINDLE.compile() is SPINDLE


def states(function, **axes):
    """Names of the error states of NumPy that a call raises."""
    seen = set()
    with np.errstate(all="call", call=lambda name, flag: seen.add(name)):
        function(**axes)
    return seen


@pytest.mark.parametrize(
    ("t", "theta", "raised"),
    [
        (0.5, 0.2, set()),
        (np.nan, 0.2, set()),
        (np.inf, np.pi / 2, set()),
        (1e308, 0.2, {"overflow"}),
        (1e-170, 0.2, {"underflow"}),
        (0.5, 1e-308, {"underflow"}),
        (-1.0, 0.2, {"invalid value"}),
        ([1e308, 1e-170, 1.0], [2.0, 0.2], {"overflow", "underflow", "invalid value"}),
    ],
)
def test_error_states_are_those_of_the_scene(t, theta, raised):
    assert states(SPINDLE, t=t, theta=theta) == raised
    assert states(SPINDLE.compile(), t=t, theta=theta) == raised


def test_rests_that_vanish_in_a_sum_are_no_underflow():
    scene = Scene("projectile", over=("t", "theta"), outputs="y", v=1.5, g=9.81)
    axes = {"t": np.array([2.0**-480 / 3]), "theta": np.array([2.0**-490 / 3])}
    assert states(scene, **axes) == states(scene.compile(), **axes) == set()
    assert (
        scene(**axes)
        == scene.compile()(**axes)
        == pytest.approx(1.5 * 2.0**-970 / 9 - 4.905 * 2.0**-960 / 9, rel=1e-15)
    )
