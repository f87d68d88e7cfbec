"""Both back ends against the printed equations, and against each other."""

import math

import compiled
import numpy as np
import printed_forms
import pytest
from samples import arguments

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen.lanes import in_lanes
from galileo_sym.codegen.signatures import name_of
from galileo_sym.generated import chord, lambert, projectile

MODULES = {"chord": chord, "lambert": lambert, "projectile": projectile}
REFERENCES = {
    "chord.descent_time": printed_forms.descent_time,
    "chord.distance": printed_forms.distance,
    "chord.speed": printed_forms.speed,
    "chord.max_angle": printed_forms.max_angle,
    "chord.position": printed_forms.chord_position,
    "chord.synchronous_circle": printed_forms.synchronous_circle,
    "projectile.flight_time": printed_forms.flight_time,
    "projectile.horizontal_range": printed_forms.horizontal_range,
    "projectile.position": printed_forms.projectile_position,
    "projectile.velocity": printed_forms.velocity,
    "projectile.range_slope_theta": printed_forms.range_slope_theta,
    "projectile.range_slope_k": printed_forms.range_slope_k,
    "projectile.max_range": printed_forms.max_range,
    "projectile.best_angle": printed_forms.best_angle,
    "lambert.w0": printed_forms.w0,
    "lambert.wm1": printed_forms.wm1,
    "lambert.linear_exponential_roots": printed_forms.linear_exponential_roots,
    "projectile.launch_angles": printed_forms.launch_angles,
}
KERNELS = [(name, force_set) for name, function in FUNCTIONS.items() for force_set in function.variants]
CANCELLING = {  # sums, of which a rounding more in one of the terms may leave nothing
    "projectile.position": ("y",),
    "projectile.velocity": ("vy",),
    "projectile.range_slope_theta": ("slope",),
}
BOUND = 1.0  # ulp: what the docstrings say


def _kernel(function, force_set):
    return getattr(MODULES[function.paper], f"{function.name}_{force_set}" if force_set else function.name)


def _evaluate(function, force_set, values, invalid="raise"):
    with np.errstate(over="ignore", under="ignore", invalid=invalid):
        results = _kernel(function, force_set)(*values)
    return results if isinstance(results, tuple) else (results,)


def _evaluate_c(function, force_set, values):
    return compiled.call(f"{name_of(function, force_set)}_n", values, len(function.outputs))


def _name(value):
    return value if isinstance(value, str) else str(value)


@pytest.mark.parametrize("width", [1, 60, 140])
@pytest.mark.parametrize(("name", "force_set"), KERNELS, ids=_name)
def test_error_against_the_printed_equations(name, force_set, width):
    function = FUNCTIONS[name]
    drawn = arguments(function, force_set, 40, width, seed=width)
    both = [_evaluate(function, force_set, drawn.values())]
    both += [_evaluate_c(function, force_set, drawn.values())] if compiled.compilers() else []
    for i in range(40):
        point = {key: float(value[i]) for key, value in drawn.items()}
        exact = REFERENCES[name](**point)
        exact = exact if isinstance(exact, tuple) else (exact,)
        for j, result in ((j, result) for results in both for j, result in enumerate(results)):
            own = len(exact) > len(both[0]) and j == len(both[0]) - 1  # the last output cancels: its unit comes last
            scale = exact[-1] if own else None
            error = printed_forms.ulps(float(result[i]), exact[j], scale)
            assert error <= BOUND, f"{name} {force_set} {function.outputs[j].name}: {error} ulp at {point}"


@pytest.mark.parametrize("width", [1, 60, 140])
@pytest.mark.parametrize(("name", "force_set"), KERNELS, ids=_name)
def test_c_and_numpy_differ_in_the_last_place_at_most(name, force_set, width):
    """And not at all where C has no other form: fused multiply-adds are what makes the difference."""
    function = FUNCTIONS[name]
    values = list(arguments(function, force_set, 3000, width, seed=100 + width).values())
    results = _evaluate(function, force_set, values, invalid="ignore")  # a range may lie above the largest by rounding
    for output, result, other in zip(function.outputs, results, _evaluate_c(function, force_set, values), strict=True):
        if output.name in CANCELLING.get(name, ()):
            continue
        places = np.abs(result.view(np.int64) - other.view(np.int64))
        assert places.max() <= (1 if in_lanes(function) or function.primitive else 0)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_zero_forces_in_arrays_give_the_kernel_without_them(name):
    function = FUNCTIONS[name]
    fullest = list(function.variants)[-1]
    for force_set in function.variants:
        drawn = arguments(function, force_set, 500, 20, seed=5)
        padded = [drawn.get(a.name, np.zeros(500)) for a in function.arguments(fullest)]
        for plain, full in zip(
            _evaluate(function, force_set, drawn.values()), _evaluate(function, fullest, padded), strict=True
        ):
            assert np.array_equal(np.broadcast_to(plain, full.shape), full, equal_nan=True)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_unsuffixed_c_function_takes_all_forces(name):
    function = FUNCTIONS[name]
    fullest = list(function.variants)[-1]
    values = list(arguments(function, fullest, 200, 20, seed=6).values())
    outputs = len(function.outputs)
    base = f"gs_{function.paper}_{function.name}"
    suffixed = f"{base}_{fullest}_n" if fullest else f"{base}_n"
    for a, b in zip(compiled.call(suffixed, values, outputs), compiled.call(f"{base}_n", values, outputs), strict=True):
        assert np.array_equal(a, b, equal_nan=True)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_binary32_is_the_double_result_rounded_once(name):
    function = FUNCTIONS[name]
    fullest = list(function.variants)[-1]
    with np.errstate(over="ignore", under="ignore"):
        values = [v.astype(np.float32) for v in arguments(function, fullest, 300, 10, seed=7).values()]
    outputs = len(function.outputs)
    native = compiled.call(f"gs_{function.paper}_{function.name}_nf", values, outputs, dtype=np.float32)
    wide = [v.astype(np.float64) for v in values]
    for i, argument in enumerate(function.arguments(fullest)):
        if argument.name == "theta":
            steep = np.abs(values[i]) == np.float32(math.pi / 2)
            wide[i] = np.where(steep, np.copysign(math.pi / 2, wide[i]), wide[i])
    if function.ceiling:
        (most,) = _evaluate(FUNCTIONS[f"{function.paper}.{function.ceiling.most}"], fullest, wide[1:])
        with np.errstate(over="ignore", under="ignore"):
            wide[0] = np.where(values[0] == most.astype(np.float32), most, wide[0])
    results = _evaluate(function, fullest, wide, invalid="ignore")  # the float next to -1/e may lie below it
    for result, other in zip(results, native, strict=True):
        with np.errstate(over="ignore", under="ignore"):
            narrow = result.astype(np.float32)
        assert np.array_equal(narrow, other, equal_nan=True)


def test_sliding_is_decided_by_the_exact_sign():
    theta = np.random.default_rng(8).uniform(0.01, 1.56, 300)
    for steps in range(-3, 4):
        mu = 1 / np.tan(theta) * (1 + steps * 2.0**-53)
        time = chord.descent_time_friction(theta, 1.0, 1.0, mu)
        for i in range(theta.size):
            assert math.isinf(time[i]) == math.isinf(printed_forms.descent_time(theta[i], 1, 1, mu[i]))


@pytest.mark.parametrize("ulps_off", [-1, 0, 1])
def test_sine_and_cosine_where_the_nearest_table_step_changes(ulps_off):
    steps = np.arange(1, 201) / 128
    theta = steps + ulps_off * np.spacing(steps)
    theta = theta[theta <= math.pi / 2]
    x, y = chord.position_free(1.0, theta, 2.0)
    for i in range(theta.size):
        exact = printed_forms.chord_position(1.0, theta[i], 2.0)
        assert printed_forms.ulps(x[i], exact[0]) < 0.55
        assert printed_forms.ulps(y[i], exact[1]) < 0.55


def test_subnormal_results_are_rounded_once():
    rng = np.random.default_rng(9)
    theta, v = rng.uniform(0, 1.5, 300), 10.0 ** rng.uniform(-323, -307, 300)
    with np.errstate(under="ignore"):
        time = projectile.flight_time_free(theta, v, 2.0)
    for i in range(300):
        assert printed_forms.ulps(time[i], printed_forms.flight_time(theta[i], v[i], 2.0)) < 0.501
