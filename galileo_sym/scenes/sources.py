"""Where the points of a plan take its factors and ends from: made when they are asked for."""

from __future__ import annotations

import numpy as np

from galileo_sym.scenes.operations import make_steps
from galileo_sym.scenes.plan import needed
from galileo_sym.scenes.points import own_shape, placed, spread


def cut(value, part):
    """Return what of an array, or of all in a tuple, belongs to a part; what does not vary along a dimension stays.

    Parameters
    ----------
    value : ndarray, scalar, None or nested tuple of these
    part : tuple of slice, or Ellipsis
        A slice along each dimension; Ellipsis for all.
    """
    if part is ... or value is None:
        return value
    if isinstance(value, tuple):
        cuts = [cut(one, part) for one in value]
        return type(value)(*cuts) if hasattr(value, "_fields") else tuple(cuts)
    if np.ndim(value) == 0:
        return value
    return value[tuple(slice(None) if length == 1 else one for length, one in zip(value.shape, part, strict=True))]


def started(plan, axes):
    """Return axes with the start in place of times before it, where motions end."""
    if plan.arrival is None or "t" not in axes:
        return axes
    return {**axes, "t": np.where(axes["t"] < 0.0, 0.0, axes["t"])}


def shown(plan, result, source, made, axes, shape, out, dtype):
    """Return an output: placed at its points, or what a source has of it on fewer axes, spread over all."""
    if set(result.axes) < set(plan.over):
        return spread(source.own(result).astype(dtype), shape, out)
    return placed(plan, result, made, axes, shape, out, dtype)


class Fresh:
    """Makes what is asked for, once.

    Parameters
    ----------
    plan : Plan
    axes : dict of str to ndarray
        In their domains, times not before the start; of equal dimension.
    operations : dict of str to callable
        What carries out the steps.
    """

    def __init__(self, plan, axes, operations):
        self._plan, self._axes, self._operations, self._made = plan, axes, operations, {}

    def _make(self, steps, axes):
        missing = [step for step in steps if step.name not in self._made]
        self._made.update(make_steps(missing, axes, self._operations, self._made))

    def own(self, result):
        """Return a result on the axes it depends on, not on times: in float64."""
        self._make(needed(self._plan.steps, [result]), self._axes)
        dimensions = next(iter(self._axes.values())).ndim
        shape = own_shape(self._axes, result.axes, dimensions)
        return placed(self._plan, result, self._made, self._axes, shape, None, np.float64)

    def factors(self, part=...):
        """Return what the steps give, by name, at a part of the times: slices along all dimensions, or Ellipsis."""
        some = {name: cut(values, part) if name == "t" else values for name, values in self._axes.items()}
        self._make(self._plan.steps, some)
        return self._made
