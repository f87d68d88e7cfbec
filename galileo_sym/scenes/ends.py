"""Motions that end: what has arrived or landed stays, and is not computed."""

from __future__ import annotations

import numpy as np

from galileo_sym.scenes.points import own_shape, placed, spread
from galileo_sym.scenes.sources import shown

_CLEARLY = 2.0**-50  # share of a time by which it is surely before or after another one


def ended(plan, axes, shape, outs, dtype, source):
    """Return the outputs of a plan whose motion ends, as `numpy_run.evaluate` does; factors come from a source.

    Times when nothing moves any more are left out before anything is computed, where times ascend and all outputs end.
    """
    time = axes["t"] if "t" in axes else np.full((1,) * len(shape), dict(plan.constants)["t"])
    early = time < 0.0
    time = np.where(early, 0.0, time)
    arrival = source.own(plan.arrival)
    all_end = len(plan.ends) == len(plan.results)
    moving, after = _split(time, arrival, len(shape)) if all_end else (..., None)
    some = {name: values[moving] if name == "t" else values for name, values in axes.items()}
    if "t" in axes:
        some["t"] = time[moving]
    made = source.factors(moving)
    ends, outputs = {end.output: end for end in plan.ends}, []
    for result, out in zip(plan.results, outs, strict=True):
        end = ends.get(result.output)
        if end is None:
            outputs.append(shown(plan, result, source, made, some, shape, out, dtype))
            continue
        limit = _limit(end, source, arrival)
        own = own_shape(axes, end.axes, len(shape))
        target = out if out is not None and own == shape else np.empty(own, dtype)
        part = target[moving]
        placed(plan, result, made, some, part.shape, part, dtype)
        _settle(end, part, limit, time[moving], early[moving], arrival)
        if after is not None:
            np.copyto(target[after], limit, casting="same_kind")
        outputs.append(spread(target, shape, out))
    return outputs


def _limit(end, source, arrival):
    """Where an output ends: 0 for speeds and heights, and for beads that never arrive since they do not move."""
    if end.limit is None:
        return np.zeros((1,) * arrival.ndim)
    return np.where(np.isinf(arrival), 0.0, source.own(end.limit))


def _split(time, arrival, dimensions):
    """Indices of the times when something moves, and of those after; all and None unless times ascend along an axis."""
    flat = time.ravel()
    if time.size < 2 or time.size not in time.shape or not np.all(flat[1:] >= flat[:-1]):
        return ..., None
    last = arrival.max(where=np.isfinite(arrival), initial=0.0)
    count = int(np.searchsorted(flat, last * (1.0 + _CLEARLY), side="right"))
    axis = time.shape.index(time.size)
    parts = slice(None, count), slice(count, None)
    return tuple((*(slice(None),) * axis, part, *(slice(None),) * (dimensions - axis - 1)) for part in parts)


def _settle(end, part, limit, time, early, arrival):
    """What has ended stays: positions between 0 and their limits, heights at 0, speeds at 0."""
    if end.floor:
        np.maximum(part, 0.0, out=part)
    elif end.limit is None:
        np.copyto(part, 0.0, where=early | (time > arrival))
    elif time.size and time.max() > arrival.min() * (1.0 - _CLEARLY):
        np.clip(part, np.minimum(limit, 0.0), np.maximum(limit, 0.0), out=part, casting="same_kind")
