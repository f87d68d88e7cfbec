"""Scenes as objects: names and values that are refused, copies with other outputs or forces, arrays in and out."""

import pickle

import numpy as np
import pytest

from galileo_sym import Scene, chord

SPINDLE = Scene("chord", over=("t", "theta"), outputs=("x", "y"), g=9.81, mu=0.36, gamma=0.5)
T, THETA = np.linspace(0.0, 1.0, 4), np.linspace(-1.2, 1.2, 6)
GIVEN = {"over": ("t", "theta"), "outputs": "x", "g": 9.81}
REFUSED = [
    (ValueError, "nearest: chord", lambda: Scene("chrod", over="t", outputs="x")),
    (ValueError, "nearest: distance", lambda: Scene("chord", **{**GIVEN, "outputs": "distanc"})),
    (ValueError, "nearest: theta", lambda: Scene("chord", **{**GIVEN, "over": ("t", "thta")})),
    (TypeError, "nearest: gamma", lambda: Scene("chord", **GIVEN, gama=0.1)),
    (ValueError, "x needs theta", lambda: Scene("chord", over="t", outputs="x", g=9.81)),
    (ValueError, "g is both an axis and a constant", lambda: Scene("chord", **{**GIVEN, "over": ("t", "theta", "g")})),
    (ValueError, "named twice", lambda: Scene("chord", **{**GIVEN, "over": ("t", "t")})),
    (ValueError, "at least one output", lambda: Scene("chord", **{**GIVEN, "outputs": ()})),
    (ValueError, "> 0", lambda: Scene("chord", **{**GIVEN, "g": 0.0})),
    (ValueError, "finite", lambda: Scene("chord", **GIVEN, mu=np.inf)),
    (TypeError, "not a number", lambda: Scene("chord", **GIVEN, mu="0.3")),
    (TypeError, "not a number", lambda: Scene("chord", **GIVEN, mu=np.array([0.1, 0.2]))),
    (ValueError, "give diameter=", lambda: Scene("chord", **GIVEN, until="arrival")),
    (ValueError, "no end of", lambda: Scene("chord", **GIVEN, until="landing")),
    (TypeError, "give theta=", lambda: SPINDLE(t=T)),
    (TypeError, "no axis that varies here", lambda: SPINDLE(t=T, theta=THETA, g=9.81)),
    (TypeError, "give the length of every axis", lambda: SPINDLE.cost(t=3)),
    (
        ValueError,
        "no force of projectile",
        lambda: Scene("projectile", over=("t", "theta"), outputs="x", v=1, g=1).without("friction"),
    ),
    (AttributeError, "does not change", lambda: setattr(SPINDLE, "over", ("t",))),
    (TypeError, "2 outputs", lambda: SPINDLE(t=T, theta=THETA, out=np.empty((4, 6)))),
    (TypeError, "the grid has", lambda: SPINDLE(t=T, theta=THETA, out=(np.empty((6, 4)), None))),
    (TypeError, "float64 or float32", lambda: SPINDLE(t=T, theta=THETA, out=(np.empty((4, 6), int), None))),
    (TypeError, "not supported", lambda: SPINDLE(t=T * 1j, theta=THETA)),
]


@pytest.mark.parametrize(("error", "words", "call"), REFUSED)
def test_refused_with_cause_and_remedy(error, words, call):
    with pytest.raises(error, match=words):
        call()


def test_a_force_of_0_does_not_act_and_an_axis_of_it_does():
    assert SPINDLE.forces == ("friction", "drag")
    assert Scene("chord", **GIVEN, mu=0.0, gamma=0).forces == ()
    assert Scene("chord", **GIVEN, mu=0.0) == Scene("chord", **GIVEN)
    assert Scene("chord", **{**GIVEN, "over": ("t", "theta", "gamma")}).forces == ("drag",)
    assert SPINDLE.without("drag") == Scene("chord", **{**GIVEN, "outputs": ("x", "y")}, mu=0.36)
    assert Scene("chord", **{**GIVEN, "over": ("t", "theta", "gamma")}).without("drag") == Scene("chord", **GIVEN)


def test_scenes_compare_hash_print_and_pickle():
    same = Scene("chord", over=["t", "theta"], outputs=["x", "y"], gamma=0.5, mu=0.36, g=9.81)
    assert same == SPINDLE
    assert len({same, SPINDLE, SPINDLE.with_outputs("x", "y")}) == 1
    assert SPINDLE.with_outputs("x") != SPINDLE
    assert eval(repr(SPINDLE), {"Scene": Scene}) == SPINDLE
    assert pickle.loads(pickle.dumps(SPINDLE)) == SPINDLE


def test_one_output_by_name_is_the_array_itself():
    x, _ = SPINDLE(t=T, theta=THETA)
    alone = SPINDLE.with_outputs("x")(t=T, theta=THETA)
    np.testing.assert_array_equal(alone, x)
    (listed,) = SPINDLE.with_outputs(["x"])(t=T, theta=THETA)
    np.testing.assert_array_equal(listed, x)


def test_axes_of_any_shape():
    x = SPINDLE.with_outputs("x")
    np.testing.assert_array_equal(x(t=T.reshape(2, 2), theta=THETA), x(t=T, theta=THETA).reshape(2, 2, 6))
    np.testing.assert_array_equal(x(t=T[1], theta=THETA), x(t=T, theta=THETA)[1])
    assert isinstance(x(t=0.3, theta=0.2), np.float64)
    assert x(t=[], theta=THETA).shape == (0, 6)
    pointwise = x(grid=False, t=T, theta=THETA[:4])
    np.testing.assert_array_equal(pointwise, chord.position(T, THETA[:4], **x.constants)[0])
    np.testing.assert_allclose(pointwise, np.diag(x(t=T, theta=THETA[:4])), rtol=2.0**-51)


def test_out_is_written_and_returned():
    out = np.empty((4, 6)), np.empty((4, 6), np.float32)
    found = SPINDLE(t=T, theta=THETA, out=out)
    assert found[0] is out[0]
    assert found[1] is out[1]
    x, y = SPINDLE(t=T, theta=THETA)
    np.testing.assert_array_equal(out[0], x)
    np.testing.assert_array_equal(out[1], y.astype(np.float32))
    circle = Scene("chord", over=("t", "theta"), outputs="R", g=9.81, mu=0.1)
    assert circle(t=T, theta=THETA, out=out[0]) is out[0]
    np.testing.assert_array_equal(out[0], np.broadcast_to(circle(t=T, theta=0.0)[:, None], (4, 6)))


def test_float32_axes_give_float32():
    t, theta = T.astype(np.float32), np.float32([0.3, np.pi / 2])
    x, y = SPINDLE(t=t, theta=theta)
    assert x.dtype == y.dtype == np.float32
    expected = chord.position(t[:, None], theta, g=np.float32(9.81), mu=np.float32(0.36), gamma=np.float32(0.5))
    assert np.allclose((x, y), expected, rtol=1e-6, atol=0.0)


def test_arguments_outside_their_domains_and_nan():
    scene = SPINDLE.without("friction")
    with np.errstate(invalid="raise"):
        x, y = scene(t=[np.nan, 1.0], theta=[np.nan, 0.5])
        assert np.isnan(x).tolist() == np.isnan(y).tolist() == [[True, True], [True, False]]
        for bad in ({"t": [-1.0], "theta": [0.1]}, {"t": [1.0], "theta": [2.0]}):
            with pytest.raises(FloatingPointError):
                scene(**bad)
    with np.errstate(invalid="ignore"):
        assert np.isnan(scene(t=[-1.0, 1.0], theta=[0.1, 2.0])[0]).tolist() == [[True, True], [False, True]]
        at_infinity = scene.without("drag")(t=[np.inf], theta=[0.5, 0.0])
    np.testing.assert_array_equal(at_infinity, [[[np.inf, 0.0]], [[np.inf, np.inf]]])


def test_a_bead_at_rest_stays_at_the_top_and_never_arrives():
    given = {"g": 9.81, "mu": 0.5, "diameter": 1.0, "until": "forever"}
    scene = Scene("chord", over=("t", "theta"), outputs=("x", "distance", "descent_time"), **given)
    x, distance, time = scene(t=[1.0, 1e300], theta=[-1.2, 1.4])
    assert not x.any()
    assert not distance.any()
    assert np.isinf(time).all()
    held = Scene("chord", over="t", outputs=("x", "descent_time"), theta=1.2, **given)
    assert held(t=[0.5, np.nan])[0] == pytest.approx([0.0, np.nan], nan_ok=True)
    assert np.isinf(held(t=[0.5])[1]).all()
