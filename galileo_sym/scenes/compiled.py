"""Scenes compiled: the C of a plan as a shared library, kept by content, called through ctypes."""

from __future__ import annotations

import ctypes
import tempfile
import warnings
from pathlib import Path

import numpy as np

from galileo_sym._types import DOUBLE
from galileo_sym.generated._kernel import raise_invalid
from galileo_sym.libraries import CompilationError, NoCompilerError, find_compiler, kept_library
from galileo_sym.scenes.arrays import Axes, checked_outs
from galileo_sym.scenes.c_source import source

_NAME = "scene"
_RAISED = {"OVERFLOW": lambda: np.multiply(2.0**1023, 2.0), "UNDERFLOW": lambda: np.multiply(2.0**-1022, 2.0**-60)}
_RAISED |= {"INVALID": raise_invalid}  # what raises an error state of NumPy, by the flag of C, in the order of its bits
_FLAGS_OF_C = """
#include <fenv.h>
void scene_clear(void) { feclearexcept(FE_ALL_EXCEPT); }
int scene_raised(void)
{
    const int found = fetestexcept(FE_OVERFLOW | FE_UNDERFLOW | FE_INVALID);
    return (found & FE_OVERFLOW ? 1 : 0) | (found & FE_UNDERFLOW ? 2 : 0) | (found & FE_INVALID ? 4 : 0);
}
"""
_FLAGS = ("-std=c99", "-O3", "-ffp-contract=off", "-fPIC")


class Compiled:
    """A scene as a function of C; called as the scene is. Made by `Scene.compile`."""

    def __init__(self, scene, library):
        self.scene, self.library = scene, library
        functions = ctypes.CDLL(str(library))
        self._run, self._work = functions[_NAME], functions[f"{_NAME}_work"]
        lengths = [ctypes.c_size_t] * len(scene.over)
        self._clear, self._raised = functions[f"{_NAME}_clear"], functions[f"{_NAME}_raised"]
        self._run.restype, self._work.restype, self._work.argtypes = None, ctypes.c_size_t, lengths
        pairs = [kind for _ in scene.over for kind in (ctypes.c_size_t, ctypes.c_void_p)]
        self._run.argtypes = [*pairs, *[ctypes.c_void_p] * (1 + len(scene.outputs))]

    def __repr__(self):
        return f"<compiled {self.scene!r}>"

    def __reduce__(self):
        return compiled, (self.scene,)

    def __call__(self, *, grid=True, out=None, **axes):
        """Compute the outputs: as the scene does, whose arguments these are; without ``grid`` by the scene itself."""
        scene = self.scene
        if not grid:
            return scene(grid=False, out=out, **axes)
        laid = Axes(scene.plan, scene.checked_axes(axes), True)
        arrays, shape = laid.all_values(), laid.shape
        targets = checked_outs(out, len(scene.outputs), shape)
        results = [np.empty(shape, laid.dtype) if target is None else target for target in targets]
        self._compute(arrays, [x if _is_plain(x) else np.empty(shape) for x in results], results)
        results = tuple(result if shape else result[()] for result in results)
        return results[0] if scene.alone else results

    def _compute(self, arrays, places, results):
        flat = [np.ascontiguousarray(values).reshape(-1) for values in arrays.values()]
        work = np.empty(self._work(*map(len, flat)), np.uint8)
        pairs = [argument for values in flat for argument in (len(values), values.ctypes.data)]
        self._clear()
        self._run(*pairs, work.ctypes.data, *(place.ctypes.data for place in places))
        raised = self._raised()
        for bit, state in enumerate(_RAISED.values()):
            if raised >> bit & 1:
                state()
        for place, result in zip(places, results, strict=True):
            if place is not result:
                np.copyto(result, place, casting="same_kind")


def _is_plain(array):
    return array.dtype == DOUBLE and array.flags.c_contiguous and array.flags.aligned


def compiled(scene):
    """Return a scene compiled; the scene itself, with a warning, where it cannot be."""
    try:
        compiler = find_compiler()
        with tempfile.TemporaryDirectory(prefix="galileo-sym-") as folder:
            path = Path(folder) / f"{_NAME}.c"
            path.write_text(source(scene.separate_plan, _NAME) + _FLAGS_OF_C, encoding="utf-8")
            return Compiled(scene, kept_library([path], compiler, _FLAGS))
    except (NoCompilerError, CompilationError) as cause:
        warnings.warn(f"the scene is not compiled, NumPy serves it: {cause}", RuntimeWarning, stacklevel=3)
        return scene
