"""Both real branches of W of pairs, and their distance from -1 in x = -1 - log of minus the argument."""

import numpy as np

from ._elementary import logarithm
from ._primitives import _lookup
from ._scaled import Scaled, add, constant, div, mul, plain, scale, select, sqrt, sub
from ._tables import TABLES, E

_HUGE = 100  # exponent above which log(y) is nothing beside y
_CLOSE_BY = 2.0**-12  # below it s - log(1 + s) cancels more than a Newton step gains


def at(name, x):
    """A table at a scaled pair >= 0, or at its far end."""
    u, u_lo = plain(x)
    beyond = u >= TABLES[name]["x_max"]
    hi, lo = _lookup(TABLES[name], np.where(beyond, TABLES[name]["x_max"], u), np.where(beyond, 0.0, u_lo))
    return Scaled(hi, lo, np.zeros_like(hi, dtype=np.int32)), beyond


def wright_omega(y):
    """w with w + log(w) = y >= 0: a table, or y - log(y), and a Newton step."""
    w, beyond = at("wright_omega", y)
    if np.any(beyond):
        w = select(beyond, sub(y, logarithm(select(beyond, y, constant(2048.0)))), w)
    huge = y.e > _HUGE
    w = select(huge, constant(1.0), w)
    step = div(mul(w, sub(add(constant(1.0), y), logarithm(w))), add(constant(1.0), w))
    return select(huge, y, step)


def principal(x, above):
    """W0(x) = x exp(-W0(x)) for a scaled pair x in [-1/e, 1], above = x + 1/e: regular in sqrt(2 e above)."""
    factor, _ = at("principal", sqrt(scale(mul(Scaled(E[0], E[1], np.int32(0)), above), 1)))
    return mul(x, factor)


def _of_root(name, x):
    """p = sqrt(2 x), p times a table at it, and where that ends; 0 at 0."""
    zero = x.hi == 0.0
    p = sqrt(scale(select(zero, constant(1.0), x), 1))
    factor, beyond = at(name, p)
    return p, select(zero, constant(0.0), mul(p, factor)), beyond & ~zero


def principal_offset(x):
    """1 + W0(-exp(-1 - x)), x >= 0."""
    _, near, beyond = _of_root("w0_offset", x)
    return select(beyond, constant(1.0), near)


def lower_offset(x):
    """-1 - W-1(-exp(-1 - x)), x >= 0: s with s - log(1 + s) = x, by a table or x + log(x), and a Newton step."""
    p, s, beyond = _of_root("wm1_offset", x)
    if np.any(beyond):
        s = select(beyond, add(x, logarithm(select(beyond, x, constant(2048.0)))), s)
    huge = x.e > _HUGE
    kept = huge | (x.hi == 0.0) | (plain(p)[0] < _CLOSE_BY)
    start = select(kept, constant(1.0), s)
    gap = sub(sub(start, logarithm(add(constant(1.0), start))), x)
    step = sub(start, div(mul(gap, add(constant(1.0), start)), start))
    return select(huge, x, select(kept, s, step))
