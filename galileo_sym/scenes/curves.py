"""Scenes whose output is the whole synchronous curve: points of the circles, no beads."""

from __future__ import annotations

import numpy as np

from galileo_sym._curve import NAMES, curve

_ARGUMENTS = ("t", "g", "mu", "gamma")


def curve_of(scene, n, *, out=None, **axes):
    """Compute the whole curves on which beads are found: points of circles, without following any bead.

    Parameters
    ----------
    n : int
        Number of points of a curve, at equal distances along its arcs; they take the place of the axis ``theta``,
        the last one. Their order is that of `galileo_sym.chord.synchronous_curve`.
    out : ndarray or tuple of ndarray, optional
        Where the outputs are written, one for each.
    **axes : array_like
        Values along each other axis: ``t``, ``g``, ``mu``, ``gamma``.

    Returns
    -------
    ndarray or tuple of ndarray
        One for each output, ``x`` or ``y``, over the outer grid of the axes, with `n` points last; the array itself
        where the scene has one output, by its name alone.

    Raises
    ------
    TypeError
        For missing or unknown axes, and as the function does.
    ValueError
        For scenes of projectiles, of other outputs, where ``theta`` is not the last axis, or where beads stop.

    Examples
    --------
    >>> from galileo_sym import Scene
    >>> x, y = Scene("chord", g=9.81, mu=0.36, over=("t", "theta"), outputs=("x", "y")).curve(100, t=[0.1, 0.2])
    >>> x.shape
    (2, 100)
    """
    for holds, told in (
        (scene.system == "chord", "projectiles have no synchronous curve here: make a scene of chords"),
        (set(scene.outputs) <= set(NAMES), "a curve has the outputs x and y: make the scene with_outputs of these"),
        (scene.over[-1] == "theta", "a curve is over all angles: name theta in over=, as the last axis"),
        (set(scene.over) <= {*_ARGUMENTS, "theta"}, "curves do not depend on a diameter: leave it out of over="),
        (scene.until == "forever", "beads that have arrived are not on the curve: make the scene with until='forever'"),
    ):
        if not holds:
            raise ValueError(told)
    varying = [name for name in scene.over if name != "theta"]
    arrays = {name: np.asanyarray(axes[name]) for name in scene.checked_axes(axes, varying)}
    after = 0
    for name in reversed(varying):
        shape = arrays[name].shape
        arrays[name] = arrays[name].reshape(shape + (1,) * after)
        after += len(shape)
    known = {"mu": 0.0, "gamma": 0.0, **scene.constants, **arrays}
    found = curve(**{name: known[name] for name in _ARGUMENTS}, n=n, names=scene.outputs, out=out)
    return found[0] if scene.alone else found
