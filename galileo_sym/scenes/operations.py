"""What each operation of a plan does: the arithmetic of the emitted kernels, compiled where there is the extension."""

from __future__ import annotations

import numpy as np

from galileo_sym import _backend
from galileo_sym.generated import _angle, _primitives, _scaled
from galileo_sym.generated._kernel import quiet
from galileo_sym.scenes.factors import (
    Factor,
    Rest,
    halved_factor,
    parted_factor,
    rounded_factor,
    settled,
    sliding,
    stored_factor,
)
from galileo_sym.scenes.plan import PRIMITIVES


def _constant(hi, lo, e):
    return _scaled.Scaled(np.float64(hi), np.float64(lo), np.int32(e))


def _pair(value):
    """The pair of a step: of a driving force, where the bead slides."""
    return value.force if isinstance(value, Rest) else value


def _of_pairs(function):
    return lambda *operands: function(*map(_pair, operands))


def _compiled(name, made):
    """The ufunc of a step, on all numbers of its operands one after the other."""
    ufunc = getattr(_backend.EXTENSION, f"_step_{name}")
    return lambda *operands: made(*ufunc(*(number for operand in operands for number in _flat(_pair(operand)))))


def _flat(operand):
    """The numbers of a pair or of an angle; an array as it is."""
    if isinstance(operand, _angle.Angle):
        return (*operand[:-2], *operand.s, *operand.c)
    return operand if isinstance(operand, tuple) else (operand,)


def _turned(x, x2, x3, complement, sign, *pairs):
    return _angle.Angle(x, x2, x3, complement, sign, _scaled.Scaled(*pairs[:3]), _scaled.Scaled(*pairs[3:]))


def _factor(*found):
    """A factor of what the extension gives: doubles, and where they do not serve."""
    *parts, odd = found
    return Factor(tuple(parts), odd if odd.any() else None)


BY_NUMPY = {
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


def _settled(factor, at_rest, *forces):
    return settled(*factor.parts, factor.odd, at_rest, *forces)


def _by_extension():
    """What the extension does of the operations, with the same bits."""
    driving, rounded = _compiled("driving", _scaled.Scaled), _compiled("round", _factor)
    pairs = ("load", "mul", "div", "add", "sub", "sqrt", *PRIMITIVES)
    return {
        "angle": _compiled("angle", _turned),
        "driving": lambda turned, friction: sliding(driving(turned, friction)),
        "round": lambda value, *resting: _settled(rounded(value), *resting),
        **{name: _compiled(name, _factor) for name in ("halves", "parts")},
        **{name: _compiled(name, _scaled.Scaled) for name in pairs},
    }


OPERATIONS = BY_NUMPY if _backend.EXTENSION is None else {**BY_NUMPY, **_by_extension()}


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
