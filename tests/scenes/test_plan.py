"""Plans: what is computed once, on which axes; the counts are those of a run."""

import subprocess
import sys
from collections import Counter
from types import SimpleNamespace

import numpy as np
import pytest
from scene_grids import CASES, OUTPUTS, axes, scene

from galileo_sym import Scene, _backend
from galileo_sym.scenes import points
from galileo_sym.scenes.arrays import Axes
from galileo_sym.scenes.numpy_run import evaluate
from galileo_sym.scenes.operations import OPERATIONS
from galileo_sym.scenes.plan import PRIMITIVES, TRANSCENDENTAL

SPINDLE = Scene("chord", over=("t", "theta"), outputs=("x", "y"), g=9.81, mu=0.36, gamma=0.5)
SHOT = Scene("projectile", over=("t", "theta"), outputs=("x", "y", "vx", "vy"), v=30.0, g=9.81, k=0.2)
ARITHMETIC = ("mul", "div", "add", "sub", "sqrt", "driving", "angle", *PRIMITIVES)


def counted(plan, given, monkeypatch):
    """Operations of a run, by kind: of steps by wrapping what carries them out, of points by counting NumPy's."""
    total = Counter()

    def counting(name, function):
        def called(*operands):
            made = function(*operands)
            first = made[0] if isinstance(made, tuple) else made
            number = np.size(getattr(first, "hi", first))
            if name in ARITHMETIC:
                total[name] += number
                total["transcendental"] += number if name in TRANSCENDENTAL else 0
            return made

        return called

    class Counting:
        """NumPy, as the module of points sees it."""

        def __getattr__(self, name):
            return getattr(np, name)

        def __init__(self):
            self.multiply, self.add, self.subtract = (
                by_size(kind, function)
                for kind, function in (("multiply", np.multiply), ("add", np.add), ("add", np.subtract))
            )

    def by_size(kind, function):
        def called(*operands, **options):
            made = function(*operands, **options)
            total[kind] += np.size(made)
            return made

        return called

    class Back:
        """The back end, as that module sees it."""

        EXTENSION = _backend.EXTENSION and SimpleNamespace(
            _sum_of_products=by_size("fma", _backend.EXTENSION._sum_of_products)
        )

        @staticmethod
        def ufunc(name):
            return by_size("call", _backend.ufunc(name))

    monkeypatch.setattr(points, "np", Counting())
    monkeypatch.setattr(points, "_backend", Back)
    monkeypatch.setattr(points, "_SIGNED", {1: points.np.add, -1: points.np.subtract})
    laid = Axes(plan, given, True)
    operations = {name: counting(name, function) for name, function in OPERATIONS.items()}
    evaluate(plan, laid.all_values(), [None] * len(plan.results), laid.dtype, operations)
    return total


@pytest.mark.parametrize(("system", "force_set"), CASES)
@pytest.mark.parametrize("extension", [True, False] if _backend.EXTENSION else [False])
def test_the_counts_are_those_of_a_run(system, force_set, extension, monkeypatch):
    if not extension:
        monkeypatch.setattr(_backend, "EXTENSION", None)
    given = {"t": np.linspace(0.1, 1.0, 5), "theta": np.linspace(0.1, 1.0, 7)}
    plan = scene(system, force_set, OUTPUTS[system]).plan
    told = sum(plan.cost({"t": 5, "theta": 7}).values(), Counter())
    called = {
        r.output: r.transcendental * np.prod([len(given[a]) for a in r.axes])
        for r in plan.results
        if r.operation == "call"
    }
    run = counted(plan, given, monkeypatch)
    run["transcendental"] += sum(called.values())
    assert +run == told


def test_what_the_spindle_takes():
    cost = SPINDLE.cost(t=1000, theta=1000)
    assert cost["t",] == {"mul": 3000, "phi2m": 1000, "transcendental": 1000}
    assert cost["theta",] == {"angle": 1000, "driving": 1000, "mul": 2000, "transcendental": 1000}
    assert cost["t", "theta"] == {"multiply": 2000000}


def test_without_forces_nothing_transcendental_depends_on_time():
    free = SPINDLE.without("friction").without("drag")
    assert "transcendental" not in free.cost(t=9, theta=9)["t",]
    assert {step.operation for step in free.plan.steps if "t" in step.axes} == {"load", "mul", "round"}


def test_one_output_is_half_of_the_points():
    both, one = SPINDLE.cost(t=9, theta=9), SPINDLE.with_outputs("x").cost(t=9, theta=9)
    assert 2 * one["t", "theta"]["multiply"] == both["t", "theta"]["multiply"]
    assert one["t",] == both["t",]


def test_a_descent_that_does_not_depend_on_the_chord_is_folded():
    galileo = Scene("chord", over="theta", outputs="descent_time", g=9.81, gamma=0.1, diameter=1.0)
    assert galileo.plan.steps == ()
    assert galileo.cost(theta=10**6) == {}
    times = galileo(theta=np.array([-1.0, 0.0, 1.0]))
    assert times.strides == (0,)
    assert not times.flags.writeable
    with np.errstate(invalid="ignore"):
        assert np.isnan(galileo(theta=[0.0, 2.0])).tolist() == [False, True]


def test_axes_that_no_factor_separates_are_left_to_the_public_function():
    scene = Scene("chord", over=("gamma", "theta"), outputs="descent_time", g=9.81, mu=0.2, diameter=1.0)
    (result,) = scene.plan.results
    assert (result.operation, result.axes) == ("call", ("gamma", "theta"))


@pytest.mark.parametrize(
    ("over", "grid", "outputs", "function"),
    [
        ("t", True, ("x", "y"), "chord_position_friction_drag"),
        ("t", True, ("R", "X"), "chord_synchronous_circle_friction_drag"),
        (("t", "theta"), False, ("x", "y"), "chord_position_friction_drag"),
    ],
)
def test_outputs_of_one_function_are_one_call(over, grid, outputs, function, monkeypatch):
    called = []
    monkeypatch.setattr(points._backend, "ufunc", lambda name, get=_backend.ufunc: called.append(name) or get(name))
    constants = {"theta": 0.4} if over == "t" else {}
    scene = Scene("chord", over=over, outputs=outputs, g=9.81, mu=0.36, gamma=0.5, **constants)
    axes = {"t": np.linspace(0.1, 1.0, 6), **({} if constants else {"theta": np.linspace(-1.0, 1.0, 6)})}
    found = scene(grid=grid, **axes)
    assert called == [function]
    alone = [scene.with_outputs(name)(grid=grid, **axes) for name in outputs]
    np.testing.assert_array_equal(found, alone)
    if over == "t":
        assert scene.cost(t=6)["t",]["call"] == 6
        assert f"with {outputs[0]}" in scene.explain()


def test_a_sum_takes_one_fma_a_point_of_the_extension_and_seven_operations_of_numpy(monkeypatch):
    alone = SHOT.with_outputs("y")
    if _backend.EXTENSION:
        assert alone.cost(t=10, theta=10)["t", "theta"] == {"fma": 100}
        assert "fma: a b + c" in alone.explain()
    monkeypatch.setattr(_backend, "EXTENSION", None)
    assert alone.cost(t=10, theta=10)["t", "theta"] == {"multiply": 300, "add": 400}
    assert "fma" not in alone.explain()


def test_buffers_of_numpy_are_as_they_were():
    before = np.getbufsize()
    with pytest.raises(FloatingPointError), np.errstate(invalid="raise"):
        SHOT(t=[-1.0], theta=[0.1])
    assert np.getbufsize() == before


def test_outputs_share_what_they_have_in_common():
    operations = Counter(step.operation for step in SHOT.plan.steps)
    assert operations["angle"] == operations["phi1m"] == operations["phi2m"] == operations["phi0m"] == 1


def test_a_plan_depends_on_nothing_but_its_scene():
    words = (
        "from galileo_sym import Scene; "
        "print(Scene('chord', over=('t', 'theta'), outputs=('x', 'y'), g=9.81, mu=0.36, gamma=0.5).plan)"
    )
    texts = {
        subprocess.run(
            [sys.executable, "-c", words], env={"PYTHONHASHSEED": seed}, capture_output=True, text=True, check=True
        ).stdout
        for seed in ("1", "2")
    }
    assert texts == {f"{SPINDLE.plan}\n"}


def test_scenes_load_no_sympy():
    words = (
        "import sys; from galileo_sym import Scene; "
        "Scene('chord', over=('t', 'theta'), outputs=('x', 'y'), g=9.81, mu=0.36)(t=[1.0], theta=[0.1]); "
        "assert 'sympy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", words], check=True)


def test_explain_tells_the_steps_and_the_totals():
    text = SPINDLE.explain(t=1000, theta=1000)
    assert "1000 phi2m" in text
    assert "2000000 multiply" in text
    assert "9.81 t t phi2m(0.5 t)" in text
    assert all(step.name in text for step in SPINDLE.plan.steps)
    assert "1000" not in SPINDLE.explain()


def test_grids_of_points_agree_with_the_axes_as_they_are():
    t, theta = axes("chord")["t"][3:8], axes("chord")["theta"]
    x, y = SPINDLE(t=t, theta=theta)
    flat = SPINDLE(grid=False, t=t[:, None], theta=theta)
    np.testing.assert_array_equal(flat, (x, y))
