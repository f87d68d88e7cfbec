"""Where the points of a plan take its factors and ends from: made when they are asked for."""

from __future__ import annotations

import numpy as np

from galileo_sym.scenes.operations import make_steps
from galileo_sym.scenes.plan import needed
from galileo_sym.scenes.points import all_placed, own_shape, placed, spread


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


def shown(plan, results, source, made, axes, shape, outs, dtype):
    """Return outputs: placed at their points, or what a source has of them on fewer axes, spread over all."""
    given = dict(zip(results, outs, strict=True))
    everywhere = [result for result in results if not set(result.axes) < set(plan.over)]
    targets = [given[result] for result in everywhere]
    placed_ones = all_placed(plan, everywhere, made, axes, shape, targets, dtype)
    found = dict(zip(everywhere, placed_ones, strict=True))
    for result in results:
        if result not in found:
            found[result] = spread(source.own(result).astype(dtype), shape, given[result])
    return [found[result] for result in results]


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

    def own(self, result):
        """Return a result on the axes it depends on, not on times: in float64."""
        missing = [step for step in needed(self._plan.steps, [result]) if step.name not in self._made]
        self._made = make_steps(missing, self._axes, self._operations, self._made)
        dimensions = next(iter(self._axes.values())).ndim
        shape = own_shape(self._axes, result.axes, dimensions)
        return placed(self._plan, result, self._made, self._axes, shape, None, np.float64)

    def factors(self, part=...):
        """Return what the steps give, by name, at a part of the grid: slices along all dimensions, or Ellipsis."""
        known = {name: cut(value, part) for name, value in self._made.items()}
        axes = {name: cut(values, part) for name, values in self._axes.items()}
        missing = [step for step in self._plan.steps if step.name not in known]
        return make_steps(missing, axes, self._operations, known)
