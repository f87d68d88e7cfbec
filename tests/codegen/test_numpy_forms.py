"""NumPy's formulas on pairs: the same bits however the arguments come, and no flag that is not due."""

from importlib import import_module

import numpy as np
import pytest
from samples import arguments, awkward, plain_results

from galileo_sym.codegen.hoisting import hoisted
from galileo_sym.codegen.lanes import forms, takes_values
from galileo_sym.codegen.numpy_forms import on_pairs
from galileo_sym.generated._chunks import CHUNK

FORMS = [(f, s) for f, s in forms() if on_pairs(f)]
OF_VALUES = [(f, s) for f, s in FORMS if takes_values(f)]


def each(pairs):
    """One test for each form."""
    return pytest.mark.parametrize(("function", "force_set"), pairs, ids=[f"{f.full_name}-{s}" for f, s in pairs])


each_form = each(FORMS)
COUNT = 97


def run(function, force_set, values):
    """Outputs of a kernel, one after the other."""
    name = f"{function.name}_{force_set}" if force_set else function.name
    results = getattr(import_module(f"galileo_sym.generated.{function.paper}"), name)(*values)
    return np.array(results if isinstance(results, tuple) else (results,))


def same(results, others):
    """Whether all bits agree, but those of NaN."""
    return np.array_equal(results, others, equal_nan=True) and np.array_equal(np.signbit(results), np.signbit(others))


@each_form
def test_numbers_are_served_alone_as_among_others(function, force_set):
    values = awkward(function, force_set, COUNT, 11, np.float64)
    with np.errstate(all="ignore"):
        whole = run(function, force_set, values)
        for i in range(0, COUNT, 4):
            assert same(run(function, force_set, [v[i] for v in values]), whole[:, i])


@each(OF_VALUES)
def test_what_is_computed_once_is_as_if_it_were_not(function, force_set):
    values = awkward(function, force_set, COUNT, 12, np.float64)
    first = len(function.positional)
    for row in range(4):
        few = [v if i < first else v[row] for i, v in enumerate(values)]
        full = [v if i < first else np.full(COUNT, v[row]) for i, v in enumerate(values)]
        with np.errstate(all="ignore"):
            assert same(run(function, force_set, few), run(function, force_set, full))


@each_form
def test_chunks_and_strides_and_shapes_do_not_matter(function, force_set):
    values = awkward(function, force_set, COUNT, 13, np.float64)
    with np.errstate(all="ignore"):
        whole = run(function, force_set, values)
        assert same(run(function, force_set, [np.repeat(v, 2)[::2] for v in values]), whole)
        column = [np.tile(values[0], (3, 1)), *values[1:]]
        assert same(run(function, force_set, column), np.repeat(whole[:, None], 3, axis=1))
        assert run(function, force_set, [v[:0] for v in values]).shape == (len(function.outputs), 0)
        times = CHUNK // COUNT + 2
        assert same(run(function, force_set, [np.tile(v, times) for v in values]), np.tile(whole, times))


@each_form
def test_ordinary_results_raise_no_flag(function, force_set):
    values = list(arguments(function, force_set, 300, 40, seed=14).values())
    with np.errstate(all="ignore"):
        plain = plain_results(run(function, force_set, values), 1e-300)
    assert np.count_nonzero(plain) > 30
    with np.errstate(all="raise"):
        run(function, force_set, [v[plain] for v in values])


def test_what_does_not_vary_is_named_once_before():
    steps = [("s", ("sqrt", ("div", "d", "g"))), ("p", ("mul", ("sqrt", "g"), "t")), ("q", ("mul", ("sqrt", "g"), "p"))]
    parts = hoisted(steps, [("add", "q", ("scale", "s", 1)), "s"], {"t"})
    assert parts.before == [steps[0], ("once1", ("sqrt", "g")), ("once2", ("scale", "s", 1))]
    assert parts.each == [("p", ("mul", "once1", "t")), ("q", ("mul", "once1", "p"))]
    assert parts.results == [("add", "q", "once2"), "s"]
