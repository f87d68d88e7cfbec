"""Rigorous enclosures by ball arithmetic: the few operations the printed equations need.

Balls are those of Arb, by `python-flint`: every operation, elementary functions included, returns a ball that holds the
exact result for all points of its arguments. A ball made of a float or an integer is a point, without rounding. A
comparison holds only if it holds for all points of both balls.
"""

import math
from functools import wraps
from typing import NamedTuple

from flint import arb, ctx

FIRST_PRECISION = 160
LAST_PRECISION = 160 << 8
_MORE = 4  # times the bits: a step costs little more than the one before, most of it overhead
CERTAIN_BITS = 90
_SERIES_BELOW = 2.0**-20  # there z - 1 + exp(-z) is summed as a series: subtraction would cost over 40 bits
_NEWTON_STEPS = 200
_FLOAT_STEPS = 60
_BELOW_ALL_FORMATS = arb(2) ** -1200
_FIRST_BRACKET = arb(0.5, 0.5)

number = arb
exponential, logarithm, square_root = arb.exp, arb.log, arb.sqrt
sine_cosine, arcsine, arctangent = arb.sin_cos, arb.asin, arb.atan


class Undecided(ArithmeticError):
    """The working precision does not settle a sign or a bracket; the computation has to be repeated with more bits."""


class Enclosure(NamedTuple):
    """A ball that holds an exact result.

    Attributes
    ----------
    ball : arb
        Infinite for a result that is, NaN for one that does not exist.
    scale : arb or None
        A point, lower bound of the magnitude that errors are measured against, where that is not the result's own.
    """

    ball: arb
    scale: arb | None = None


INFINITE = Enclosure(arb.pos_inf())
ZERO = Enclosure(arb(0))
ABSENT = Enclosure(arb.nan())  # of a root that does not exist: the result has to be NaN


def with_bits(bits):
    """Decorate a function to work at a precision, and to leave flint's context as it was."""

    def decorate(function):
        @wraps(function)
        def precisely(*given):
            before = ctx.prec
            ctx.prec = bits
            try:
                return function(*given)
            finally:
                ctx.prec = before

        return precisely

    return decorate


def enclosure(ball, scale=None):
    """An `Enclosure` of a ball; `scale` is a ball of positive numbers or None."""
    return Enclosure(ball, None if scale is None else scale.abs_lower())


def nearest_float(result):
    """The float nearest the middle of an `Enclosure`."""
    return float(result.ball)


def decay(z):
    """Enclosures of exp(-z), 1 - exp(-z) and z - 1 + exp(-z), the brackets of every printed equation with drag.

    Parameters
    ----------
    z : arb
        A ball of numbers z >= 0 (dimensionless: gamma t or k t).

    Returns
    -------
    tuple of three balls
        For small z the two leading terms of exp(-z) are cancelled before summing:
        z - 1 + exp(-z) = z**2/2 (1 - z/3 (1 - z/4 (1 - ...))), where each bracket lies in [0, 1] for z < 1.
    """
    if not z < _SERIES_BELOW:
        fading = exponential(-z)
        lost = 1 - fading
        return fading, lost, z - lost
    if z.is_zero():
        return number(1), number(0), number(0)
    bracket = _FIRST_BRACKET
    for order in range(3 + ctx.prec // -_magnitude(z), 2, -1):
        bracket = 1 - z * bracket / order
    lag = z * z * bracket / 2
    lost = z - lag
    return 1 - lost, lost, lag


def _magnitude(x):
    """The exponent m with about 2**(m - 1) <= x < 2**m; that of the least float for what is smaller."""
    return math.frexp(float(x) or math.ulp(0.0))[1]


def spared(function):
    """A function of s that vanishes like s**2, evaluated with the bits that its subtraction costs."""

    def evaluate(s):
        spare = 2 * max(0, -_magnitude(s))
        ctx.prec += spare
        try:
            return function(s)
        finally:
            ctx.prec -= spare

    return evaluate


def float_newton(step, start):
    """A first guess (no proof) by Newton's method in floats, x - step(x) repeated from `start`."""
    x = start
    for _ in range(_FLOAT_STEPS):
        move = step(x)
        x -= move
        if abs(move) < 1e-9 * x:
            break
    return x


def newton(value_and_slope, start):
    """A close approximation (no proof) of a positive root by Newton's method from `start`, as a point.

    Parameters
    ----------
    value_and_slope : callable
        Takes a point, gives balls of the function and of its derivative.
    start : arb
        Positive first guess on the side from which the method converges.
    """
    x = start.mid()
    settled = number(2) ** -(ctx.prec // 2)
    for _ in range(_NEWTON_STEPS):
        value, slope = value_and_slope(x)
        step = (value / slope).mid()
        x = (x - step).mid()
        if abs(step) < settled * x:
            return x
    raise Undecided("Newton's method did not settle")


def proved_root(function, target, near, falling=False):
    """An enclosure of an x > 0 with function(x) = target, proved by a change of sign.

    Parameters
    ----------
    function : callable
        An increasing function of x > 0, or a decreasing one, or one that does so about one root only: takes a point,
        gives a ball.
    target : arb
        The value to meet, positive; every number in it is met inside the result.
    near : arb
        Point close to the root; needs no proof.
    falling : bool
        Whether the function decreases.

    Raises
    ------
    Undecided
        If the bracket of 2**(-32 - precision/2), widened by the target's own width, holds no certain change of sign.
    """
    part = (8 * target.rad() / target + number(2) ** (-32 - ctx.prec // 2)).mid()
    bottom, top = (near * (1 - part)).mid(), (near * (1 + part)).mid()
    if not bottom > 0:
        raise Undecided("the target is too wide")
    below, above = (top, bottom) if falling else (bottom, top)
    if not function(below) < target:
        raise Undecided("no sign at the end of the bracket below the target")
    if not function(above) > target:
        raise Undecided("no sign at the end of the bracket above the target")
    return bottom.union(top)


def increasing(function, x):
    """The ball of an increasing function over a ball: that of its values at both ends."""
    return function(x.lower()).union(function(x.upper()))


def _is_certain(result):
    """Whether an enclosure is narrower than 2**-90 of its magnitude (or scale), or below the range of any format."""
    if result is ABSENT or result is INFINITE:
        return True
    ball, scale = result
    if ball.rel_accuracy_bits() > CERTAIN_BITS + 2:  # which rounds exponents, and takes an infinity for accurate
        return ball.is_finite()
    if scale is not None:
        return ball.rad() < scale * 2.0 ** -(CERTAIN_BITS + 1)
    return ball.abs_upper() < _BELOW_ALL_FORMATS


def certain(compute):
    """Run `compute` with four times the precision until each enclosure it returns is narrower than 2**-90.

    Parameters
    ----------
    compute : callable
        Takes nothing, works at the precision of flint's context, returns a tuple of `Enclosure`.

    Raises
    ------
    ArithmeticError
        If 40960 bits do not suffice.
    """
    before = ctx.prec
    precision = FIRST_PRECISION
    try:
        while precision <= LAST_PRECISION:
            ctx.prec = precision
            try:
                results = compute()
            except Undecided:
                results = None
            if results is not None and all(map(_is_certain, results)):
                return results
            precision *= _MORE
    finally:
        ctx.prec = before
    raise ArithmeticError(f"no certain reference with {LAST_PRECISION} bits; the inputs lie on a singular point")
