"""Axes as arrays that broadcast to the grid, and the arrays that outputs are written to."""

import numpy as np

from galileo_sym._types import DOUBLE, SINGLE, as_operand, common_dtype
from galileo_sym.generated._kernel import DOMAINS, admit, quiet
from galileo_sym.generated._tables import HALF_PI

_ANGLES = ("chord angle", "elevation")


def axis_arrays(plan, given, grid):
    """Return the axes as arrays of float64, the dtype of the outputs, and their shape.

    Parameters
    ----------
    plan : Plan
    given : dict of str to array_like
        Values along each axis of the plan.
    grid : bool
        Whether outputs are over the outer grid; else the arrays broadcast as they are.
    """
    arrays = {name: np.asarray(as_operand(given[name])) for name in plan.over}
    dtype = common_dtype([np.asarray(x) for x in arrays.values()])
    domains = dict(plan.domains)
    wide = {name: _widened(array, domains[name]) for name, array in arrays.items()}
    shapes = [array.shape for array in wide.values()]
    if grid:
        shape = tuple(length for one in shapes for length in one)
        before = np.cumsum([0, *map(len, shapes)])
        new = [(1,) * b + one + (1,) * (len(shape) - b - len(one)) for b, one in zip(before, shapes, strict=False)]
    else:
        shape = np.broadcast_shapes(*shapes)
        new = [(1,) * (len(shape) - len(one)) + one for one in shapes]
    return {name: a.reshape(s) for (name, a), s in zip(wide.items(), new, strict=True)}, dtype, shape


def _widened(array, domain):
    """An axis as float64; the float32 next to pi/2, which lies above it, counts as pi/2."""
    wide = array.astype(DOUBLE, copy=False)
    if array.dtype == SINGLE and domain in _ANGLES:
        return np.where(np.abs(array) == np.float32(HALF_PI[0]), np.copysign(HALF_PI[0], wide), wide)
    return wide


def admitted_axes(plan, axes):
    """Return the axes with harmless values where there is no result, and by axis where that is, if anywhere.

    What is outside its domain raises 'invalid'. Where the motion has an end, times before its start are admitted.
    """
    domains = dict(plan.domains)
    admitted, void = {}, {}
    for name, values in axes.items():
        domain = "real" if name == "t" and plan.arrival is not None else domains[name]
        if _is_inside(values, domain):
            admitted[name] = values
            continue
        (admitted[name],), mask = admit((values, domain))
        if mask.any():
            void[name] = mask
    return admitted, void


def _is_inside(values, domain):
    """Whether all values are in a domain, an interval: their extremes are, and not NaN."""
    inside = DOMAINS[domain][0]
    with quiet():
        return values.size > 0 and bool(inside(values.min()) and inside(values.max()))


def checked_outs(out, count, shape):
    """Return where outputs are written, one for each: None for an array to be made.

    Raises
    ------
    TypeError
        Unless each is an array of float64 or float32 of that shape.
    """
    if out is None:
        return (None,) * count
    targets = (out,) if isinstance(out, np.ndarray) else tuple(out)
    if len(targets) != count:
        raise TypeError(f"out holds {len(targets)} arrays: the scene has {count} outputs")
    for target in targets:
        if target is not None and not (isinstance(target, np.ndarray) and target.dtype in (DOUBLE, SINGLE)):
            raise TypeError("out must hold arrays of float64 or float32")
        if target is not None and target.shape != shape:
            raise TypeError(f"an array of out has the shape {target.shape}: the grid has {shape}")
    return targets
