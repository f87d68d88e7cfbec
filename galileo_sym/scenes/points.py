"""The points of an output in NumPy: one multiplication of two factors, or what its result says."""

from __future__ import annotations

import numpy as np

from galileo_sym import _backend
from galileo_sym.generated._functions import FUNCTIONS
from galileo_sym.generated._kernel import DOMAINS, quiet

_BLOCK = 32768  # points at a time where an output takes several operations: a few arrays stay in the cache
_ONE = (1.0, 0.0)


def own_shape(axes, names, dimensions):
    """Return the shape over some of the axes, with 1 along the others."""
    return np.broadcast_shapes((1,) * dimensions, *(axes[name].shape for name in names))


def placed(plan, result, made, axes, shape, out, dtype):
    """Return an output, computed on the axes it depends on, in the shape of all.

    Parameters
    ----------
    plan : Plan
    result : Result
    made : dict of str to object
        What the steps of the plan give.
    axes : dict of str to ndarray
        In their domains.
    shape : tuple of int
    out : ndarray or None
        Where it is written; None for an array of its own, or a view where some axes do not matter.
    dtype : numpy.dtype
        Of an array of its own.
    """
    (found,) = all_placed(plan, [result], made, axes, shape, [out], dtype)
    return found


def all_placed(plan, results, made, axes, shape, outs, dtype):
    """Return several outputs as `placed` does; one call gives those of a plan that are of the same one."""
    targets, calls = {}, {}
    for result, out in zip(results, outs, strict=True):
        own = own_shape(axes, result.axes, len(shape))
        target = targets[result] = out if out is not None and own == shape else np.empty(own, dtype)
        if result.operation == "call":
            calls.setdefault(plan.companions.get(result.output, result.output), []).append((result, target))
        else:
            _POINTS[result.operation](plan, result, made, axes, target)
    for members in calls.values():
        _call(plan, members, axes)
    return [spread(targets[result], shape, out) for result, out in zip(results, outs, strict=True)]


def spread(target, shape, out):
    """Return an array along axes that it does not depend on, too: a view, or written out."""
    if target is out or (out is None and target.shape == shape):
        return target
    if out is None:
        return np.broadcast_to(target, shape)
    np.copyto(out, target, casting="same_kind")
    return out


def _arguments(plan, result, axes):
    """The arguments of the public function of an output, in order; harmless ones for what it does not depend on."""
    constants, domains = dict(plan.constants), dict(plan.domains)
    return [
        axes[name] if name in result.axes else constants.get(name, DOMAINS[domains[name]][1])
        for name in result.arguments
    ]


def _number(plan, result, made, axes, target):
    target[...] = result.operands[0]


def _call(plan, members, axes):
    """A call of the public function of some results, written to their targets."""
    result, target = members[0]
    name, out = result.ufunc, target
    if len(members) > 1:
        targets = {member.ufunc: found for member, found in members}
        name, *each = next(names for names in FUNCTIONS[result.function]["ufuncs"].values() if name in names)
        out = tuple(targets.get(one) for one in each)
    _backend.ufunc(name)(*_arguments(plan, result, axes), out=out, casting="same_kind")


def _copy(plan, result, made, axes, target):
    (factor,) = (made[name] for name in result.operands)
    np.copyto(target, factor.parts[0], casting="same_kind")


def _product(plan, result, made, axes, target):
    one, other = (made[name] for name in result.operands)
    np.multiply(one.parts[0], other.parts[0], out=target, casting="same_kind")
    _put_odd(plan, result, [one, other], axes, target)


def _sum(plan, result, made, axes, target):
    """Sum of the leading parts of addends, whose products are exact, and of what is left of them."""
    addends = [(sign, [made[name] for name in names]) for sign, *names in result.operands]
    with quiet():  # products of rests may underflow, which says nothing of the sum
        (_sum_in_passes if _backend.EXTENSION is None else _sum_at_once)(addends, target)
    _put_odd(plan, result, [factor for _, found in addends for factor in found], axes, target)


def _sum_at_once(addends, target):
    """By the extension: a b + c d, each in two parts."""
    parts = [part for sign, found in addends for part in _two_pairs(sign, found)]
    _backend.EXTENSION._sum_of_products(*parts, out=target, casting="same_kind")


def _two_pairs(sign, found):
    """The parts of the two factors of an addend, or of one and 1; the first takes the sign."""
    first, *others = [factor.parts for factor in found]
    (other,) = others or [_ONE]
    return [*(first if sign > 0 else map(np.negative, first)), *other]


def _sum_in_passes(addends, target):
    """By NumPy's operations, block by block."""
    blocks = _blocks(target)
    room = np.empty((3, *target[blocks[0]].shape)) if blocks else None
    for block in blocks:
        high, low, more = (room[k, : len(target[block])] if target.ndim else room[k, ...] for k in range(3))
        for number, (sign, found) in enumerate(addends):
            parts = [_part(part, block) for factor in found for part in factor.parts]
            _ADDENDS[len(found)](_SIGNED[sign] if number else None, parts, high, low, more)
        np.add(high, low, out=target[block], casting="same_kind")


def _pair(sign, parts, high, low, more):
    """A pair, to what is there already."""
    for part, total in zip(parts, (high, low), strict=True):
        np.copyto(total, part) if sign is None else sign(total, part, out=total)


def _two_factors(sign, parts, high, low, more):
    """The product of two factors in halves: to what is there already, or if this is the first addend instead of it."""
    one, one_rest, other, other_rest = parts
    if sign is None:
        np.multiply(one, other, out=high)
        np.multiply(one, other_rest, out=low)
    else:
        sign(high, np.multiply(one, other, out=more), out=high)
        sign(low, np.multiply(one, other_rest, out=more), out=low)
    np.multiply(one_rest, other + other_rest, out=more)
    (sign or np.add)(low, more, out=low)


_SIGNED = {1: np.add, -1: np.subtract}
_ADDENDS = {1: _pair, 2: _two_factors}  # by number of factors


def _blocks(target):
    """Slices of rows, of some thousand points each; all of what has no rows."""
    if target.ndim == 0:
        return [...]
    rows = max(1, _BLOCK * len(target) // max(target.size, 1))
    return [slice(start, start + rows) for start in range(0, len(target), rows)]


def _part(part, block):
    """What of a factor belongs to a slice of rows."""
    return part if block is ... or np.ndim(part) == 0 or len(part) == 1 else part[block]


def _put_odd(plan, result, found, axes, target):
    """By the public function, where factors do not serve."""
    masks = [factor.odd for factor in found if factor.odd is not None and factor.odd.any()]
    if not masks:
        return
    odd = np.broadcast_to(np.logical_or.reduce(np.broadcast_arrays(*masks)), target.shape)
    arguments = (np.broadcast_to(x, target.shape)[odd] for x in _arguments(plan, result, axes))
    target[odd] = _backend.ufunc(result.ufunc)(*arguments)


_POINTS = {"number": _number, "copy": _copy, "product": _product, "sum": _sum}
