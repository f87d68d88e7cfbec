"""Public functions: the inputs that broke every contender, the papers' own scenes, limits and edges."""

import math

import numpy as np
import pytest

from galileo_sym import chord, projectile

pytestmark = pytest.mark.usefixtures("back_end")

HALF_PI = math.pi / 2
FALL = {"diameter": 1.0, "g": 9.81}
SHOT = {"v": 10.0, "g": 9.81}


# Exact values to the digits given, computed once with mpmath at 60 digits from the printed equations.
@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (lambda: chord.descent_time(0.0, **FALL, gamma=1e-8), 0.45152364132552),
        (lambda: chord.descent_time(0.0, **FALL, gamma=1e-200), 0.45152364098573),
        (lambda: chord.descent_time(0.0, diameter=1e250, g=1e250, gamma=1e100), 1e100),
        (lambda: chord.descent_time(0.0, diameter=1e-200, g=1e200, gamma=1.0), 1.4142135623731e-200),
        (lambda: chord.descent_time(0.0, diameter=1e200, g=1e-200, gamma=1e-150), 1e250),
        (lambda: chord.descent_time(1.1071487177940904, **FALL, mu=0.5, gamma=1.0), 433567375072350.1),
        (lambda: chord.distance(1.0, 0.5, g=9.81, gamma=1e-9), 4.304542461),
        (lambda: chord.distance(1.0, 0.5, g=9.81, gamma=1e-170), 4.304542462),
        (lambda: projectile.flight_time(0.5, **SHOT, k=1e-9), 0.97742210),
        (lambda: projectile.flight_time(0.5, **SHOT, k=1e-8), 0.97742210),
        (lambda: projectile.best_angle(1 + 2**-52), 0.62115734),
        (lambda: projectile.best_angle(1.5e-8), 0.78539816),
        (lambda: projectile.best_angle(1e155), 7.06241422e-153),
        (lambda: projectile.best_angle(1e200), 9.13217064e-198),
        (lambda: projectile.position(0.5, 0.5, **SHOT, k=1e-9)[1], 1.17087769),
    ],
)
def test_inputs_worth_keeping(value, expected):
    assert value() == pytest.approx(expected, rel=1e-8)


def test_two_of_them_to_the_last_digits():
    assert chord.descent_time(0.0, diameter=1e250, g=1e250, gamma=1e100) == 1e100
    assert chord.descent_time(0.0, **FALL, gamma=1e-200) == chord.descent_time(0.0, **FALL)


def test_galileos_paradox_holds_up_to_the_horizontal():
    theta = np.linspace(-HALF_PI, HALF_PI, 101)
    assert np.all(chord.descent_time(theta, **FALL) == chord.descent_time(0.0, **FALL))
    assert np.all(chord.descent_time(theta, **FALL, mu=np.zeros(101)) == chord.descent_time(0.0, **FALL))


@pytest.mark.parametrize("mu", [0.36, 0.5])
@pytest.mark.parametrize("gamma", [0.0, 0.5])
def test_beads_lie_on_the_synchronous_circle(mu, gamma):
    theta = np.linspace(-0.9, 0.9, 41)
    x, y = chord.position(1.0, theta, g=1.0, mu=mu, gamma=gamma)
    X, Y, R = chord.synchronous_circle(1.0, g=1.0, mu=mu, gamma=gamma)
    assert np.hypot(x + np.sign(theta) * X, y - Y) == pytest.approx(np.where(theta == 0, np.hypot(X, Y), R), rel=1e-14)


@pytest.mark.parametrize("k", [0.0, 0.05, 0.5, 5.0])
def test_projectile_lands_at_its_range(k):
    theta = np.linspace(0.05, 1.5, 30)
    time = projectile.flight_time(theta, v=50.0, g=32.2, k=k)
    x, y = projectile.position(time, theta, v=50.0, g=32.2, k=k)
    assert x == pytest.approx(projectile.horizontal_range(theta, v=50.0, g=32.2, k=k), rel=1e-14)
    assert np.abs(y) == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("k", [0.05, 0.5, 5.0])
def test_best_angle_gives_the_greatest_range(k):
    theta = projectile.best_angle(k * 50.0 / 32.2)
    best = projectile.horizontal_range(theta, v=50.0, g=32.2, k=k)
    assert best > projectile.horizontal_range(theta + 1e-4, v=50.0, g=32.2, k=k)
    assert best > projectile.horizontal_range(theta - 1e-4, v=50.0, g=32.2, k=k)


def test_at_rest():
    assert chord.descent_time(1.2, **FALL, mu=0.5) == math.inf
    assert chord.descent_time(-1.2, **FALL, mu=0.5, gamma=1.0) == math.inf
    assert chord.distance(1.0, 1.2, g=9.81, mu=0.5) == 0.0
    assert chord.position(1.0, 1.2, g=9.81, mu=0.5, gamma=2.0) == (0.0, 0.0)
    assert chord.descent_time(1e-300, **FALL, mu=math.inf) == math.inf
    assert chord.descent_time(0.0, **FALL, mu=math.inf) == chord.descent_time(0.0, **FALL)


def test_start_and_mirror():
    assert chord.position(0.0, 0.5, g=9.81, mu=0.1, gamma=1.0) == (0.0, 0.0)
    assert projectile.position(0.0, 0.5, **SHOT, k=1.0) == (0.0, 0.0)
    assert projectile.flight_time(0.0, **SHOT, k=1.0) == 0.0
    assert projectile.horizontal_range(0.0, **SHOT) == 0.0
    assert projectile.best_angle(0) == math.pi / 4
    x, y = chord.position(1.0, 0.5, g=9.81, mu=0.1)
    assert chord.position(1.0, -0.5, g=9.81, mu=0.1) == (-x, y)


# An infinite argument gives the limit.
@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (lambda: chord.descent_time(0.1, diameter=math.inf, g=1.0, gamma=1.0), math.inf),
        (lambda: chord.descent_time(0.1, diameter=1.0, g=math.inf, gamma=1.0), 0.0),
        (lambda: chord.descent_time(0.1, diameter=1.0, g=1.0, gamma=math.inf), math.inf),
        (lambda: chord.distance(math.inf, 0.1, g=1.0, gamma=1.0), math.inf),
        (lambda: chord.distance(1.0, 0.1, g=1.0, gamma=math.inf), 0.0),
        (lambda: chord.distance(0.0, 0.1, g=1.0, gamma=math.inf), 0.0),
        (lambda: chord.distance(math.inf, 1.2, g=1.0, mu=0.5, gamma=math.inf), 0.0),
        (lambda: projectile.flight_time(0.5, v=2.0, g=1.0, k=math.inf), 2 * math.sin(0.5)),
        (lambda: projectile.horizontal_range(0.5, v=2.0, g=1.0, k=math.inf), 0.0),
        (lambda: projectile.horizontal_range(0.5, v=math.inf, g=1.0, k=1.0), math.inf),
        (lambda: projectile.position(math.inf, 0.5, v=10.0, g=9.81, k=2.0)[0], 5 * math.cos(0.5)),
        (lambda: projectile.position(math.inf, 0.5, v=10.0, g=9.81, k=2.0)[1], -math.inf),
        (lambda: projectile.best_angle(math.inf), 0.0),
    ],
)
def test_limits_at_infinity_come_without_a_flag(value, expected):
    with np.errstate(all="raise"):
        assert value() == expected


@pytest.mark.parametrize(
    "value",
    [
        lambda: chord.descent_time(0.1, diameter=math.inf, g=math.inf),
        lambda: chord.descent_time(0.1, diameter=1.0, g=math.inf, gamma=math.inf),
        lambda: chord.distance(math.inf, 0.1, g=1.0, gamma=math.inf),
        lambda: projectile.flight_time(0.5, v=math.inf, g=math.inf),
        lambda: projectile.horizontal_range(0.5, v=math.inf, g=1.0, k=math.inf),
        lambda: projectile.position(math.inf, 0.5, v=math.inf, g=1.0)[1],
    ],
)
def test_no_limit_is_invalid(value):
    with pytest.raises(RuntimeWarning, match="invalid value"):
        value()
    with np.errstate(invalid="ignore"):
        assert math.isnan(value())


def test_results_beyond_the_doubles_overflow_and_underflow():
    with pytest.raises(RuntimeWarning, match="overflow"):
        chord.distance(1e200, 0.1, g=1.0)
    with np.errstate(over="ignore"):
        assert chord.distance(1e200, 0.1, g=1.0) == math.inf
    with np.errstate(under="raise"), pytest.raises(FloatingPointError, match="underflow"):
        chord.distance(1e-200, 0.1, g=1.0)
    with np.errstate(all="raise"):
        assert chord.distance(1e250, 0.0, g=1e-300, gamma=1e250) == pytest.approx(1e-300)
