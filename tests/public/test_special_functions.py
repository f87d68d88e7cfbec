"""The public face of the primitives: names, dtypes, float32 rounded once, out=, where=, NaN and flags."""

import numpy as np
import pytest

from galileo_sym import special
from galileo_sym._stand_in import StandIn
from galileo_sym.generated import special as emitted
from galileo_sym.primitives.kernels import KERNELS

pytestmark = pytest.mark.usefixtures("back_end")
every = pytest.mark.parametrize("name", KERNELS)


def _good(name):
    lower, upper = KERNELS[name].domain
    x = np.concatenate([[0.0, 1e-300, 1e-8], np.linspace(0.001, 1.5, 200), [9.0, 700.0, 1e10]])
    x = np.concatenate([x, -x])
    return x[(x >= lower) & (x <= upper) & (x != KERNELS[name].pole)]


def test_names_are_those_of_the_kernels():
    assert special.__all__ == list(KERNELS)


@every
def test_what_a_ufunc_tells(name):
    function = getattr(special, name)
    assert function.__name__ == name
    assert (function.nin, function.nout, function.types) == (1, 1, ["f->f", "d->d"])
    for part in ("Parameters", "Returns", "Raises", "paper", "Claimed bound: 2 ulp"):
        assert part in function.__doc__


def test_the_extension_has_ufuncs_of_numpy(back_end):
    assert all(isinstance(getattr(special, name), np.ufunc) == (back_end == "c") for name in KERNELS)


@every
def test_float64(name):
    x = _good(name)
    function = getattr(special, name)
    expected = getattr(emitted, name)(x)[0]
    np.testing.assert_array_max_ulp(function(x), expected, 1)  # C has a multiply-add, NumPy has none
    assert np.array_equal([function(float(v)) for v in x[:20]], function(x)[:20])
    assert type(function(float(x[0]))) is np.float64
    assert np.array_equal(
        function(x.reshape(2, -1) if x.size % 2 == 0 else x[1:].reshape(2, -1)).ravel()[-5:], expected[-5:]
    )


@every
def test_float32_is_rounded_once(name):
    """Of hi + lo, not of hi: what lies between two floats is decided by the rest."""
    x = _good(name).astype(np.float32)
    x = x[(x >= np.float64(KERNELS[name].domain[0])) & (x <= np.float64(KERNELS[name].domain[1]))]
    x = x[x != KERNELS[name].pole]
    value = getattr(special, name)(x)
    hi, lo = getattr(emitted, name)(x.astype(np.float64))
    assert value.dtype == np.float32
    near = np.isfinite(value) & (value != 0)
    value, hi, lo = value[near], hi[near], lo[near]
    missed = abs((value.astype(np.float64) - hi) - lo)
    for side in (-np.inf, np.inf):
        neighbour = np.nextafter(value, np.float32(side)).astype(np.float64)
        assert (missed <= abs((neighbour - hi) - lo)).all()


def test_a_tie_is_broken_by_the_rest():
    tie = 1.0 + 2.0**-24
    row = emitted.FUNCTIONS["phi1m"] | {"kernels": {(): lambda x: (np.full_like(x, tie), np.array([-1e-20, 1e-20]))}}
    tied = StandIn("phi1m", "", row, (), 1)
    assert np.array_equal(tied(np.array([1, 2], np.float32)), np.array([1.0, 1.0 + 2.0**-23], np.float32))
    assert np.array_equal(tied(np.array([1.0, 2.0])), [tie, tie])


@every
def test_nan_and_flags(name):
    function = getattr(special, name)
    lower, upper = KERNELS[name].domain
    with np.errstate(invalid="raise"):
        assert np.isnan(function(np.nan))
        for x in (-1e300, 1e300, np.inf, -np.inf):
            if not lower <= x <= upper:
                with pytest.raises(FloatingPointError):
                    function(x)
            else:
                assert not np.isnan(function(x))


@every
def test_out_and_where(name):
    x = _good(name)[:4]
    out = np.full(4, 7.0)
    assert getattr(special, name)(x, out=out, where=np.array([True, False, True, False])) is out
    assert np.array_equal(out[1::2], [7.0, 7.0])
    assert np.array_equal(out[::2], getattr(special, name)(x)[::2])


@pytest.mark.parametrize("name", [n for n, kernel in KERNELS.items() if kernel.pole is not None])
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_a_pole_divides_by_zero(name, dtype):
    function, pole = getattr(special, name), KERNELS[name].pole
    for x in (pole, -pole):
        with np.errstate(divide="raise"), pytest.raises(FloatingPointError, match="divide by zero"):
            function(dtype(x))
        with np.errstate(divide="ignore", invalid="raise"):
            assert np.isinf(function(dtype(x)))


def test_no_other_dtypes():
    with pytest.raises(TypeError):
        special.w0(1j)
