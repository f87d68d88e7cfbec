"""Certain references: each public function from its printed equation, by interval arithmetic on the exact float inputs.

Nothing here uses the package's primitives, stable forms or emitted code. Implicit results (descent time, flight time,
best angle) are roots of the printed equations, found by Newton's method and then proved by a change of sign.
Every function takes its arguments as floats in SI units and radians, and returns a tuple of `Enclosure`.
"""

import math

from mpmath import libmp

from . import lambert_reference
from .enclosure import (
    CONTEXT,
    INFINITE,
    ZERO,
    Undecided,
    certain,
    decay,
    enclosure,
    exponential,
    newton,
    number,
    proved_root,
    sine_cosine,
    to_float,
)

_FLOAT_NEWTON_STEPS = 60


# --- chord -----------------------------------------------------------------------------------------------------------


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


# --- projectile ------------------------------------------------------------------------------------------------------


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
    larger = rise if rise._mpi_[0] == drop._mpi_[0] or rise > drop else drop
    return (enclosure(speed * cosine * reach), enclosure(rise - drop, larger))


def _first_flight_root(lift):
    """A first guess at the T > 0 with T - 1 + exp(-T) = lift (1 - exp(-T))."""
    size = to_float(lift)
    if not 1e-10 < size < 1e10:
        return lift + 1 if size > 1 else 2 * lift
    flight = min(2 * size, 1 + size)
    for _ in range(_FLOAT_NEWTON_STEPS):
        lost = -math.expm1(-flight)
        step = (flight - lost - size * lost) / (lost - size * (1 - lost))
        flight -= step
        if abs(step) < 1e-9 * flight:
            break
    return number(flight)


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


def _lost_between(flight):
    """1 - exp(-T) over an interval of T; it increases."""
    low, high = (CONTEXT.make_mpf((end, end)) for end in flight._mpi_)
    return CONTEXT.make_mpf((decay(low)[1]._mpi_[0], decay(high)[1]._mpi_[1]))


def _horizontal_range(theta, v, g, k):
    """x at impact: v cos(theta) (1 - exp(-T))/k; 2 v**2 sin(theta) cos(theta)/g without resistance."""
    if theta == 0:
        return (ZERO,)
    sine, cosine = sine_cosine(number(theta))
    speed = number(v)
    if k == 0:
        return (enclosure(2 * speed * speed * sine * cosine / number(g)),)
    return (enclosure(speed * cosine * _lost_between(_flight(sine, v, g, k)) / number(k)),)


def _stationarity(s):
    """1 + (s - 1) e**s, increasing in s > 0, and its derivative s e**s."""
    growth = exponential(s)
    return decay(s)[2] * growth, s * growth


def _first_stationary_root(alpha):
    """A first guess at the s > 0 with 1 + (s - 1) e**s = alpha**2."""
    if alpha < 1e-5:
        return number(alpha) * CONTEXT.sqrt(number(2))
    if alpha > 3:  # (s - 1) + log(s - 1) = 2 log(alpha) - 1, up to alpha**-2
        level = 2 * math.log(alpha) - 1
        root = level if level > 1 else 1.0
        for _ in range(_FLOAT_NEWTON_STEPS):
            root -= (root + math.log(root) - level) / (1 + 1 / root)
        return number(1 + root)
    root = min(math.sqrt(2) * alpha, 1 + alpha)
    for _ in range(_FLOAT_NEWTON_STEPS):
        lost = -math.expm1(-root)
        root -= ((root - lost) - alpha * alpha * (1 - lost)) / root
    return number(root)


def _best_angle(alpha):
    """theta_max with sin = alpha/(e**s - 1) where 1 + (s - 1) e**s = alpha**2: dR/dtheta = 0 in s = k t at impact."""
    if alpha == 0:
        target = CONTEXT.sqrt(number(1) / 2)
    else:
        square = number(alpha) * number(alpha)

        def balance(s):
            value, slope = _stationarity(s)
            return value - square, slope

        s = proved_root(lambda s: _stationarity(s)[0], square, newton(balance, _first_stationary_root(alpha)))
        fading = exponential(-s)
        target = number(alpha) * fading / _lost_between(s)
    middle = libmp.mpf_asin(target.mid._mpi_[0], CONTEXT.prec, libmp.round_nearest)
    angle = CONTEXT.make_mpf((middle, middle))
    return (enclosure(proved_root(lambda theta: sine_cosine(theta)[0], target, angle)),)


_EQUATIONS = {
    "chord.descent_time": _descent_time,
    "chord.distance": _distance,
    "chord.position": _chord_position,
    "chord.synchronous_circle": _synchronous_circle,
    "projectile.flight_time": _flight_time,
    "projectile.horizontal_range": _horizontal_range,
    "projectile.position": _position,
    "projectile.best_angle": _best_angle,
    "lambert.w0": lambert_reference.w0,
    "lambert.wm1": lambert_reference.wm1,
    "lambert.linear_exponential_roots": lambert_reference.linear_exponential_roots,
}


def reference(function, arguments):
    """Certain enclosures of the exact results of a public function at float inputs.

    Parameters
    ----------
    function : str
        Full name, such as ``"chord.descent_time"``.
    arguments : dict of str to float
        Every argument by its public name, finite and inside the function's domain; an absent force is 0.0.

    Returns
    -------
    tuple of Enclosure
        One for each output, of relative width below 2**-90 (projectile y: relative to its larger term);
        `INFINITE` for the descent time of a bead at rest, `ZERO` for its distance and position, `ABSENT` for a root
        that does not exist.

    Raises
    ------
    KeyError
        For a function without a reference.
    ArithmeticError
        If 65536 bits do not settle the result.
    """
    equation = _EQUATIONS[function]
    return certain(lambda: equation(**arguments))
