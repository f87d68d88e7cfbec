"""The first two exponential integrator functions of -s as pairs, for the equations that a solver meets."""

from typing import NamedTuple

import numpy as np

from ._scaled import ZERO, Scaled, constant, div, mul, pair_add, pair_mul, plain, select, sub
from ._tables import DECAY_PAIRS, DECAY_SERIES

_HALVINGS = 8
_FAR = 75.0  # exp(-s) is below 2**-108 of what it is added to


class Decay(NamedTuple):
    """exp(-s), phi1(-s) = (1 - exp(-s))/s and phi2(-s) = (s - 1 + exp(-s))/s**2; exp(-s) is 0 for s > 75."""

    fading: Scaled
    first: Scaled
    second: Scaled


def decay(s):
    """Evaluate at a scaled pair s >= 0, with relative error about 2**-96.

    The power series at z = -s/2**8, then eight times phi2(2z) = (phi1(z)**2 + 2 phi2(z))/4,
    phi1(2z) = phi1(z) (1 + exp(z))/2 and exp(2z) = exp(z)**2.
    """
    x, x_lo = plain(s)
    far = x >= _FAR
    x, x_lo = (np.where(far, 0.0, part) * 2.0**-_HALVINGS for part in (x, x_lo))
    phi2 = np.full_like(x, DECAY_SERIES[-1][0]), np.zeros_like(x)
    for c, _ in DECAY_SERIES[-2 : DECAY_PAIRS - 1 : -1]:
        phi2 = phi2[0] * x + c, phi2[1]
    for row in DECAY_SERIES[DECAY_PAIRS - 1 :: -1]:
        phi2 = pair_add(*pair_mul(*phi2, x, x_lo), *row)
    phi1 = _less(*pair_mul(*phi2, x, x_lo))
    fading = _less(*pair_mul(*phi1, x, x_lo))
    for _ in range(_HALVINGS):
        hi, lo = pair_mul(*phi1, *phi1)
        phi2 = pair_add(0.25 * hi, 0.25 * lo, 0.5 * phi2[0], 0.5 * phi2[1])
        hi, lo = pair_mul(*phi1, *pair_add(1.0, 0.0, *fading))
        phi1 = 0.5 * hi, 0.5 * lo
        fading = pair_mul(*fading, *fading)
    zero = np.zeros_like(x, dtype=np.int32)
    near = [Scaled(*part, zero) for part in (fading, phi1, phi2)]
    if not np.any(far):
        return Decay(*near)
    inverse = div(constant(1.0), select(far, s, constant(1.0)))
    beyond = ZERO, inverse, mul(sub(constant(1.0), inverse), inverse)
    return Decay(*(select(far, a, b) for a, b in zip(beyond, near, strict=True)))


def _less(hi, lo):
    """1 - (hi + lo)."""
    return pair_add(1.0, 0.0, -hi, -lo)


def fading(decay):
    """exp(-s)."""
    return decay.fading


def first(decay):
    """phi1(-s)."""
    return decay.first


def second(decay):
    """phi2(-s)."""
    return decay.second
