"""References against formulas they do not use: Lambert W at 1400 digits, Taylor series of the motion, maxima."""

import math

import pytest
from flint import ctx
from mpmath import mp, mpf
from verify_ends import ball_ends, ends, exactly

from galileo_sym.verify.enclosure import (
    INFINITE,
    ZERO,
    Enclosure,
    Undecided,
    certain,
    decay,
    nearest_float,
    number,
    proved_root,
)
from galileo_sym.verify.fixed_points import KNOWN_HARD
from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.reference import reference
from galileo_sym.verify.sampling import HALF_PI, critical_angle, critical_friction, step

DIGITS = 1400
CHORD = {"theta": 0.3, "diameter": 1.7, "g": 9.81, "mu": 0.0, "gamma": 0.0}
THROW = {"theta": 0.6, "v": 50.0, "g": 32.2, "k": 0.0}


def holds(enclosure, value):
    """Whether the value, an mpf of many digits, lies in the enclosure, and that is narrow."""
    low, high = ends(enclosure)
    return low <= value <= high and high - low <= abs(value) * mpf(2) ** -90


def with_forces(function, force_set, point):
    spec = FUNCTIONS[function]
    return point | dict.fromkeys(spec.absent_forces(force_set), 0.0)


@pytest.fixture(autouse=True)
def many_digits():
    with mp.workdps(DIGITS):
        yield


# --- by Lambert W, the papers' printed closed forms ---------------------------------------------------------------


def lambert_near_branch(x):
    """W0(-exp(-1 - x)) for x > 0."""
    return mp.lambertw(-mp.exp(-1 - x)).real


CHORD_CASES = [
    {},
    {"gamma": 1e-8},
    {"gamma": 1e-200},
    {"gamma": 3.0},
    {"gamma": 1e3},
    {"gamma": 0.7, "mu": 0.36},
    {"gamma": 0.7, "mu": 0.36, "theta": -0.9},
    {"gamma": 1e-30, "mu": 1e-3, "theta": 1.5},
    {"gamma": 1.0, "mu": 0.5, "theta": 1.1071487177940904, "diameter": 1.0},
    {"gamma": 1e100, "diameter": 1e250, "g": 1e250, "theta": 0.0},
    {"mu": 0.5},
    {"theta": HALF_PI},
    {"theta": HALF_PI, "gamma": 1.0},
]


@pytest.mark.parametrize("changed", CHORD_CASES)
def test_descent_time_is_equation_43(changed):
    point = CHORD | changed
    theta, diameter, g, mu, gamma = (mpf(point[name]) for name in ("theta", "diameter", "g", "mu", "gamma"))
    n = 1 - mu * mp.tan(abs(theta))
    if gamma == 0:
        exact = mp.sqrt(2 * diameter / (g * n))
    else:
        square = diameter * gamma**2 / (g * n)
        exact = lambert_near_branch(square) / gamma + 1 / gamma + diameter * gamma / (g * n)
    assert holds(reference("chord.descent_time", point)[0], exact)


THROW_CASES = [
    {},
    {"k": 1e-8},
    {"k": 1e-200},
    {"k": 0.5},
    {"k": 30.0},
    {"k": 1e-9, "theta": 1e-12},
    {"k": 0.5, "theta": HALF_PI},
    {"k": 1e100, "v": 1e-90},
]


@pytest.mark.parametrize("changed", THROW_CASES)
def test_flight_and_range_are_the_printed_forms(changed):
    point = THROW | changed
    theta, v, g, k = (mpf(point[name]) for name in ("theta", "v", "g", "k"))
    if k == 0:
        time, reach = 2 * v * mp.sin(theta) / g, v**2 * mp.sin(2 * theta) / g
    else:
        lift = 1 + k * v / g * mp.sin(theta)
        w = mp.lambertw(-lift * mp.exp(-lift)).real
        time, reach = (lift + w) / k, v * mp.cos(theta) * (1 + w / lift) / k
    assert holds(reference("projectile.flight_time", point)[0], time)
    assert holds(reference("projectile.horizontal_range", point)[0], reach)


@pytest.mark.parametrize(
    "alpha", [1e-150, 1.5e-8, 0.01, 0.5, 1 - 2.0**-53, 1.0, 1 + 2.0**-52, 2.0, 2.999, 3.001, 77.0, 1e10, 1e155, 1e300]
)
def test_best_angle_is_theorem_3(alpha):
    a = mpf(alpha)
    w = mp.lambertw((a * a - 1) / mp.e).real
    sine = 1 / (mp.e - 1) if a == 1 else a * w / (a * a - 1 - w)
    assert holds(reference("projectile.best_angle", {"alpha": alpha})[0], mp.asin(sine))


W_CASES = [-5e-324, -1e-300, -0.00247, -0.00248, -0.1, -0.3, -0.3678794411714423]


@pytest.mark.parametrize("x", [*W_CASES, 5e-324, 1e-300, 0.00247, 0.00248, 0.3, 2.7, math.e, 2.72, 1e10, 1e308])
def test_w_is_lambert_w(x):
    assert holds(reference("lambert.w0", {"x": x})[0], mp.lambertw(mpf(x)).real)
    if x < 0:
        assert holds(reference("lambert.wm1", {"x": x})[0], mp.lambertw(mpf(x), -1).real)


@pytest.mark.parametrize("c", [1e-300, 0.002, -0.002, 0.3, -0.3, 1e10])
@pytest.mark.parametrize("b", [-1e3, -2.0, 0.0, 1e-9, 0.5, 7.0, 1e3, 1e12])
def test_roots_solve_the_equation(b, c):
    """Of 1.5 t + b + c exp(-0.75 t), by result (3)."""
    rate = mpf(-0.5)
    first, second = reference("lambert.linear_exponential_roots", {"a": 1.5, "b": b, "c": c, "d": -0.75})
    x = c * rate * mp.exp(-b * rate)
    for root, branch in ((first, 0), (second, -1)):
        w = mp.lambertw(x, branch)
        if root.ball.is_nan():
            assert mp.im(w) != 0 or not mp.isfinite(w)
        else:
            assert holds(root, -mpf(b) / 1.5 + w.real / mpf(0.75))


@pytest.mark.parametrize("alpha", [0.25, 1.0, 4.0])
def test_best_angle_maximises_the_range(alpha):
    """The printed range at theta_max exceeds that at either side; no stationarity condition is used."""
    with mp.workdps(60):
        (best,) = reference("projectile.best_angle", {"alpha": alpha})

        def reach(theta):
            lift = 1 + alpha * mp.sin(theta)
            return mp.cos(theta) * (1 + mp.lambertw(-lift * mp.exp(-lift)).real / lift)

        angle, aside = ends(best)[0], mpf(10) ** -12
        assert reach(angle) > reach(angle - aside)
        assert reach(angle) > reach(angle + aside)


# --- by the equations of motion ------------------------------------------------------------------------------------


def travelled(acceleration, rate, speed, t):
    """Position at t of s'' = acceleration - rate s', s(0) = 0, s'(0) = speed, by its Taylor series about 0."""
    term, total, order = speed * t, speed * t, 2
    term = (acceleration - rate * speed) * t**2 / 2
    while abs(term) > mpf(10) ** (-DIGITS + 20) * abs(total) or order < 5:
        total += term
        order += 1
        term = -term * rate * t / order
    return total


@pytest.mark.parametrize("theta", [0.0, 0.4, -0.4, 1.2])
@pytest.mark.parametrize(("mu", "gamma"), [(0.0, 0.0), (0.3, 0.0), (0.0, 0.9), (0.3, 0.9), (0.3, 1e-170), (0.1, 12.0)])
def test_chord_motion_is_newtons_law(theta, mu, gamma):
    t, g = 0.625, 9.81
    drive = mpf(g) * (mp.cos(mpf(theta)) - mpf(mu) * mp.sin(abs(mpf(theta))))
    along = travelled(drive, mpf(gamma), mpf(0), mpf(t))
    point = {"t": t, "theta": theta, "g": g, "mu": mu, "gamma": gamma}
    assert holds(reference("chord.distance", point)[0], along)
    x, y = reference("chord.position", point)
    assert x == ZERO or holds(x, along * mp.sin(mpf(theta)))
    assert holds(y, along * mp.cos(mpf(theta)))


@pytest.mark.parametrize(("mu", "gamma"), [(0.3, 0.0), (0.0, 0.9), (0.3, 0.9)])
def test_bead_has_reached_the_circle_at_the_descent_time(mu, gamma):
    point = CHORD | {"mu": mu, "gamma": gamma}
    time = ends(reference("chord.descent_time", point)[0])[0]
    drive = mpf(point["g"]) * (mp.cos(mpf(0.3)) - mpf(mu) * mp.sin(mpf(0.3)))
    end = mpf(point["diameter"]) * mp.cos(mpf(0.3))
    assert abs(travelled(drive, mpf(gamma), mpf(0), time) / end - 1) < mpf(2) ** -88


@pytest.mark.parametrize(("mu", "gamma"), [(0.0, 0.0), (0.5, 0.0), (0.0, 0.9), (0.36, 0.9)])
@pytest.mark.parametrize("theta", [0.0, 0.2, 0.7])
def test_circle_passes_through_the_beads(mu, gamma, theta):
    """Three enclosures satisfy (44) with the bead's position from Newton's law."""
    t, g = 0.625, 9.81
    circle = reference("chord.synchronous_circle", {"t": t, "g": g, "mu": mu, "gamma": gamma})
    side, depth, radius = (ends(one)[0] for one in circle)
    angle = mpf(theta)
    along = travelled(mpf(g) * (mp.cos(angle) - mpf(mu) * mp.sin(angle)), mpf(gamma), mpf(0), mpf(t))
    squares = (along * mp.sin(angle) + side) ** 2 + (along * mp.cos(angle) - depth) ** 2
    assert abs(squares / radius**2 - 1) < mpf(2) ** -86


@pytest.mark.parametrize("k", [0.0, 1e-170, 1e-9, 0.5, 9.0])
@pytest.mark.parametrize("theta", [0.0, 0.5, 1.5])
def test_projectile_motion_is_newtons_law(k, theta):
    t, v, g = 0.625, 10.0, 9.81
    x, y = reference("projectile.position", {"t": t, "theta": theta, "v": v, "g": g, "k": k})
    assert holds(x, travelled(mpf(0), mpf(k), mpf(v) * mp.cos(mpf(theta)), mpf(t)))
    height = travelled(-mpf(g), mpf(k), mpf(v) * mp.sin(mpf(theta)), mpf(t))
    low, high = ends(y)
    assert low <= height <= high
    assert high - low <= mpf(2) ** -90 * exactly(y.scale)


def test_height_is_measured_against_its_larger_term():
    point = THROW | {"k": 0.5}
    (time,) = reference("projectile.flight_time", point)
    t = nearest_float(time)
    _, y = reference("projectile.position", point | {"t": t})
    rise = mpf(50) * mp.sin(mpf(0.6)) * (1 - mp.exp(-mpf(t) / 2)) / mpf(0.5)
    assert abs(ends(y)[0]) < rise * mpf(2) ** -45
    assert abs(exactly(y.scale) / rise - 1) < mpf(2) ** -45


# --- edges -----------------------------------------------------------------------------------------------------------


def test_sliding_is_decided_by_the_exact_sign():
    """At the floats on either side of arctan(1/mu) for many mu."""
    for mu in (1e-12, 0.02, 0.36, 0.5, 1.0, 3.0, 1e12, 1e300):
        angle = critical_angle(mu)
        for ulps in (-1, 0, 1):
            theta = min(step(angle, ulps), HALF_PI)
            slides = mp.cos(mpf(theta)) - mpf(mu) * mp.sin(mpf(theta)) > 0
            point = CHORD | {"mu": mu, "theta": -theta}
            assert (reference("chord.descent_time", point) != (INFINITE,)) == slides
            moving = {"t": 1.0, "theta": theta, "g": 9.81, "mu": mu, "gamma": 0.5}
            assert (reference("chord.distance", moving) != (ZERO,)) == slides
            assert (reference("chord.position", moving) != (ZERO, ZERO)) == slides


def test_zero_time_and_zero_elevation():
    assert reference("projectile.flight_time", THROW | {"theta": 0.0, "k": 2.0}) == (ZERO,)
    assert reference("projectile.horizontal_range", THROW | {"theta": 0.0}) == (ZERO,)
    still = {"t": 0.0, "theta": 0.2, "g": 9.81, "mu": 0.1, "gamma": 2.0}
    assert reference("chord.distance", still) == (ZERO,)
    start = reference("projectile.position", THROW | {"t": 0.0, "k": 2.0})
    assert [one.ball for one in start] == [ZERO.ball] * 2


KNOWN_VALUES = {
    ("chord.descent_time", "drag"): ["0.45152", None, "1e100", None, None],
    ("chord.descent_time", "friction_drag"): ["4.336e14"],
    ("chord.distance", "drag"): ["4.3045", None, None],
    ("projectile.flight_time", "drag"): ["0.97742", None],
    ("projectile.position", "drag"): ["1.17088"],
    ("projectile.best_angle", "all"): ["0.62116", None, "0.78540", "7.06e-153", None],
}


@pytest.mark.parametrize("place", KNOWN_VALUES)
def test_known_hard_inputs_have_their_recorded_values(place):
    assert len(KNOWN_HARD[place]) == len(KNOWN_VALUES[place])
    for point, text in zip(KNOWN_HARD[place], KNOWN_VALUES[place], strict=True):
        last = reference(place[0], with_forces(*place, point))[-1]
        if text is not None:
            digits = len(text.split("e")[0].replace(".", "").lstrip("0"))
            assert abs(ends(last)[0] / mpf(text) - 1) < mpf(10) ** (1 - digits)


@pytest.mark.parametrize("exponent", [1000, 300, 50, 21, 20, 19, 5, 0, -3, -9])
def test_brackets_agree_with_plain_evaluation(exponent):
    z = math.ldexp(1.37, -exponent)
    with ctx.workprec(200):
        found = decay(number(z))
    fading = mp.exp(-mpf(z))
    for ball, exact in zip(found, (fading, 1 - fading, mpf(z) - 1 + fading), strict=True):
        low, high = ball_ends(ball)
        assert low <= exact <= high
        assert high - low <= abs(exact) * mpf(2) ** -150


def test_extremes_of_magnitude_are_certain():
    for size in (1e-300, 1e-150, 1e150, 1e300):
        for other in (1e-300, 1e300):
            (time,) = reference("chord.descent_time", CHORD | {"gamma": size, "diameter": other, "g": 1 / other})
            assert time.ball > 0
            (time,) = reference("projectile.flight_time", THROW | {"k": size, "v": other})
            assert time.ball > 0


def test_a_bracket_without_the_root_is_refused():
    for near in (1.5, 1.4):
        with pytest.raises(Undecided):
            proved_root(lambda x: x * x, number(2), number(near))
        with pytest.raises(Undecided):
            proved_root(lambda x: 4 / (x * x), number(2), number(near), falling=True)


def test_a_target_about_zero_is_refused():
    with pytest.raises(Undecided, match="too wide"):
        proved_root(lambda x: x * x, number(2, 0.5), number(1.4))


@pytest.mark.parametrize("ball", [number.pos_inf(), number.nan(), number(1, 1), number(2.0**-1070, 2.0**-1070)])
def test_balls_that_hold_little_are_no_references(ball):
    """An infinity and NaN are results only where the equations say so."""
    with pytest.raises(ArithmeticError, match="singular"):
        certain(lambda: (Enclosure(ball),))


def test_what_cannot_be_settled_is_an_error():
    def never():
        raise Undecided("a tie")

    with pytest.raises(ArithmeticError, match="singular"):
        certain(never)


@pytest.mark.parametrize("theta", [1e-5, 0.7, 1.5, HALF_PI])
def test_critical_friction_is_the_nearest_float(theta):
    exact = mp.cot(mpf(theta))
    mu = critical_friction(theta)
    assert abs(mpf(mu) - exact) <= min(abs(mpf(step(mu, ulps)) - exact) for ulps in (-1, 1))
