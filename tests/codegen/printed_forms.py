"""References for the tests: the printed equations, evaluated by mpmath with digits enough for their cancellation."""

import math
from functools import wraps

from mpmath import mp, mpf

from galileo_sym.verify.reference import reference

_BITS = 260


def _precise(reference):
    """Run a reference with all its outer arithmetic at the base precision."""

    @wraps(reference)
    def run(*arguments, **named):
        with mp.workprec(_BITS):
            return reference(*arguments, **named)

    return run


def _spare(*numbers):
    """Bits that terms cancelling down to one of these numbers may cost."""
    return _BITS + sum(abs(int(mp.mag(x))) for x in numbers if x)


def _reduced_time(c):
    """z > 0 with z - 1 + exp(-z) = c."""
    if c > 500:
        return c + 1 - mp.exp(-c - 1)
    z = mp.sqrt(2 * c) if c < 1 else c + 1
    for _ in range(80):
        step = (z - 1 + mp.exp(-z) - c) / (1 - mp.exp(-z))
        z -= step
        if abs(step) < z * mpf(2) ** -200:
            return z
    raise ArithmeticError("Newton did not settle")


def _slope(theta, mu):
    return mp.cos(theta) - mu * mp.sin(abs(theta))


@_precise
def descent_time(theta, diameter, g, mu=0, gamma=0):
    theta, diameter, g, mu, gamma = map(mpf, (theta, diameter, g, mu, gamma))
    with mp.workprec(1500):
        n = _slope(theta, mu)
        if n <= 0:
            return mp.inf
        length = diameter * mp.cos(theta) / n
        c = length * gamma**2 / g
    with mp.workprec(_spare(c, c, c)):
        return _reduced_time(c) / gamma if gamma else mp.sqrt(2 * length / g)


def _travel(t, g, gamma):
    with mp.workprec(_spare(*[gamma * t] * 3)):
        if not gamma or not t:
            return g * t**2 / 2
        return g / gamma * t - g / gamma**2 * (1 - mp.exp(-gamma * t))


@_precise
def distance(t, theta, g, mu=0, gamma=0):
    t, theta, g, mu, gamma = map(mpf, (t, theta, g, mu, gamma))
    with mp.workprec(1500):
        n = max(_slope(theta, mu), mpf(0))
    return _travel(t, g, gamma) * n


@_precise
def chord_position(t, theta, g, mu=0, gamma=0):
    s = distance(t, theta, g, mu, gamma)
    return s * mp.sin(theta), s * mp.cos(theta)


@_precise
def synchronous_circle(t, g, mu=0, gamma=0):
    t, g, mu, gamma = map(mpf, (t, g, mu, gamma))
    half = _travel(t, g, gamma) / 2
    with mp.workprec(_spare(mu, mu)):
        return mu * half, half, mp.sqrt(1 + mu**2) * half


def _impact(b):
    """T > 0 with (1 + b)(1 - exp(-T)) = T."""
    if b > 500:
        return 1 + b
    T = 2 * b if b < 1 else 1 + b
    for _ in range(80):
        step = (T - (1 + b) * (1 - mp.exp(-T))) / (1 - (1 + b) * mp.exp(-T))
        T -= step
        if abs(step) < T * mpf(2) ** -200:
            return T
    raise ArithmeticError("Newton did not settle")


@_precise
def flight_time(theta, v, g, k=0):
    theta, v, g, k = map(mpf, (theta, v, g, k))
    rise = v * mp.sin(theta) / g
    with mp.workprec(_spare(*[k * rise] * 3)):
        rise = v * mp.sin(theta) / g
        return _impact(k * rise) / k if k and rise else 2 * rise


@_precise
def horizontal_range(theta, v, g, k=0):
    theta, v, g, k = map(mpf, (theta, v, g, k))
    time = flight_time(theta, v, g, k)
    with mp.workprec(_spare(*[k * time] * 3)):
        return v * mp.cos(theta) * ((1 - mp.exp(-k * time)) / k if k else time)


@_precise
def projectile_position(t, theta, v, g, k=0):
    """x, y, and the larger of the two terms of y."""
    t, theta, v, g, k = map(mpf, (t, theta, v, g, k))
    fall = _travel(t, g, k)
    with mp.workprec(_spare(*[k * t] * 3)):
        reach = v * ((1 - mp.exp(-k * t)) / k if k else t)
        rise = reach * mp.sin(theta)
        return reach * mp.cos(theta), rise - fall, max(rise, fall)


@_precise
def best_angle(alpha):
    alpha = mpf(alpha)
    if alpha == 0:
        return mp.pi / 4
    with mp.workprec(_spare(*[alpha] * 6)):
        if alpha == 1:
            return mp.asin(1 / (mp.e - 1))
        w = mp.lambertw((alpha**2 - 1) / mp.e).real
        return mp.asin(alpha * w / (alpha**2 - 1 - w))


@_precise
def w0(x):
    with mp.workprec(_spare(x)):
        return mp.lambertw(mpf(x)).real


@_precise
def wm1(x):
    with mp.workprec(_spare(x)):
        return mp.lambertw(mpf(x), -1).real


def _settled(step, w):
    """The limit of Newton steps."""
    for _ in range(200):
        change = step(w)
        w = max(w - change, w / 8)
        if abs(change) < w * mp.eps * 64:
            return w
    raise ArithmeticError("Newton did not settle")


def _root(w, b, a, d):
    t = (-b * d / a - w) / d
    return mpf(0) if abs(t * d) < mp.eps * 2**100 else t  # what is left of two equal terms


@_precise
def linear_exponential_roots(a, b, c, d):
    """Both by result (3), None where there is none; W from the logarithm of w e^w = Q: Q itself may be anything."""
    with mp.workprec(2 * _spare(a, b, c, d) + 200):
        a, b, c, d = map(mpf, (a, b, c, d))
        log_q = mp.log(abs(c * d / a)) - b * d / a
        if c * d / a > 0:
            start = mp.exp(log_q) if log_q < 0 else max(log_q, mpf(1) / 2)
            w = _settled(lambda w: (w + mp.log(w) - log_q) / (1 + 1 / w), start)
            return _root(w, b, a, d), None
        if log_q > -1:
            return None, None
        start = mp.exp(log_q) if log_q < -2 else mpf(1) / 2
        w = _settled(lambda w: (-w + mp.log(w) - log_q) / (1 / w - 1), start)
        far = _settled(lambda w: (w - mp.log(w) + log_q) / (1 - 1 / w), 1 - 2 * log_q)
        return _root(-w, b, a, d), _root(-far, b, a, d)


@_precise
def speed(t, theta, g, mu=0, gamma=0):
    t, theta, g, mu, gamma = map(mpf, (t, theta, g, mu, gamma))
    with mp.workprec(1500):
        n = max(_slope(theta, mu), mpf(0))
    with mp.workprec(_spare(*[gamma * t] * 2)):
        return n * g * ((1 - mp.exp(-gamma * t)) / gamma if gamma else t)


@_precise
def max_angle(mu):
    return mp.atan(1 / mpf(mu))


@_precise
def velocity(t, theta, v, g, k=0):
    """vx, vy, and the larger of the two terms of vy."""
    t, theta, v, g, k = map(mpf, (t, theta, v, g, k))
    left = v * mp.exp(-k * t)
    lost = speed(t, 0, g, 0, k)
    risen = left * mp.sin(theta)
    return left * mp.cos(theta), risen - lost, max(risen, lost)


def _range(theta, v, g, k):
    """The range to the working precision; k > 0."""
    return v * mp.cos(theta) * (1 - mp.exp(-_impact(k * v * mp.sin(theta) / g))) / k


_STEP = mpf(2) ** -60  # relative; the error of a central difference goes with its square


@_precise
def range_slope_theta(theta, v, g, k=0):
    """The slope by a central difference, and the larger of its two terms."""
    theta, v, g, k = map(mpf, (theta, v, g, k))
    if k == 0 or theta == 0:
        unit = 2 * v**2 / g
        return unit * mp.cos(2 * theta), unit * max(mp.cos(theta) ** 2, mp.sin(theta) ** 2)
    with mp.workprec(_spare(*[k * v * mp.sin(theta) / g] * 5)):
        h = theta * _STEP
        slope = (_range(theta + h, v, g, k) - _range(theta - h, v, g, k)) / (2 * h)
        given = _range(theta, v, g, k) * mp.tan(theta)
        return slope, max(given, slope + given)


@_precise
def range_slope_k(theta, v, g, k=0):
    theta, v, g, k = map(mpf, (theta, v, g, k))
    if k == 0:
        return -8 * v**3 * mp.sin(theta) ** 2 * mp.cos(theta) / (3 * g**2)
    with mp.workprec(_spare(*[k * v * mp.sin(theta) / g] * 6)):
        h = k * _STEP
        return (_range(theta, v, g, k + h) - _range(theta, v, g, k - h)) / (2 * h)


@_precise
def max_range(v, g, k=0):
    v, g, k = map(mpf, (v, g, k))
    return horizontal_range(best_angle(k * v / g), v, g, k)


def ulps(value, exact, scale=None, bits=53):
    """Error of a float in units in the last place of the exact value, or of another one; None stands for no value."""
    if exact is None:
        return 0.0 if math.isnan(value) else math.inf
    scale = abs(exact if scale is None else scale)
    if not math.isfinite(value):
        return 0.0 if value == float(exact) else math.inf
    if scale == 0:
        return 0.0 if value == exact else math.inf
    tiny = {53: -1074, 24: -149}[bits]
    with mp.workprec(_BITS):
        unit = mpf(2) ** max(mp.mag(scale) - bits, tiny)
        return float(abs(mpf(float(value)) - exact) / unit)


def launch_angles(r, v, g, k=0.0):
    """Enclosed by a change of sign in the impact time: a search for the angles would take seconds."""
    enclosures = reference("projectile.launch_angles", {"r": r, "v": v, "g": g, "k": k})
    return tuple(mp.ldexp(*map(int, e.ball.mid().man_exp())) for e in enclosures)
