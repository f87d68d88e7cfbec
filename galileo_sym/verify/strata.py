"""Strata: the regions of the inputs in which errors are sampled apart, as one table for each paper.

A stratum draws one value for each variable of its paper; a function keeps those it takes. Strata that need a
variable the kernel does not have are left out of its list.
"""

import math

from .enclosure import nearest_float
from .fixed_points import KNOWN_HARD, SCENES
from .lambert_strata import STRATA as LAMBERT
from .reference import reference
from .sampling import HALF_PI, critical_angle, critical_friction, grid_end, step
from .stratum import Stratum

_NEAR = 64  # places within which "near" is tried


def _tiny(draw):
    """Exponents of a drag that changes the last digits, or none at all."""
    return (-60, -8) if draw.chance(0.6) else (-1020, -60)


def _slight(draw):
    """An angle near 0 of either sign, 0 included."""
    return draw.sign() * (0.0 if draw.chance(0.05) else draw.magnitude(-1020, -10))


def _some_zero(draw, low, high):
    """Zero or an ordinary value, so that arrays hold both."""
    return draw.magnitude(low, high) if draw.chance(0.5) else 0.0


def _grid_angle(draw, top):
    """An angle within 4 places of a multiple of 1/128 up to top/128, or of pi/4 if that is below."""
    middle = draw.chance(0.1) and top / 128.0 > HALF_PI / 2
    return step(HALF_PI / 2 if middle else draw.integer(1, top) / 128.0, draw.integer(-4, 4))


# --- chord -----------------------------------------------------------------------------------------------------------


def _chord(draw, has, **given):
    """Typical values of all variables of the chord, save those given."""
    mu = given.get("mu", draw.magnitude(-4, 1)) if "mu" in has else 0.0
    share = draw.uniform(-0.95, 0.95)
    typical = {
        "theta": share * critical_angle(mu),
        "t": draw.magnitude(-4, 3),
        "diameter": draw.magnitude(-4, 4),
        "g": draw.magnitude(0, 5),
        "gamma": draw.magnitude(-4, 3),
    }
    return {**typical, **given, "mu": mu}


def _chord_extreme(draw, has):
    wide = {name: draw.magnitude(-830, 830) for name in ("t", "diameter", "g", "gamma", "mu")}
    return _chord(draw, has, **wide)


def _chord_critical(draw, has):
    mu = draw.magnitude(-30, 30) if draw.chance(0.5) else draw.magnitude(-4, 1)
    return _chord(draw, has, mu=mu, theta=draw.sign() * step(critical_angle(mu), -draw.integer(0, _NEAR)))


def _chord_approaching(draw, has):
    """Angles at every binary distance below theta_max, where the cancellation in cos - mu sin sets in."""
    mu = draw.magnitude(-30, 30) if draw.chance(0.5) else draw.magnitude(-4, 1)
    return _chord(draw, has, mu=mu, theta=draw.sign() * critical_angle(mu) * (1.0 - draw.magnitude(-47, -4)))


def _chord_at_rest(draw, has):
    mu = draw.magnitude(-4, 1)
    above = step(critical_angle(mu), draw.integer(1, _NEAR))
    theta = above if draw.chance(0.5) else draw.uniform(above, HALF_PI)
    return _chord(draw, has, mu=mu, theta=draw.sign() * theta)


def _chord_steep(draw, has):
    """Nearly horizontal chords; friction, where there is any, is below its critical value."""
    theta = step(HALF_PI, -draw.integer(0, _NEAR)) if draw.chance(0.5) else HALF_PI - draw.magnitude(-50, -8)
    return _chord(draw, has, theta=draw.sign() * theta, mu=draw.uniform(0.0, 0.99) * critical_friction(theta))


def _chord_grid(draw, has):
    shift = draw.integer(-3, 3)
    angle = _grid_angle(draw, 51 if "mu" in has else 201)
    given = {
        "gamma": math.ldexp(grid_end(draw), -shift),
        "t": math.ldexp(1.0, shift),
        "g": 1.0,
        "diameter": math.ldexp(0.5, 2 * shift),
        "theta": draw.sign() * angle if draw.chance(0.5) else 0.0,
    }
    return _chord(draw, has, **given)


def _chord_range_ends(draw, has):
    """Results among the subnormals, or close to overflow; g and D may be subnormal themselves."""
    small, large = (-1074, -1010), (1012, 1023)
    if "diameter" not in has:
        return _chord(draw, has, g=draw.magnitude(*(small if draw.chance(0.5) else large)))
    length, weight, rate = (small, large, large) if draw.chance(0.5) else (large, small, small)
    given = {"diameter": draw.magnitude(*length), "g": draw.magnitude(*weight), "gamma": draw.magnitude(*rate)}
    return _chord(draw, has, **given)


_CHORD = (
    Stratum("typical", (), _chord),
    Stratum("tiny-drag", ("gamma",), lambda draw, has: _chord(draw, has, gamma=draw.magnitude(*_tiny(draw)))),
    Stratum("huge-drag", ("gamma",), lambda draw, has: _chord(draw, has, gamma=draw.magnitude(4, 900))),
    Stratum("zero-drag", ("gamma",), lambda draw, has: _chord(draw, has, gamma=_some_zero(draw, -4, 3))),
    Stratum("zero-friction", ("mu",), lambda draw, has: _chord(draw, has, mu=_some_zero(draw, -4, 1))),
    Stratum("extreme", (), _chord_extreme),
    Stratum("range-ends", (), _chord_range_ends),
    Stratum("near-theta-max", ("mu", "theta"), _chord_critical),
    Stratum("approaching-theta-max", ("mu", "theta"), _chord_approaching),
    Stratum("at-rest", ("mu", "theta"), _chord_at_rest),
    Stratum("theta-near-0", ("theta",), lambda draw, has: _chord(draw, has, theta=_slight(draw))),
    Stratum("theta-near-half-pi", ("theta",), _chord_steep),
    Stratum("interval-ends", (), _chord_grid),
)


# --- projectile ------------------------------------------------------------------------------------------------------


def _throw(draw, has, **given):
    """Typical values of all variables of the projectile, save those given; t reaches a little beyond landing."""
    values = {
        "theta": draw.uniform(0.05, 1.5),
        "v": draw.magnitude(0, 8),
        "g": draw.magnitude(0, 5),
        "k": draw.magnitude(-5, 3),
        **given,
    }
    drawn = draw.uniform(0.01, 1.2) * (2 * values["v"] * values["theta"] / values["g"])
    return {"t": drawn, **values} if "k" in has else {"t": drawn, **values, "k": 0.0}


def _throw_extreme(draw, has):
    wide = {name: draw.magnitude(-830, 830) for name in ("t", "v", "g", "k")}
    return _throw(draw, has, theta=draw.magnitude(-830, 0), **wide)


def _throw_upward(draw, has):
    theta = step(HALF_PI, -draw.integer(0, _NEAR)) if draw.chance(0.5) else HALF_PI - draw.magnitude(-50, -8)
    return _throw(draw, has, theta=theta)


def _landing(draw, has):
    """Times within 64 places of the impact."""
    throw = _throw(draw, has)
    arguments = {name: throw[name] for name in ("theta", "v", "g", "k")}
    (impact,) = reference("projectile.flight_time", arguments)
    return {**throw, "t": step(nearest_float(impact), draw.integer(-_NEAR, _NEAR))}


def _throw_grid(draw, has):
    shift = draw.integer(-3, 3)
    unit = math.ldexp(1.0, shift)
    angle = _grid_angle(draw, 201)
    given = {"k": grid_end(draw) / unit, "t": unit, "v": 1.0, "g": 1.0 / unit}
    return _throw(draw, has, theta=angle if draw.chance(0.5) else HALF_PI, **given)


# exponents of v, g, k: heights go with v and g, flight times with v/g, ranges with v**2/g
_POSITION_ENDS = (((-1074, -1015), (-1074, -1015), (-5, 3)), ((1010, 1023), (1010, 1023), (-5, 3)))
_FLIGHT_ENDS = (
    ((-1074, -1000), (0, 30), (1000, 1023)),
    ((1000, 1023), (-20, 0), (-1030, -1000)),
    ((-540, -490), (0, 30), (490, 560)),
    ((490, 512), (-20, 0), (-530, -490)),
)


def _throw_range_ends(draw, has):
    """Results among the subnormals, or close to overflow."""
    ends = _POSITION_ENDS if "t" in has else _FLIGHT_ENDS
    speed, weight, rate = ends[draw.integer(0, len(ends) - 1)]
    throw = _throw(draw, has, v=draw.magnitude(*speed), g=draw.magnitude(*weight), k=draw.magnitude(*rate))
    return {**throw, "t": draw.magnitude(-2, 2)}


_PROJECTILE = (
    Stratum("typical", (), _throw),
    Stratum("tiny-drag", ("k",), lambda draw, has: _throw(draw, has, k=draw.magnitude(*_tiny(draw)))),
    Stratum("huge-drag", ("k",), lambda draw, has: _throw(draw, has, k=draw.magnitude(4, 900))),
    Stratum("zero-drag", ("k",), lambda draw, has: _throw(draw, has, k=_some_zero(draw, -5, 3))),
    Stratum("extreme", (), _throw_extreme),
    Stratum("range-ends", (), _throw_range_ends),
    Stratum("theta-near-0", (), lambda draw, has: _throw(draw, has, theta=abs(_slight(draw)))),
    Stratum("theta-near-half-pi", (), _throw_upward),
    Stratum("near-landing", ("t",), _landing),
    Stratum("interval-ends", (), _throw_grid),
)

_BEST_ANGLE = (
    Stratum("typical", (), lambda draw, has: {"alpha": draw.magnitude(-4, 6)}),
    Stratum("tiny-drag", (), lambda draw, has: {"alpha": draw.magnitude(-1020, -4)}),
    Stratum("huge-drag", (), lambda draw, has: {"alpha": draw.magnitude(6, 1023)}),
    Stratum("alpha-near-1", (), lambda draw, has: {"alpha": step(1.0, draw.integer(-_NEAR, _NEAR))}),
    Stratum("interval-ends", (), lambda draw, has: {"alpha": grid_end(draw)}),
)


def random_strata(function, force_set):
    """The strata drawn at random for one kernel, in the order of the tables."""
    if function.paper == "lambert":
        return list(LAMBERT[function.name])
    if "alpha" in function.positional:
        return list(_BEST_ANGLE)
    table = {"chord": _CHORD, "projectile": _PROJECTILE}[function.paper]
    has = set(function.arguments(force_set))
    return [stratum for stratum in table if has.issuperset(stratum.needs)]


def fixed_strata(function, force_set):
    """Names and points of the strata that are lists."""
    lists = {
        "scenes": SCENES.get((function.full_name, force_set)) or SCENES[function.paper, force_set],
        "known-hard": KNOWN_HARD.get((function.full_name, force_set), []),
    }
    return {name: points for name, points in lists.items() if points}


def strata_names(function, force_set):
    """All strata of one kernel, in order."""
    return [*(stratum.name for stratum in random_strata(function, force_set)), *fixed_strata(function, force_set)]
