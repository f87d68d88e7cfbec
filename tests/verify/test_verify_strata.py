"""Each stratum applies somewhere, yields what its name says, and a vacuous one is an error."""

import math

import pytest
from mpmath import mp, mpf
from verify_ends import ends, exactly

from galileo_sym.verify.enclosure import INFINITE, ZERO
from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.measure import Task, VacuousStratumError, as_hex, from_hex, take_sample
from galileo_sym.verify.sampling import HALF_PI, Draw, critical_angle, grid_end, step
from galileo_sym.verify.strata import Stratum, fixed_strata, random_strata, strata_names

EVERY = [
    (name, force_set, stratum)
    for name, function in FUNCTIONS.items()
    for force_set in function.force_sets
    for stratum in strata_names(function, force_set)
]


@pytest.mark.parametrize("place", EVERY, ids=":".join)
def test_each_stratum_yields_points_inside_the_domain(place):
    sample = take_sample(Task(*place, 8, 1))
    function = FUNCTIONS[place[0]]
    lists = fixed_strata(function, place[1])
    assert sample.size == len(lists.get(place[2], range(8)))
    assert list(sample.arguments) == list(function.arguments(place[1]))
    for name, values in sample.arguments.items():
        assert all(map(math.isfinite, values))
        if name == "theta":
            least = -HALF_PI if place[0].startswith("chord") else 0.0
            assert all(least <= value <= HALF_PI for value in values)
        elif name in function.ranges:
            least, greatest = function.ranges[name]
            assert all(least <= value <= greatest for value in values)
        elif name in {"g", "diameter", "v"}:
            assert all(value > 0 for value in values)
        else:
            assert all(value >= 0 for value in values)


def test_names_are_unique_in_each_kernel():
    for name, function in FUNCTIONS.items():
        for force_set in function.force_sets:
            names = strata_names(function, force_set)
            assert len(set(names)) == len(names), name
            assert {"typical", "scenes"} <= set(names)


def sampled(place, points=40):
    return take_sample(Task(*place, points, 7))


def test_near_theta_max_is_within_64_places_and_reaches_both_sides():
    sample = sampled(("chord.descent_time", "friction_drag", "near-theta-max"))
    for theta, mu in zip(sample.arguments["theta"], sample.arguments["mu"], strict=True):
        angle = critical_angle(mu)
        assert step(angle, -64) <= abs(theta) <= angle
    assert {math.copysign(1, theta) for theta in sample.arguments["theta"]} == {1.0, -1.0}


@pytest.mark.parametrize(
    ("name", "still"), [("chord.descent_time", INFINITE), ("chord.distance", ZERO), ("chord.position", ZERO)]
)
def test_beads_at_rest_are_at_rest(name, still):
    sample = sampled((name, "friction", "at-rest"))
    assert all(one == still for index in range(sample.size) for one in sample.references(index))


def test_extreme_reaches_far():
    sizes = sampled(("projectile.flight_time", "drag", "extreme"), 200).arguments["v"]
    assert min(sizes) < 1e-200
    assert max(sizes) > 1e200


def test_tiny_drag_covers_both_lost_digits_and_none():
    rates = sampled(("chord.distance", "drag", "tiny-drag"), 100).arguments["gamma"]
    assert min(rates) < 1e-100
    assert any(2.0**-60 <= rate < 2.0**-8 for rate in rates)


def test_zero_drag_mixes_zeros_and_others():
    rates = sampled(("chord.position", "drag", "zero-drag")).arguments["gamma"]
    assert 0.0 in rates
    assert any(rates)


def test_near_landing_is_within_places_of_the_impact():
    sample = sampled(("projectile.position", "drag", "near-landing"))
    with mp.workprec(400):
        for index in range(sample.size):
            _, y = sample.references(index)
            assert max(map(abs, ends(y))) < mpf(2) ** -44 * exactly(y.scale)


def test_alpha_near_one():
    alphas = sampled(("projectile.best_angle", "all", "alpha-near-1"), 200).arguments["alpha"]
    assert all(step(1.0, -64) <= alpha <= step(1.0, 64) for alpha in alphas)
    assert min(alphas) < 1.0 < max(alphas)


def test_grid_ends_are_near_sixteenths_of_a_binade():
    draw = Draw("grid")
    for _ in range(200):
        end = grid_end(draw)
        assert end > 0
        mantissa, _ = math.frexp(1.0 + end)
        assert abs(mantissa * 32 - round(mantissa * 32)) < 1e-13


def test_vacuous_stratum_is_an_error(monkeypatch):
    def nothing(draw, has):
        return {"alpha": 1e308}

    huge = [Stratum("beyond", (), nothing)]
    monkeypatch.setattr("galileo_sym.verify.measure.random_strata", lambda *_: huge)
    monkeypatch.setattr("galileo_sym.verify.measure.representable", lambda _: False)
    with pytest.raises(VacuousStratumError, match="only 0 of 5 points"):
        take_sample(Task("projectile.best_angle", "all", "beyond", 5, 1))


def test_step_crosses_binades():
    assert step(1.0, -1) == 1.0 - 2.0**-53
    assert step(1.0, 2) == 1.0 + 2.0**-51
    assert step(1.0, 0) == 1.0


@pytest.mark.parametrize("mu", [1e-300, 1e-9, 0.36, 0.5, 7.0, 1e200])
def test_critical_angle_is_the_nearest_float(mu):
    with mp.workdps(400):
        exact = mp.atan(1 / mpf(mu))
        angle = critical_angle(mu)
        assert angle <= HALF_PI
        nearer = [abs(mpf(other) - exact) for other in (step(angle, -1), step(angle, 1)) if other <= HALF_PI]
        assert abs(mpf(angle) - exact) <= min(nearer)


def test_hex_round_trip():
    point = {"theta": 0.1, "k": 5e-324}
    assert from_hex(as_hex(point)) == point
    with pytest.raises(ValueError, match="infinite"):
        from_hex({"k": "inf"})


def test_every_kernel_has_the_strata_that_its_arguments_allow():
    names = {
        place: {one.name for one in random_strata(FUNCTIONS[place[0]], place[1])} for place in (x[:2] for x in EVERY)
    }
    assert "near-theta-max" in names["chord.position", "friction"]
    assert "near-theta-max" not in names["chord.position", "drag"]
    assert "near-theta-max" not in names["chord.synchronous_circle", "friction"]
    assert "tiny-drag" not in names["chord.distance", "friction"]
    assert "near-landing" in names["projectile.position", "drag"]
    assert "near-landing" not in names["projectile.flight_time", "drag"]
