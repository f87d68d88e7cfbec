"""What a user gets without this package: printed formulas by SymPy's lambdify; SciPy's functions and solvers."""

import warnings
from functools import cache, partial

import numpy as np
from scipy import special
from scipy.optimize import elementwise
from sympy import Symbol, lambdify

from .contestants import Contestant
from .printed import printed, symbols

_REAL = 1e-6  # a smaller share of an imaginary part is round-off of a real number


def _as_real(value, shape):
    """The real part of a result; NaN where it is truly complex."""
    value = np.broadcast_to(np.asarray(value), shape)
    if not np.iscomplexobj(value):
        return np.array(value, dtype=float)
    return np.where(np.abs(value.imag) <= _REAL * np.abs(value), value.real, np.nan)


class _Typed(Contestant):
    def results(self, case, arguments):
        shape = next(iter(arguments.values())).shape
        with np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = self.prepare(case, arguments)()
        return tuple(_as_real(one, shape) for one in (found if isinstance(found, (tuple, list)) else (found,)))


class Lambdified(_Typed):
    """The printed formulas, by `sympy.lambdify` with NumPy and SciPy."""

    name = "lambdify"

    def serves(self, case):
        return bool(printed(case.full_name, case.force_set))

    def prepare(self, case, arguments):
        return partial(_lambdified(case), *(arguments[name] for name in case.arguments))


@cache
def _lambdified(case):
    return lambdify([Symbol(s) for s in symbols(case)], printed(case.full_name, case.force_set), ["scipy", "numpy"])


def _fallen(t, gamma):
    """The share of g t^2/2 fallen in a time, times t^2: the bracket of (29) and (41), as printed."""
    return t / gamma - (1 - np.exp(-gamma * t)) / gamma**2


def _descent_time(theta, diameter, g, gamma, mu=0.0):
    """The root of (29) or (41) at the end of the chord, between the time without drag and its bound by W0 < 0."""
    pull = g * (np.cos(theta) - mu * np.sin(np.abs(theta)))
    length = diameter * np.cos(theta)
    free = np.sqrt(2 * length / pull)
    slowest = 1 / gamma + gamma * free**2 / 2
    return elementwise.find_root(
        lambda t, pull, length, gamma: pull * _fallen(t, gamma) - length, (free, slowest), args=(pull, length, gamma)
    ).x


def _flight_time(theta, v, g, k):
    """The root of y(t) = 0 but 0, between the apex without resistance and landing without it."""
    free = 2 * v * np.sin(theta) / g
    return elementwise.find_root(
        lambda t, up, g, k: (g + k * up) * (1 - np.exp(-k * t)) / k**2 - g * t / k,
        (free / 2, free),
        args=(v * np.sin(theta), g, k),
    ).x


def _horizontal_range(theta, v, g, k):
    return v * np.cos(theta) * (1 - np.exp(-k * _flight_time(theta, v, g, k))) / k


SCIPY = {
    ("chord.descent_time", "drag"): _descent_time,
    ("chord.descent_time", "friction_drag"): lambda theta, diameter, g, mu, gamma: _descent_time(
        theta, diameter, g, gamma, mu
    ),
    ("chord.max_angle", ""): lambda mu: np.arctan2(1.0, mu),
    ("projectile.flight_time", "drag"): _flight_time,
    ("projectile.horizontal_range", "drag"): _horizontal_range,
    ("lambert.w0", ""): special.lambertw,
    ("lambert.wm1", ""): lambda x: special.lambertw(x, -1),
    ("special.phi1m", ""): lambda x: special.exprel(-x),
    ("special.exp_minus", ""): lambda x: np.exp(-x),
    ("special.w0", ""): special.lambertw,
    ("special.wm1", ""): lambda x: special.lambertw(x, -1),
    ("special.sin", ""): np.sin,
    ("special.cos", ""): np.cos,
    ("special.arctan", ""): np.arctan,
}


class SciPy(_Typed):
    """SciPy's and NumPy's own functions; for implicit results SciPy's bracketing solver on the printed equations."""

    name = "SciPy"

    def serves(self, case):
        return (case.full_name, case.force_set) in SCIPY

    def prepare(self, case, arguments):
        return partial(SCIPY[case.full_name, case.force_set], *(arguments[name] for name in case.arguments))
