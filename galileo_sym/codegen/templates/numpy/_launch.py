"""Launch angles by the roots of range**2 = F(Z), Z the square of the time of flight; F is concave, so steps are safe.

A step goes to the root of the parabola that osculates F (Cauchy's method, of third order, exact without resistance and
beside the maximum). From the starts below three steps leave what rounding leaves: below 2**-66 of the time beside the
maximum, 2**-90 elsewhere.
"""

from typing import NamedTuple

import numpy as np

from ._elevation import elevation, right_angle
from ._primitives import best_time, flight_factor, log
from ._scaled import ZERO, Scaled, add, constant, div, load, mul, neg, plain, rounded, scale, select, sqrt, sub

_STEPS = 3
_TWO_THIRDS = 2.0 / 3.0


class Balance(NamedTuple):
    """F at a time of flight z, its first derivative by Z and minus its second; rise/range = tan(theta), d rise/dZ."""

    square: Scaled
    slope: Scaled
    bend: Scaled
    rise: Scaled
    lean: Scaled


class Angles(NamedTuple):
    """The two angles that reach a range."""

    low: Scaled
    high: Scaled


def _root(a):
    """Square root, 0 of what is not positive."""
    some = a.hi > 0.0
    return select(some, sqrt(select(some, a, constant(1.0))), ZERO)


def _step(at, level, low):
    """From Z to the lower or upper root of the osculating parabola, or to its vertex where that stays below level."""
    gap = scale(sub(at.square, level), 1)
    square = add(mul(at.slope, at.slope), mul(at.bend, gap))
    turn = _root(square)
    across = add(at.slope, turn) if low else sub(at.slope, turn)
    through = (square.hi > 0.0) & (across.hi != 0.0)
    return div(select(through, neg(gap), at.slope), select(through, across, at.bend))


def _moved(z, step):
    """Time of flight after a step of its square, which is at most divided by 8."""
    share, least = add(constant(1.0), div(step, mul(z, z))), constant(0.125)
    return mul(z, sqrt(select(sub(share, least).hi > 0.0, share, least)))


def _starts(top, z_best, alpha, level):
    """Times of flight, low and high, within 12 percent of the distance to the best one.

    Both are exact without resistance. The low one is quadratic in eta = sqrt(1 - level/top) as to (z phi1)**2, the high
    one as to z**2, with the slope at the maximum and the value at eta = 1 right.
    """
    one = constant(1.0)
    share = div(level, top.square)
    eta = _root(div(sub(top.square, level), top.square))
    fading, lost = top.rise, scale(top.lean, 1)  # exp(-s) and phi1(-s), s = alpha z_best
    bend = add(mul(lost, lost), mul(div(alpha, z_best), mul(lost, fading)))
    width = scale(sqrt(div(top.square, bend)), 1)
    best = mul(z_best, z_best)
    reach = mul(best, mul(lost, lost))
    near = mul(mul(width, lost), fading)
    far = sub(reach, near)
    chord = sqrt(mul(div(share, add(one, eta)), add(reach, mul(far, eta))))
    gone = mul(alpha, chord)  # 1 - exp(-s) at the start
    spare = add(mul(fading, sub(constant(2.0), fading)), mul(mul(alpha, alpha), mul(eta, add(near, mul(far, eta)))))
    u = plain(gone)[0]
    small = u < 2.0**-10
    age = log(rounded(div(add(one, gone), spare)))[0] / np.where(small, 1.0, u)
    low = mul(chord, load(np.where(small, 1.0 + u * (0.5 + u / 3.0), age)))
    end = scale(flight_factor(alpha), 1)
    growth = sub(sqrt(div(one, fading)), one)
    bent, bent_end = (_bent(p) for p in (mul(eta, growth), growth))
    rest = sub(sub(mul(end, end), best), mul(width, bent_end))
    high = sqrt(add(best, mul(eta, add(mul(width, bent), mul(rest, eta)))))
    return low, high


def _bent(p):
    """1/sqrt(1 + 2p/3 + p**2)."""
    one = constant(1.0)
    return div(one, sqrt(add(one, mul(p, add(constant(_TWO_THIRDS), p)))))


def launch(balance, reach, alpha):
    """Return both angles, low and high, of a range.

    Parameters
    ----------
    balance : callable
        From a time of flight in units of v/g, and alpha, to its `Balance`.
    reach : Scaled
        The range in units of v**2/g, 0 <= reach < that of the best angle.
    alpha : Scaled
        k v/g >= 0.
    """
    grounded = reach.hi == 0.0
    some = select(grounded, div(constant(0.25), add(constant(1.0), alpha)), reach)
    level = mul(some, some)
    z_best = best_time(alpha)
    top = balance(z_best, alpha)
    angles = []
    for low, start in zip((True, False), _starts(top, z_best, alpha, level), strict=True):
        z = start
        for _ in range(_STEPS - 1):
            z = _moved(z, _step(balance(z, alpha), level, low))
        at = balance(z, alpha)
        angles.append(elevation(add(at.rise, mul(_step(at, level, low), at.lean)), some))
    ends = ZERO, right_angle()
    return Angles(*(select(grounded, end, angle) for end, angle in zip(ends, angles, strict=True)))
