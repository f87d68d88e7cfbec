"""What is nearest a midpoint, decided by Arb: the sign of f(x) - m, as far as can be from the equation that defines f.

Such an equation changes sign once as f(x) passes m, and is made of polynomials of x and m, exact at high enough
precision, and of exp(-t); so a value that touches m but for exp(-t) is told too.
"""

import struct
from fractions import Fraction
from math import isfinite

from flint import arb, ctx, fmpq

PRECISIONS = tuple(128 << k for k in range(8))


class Unsettled(ArithmeticError):
    """No precision tried tells on which side of m the value lies."""


def _flight(b, t):
    return (1 + b - t) - (1 + b) * (-t).exp()


def _best_sine(a, m):
    """1 + (s - 1) exp(s) - a^2 at the s that has m for best sine, exp(s) = 1 + a/m."""
    share = a / m
    return 1 + (share.log1p() - 1) * (1 + share) - a * a


def _max_range_factor(a, m):
    s = 1 + ((a * a - 1) * arb(-1).exp()).lambertw()
    return (1 - (1 + s) * (-s).exp()) - (a * m) ** 2


def _w0(x, m):
    return x - m * m.exp() if m > -1 else arb(1)


def _wm1(x, m):
    return m * m.exp() - x if m < -1 else arb(-1)


# name: f(x) - m in sign; what is exact comes first, since it may be 0
SIGNS = {
    "phi1m": lambda z, m: (1 - m * z) - (-z).exp(),
    "phi2m": lambda z, m: (z - 1 - m * z * z) + (-z).exp(),
    "descent_factor": lambda p, m: (p * p / 2 + 1 - p * m) - (-p * m).exp(),
    "flight_factor": lambda b, m: _flight(b, 2 * b * m),
    "range_factor": lambda b, m: _flight(b, 2 * b * (1 + b) * m),
    "best_sine": _best_sine,
    "best_angle": lambda a, m: _best_sine(a, m.sin()),
    "max_range_factor": _max_range_factor,
    "w0_offset": lambda x, m: (x + m) + (-m).log1p() if m < 1 else arb(-1),
    "wm1_offset": lambda x, m: -(m + x) - (-m).log1p() if m < 0 else arb(-1),
    "w0": _w0,
    "wm1": _wm1,
    "exp_minus": lambda z, m: (-z).exp() - m,
    "sin": lambda x, m: x.sin() - m,
    "cos": lambda x, m: x.cos() - m,
    "arctan": lambda x, m: x.atan() - m,
}


def sign(name, x, m):
    """Return whether the value at x lies above (1) or below (-1) m.

    Parameters
    ----------
    name : str
        A primitive, a key of `SIGNS`.
    x, m : float or Fraction
        x in the domain, and not 0: so f(x) is not m, since these functions take no rational to a rational.

    Raises
    ------
    Unsettled
        If 16384 bits do not tell.
    """
    before = ctx.prec
    try:
        for ctx.prec in PRECISIONS:
            ball = SIGNS[name](*(arb(fmpq(*Fraction(v).as_integer_ratio())) for v in (x, m)))
            if ball > 0:
                return 1
            if ball < 0:
                return -1
    finally:
        ctx.prec = before
    raise Unsettled(f"{name}({float(x).hex()}) is too near {m} for {PRECISIONS[-1]} bits")


def of_bits(bits):
    """Return the float of 32 bits, as an exact double."""
    return struct.unpack("<f", struct.pack("<I", bits))[0]


def to_bits(value):
    """Return the 32 bits of a float."""
    return struct.unpack("<I", struct.pack("<f", value))[0]


def is_nearest(name, x, y):
    """Return whether the finite float y is the one nearest to the value at x.

    Raises
    ------
    Unsettled
        As `sign`.
    """
    if not isfinite(y):
        return False
    size = to_bits(abs(y))
    outer = Fraction(of_bits(size + 1)) if size + 1 < 0x7F800000 else Fraction(2) ** 128
    inner = Fraction(of_bits(size - 1)) if size else -outer
    ends = sorted((abs(Fraction(y)) + neighbour) / (2 if y >= 0 else -2) for neighbour in (inner, outer))
    return sign(name, x, ends[1]) < 0 < sign(name, x, ends[0])
