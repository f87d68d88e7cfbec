"""The formulas on vectors: every version, shape and length with the same bits, and no flag that is not due."""

import ctypes
import platform

import compiled
import numpy as np
import pytest
from samples import arguments, awkward, plain_results

from galileo_sym import _backend, catalogue
from galileo_sym.codegen.kernels import runnable
from galileo_sym.codegen.lanes import forms, shapes
from galileo_sym.codegen.signatures import ARRAYS, VALUES, name_of
from galileo_sym.generated._functions import FUNCTIONS

FORMS = forms()
IDS = [f"{f.full_name}-{s}" for f, s in FORMS]
each_form = pytest.mark.parametrize(("function", "force_set"), FORMS, ids=IDS)
COUNT = 203  # not a multiple of any number of lanes


def _pointer(array):
    return ctypes.c_void_p(array.ctypes.data)


SCALARS = {np.float64: ctypes.c_double, np.float32: ctypes.c_float}
LETTERS = {np.float64: "", np.float32: "f"}
each_dtype = pytest.mark.parametrize("dtype", SCALARS, ids=["binary64", "binary32"])


def run(library, function, force_set, shape, values, ending=""):
    """Outputs of a form; in the shape of values, of the first of each keyword argument."""
    names = [a.name for a in function.arguments(force_set)]
    dtype = values[0].dtype.type
    results = [np.full(values[0].size, -7.0, dtype) for _ in function.outputs]
    given = [
        SCALARS[dtype](value[0]) if shape == VALUES and name in names[len(function.positional) :] else _pointer(value)
        for name, value in zip(names, values, strict=True)
    ]
    routine = getattr(library, f"{name_of(function, force_set)}_{shape}{LETTERS[dtype]}{ending}")
    routine.restype = None
    routine(ctypes.c_size_t(values[0].size), *given, *map(_pointer, results))
    return results


def _same(results, others):
    return all(a.tobytes() == b.tobytes() for a, b in zip(results, others, strict=True))


@pytest.mark.parametrize("compiler", compiled.compilers() or [None])
@each_dtype
@each_form
def test_every_version_and_shape_gives_the_same_bits(compiler, function, force_set, dtype):
    library = compiled.library(compiler)
    values = awkward(function, force_set, COUNT, 1, dtype)
    keywords = len(function.positional)
    for shape in shapes(function):
        given = values
        if shape == VALUES:
            given = [v if i < keywords else np.full(COUNT, v[3], dtype) for i, v in enumerate(values)]
        expected = run(compiled.library(), function, force_set, ARRAYS, given)
        for ending in ["", *(f"_{version}" for version in runnable())]:
            assert _same(run(library, function, force_set, shape, given, ending), expected), (shape, ending)


@each_dtype
@each_form
def test_single_numbers_and_short_arrays_give_the_same_bits(function, force_set, dtype):
    library = compiled.library()
    values = awkward(function, force_set, COUNT, 2, dtype)
    whole = run(library, function, force_set, ARRAYS, values)
    for length in [*range(1, 18), 31]:
        part = run(library, function, force_set, ARRAYS, [np.ascontiguousarray(v[:length]) for v in values])
        assert _same(part, [w[:length] for w in whole])
    scalar, number = getattr(library, name_of(function, force_set) + LETTERS[dtype]), SCALARS[dtype]
    several = len(function.outputs) > 1
    scalar.restype = None if several else number
    for i in range(40):
        given = [number(v[i]) for v in values]
        results = [number() for _ in function.outputs]
        told = scalar(*given, *(map(ctypes.byref, results) if several else ()))
        found = [r.value for r in results] if several else [told]
        assert _same([np.array([f], dtype) for f in found], [w[i : i + 1] for w in whole])


@each_dtype
@each_form
def test_a_result_may_take_the_place_of_an_argument(function, force_set, dtype):
    library = compiled.library()
    values = awkward(function, force_set, COUNT, 3, dtype)
    expected = run(library, function, force_set, ARRAYS, values)
    results = [values[0], *(np.empty(COUNT, dtype) for _ in function.outputs[1:])]
    routine = getattr(library, f"{name_of(function, force_set)}_{ARRAYS}{LETTERS[dtype]}")
    routine(ctypes.c_size_t(COUNT), *map(_pointer, values), *map(_pointer, results))
    assert _same(results, expected)


@each_form
def test_binary32_is_the_binary64_result_but_for_a_little(function, force_set):
    """Half a unit in the last place for the rounding, and no more than 1/64 for what plain arithmetic errs by."""
    library = compiled.library()
    values = awkward(function, force_set, COUNT, 5, np.float32)
    wide = [v.astype(np.float64) for v in values]
    for i, argument in enumerate(function.arguments(force_set)):
        if argument.unit == "rad":
            steep = np.abs(values[i]) == np.float32(np.pi / 2)
            wide[i] = np.where(steep, np.copysign(np.pi / 2, wide[i]), wide[i])
    if function.ceiling:
        greatest = catalogue.FUNCTIONS[f"{function.paper}.{function.ceiling.most}"]
        (most,) = run(library, greatest, force_set, ARRAYS, wide[1:])
        with np.errstate(over="ignore", under="ignore", invalid="ignore"):
            wide[0] = np.where(values[0] == most.astype(np.float32), most, wide[0])
    narrow = run(library, function, force_set, ARRAYS, values)
    for result, exact in zip(narrow, run(library, function, force_set, ARRAYS, wide), strict=True):
        with np.errstate(over="ignore", under="ignore", invalid="ignore"):
            nearest = exact.astype(np.float32)
            units = np.abs(result - exact) / np.spacing(np.abs(nearest).clip(2.0**-126, 2.0**127)).astype(float)
        plain = np.isfinite(nearest) & np.isfinite(result)
        assert np.array_equal(result[~plain], nearest[~plain], equal_nan=True)
        assert units[plain].max(initial=0.0) <= 0.5 + 1 / 64


@each_dtype
@each_form
def test_the_extension_gives_the_same_bits_and_flags(function, force_set, dtype):
    """It is compiled by other options, -O3 among them."""
    if _backend.EXTENSION is None:
        pytest.skip("no compiled extension: the NumPy back end serves")
    acting = function.variants[force_set][0]
    ufunc = getattr(_backend.EXTENSION, FUNCTIONS[function.full_name]["ufuncs"][acting][0])
    values = awkward(function, force_set, COUNT, 6, dtype)
    with np.errstate(all="ignore"):
        found = ufunc(*values)
    found = found if isinstance(found, tuple) else (found,)
    assert _same(found, run(compiled.library(), function, force_set, ARRAYS, values))
    with np.errstate(all="ignore"):
        values = [v.astype(dtype) for v in arguments(function, force_set, COUNT, 1, seed=7).values()]
        found = ufunc(*values)
        plain = plain_results(found if isinstance(found, tuple) else (found,), 1e-30, bool(function.routine))
    assert np.count_nonzero(plain) > COUNT // 4
    with np.errstate(all="raise"):
        ufunc(*(v[plain] for v in values))


FLAGS = {"invalid": 1, "divide": 4, "overflow": 8, "underflow": 16}  # as x86-64 has them
_elsewhere = pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="FLAGS are those of x86-64")


@_elsewhere
@each_form
def test_only_results_raise_flags(function, force_set):
    """None where all are ordinary numbers, though arguments are far from it."""
    library, libm = compiled.library(), ctypes.CDLL("libm.so.6")
    values = list(arguments(function, force_set, COUNT, 40, seed=4).values())
    with np.errstate(all="ignore"):
        plain = plain_results(run(library, function, force_set, ARRAYS, values), 1e-300, bool(function.routine))
    values = [np.ascontiguousarray(v[plain]) for v in values]
    assert values[0].size > 20
    for ending in ["", *(f"_{version}" for version in runnable())]:
        libm.feclearexcept(sum(FLAGS.values()))
        run(library, function, force_set, ARRAYS, values, ending)
        raised = libm.fetestexcept(sum(FLAGS.values()))
        assert not raised, (ending, [name for name, bit in FLAGS.items() if raised & bit])
