"""Values of scenes: against certain references, for all forces and sets of outputs; at the ends of the range, too."""

import numpy as np
import pytest
from scene_grids import ANGLES, CASES, CONSTANTS, FORCES, OUTPUTS, TIMES, axes, scene, subsets

from galileo_sym import Scene, chord, projectile
from galileo_sym.generated._graphs import SYSTEMS
from galileo_sym.verify.reference import reference
from galileo_sym.verify.ulp import ulp_error

MOST = 2.0  # ulp: one more than the public functions; of the larger term where there are two


@pytest.fixture(autouse=True)
def _flags():
    """Results beyond the range raise what public functions raise."""
    with np.errstate(over="ignore", under="ignore"):
        yield


def exact(system, function, t, theta, constants):
    """Enclosures of the outputs of a public function at a point."""
    rows = [row for row in SYSTEMS[system]["outputs"].values() if row["function"] == function]
    names = (*rows[0]["arguments"], *SYSTEMS[system]["forces"].values())
    if function == "chord.synchronous_circle" or "theta" not in names:
        names = tuple(name for name in names if name != "theta")
    values = {"t": t, "theta": theta, **dict.fromkeys(SYSTEMS[system]["forces"].values(), 0.0), **constants}
    return reference(function, {name: float(values[name]) for name in names})


@pytest.mark.parametrize(("system", "force_set"), CASES)
def test_errors_are_at_most_2_ulp(system, force_set):
    constants = {**CONSTANTS[system], **FORCES[system][force_set]}
    found = scene(system, force_set, OUTPUTS[system])(**axes(system))
    worst = {}
    for i, t in enumerate(TIMES):
        for j, theta in enumerate(ANGLES[system]):
            if t > 1e100 and j % 3:
                continue
            known = {}
            for output, array in zip(OUTPUTS[system], found, strict=True):
                row = SYSTEMS[system]["outputs"][output]
                if row["function"] not in known:
                    known[row["function"]] = exact(system, row["function"], t, theta, constants)
                error = ulp_error(array[i, j], known[row["function"]][row["index"]])
                worst[output] = max(worst.get(output, 0.0), error)
    assert max(worst.values()) <= MOST, worst


@pytest.mark.parametrize(("system", "force_set"), CASES)
def test_an_output_has_the_same_bits_whatever_else_is_asked_for(system, force_set):
    everything = scene(system, force_set, OUTPUTS[system])
    values = dict(zip(OUTPUTS[system], everything(**axes(system)), strict=True))
    for chosen in subsets(system):
        for name, array in zip(chosen, everything.with_outputs(chosen)(**axes(system)), strict=True):
            assert np.array_equal(array, values[name])


@pytest.mark.parametrize("over", [("theta", "t"), ("t", "theta", "g"), ("g", "t", "theta"), ("t",), ("theta",)])
@pytest.mark.parametrize(("system", "force_set"), CASES)
def test_other_axes_give_what_the_public_functions_give(system, force_set, over):
    """Measured in ulp of the larger term where there are two: of the values without the cancelling one."""
    values = {"t": np.array([0.0, 0.3, 1.1]), "theta": np.array([0.1, 0.6, 1.1]), "g": np.array([1.62, 9.81])}
    fixed = {name: float(values[name][1]) for name in ("t", "theta") if name not in over}
    chosen = OUTPUTS[system]
    found = scene(system, force_set, chosen, over, **fixed)(**{name: values[name] for name in over})
    grid = dict(zip(over, np.meshgrid(*(values[name] for name in over), indexing="ij"), strict=True))
    given = {**CONSTANTS[system], **FORCES[system][force_set], **fixed, **grid}
    module = {"chord": chord, "projectile": projectile}[system]
    for output, array in zip(chosen, found, strict=True):
        row = SYSTEMS[system]["outputs"][output]
        function = getattr(module, row["function"].split(".")[1])
        names = [name for name in (*row["arguments"], *FORCES[system][force_set]) if name not in ("t", "theta")]
        positional = [given[name] for name in ("t", "theta") if name in row["arguments"]]
        expected = function(*positional, **{name: given[name] for name in names})
        expected = np.asarray(expected[row["index"]] if isinstance(expected, tuple) else expected)
        term = np.maximum(np.abs(expected), 31.7 * given["t"] if output == "y" else 31.7 if output == "vy" else 0.0)
        finite = np.isfinite(expected)
        assert np.array_equal(array, np.broadcast_to(expected, array.shape), equal_nan=True) or np.all(
            np.abs(array - expected)[finite] <= 3 * np.spacing(np.broadcast_to(term, array.shape))[finite]
        ), output


def test_where_friction_all_but_holds_the_bead():
    theta = np.nextafter(np.arctan(1 / 0.36), [-9.0, 9.0])
    theta = np.concatenate([theta, np.arctan(1 / 0.36) + np.arange(-3, 4) * 2.0**-52])
    x, y = Scene("chord", over=("t", "theta"), outputs=("x", "y"), g=9.81, mu=0.36, gamma=0.7)(t=[0.4], theta=theta)
    for j, angle in enumerate(theta):
        exact_x, exact_y = reference("chord.position", {"t": 0.4, "theta": angle, "g": 9.81, "mu": 0.36, "gamma": 0.7})
        assert ulp_error(x[0, j], exact_x) <= MOST
        assert ulp_error(y[0, j], exact_y) <= MOST


def test_heights_keep_their_digits_at_landing():
    angles = np.array([0.3, 0.7, 1.1, 1.4])
    shot = {"v": 31.7, "g": 9.81, "k": 0.3}
    times = projectile.flight_time(angles, **shot)
    heights = Scene("projectile", over=("t", "theta"), outputs="y", **shot)(t=times, theta=angles)
    for i, angle in enumerate(angles):
        _, y = reference("projectile.position", {"t": times[i], "theta": angle, **shot})
        assert abs(heights[i, i] - float(y.ball)) <= 2.0**-64 * 31.7 * times[i]


def test_extreme_constants():
    for g, gamma in ((1e-200, 1e150), (1e200, 1e-200), (1e-300, 0.0)):
        found = Scene("chord", over=("t", "theta"), outputs="distance", g=g, gamma=gamma)(t=[1e80, 1e-30], theta=[0.3])
        for i, t in enumerate((1e80, 1e-30)):
            (d,) = reference("chord.distance", {"t": t, "theta": 0.3, "g": g, "mu": 0.0, "gamma": gamma})
            assert ulp_error(found[i, 0], d) <= MOST
