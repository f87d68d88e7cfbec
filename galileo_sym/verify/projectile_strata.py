"""The strata of the projectile's functions."""

import math

from .enclosure import nearest_float
from .reference import reference
from .sampling import HALF_PI, grid_end, step
from .stratum import NEAR, Stratum, grid_angle, slight, some_zero, tiny


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
    theta = step(HALF_PI, -draw.integer(0, NEAR)) if draw.chance(0.5) else HALF_PI - draw.magnitude(-50, -8)
    return _throw(draw, has, theta=theta)


def _landing(draw, has):
    """Times within 64 places of the impact."""
    throw = _throw(draw, has)
    arguments = {name: throw[name] for name in ("theta", "v", "g", "k")}
    (impact,) = reference("projectile.flight_time", arguments)
    return {**throw, "t": step(nearest_float(impact), draw.integer(-NEAR, NEAR))}


def _throw_grid(draw, has):
    shift = draw.integer(-3, 3)
    unit = math.ldexp(1.0, shift)
    angle = grid_angle(draw, 201)
    given = {"k": grid_end(draw) / unit, "t": unit, "v": 1.0, "g": 1.0 / unit}
    return _throw(draw, has, theta=angle if draw.chance(0.5) else HALF_PI, **given)


# exponents of v, g, k: heights go with v and g, flight times with v/g, ranges with v**2/g, their loss with v**3/g**2
_POSITION_ENDS = (((-1074, -1015), (-1074, -1015), (-5, 3)), ((1010, 1023), (1010, 1023), (-5, 3)))
_FLIGHT_ENDS = (
    ((-1074, -1000), (0, 30), (1000, 1023)),
    ((1000, 1023), (-20, 0), (-1030, -1000)),
    ((-540, -490), (0, 30), (490, 560)),
    ((490, 512), (-20, 0), (-530, -490)),
    ((-355, -330), (0, 8), (330, 365)),
    ((330, 340), (-4, 0), (-350, -330)),
)


def _throw_range_ends(draw, has):
    """Results among the subnormals, or close to overflow."""
    ends = _POSITION_ENDS if "t" in has else _FLIGHT_ENDS
    speed, weight, rate = ends[draw.integer(0, len(ends) - 1)]
    throw = _throw(draw, has, v=draw.magnitude(*speed), g=draw.magnitude(*weight), k=draw.magnitude(*rate))
    return {**throw, "t": draw.magnitude(-2, 2)}


def _near_or_approaching(draw, middle, top):
    """Within 64 places of a number, or at every binary distance from it, below `top`."""
    if draw.chance(0.5):
        return min(step(middle, draw.integer(-NEAR, NEAR)), top)
    return min(middle * (1.0 + draw.sign() * draw.magnitude(-47, -4)), top)


def _apex(draw, has):
    """Times about the one at which the upward velocity is 0."""
    throw = _throw(draw, has)
    rise = throw["v"] * math.sin(throw["theta"]) / throw["g"]
    apex = math.log1p(throw["k"] * rise) / throw["k"] if throw["k"] else rise
    return {**throw, "t": _near_or_approaching(draw, apex, math.inf)}


def _throw_fading(draw, has):
    """Large k while exp(-kt) is still representable, among the subnormals or not."""
    throw = _throw(draw, has, k=draw.magnitude(4, 900))
    return {**throw, "t": draw.uniform(0.0, 750.0) / throw["k"]}


def _farthest(draw, has):
    """Elevations about the one of greatest range."""
    throw = _throw(draw, has)
    if "k" in has and draw.chance(0.5):
        throw["k"] = draw.magnitude(-60, 200)
    (best,) = reference("projectile.best_angle", {"alpha": throw["k"] * throw["v"] / throw["g"]})
    return {**throw, "theta": _near_or_approaching(draw, nearest_float(best), HALF_PI)}


_PROJECTILE = (
    Stratum("typical", (), _throw),
    Stratum("tiny-drag", ("k",), lambda draw, has: _throw(draw, has, k=draw.magnitude(*tiny(draw)))),
    Stratum("huge-drag", ("k",), lambda draw, has: _throw(draw, has, k=draw.magnitude(4, 900))),
    Stratum("zero-drag", ("k",), lambda draw, has: _throw(draw, has, k=some_zero(draw, -5, 3))),
    Stratum("extreme", (), _throw_extreme),
    Stratum("range-ends", (), _throw_range_ends),
    Stratum("theta-near-0", ("theta",), lambda draw, has: _throw(draw, has, theta=abs(slight(draw)))),
    Stratum("theta-near-half-pi", ("theta",), _throw_upward),
    Stratum("near-landing", ("t",), _landing),
    Stratum("interval-ends", (), _throw_grid),
)

_BEST_ANGLE = (
    Stratum("typical", (), lambda draw, has: {"alpha": draw.magnitude(-4, 6)}),
    Stratum("tiny-drag", (), lambda draw, has: {"alpha": draw.magnitude(-1020, -4)}),
    Stratum("huge-drag", (), lambda draw, has: {"alpha": draw.magnitude(6, 1023)}),
    Stratum("alpha-near-1", (), lambda draw, has: {"alpha": step(1.0, draw.integer(-NEAR, NEAR))}),
    Stratum("interval-ends", (), lambda draw, has: {"alpha": grid_end(draw)}),
)

TABLES = {
    "projectile": _PROJECTILE,
    "projectile.best_angle": _BEST_ANGLE,
    "projectile.velocity": (
        *(stratum for stratum in _PROJECTILE if stratum.name != "huge-drag"),
        Stratum("huge-drag", ("k",), _throw_fading),
        Stratum("near-apex", (), _apex),
    ),
    "projectile.range_slope_theta": (*_PROJECTILE, Stratum("near-theta-max", (), _farthest)),
}
