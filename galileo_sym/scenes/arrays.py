"""Axes as arrays that broadcast to the grid, and the arrays that outputs are written to."""

from itertools import accumulate
from math import isnan, prod

import numpy as np

from galileo_sym._types import DOUBLE, SINGLE, as_operand, common_dtype
from galileo_sym.generated._kernel import DOMAINS, admit, quiet
from galileo_sym.generated._tables import HALF_PI

_ANGLES = ("chord angle", "elevation")


class Axes:
    """Axes as they were given, laid out along the dimensions of the outputs.

    Parameters
    ----------
    plan : Plan
    given : dict of str to array_like
        Values along each axis of the plan; dask arrays are computed where their values are asked for.
    grid : bool
        Whether outputs are over the outer grid of the axes; else the arrays broadcast as they are.

    Attributes
    ----------
    shape : tuple of int
        Of the outputs.
    dtype : numpy.dtype
        Of the outputs.
    shares : bool
        Whether a value of some axis serves several points.
    """

    def __init__(self, plan, given, grid):
        self._given = {name: _as_array(as_operand(given[name])) for name in plan.over}
        self.dtype = common_dtype([np.empty(0, array.dtype) for array in self._given.values()])
        self._domains = dict(plan.domains)
        shapes = {name: array.shape for name, array in self._given.items()}
        if grid:
            self.shape = tuple(length for shape in shapes.values() for length in shape)
            ends = np.cumsum([len(shape) for shape in shapes.values()])
        else:
            self.shape = np.broadcast_shapes(*shapes.values())
            ends = [len(self.shape)] * len(shapes)
        points = prod(self.shape)
        self.shares = grid or any(1 < prod(shape) < points for shape in shapes.values())
        self._first = {name: int(end) - len(shapes[name]) for name, end in zip(shapes, ends, strict=True)}

    def dimensions(self, names):
        """Return the dimensions along which some axes vary, in order: a tuple."""
        found = {
            self._first[name] + place
            for name in names
            for place, length in enumerate(self._given[name].shape)
            if length != 1
        }
        return tuple(sorted(found))

    def lazy(self, name):
        """Whether an axis is a dask array."""
        return is_lazy(self._given[name])

    def bounds(self, dimension):
        """Return where the chunks of dask arrays along a dimension begin and end: a sorted list."""
        found = {0, self.shape[dimension]}
        for name, array in self._given.items():
            place = dimension - self._first[name]
            if is_lazy(array) and 0 <= place < len(array.shape) and array.shape[place] != 1:
                found.update(accumulate(array.chunks[place]))
        return sorted(found)

    def all_values(self):
        """Return all of each axis, as `values` does, by name."""
        return {name: self.values(name) for name in self._given}

    def values(self, name, block=None):
        """Return an axis as float64 with the dimensions of the outputs: all of it, or what belongs to a block.

        Parameters
        ----------
        name : str
        block : tuple of (int, int), optional
            First index and end along each dimension.
        """
        array, first = self._given[name], self._first[name]
        if block is not None:
            own = block[first : first + len(array.shape)]
            pairs = zip(array.shape, own, strict=True)
            array = array[tuple(slice(None) if length == 1 else slice(*span) for length, span in pairs)]
        array = np.asarray(array)
        after = len(self.shape) - first - array.ndim
        return _widened(array, self._domains[name]).reshape((1,) * first + array.shape + (1,) * after)


def is_lazy(array):
    """Whether an array is one of dask's."""
    return hasattr(array, "__dask_graph__") and bool(getattr(array, "chunks", None))


def _as_array(operand):
    """An operand as an array; one of dask as it is.

    Raises
    ------
    ValueError
        For a dask array of unknown length.
    """
    if not is_lazy(operand):
        return np.asarray(operand)
    if any(map(isnan, operand.shape)):  # NaN stands for unknown
        raise ValueError("a dask array has chunks of unknown length: call its compute_chunk_sizes() first")
    return operand


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
