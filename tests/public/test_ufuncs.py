"""The ufuncs of the extension as NumPy's documentation has them: options, casting, memory, subclasses, flags."""

import pickle
import warnings

import numpy as np
import pytest

from galileo_sym.generated._functions import FUNCTIONS

THETA = np.linspace(-1.2, 1.2, 7)


def names():
    return [name for row in FUNCTIONS.values() for served in row["ufuncs"].values() for name in served]


def test_every_form_and_output_has_a_ufunc_with_both_types(lib):
    assert len(set(names())) == 75
    for name in names():
        ufunc = getattr(lib, name)
        assert isinstance(ufunc, np.ufunc)
        assert ufunc.__name__ == name
        assert ufunc.types == [f"{letter * ufunc.nin}->{letter * ufunc.nout}" for letter in "fd"]
        assert ufunc.signature is None
        for part in ("Parameters", "Returns", "claimed bound", "rad" if "theta" in ufunc.__doc__ else "in "):
            assert part in ufunc.__doc__


def test_ufuncs_are_pickled_by_name(lib):
    for name in names():
        assert pickle.loads(pickle.dumps(getattr(lib, name))) is getattr(lib, name)


@pytest.mark.parametrize("name", names())
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@np.errstate(invalid="ignore")
def test_steps_do_not_matter(lib, name, dtype):
    """Contiguous, strided, reversed, unaligned, of the other byte order, constant: the same bits as of each element."""
    ufunc = getattr(lib, name)
    count = 1100  # more than two blocks
    rng = np.random.default_rng(5)
    values = [rng.uniform(0.1, 0.7, count).astype(dtype) for _ in range(ufunc.nin)]
    for vary in (range(ufunc.nin), (0,), (ufunc.nin - 1,)):
        arguments = [v if i in vary else v[0] for i, v in enumerate(values)]
        expected = as_tuple(ufunc(*arguments))
        single = [
            as_tuple(ufunc(*(np.ravel(a)[j if np.ndim(a) else 0] for a in arguments))) for j in range(0, count, 97)
        ]
        for place, one in enumerate(expected):
            assert np.array_equal(one[::97], [s[place] for s in single], equal_nan=True)
        for laid in (strided, backwards, unaligned, swapped, full):
            for one, other in zip(as_tuple(ufunc(*map(laid, arguments))), expected, strict=True):
                assert one.dtype == dtype
                assert np.array_equal(one, other, equal_nan=True)
        target = tuple(np.full(2 * count, 7, dtype)[::2] for _ in expected)
        ufunc(*arguments, out=target)
        for one, other in zip(target, expected, strict=True):
            assert np.array_equal(one, other, equal_nan=True)
            assert np.array_equal(one.base[1::2], np.full(count, 7, dtype))


def as_tuple(results):
    return results if isinstance(results, tuple) else (results,)


def strided(array):
    if np.ndim(array) == 0:
        return array
    wide = np.full(3 * array.size, np.nan, array.dtype)
    wide[1::3] = array
    return wide[1::3]


def backwards(array):
    return array if np.ndim(array) == 0 else array[::-1].copy()[::-1]


def unaligned(array):
    if np.ndim(array) == 0:
        return array
    raw = np.empty(array.nbytes + 1, np.uint8)
    moved = raw[1:].view(array.dtype)
    moved[:] = array
    assert not moved.flags.aligned
    return moved


def swapped(array):
    return array if np.ndim(array) == 0 else array.astype(array.dtype.newbyteorder())


def full(array):
    """A number as an array of it."""
    return np.full(1100, array, array.dtype) if np.ndim(array) == 0 else array


def test_out(drag):
    expected = drag(THETA)
    for target in (np.empty(7), np.empty((2, 7))):
        assert drag(THETA, out=target) is target
        assert np.array_equal(target, np.broadcast_to(expected, target.shape))
    target = np.empty(7)
    assert drag(THETA, out=(target,)) is target
    with pytest.raises(ValueError, match="broadcast"):
        drag(THETA, out=np.empty(3))
    with pytest.raises(TypeError, match="annot cast"):
        drag(THETA, out=np.empty(7, int))
    with pytest.raises(TypeError, match="must be of ArrayType"):
        drag(THETA, out=[0.0] * 7)


def test_out_by_position_and_of_several_outputs(lib):
    expected = lib.chord_position_free(1.5, THETA, 9.81)
    x, y = np.empty(7), np.empty(7)
    assert lib.chord_position_free(1.5, THETA, 9.81, x, y)[0] is x
    assert np.array_equal([x, y], expected)
    made = lib.chord_position_free(1.5, THETA, 9.81, out=(None, y))
    assert made[1] is y
    assert np.array_equal(made, expected)
    assert np.array_equal(lib.chord_position_free_x(1.5, THETA, 9.81), expected[0])
    assert np.array_equal(lib.chord_position_free_y(1.5, THETA, 9.81), expected[1])
    with pytest.raises(ValueError, match="exactly one entry per ufunc output"):
        lib.chord_position_free(1.5, THETA, 9.81, out=(x,))


def test_where(drag):
    target, keep = np.full(7, 7.0), np.arange(7) % 2 == 0
    bad = np.where(keep, THETA, 99.0)
    with np.errstate(all="raise"):
        drag(bad, out=target, where=keep)
    assert np.array_equal(target[keep], drag(THETA)[keep])
    assert (target[~keep] == 7.0).all()
    assert drag(THETA, out=target, where=False)[1] == 7.0


def test_casting_and_dtype(drag):
    assert drag(THETA.astype(np.float32), np.float32(1.5), dtype=np.float64).dtype == np.float64
    assert drag(THETA, dtype=np.float32).dtype == np.float32
    assert np.array_equal(drag(THETA, dtype="f4"), drag(THETA.astype("f4")))
    single = np.empty(7, np.float32)
    assert np.array_equal(drag(THETA, out=single), drag(THETA).astype(np.float32))
    for casting in ("no", "equiv", "safe"):
        with pytest.raises(TypeError, match="annot cast"):
            drag(THETA, out=np.empty(7, np.float32), casting=casting)
        with pytest.raises(TypeError, match="annot cast"):
            drag(THETA, dtype=np.float32, casting=casting)
    whole = np.empty(7, int)
    drag(THETA, out=whole, casting="unsafe")
    assert np.array_equal(whole, drag(THETA).astype(int))
    for dtype in (complex, np.longdouble, object, int, np.float16):
        with pytest.raises(TypeError, match="ask for float64 or float32"):
            drag(THETA, dtype=dtype)


@pytest.mark.parametrize("one", [np.int8(1), np.uint64(1), True, np.bool_(True), 1])
def test_integers_become_float64(lib, one):
    assert lib.w0(one) == lib.w0(1.0)
    assert lib.w0(one).dtype == lib.w0(np.array([one])).dtype == np.float64
    assert lib.chord_distance_free(one, np.zeros(1, type(one)), one).dtype == np.float64


def test_types_are_promoted_as_numpy_does(lib):
    single = np.ones(2, np.float32)
    for t, g, dtype in (
        (1.0, 2, np.float32),
        (np.float16(1), np.int8(1), np.float32),
        (np.float16(1), np.int16(1), np.float32),
        (np.float32(1), np.int32(1), np.float64),
        (np.float64(1), 2.0, np.float64),
    ):
        assert lib.chord_distance_free(t, single * 0, g).dtype == dtype
    assert lib.w0(np.float16(1)).dtype == np.float32


REFUSED = (1j, np.complex64(1), np.longdouble(1), np.array([None]), "1", None, np.datetime64(1, "s"))


@pytest.mark.parametrize("bad", REFUSED, ids=lambda bad: type(bad).__name__)
def test_other_types_are_refused(lib, bad):
    with pytest.raises(TypeError, match="not supported: convert them to float64 or float32"):
        lib.chord_distance_free(1.0, bad, np.ones(2))


def test_broadcasting_and_empty(drag):
    grid = drag(THETA[:, None], np.array([1.0, 2.0, 3.0]))
    assert grid.shape == (7, 3)
    assert grid[4, 1] == drag(THETA[4], 2.0)
    assert drag(np.empty((0, 3))).shape == (0, 3)
    with pytest.raises(ValueError, match="broadcast"):
        drag(THETA, np.ones(3))


def test_no_dimension_gives_a_scalar(drag):
    for none in (0.5, np.float64(0.5), np.array(0.5)):
        assert type(drag(none)) is np.float64
    target = np.empty(())
    assert drag(0.5, out=target) is target
    assert target == drag(0.5)


def test_order(drag):
    columns = np.asfortranarray(np.full((3, 4), 0.5))
    assert drag(columns).flags.f_contiguous
    assert drag(columns, order="C").flags.c_contiguous
    assert np.array_equal(drag(columns), drag(columns, order="C"))


def test_overlap(lib):
    """Outputs over inputs, shifted, reversed, or of another output: as if all had been read first."""
    values = np.linspace(0.1, 1.0, 1500)
    for source, target in (
        (slice(None), slice(None)),
        (slice(1, None), slice(-1)),
        (slice(None), slice(None, None, -1)),
    ):
        theta = values.copy()
        expected = lib.chord_distance_drag(1.5, theta[source], 9.81, 0.5)
        lib.chord_distance_drag(1.5, theta[source], 9.81, 0.5, out=theta[target])
        assert np.array_equal(theta[target], expected)
    t, theta = values.copy(), values.copy()
    expected = lib.chord_position_drag(t, theta, 9.81, 0.5)
    lib.chord_position_drag(t, theta, 9.81, 0.5, out=(theta, t))
    assert np.array_equal([theta, t], expected)
    theta = values.copy()
    expected = lib.chord_descent_time_free(theta, theta[:1], 9.81)
    lib.chord_descent_time_free(theta, theta[:1], 9.81, out=theta)
    assert np.array_equal(theta, expected)


@pytest.mark.parametrize("method", ["reduce", "accumulate", "reduceat", "outer"])
def test_methods_of_binary_ufuncs_do_not_apply(lib, method):
    with pytest.raises((ValueError, TypeError)):
        getattr(lib.w0, method)(np.ones(3), *([[0]] if method in ("reduceat", "outer") else []))
    with pytest.raises((ValueError, TypeError)):
        getattr(lib.chord_distance_free, method)(np.ones(3), *([[0]] if method in ("reduceat", "outer") else []))


def test_at(lib):
    values = np.array([1.0, 2.0, 3.0])
    lib.w0.at(values, [0, 2])
    assert np.array_equal(values, [lib.w0(1.0), 2.0, lib.w0(3.0)])


def test_flags(drag, lib):
    """NumPy's error state, in each of its modes; NaN and comparisons raise nothing."""
    bad = np.array([0.5, 2.0])
    with np.errstate(invalid="ignore"), warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.isnan(drag(bad)).tolist() == [False, True]
    with (
        np.errstate(invalid="warn"),
        pytest.warns(RuntimeWarning, match="invalid value encountered in chord_distance_drag"),
    ):
        drag(bad)
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match="invalid"):
        drag(bad)
    seen = []
    with np.errstate(invalid="call"), np.errstate(call=lambda kind, flag: seen.append(kind)):
        drag(bad)
    assert seen == ["invalid value"]
    with np.errstate(all="raise"):
        assert np.isnan(drag(np.array([0.5, np.nan]))).tolist() == [False, True]
        assert np.isnan(drag(np.full(600, np.nan))).all()
    with np.errstate(divide="raise"), pytest.raises(FloatingPointError, match="divide by zero"):
        lib.wm1(0.0)
    with np.errstate(over="raise"), pytest.raises(FloatingPointError, match="overflow"):
        lib.chord_distance_free(1e200, 0.5, 9.81)
    with np.errstate(under="raise"), pytest.raises(FloatingPointError, match="underflow"):
        lib.chord_distance_free(1e-200, 0.5, 9.81)


def test_one_evaluation_serves_all_angles(lib):
    """Without friction the time does not depend on the angle, but for its domain: each element has its own say."""
    theta = np.linspace(-1.5, 1.5, 2000)
    times = lib.chord_descent_time_free(theta, 1.0, 9.81)
    assert (times == times[0]).all()
    assert times.flags.writeable
    assert times.strides == (8,)
    times[0] = 0.0
    for place, x in ((0, 2.0), (700, np.nan), (1999, -np.inf)):
        changed = theta.copy()
        changed[place] = x
        with np.errstate(invalid="ignore" if not np.isnan(x) else "raise"):
            found = lib.chord_descent_time_free(changed, 1.0, 9.81)
        assert np.array_equal(np.isnan(found), np.arange(2000) == place)
        if not np.isnan(x):
            with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
                lib.chord_descent_time_free(changed, 1.0, 9.81)
    with np.errstate(all="raise"):
        assert np.isnan(lib.chord_descent_time_free(np.full(600, np.nan), 1e308, 1e-308)).all()
        assert np.isnan(lib.chord_descent_time_free(theta, np.nan, 9.81)).all()
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
        lib.chord_descent_time_free(theta, -1.0, 9.81)
    for dtype in (np.float32, np.float64):
        g = np.array([1.0, 0.0, -1.0, np.nan, np.inf, np.finfo(dtype).smallest_subnormal], dtype)
        with np.errstate(invalid="ignore"):
            vx = lib.projectile_velocity_free_vx(dtype(2), dtype(0.5), dtype(3), g)
        assert np.array_equal(np.isnan(vx), [False, True, True, True, False, False])
    right = np.float32(np.pi / 2)
    assert (lib.chord_descent_time_free(np.full(9, right), np.float32(1), 9.81) > 0).all()
    filled = np.empty((50, 40))
    assert (lib.projectile_max_range_free(2.0, 4.0, out=filled) == 1.0).all()
