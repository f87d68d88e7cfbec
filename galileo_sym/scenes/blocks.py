"""A grid larger than memory, block by block: how large blocks are, and what is made of each."""

from __future__ import annotations

import mmap
import operator
from bisect import bisect_left
from contextlib import nullcontext
from itertools import pairwise
from math import prod

import numpy as np

from galileo_sym import _backend
from galileo_sym.progress import progress_bar
from galileo_sym.scenes.arrays import Axes, checked_outs
from galileo_sym.scenes.kept import CALL, Kept
from galileo_sym.scenes.numpy_run import evaluate
from galileo_sym.scenes.sources import cut

_SMALL = 2**18  # bytes of small objects, and of the buffers of a cast
_POINT = {
    "sum": {"c": 0, "numpy": 64}[_backend.NAME],
    "call": CALL,
}  # bytes a point beside the output, by operation of a result
_ODD = 64 + CALL  # where factors do not serve
_ENDED = 32
_MOST = _ODD + _ENDED + 64
_AXIS = 64  # bytes an element of an axis while its domain is checked


class Blocks:
    """The blocks of a grid of a scene, in the order of their points.

    Parameters
    ----------
    scene : Scene
    given : dict of str to array_like
        The axes.
    max_bytes, grid, out
        As for `blocks_of`.
    """

    def __init__(self, scene, given, *, max_bytes, grid, out):
        self._axes = Axes(scene.plan, given, grid)
        plan = self._plan = scene.plan_for(self._axes)
        self._targets = checked_outs(out, len(plan.results), self._axes.shape)
        self._kept = Kept(plan, self._axes)
        self._bounds = [self._axes.bounds(d) for d in range(len(self._axes.shape))]
        width = self._axes.dtype.itemsize
        self._made = sum(width for target in self._targets if target is None)
        self._given = sum(target.dtype.itemsize for target in self._targets if target is not None)
        self._budget = _as_bytes(max_bytes)
        self._reserve = max(_MOST, self._budget // 8)
        self._lengths = self._found_lengths()

    def _bytes(self, lengths):
        """The most that a block of some lengths takes, with the one before it, which the caller may still hold."""
        points = prod(lengths)
        making = max(self._kept.making(lengths).values(), default=0)
        block = points * (self._made + self._given) + min(points * _MOST, self._reserve)
        checked = sum(_AXIS * prod(lengths[d] for d in self._axes.dimensions((name,))) for name in self._plan.over)
        return _SMALL + self._kept.bytes(lengths) + checked + points * self._made + max(making, block)

    def _found_lengths(self):
        """The lengths of the largest blocks that fit: all of the last dimensions, if one row of these does."""
        lengths = [max((b - a for a, b in pairwise(ends)), default=1) for ends in self._bounds]
        least = self._bytes([1] * len(lengths))
        if least > self._budget:
            raise ValueError(f"max_bytes={self._budget} is too small for this grid: the least that does is {least}")
        for dimensions in self._kept.making(lengths):
            while (
                self._kept.making(lengths)[dimensions] > self._budget // 2 and prod(lengths[d] for d in dimensions) > 1
            ):
                widest = max(dimensions, key=lengths.__getitem__)
                lengths[widest] = -(-lengths[widest] // 2)
        for d, length in enumerate(lengths):
            lengths[d] = 1 + bisect_left(range(2, length + 1), True, key=lambda n, d=d: self._exceeds(lengths, d, n))
        return lengths

    def _exceeds(self, lengths, dimension, length):
        return self._bytes([*lengths[:dimension], length, *lengths[dimension + 1 :]]) > self._budget

    def each(self, progress):
        """Yield the index of each block, a tuple of slices, and its outputs, a tuple of arrays."""
        total = prod(sum(1 for _ in _spans(*one)) for one in zip(self._bounds, self._lengths, strict=True))
        with progress_bar("blocks") if progress else nullcontext() as told:
            for done, block in enumerate(_grid(self._bounds, self._lengths), 1):
                index = tuple(slice(*span) for span in block)
                try:
                    yield index, tuple(self._outputs(block, index))
                finally:
                    for target in self._targets:
                        _write_back(target)
                if told is not None:
                    told(done, total, "")

    def _outputs(self, block, index):
        """The outputs of a block: in one go, or in parts that keep small what is there beside them."""
        shape = tuple(end - start for start, end in block)
        axes = {name: self._kept.values(name, block) for name in self._plan.over}
        outs = [None if target is None else target[index] for target in self._targets]
        beside = self._beside(block)
        if prod(shape) * beside <= self._reserve:
            return evaluate(self._plan, axes, outs, self._axes.dtype, source=self._kept.part(block))
        outs = [np.empty(shape, self._axes.dtype) if out is None else out for out in outs]
        lengths, most = list(shape), self._reserve // beside
        for d in range(len(shape)):
            lengths[d] = max(1, min(lengths[d], most // prod(lengths[d + 1 :])))
        for part in _grid([(0, length) for length in shape], lengths):
            inside = tuple(slice(*span) for span in part)
            some = {name: cut(values, inside) for name, values in axes.items()}
            targets = [out[inside] for out in outs]
            evaluate(self._plan, some, targets, self._axes.dtype, source=self._kept.part(block, inside))
        return outs

    def _beside(self, block):
        """Bytes a point that making the outputs of a block takes beside them."""
        odd = any(getattr(value, "odd", None) is not None for value in self._kept.factors(block).values())
        ended = _ENDED if self._plan.arrival else 0
        everywhere = [result for result in self._plan.results if result.axes == self._plan.over]
        return ended + max([_ODD if odd else 0, *(_POINT.get(result.operation, 0) for result in everywhere)])


def blocks_of(scene, *, max_bytes, grid=True, out=None, progress=False, **axes):
    """Compute a grid that may be larger than memory, block by block.

    Parameters
    ----------
    max_bytes : int
        The most memory that this takes at one time: two blocks of outputs made here, since the caller may hold the
        one before, or the pages of `out` that a block lies in; what its making takes beside it; and the factors
        along axes that later blocks need, which are computed once for the whole call. Not counted are the axes and
        `out` themselves, what the caller keeps, and what a dask array takes while a chunk of it is computed.
    grid : bool, optional
        As for a call of the scene.
    out : ndarray or tuple of ndarray, optional
        Where the outputs are written, one for each: float64 or float32, of the shape of the whole grid. What is
        memory-mapped (``numpy.memmap``, ``numpy.lib.format.open_memmap``) is flushed after each block, and its
        pages are given back.
    progress : bool, optional
        Whether a bar shows on a terminal.
    **axes : array_like
        Values along each axis: arrays, memory-mapped ones, or dask arrays, whose chunks are computed one at a time,
        once each; no block crosses a bound between their chunks.

    Yields
    ------
    index : tuple of slice
        Where the block is in the grid. Blocks come in the order of their points: the last axis runs fastest.
    arrays : ndarray or tuple of ndarray
        What a call of the scene gives there, to the bit; views of `out` if that is given.

    Raises
    ------
    TypeError
        As a call of the scene does; and for `max_bytes` that is no whole number.
    ValueError
        If `max_bytes` does not do for the smallest blocks, with the least that does; for dask arrays with chunks of
        unknown length.

    Examples
    --------
    >>> import numpy as np
    >>> from galileo_sym import Scene
    >>> scene = Scene("chord", g=9.81, mu=0.36, over=("t", "theta"), outputs="y")
    >>> axes = {"t": np.linspace(0.0, 1.0, 3000), "theta": np.linspace(-1.0, 1.0, 1000)}
    >>> lowest = max(y.max() for _, y in scene.blocks(**axes, max_bytes=2**22))
    """
    blocks = Blocks(scene, scene.checked_axes(axes), max_bytes=max_bytes, grid=grid, out=out)
    return _yielded(blocks, scene.alone, progress)


def _yielded(blocks, alone, progress):
    for index, found in blocks.each(progress):
        outputs = found if index else tuple(array[()] for array in found)
        yield index, outputs[0] if alone else outputs


def _as_bytes(given):
    """A number of bytes."""
    try:
        return operator.index(given)
    except TypeError:
        raise TypeError(f"max_bytes is {given!r}: give a whole number of bytes") from None


def _spans(bounds, length):
    """First index and end of pieces of at most some length, none of which crosses a bound."""
    for start, end in pairwise(bounds):
        for first in range(start, end, length):
            yield first, min(first + length, end)


def _grid(bounds, lengths):
    """Spans along all dimensions, the last one running fastest."""
    if not bounds:
        yield ()
        return
    for span in _spans(bounds[0], lengths[0]):
        for rest in _grid(bounds[1:], lengths[1:]):
            yield (span, *rest)


def _write_back(target):
    """Write a memory-mapped array to its file, and let go of the memory that holds it."""
    mapped = base = target
    while isinstance(base, np.ndarray):
        mapped = base if isinstance(base, np.memmap) else mapped
        base = base.base
    if isinstance(base, mmap.mmap) and isinstance(mapped, np.memmap) and mapped.mode in ("r+", "w+"):
        base.flush()
        if hasattr(base, "madvise"):
            base.madvise(mmap.MADV_DONTNEED)  # of a private map that would lose what was written
