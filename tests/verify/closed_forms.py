"""The primitives in closed form, by mpmath's W: the proof of the approximations has no W and is tried against them."""

from mpmath import asin, atan, e, exp, expm1, lambertw, log, log1p, mp, sin, sqrt

GUARD_DIGITS = 50  # W of what is close to -1/e, and expm1 less its argument, lose up to 30


def _tau(p):
    return 1 + p * p / 2 + lambertw(-exp(-1 - p * p / 2)).real


def _sigma(p):
    return -1 - lambertw(-exp(-1 - p * p / 2), -1).real


def _flight_time(b):
    return 1 + b + lambertw(-(1 + b) * exp(-1 - b)).real


def _best_s(a):
    return 1 + lambertw((a * a - 1) / e).real


def _balance(b):
    T = _flight_time(b)
    return b * exp(-T) / (T - b)


CLOSED_FORMS = {
    "phi1m": lambda z: -expm1(-z) / z,
    "phi2m": lambda z: (z + expm1(-z)) / z**2,
    "descent_factor": lambda p: _tau(p) / p,
    "flight_factor": lambda b: _flight_time(b) / (2 * b),
    "range_factor": lambda b: -expm1(-_flight_time(b)) / (2 * b),
    "grown_loss": lambda b: -((1 + b) ** 2) * expm1(-_flight_time(b)) / (2 * b) * (1 - _balance(b)) / b,
    "grown_balance": lambda b: exp(b) * _balance(b),
    "best_sine": lambda a: a / expm1(_best_s(a)),
    "best_angle": lambda a: asin(a / expm1(_best_s(a))),
    "max_range_factor": lambda a: sqrt(1 - (1 + _best_s(a)) * exp(-_best_s(a))) / a,
    "w0_ratio": lambda q: exp(-lambertw(q * q - 1 / e).real),
    "rise_factor": lambda p: -expm1(-_tau(p)) / p,
    "fall_factor": lambda p: _sigma(p) / p,
    "wm1_branch": lambda q: -lambertw(q * q - 1 / e, -1).real,
    "wm1_middle": lambda m: -lambertw(-m, -1).real,
    "fall_log": lambda y: log1p(_sigma(sqrt(2 * exp(y)))),
    "log": log,
    "omega": lambda y: lambertw(exp(y)).real,
    "sine": sin,
    "arctangent": atan,
}
CLOSED_FORMS |= {f"{name}_tail": CLOSED_FORMS[name] for name in ("grown_loss", "grown_balance")}  # other equations


def closed_form(name, x):
    """The primitive at x > 0, to the working precision."""
    with mp.extradps(GUARD_DIGITS):
        value = CLOSED_FORMS[name](x)
    return +value
