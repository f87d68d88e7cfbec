"""exp(-x) by the nearest of 512 steps of a halving."""

import numpy as np

from ._steps import FADING_STEP, FADING_STEP_LO, FADINGS, FADINGS_A_UNIT, POWER, POWER_LO

_BIG = 2.0**52 + 2.0**51  # added, it leaves an integer in the last bits
_BITS = FADINGS.bit_length() - 1


def fading(x, x_lo=None):
    """exp(-x - x_lo), 0 <= x <= 640, to 2**-62 of it, as a pair."""
    u = x * FADINGS_A_UNIT
    u += _BIG
    k = u - _BIG
    steps = u.view(np.int64)
    power = (0x3FF0000000000000 - (steps >> _BITS << 52)).view(np.float64)
    i = steps & (FADINGS - 1)
    t = x - k * FADING_STEP  # both are exact
    k *= FADING_STEP_LO
    t -= k
    if x_lo is not None:
        t += x_lo
    tail = 1.0 / 6.0 - t * (1.0 / 24.0 - t * (1.0 / 120.0))
    tail *= t
    tail -= 0.5
    tail *= t
    tail += 1.0
    tail *= t  # 1 - exp(-t)
    c = POWER.take(i)
    tail *= c
    p = POWER_LO.take(i) - tail
    r = c + p
    c -= r
    c += p
    c *= power
    r *= power
    return r, c
