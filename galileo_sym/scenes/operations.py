"""What each operation of a plan does in NumPy: by the arithmetic of the emitted kernels."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from galileo_sym.generated import _angle, _primitives, _scaled
from galileo_sym.generated._kernel import quiet
from galileo_sym.generated._scaled import Scaled
from galileo_sym.scenes.plan import PRIMITIVES

_MOST = 500  # exponents of factors whose product is sure to be a normal number
_HALF = 134217729.0  # 2**27 + 1: splits a double into 26 bits and the rest


class Rest(NamedTuple):
    """A driving force, 1 in place of what is not positive, and where that is."""

    force: Scaled
    held: np.ndarray


class Factor(NamedTuple):
    """Doubles, one array or two; and where they do not serve: out of range or infinite. None: they serve everywhere."""

    parts: tuple
    odd: np.ndarray | None


def _constant(hi, lo, e):
    return Scaled(np.float64(hi), np.float64(lo), np.int32(e))


def _driving(turned, friction):
    force = _angle.driving(turned, friction)
    held = force.hi <= 0.0
    one = Scaled(np.where(held, 1.0, force.hi), np.where(held, 0.0, force.lo), np.where(held, 0, force.e))
    return Rest(one, held)


def _in_range(value):
    """A pair with 0 in place of what is out of range, and where that is; None if nothing is."""
    hi, lo, e = np.broadcast_arrays(*value)
    odd = ((e < -_MOST) | (e > _MOST)) & (hi != 0.0)
    if not odd.any():
        return value.hi, value.lo, np.where(hi == 0.0, 0, e), None
    return np.where(odd, 0.0, hi), np.where(odd, 0.0, lo), np.where(odd, 0, e), odd


def _round(value, at_rest, *forces):
    hi, _, e, odd = _in_range(value)
    number = np.ldexp(hi, e)
    for force in forces:
        if force.held.any():
            number = np.where(force.held, at_rest, number)
            odd = None if odd is None else odd & ~force.held
    return Factor((number,), odd)


def _store(value, at_rest, *forces):
    number = _scaled.store(value)
    for force in forces:
        number = np.where(force.held, at_rest, number)
    return Factor((number,), None)


def _halves(value):
    hi, lo, e, odd = _in_range(value)
    high = _HALF * hi
    high = high - (high - hi)
    return Factor((np.ldexp(high, e), np.ldexp((hi - high) + lo, e)), odd)


def _parts(value):
    hi, lo, e, odd = _in_range(value)
    return Factor((np.ldexp(hi, e), np.ldexp(lo, e)), odd)


def _pair(value):
    """The pair of a step: of a driving force, where the bead slides."""
    return value.force if isinstance(value, Rest) else value


def _of_pairs(function):
    return lambda *operands: function(*map(_pair, operands))


OPERATIONS = {
    "load": _scaled.load,
    "constant": _constant,
    "angle": _angle.angle,
    "sine": _angle.sine,
    "cosine": _angle.cosine,
    "driving": _driving,
    "scale": lambda a, k: _scaled.scale(_pair(a), k),
    "round": lambda value, at_rest, *forces: _round(_pair(value), at_rest, *forces),
    "store": lambda value, at_rest, *forces: _store(_pair(value), at_rest, *forces),
    "halves": _of_pairs(_halves),
    "parts": _of_pairs(_parts),
    **{name: _of_pairs(getattr(_scaled, name)) for name in ("mul", "div", "add", "sub", "sqrt")},
    **{name: _of_pairs(getattr(_primitives, name)) for name in PRIMITIVES},
}


def factors(plan, axes, operations=OPERATIONS):
    """Return what each step of a plan gives, by name.

    Parameters
    ----------
    plan : Plan
    axes : dict of str to ndarray
        In their domains.
    operations : dict of str to callable, optional
        What carries out the steps.
    """
    made = {}
    with quiet():
        for step in plan.steps:
            if step.operation in ("load", "angle"):
                (operand,) = step.operands
                operands = (axes[operand] if isinstance(operand, str) else np.float64(operand),)
            else:
                operands = (made[x] if isinstance(x, str) else x for x in step.operands)
            made[step.name] = operations[step.operation](*operands)
    return made
