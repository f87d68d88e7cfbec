"""Points of the synchronous curve: against circles (21) and (24) at high precision, and as a NumPy function."""

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from galileo_sym import Scene, chord

MOST = 2.0  # ulp of each coordinate


def exact(t, n, g, mu, gamma):
    """Points of the circles of the papers, from their centres and radii, at equal angles seen from these."""
    with mpmath.workprec(2600):
        t, g, mu, z = mpf(t), mpf(g), mpf(mu), mpf(gamma) * mpf(t)
        across = g * t * t * ((z - 1 + mpmath.exp(-z)) / z**2 if z else mpf(1) / 2) / 2  # of the centre, (45)-(47)
        offset = mpmath.atan(mu)
        points = []
        for place in range(n):
            seen = offset + (mpmath.pi - 2 * offset) * abs(n - 2 * place) / n
            x = across * (mpmath.sqrt(1 + mu**2) * mpmath.sin(seen) - mu)
            y = across * (mpmath.sqrt(1 + mu**2) * mpmath.cos(seen) + 1)
            points.append((0 if 2 * place in (0, n) else x if 2 * place < n else -x, y if place else 0))
        return points


def error(value, wanted):
    """Error of a double in ulp."""
    with mpmath.workprec(200):
        return float(abs(mpf(float(value)) - wanted) / mpf(float(np.spacing(abs(float(wanted))))))


@pytest.mark.parametrize("n", [1, 2, 5, 16])
@pytest.mark.parametrize("mu", [0.0, 1e-9, 0.36, 7.3, 1e12])
def test_points_lie_on_the_circles_at_equal_arcs(mu, n):
    for t, gamma in ((0.7, 0.0), (3.1, 0.4), (50.0, 1e-7), (1e250, 1e250), (1e-40, 1e30)):
        x, y = chord.synchronous_curve(t, n, g=9.81, mu=mu, gamma=gamma)
        for point, wanted in zip(zip(x, y, strict=True), exact(t, n, 9.81, mu, gamma), strict=True):
            assert max(map(error, point, wanted)) <= MOST, (t, gamma, point)


def test_sizes_and_frictions_at_the_ends_of_the_range():
    for t, mu in ((1e154, 1e100), (1e160, 1e300), (1e-155, 0.2), (1.0, 1e308)):
        with np.errstate(over="ignore", under="ignore"):
            x, y = chord.synchronous_curve(t, 6, g=9.81, mu=mu)
        for point, wanted in zip(zip(x, y, strict=True), exact(t, 6, 9.81, mu, 0.0), strict=True):
            for value, true in zip(point, wanted, strict=True):
                assert np.isinf(value) if true > mpf(2) ** 1024 else error(value, true) <= MOST, (t, mu, value)


def test_points_are_those_of_beads_and_mirror_images():
    given = {"g": 9.81, "mu": 0.5, "gamma": 0.3}
    x, y = chord.synchronous_curve(0.8, 40, **given)
    angles = np.arctan(2.0) * (1 - np.arange(41) / 20)[:40]
    bead_x, bead_y = chord.position(0.8, angles, **given)
    np.testing.assert_allclose(x[1:], bead_x[1:], rtol=1e-13, atol=1e-15)
    np.testing.assert_allclose(y[1:], bead_y[1:], rtol=1e-13, atol=1e-15)
    assert (x[0], y[0], x[20], y[20]) == (0.0, 0.0, 0.0, chord.distance(0.8, 0.0, g=9.81, gamma=0.3))
    assert np.array_equal(x[1:], -x[:0:-1])
    assert np.array_equal(y[1:], y[:0:-1])
    round_x, round_y = chord.synchronous_curve(0.8, 9, g=9.81)
    _, centre, radius = chord.synchronous_circle(0.8, g=9.81)
    np.testing.assert_allclose(np.hypot(round_x, round_y - centre), radius, rtol=1e-15)


def test_it_broadcasts_and_takes_what_ufuncs_take():
    t, mu = np.linspace(0.1, 1.0, 3)[:, None], np.array([0.0, 0.4])
    x, y = chord.synchronous_curve(t, 7, g=9.81, mu=mu)
    assert x.shape == y.shape == (3, 2, 7)
    np.testing.assert_array_equal(x[2, 1], chord.synchronous_curve(1.0, 7, g=9.81, mu=0.4)[0])
    out = np.empty((3, 2, 7)), np.empty((3, 2, 7), np.float32)
    found = chord.synchronous_curve(t, 7, g=9.81, mu=mu, out=out)
    assert found[0] is out[0]
    assert found[1] is out[1]
    np.testing.assert_array_equal(out[1], y.astype(np.float32))
    some = np.arange(7) % 2 == 0
    loose, _ = chord.synchronous_curve(t, 7, g=9.81, mu=mu, where=some)
    assert np.array_equal(np.isnan(loose), np.broadcast_to(~some, loose.shape))
    single, _ = chord.synchronous_curve(np.float32(0.5), 4, g=9.81)
    assert single.dtype == np.float32
    assert chord.synchronous_curve(0.5, 4, g=9.81, dtype=np.float32)[0].dtype == np.float32
    with pytest.raises(TypeError, match="Cannot cast"):
        chord.synchronous_curve(t, 4, g=9.81, dtype=np.float32, casting="safe")
    with pytest.raises(TypeError, match="not supported"):
        chord.synchronous_curve(1j, 4, g=9.81)
    with pytest.raises(TypeError, match="without a mask"):
        chord.synchronous_curve(np.ma.MaskedArray([1.0], mask=[True]), 4, g=9.81)
    for wrong, kind in ((0, ValueError), (2.0, TypeError), ("3", TypeError)):
        with pytest.raises(kind, match=r"points|at least 1"):
            chord.synchronous_curve(1.0, wrong, g=9.81)


def test_outside_the_domain_missing_and_infinite():
    for bad in ({"t": -1.0}, {"g": 0.0}, {"mu": -0.1}, {"gamma": -1.0}):
        given = {"t": [1.0, 1.0], "g": 9.81, "mu": 0.1, "gamma": 0.2, **bad}
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
            chord.synchronous_curve(given.pop("t"), 3, **given)
    with np.errstate(all="raise"):
        x, y = chord.synchronous_curve([np.nan, 0.0, 1.0, np.inf], 3, g=2.0, gamma=1.0)
    assert np.isnan(x[0]).all()
    assert np.isnan(y[0]).all()
    assert not x[1].any()
    assert np.array_equal(y[2], chord.synchronous_curve(1.0, 3, g=2.0, gamma=1.0)[1])
    assert np.array_equal(np.isinf(y[3]), [False, True, True])
    with np.errstate(invalid="ignore"):
        x, _ = chord.synchronous_curve(np.inf, 3, g=2.0, gamma=np.inf)
    assert np.array_equal(np.isnan(x), [False, True, True])


def test_scenes_show_whole_curves():
    scene = Scene("chord", over=("t", "mu", "theta"), outputs=("y", "x"), g=9.81, gamma=0.2)
    t, mu = np.array([0.1, 0.4]), np.array([0.0, 0.3, 2.0])
    y, x = scene.curve(12, t=t, mu=mu)
    wanted = chord.synchronous_curve(t[:, None], 12, g=9.81, mu=mu, gamma=0.2)
    np.testing.assert_array_equal((x, y), wanted)
    out = np.empty((2, 3, 12))
    assert scene.with_outputs("x").curve(12, t=t, mu=mu, out=out) is out
    np.testing.assert_array_equal(out, x)
    with pytest.raises(TypeError, match="give mu="):
        scene.curve(12, t=t)
    with pytest.raises(TypeError, match="no axis that varies here"):
        scene.curve(12, t=t, mu=mu, theta=0.1)
    for wrong in (scene.with_outputs("x", "speed"), Scene("chord", over="t", outputs="x", theta=0.1, g=9.81)):
        with pytest.raises(ValueError, match=r"x and y|as the last axis"):
            wrong.curve(12, t=t)
    stopping = Scene("chord", over=("t", "theta"), outputs="x", g=9.81, diameter=1.0)
    with pytest.raises(ValueError, match="until='forever'"):
        stopping.curve(12, t=t)
