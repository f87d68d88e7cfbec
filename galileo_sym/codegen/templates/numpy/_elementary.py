"""Exponential and logarithm of scaled pairs as scaled pairs, about 2**-96 relative: series, no table."""

import numpy as np

from ._scaled import (
    Scaled,
    add,
    constant,
    div,
    fast_two_sum,
    mul,
    pair_add,
    pair_mul,
    plain,
    scale,
    select,
    two_prod,
    two_sum,
)  # fmt: skip
from ._tables import ATANH, GROWTH, LOG_2

FAR = 2.0**16  # beyond it an exponential is 0 or infinite beside any quotient of doubles
_HALVINGS = 8
_ATANH_PAIRS = 11  # terms that need two doubles
_GROWTH_PAIRS = 5
_TINY = 2.0**-60  # its square is nothing beside 1, and might underflow
_ROOT_HALF = 0.7071067811865476
_LOG_OF_INFINITE = 2**19  # exponent: infinite, yet below any infinite argument


def _horner(rows, pairs, x, x_lo):
    """Series in x + x_lo: in doubles as long as the terms are small, then in pairs."""
    tail = rows[-1][0] + 0.0 * x
    for row in rows[-2 : pairs - 1 : -1]:
        tail = tail * x + row[0]
    hi, lo = tail, 0.0 * x
    for row in rows[pairs - 1 :: -1]:
        hi, lo = pair_add(row[0], row[1], *pair_mul(hi, lo, x, x_lo))
    return hi, lo


def growth(x, x_lo):
    """(exp(x) - 1)/x for a pair with |x| <= log(2)/2: at x/2**8 by its series, then doubled 8 times."""
    x, x_lo = x * 2.0**-_HALVINGS, x_lo * 2.0**-_HALVINGS
    hi, lo = _horner(GROWTH, _GROWTH_PAIRS, x, x_lo)
    for i in range(_HALVINGS):
        half, half_lo = x * 2.0 ** (i - 1), x_lo * 2.0 ** (i - 1)
        hi, lo = pair_add(hi, lo, *pair_mul(*pair_mul(hi, lo, hi, lo), half, half_lo))
    return hi, lo


def reduce_exponent(t):
    """Return k and the pair r with t = k log(2) + r, |r| <= log(2)/2, for |t| <= 2**16."""
    x, x_lo = plain(t)
    k = np.rint(x * (1.0 / LOG_2[0]))
    x, x_lo = pair_add(x, x_lo, -k * LOG_2[0], 0.0)
    p, q = two_prod(-k, LOG_2[1])
    x, x_lo = pair_add(x, x_lo, p, q - k * LOG_2[2])
    return k, x, x_lo


def exponential(t):
    """exp(t) for |t| <= 2**16."""
    k, x, x_lo = reduce_exponent(t)
    hi, lo = pair_add(1.0, 0.0, *pair_mul(x, x_lo, *growth(x, x_lo)))
    return Scaled(hi, lo, k.astype(np.int32))


def log_from_excess(f):
    """log(1 + f) for a scaled pair with sqrt(1/2) <= 1 + f <= sqrt(2): 2 atanh(f/(2 + f))."""
    z = div(f, add(constant(2.0), f))
    x, x_lo = plain(z)
    x, x_lo = (np.where(np.abs(x) < _TINY, 0.0, part) for part in (x, x_lo))
    series = _horner(ATANH, _ATANH_PAIRS, *pair_mul(x, x_lo, x, x_lo))
    return scale(mul(z, Scaled(*series, np.int32(0))), 1)


def logarithm(a):
    """log(a) for a > 0; infinite, but below any infinite argument, where a is an infinite argument or its inverse."""
    m, shift = np.frexp(a.hi)
    low = m < _ROOT_HALF
    shift = shift - low
    k = np.clip(a.e + shift, -(2**18), 2**18)
    excess = two_sum(np.ldexp(a.hi, -shift), -1.0 + 0.0 * m)
    f = Scaled(*fast_two_sum(excess[0], excess[1] + np.ldexp(a.lo, -shift)), np.int32(0))
    near = log_from_excess(f)
    x = k.astype(np.float64)
    p, q = two_prod(x, LOG_2[1] + 0.0 * x)
    hi, lo = pair_add(x * LOG_2[0], 0.0, p, q + x * LOG_2[2])
    finite = select(k == 0, near, add(Scaled(hi, lo, np.zeros_like(k)), near))
    infinite = Scaled(np.copysign(0.5, x), 0.0 * x, np.full_like(k, _LOG_OF_INFINITE))
    return select(np.abs(k) == 2**18, infinite, finite)
