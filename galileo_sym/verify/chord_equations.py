"""The printed equations of the chord paper at exact inputs, in interval arithmetic."""

import math

from mpmath import libmp

from .enclosure import (
    CONTEXT,
    INFINITE,
    ZERO,
    Undecided,
    decay,
    enclosure,
    newton,
    number,
    proved_root,
    sine_cosine,
    to_float,
)

_FLOAT_NEWTON_STEPS = 60


def _chord_angle(theta, mu):
    """Enclosures of sin|theta|, cos theta and cos theta - mu sin|theta|; the last is None for a bead at rest."""
    sine, cosine = sine_cosine(number(abs(theta)))
    driving = cosine - number(mu) * sine
    low, high = driving._mpi_
    if libmp.mpf_sign(high) < 0:
        return sine, cosine, None
    if libmp.mpf_sign(low) <= 0:
        raise Undecided("the sign of cos|theta| - mu sin|theta| needs more bits")
    return sine, cosine, driving


def _fall(t, g, gamma):
    """The bracket g/gamma t - g/gamma**2 (1 - exp(-gamma t)) of (29); g t**2/2 without drag."""
    if gamma == 0:
        return number(g) * number(t) * number(t) / 2
    rate = number(gamma)
    return number(g) * decay(rate * number(t))[2] / (rate * rate)


def _lag(tau):
    """tau - 1 + exp(-tau), increasing, and its derivative."""
    _, lost, lag = decay(tau)
    return lag, lost


def _first_lag_root(target):
    """A first guess at the tau > 0 with tau - 1 + exp(-tau) = target, good to some 1e-8."""
    size = to_float(target)
    if not 1e-10 < size < 1e10:
        return target + 1 if size > 1 else CONTEXT.sqrt(2 * target)
    tau = math.sqrt(2 * size) if size < 1 else size + 1
    for _ in range(_FLOAT_NEWTON_STEPS):
        lost = -math.expm1(-tau)
        step = (tau - lost - size) / lost
        tau -= step
        if abs(step) < 1e-9 * tau:
            break
    return number(tau)


def _descent_time(theta, diameter, g, mu, gamma):
    """(42) solved for t_AB: D = (g/gamma t - g/gamma**2 (1 - exp(-gamma t))) (1 - mu tan|theta|).

    (17) and (4) where gamma = 0, infinite for a bead at rest.
    """
    _, cosine, driving = _chord_angle(theta, mu)
    if driving is None:
        return (INFINITE,)
    slope = driving / cosine if mu else number(1)  # 1 - mu tan|theta|
    length = number(diameter) / (number(g) * slope)
    if gamma == 0:
        return (enclosure(CONTEXT.sqrt(2 * length)),)
    rate = number(gamma)
    target = rate * rate * length
    near = newton(lambda tau: (_lag(tau)[0] - target, _lag(tau)[1]), _first_lag_root(target))
    return (enclosure(proved_root(lambda tau: decay(tau)[2], target, near) / rate),)


def _distance(t, theta, g, mu, gamma):
    """(41), which is (1), (15), (29) where forces are absent; 0 at rest."""
    driving = _chord_angle(theta, mu)[2]
    return (ZERO,) if driving is None else (enclosure(_fall(t, g, gamma) * driving),)


def _speed(t, theta, g, mu, gamma):
    """The derivative of (41): g/gamma (1 - exp(-gamma t)) (cos - mu sin), g t (...) without drag; 0 at rest."""
    driving = _chord_angle(theta, mu)[2]
    if driving is None:
        return (ZERO,)
    time = number(t) if gamma == 0 else decay(number(gamma) * number(t))[1] / number(gamma)
    return (enclosure(number(g) * time * driving),)


def _tangent(angle):
    """The tangent, which increases below pi/2."""
    sine, cosine = sine_cosine(angle)
    return sine / cosine


def _arctangent(tangent):
    """The angle below pi/2 with a given tangent, 0 < tangent <= 1."""
    middle = libmp.mpf_atan(tangent.mid._mpi_[0], CONTEXT.prec, libmp.round_nearest)
    return proved_root(_tangent, tangent, CONTEXT.make_mpf((middle, middle)))


def _max_angle(mu):
    """(13): the angle with tangent 1/mu; below mu = 1 its complement is the one found."""
    if mu >= 1:
        return (enclosure(_arctangent(1 / number(mu))),)
    right = CONTEXT.pi / 2
    return (enclosure(right if mu == 0 else right - _arctangent(number(mu))),)


def _chord_position(t, theta, g, mu, gamma):
    """x = s sin(theta), y = s cos(theta) with s of (41)."""
    sine, cosine, driving = _chord_angle(theta, mu)
    if driving is None:
        return (ZERO, ZERO)
    along = _fall(t, g, gamma) * driving
    return (enclosure(along * (-sine if theta < 0 else sine)), enclosure(along * cosine))


def _synchronous_circle(t, g, mu, gamma):
    """X, Y, R of (45)-(47), which are (10), (22), (32) where forces are absent."""
    depth = _fall(t, g, gamma) / 2
    slope = number(mu)
    return (enclosure(slope * depth), enclosure(depth), enclosure(CONTEXT.sqrt(1 + slope * slope) * depth))


EQUATIONS = {
    "chord.descent_time": _descent_time,
    "chord.distance": _distance,
    "chord.speed": _speed,
    "chord.max_angle": _max_angle,
    "chord.position": _chord_position,
    "chord.synchronous_circle": _synchronous_circle,
}
