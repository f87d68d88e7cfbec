"""What each operation of a plan does in NumPy: by the arithmetic of the emitted kernels."""

from __future__ import annotations

import numpy as np

from galileo_sym.generated import _angle, _primitives, _scaled
from galileo_sym.generated._kernel import quiet
from galileo_sym.scenes.factors import Rest, halved_factor, parted_factor, rounded_factor, sliding, stored_factor
from galileo_sym.scenes.plan import PRIMITIVES


def _constant(hi, lo, e):
    return _scaled.Scaled(np.float64(hi), np.float64(lo), np.int32(e))


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
    "driving": lambda turned, friction: sliding(_angle.driving(turned, friction)),
    "scale": lambda a, k: _scaled.scale(_pair(a), k),
    "round": lambda value, at_rest, *forces: rounded_factor(_pair(value), at_rest, *forces),
    "store": lambda value, at_rest, *forces: stored_factor(_pair(value), at_rest, *forces),
    "halves": _of_pairs(halved_factor),
    "parts": _of_pairs(parted_factor),
    **{name: _of_pairs(getattr(_scaled, name)) for name in ("mul", "div", "add", "sub", "sqrt")},
    **{name: _of_pairs(getattr(_primitives, name)) for name in PRIMITIVES},
}


def make_steps(steps, axes, operations, known):
    """Return what each of some steps gives, by name.

    Parameters
    ----------
    steps : iterable of Step
        In order.
    axes : dict of str to ndarray
        In their domains.
    operations : dict of str to callable
        What carries out the steps.
    known : dict of str to object
        What earlier steps gave.
    """
    made = dict(known)
    with quiet():
        for step in steps:
            if step.operation in ("load", "angle"):
                (operand,) = step.operands
                operands = (axes[operand] if isinstance(operand, str) else np.float64(operand),)
            else:
                operands = (made[x] if isinstance(x, str) else x for x in step.operands)
            made[step.name] = operations[step.operation](*operands)
    return made
