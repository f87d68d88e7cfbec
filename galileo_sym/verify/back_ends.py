"""The back ends that are verified: the public NumPy functions, and the emitted C where there is a compiler."""

from importlib import import_module
from pathlib import Path

import numpy as np

from galileo_sym.libraries import NoCompilerError

from .native import NativeLibrary


class NumpyFunctions:
    """The public functions as the NumPy back end serves them, whichever back end this installation chooses."""

    name = "numpy"

    def evaluate(self, function, force_set, arguments):
        """Results of one kernel; absent forces are left to their default, which selects it.

        Parameters and returns as in `NativeLibrary.evaluate`.
        """
        front, stand_ins = import_module("galileo_sym._front"), import_module("galileo_sym._stand_in")
        public = front.Served(function.full_name, stand_ins.stand_in)
        forces = max(function.force_sets.values(), key=len)
        taken = function.arguments(force_set)
        operands = [arguments[n] if n in taken else 0.0 for n in (*function.positional, *function.keywords, *forces)]
        with np.errstate(all="ignore"):
            results = public(*operands, None, True, None, "same_kind")
        return results if isinstance(results, tuple) else (results,)


def generated_folder():
    """The folder of the emitted code."""
    return Path(import_module("galileo_sym.generated").__file__).parent


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
