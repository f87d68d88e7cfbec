"""Both real branches of W, and their distance from -1 in x = -1 - log of minus the argument."""

import numpy as np

from ._elementary import exponential, log_from_excess, logarithm, minus_one
from ._kernel import admit, quiet, settle
from ._primitives import _lookup
from ._scaled import Scaled, add, constant, div, load, mul, neg, pair_add, plain, scale, select, sqrt, sub, two_sum
from ._tables import INVERSE_E, TABLES, E

_HUGE = 100  # exponent above which log(y) is nothing beside y
_NEAR = -0.26  # below it -e x is nearer 1 than sqrt(1/2)
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


def _above(x):
    """x + 1/e, exact but for the last rounding of a pair."""
    s, t = two_sum(x, INVERSE_E[0] + 0.0 * x)
    return Scaled(*pair_add(s, t, INVERSE_E[1], INVERSE_E[2]), np.zeros_like(s, dtype=np.int32))


def w0(x):
    """Principal branch of W, for x >= -1/e."""
    (x,), void = admit((x, "branch"))
    with quiet():
        great = x >= 1.0
        small = np.where(great, 0.5, x)
        argument = load(small)
        w = principal(argument, _above(small))
        gap = sub(w, mul(argument, exponential(neg(w))))  # for a Newton step
        value = sub(w, div(gap, add(constant(1.0), w)))
        if np.any(great):
            value = select(great, wright_omega(logarithm(load(np.where(great, x, 2.0)))), value)
    return np.where(x == 0.0, x, settle(value, void))


def wm1(x):
    """Lower branch of W, for -1/e <= x <= 0; a pole at 0."""
    (x,), void = admit((x, "lower branch"))
    pole = x == 0.0
    if np.any(pole):
        np.divide(-1.0, np.zeros(1))  # raises 'divide by zero'
    with quiet():
        x = np.where(pole, -0.25, x)
        near = x < _NEAR
        height = neg(mul(Scaled(E[0], E[1], np.int32(0)), _above(np.where(near, x, -0.3))))
        excess = select(near, neg(log_from_excess(height)), minus_one(neg(logarithm(load(-x)))))
        value = neg(add(constant(1.0), lower_offset(excess)))
    return np.where(pole, -np.inf, settle(value, void))
