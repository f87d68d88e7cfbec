"""The emitted C, compiled by the system's compiler into a private library and called on arrays."""

import ctypes
from functools import cache
from pathlib import Path

import numpy as np

from galileo_sym.libraries import CompilationError, find_compiler, kept_library


@cache
def _loaded(path):
    """Return a library, loaded once in a process."""
    try:
        return ctypes.CDLL(str(path))
    except OSError as cause:  # such as a table that a lost or empty source should define
        missing = str(cause).removeprefix(f"{path}: ")
        raise CompilationError(f"the emitted C does not load ({missing}); run `galileo-sym emit`") from None


class NativeLibrary:
    """The functions of the emitted C as array functions; the same sources are compiled once and kept.

    Parameters
    ----------
    folder : Path
        Where the C sources are.
    compiler : list of str, optional
        The compiler's command; the system's by default.

    Raises
    ------
    NoCompilerError, CompilationError
        If there is no compiler, or if the sources do not compile to a library that loads.
    """

    name = "c"

    def __init__(self, folder, compiler=None):
        compiler = find_compiler() if compiler is None else compiler
        self._library = _loaded(kept_library(sorted(Path(folder).glob("*.c")), compiler))

    def evaluate(self, function, force_set, arguments):
        """Results of the array form of one kernel.

        Parameters
        ----------
        function : Function
            A row of the table of functions.
        force_set : str
            One of its force sets.
        arguments : dict of str to ndarray
            Arrays of equal length for the kernel's arguments.

        Returns
        -------
        tuple of ndarray
            One array for each output.

        Raises
        ------
        CompilationError
            If the library has no such function.
        """
        inputs = [np.ascontiguousarray(arguments[name], dtype=float) for name in function.arguments(force_set)]
        outputs = [np.full(inputs[0].shape, np.nan) for _ in function.outputs]
        self._call(c_symbol(function, force_set), inputs, outputs)
        return tuple(outputs)

    def primitive(self, name, x):
        """Results of the array form of a one-variable function.

        Parameters
        ----------
        name : str
            Such as "descent_factor".
        x : ndarray

        Returns
        -------
        ndarray

        Raises
        ------
        CompilationError
            If the library has no such function.
        """
        x = np.ascontiguousarray(x, dtype=float)
        value = np.full(x.shape, np.nan)
        self._call(f"gs_special_{name}_n", [x], [value])
        return value

    def _call(self, symbol, inputs, outputs):
        try:
            routine = getattr(self._library, symbol)
        except AttributeError:
            raise CompilationError(f"the emitted C has no function {symbol}; run `galileo-sym emit`") from None
        routine.restype = None
        pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (*inputs, *outputs)]
        routine(ctypes.c_size_t(inputs[0].size), *pointers)


def c_symbol(function, force_set):
    """Name of the C array function of one kernel."""
    suffix = "" if len(function.force_sets) == 1 else f"_{force_set}"
    return f"gs_{function.paper}_{function.name}{suffix}_n"
