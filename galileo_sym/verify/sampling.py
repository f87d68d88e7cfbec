"""Exact, platform-independent random floats, and the few correctly rounded angles that strata are built around."""

import math
import random

from .enclosure import arctangent, number, sine_cosine, with_bits

HALF_PI = math.pi / 2
_ANGLE_BITS = 160


class Draw:
    """A stream of floats that depends on its key alone.

    Only IEEE arithmetic, `ldexp` and the Mersenne twister are used, so that each machine draws the same floats.

    Parameters
    ----------
    key : str
        Seed, function, force set and stratum.
    """

    def __init__(self, key):
        self._random = random.Random(key)

    def uniform(self, low, high):
        """A float between two floats."""
        return low + (high - low) * self._random.random()

    def integer(self, low, high):
        """An integer, both ends included."""
        return low + int((high - low + 1) * self._random.random())

    def magnitude(self, low, high):
        """A positive float, log-uniform by binade: 2**low <= x < 2**high, with a random significand."""
        return math.ldexp(1.0 + self._random.random(), self.integer(low, high - 1))

    def sign(self):
        """1.0 or -1.0."""
        return 1.0 if self._random.random() < 0.5 else -1.0

    def chance(self, share):
        """True for that share of the draws."""
        return self._random.random() < share


def step(value, ulps):
    """The float so many places above (below, if negative) a positive float."""
    direction = math.inf if ulps > 0 else -math.inf
    for _ in range(abs(ulps)):
        value = math.nextafter(value, direction)
    return value


@with_bits(_ANGLE_BITS)
def critical_angle(mu):
    """The float nearest theta_max = arctan(1/mu), not above the float nearest pi/2."""
    return min(float(arctangent(1 / number(mu))), HALF_PI) if mu else HALF_PI


@with_bits(_ANGLE_BITS)
def critical_friction(theta):
    """The float nearest cot(theta), the coefficient of friction at which a bead on that chord just stays at rest."""
    sine, cosine = sine_cosine(number(theta))
    return float(cosine / sine)


def grid_end(draw):
    """A positive float within 4 places of an end of the intervals on which 1 + x has the same 4 leading bits."""
    while True:
        end = math.ldexp(1.0 + draw.integer(0, 15) / 16.0, draw.integer(0, 13)) - 1.0
        if end > 0.0:
            return step(end, draw.integer(-4, 4))
