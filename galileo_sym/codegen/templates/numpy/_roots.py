"""Real roots of a t + b + c exp(d t) = 0 by both branches of W, in T = d t, beta = b d/a and kappa = c d/a.

T + beta + kappa exp(T) = 0 has the roots T = -beta - w, w exp(w) = kappa exp(-beta). That argument is never formed
where it is large or close to -1/e: log|kappa| - beta and its distance from -1 take its place. Two Newton steps in pairs
repair what -beta - w cancels, in S + T + kappa (exp(T) - 1) with S = (b + c) d/a where T is small.
"""

from typing import NamedTuple

import numpy as np

from ._branches import lower_offset, principal, principal_offset, wright_omega
from ._elementary import FAR, exponential, growth, log_from_excess, logarithm, reduce_exponent
from ._excess import excess
from ._kernel import admit, quiet, raise_invalid, settle
from ._scaled import ZERO_EXPONENT, Scaled, add, constant, div, load, mul, neg, plain, select, sub
from ._tables import INVERSE_E

_UNSURE = 2.0**-20  # share of its terms below which their difference is taken in integers
_DOUBLE = 2.0**-35  # distance of w from -1 below which a Newton step would lose more than it gains
_LOOKED_UP = -2.0  # log|kappa| - beta below which w comes from its argument, whatever the sign of kappa
_CLOSE = 0.25  # distance of -b/c from 1 below which its logarithm is that of 1 - (b + c)/c
_STEPS = 2


class Equation(NamedTuple):
    """beta, kappa, |kappa|, log|kappa|, S, beta - 1, and whether kappa < 0."""

    beta: Scaled
    kappa: Scaled
    size: Scaled
    log: Scaled
    total: Scaled
    beta_less: Scaled
    negative: np.ndarray


def _load(x):
    """A double of either sign as a scaled pair."""
    size = load(np.abs(x))
    return Scaled(np.copysign(size.hi, x), size.lo, size.e)


def _size(a):
    """Absolute value."""
    sign = np.copysign(1.0, a.hi)
    return Scaled(sign * a.hi, sign * a.lo, a.e)


def _equation(a, b, c, d):
    rate = div(d, a)
    beta, kappa = mul(b, rate), mul(c, rate)
    size = _size(kappa)
    beta_less = div(sub(mul(b, d), a), a)  # b d is exact: nothing is lost where b d/a is near 1
    return Equation(beta, kappa, size, logarithm(size), mul(add(b, c), rate), beta_less, kappa.hi < 0.0)


def _excess(eq, a, b, c, d):
    """beta - 1 - log(-kappa), >= 0 where there are roots for kappa < 0."""
    value = sub(eq.beta_less, eq.log)
    largest = add(_size(eq.beta_less), _size(eq.log))
    unsure = eq.negative & (largest.e < 18) & ~(sub(_size(value), mul(constant(_UNSURE), largest)).hi > 0.0)
    if np.any(unsure):
        value = Scaled(*(np.array(part) for part in value))
        exact = excess(a[unsure], b[unsure], c[unsure], d[unsure])
        for part, found in zip(value, exact, strict=True):
            part[unsure] = found
    return value


def _small(eq, y):
    """W0(kappa exp(-beta)) where that is small."""
    x, _ = plain(eq.beta)
    gone = x >= FAR
    zero = Scaled(0.0, 0.0, np.int32(ZERO_EXPONENT))
    argument = mul(eq.kappa, exponential(neg(select(gone | (x <= -FAR), constant(1.0), eq.beta))))
    argument = select(gone | (y.hi >= 0.0), zero, argument)
    e_inverse = Scaled(INVERSE_E[0], INVERSE_E[1], np.int32(0))
    return principal(argument, add(argument, e_inverse))


def _far_start(eq, w):
    """T = log(|w|/|kappa|), for |w| >= 2."""
    return logarithm(div(_size(w), eq.size))


def _newton(eq, t):
    """One step for T + beta + kappa exp(T) = 0."""
    k, x, x_lo = reduce_exponent(t)
    rate = Scaled(*growth(x, x_lo), np.zeros_like(x, dtype=np.int32))
    small = k == 0.0
    change = mul(select(small, t, Scaled(x, x_lo, np.int32(0))), rate)
    power = add(constant(1.0), change)
    power = mul(eq.kappa, Scaled(power.hi, power.lo, power.e + k.astype(np.int32)))
    near = add(add(eq.total, t), mul(eq.kappa, change))
    rest = select(small, near, add(add(t, eq.beta), power))
    slope = add(constant(1.0), power)._replace(lo=0.0)  # a double will do
    return sub(t, div(rest, slope))


def _polished(eq, t, double):
    """Newton steps, but not where exp(T) is 0 or infinite, nor beside a double root."""
    kept = (np.abs(plain(t)[0]) >= FAR) | double
    for _ in range(_STEPS):
        t = select(kept, t, _newton(eq, select(kept, constant(0.25), t)))
    return t


def _principal_root(eq, distance):
    """T by W0, at a distance >= 0 of log|kappa| - beta from -1 where kappa < 0."""
    y = sub(eq.log, eq.beta)
    large = (y.hi >= 0.0) & ~eq.negative
    near = eq.negative & (add(y, constant(-_LOOKED_UP)).hi >= 0.0)
    w = select(large, wright_omega(select(large, y, constant(1.0))), _small(eq, y))
    less = principal_offset(select(near, distance, constant(1.0)))
    start = select(near, sub(neg(eq.beta_less), less), sub(neg(eq.beta), w))
    start = select(plain(w)[0] >= 2.0, _far_start(eq, w), start)
    return _polished(eq, start, near & (plain(less)[0] < _DOUBLE))


def _lower_root(eq, distance):
    """T by W-1, where kappa < 0."""
    more = lower_offset(distance)
    w = add(constant(1.0), more)  # -W-1
    start = select(plain(w)[0] >= 2.0, _far_start(eq, w), add(neg(eq.beta_less), more))
    return _polished(eq, start, plain(more)[0] < _DOUBLE)


def _roots(a, b, c, d):
    """T by W0 and by W-1, and whether there are such roots, for nonzero a, c, d."""
    A, B, C, D = map(_load, (a, b, c, d))
    eq = _equation(A, B, C, D)
    distance = _excess(eq, a, b, c, d)
    two = eq.negative & (distance.hi >= 0.0)
    distance = select(two, distance, constant(1.0))
    slope = np.copysign(1.0, a) * add(A, mul(C, D)).hi  # sign of 1 + kappa, exactly
    at_0 = (b == -c) & np.isfinite(b)
    zero = Scaled(0.0, 0.0, np.int32(ZERO_EXPONENT))
    T0 = select(at_0 & (slope >= 0.0), zero, _principal_root(eq, distance))
    Tm1 = select(at_0 & (slope <= 0.0), zero, _lower_root(eq, distance))
    return div(T0, D), div(Tm1, D), ~eq.negative | two, two


def _degenerate(a, b, c, d):
    """The root where a, c or d is 0, and whether there is one."""
    B, C = _load(b), _load(c)
    total, divisor = add(B, C), _load(np.where(c == 0.0, 1.0, c))
    linear = neg(div(total, _load(np.where(a == 0.0, 1.0, a))))
    ratio = neg(div(B, divisor))
    positive = ratio.hi > 0.0
    near = np.abs(plain(ratio)[0] - 1.0) < _CLOSE
    excess_of_ratio = select(near, neg(div(total, divisor)), constant(0.0))
    value = select(near, log_from_excess(excess_of_ratio), logarithm(select(positive, ratio, constant(2.0))))
    crossing = div(value, _load(np.where(d == 0.0, 1.0, d)))
    return select(a == 0.0, crossing, linear), (a != 0.0) | positive


def linear_exponential_roots(a, b, c, d):
    """Roots by W0 and W-1 of a t + b + c exp(d t) = 0; NaN where there is none."""
    arguments, void = admit(*((x, "real") for x in (a, b, c, d)))
    a, b, c, d = np.broadcast_arrays(*arguments)
    two_infinite = sum(np.isinf(x).astype(int) for x in (a, b, c, d)) > 1
    undecided = two_infinite | ((a == 0.0) & ((c == 0.0) | (d == 0.0)))
    if np.any(undecided):
        raise_invalid()
    void = void | undecided
    with quiet():
        plainly = (a == 0.0) | (c == 0.0) | (d == 0.0)
        t0, tm1, first, second = _roots(*(np.where(plainly | void, 1.0, x) for x in (a, b, c, d)))
        if np.any(plainly):
            t, there = _degenerate(a, b, c, d)
            t0, first, second = select(plainly, t, t0), np.where(plainly, there, first), second & ~plainly
    return settle(t0, void | ~first), settle(tm1, void | ~second)
