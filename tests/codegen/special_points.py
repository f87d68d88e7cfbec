"""Independent references of the primitives, and arguments to try them at."""

import numpy as np
from mpmath import mp, mpf

from galileo_sym.codegen.pairs import PAIRS


# Closed forms by Lambert W, as far from the code under test as can be; the precision doubles until two agree.
def _flight(b):
    y = 1 + b
    return y + mp.lambertw(-y * mp.exp(-y)).real


def _descent(p):
    return 1 + p * p / 2 + mp.lambertw(-mp.exp(-1 - p * p / 2)).real


def _best(a):
    return 1 + mp.lambertw((a * a - 1) / mp.e).real


def _offset(branch):
    return lambda x: 1 + mp.lambertw(-mp.exp(-1 - x), branch).real


def _grown_balance(b):
    y = 1 + b
    beyond = 1 + mp.lambertw(-y * mp.exp(-y)).real  # T - b
    return b * mp.exp(-beyond) / beyond


CLOSED = {
    "phi1m": lambda z: -mp.expm1(-z) / z,
    "phi2m": lambda z: (z + mp.expm1(-z)) / z**2,
    "descent_factor": lambda p: _descent(p) / p,
    "flight_factor": lambda b: _flight(b) / (2 * b),
    "range_factor": lambda b: -mp.expm1(-_flight(b)) / (2 * b),
    "best_sine": lambda a: a / mp.expm1(_best(a)),
    "best_angle": lambda a: mp.asin(a / mp.expm1(_best(a))),
    "max_range_factor": lambda a: mp.sqrt(1 - (1 + _best(a)) * mp.exp(-_best(a))) / a,
    "w0_offset": _offset(0),
    "wm1_offset": _offset(-1),
    "w0": lambda x: mp.lambertw(x).real,
    "wm1": lambda x: mp.lambertw(x, -1).real,
    "exp_minus": lambda z: mp.exp(-z),
    "sin": mp.sin,
    "cos": mp.cos,
    "arctan": mp.atan,
    "acot": mp.acot,
    "range_loss": lambda b: -mp.expm1(-_flight(b)) / (2 * b) * (1 - mp.exp(-b) * _grown_balance(b)) / b,
    "grown_balance": _grown_balance,
    "wright_omega": lambda y: mp.lambertw(mp.exp(y)).real,
}
ITSELF = "the argument, its sign included"
LIMITS = {  # at +0 and -0, and at infinity
    "phi1m": (1.0, 0.0),
    "phi2m": (0.5, 0.0),
    "descent_factor": (1.0, np.inf),
    "flight_factor": (1.0, 0.5),
    "range_factor": (1.0, 0.0),
    "best_sine": (np.sqrt(0.5), 0.0),
    "best_angle": (np.pi / 4, 0.0),
    "max_range_factor": (1.0, 0.0),
    "w0_offset": (ITSELF, 1.0),
    "wm1_offset": (0.0, -np.inf),
    "w0": (ITSELF, np.inf),
    "wm1": (-np.inf, np.nan),
    "exp_minus": (1.0, 0.0),
    "sin": (ITSELF, np.nan),
    "cos": (1.0, np.nan),
    "arctan": (ITSELF, np.pi / 2),
    "acot": (np.pi / 2, 0.0),
    "range_loss": (4 / 3, 0.0),
    "grown_balance": (1.0, np.inf),
    "wright_omega": (0.5671432904097838, np.nan),
}
ODD_OR_EVEN = {"sin": -1.0, "cos": 1.0, "arctan": -1.0}


def reference(name, x, x_lo=0.0):
    """The value at x + x_lo to 40 digits."""
    previous, digits = None, 60 + 3 * max(0, int(-np.log10(abs(x))))  # what cancels at small arguments
    while True:
        with mp.workdps(digits):
            value = CLOSED[name](mpf(float(x)) + float(x_lo))
        if previous is not None and abs(value - previous) <= abs(value) * mpf(10) ** -40:
            return value
        previous, digits = value, 2 * digits
        assert digits < 10000


def points(name, count, seed=1):
    """Arguments of all sizes in the domain, and on both sides of every end of a piece."""
    kernel, rng = PAIRS[name], np.random.default_rng(seed)
    lower, upper = kernel.domain
    thresholds = np.array([v for v in kernel.thresholds if np.isfinite(v)])
    spread = 10.0 ** rng.uniform(-12, min(4, np.log10(max(abs(thresholds))) + 1), count)
    far = 10.0 ** rng.uniform(-323, 308, count // 4)
    ends = np.array([5e-324, *thresholds, *(2.0**e * (1 + s / 4) for e in range(-8, 9) for s in range(4))])
    x = np.concatenate([spread, far, ends, np.nextafter(ends, 0), np.nextafter(ends, 1e9)])
    if np.isfinite(upper):
        x = np.concatenate([x, upper - spread, upper * rng.uniform(0, 1, count)])
    if lower < 0:
        x = np.concatenate([x, -x[::3], max(lower, -10.0) * rng.uniform(0, 1, count), max(lower, -10.0) + spread])
    return x[(x >= lower) & (x <= upper) & (x != 0)]
