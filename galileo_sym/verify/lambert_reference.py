"""Certain references of W and of the roots of a t + b + c exp(d t) = 0, by ball arithmetic on their equations.

Three forms of w exp(w) = x, each with a left side that increases: w + log(w) = log(x) for w > 0, and, at the distance
-1 - log(-x) of -x from 1/e, 1 + (s - 1) exp(s) = 1 + e x with s = 1 + W0 and s - log(1 + s) = -1 - log(-x) with
s = -1 - W-1.
"""

import math

from flint import fmpq

from .enclosure import (
    ABSENT,
    ZERO,
    Undecided,
    enclosure,
    exponential,
    float_newton,
    logarithm,
    newton,
    number,
    proved_root,
    spared,
    square_root,
)

_NEAR = 1e-6  # below it the first guess is the leading term of the power series
_FAR = 1e15  # above it that of the asymptotic one
_SMALL = -6.0  # logarithm of the |x| below which W0 is found from x itself
_NEGLIGIBLE = -1e9  # and below which W0 counts for nothing beside any number of the equation


def _root(value_and_slope, target, guess):
    """The proved root of an increasing function."""

    def balance(s):
        value, slope = value_and_slope(s)
        return value - target, slope

    return proved_root(lambda s: value_and_slope(s)[0], target, newton(balance, guess))


def _by_logarithm(y):
    """W0 > 0 from w + log(w) = y >= 1."""
    size = float(y)
    guess = y
    if size < _FAR:
        guess = number(float_newton(lambda w: min((w + math.log(w) - size) / (1 + 1 / w), w / 2), 1.0))
    return _root(lambda w: (w + logarithm(w), 1 + 1 / w), y, guess)


def _principal_offset(level):
    """s = 1 + W0 > 0 from 1 + (s - 1) exp(s) = 1 + e x = level, at most 1 + e**2."""
    size = float(level)
    guess = square_root(2 * level)
    if size > _NEAR:

        def step(s):
            return (1 + (s - 1) * math.exp(s) - size) / (s * math.exp(s))

        guess = number(float_newton(step, min(math.sqrt(2 * size), 1 + math.log1p(size))))

    def balance(s):
        growth = exponential(s)
        return 1 + (s - 1) * growth, s * growth

    return _root(spared(balance), level, guess)


def _small(size, sign):
    """W0 of x = sign size from w exp(w) = x itself, which increases with |w| below 1; 0 < size < 2**-8."""

    def balance(w):
        growth = exponential(w if sign > 0 else -w)
        return w * growth, (1 + sign * w) * growth

    return sign * _root(balance, size, size)


def _principal(exponent, sign):
    """W0 of x = sign exp(exponent), which is above -1/e and below e."""
    if _NEGLIGIBLE < float(exponent) < _SMALL:
        return _small(exponential(exponent), sign)
    return _principal_offset(1 + sign * exponential(1 + exponent)) - 1


def _lower_offset(distance):
    """s = -1 - W-1 > 0 from s - log(1 + s) = distance > 0."""
    size = float(distance)
    guess = distance
    if size < _NEAR:
        guess = square_root(2 * distance)
    elif size < _FAR:

        def step(s):
            return (s - math.log1p(s) - size) * (1 + s) / s

        guess = number(float_newton(step, size + math.sqrt(2 * size)))
    return _root(spared(lambda s: (s - logarithm(1 + s), s / (1 + s))), distance, guess)


def _is_positive(x):
    """Whether a ball holds positive numbers only; raises where its sign is open."""
    if not (x > 0 or x < 0):
        raise Undecided("a sign needs more bits")
    return x > 0


def w0(x):
    """W0(x), the w >= -1 of result (1)."""
    if x == 0:
        return (ZERO,)
    if x > math.e:
        return (enclosure(_by_logarithm(logarithm(number(x)))),)
    if abs(x) < math.exp(_SMALL):
        return (enclosure(_small(number(abs(x)), 1 if x > 0 else -1)),)
    level = 1 + exponential(number(1)) * number(x)
    _is_positive(level)
    return (enclosure(_principal_offset(level) - 1),)


def wm1(x):
    """W-1(x), the w <= -1 of result (1)."""
    distance = -1 - logarithm(number(-x))
    _is_positive(distance)
    return (enclosure(-1 - _lower_offset(distance)),)


def _degenerate(a, b, c, d):
    """The roots where a, c or d is 0."""
    if a != 0:
        root = -(b + c) / a
        return (ZERO if root == 0 else enclosure(number(root)), ABSENT)
    ratio = -b / c
    if ratio <= 0:
        return (ABSENT, ABSENT)
    return (ZERO if ratio == 1 else enclosure(logarithm(number(ratio)) / number(d)), ABSENT)


def linear_exponential_roots(a, b, c, d):
    """Result (3) and the root by W-1: t = -b/a - W/d, w exp(w) = (c d/a) exp(-b d/a)."""
    a, b, c, d = (fmpq(*x.as_integer_ratio()) for x in (a, b, c, d))
    if 0 in (a, c, d):
        return _degenerate(a, b, c, d)
    beta, kappa = b * d / a, c * d / a
    if beta == 1 and kappa == -1:
        return (ZERO, ZERO)  # the only double root: log(-kappa) is irrational for any other rational kappa
    exponent = logarithm(number(abs(kappa))) - number(beta)  # of |x|
    zero_is_a_root = b == -c
    if kappa > 0:
        w = _by_logarithm(exponent) if float(exponent) > 1 else _principal(exponent, 1)
        return (ZERO if zero_is_a_root else enclosure((-number(beta) - w) / number(d)), ABSENT)
    distance = -1 - exponent
    if not _is_positive(distance):
        return (ABSENT, ABSENT)
    if zero_is_a_root and kappa >= -1:
        first = ZERO
    else:
        first = enclosure((-number(beta) - _principal(exponent, -1)) / number(d))
    if zero_is_a_root and kappa <= -1:
        return (first, ZERO)
    return (first, enclosure((1 - number(beta) + _lower_offset(distance)) / number(d)))


EQUATIONS = {
    "lambert.w0": w0,
    "lambert.wm1": wm1,
    "lambert.linear_exponential_roots": linear_exponential_roots,
}
