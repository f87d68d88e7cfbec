"""Arrays of other libraries come back as themselves, from both back ends; any number of threads gives the same bits."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from galileo_sym import chord, lambert, projectile, special

pytestmark = pytest.mark.usefixtures("back_end")

dask_array = pytest.importorskip("dask.array", reason="dask is not installed: its arrays are not tested")
pandas = pytest.importorskip("pandas", reason="pandas is not installed: its series are not tested")
xarray = pytest.importorskip("xarray", reason="xarray is not installed: its arrays are not tested")

THETA = np.linspace(0.1, 1.2, 301)


def calls():
    """Functions of an array of angles, one of each kind; these are looked up when called."""
    return {
        "one output": lambda x: chord.descent_time(x, diameter=2.0, g=9.81, gamma=0.5),
        "a force that varies": lambda x: chord.distance(1.5, 0.3, g=9.81, mu=x),
        "no dependence": lambda x: chord.descent_time(x, diameter=2.0, g=9.81),
        "a force of a type of its own": lambda x: chord.distance(1.5, x, g=9.81, mu=np.float64(0)),
        "two outputs": lambda x: projectile.position(1.5, x, v=10.0, g=9.81, k=0.3),
        "three outputs": lambda x: chord.synchronous_circle(x, g=9.81, mu=0.2, gamma=0.1),
        "a primitive": lambert.w0,
        "roots": lambda x: lambert.linear_exponential_roots(x, 2.0, -1.0, 1.0),
        "special": special.flight_factor,
    }


every = pytest.mark.parametrize("kind", calls())


def outputs(results):
    return results if isinstance(results, tuple) else (results,)


@every
@pytest.mark.parametrize("chunk", [97, 301])
def test_dask(kind, chunk):
    call = calls()[kind]
    lazy = outputs(call(dask_array.from_array(THETA, chunks=chunk)))
    for one, expected in zip(lazy, outputs(call(THETA)), strict=True):
        assert isinstance(one, dask_array.Array)
        assert one.dtype == np.float64
        for workers in (1, 4):
            assert np.array_equal(one.compute(scheduler="threads", num_workers=workers), expected)


@every
def test_xarray(kind):
    call = calls()[kind]
    given = xarray.DataArray(THETA, dims="launch", coords={"launch": np.arange(301)}, name="theta")
    for one, expected in zip(outputs(call(given)), outputs(call(THETA)), strict=True):
        assert isinstance(one, xarray.DataArray)
        assert one.dims == ("launch",)
        assert np.array_equal(one.coords["launch"], given.coords["launch"])
        assert np.array_equal(one.values, expected)


def test_xarray_broadcasts_by_name():
    t = xarray.DataArray([1.0, 2.0, 3.0], dims="t")
    theta = xarray.DataArray([0.1, 0.2], dims="theta")
    x, y = chord.position(t, theta, g=9.81, gamma=0.5)
    assert x.dims == y.dims == ("t", "theta")
    expected = chord.position(t.values[:, None], theta.values, g=9.81, gamma=0.5)
    assert np.array_equal([x.values, y.values], expected)


@every
def test_pandas(kind):
    call = calls()[kind]
    index = pandas.Index(np.arange(301) * 2, name="launch")
    for one, expected in zip(outputs(call(pandas.Series(THETA, index))), outputs(call(THETA)), strict=True):
        assert isinstance(one, pandas.Series)
        assert one.index.equals(index)
        assert np.array_equal(one.to_numpy(), expected)


def test_pandas_aligns():
    theta = pandas.Series([0.1, 0.2], index=["a", "b"])
    gravity = pandas.Series([9.0, 10.0], index=["b", "a"])
    found = chord.distance(1.0, theta, g=gravity)
    assert found["a"] == chord.distance(1.0, 0.1, g=10.0)
    assert found["b"] == chord.distance(1.0, 0.2, g=9.0)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_single_precision_stays(dtype):
    given = THETA.astype(dtype)
    assert chord.distance(1.5, dask_array.from_array(given), g=9.81).compute().dtype == dtype
    assert chord.distance(1.5, pandas.Series(given), g=9.81, mu=0.0).dtype == dtype


def test_other_types_are_refused_there_too():
    with pytest.raises(TypeError, match="not supported"):
        chord.distance(1.0, pandas.Series([1j]), g=9.81)


@every
def test_threads_give_the_same_bits(kind):
    call, theta = calls()[kind], np.tile(THETA, 14)
    whole = outputs(call(theta))
    places = [slice(i, i + 997) for i in range(0, theta.size, 997)]
    with ThreadPoolExecutor(4) as pool:
        parts = list(pool.map(lambda place: outputs(call(theta[place])), places))
    for one, pieces in zip(whole, zip(*parts, strict=True), strict=True):
        assert np.array_equal(one, np.concatenate(pieces))
