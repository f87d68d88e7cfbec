"""The printed equations of the chord paper at exact inputs, in ball arithmetic."""

import math

from .enclosure import (
    INFINITE,
    ZERO,
    Undecided,
    arctangent,
    decay,
    enclosure,
    float_newton,
    newton,
    number,
    proved_root,
    sine_cosine,
    square_root,
)


def _chord_angle(theta, mu):
    """Enclosures of sin|theta|, cos theta and cos theta - mu sin|theta|; the last is None for a bead at rest."""
    sine, cosine = sine_cosine(number(abs(theta)))
    driving = cosine - number(mu) * sine
    if driving < 0:
        return sine, cosine, None
    if not driving > 0:
        raise Undecided("the sign of cos|theta| - mu sin|theta| needs more bits")
    return sine, cosine, driving


def _fall(t, g, gamma):
    """The bracket g/gamma t - g/gamma**2 (1 - exp(-gamma t)) of (29); g t**2/2 without drag."""
    if gamma == 0:
        return number(g) * number(t) * number(t) / 2
    rate = number(gamma)
    return number(g) * decay(rate * number(t))[2] / (rate * rate)


def _first_lag_root(target):
    """A first guess at the tau > 0 with tau - 1 + exp(-tau) = target, good to some 1e-8."""
    size = float(target)
    if not 1e-10 < size < 1e10:
        return target + 1 if size > 1 else square_root(2 * target)

    def step(tau):
        lost = -math.expm1(-tau)
        return (tau - lost - size) / lost

    return number(float_newton(step, math.sqrt(2 * size) if size < 1 else size + 1))


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
        return (enclosure(square_root(2 * length)),)
    rate = number(gamma)
    target = rate * rate * length

    def balance(tau):
        _, lost, lag = decay(tau)
        return lag - target, lost

    near = newton(balance, _first_lag_root(target))
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


def _max_angle(mu):
    """(13): the angle with tangent 1/mu."""
    return (enclosure(arctangent(1 / number(mu)) if mu else number.pi() / 2),)


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
    return (enclosure(slope * depth), enclosure(depth), enclosure(square_root(1 + slope * slope) * depth))


EQUATIONS = {
    "chord.descent_time": _descent_time,
    "chord.distance": _distance,
    "chord.speed": _speed,
    "chord.max_angle": _max_angle,
    "chord.position": _chord_position,
    "chord.synchronous_circle": _synchronous_circle,
}
