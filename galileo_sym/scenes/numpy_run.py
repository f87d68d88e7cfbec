"""A plan carried out by NumPy: factors in pairs on their axes, rounded once; one multiplication an output a point."""

from __future__ import annotations

from contextlib import contextmanager

import numpy as np

from galileo_sym.scenes.arrays import admitted_axes
from galileo_sym.scenes.ends import ended
from galileo_sym.scenes.operations import OPERATIONS
from galileo_sym.scenes.sources import Fresh, shown, started

_BUFFER = 512  # elements: with larger buffers NumPy copies what is broadcast along rows of a grid, at thrice the time


def evaluate(plan, axes, outs, dtype, operations=OPERATIONS, source=None):
    """Return the outputs of a plan at its points.

    Parameters
    ----------
    plan : Plan
    axes : dict of str to ndarray
        Arrays of float64 of the axes, of equal dimension, that broadcast to the shape of the outputs.
    outs : sequence of ndarray or None
        For each output where it is written; None for an array of its own, or a view where some axes do not matter.
    dtype : numpy.dtype
        Of outputs that are made.
    operations : dict of str to callable, optional
        What carries out the steps.
    source : object, optional
        Where factors and ends come from, with the methods of `galileo_sym.scenes.sources.Fresh`, which is the default.

    Returns
    -------
    list of ndarray
    """
    shape = np.broadcast_shapes(*(values.shape for values in axes.values()))
    with _small_buffers():
        within, void = admitted_axes(plan, axes)
        source = source or Fresh(plan, started(plan, within), operations)
        if plan.arrival is None:
            outputs = shown(plan, plan.results, source, source.factors(), within, shape, outs, dtype)
        else:
            outputs = ended(plan, within, shape, outs, dtype, source)
        return [_voided(result, output, void) for result, output in zip(plan.results, outputs, strict=True)]


@contextmanager
def _small_buffers():
    before = np.setbufsize(_BUFFER)
    try:
        yield
    finally:
        np.setbufsize(before)


def _voided(result, output, void):
    """NaN where an argument of the function of an output is outside its domain."""
    for name in result.arguments:
        if name in void:
            output = output if output.flags.writeable else output.copy()
            np.copyto(output, np.nan, where=void[name])
    return output
