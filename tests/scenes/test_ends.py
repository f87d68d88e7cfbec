"""Motions that end: beads stay where they arrive, projectiles where they land; what stays is not computed."""

import numpy as np
import pytest

from galileo_sym import Scene, chord, projectile
from galileo_sym.scenes import ends, operations

GIVEN = {"g": 9.81, "mu": 0.36, "gamma": 0.5}
BEADS = Scene("chord", over=("t", "theta"), outputs=("x", "y", "distance", "speed"), diameter=1.3, **GIVEN)
SHOTS = Scene("projectile", over=("theta", "t"), outputs=("x", "y", "vx", "vy"), until="landing", v=20.0, g=9.81, k=0.3)
T = np.linspace(-0.5, 4.0, 60)
THETA = np.concatenate([np.linspace(-1.5, 1.5, 30), [np.arctan(1 / 0.36), np.pi / 2]])
ULP = 4 * 2.0**-52


def test_beads_start_at_the_top_slide_and_stay_at_the_end_of_the_chord():
    time = np.maximum(T, 0.0)[:, None]
    gone = np.minimum(chord.distance(time, THETA, **GIVEN), 1.3 * np.cos(THETA))
    arrival = chord.descent_time(THETA, diameter=1.3, **GIVEN)
    speed = np.where((T[:, None] < 0) | (time > arrival), 0.0, chord.speed(time, THETA, **GIVEN))
    expected = gone * np.sin(THETA), gone * np.cos(THETA), gone, speed
    for found, wanted in zip(BEADS(t=T, theta=THETA), expected, strict=True):
        np.testing.assert_allclose(found, wanted, rtol=ULP, atol=0.0)


def test_without_friction_all_beads_arrive_at_once():
    """At one time, so that no arrival is over the axis of the angles; after it in the midst of others."""
    scene, theta, time = BEADS.without("friction"), THETA[10:14], np.array([0.1, 3.0, 0.2, -1.0, 0.3])
    found = dict(zip(scene.outputs, scene(t=time, theta=theta), strict=True))
    np.testing.assert_array_equal(found["speed"][[1, 3]], np.zeros((2, 4)))
    np.testing.assert_allclose(found["distance"][1], 1.3 * np.cos(theta), rtol=ULP)
    assert np.all(found["speed"][[0, 2, 4]] > 0.0)


def test_projectiles_stay_where_they_land():
    shot = {"v": 20.0, "g": 9.81, "k": 0.3}
    theta = np.linspace(0.0, np.pi / 2, 21)[:, None]
    time = np.maximum(T, 0.0)
    x, y = projectile.position(time, theta, **shot)
    landing = projectile.flight_time(theta, **shot)
    vx, vy = (np.where((T < 0) | (time > landing), 0.0, v) for v in projectile.velocity(time, theta, **shot))
    expected = np.minimum(x, projectile.horizontal_range(theta, **shot)), np.maximum(y, 0.0), vx, vy
    for found, wanted in zip(SHOTS(t=T, theta=theta[:, 0]), expected, strict=True):
        np.testing.assert_allclose(found, wanted, rtol=ULP, atol=20.0 * 2.0**-50)


@pytest.mark.parametrize("scene", [BEADS, SHOTS], ids=["chord", "projectile"])
def test_the_order_of_times_does_not_matter(scene):
    theta = THETA[10:] if scene is BEADS else np.linspace(0.0, 1.5, 9)
    order = np.random.default_rng(8).permutation(len(T))
    for sorted_times, mixed in zip(scene(t=T, theta=theta), scene(t=T[order], theta=theta), strict=True):
        axis = scene.over.index("t")
        np.testing.assert_array_equal(np.take(sorted_times, order, axis), mixed)


def test_times_after_the_last_arrival_are_not_computed(monkeypatch):
    seen = []
    before = operations.OPERATIONS["phi2m"]
    monkeypatch.setitem(operations.OPERATIONS, "phi2m", lambda z: seen.append(z.hi.size) or before(z))
    late = np.linspace(0.0, 100.0, 1000)
    theta = np.array([-1.5, -0.8, 0.0, 0.7, 1.1])  # the first bead does not move at all
    x, *_ = BEADS(t=late, theta=theta)
    last = chord.descent_time(theta[1:], diameter=1.3, **GIVEN).max()
    moving = np.sum(late <= last)
    assert seen == [moving]
    assert np.all(x[-1] == x[moving])
    assert moving < 100


@pytest.mark.parametrize("outputs", [BEADS.outputs, "speed"], ids=["all", "speed"])
def test_rows_and_columns_in_which_nothing_moves_are_filled(outputs, monkeypatch):
    """Beads at 1.3 and beyond are at rest; those at 0.2, -0.7 and 1.0 arrive after 0.56, 0.65 and 0.83 s."""
    seen, placed, scene = [], ends.all_placed, BEADS.with_outputs(outputs)
    monkeypatch.setattr(ends, "all_placed", lambda *given: seen.append(given[4]) or placed(*given))
    theta = np.array([-1.5, -1.3, -0.7, 1.4, 0.2, 1.0, 1.3, 1.5])
    time = np.array([-2.0, -1.0, 0.0, -0.5, 0.1, 0.6, 1e6, 1e7])
    whole = np.reshape(scene(t=time, theta=theta), (-1, 8, 8))
    assert seen.pop() == (4, 4)
    inside = np.roll(np.arange(8), 3)  # what moves is at the borders: nothing is left out
    mixed = np.reshape(scene(t=time[inside], theta=theta[inside]), whole.shape)
    assert seen.pop() == (8, 8)
    np.testing.assert_array_equal(mixed, whole[:, inside][:, :, inside])
    late = np.reshape(scene(t=[0.7], theta=[0.2, -0.7, 1.0, 1.4]), (-1, 4))
    assert seen.pop() == (1, 1)
    each = [
        np.reshape(scene(t=[0.1, 0.7], theta=[1.0, angle, 1.0]), (-1, 2, 3))[:, 1, 1] for angle in (0.2, -0.7, 1.0, 1.4)
    ]
    np.testing.assert_array_equal(late, np.transpose(each))


def test_out_types_missing_values_and_other_axes():
    out = tuple(np.empty((len(T), len(THETA))) for _ in range(4))
    plain = BEADS(t=T, theta=THETA)
    assert all(a is b for a, b in zip(BEADS(t=T, theta=THETA, out=out), out, strict=True))
    np.testing.assert_array_equal(out, plain)
    single = BEADS(t=T.astype(np.float32), theta=THETA.astype(np.float32))
    assert {array.dtype for array in single} == {np.dtype(np.float32)}
    gaps = np.where(T < 0.3, np.nan, T)
    assert np.array_equal(np.isnan(BEADS(t=gaps, theta=THETA)[0]).all(axis=1), T < 0.3)
    later = Scene("chord", over=("diameter", "theta"), outputs="distance", t=1e3, **GIVEN)
    found = later(diameter=[1.0, 2.0], theta=[0.2, 1.3])
    np.testing.assert_allclose(found, [[np.cos(0.2), 0.0], [2 * np.cos(0.2), 0.0]], rtol=ULP)
    with_circle = BEADS.with_outputs("x", "R")(t=T[10:], theta=THETA)
    np.testing.assert_array_equal(with_circle[0], plain[0][10:])


def test_positions_go_on_where_it_is_asked_for():
    beyond = Scene("chord", over="t", outputs="distance", theta=0.0, diameter=1.0, g=9.81, until="forever")
    assert beyond(t=[10.0])[0] > 400.0
    assert BEADS.until == "arrival"
    assert SHOTS.until == "landing"
