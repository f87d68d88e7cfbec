"""The primitives on scaled pairs: a table near 0, the leading terms beyond it."""

import numpy as np

from ._scaled import (
    LIMIT,
    Scaled,
    add,
    constant,
    div,
    fast_two_sum,
    load,
    mul,
    pair_add,
    plain,
    scale,
    select,
    sqrt,
    sub,
    two_prod,
    two_sum,
)
from ._tables import INVERSE_E, LOG_2, PER_BINADE, TABLES

_GONE = 2.0**17  # exp(-z) of larger z is 0 times any finite number,
_SMALL = -(2**19)  # but not times an infinite one
_VANISHED = -(2**22)  # exp(-z) of infinite z


def _lookup(table, x, x_lo):
    """Evaluate a table at x + x_lo, 0 <= x + x_lo <= x_max but for rounding: the value as a pair."""
    coefficients = table["coefficients"]
    m, e = np.frexp(1.0 + x)
    i = (e - 1) * PER_BINADE + np.floor((m - 0.5) * (2 * PER_BINADE)).astype(np.int32)
    i = np.clip(i, 0, coefficients.shape[1] - 1)
    d, d_lo = two_sum(x - table["centres"][i], x_lo)
    tail = coefficients[-1][i]
    for row in coefficients[-2:3:-1]:
        tail = tail * d + row[i]
    slope, slope_lo = two_sum(coefficients[2][i], tail * d)
    rise, rise_lo = two_prod(slope, d)
    value, rest = two_sum(coefficients[0][i], rise)
    slope_lo = slope_lo + coefficients[3][i]
    return fast_two_sum(value, rest + (coefficients[1][i] + (rise_lo + (slope_lo * d + slope * d_lo))))


def _far(table, x):
    """Leading terms 2**shift x**power (1 + correction x**-order)."""
    inverse = div(constant(1.0), x)
    u, _ = plain(inverse)
    small = table["correction"] * (u * u if table["order"] == 2 else u)
    factor = Scaled(*fast_two_sum(np.ones_like(small), small), np.int32(0))
    lead = mul(inverse, inverse) if table["power"] == -2 else {-1: inverse, 1: x}.get(table["power"])
    return scale(factor if lead is None else mul(lead, factor), table["shift"])


def _primitive(name):
    table = TABLES[name]

    def evaluate(x):
        u, u_lo = plain(x)
        far = u >= table["x_max"]
        hi, lo = _lookup(table, np.where(far, 0.0, u), np.where(far, 0.0, u_lo))
        near = Scaled(hi, lo, np.zeros_like(hi, dtype=np.int32))
        return select(far, _far(table, x), near) if np.any(far) else near

    evaluate.__name__ = evaluate.__qualname__ = name
    evaluate.__doc__ = f"{table['doc']}, of a scaled pair >= 0."
    return evaluate


phi1m = _primitive("phi1m")
phi2m = _primitive("phi2m")
descent_factor = _primitive("descent_factor")
flight_factor = _primitive("flight_factor")
range_factor = _primitive("range_factor")
range_loss = _primitive("range_loss")
acot = _primitive("acot")


def phi0m(z):
    """exp(-z), of a scaled pair >= 0: 2**-n times a table at the rest that n log(2) leaves of z."""
    u, u_lo = plain(z)
    gone = u >= _GONE
    u, u_lo = np.where(gone, 0.0, u), np.where(gone, 0.0, u_lo)
    n = np.floor(u / LOG_2[0])
    r, r_lo = pair_add(*two_sum(u - n * LOG_2[0], -n * LOG_2[1]), u_lo, -n * LOG_2[2])
    hi, lo = _lookup(TABLES["phi0m"], r, r_lo)
    below = np.where(z.e > LIMIT, _VANISHED, _SMALL)
    return Scaled(hi, lo, np.where(gone, below, -n).astype(np.int32))


def range_balance(b):
    """b exp(-T)/(T - b), T = (1 + b)(1 - exp(-T)), of a scaled pair >= 0: exp(-b) times what grows like b/e."""
    table = TABLES["grown_balance"]
    u, u_lo = plain(b)
    far = u >= table["x_max"]
    hi, lo = _lookup(table, np.where(far, 0.0, u), np.where(far, 0.0, u_lo))
    near = Scaled(hi, lo, np.zeros_like(hi, dtype=np.int32))
    return mul(phi0m(b), select(far, mul(b, Scaled(*INVERSE_E[:2], np.int32(0))), near))


def log(a):
    """Natural logarithm of a >= 1, as a pair."""
    m, e = np.frexp(a.hi)
    k = np.minimum(a.e + e - 1, 1030).astype(np.float64)
    hi, lo = _lookup(TABLES["log1p"], 2.0 * m - 1.0, np.ldexp(a.lo, 1 - e))
    return pair_add(*fast_two_sum(k * LOG_2[0], k * LOG_2[1]), hi, lo)


def _small_arcsine(a):
    """Arcsine of 0 <= a < 0.011."""
    u, _ = plain(a)
    q = u * u
    rest = q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0))))
    return mul(a, Scaled(*fast_two_sum(np.ones_like(rest), rest), np.int32(0)))


def _excess_far(a):
    """w = s - 1 for large a, from w + log(w) = log(a**2 - 1) - 1."""
    u, _ = plain(div(constant(1.0), a))
    q = u * u
    hi, lo = log(a)
    hi, lo = pair_add(hi + hi, lo + lo, -1.0, -q * (1.0 + 0.5 * q))
    return Scaled(*_lookup(TABLES["wright_omega"], hi, lo), np.int32(0))


def _best_elevation_far(a):
    """From sin = w/(a - (1 + w)/a)."""
    w = _excess_far(a)
    return _small_arcsine(div(w, sub(a, div(add(constant(1.0), w), a))))


def _max_range_factor_far(a):
    """From (1 + s) exp(-s) = w (2 + w)/(a**2 - 1)."""
    w = _excess_far(a)
    lost = div(mul(w, add(constant(2.0), w)), sub(mul(a, a), constant(1.0)))
    return div(sqrt(sub(constant(1.0), lost)), a)


def _best_time_far(a):
    """From s = 1 + w."""
    return div(add(constant(1.0), _excess_far(a)), a)


def _near_and_far(table, a, beyond):
    """A table of a scaled pair >= 0, and a function for what lies beyond it."""
    u, u_lo = plain(a)
    far = u >= table["x_max"]
    hi, lo = _lookup(table, np.where(far, 0.0, u), np.where(far, 0.0, u_lo))
    near = Scaled(hi, lo, np.zeros_like(hi, dtype=np.int32))
    return select(far, beyond(select(far, a, load(np.full_like(u, 2048.0)))), near) if np.any(far) else near


def best_elevation(a):
    """Angle of greatest range, of a scaled pair >= 0."""
    return _near_and_far(TABLES["best_angle"], a, _best_elevation_far)


def best_time(a):
    """Time of flight at the angle of greatest range in units of v/g, of a scaled pair >= 0."""
    return _near_and_far(TABLES["best_time"], a, _best_time_far)


def max_range_factor(a):
    """sqrt(1 - (1 + s) exp(-s))/a, 1 + (s - 1) exp(s) = a**2, of a scaled pair >= 0."""
    return _near_and_far(TABLES["max_range_factor"], a, _max_range_factor_far)
