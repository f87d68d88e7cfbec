"""Motions that end: what has arrived or landed stays, what has not started or is at rest too, and is not computed."""

from __future__ import annotations

import numpy as np

from galileo_sym.scenes.points import all_placed, own_shape, spread
from galileo_sym.scenes.sources import cut, shown

_CLEARLY = 2.0**-50  # share of a time by which it is surely before or after another one


def ended(plan, axes, shape, outs, dtype, source):
    """Return the outputs of a plan whose motion ends, as `numpy_run.evaluate` does; factors come from a source.

    Rows and columns at the border of the grid in which nothing moves are filled, not computed: times before the start
    or after the last arrival, beads at rest, and those that arrived before the first time.
    """
    time = axes["t"] if "t" in axes else np.full((1,) * len(shape), dict(plan.constants)["t"])
    early = time < 0.0
    time = np.where(early, 0.0, time)
    arrival = source.own(plan.arrival)
    ends, given = {end.output: end for end in plan.ends}, dict(zip(plan.results, outs, strict=True))
    ending = [result for result in plan.results if result.output in ends]
    others = [result for result in plan.results if result.output not in ends]
    idle = _idle(time, early, arrival) if all(set(one.axes) < set(plan.over) for one in others) else []
    window = _window(idle, shape)
    made = source.factors(window)
    some = {name: cut(time if name == "t" else values, window) for name, values in axes.items()}
    found = dict(
        zip(others, shown(plan, others, source, made, some, shape, [given[r] for r in others], dtype), strict=True)
    )
    targets = [_target(own_shape(axes, ends[r.output].axes, len(shape)), shape, given[r], dtype) for r in ending]
    parts = [cut(target, window) for target in targets]
    inner = tuple(one.stop - one.start for one in window)
    all_placed(plan, ending, made, some, inner, parts, dtype)
    late = _late(*(cut(array, window) for array in (time, early, arrival)), inner)
    for result, target, part in zip(ending, targets, parts, strict=True):
        limit = _limit(ends[result.output], source, arrival)
        _settle(ends[result.output], part, cut(limit, window), late)
        _fill(target, window, shape, early, limit)
        found[result] = spread(target, shape, given[result])
    return [found[result] for result in plan.results]


def _target(own, shape, out, dtype):
    return out if out is not None and own == shape else np.empty(own, dtype)


def _limit(end, source, arrival):
    """Where an output ends: 0 for speeds and heights, and for beads that never arrive since they do not move."""
    if end.limit is None:
        return np.zeros((1,) * arrival.ndim)
    return np.where(np.isinf(arrival), 0.0, source.own(end.limit))


def _idle(time, early, arrival):
    """Masks, over times and over motions, of what is surely not moving."""
    last = arrival.max(where=np.isfinite(arrival), initial=0.0) * (1.0 + _CLEARLY)
    first = time.min(where=~early, initial=np.inf)
    return [early | (time > last), np.isinf(arrival) | (arrival * (1.0 + _CLEARLY) < first)]


def _window(masks, shape):
    """Slices along all dimensions: beyond them one of some masks holds everywhere."""
    bounds = [(0, length) for length in shape]
    for mask in masks:
        for d, length in enumerate(mask.shape):
            if length > 1:
                free = np.flatnonzero(~mask.all(axis=tuple(other for other in range(mask.ndim) if other != d)))
                begin, end = (free[0], free[-1] + 1) if free.size else (0, 0)
                bounds[d] = (max(bounds[d][0], int(begin)), min(bounds[d][1], int(end)))
    return tuple(slice(begin, max(begin, end)) for begin, end in bounds)


def _late(time, early, arrival, shape):
    """Where something may have ended, as slices; and there what surely has, and where speeds are 0."""
    before = ~early & (time < arrival.min(initial=np.inf) * (1.0 - _CLEARLY))
    index = _window([before], shape)
    time, early, arrival = (cut(array, index) for array in (time, early, arrival))
    return index, time > arrival * (1.0 + _CLEARLY), early | (time > arrival)


def _settle(end, part, limit, late):
    """What has ended stays: positions between 0 and their limits, heights at 0, speeds at 0."""
    index, ended_surely, stopped = late
    part, limit = cut(part, index), cut(limit, index)
    if end.floor:
        np.maximum(part, 0.0, out=part)
    elif end.limit is None:
        np.copyto(part, 0.0, where=stopped)
    else:
        np.clip(part, np.minimum(limit, 0.0), np.maximum(limit, 0.0), out=part, casting="same_kind")
        np.copyto(part, limit, where=ended_surely, casting="same_kind")


def _fill(target, window, shape, early, limit):
    """Write what does not move: all that is outside of a window."""
    for d, (one, length) in enumerate(zip(window, shape, strict=True)):
        for beside in (slice(0, one.start), slice(one.stop, length)):
            if beside.start < beside.stop:
                index = (*window[:d], beside, *(slice(0, rest) for rest in shape[d + 1 :]))
                part, before = cut(target, index), cut(early, index)
                np.copyto(part, cut(limit, index), casting="same_kind")
                if before.any():
                    np.copyto(part, 0.0, where=before)
