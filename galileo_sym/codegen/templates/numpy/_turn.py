"""Sine and cosine together, by the nearest of 512 steps of a quarter turn."""

from functools import cached_property

import numpy as np

from ._pairs import Pair, cut, mul, sub
from ._steps import CENTRE, CENTRE_LO, SINE, SINE_LO, TURNS, TURNS_A_RADIAN

_BIG = 2.0**52 + 2.0**51  # added, it leaves an integer in the last bits
_CLEAR = 2.0**-5  # share of the cosine from which the driving force is left to pairs
_COSINE, _COSINE_LO = (np.ascontiguousarray(column[::-1]) for column in (SINE, SINE_LO))


class Turn:
    """Sine and cosine of |theta|, |theta| <= pi/2 - 2**-20, to 2**-65 or so, and the sign of theta.

    Products of the step's sine and cosine with the first part of the distance d from it are exact; what is left is so
    small that plain arithmetic does.
    """

    def __init__(self, theta):
        size = np.abs(theta)
        u = size * TURNS_A_RADIAN
        u += _BIG
        i = u.view(np.int64) & (2 * TURNS - 1)
        d = size - CENTRE.take(i)
        self.theta = theta
        self._d = cut(d)
        rest = d - self._d
        off = CENTRE_LO.take(i)
        rest -= off
        d -= off
        q = d * d
        self._less = q * (q * (1.0 / 24.0) - 0.5)  # cos(d) - 1
        q *= q * (1.0 / 120.0) - 1.0 / 6.0
        q *= d
        q += rest
        self._over = q  # sin(d) less the first part of d
        self._s, self._s_lo, self._c, self._c_lo = (t.take(i) for t in (SINE, SINE_LO, _COSINE, _COSINE_LO))
        self._sine, self._cosine = self._s + self._s_lo, self._c + self._c_lo

    @cached_property
    def sine(self):
        """Sine of |theta|."""
        p = self._c * self._d
        s = self._s + p
        small = self._c_lo * self._d
        small += self._s_lo
        small += self._cosine * self._over
        small += self._sine * self._less
        small += p - (s - self._s)
        return Pair(s, small)

    @cached_property
    def cosine(self):
        """Cosine of theta."""
        p = self._s * self._d
        c = self._c - p
        small = self._s_lo * self._d
        small -= self._c_lo
        small += self._sine * self._over
        small -= self._cosine * self._less
        return Pair(c, ((self._c - c) - p) - small)


def angle(theta):
    """Prepare theta."""
    return Turn(theta)


def sine(turn):
    """Sine of theta."""
    sign = np.copysign(1.0, turn.theta)
    return Pair(sign * turn.sine.p, sign * turn.sine.q)


def cosine(turn):
    """Cosine of theta."""
    return turn.cosine


def driving(turn, mu, lanes):
    """cos(theta) - mu sin(|theta|); 1 where friction holds the bead, or nearly does."""
    n = sub(turn.cosine, mul(mu, turn.sine))
    least = _CLEAR * turn.cosine.x
    moves = n.x >= least
    if moves.all():
        return n
    lanes.keep(np.abs(n.x) >= least)
    lanes.held = ~moves
    return Pair(np.where(moves, n.p, 1.0), np.where(moves, n.q, 0.0))
