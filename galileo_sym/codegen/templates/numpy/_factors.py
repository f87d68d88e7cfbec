"""The primitives on pairs of ordinary size, for the papers' formulas."""

import numpy as np

from . import special
from ._chunks import extent
from ._fading import fading
from ._lines import inside
from ._pairs import Pair, mul

_END = 512.0  # from here exp(-z) is left to the scaled kernels


def _factor(name):
    primitive = special.PRIMITIVES[name]

    def evaluate(x):
        return Pair(*inside(primitive, x.x, x.rest))

    evaluate.__name__ = evaluate.__qualname__ = name
    evaluate.__doc__ = f"{name} of a pair >= 0."
    return evaluate


phi1m = _factor("phi1m")
phi2m = _factor("phi2m")
descent_factor = _factor("descent_factor")
flight_factor = _factor("flight_factor")
range_factor = _factor("range_factor")
range_loss = _factor("range_loss")
max_range_factor = _factor("max_range_factor")
acot = _factor("acot")
_grown_balance = _factor("grown_balance")


def phi0m(z, lanes):
    """exp(-z), z below 512."""
    if extent(z.x)[1] < _END:
        return Pair(*fading(z.x, z.rest))
    here = z.x < _END
    lanes.keep(here)
    return Pair(*fading(*(part if part is None else np.where(here, part, 0.0) for part in (z.x, z.rest))))


def range_balance(b, lanes):
    """b exp(-T)/(T - b), T = (1 + b)(1 - exp(-T)): exp(-b) times what grows like b/e."""
    return mul(phi0m(b, lanes), _grown_balance(b))
