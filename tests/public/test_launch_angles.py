"""Launch angles: back to the range, the largest range and beyond, sizes, limits."""

import math

import numpy as np
import pytest

from galileo_sym.projectile import best_angle, horizontal_range, launch_angles, max_range

pytestmark = pytest.mark.usefixtures("back_end")

RATES = (0.0, 1e-200, 1e-9, 0.05, 0.644, 5.0, 1e4)
SHOT = {"v": 50.0, "g": 32.2}
SHARES = np.concatenate([np.linspace(0.0, 1.0, 40)[1:-1], [1e-300, 1e-12, 1 - 1e-9, 1 - 1e-14, 1 - 2.0**-52]])


@pytest.mark.parametrize("k", RATES)
def test_there_and_back(k):
    """Rounding an angle changes the range by no more than its slope allows: |theta R'/R| <= 2 theta cot + theta tan."""
    r = SHARES * max_range(**SHOT, k=k)
    for theta in launch_angles(r, **SHOT, k=k):
        carried = 2 + 2 * theta / np.tan(theta) + theta * np.tan(theta)
        back = horizontal_range(theta, **SHOT, k=k)
        assert np.all(np.abs(back - r) <= carried * 2.0**-53 * np.maximum(back, r))


@pytest.mark.parametrize("k", RATES)
def test_low_rises_and_high_falls_towards_the_best_angle(k):
    r = np.sort(SHARES) * max_range(**SHOT, k=k)
    low, high = launch_angles(r, **SHOT, k=k)
    best = best_angle(k * SHOT["v"] / SHOT["g"])
    assert np.all(np.diff(low) > 0)
    assert np.all(np.diff(high) < 0)
    assert low[-1] < best < high[-1]


@pytest.mark.parametrize("k", RATES)
def test_ends(k):
    most = max_range(**SHOT, k=k)
    assert launch_angles(0.0, **SHOT, k=k) == (0.0, math.pi / 2)
    assert launch_angles(most, **SHOT, k=k) == pytest.approx((best_angle(k * SHOT["v"] / SHOT["g"]),) * 2, rel=2**-52)
    for beyond in (np.nextafter(most, np.inf), 2 * most, math.inf):
        with np.errstate(invalid="ignore"):
            assert np.all(np.isnan(launch_angles(beyond, **SHOT, k=k)))
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
            launch_angles(beyond, **SHOT, k=k)


@pytest.mark.parametrize("k", [0.0, 0.3, 7.0])
def test_the_single_precision_largest_range_has_the_best_angle(k):
    rng = np.random.default_rng(3)
    v, g = (rng.uniform(1, 100, 200).astype(np.float32) for _ in range(2))
    rate = np.float32(k)
    low, high = launch_angles(max_range(v=v, g=g, k=rate), v=v, g=g, k=rate)
    assert low.dtype == np.float32
    assert np.array_equal(low, high)
    assert low == pytest.approx(best_angle(float(rate) * v.astype(float) / g), rel=1e-7)


@pytest.mark.parametrize(("speed", "weight"), [(300, -300), (-330, 330), (490, 7), (-490, -20)])
def test_other_units_give_the_same_bits(speed, weight):
    for k in (0.0, 0.125, 40.0):
        r = np.array([0.001, 0.3, 0.999]) * max_range(v=3.0, g=2.0, k=k)
        near = launch_angles(r, v=3.0, g=2.0, k=k)
        scaled = {"v": math.ldexp(3.0, speed), "g": math.ldexp(2.0, weight), "k": math.ldexp(k, weight - speed)}
        with np.errstate(all="raise"):
            far = launch_angles(np.ldexp(r, 2 * speed - weight), **scaled)
        assert np.array_equal(near, far)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ({"r": 1.0, "v": math.inf, "g": 9.81, "k": 0.5}, (0.0, math.pi / 2)),
        ({"r": 1.0, "v": math.inf, "g": 9.81}, (0.0, math.pi / 2)),
        ({"r": 1.0, "v": 10.0, "g": math.inf, "k": 0.5}, (math.nan, math.nan)),
        ({"r": 1.0, "v": 10.0, "g": 9.81, "k": math.inf}, (math.nan, math.nan)),
        ({"r": 0.0, "v": 10.0, "g": math.inf}, (0.0, math.pi / 2)),
        ({"r": 1.0, "v": math.inf, "g": math.inf}, (math.nan, math.nan)),
        ({"r": math.inf, "v": math.inf, "g": 1.0}, (math.nan, math.nan)),
        ({"r": math.nan, "v": 10.0, "g": 9.81}, (math.nan, math.nan)),
    ],
)
def test_infinite_arguments(arguments, expected):
    with np.errstate(invalid="ignore"):
        assert np.array_equal(launch_angles(**arguments), expected, equal_nan=True)


def test_where_the_angle_follows_the_range_by_2_to_the_49():
    """alpha = 1e15: 1 - k r/v is known to its last place, and 1 - exp(-s) = k r/v up to 1e-24."""
    v, g, k = 1.0, 1.0, 2.0**50
    r = (1 - 2.0**-50) / k
    low, high = launch_angles(r, v=v, g=g, k=k)
    s = 50 * math.log(2.0)
    assert low == pytest.approx((s / (1 - 2.0**-50) - 1) / 2.0**50, rel=1e-12)
    assert high == pytest.approx(2.0**-24.5, rel=1e-12)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_every_largest_range_that_is_told_has_the_best_angle(dtype):
    """Two computations that differ in the last place, rarely, would do for all but a few."""
    v, g, k = np.exp(np.random.default_rng(2014).uniform(-3, 3, (3, 4000))).astype(dtype)
    low, high = launch_angles(max_range(v=v, g=g, k=k), v=v, g=g, k=k)
    assert np.array_equal(low, high)
