"""Strata of the launch angles: shares of the largest range, up to the last floats below it."""

import math
import sys

from .enclosure import nearest_float
from .reference import reference
from .sampling import grid_end, step
from .stratum import NEAR, Stratum, some_zero, tiny

_CLEAR = 2  # places that the emitted largest range, or its rounding, may be off


def _aim(draw, has, share=None, **given):
    """Typical values of v, g and k, save those given, and a share of the largest range they allow."""
    values = {"v": draw.magnitude(0, 8), "g": draw.magnitude(0, 5), "k": draw.magnitude(-5, 3), **given}
    values["k"] *= "k" in has
    most = _most(**values)
    return {**values, "r": max(0.0, min((draw.uniform(0.01, 0.999) if share is None else share) * most, most))}


def _most(v, g, k):
    """The largest float that is surely below the largest range."""
    (exact,) = reference("projectile.max_range", {"v": v, "g": g, "k": k})
    return step(min(nearest_float(exact), sys.float_info.max), -_CLEAR)


def _near(draw, has, **given):
    """Ranges within 64 places of the largest."""
    aimed = _aim(draw, has, 1.0, **given)
    return {**aimed, "r": max(0.0, step(aimed["r"], -draw.integer(0, NEAR)))}


def _approaching(draw, has, **given):
    """Ranges at every binary distance below the largest, where the angles go with the square root of it."""
    return _aim(draw, has, 1.0 - draw.magnitude(-50, -4), **given)


def _wide(draw, has):
    """Arguments of any size; k v/g of moderate size in half of them."""
    speed, weight = draw.magnitude(-500, 500), draw.magnitude(-500, 500)
    rate = draw.magnitude(-500, 500)
    if draw.chance(0.5):
        rate = min(max(weight / speed, 1e-300), 1e300) * draw.magnitude(-20, 20)
    return _aim(draw, has, v=speed, g=weight, k=rate)


def _range_ends(draw, has):
    """Ranges among the subnormals, or close to overflow."""
    small = draw.chance(0.5)
    speed, weight = ((-536, -500), (0, 30)) if small else ((490, 512), (-20, 0))
    alike = draw.magnitude(490, 560) if small else draw.magnitude(-530, -490)
    return _aim(draw, has, v=draw.magnitude(*speed), g=draw.magnitude(*weight), k=alike)


def _grid(draw, has):
    """k v/g at the ends of the intervals of tables."""
    unit = math.ldexp(1.0, draw.integer(-3, 3))
    return _aim(draw, has, v=1.0, g=1.0 / unit, k=grid_end(draw) / unit)


TABLES = {
    "projectile.launch_angles": (
        Stratum("typical", (), _aim),
        Stratum("short", (), lambda draw, has: _aim(draw, has, draw.magnitude(-1000, -8))),
        Stratum("approaching-maximum", (), _approaching),
        Stratum("near-maximum", (), _near),
        Stratum("extreme", (), _wide),
        Stratum("range-ends", (), _range_ends),
        Stratum("tiny-drag", ("k",), lambda draw, has: _aim(draw, has, k=draw.magnitude(*tiny(draw)))),
        Stratum("huge-drag", ("k",), lambda draw, has: _aim(draw, has, k=draw.magnitude(4, 900))),
        Stratum("huge-drag-near-maximum", ("k",), lambda draw, has: _near(draw, has, k=draw.magnitude(4, 100))),
        Stratum("zero-drag", ("k",), lambda draw, has: _aim(draw, has, k=some_zero(draw, -5, 3))),
        Stratum("interval-ends", ("k",), _grid),
    )
}
