"""Scenes emitted as modules of NumPy: self-contained, no more in them than they need, the bits of the scene."""

import importlib.util
import subprocess
import sys

import numpy as np
import pytest
from scene_grids import CASES, OUTPUTS, axes, scene

from galileo_sym import Scene
from galileo_sym.scenes.python_closure import closure

SPINDLE = Scene("chord", over=("t", "theta"), outputs=("x", "y"), g=9.81, mu=0.36, gamma=0.5)


def emitted(shown, folder):
    """The function of an emitted scene."""
    path = folder / "shown.py"
    shown.emit("numpy", path)
    spec = importlib.util.spec_from_file_location("shown", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.shown


@pytest.mark.parametrize("ending", [False, True])
@pytest.mark.parametrize(("system", "force_set"), CASES)
def test_the_bits_are_those_of_the_scene(system, force_set, ending, tmp_path):
    until = {"chord": "arrival", "projectile": "landing"}[system] if ending else "forever"
    shown = scene(system, force_set, OUTPUTS[system], until=until)
    given = {name: np.append(values, np.nan) for name, values in axes(system).items()}
    with np.errstate(over="ignore", under="ignore"):
        for found, wanted in zip(emitted(shown, tmp_path)(**given), shown(**given), strict=True):
            finite = np.isfinite(wanted)
            np.testing.assert_array_equal(np.isfinite(found), finite)
            assert np.all(np.abs(found[finite] - wanted[finite]) <= np.spacing(np.abs(wanted[finite])))


def test_it_needs_numpy_alone_and_holds_no_more_than_it_needs(tmp_path):
    SPINDLE.emit("numpy", tmp_path / "spindle.py")
    text = (tmp_path / "spindle.py").read_text()
    assert "phi2m" in text
    for absent in ("phi1m", "phi0m", "sqrt", "descent_factor", "elevation", "from .", "import galileo_sym"):
        assert absent not in text
    words = (
        "import sys, numpy; import spindle; x, y = spindle.spindle([0.1, 0.2], [0.3]); print(x.shape);"
        "assert not any(name.startswith('galileo') for name in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", words], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == "(2, 1)\n"


def test_arguments_outside_their_domains_raise_invalid(tmp_path):
    function = emitted(SPINDLE, tmp_path)
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
        function([-1.0], [0.1])


def test_a_dictionary_keeps_the_entries_that_are_named():
    text = closure("phi1m")
    assert '"phi1m": {' in text
    assert '"phi2m"' not in text


def test_error_states_are_those_of_the_scene(tmp_path):
    def states(function, *given, **axes):
        seen = set()
        with np.errstate(all="call", call=lambda name, flag: seen.add(name)):
            function(*given, **axes)
        return seen

    function = emitted(SPINDLE, tmp_path)
    for t, theta, raised in (
        (0.5, 0.2, set()),
        (1e308, 0.2, {"overflow"}),
        (1e308, 1.5, set()),  # at rest
        (1e-170, 0.2, {"underflow"}),
        (-1.0, 0.2, {"invalid value"}),
    ):
        assert states(function, [t], [theta]) == states(SPINDLE, t=[t], theta=[theta]) == raised
