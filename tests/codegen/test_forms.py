"""The formulas on vectors: every version, shape and length with the same bits, and no flag that is not due."""

import ctypes
import platform

import compiled
import numpy as np
import pytest
from samples import arguments

from galileo_sym.codegen.kernels import TARGETS
from galileo_sym.codegen.lanes import ARRAYS, VALUES, forms, name_of, shapes

FORMS = forms()
IDS = [f"{f.full_name}-{s}" for f, s in FORMS]
each_form = pytest.mark.parametrize(("function", "force_set"), FORMS, ids=IDS)
COUNT = 203  # not a multiple of any number of lanes
_FEATURES = {"avx512": ("avx512f", "avx512dq", "avx512bw", "avx512vl"), "avx2": ("avx2", "fma"), "fma": ("fma",)}


def versions():
    """Suffixes of the versions that this machine can run."""
    if platform.machine() not in ("x86_64", "AMD64"):
        return ["plain"]
    with open("/proc/cpuinfo", encoding="ascii") as told:
        words = set(told.read().split())
    assert set(_FEATURES) == set(TARGETS)
    return ["plain", *(name for name, wanted in _FEATURES.items() if words.issuperset(wanted))]


def _pointer(array):
    return ctypes.c_void_p(array.ctypes.data)


def run(library, function, force_set, shape, values, ending=""):
    """Outputs of a form; in the shape of values, of the first of each keyword argument."""
    names = [a.name for a in function.arguments(force_set)]
    results = [np.full(values[0].size, -7.0) for _ in function.outputs]
    given = [
        ctypes.c_double(value[0]) if shape == VALUES and name in names[len(function.positional) :] else _pointer(value)
        for name, value in zip(names, values, strict=True)
    ]
    routine = getattr(library, f"{name_of(function, force_set)}_{shape}{ending}")
    routine.restype = None
    routine(ctypes.c_size_t(values[0].size), *given, *map(_pointer, results))
    return results


def awkward(function, force_set, seed):
    """Ordinary arguments with others strewn among them: 0, tiny, huge, infinite, NaN, beyond the domain."""
    rng = np.random.default_rng(seed)
    odd = np.array([0.0, -0.0, 5e-324, 1e-300, 1e-200, 1e-31, 1e31, 1e200, 1e308, np.inf, np.nan, -1.0, np.pi / 2, 2.0])
    values = []
    for value in arguments(function, force_set, COUNT, 8, seed=seed).values():
        struck = rng.random(COUNT) < 0.06
        values.append(np.where(struck, rng.choice(odd, COUNT), value))
    return values


def _same(results, others):
    return all(np.array_equal(a.view(np.int64), b.view(np.int64)) for a, b in zip(results, others, strict=True))


@pytest.mark.parametrize("compiler", compiled.compilers() or [None])
@each_form
def test_every_version_and_shape_gives_the_same_bits(compiler, function, force_set):
    library = compiled.library(compiler)
    values = awkward(function, force_set, seed=1)
    keywords = len(function.positional)
    for shape in shapes(function):
        given = values
        if shape == VALUES:
            given = [v if i < keywords else np.full(COUNT, v[3]) for i, v in enumerate(values)]
        expected = run(compiled.library(), function, force_set, ARRAYS, given)
        for ending in ["", *(f"_{version}" for version in versions())]:
            assert _same(run(library, function, force_set, shape, given, ending), expected), (shape, ending)


@each_form
def test_single_numbers_and_short_arrays_give_the_same_bits(function, force_set):
    library = compiled.library()
    values = awkward(function, force_set, seed=2)
    whole = run(library, function, force_set, ARRAYS, values)
    for length in [*range(1, 18), 31]:
        part = run(library, function, force_set, ARRAYS, [np.ascontiguousarray(v[:length]) for v in values])
        assert _same(part, [w[:length] for w in whole])
    scalar = getattr(library, name_of(function, force_set))
    several = len(function.outputs) > 1
    scalar.restype = None if several else ctypes.c_double
    for i in range(40):
        given = [ctypes.c_double(v[i]) for v in values]
        results = [ctypes.c_double() for _ in function.outputs]
        told = scalar(*given, *(map(ctypes.byref, results) if several else ()))
        found = [r.value for r in results] if several else [told]
        assert _same([np.array([f]) for f in found], [w[i : i + 1] for w in whole])


@each_form
def test_a_result_may_take_the_place_of_an_argument(function, force_set):
    library = compiled.library()
    values = [np.ascontiguousarray(v) for v in awkward(function, force_set, seed=3)]
    expected = run(library, function, force_set, ARRAYS, values)
    results = [values[0], *(np.empty(COUNT) for _ in function.outputs[1:])]
    routine = getattr(library, f"{name_of(function, force_set)}_{ARRAYS}")
    routine(ctypes.c_size_t(COUNT), *map(_pointer, values), *map(_pointer, results))
    assert _same(results, expected)


FLAGS = {"invalid": 1, "divide": 4, "overflow": 8, "underflow": 16}  # as x86-64 has them
_elsewhere = pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="FLAGS are those of x86-64")


@_elsewhere
@each_form
def test_only_results_raise_flags(function, force_set):
    """None where all are ordinary numbers, though arguments are far from it."""
    library, libm = compiled.library(), ctypes.CDLL("libm.so.6")
    values = list(arguments(function, force_set, COUNT, 40, seed=4).values())
    with np.errstate(all="ignore"):
        sizes = np.abs(run(library, function, force_set, ARRAYS, values))
        sizes = sizes[sizes.max(axis=1) > 0]  # a result that is always 0 raises nothing
        plain = np.all((sizes > 1e-300) & (sizes < 1e300), axis=0)
    values = [np.ascontiguousarray(v[plain]) for v in values]
    assert values[0].size > 20
    for ending in ["", *(f"_{version}" for version in versions())]:
        libm.feclearexcept(sum(FLAGS.values()))
        run(library, function, force_set, ARRAYS, values, ending)
        raised = libm.fetestexcept(sum(FLAGS.values()))
        assert not raised, (ending, [name for name, bit in FLAGS.items() if raised & bit])
