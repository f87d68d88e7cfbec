"""The back ends that are verified: the public NumPy functions, and the emitted C where there is a compiler."""

from importlib import import_module
from pathlib import Path

import numpy as np

from galileo_sym.libraries import NoCompilerError

from .native import NativeLibrary


class NumpyFunctions:
    """The public functions of `galileo_sym.chord` and `galileo_sym.projectile` on arrays."""

    name = "numpy"

    def evaluate(self, function, force_set, arguments):
        """Results of one kernel; absent forces are left to their default, which selects it.

        Parameters and returns as in `NativeLibrary.evaluate`.
        """
        public = getattr(import_module(f"galileo_sym.{function.paper}"), function.name)
        by_name = {name: arguments[name] for name in (*function.keywords, *function.force_sets[force_set])}
        positional = [arguments[name] for name in function.positional]
        with np.errstate(all="ignore"):
            results = public(*positional, **by_name)
        return results if isinstance(results, tuple) else (results,)


def generated_folder():
    """The folder of the emitted code."""
    return Path(next(iter(import_module("galileo_sym.generated").__path__)))


def available_back_ends(tell):
    """NumPy, and C if this machine has a compiler; `tell` is called with a sentence if it has none.

    Raises
    ------
    CompilationError
        If there is a compiler and the emitted C does not compile or load.
    """
    try:
        return [NumpyFunctions(), NativeLibrary(generated_folder() / "c")]
    except NoCompilerError as cause:
        tell(f"No C compiler: {cause}. Only the NumPy back end is verified.")
        return [NumpyFunctions()]
