"""Certain references of W and of the roots of a t + b + c exp(d t) = 0, by interval arithmetic on their equations.

Three forms of w exp(w) = x, each with a left side that increases: w + log(w) = log(x) for w > 0, and, at the distance
-1 - log(-x) of -x from 1/e, 1 + (s - 1) exp(s) = 1 + e x with s = 1 + W0 and s - log(1 + s) = -1 - log(-x) with
s = -1 - W-1.
"""

import math
from fractions import Fraction

from mpmath import libmp

from .enclosure import (
    ABSENT,
    CONTEXT,
    ZERO,
    Undecided,
    enclosure,
    exponential,
    logarithm,
    newton,
    number,
    proved_root,
    to_float,
)

_STEPS = 60
_NEAR = 1e-6  # below it the first guess is the leading term of the power series
_FAR = 1e15  # above it that of the asymptotic one


def _root(value_and_slope, target, guess):
    """The proved root of an increasing function."""

    def balance(s):
        value, slope = value_and_slope(s)
        return value - target, slope

    return proved_root(lambda s: value_and_slope(s)[0], target, newton(balance, guess))


def _spared(function):
    """A function of s that vanishes like s**2, evaluated with the bits that its subtraction costs."""

    def evaluate(s):
        raw = s._mpi_[0]
        spare = 2 * max(0, -(raw[2] + raw[3]))
        CONTEXT.prec += spare
        try:
            return function(s)
        finally:
            CONTEXT.prec -= spare

    return evaluate


def _by_logarithm(y):
    """W0 > 0 from w + log(w) = y >= 1."""
    size = to_float(y)
    if size > _FAR:
        guess = y
    else:
        w = 1.0
        for _ in range(_STEPS):
            w = max(w - (w + math.log(w) - size) / (1 + 1 / w), 0.5)
        guess = number(w)
    return _root(lambda w: (w + logarithm(w), 1 + 1 / w), y, guess)


def _principal_offset(level):
    """s = 1 + W0 > 0 from 1 + (s - 1) exp(s) = 1 + e x = level, at most 1 + e**2."""
    size = to_float(level)
    guess = CONTEXT.sqrt(2 * level)
    if size > _NEAR:
        s = min(math.sqrt(2 * size), 1 + math.log1p(size))
        for _ in range(_STEPS):
            s -= (1 + (s - 1) * math.exp(s) - size) / (s * math.exp(s))
        guess = number(s)
    return _root(_spared(lambda s: (1 + (s - 1) * exponential(s), s * exponential(s))), level, guess)


def _lower_offset(distance):
    """s = -1 - W-1 > 0 from s - log(1 + s) = distance > 0."""
    size = to_float(distance)
    guess = distance
    if size < _NEAR:
        guess = CONTEXT.sqrt(2 * distance)
    elif size < _FAR:
        s = size + math.sqrt(2 * size)
        for _ in range(_STEPS):
            s -= (s - math.log1p(s) - size) * (1 + s) / s
        guess = number(s)
    return _root(_spared(lambda s: (s - logarithm(1 + s), s / (1 + s))), distance, guess)


def _is_positive(x):
    """Whether an interval holds positive numbers only; raises where its sign is open."""
    low, high = x._mpi_
    if libmp.mpf_sign(low) != libmp.mpf_sign(high) or libmp.mpf_sign(low) == 0:
        raise Undecided("a sign needs more bits")
    return libmp.mpf_sign(low) > 0


def w0(x):
    """W0(x), the w >= -1 of result (1)."""
    if x == 0:
        return (ZERO,)
    if x > math.e:
        return (enclosure(_by_logarithm(logarithm(number(x)))),)
    level = 1 + exponential(number(1)) * number(x)
    _is_positive(level)
    return (enclosure(_principal_offset(level) - 1),)


def wm1(x):
    """W-1(x), the w <= -1 of result (1)."""
    distance = -1 - logarithm(number(-x))
    _is_positive(distance)
    return (enclosure(-1 - _lower_offset(distance)),)


def _quotient(value):
    """A rational number."""
    return number(value.numerator) / number(value.denominator)


def _degenerate(a, b, c, d):
    """The roots where a, c or d is 0."""
    if a != 0:
        root = -(b + c) / a
        return (ZERO if root == 0 else enclosure(_quotient(root)), ABSENT)
    ratio = -b / c
    if ratio <= 0:
        return (ABSENT, ABSENT)
    return (ZERO if ratio == 1 else enclosure(logarithm(_quotient(ratio)) / _quotient(d)), ABSENT)


def linear_exponential_roots(a, b, c, d):
    """Result (3) and the root by W-1: t = -b/a - W/d, w exp(w) = (c d/a) exp(-b d/a)."""
    a, b, c, d = map(Fraction, (a, b, c, d))
    if 0 in (a, c, d):
        return _degenerate(a, b, c, d)
    beta, kappa = b * d / a, c * d / a
    if beta == 1 and kappa == -1:
        return (ZERO, ZERO)  # the only double root: log(-kappa) is irrational for any other rational kappa
    exponent = logarithm(_quotient(abs(kappa))) - _quotient(beta)  # of |x|
    zero_is_a_root = b == -c
    if kappa > 0:
        if to_float(exponent) > 1:
            w = _by_logarithm(exponent)
        else:
            w = _principal_offset(1 + exponential(1 + exponent)) - 1
        return (ZERO if zero_is_a_root else enclosure((-_quotient(beta) - w) / _quotient(d)), ABSENT)
    distance = -1 - exponent
    if not _is_positive(distance):
        return (ABSENT, ABSENT)
    rest = 1 - _quotient(beta)
    if zero_is_a_root and kappa >= -1:
        first = ZERO
    else:
        first = enclosure((rest - _principal_offset(1 - exponential(-distance))) / _quotient(d))
    if zero_is_a_root and kappa <= -1:
        return (first, ZERO)
    return (first, enclosure((rest + _lower_offset(distance)) / _quotient(d)))


EQUATIONS = {
    "lambert.w0": w0,
    "lambert.wm1": wm1,
    "lambert.linear_exponential_roots": linear_exponential_roots,
}
