"""Where errors of scenes are looked for: constants and axes by stratum, and certain references at their points."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from flint import arb

from galileo_sym import chord, projectile
from galileo_sym.generated._graphs import SYSTEMS
from galileo_sym.verify.enclosure import INFINITE, ZERO, Enclosure, with_bits
from galileo_sym.verify.reference import reference

SIDE = 16  # values of each axis
_HALF_PI = np.pi / 2
_BITS = 400
_BESIDE = 2.0**-50  # share of the time of an arrival by which a time differs from it where speeds are held: these jump
ENDS = {"chord": "arrival", "projectile": "landing"}
_ARRIVAL = {"chord": "descent_time", "projectile": "flight_time"}
_NEAR = 1.0 + np.array([-3.0, -1.0, -0.5, 0.0, 1.0, 2.0, 3.0, 8.0]) * 2.0**-52  # of the time of an arrival


def _typical(draw, name):
    ranges = {"t": (-3.0, 1.5), "g": (0.0, 2.0), "v": (0.0, 3.0), "diameter": (-1.0, 2.0)}
    return 10.0 ** draw.uniform(*ranges.get(name, (-2.0, 0.5)))


def _extreme(draw, name):
    return 2.0 ** draw.uniform(-300.0, 300.0)


def _angles(draw, system, most):
    """Angles up to the one from which a bead rests, some of them next to it, next to 0 or next to a right angle."""
    beside = np.nextafter(most, 0.0) - np.arange(5) * 2.0**-52
    away = most * (1.0 - 2.0 ** draw.uniform(-47.0, -4.0, 4))
    tiny = 2.0 ** draw.uniform(-900.0, -8.0, 3)
    plain = most * draw.uniform(0.0, 1.0, SIDE - 12)
    found = np.concatenate([beside[:5], away, tiny, plain])
    return found * draw.choice([-1.0, 1.0], found.size) if system == "chord" else found


class Stratum(NamedTuple):
    """How constants are drawn, by name; and for motions that end which angles and times there are.

    ``angles`` takes the draw, the system and the angle from which a bead rests; ``times`` the draw, the times of
    arrival at the angles and some times of any size. ``forces`` are those without which there is no such motion.
    """

    constant: Callable
    ends: bool = False
    angles: Callable | None = None
    times: Callable | None = None
    forces: tuple = ()


def _at_rest(draw, system, most):
    """Angles from the one from which a bead rests up to a right angle."""
    beside = most + np.arange(1.0, 9.0) * 2.0**-52
    found = np.concatenate([beside, [_HALF_PI], draw.uniform(beside[-1], _HALF_PI, SIDE - 9)])
    return found * draw.choice([-1.0, 1.0], found.size)


def _about_arrival(draw, arrivals, times):
    """Times next to arrivals at some of the angles, and long after."""
    beside = arrivals[: _NEAR.size] * _NEAR
    return np.concatenate([beside, arrivals[_NEAR.size :] * 10.0 ** draw.uniform(-1.0, 6.0, SIDE - _NEAR.size)])


def _early(draw, arrivals, times):
    return np.concatenate([-times[: SIDE - 4], [-0.0, -5e-324, -1e300, 0.0]])


STRATA = {
    "typical": Stratum(_typical),
    "extreme": Stratum(_extreme),
    "arrived": Stratum(_typical, True, _angles, _about_arrival),
    "before 0": Stratum(_typical, True, _angles, _early),
    "at rest": Stratum(_typical, True, _at_rest, lambda draw, arrivals, times: times, ("mu",)),
}


def strata(forces):
    """Return the names of the strata that there are with some forces."""
    return [name for name, stratum in STRATA.items() if set(stratum.forces) <= set(forces)]


def draw_scene(system, forces, stratum, draw):
    """Return constants and axes of a scene.

    Parameters
    ----------
    system : str
    forces : tuple of str
        Arguments of the forces that act.
    stratum : str
        A key of ``STRATA``.
    draw : numpy.random.Generator
    """
    one = STRATA[stratum]
    needed = {name for row in SYSTEMS[system]["outputs"].values() for name in row["arguments"]} - {"t", "theta"}
    constants = {name: float(one.constant(draw, name)) for name in sorted({*needed, *forces})}
    if "mu" in constants:
        constants["mu"] = float(_typical(draw, "mu"))
    most = float(np.arctan2(1.0, constants["mu"])) if "mu" in constants else _HALF_PI
    theta = (one.angles or _angles)(draw, system, most)
    t = np.array([one.constant(draw, "t") for _ in range(SIDE)])
    arrivals = _arrivals(system, theta, constants, forces)
    if one.times:
        t = one.times(draw, arrivals, t)
    elif system == "projectile":  # half of them at landing, where heights cancel
        t = np.where(np.isfinite(arrivals) & (np.arange(SIDE) % 2 == 0), arrivals, t)
    return constants, {"t": t, "theta": theta}


def _arrivals(system, theta, constants, forces):
    """The times at which motions end, as floats."""
    module = {"chord": chord, "projectile": projectile}[system]
    own = {"chord": ("diameter", "g"), "projectile": ("v", "g")}[system]
    with np.errstate(all="ignore"):
        return getattr(module, _ARRIVAL[system])(theta, **{name: constants[name] for name in (*own, *forces)})


def exact(system, output, point):
    """Return a certain enclosure of an output at a point, given with all constants."""
    row = SYSTEMS[system]["outputs"][output]
    names = (*row["arguments"], *SYSTEMS[system]["forces"].values())
    return reference(row["function"], {name: float(point.get(name, 0.0)) for name in names})[row["index"]]


@with_bits(_BITS)
def _bottom(point):
    """The end of a chord of a circle of some diameter, in Thales' triangle: the length of the chord, and x and y."""
    sine, cosine = arb(point["theta"]).sin_cos()
    along = arb(point["diameter"]) * cosine
    return {"distance": Enclosure(along), "x": Enclosure(along * sine), "y": Enclosure(along * cosine), "speed": ZERO}


def _landed(point):
    return {"x": exact("projectile", "range", point), "y": ZERO, "vx": ZERO, "vy": ZERO}


_STOPPED = {"chord": _bottom, "projectile": _landed}
_SPEEDS = ("speed", "vx", "vy")
ENDING = {"chord": ("x", "y", "distance", "speed"), "projectile": ("x", "y", "vx", "vy")}


def exact_ended(system, output, point):
    """Return a certain enclosure of an output of a motion that ends; None for a speed next to its jump.

    Before its start and at rest nothing has moved, and speeds are 0; after its arrival a bead is at the end of its
    chord, a projectile where its range ends.
    """
    start = {**point, "t": max(point["t"], 0.0)}
    if point["t"] < 0.0:
        return ZERO if output in _SPEEDS else exact(system, output, start)
    arrival = exact(system, _ARRIVAL[system], point)
    if arrival is INFINITE:
        return exact(system, output, start)
    if output in _SPEEDS and abs(arb(point["t"]) / arrival.ball - 1) < _BESIDE:
        return None
    return _STOPPED[system](point)[output] if arb(point["t"]) > arrival.ball else exact(system, output, start)
