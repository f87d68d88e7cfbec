"""Public functions as NumPy functions: domain and flags, dtypes, broadcasting, out=, where=, casting=."""

import math

import numpy as np
import pytest

from galileo_sym import chord, projectile

pytestmark = pytest.mark.usefixtures("back_end")


def _quarter(value):
    """A range within reach, of the value's type where it has quarters."""
    try:
        return value * 0.25
    except TypeError:
        return value


CALLS = {
    "chord.descent_time": lambda *a, **o: chord.descent_time(a[0], diameter=a[1], g=a[2], mu=a[3], gamma=a[4], **o),
    "chord.distance": lambda *a, **o: chord.distance(a[1], a[0], g=a[2], mu=a[3], gamma=a[4], **o),
    "chord.position": lambda *a, **o: chord.position(a[1], a[0], g=a[2], mu=a[3], gamma=a[4], **o),
    "chord.synchronous_circle": lambda *a, **o: chord.synchronous_circle(a[1], g=a[2], mu=a[3], gamma=a[4], **o),
    "projectile.flight_time": lambda *a, **o: projectile.flight_time(a[0], v=a[1], g=a[2], k=a[3], **o),
    "projectile.horizontal_range": lambda *a, **o: projectile.horizontal_range(a[0], v=a[1], g=a[2], k=a[3], **o),
    "projectile.position": lambda *a, **o: projectile.position(a[4], a[0], v=a[1], g=a[2], k=a[3], **o),
    "projectile.launch_angles": lambda *a, **o: projectile.launch_angles(_quarter(a[3]), v=a[2], g=a[4], k=a[1], **o),
    "projectile.best_angle": lambda *a, **o: projectile.best_angle(a[3], **o),
}
UNUSED = {  # positions in GOOD that a function does not take
    "chord.synchronous_circle": (0,),
    "projectile.flight_time": (4,),
    "projectile.horizontal_range": (4,),
    "projectile.launch_angles": (0,),
    "projectile.best_angle": (0, 1, 2, 4),
}
GOOD = (0.5, 1.5, 9.81, 0.25, 0.75)
every = pytest.mark.parametrize("name", CALLS)


def _all(results):
    return results if isinstance(results, tuple) else (results,)


@every
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_dtype_is_kept_and_scalars_give_scalars(name, dtype):
    scalars = _all(CALLS[name](*(dtype(x) for x in GOOD)))
    arrays = _all(CALLS[name](*(np.full((2, 3), x, dtype) for x in GOOD)))
    for scalar, array in zip(scalars, arrays, strict=True):
        assert type(scalar) is dtype
        assert array.dtype == dtype
        assert array.shape == (2, 3)
        assert np.all(array == scalar)


@every
def test_float32_is_the_double_result_rounded_once(name):
    narrow = [np.float32(x) for x in GOOD]
    for single, double in zip(_all(CALLS[name](*narrow)), _all(CALLS[name](*map(float, narrow))), strict=True):
        assert single == np.float32(double)


@every
def test_integers_and_booleans_become_float64(name):
    for one in (1, True, np.int8(1), np.array([1], dtype=np.uint64)):
        for result in _all(CALLS[name](one, one, one, one, one)):
            assert result.dtype == np.float64
        expected = _all(CALLS[name](1.0, 1.0, 1.0, 1.0, 1.0))
        for result, value in zip(_all(CALLS[name](one, one, one, one, one)), expected, strict=True):
            assert np.array_equal(np.ravel(result)[0], value, equal_nan=True)


def test_python_numbers_take_the_dtype_of_the_arrays():
    assert chord.descent_time(np.float32(0.5), diameter=1, g=9.81).dtype == np.float32
    assert chord.descent_time(np.float32(0.5), diameter=np.float64(1), g=9.81).dtype == np.float64
    assert chord.descent_time(np.float32(0.5), diameter=1, g=9.81, mu=np.float64(0)).dtype == np.float64
    assert projectile.best_angle(np.float16(1)).dtype == np.float32
    assert projectile.best_angle(np.array([1.0], dtype=">f8")).dtype == np.dtype("=f8")


@every
@pytest.mark.parametrize("bad", [1j, np.complex64(1), np.longdouble(1), np.array([1.0], dtype=object), "1", None])
def test_other_types_are_refused(name, bad):
    with pytest.raises(TypeError, match="not supported"):
        CALLS[name](*(bad,) * 5)


def test_a_force_of_a_refused_type_is_refused_even_if_it_is_zero():
    with pytest.raises(TypeError, match="complex"):
        chord.descent_time(0.5, diameter=1.0, g=9.81, mu=0j)


@every
@pytest.mark.parametrize("position", range(5))
def test_outside_the_domain(name, position):
    good = _all(CALLS[name](*(np.array([x, x]) for x in GOOD)))
    values = [np.array([x, -1e-300 if i == position else x]) for i, x in enumerate(GOOD)]
    if position == 0:
        values[0][1] = np.nextafter(math.pi / 2, 2)
    with np.errstate(invalid="ignore"):
        results = _all(CALLS[name](*values))
    used = position not in UNUSED.get(name, ())
    for result, whole in zip(results, good, strict=True):
        assert result[0] == whole[0]
        assert math.isnan(result[1]) == used
    if used:
        with pytest.raises(RuntimeWarning, match="invalid value"):
            CALLS[name](*values)
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
            CALLS[name](*values)


@every
@pytest.mark.parametrize("position", range(5))
def test_nan_in_nan_out_without_a_flag(name, position):
    values = [math.nan if i == position else x for i, x in enumerate(GOOD)]
    plain = _all(CALLS[name](*GOOD))
    with np.errstate(all="raise"):
        results = _all(CALLS[name](*values))
    if position in UNUSED.get(name, ()):
        assert results == plain
    else:
        assert all(math.isnan(r) for r in results)


@every
def test_good_arguments_raise_no_flag(name):
    with np.errstate(all="raise"):
        CALLS[name](*GOOD)
        CALLS[name](*(np.full(3, x) for x in GOOD))


def test_the_single_precision_right_angle_counts_as_one():
    steep = np.float32(np.pi / 2)
    assert float(steep) > math.pi / 2
    assert chord.descent_time(steep, diameter=np.float32(1), g=np.float32(9.81)) > 0
    assert chord.distance(np.float32(1), -steep, g=np.float32(2)) == np.float32(math.cos(math.pi / 2))
    with np.errstate(invalid="ignore"):
        assert np.isnan(chord.distance(np.float32(1), np.nextafter(steep, np.float32(2)), g=np.float32(2)))


@every
def test_broadcasting(name):
    wide = [np.full(shape, x) for shape, x in zip([(4, 1, 1), (3, 1), (1, 2), (), (4, 1, 2)], GOOD, strict=True)]
    scalars = _all(CALLS[name](*GOOD))
    for result, scalar in zip(_all(CALLS[name](*wide)), scalars, strict=True):
        assert np.all(result == scalar)
    with pytest.raises(ValueError, match="broadcast"):
        chord.distance(np.ones(2), np.ones(3) / 2, g=1.0)


@every
def test_empty_arrays(name):
    for result in _all(CALLS[name](*(np.ones((0, 3)) for _ in GOOD))):
        assert result.shape == (0, 3)


@every
def test_out_and_where(name):
    values = [np.full(3, x) for x in GOOD]
    values[3] = np.array([-1.0, 0.25, 0.5])
    keep = np.array([False, True, True])
    expected = _all(CALLS[name](*(v[1:] for v in values)))
    out = tuple(np.full(3, 7.0) for _ in expected)
    with np.errstate(all="raise"):
        given = CALLS[name](*values, out=out if len(out) > 1 else out[0], where=keep)
        unplaced = _all(CALLS[name](*values, where=keep))
    for target, result, loose, value in zip(out, _all(given), unplaced, expected, strict=True):
        assert result is target
        assert target[0] == 7.0
        assert np.array_equal(target[1:], value)
        assert np.array_equal(loose[1:], value)


def test_out_may_be_an_argument_and_may_be_wider_than_the_result():
    t = np.array([1.0, 2.0])
    expected = chord.distance(t, 0.5, g=2.0)
    assert chord.distance(t, 0.5, g=2.0, out=t) is t
    assert np.array_equal(t, expected)
    table = np.empty((3, 2))
    assert np.all(chord.distance(1.0, 0.5, g=2.0, out=table) == expected[0])


def test_casting():
    single = np.empty(1, np.float32)
    assert chord.distance(np.ones(1), 0.5, g=2.0, out=single) is single
    with pytest.raises(TypeError, match=r"Cannot cast ufunc .* output"):
        chord.distance(np.ones(1), 0.5, g=2.0, out=single, casting="safe")
    with pytest.raises(TypeError, match=r"Cannot cast ufunc .* output"):
        chord.distance(np.ones(1), 0.5, g=2.0, out=np.empty(1, int))
    assert chord.distance(1.0, 0.5, g=2.0, dtype=np.float32).dtype == np.float32
    with pytest.raises(TypeError, match=r"Cannot cast ufunc .* input"):
        chord.distance(np.ones(1), 0.5, g=2.0, dtype=np.float32, casting="safe")
    with pytest.raises(TypeError, match="ask for float64 or float32"):
        chord.distance(1.0, 0.5, g=2.0, dtype=complex)


@pytest.mark.parametrize("casting", ["foo", "", None])
def test_an_unknown_casting_rule_is_refused(casting):
    with pytest.raises(ValueError, match="casting must be one of 'no', 'equiv', 'safe', 'same_kind', 'unsafe'"):
        chord.distance(1.0, 0.5, g=9.81, casting=casting)
    for rule in ("no", "equiv", "safe", "same_kind", "unsafe"):
        assert chord.distance(1.0, 0.5, g=9.81, casting=rule) == chord.distance(1.0, 0.5, g=9.81)


def test_masked_arrays_keep_their_masks():
    """But for where=, of which NumPy would lose the mask without a word."""
    masked = np.ma.MaskedArray([1.0, 2.0], mask=[False, True])
    for result in (
        chord.distance(masked, 0.5, g=9.81),
        chord.distance(np.ones(2), 0.5, g=9.81, mu=masked / 10),
        *chord.position(masked, 0.5, g=9.81),
    ):
        assert isinstance(result, np.ma.MaskedArray)
        assert np.array_equal(result.mask, masked.mask)
    assert chord.distance(masked, 0.5, g=9.81)[0] == chord.distance(1.0, 0.5, g=9.81)
    with pytest.raises(TypeError, match=r"masked array, its mask would be lost"):
        chord.distance(np.ones(2), 0.5, g=9.81, where=np.ma.MaskedArray([True, True], mask=[False, True]))


def test_python_integers_beyond_int64():
    large = chord.descent_time(0.5, diameter=2**70, g=10)
    assert type(large) is np.float64
    assert large == chord.descent_time(0.5, diameter=2.0**70, g=10.0)
    assert chord.descent_time(np.float32(0.5), diameter=2**70, g=10).dtype == np.float32
    with pytest.raises(OverflowError):
        chord.descent_time(0.5, diameter=10**400, g=10)


def test_bad_out_and_where_are_refused():
    with pytest.raises(TypeError, match="out must be an array"):
        chord.distance(1.0, 0.5, g=2.0, out=[0.0])
    with pytest.raises(ValueError, match="out must hold 2 arrays"):
        chord.position(1.0, 0.5, g=2.0, out=np.empty(()))
    with pytest.raises(TypeError, match="where must be boolean"):
        chord.distance(1.0, 0.5, g=2.0, where=np.array([1, 0]))
    with pytest.raises(TypeError, match="unexpected keyword"):
        chord.distance(1.0, 0.5, g=2.0, order="C")
