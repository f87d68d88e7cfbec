"""Rigorous enclosures by interval arithmetic: the few operations the printed equations need.

Intervals are those of `mpmath` (outward rounding of + - * / sqrt). Its exponential, logarithm, sine and cosine carry
guard bits but no proof of the last one, so they are evaluated with 16 bits to spare and widened by 2**14 times their
stated error.
"""

from typing import NamedTuple

from mpmath import libmp
from mpmath.ctx_iv import MPIntervalContext

CONTEXT = MPIntervalContext()
FIRST_PRECISION = 160
LAST_PRECISION = 1 << 16
CERTAIN_BITS = 90
_GUARD_BITS = 16
_SERIES_BELOW = -20  # z - 1 + exp(-z) is summed as a series below 2**-20, where subtraction costs over 40 bits
_NEWTON_STEPS = 200


class Undecided(ArithmeticError):
    """The working precision does not settle a sign or a bracket; the computation has to be repeated with more bits."""


class Enclosure(NamedTuple):
    """An exact result between two numbers, both in mpmath's raw form (sign, mantissa, exponent, bits).

    Attributes
    ----------
    low, high : tuple
        Ends of the interval; equal to `libmp.finf` for a result that is infinite.
    scale : tuple or None
        Lower bound of the magnitude that errors are measured against, where that is not the result's own.
    """

    low: tuple
    high: tuple
    scale: tuple | None = None


INFINITE = Enclosure(libmp.finf, libmp.finf)
ZERO = Enclosure(libmp.fzero, libmp.fzero)
ABSENT = Enclosure(libmp.fnan, libmp.fnan)  # of a root that does not exist: the result has to be NaN


def number(value):
    """The point interval of a float or integer, without rounding."""
    raw = libmp.from_float(value) if isinstance(value, float) else libmp.from_int(value)
    return CONTEXT.make_mpf((raw, raw))


def enclosure(interval, scale=None):
    """An `Enclosure` of an interval; `scale` is an interval of positive numbers or None."""
    low, high = interval._mpi_
    return Enclosure(low, high, None if scale is None else scale._mpi_[0])


def _widened(low, high):
    """An interval around two approximations of one point or two, each widened by its guard bits."""
    slack = libmp.from_man_exp(1, -CONTEXT.prec - 2)
    down = libmp.mpf_sub(low, libmp.mpf_abs(libmp.mpf_mul(low, slack)), CONTEXT.prec, libmp.round_floor)
    up = libmp.mpf_add(high, libmp.mpf_abs(libmp.mpf_mul(high, slack)), CONTEXT.prec, libmp.round_ceiling)
    return CONTEXT.make_mpf((down, up))


def sine_cosine(theta):
    """Enclosures of sin and cos at a point.

    Parameters
    ----------
    theta : interval
        A point interval, 0 <= theta <= the double nearest pi/2, in radians.
    """
    (point, _) = theta._mpi_
    cosine, sine = libmp.mpf_cos_sin(point, CONTEXT.prec + _GUARD_BITS, libmp.round_nearest)
    return _widened(sine, sine), _widened(cosine, cosine)


def exponential(x):
    """Enclosure of exp over an interval of any width."""
    low, high = x._mpi_
    bits = CONTEXT.prec + _GUARD_BITS
    lower = libmp.mpf_exp(low, bits, libmp.round_nearest)
    upper = lower if low == high else libmp.mpf_exp(high, bits, libmp.round_nearest)
    return _widened(lower, upper)


def logarithm(x):
    """Enclosure of log over an interval of positive numbers."""
    low, high = x._mpi_
    bits = CONTEXT.prec + _GUARD_BITS
    lower = libmp.mpf_log(low, bits, libmp.round_nearest)
    upper = lower if low == high else libmp.mpf_log(high, bits, libmp.round_nearest)
    return _widened(lower, upper)


def arctangent(x):
    """Enclosure of arctan over an interval of any width."""
    bits = CONTEXT.prec + _GUARD_BITS
    return _widened(*(libmp.mpf_atan(end, bits, libmp.round_nearest) for end in x._mpi_))


def nearest_float(result):
    """The float nearest the lower end of an `Enclosure`."""
    return libmp.to_float(result.low, rnd=libmp.round_nearest)


def _magnitude(raw):
    """The exponent m with 2**(m - 1) <= |x| < 2**m of a raw nonzero number."""
    return raw[2] + raw[3]


def decay(z):
    """Enclosures of exp(-z), 1 - exp(-z) and z - 1 + exp(-z), the brackets of every printed equation with drag.

    Parameters
    ----------
    z : interval
        A point interval, z >= 0 (dimensionless: gamma t or k t).

    Returns
    -------
    tuple of three intervals
        For small z the two leading terms of exp(-z) are cancelled before summing:
        z - 1 + exp(-z) = z**2/2 (1 - z/3 (1 - z/4 (1 - ...))), where each bracket lies in [0, 1] for z < 1.
    """
    point = z._mpi_[0]
    if point == libmp.fzero:
        return number(1), number(0), number(0)
    magnitude = _magnitude(point)
    if magnitude > _SERIES_BELOW:
        fading = exponential(-z)
        lost = 1 - fading
        return fading, lost, z - lost
    bracket = CONTEXT.make_mpf((libmp.fzero, libmp.fone))
    for order in range(3 + CONTEXT.prec // -magnitude, 2, -1):
        bracket = 1 - z * bracket / order
    lag = z * z * bracket / 2
    lost = z - lag
    return 1 - lost, lost, lag


def midpoint(x):
    """The point interval at the middle of an interval."""
    low, high = x._mpi_
    middle = libmp.mpf_shift(libmp.mpf_add(low, high), -1)
    middle = libmp.mpf_pos(middle, CONTEXT.prec, libmp.round_nearest)
    return CONTEXT.make_mpf((middle, middle))


def to_float(x):
    """The double nearest the middle of an interval; +-inf or 0 where that leaves the range."""
    return libmp.to_float(midpoint(x)._mpi_[0])


def newton(value_and_slope, start):
    """A close approximation (no proof) of a positive root by Newton's method from `start`, as a point interval.

    Parameters
    ----------
    value_and_slope : callable
        Takes a point interval, gives intervals of the function and of its derivative.
    start : interval
        Positive first guess on the side from which the method converges.
    """
    x = midpoint(start)
    for _ in range(_NEWTON_STEPS):
        value, slope = value_and_slope(x)
        step = midpoint(midpoint(value) / midpoint(slope))
        following = midpoint(x - step)
        raw, move = following._mpi_[0], step._mpi_[0]
        if move == libmp.fzero or _magnitude(move) < _magnitude(raw) - CONTEXT.prec // 2:
            return following
        x = following
    raise Undecided("Newton's method did not settle")


def proved_root(increasing, target, near):
    """An enclosure of the x > 0 with increasing(x) = target, proved by a change of sign.

    Parameters
    ----------
    increasing : callable
        An increasing function of x > 0: takes a point interval, gives an interval.
    target : interval
        The value to meet, positive; every number in it is met inside the result.
    near : interval
        Point interval close to the root; needs no proof.

    Raises
    ------
    Undecided
        If the bracket of 2**(48 - precision), widened by the target's own width, holds no certain change of sign.
    """
    low, high = target._mpi_
    width = CONTEXT.make_mpf((libmp.fzero, libmp.mpf_sub(high, low)))
    part = 4 * (width / target).b + CONTEXT.make_mpf((libmp.fzero, libmp.from_man_exp(1, 48 - CONTEXT.prec))).b
    bottom, top = (near * (1 - part)).a, (near * (1 + part)).b
    if not increasing(bottom).b < target.a:
        raise Undecided("no sign at the lower end of the bracket")
    if not increasing(top).a > target.b:
        raise Undecided("no sign at the upper end of the bracket")
    return CONTEXT.make_mpf((bottom._mpi_[0], top._mpi_[1]))


def _is_certain(result):
    """Whether an enclosure is narrower than 2**-90 of its magnitude (or scale)."""
    if result == ABSENT:
        return True
    width = libmp.mpf_sub(result.high, result.low, 30, libmp.round_up)
    if width == libmp.fzero or result == INFINITE:
        return True
    if result.scale is not None:
        size = result.scale
    elif libmp.mpf_sign(result.low) * libmp.mpf_sign(result.high) <= 0:
        return False
    else:
        size = min(libmp.mpf_abs(result.low), libmp.mpf_abs(result.high), key=_magnitude)
    return size != libmp.fzero and _magnitude(width) < _magnitude(size) - CERTAIN_BITS


def certain(compute):
    """Run `compute` with doubled precision until each enclosure it returns is narrower than 2**-90.

    Parameters
    ----------
    compute : callable
        Takes nothing, works at the precision of `CONTEXT`, returns a tuple of `Enclosure`.

    Raises
    ------
    ArithmeticError
        If 65536 bits do not suffice.
    """
    precision = FIRST_PRECISION
    while precision <= LAST_PRECISION:
        CONTEXT.prec = precision
        try:
            results = compute()
        except Undecided:
            results = None
        if results is not None and all(_is_certain(result) for result in results):
            return results
        precision *= 2
    raise ArithmeticError(f"no certain reference with {LAST_PRECISION} bits; the inputs lie on a singular point")
