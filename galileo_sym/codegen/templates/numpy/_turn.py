"""Sine and cosine together, by the nearest of 512 steps of a quarter turn."""

from functools import cached_property

import numpy as np

from ._pairs import Pair, halves
from ._steps import CENTRE, CENTRE_LO, SINE, SINE_LO, TURNS, TURNS_A_RADIAN

_BIG = 2.0**52 + 2.0**51  # added, it leaves an integer in the last bits
_COSINE, _COSINE_LO = (np.ascontiguousarray(column[::-1]) for column in (SINE, SINE_LO))


class Turn:
    """Sine and cosine of |theta|, |theta| <= pi/2 - 2**-20, to 2**-66 or so, and the sign of theta.

    Products of the step's sine and cosine with the first half of the distance d from it are exact; what is left is so
    small that plain arithmetic does.
    """

    def __init__(self, theta):
        size = np.abs(theta)
        i = (size * TURNS_A_RADIAN + _BIG).view(np.int64) & (2 * TURNS - 1)
        d = size - CENTRE.take(i)
        self.theta = theta
        self._d, d_lo = halves(d)
        self._d_lo = d_lo - CENTRE_LO.take(i)
        self._s, self._s_lo, self._c, self._c_lo = (t.take(i) for t in (SINE, SINE_LO, _COSINE, _COSINE_LO))
        q = d * d
        self._less = q * (q * (1.0 / 24.0) - 0.5)  # cos(d) - 1
        self._over = self._d_lo + d * q * (q * (1.0 / 120.0) - 1.0 / 6.0)  # sin(d) less the first half of d

    @cached_property
    def sine(self):
        """Sine of |theta|."""
        p = self._c * self._d
        s = self._s + p
        small = self._s * self._less + (self._c * self._over + (self._c_lo * self._d + self._s_lo))
        rest = ((self._s - s) + p) + small
        r = s + rest
        return Pair(r, (s - r) + rest)

    @cached_property
    def cosine(self):
        """Cosine of theta."""
        p = self._s * self._d
        c = self._c - p
        small = self._c * self._less - (self._s * self._over + (self._s_lo * self._d - self._c_lo))
        rest = ((self._c - c) - p) + small
        r = c + rest
        return Pair(r, (c - r) + rest)


def angle(theta):
    """Prepare theta."""
    return Turn(theta)


def sine(turn):
    """Sine of theta."""
    sign = np.copysign(1.0, turn.theta)
    return Pair(sign * turn.sine.hi, sign * turn.sine.lo)


def cosine(turn):
    """Cosine of theta."""
    return turn.cosine
