"""The strata of the chord's functions."""

import math

from .sampling import HALF_PI, critical_angle, critical_friction, grid_end, step
from .stratum import NEAR, Stratum, grid_angle, slight, some_zero, tiny


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
    return _chord(draw, has, mu=mu, theta=draw.sign() * step(critical_angle(mu), -draw.integer(0, NEAR)))


def _chord_approaching(draw, has):
    """Angles at every binary distance below theta_max, where the cancellation in cos - mu sin sets in."""
    mu = draw.magnitude(-30, 30) if draw.chance(0.5) else draw.magnitude(-4, 1)
    return _chord(draw, has, mu=mu, theta=draw.sign() * critical_angle(mu) * (1.0 - draw.magnitude(-47, -4)))


def _chord_at_rest(draw, has):
    mu = draw.magnitude(-4, 1)
    above = step(critical_angle(mu), draw.integer(1, NEAR))
    theta = above if draw.chance(0.5) else draw.uniform(above, HALF_PI)
    return _chord(draw, has, mu=mu, theta=draw.sign() * theta)


def _chord_steep(draw, has):
    """Nearly horizontal chords; friction, where there is any, is below its critical value."""
    theta = step(HALF_PI, -draw.integer(0, NEAR)) if draw.chance(0.5) else HALF_PI - draw.magnitude(-50, -8)
    return _chord(draw, has, theta=draw.sign() * theta, mu=draw.uniform(0.0, 0.99) * critical_friction(theta))


def _chord_grid(draw, has):
    shift = draw.integer(-3, 3)
    angle = grid_angle(draw, 51 if "mu" in has else 201)
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
    Stratum("tiny-drag", ("gamma",), lambda draw, has: _chord(draw, has, gamma=draw.magnitude(*tiny(draw)))),
    Stratum("huge-drag", ("gamma",), lambda draw, has: _chord(draw, has, gamma=draw.magnitude(4, 900))),
    Stratum("zero-drag", ("gamma",), lambda draw, has: _chord(draw, has, gamma=some_zero(draw, -4, 3))),
    Stratum("zero-friction", ("mu",), lambda draw, has: _chord(draw, has, mu=some_zero(draw, -4, 1))),
    Stratum("extreme", (), _chord_extreme),
    Stratum("range-ends", (), _chord_range_ends),
    Stratum("near-theta-max", ("mu", "theta"), _chord_critical),
    Stratum("approaching-theta-max", ("mu", "theta"), _chord_approaching),
    Stratum("at-rest", ("mu", "theta"), _chord_at_rest),
    Stratum("theta-near-0", ("theta",), lambda draw, has: _chord(draw, has, theta=slight(draw))),
    Stratum("theta-near-half-pi", ("theta",), _chord_steep),
    Stratum("interval-ends", (), _chord_grid),
)

_MAX_ANGLE = (
    Stratum("typical", (), lambda draw, has: {"mu": draw.magnitude(-4, 4)}),
    Stratum("tiny-friction", (), lambda draw, has: {"mu": draw.magnitude(-1074, -4)}),
    Stratum("huge-friction", (), lambda draw, has: {"mu": draw.magnitude(4, 1023)}),
    Stratum("zero-friction", (), lambda draw, has: {"mu": some_zero(draw, -4, 1)}),
    Stratum("interval-ends", (), lambda draw, has: {"mu": grid_end(draw)}),
)

TABLES = {"chord": _CHORD, "chord.max_angle": _MAX_ANGLE}
