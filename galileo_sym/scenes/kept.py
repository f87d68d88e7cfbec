"""What a plan gives on fewer axes than all, made once for all blocks of a grid."""

from __future__ import annotations

from math import prod

import numpy as np

from galileo_sym import _backend
from galileo_sym.scenes.arrays import admitted_axes
from galileo_sym.scenes.operations import OPERATIONS, make_steps
from galileo_sym.scenes.plan import names_in
from galileo_sym.scenes.points import own_shape, placed
from galileo_sym.scenes.sources import cut, started

CALL = {"c": 24, "numpy": 1500}[_backend.NAME]  # bytes a point while a public function is called
_MAKING = 400  # bytes an element that a step takes at most while it is carried out
_STEP = 32  # bytes an element of what a step gives, and of what is left over from it
_LEFT = {"round": 9, "store": 9, "angle": 64, "halves": 17, "parts": 17}  # bytes an element that are kept; pairs: 24


class Kept:
    """Factors and ends of a plan, by blocks of its grid: each made once, and kept as long as it is needed.

    Blocks are asked for in the order of their points: the last dimension runs fastest.

    Parameters
    ----------
    plan : Plan
    axes : Axes
        Of the whole grid.
    """

    def __init__(self, plan, axes):
        self.plan, self.axes, self._stores = plan, axes, {}
        used = names_in(tuple(result.operands for result in plan.all_results))
        for step in plan.steps:
            used.update(name for name in names_in(step.operands) if self._axes_of(name) != step.axes)
        groups = {}
        for step in plan.steps:
            groups.setdefault(step.axes, []).append(step)
        self._groups = {
            names: (steps, [step for step in steps if step.name in used])
            for names, steps in sorted(groups.items(), key=lambda group: len(group[0]))
        }

    def _axes_of(self, name):
        return next((step.axes for step in self.plan.steps if step.name == name), None)

    @property
    def _owned(self):
        """Results that are made on fewer axes than all."""
        fewer = [result for result in self.plan.results if set(result.axes) < set(self.plan.over)]
        return dict.fromkeys([*self.plan.bounds, *fewer])

    def making(self, lengths):
        """Return the most bytes that making anything takes for blocks of some lengths, by its dimensions."""
        each = [(names, _MAKING + _STEP * len(steps)) for names, (steps, _) in self._groups.items()]
        each += [(result.axes, 16 + CALL) for result in self._owned]
        found = {}
        for names, size in each:
            dimensions = self.axes.dimensions(names)
            found[dimensions] = max(found.get(dimensions, 0), size * prod(lengths[d] for d in dimensions))
        return found

    def bytes(self, lengths):
        """Return the bytes of what is kept at the same time, for blocks of some lengths."""
        shape, total = self.axes.shape, 0
        groups = self._groups.items()
        each = [(names, sum(_LEFT.get(step.operation, 24) for step in left)) for names, (_, left) in groups]
        each += [(result.axes, 16) for result in self._owned]
        each += [((name,), 8) for name in self.plan.over if self.axes.lazy(name)]
        for names, size in each:
            dimensions = self.axes.dimensions(names)
            leading = _leading(dimensions)
            total += size * prod(lengths[d] if d in leading else shape[d] for d in dimensions)
        return total

    def part(self, block, inside=...):
        """Return a source of factors for a block, or of what is inside it: slices along all dimensions."""
        return _Part(self, block, inside)

    def _once(self, key, names, block, make):
        """What belongs to some axes in a block: made if it is not there; what no later block asks for is dropped."""
        dimensions = self.axes.dimensions(names)
        lead = tuple(block[d] for d in _leading(dimensions))
        if self._stores.get(key, (None,))[0] != lead:
            self._stores[key] = lead, {}
        store, place = self._stores[key][1], tuple(block[d] for d in dimensions)
        if place not in store:
            store[place] = make()
        return store[place]

    def values(self, name, block):
        """Return what of an axis belongs to a block."""
        if not self.axes.lazy(name):
            return self.axes.values(name, block)
        return self._once(name, (name,), block, lambda: self.axes.values(name, block))

    def _admitted(self, names, block):
        axes, _ = admitted_axes(self.plan, {name: self.values(name, block) for name in names})
        return started(self.plan, axes)

    def _group(self, names, block):
        steps, left = self._groups[names]

        def make():
            known = self.factors(block, within=names)
            made = make_steps(steps, self._admitted(names, block), OPERATIONS, known)
            return {step.name: made[step.name] for step in left}

        return self._once(names, names, block, make)

    def factors(self, block, within=None):
        """Return what is kept of the steps, by name, for a block; of those on fewer axes than some."""
        made = {}
        for names in self._groups:
            if within is None or set(names) < set(within):
                made.update(self._group(names, block))
        return made

    def own(self, result, block):
        """Return a result on the axes it depends on, for a block: in float64."""

        def make():
            axes = self._admitted(self.plan.over, block)
            shape = own_shape(axes, result.axes, len(block))
            return placed(self.plan, result, self.factors(block), axes, shape, None, np.float64)

        return self._once(result, result.axes, block, make)


class _Part:
    """A source, as `sources.Fresh`, of what is inside a block."""

    def __init__(self, kept, block, inside):
        self._kept, self._block, self._inside = kept, block, inside

    def own(self, result):
        return cut(self._kept.own(result, self._block), self._inside)

    def factors(self, part=...):
        made = self._kept.factors(self._block)
        return {name: cut(cut(value, self._inside), part) for name, value in made.items()}


def _leading(dimensions):
    """The first of some dimensions that follow each other from 0 on: where these go on, nothing comes back."""
    return [d for place, d in enumerate(dimensions) if place == d]
