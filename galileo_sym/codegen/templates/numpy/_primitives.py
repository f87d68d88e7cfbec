"""The primitives on scaled pairs: a table near 0, the leading terms beyond it."""

import numpy as np

from ._scaled import Scaled, add, constant, div, fast_two_sum, load, mul, pair_add, plain, scale, select, sub
from ._tables import LOG_2, PER_BINADE, TABLES


def _lookup(table, x, x_lo):
    """Evaluate a table at x + x_lo, 0 <= x <= x_max: the value as a pair."""
    coefficients = table["coefficients"]
    m, e = np.frexp(1.0 + x)
    i = (e - 1) * PER_BINADE + np.floor((m - 0.5) * (2 * PER_BINADE)).astype(np.int32)
    i = np.minimum(i, coefficients.shape[1] - 1)
    d = (x - table["centres"][i]) + x_lo
    tail = coefficients[-1][i]
    for row in coefficients[-2:1:-1]:
        tail = tail * d + row[i]
    return fast_two_sum(coefficients[0][i], coefficients[1][i] + tail * d)


def _far(table, x):
    """Leading terms 2**shift x**power (1 + correction x**-order)."""
    inverse = div(constant(1.0), x)
    u, _ = plain(inverse)
    small = table["correction"] * (u * u if table["order"] == 2 else u)
    factor = Scaled(*fast_two_sum(np.ones_like(small), small), np.int32(0))
    lead = {-1: inverse, 1: x}.get(table["power"])
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


def _log(a):
    """Natural logarithm of a >= 1 (one double, normalised), as a pair."""
    k = np.minimum(a.e - 1, 1030).astype(np.float64)
    hi, lo = _lookup(TABLES["log1p"], 2.0 * a.hi - 1.0, 0.0)
    return pair_add(*fast_two_sum(k * LOG_2[0], k * LOG_2[1]), hi, lo)


def _small_arcsine(a):
    """Arcsine of 0 <= a < 0.011."""
    u, _ = plain(a)
    q = u * u
    rest = q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0))))
    return mul(a, Scaled(*fast_two_sum(np.ones_like(rest), rest), np.int32(0)))


def _best_elevation_far(a):
    """From w + log(w) = log(a**2 - 1) - 1, w = s - 1, and sin = w/(a - (1 + w)/a)."""
    u, _ = plain(div(constant(1.0), a))
    q = u * u
    hi, lo = _log(a)
    hi, lo = pair_add(hi + hi, lo + lo, -1.0, -q * (1.0 + 0.5 * q))
    w = Scaled(*_lookup(TABLES["wright_omega"], hi, lo), np.int32(0))
    return _small_arcsine(div(w, sub(a, div(add(constant(1.0), w), a))))


def best_elevation(a):
    """Angle of greatest range, of a scaled pair >= 0 (one double, normalised)."""
    table = TABLES["best_angle"]
    u, _ = plain(a)
    far = u >= table["x_max"]
    hi, lo = _lookup(table, np.where(far, 0.0, u), 0.0)
    near = Scaled(hi, lo, np.zeros_like(hi, dtype=np.int32))
    return (
        select(far, _best_elevation_far(select(far, a, load(np.full_like(u, 2048.0)))), near) if np.any(far) else near
    )
