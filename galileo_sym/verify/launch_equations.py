"""Certain references of the launch angles: the impact times that reach a range, and the elevations that belong to them.

With T = k t at the impact, the printed equations are sin(theta) = (T/(1 - exp(-T)) - 1)/alpha, alpha = k v/g, and
k r/v = cos(theta) (1 - exp(-T)). The square of the range rises with T up to its maximum and falls from there on, so a
rise through (k r/v)**2 encloses the low shot and a fall the high one.
"""

from flint import ctx

from .enclosure import (
    ZERO,
    Undecided,
    arctangent,
    decay,
    enclosure,
    increasing,
    number,
    proved_root,
    square_root,
)
from .projectile_equations import near_best_time

_STEPS = 200
_STEEP = 2.0**40  # conditions beyond which an error is measured against what the arguments' own roundings do


def _square(time, lift):
    """(k r/v)**2 at an impact time."""
    _, lost, lag = decay(time)
    height = lag / lift
    return (lost - height) * (lost + height)


def _derivatives(time, lift):
    """(k r/v)**2 at an impact time and its first two derivatives, each over 2."""
    fading, lost, lag = decay(time)
    weight = 1 / (lift * lift)
    value = (lost * lost - lag * lag * weight) / 2
    return value, lost * (fading - lag * weight), fading * (fading - lost - lag * weight) - lost * lost * weight


def _near(lift, pull, best, low):
    """A close approximation (no proof) of the impact time of the low or the high shot.

    From the time of the largest range, `best`, steps to the root of the parabola with the same value and derivatives,
    which settle fast also where the roots run together; from the time of a shot that does not fall where that leads
    astray.
    """
    target = pull * pull / 2
    bottom, top = (-(-pull).log1p(), best) if low else (best, 2 + 2 * lift)
    settled = number(2) ** (-2 * ctx.prec // 5)  # the next error goes with the third power
    x = best
    for _ in range(_STEPS):
        value, slope, curvature = _derivatives(x, lift)
        missing = target - value
        root = square_root(abs(slope * slope + 2 * missing * curvature))
        step = (2 * missing / (slope + root if low else slope - root)).mid()
        if abs(step) < settled * x:
            return (x + step).mid()
        if (missing > 0) == low:
            bottom = x
        else:
            top = x
        x = (x + step).mid()
        if not bottom < x < top:
            x = bottom.mid() if x is not bottom and low else ((bottom + top) / 2).mid()
    raise Undecided("the steps to the impact did not settle")


def _impact(lift, pull, best, low):
    """Enclosure of the impact time of the low or the high shot, with lift = k v/g and pull = k r/v."""
    return proved_root(lambda time: _square(time, lift), pull * pull, _near(lift, pull, best, low), falling=not low)


def _with_resistance(r, v, g, k):
    lift, pull = number(k) * number(v) / number(g), number(k) * number(r) / number(v)
    best, angles = near_best_time(lift), []
    for low in (True, False):
        time = _impact(lift, pull, best, low)
        angle = arctangent(increasing(lambda time: decay(time)[2], time) / (lift * pull))
        angles.append(enclosure(angle, _unit(angle, time.lower(), lift, pull)))
    return tuple(angles)


def _unit(angle, time, lift, pull):
    """What errors are measured against where the angle follows the range over 2**40 times: that share of its change."""
    fading, lost, lag = decay(time)
    slope = fading - lag / (lift * lift)
    of_tangent = pull * pull / (slope * lag) - 1  # by the logarithms of both
    share = abs(of_tangent * lag * pull / (lost * lost * lift * angle))
    return angle * share / _STEEP if share > _STEEP else None


def _without_resistance(r, v, g):
    """sin(2 theta) = g r/v**2."""
    most, taken = number(v) * number(v), number(g) * number(r)
    if most == taken:  # products of two doubles are exact
        return (enclosure(arctangent(number(1))),) * 2
    sine = taken / most
    rest = (1 - sine) * (1 + sine)
    if not rest > 0:
        raise Undecided("whether the range is beyond the largest needs more bits")
    cosine = square_root(rest)
    return enclosure(arctangent(sine / (1 + cosine))), enclosure(arctangent((1 + cosine) / sine))


def _launch_angles(r, v, g, k):
    """Both elevations at which the range is r; r below the largest range, as a real number.

    Raises
    ------
    Undecided
        If the bits do not suffice; above the largest range none do.
    """
    if r == 0:
        return ZERO, enclosure(number.pi() / 2)
    return _with_resistance(r, v, g, k) if k else _without_resistance(r, v, g)


EQUATIONS = {"projectile.launch_angles": _launch_angles}
