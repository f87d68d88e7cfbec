"""The printed equations of the projectile paper at exact inputs, in ball arithmetic."""

import math

from .enclosure import (
    ZERO,
    arcsine,
    decay,
    enclosure,
    exponential,
    float_newton,
    logarithm,
    newton,
    number,
    proved_root,
    sine_cosine,
    square_root,
)


def _larger(one, other):
    """Of two balls of positive numbers, the one that is larger; either if they overlap."""
    return other if one < other else one


def _position(t, theta, v, g, k):
    """x and y of linear resistance, y ordered as v sin(theta) (1 - e)/k - g (kt - 1 + e)/k**2 with e = exp(-kt).

    y is measured against the larger of its two terms.
    """
    sine, cosine = sine_cosine(number(theta))
    time, speed, weight = number(t), number(v), number(g)
    if k == 0:
        reach, drop = time, weight * time * time / 2
    else:
        rate = number(k)
        _, lost, lag = decay(rate * time)
        reach, drop = lost / rate, weight * lag / (rate * rate)
    rise = speed * sine * reach
    return (enclosure(speed * cosine * reach), enclosure(rise - drop, _larger(rise, drop)))


def _velocity(t, theta, v, g, k):
    """The derivatives of x and y; vy is measured against the larger of its two terms."""
    sine, cosine = sine_cosine(number(theta))
    time, speed, weight = number(t), number(v), number(g)
    fading, lost, _ = decay(number(k) * time)
    fallen = weight * (time if k == 0 else lost / number(k))
    risen = speed * sine * fading
    return (enclosure(speed * cosine * fading), enclosure(risen - fallen, _larger(risen, fallen)))


def _first_flight_root(lift):
    """A first guess at the T > 0 with T - 1 + exp(-T) = lift (1 - exp(-T))."""
    size = float(lift)
    if not 1e-10 < size < 1e10:
        return lift + 1 if size > 1 else 2 * lift

    def step(flight):
        lost = -math.expm1(-flight)
        return (flight - lost - size * lost) / (lost - size * (1 - lost))

    return number(float_newton(step, min(2 * size, 1 + size)))


def _flight(sine, v, g, k):
    """T = k t at impact, the positive root of -T + 1 + B - exp(-T) (1 + B) = 0 with B = (k v/g) sin(theta).

    Sorted by B the equation reads (T - 1 + exp(-T))/(1 - exp(-T)) = B, whose left side increases with T.
    """
    lift = number(k) * number(v) * sine / number(g)

    def impact(flight):
        fading, lost, lag = decay(flight)
        return lag - lift * lost, lost - lift * fading

    def left_side(flight):
        _, lost, lag = decay(flight)
        return lag / lost

    return proved_root(left_side, lift, newton(impact, _first_flight_root(lift)))


def _flight_time(theta, v, g, k):
    """The positive root of y(t) = 0; 2 v sin(theta)/g without resistance, 0 at theta = 0."""
    if theta == 0:
        return (ZERO,)
    sine, _ = sine_cosine(number(theta))
    if k == 0:
        return (enclosure(2 * number(v) * sine / number(g)),)
    return (enclosure(_flight(sine, v, g, k) / number(k)),)


def _horizontal_range(theta, v, g, k):
    """x at impact: v cos(theta) (1 - exp(-T))/k; 2 v**2 sin(theta) cos(theta)/g without resistance."""
    if theta == 0:
        return (ZERO,)
    sine, cosine = sine_cosine(number(theta))
    speed = number(v)
    if k == 0:
        return (enclosure(2 * speed * speed * sine * cosine / number(g)),)
    return (enclosure(speed * cosine * decay(_flight(sine, v, g, k))[1] / number(k)),)


def _flight_brackets(sine, v, g, k):
    """B = (k v/g) sin(theta), and exp(-T), 1 - exp(-T) and 1 - (1 + B) exp(-T) at the impact."""
    lift, flight = number(k) * number(v) * sine / number(g), _flight(sine, v, g, k)
    fading, lost, _ = decay(flight)
    return lift, fading, lost, lost - lift * fading


def _range_slope_theta(theta, v, g, k):
    """The range and T = (1 + B) (1 - exp(-T)) differentiated; measured against the larger of its two terms.

    At theta = 0, where this is 0/0, and without resistance: 2 v**2/g (cos**2 - sin**2).
    """
    sine, cosine = sine_cosine(number(theta))
    speed, weight = number(v), number(g)
    if theta == 0 or k == 0:
        unit = 2 * speed * speed / weight
        gained, given = unit * cosine * cosine, unit * sine * sine
    else:
        _, fading, lost, rate = _flight_brackets(sine, v, g, k)
        gained = speed * speed * cosine * cosine * fading * lost / (weight * rate)
        given = speed * sine * lost / number(k)
    return (enclosure(gained - given, _larger(gained, given)),)


def _range_slope_k(theta, v, g, k):
    """The same for dT/dk: -v cos(theta) (1 - exp(-T))/k**2 (1 - B exp(-T)/(1 - (1 + B) exp(-T))).

    Without resistance its limit, -8/3 v**3 sin**2 cos/g**2.
    """
    if theta == 0:
        return (ZERO,)
    sine, cosine = sine_cosine(number(theta))
    speed, weight = number(v), number(g)
    if k == 0:
        return (enclosure(-8 * speed * speed * speed * sine * sine * cosine / (3 * weight * weight)),)
    lift, fading, lost, rate = _flight_brackets(sine, v, g, k)
    drag = number(k)
    return (enclosure(-speed * cosine * lost * (1 - lift * fading / rate) / (drag * drag)),)


def _stationarity(s):
    """1 + (s - 1) e**s, increasing in s > 0, and its derivative s e**s."""
    growth = exponential(s)
    return decay(s)[2] * growth, s * growth


def _first_stationary_root(alpha):
    """A first guess at the s > 0 with 1 + (s - 1) e**s = alpha**2."""
    size = float(alpha)
    if size < 1e-5:
        return alpha * square_root(number(2))
    if size > 3:  # (s - 1) + log(s - 1) = 2 log(alpha) - 1, up to alpha**-2
        level = 2 * float(logarithm(alpha)) - 1
        root = float_newton(lambda x: (x + math.log(x) - level) / (1 + 1 / x), max(level, 1.0))
        return number(1 + root)
    return number(
        float_newton(lambda s: (s + math.expm1(-s) - size * size * math.exp(-s)) / s, min(2**0.5 * size, 1 + size))
    )


def near_best_time(alpha):
    """A close approximation of s = k t at the impact for the angle of Theorem 3: 1 + (s - 1) e**s = alpha**2."""
    square = alpha * alpha

    def balance(s):
        value, slope = _stationarity(s)
        return value - square, slope

    return newton(balance, _first_stationary_root(alpha))


def _at_best_angle(alpha):
    """sin(theta_max) = alpha/(e**s - 1), where 1 + (s - 1) e**s = alpha**2, and 1 - e**-s: dR/dtheta = 0 in s = k t."""
    s = proved_root(lambda s: _stationarity(s)[0], alpha * alpha, near_best_time(alpha))
    lost = decay(s)[1]
    return alpha * exponential(-s) / lost, lost


def _max_range(v, g, k):
    """x at impact for the angle of Theorem 3: v cos(theta_max) (1 - e**-s)/k; v**2/g without resistance."""
    speed = number(v)
    if k == 0:
        return (enclosure(speed * speed / number(g)),)
    sine, lost = _at_best_angle(number(k) * speed / number(g))
    return (enclosure(speed * square_root(1 - sine * sine) * lost / number(k)),)


def _best_angle(alpha):
    """theta_max of Theorem 3."""
    return (enclosure(arcsine(square_root(number(0.5)) if alpha == 0 else _at_best_angle(number(alpha))[0])),)


EQUATIONS = {
    "projectile.flight_time": _flight_time,
    "projectile.horizontal_range": _horizontal_range,
    "projectile.position": _position,
    "projectile.velocity": _velocity,
    "projectile.range_slope_theta": _range_slope_theta,
    "projectile.range_slope_k": _range_slope_k,
    "projectile.max_range": _max_range,
    "projectile.best_angle": _best_angle,
}
