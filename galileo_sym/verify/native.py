"""The emitted C, compiled by the system's compiler into a private library and called on arrays."""

import ctypes
import hashlib
import os
import shlex
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np

COMPILERS = ("cc", "gcc", "clang")
FLAGS = ("-std=c99", "-O2", "-ffp-contract=off", "-fPIC", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-shared")
_SHOWN_LINES = 20


class CompilationError(Exception):
    """The emitted C does not compile or load, or lacks a function."""


class NoCompilerError(Exception):
    """There is no C compiler on this machine; the message says where it was looked for."""


def find_compiler(environment=None):
    """The command of the C compiler: $CC if set, else the first of cc, gcc, clang on PATH.

    Parameters
    ----------
    environment : mapping, optional
        Environment variables; those of the process by default.

    Returns
    -------
    list of str
        The compiler and its options.

    Raises
    ------
    NoCompilerError
        If $CC is set and is not there, or if it is not set and none of the three is.
    """
    environment = os.environ if environment is None else environment
    path = environment.get("PATH", os.defpath)
    chosen = shlex.split(environment.get("CC", ""))
    if chosen:
        if shutil.which(chosen[0], path=path) is None:
            raise NoCompilerError(f"CC names {chosen[0]!r}, which is not on PATH; unset CC or install that compiler")
        return chosen
    for name in COMPILERS:
        if shutil.which(name, path=path):
            return [name]
    raise NoCompilerError(f"none of {', '.join(COMPILERS)} is on PATH and CC is not set; install one or set CC")


def compile_library(sources, target, compiler):
    """Compile C files into a shared library.

    Parameters
    ----------
    sources : list of Path
        The C files; their own folder is on the include path.
    target : Path
        The library to write.
    compiler : list of str
        As from `find_compiler`.

    Raises
    ------
    CompilationError
        With the compiler's first messages; warnings are errors.
    """
    if not sources:
        raise CompilationError("there are no C sources to compile; run `galileo-sym emit`")
    command = [*compiler, *FLAGS, f"-I{sources[0].parent}", *map(str, sources), "-o", str(target), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        messages = "\n".join((done.stderr or done.stdout).splitlines()[:_SHOWN_LINES])
        raise CompilationError(f"{' '.join(compiler)} exits with {done.returncode}:\n{messages}")


def _digest(folder):
    """Return a hash of all that a compilation reads."""
    total = hashlib.sha256()
    for path in sorted(Path(folder).glob("*.[ch]")):
        content = path.read_bytes()
        total.update(f"{path.name} {len(content)} ".encode() + content)
    return total.hexdigest()


@cache
def _loaded(folder, digest, compiler):
    """Return the library of a folder's sources, compiled once in a process."""
    # the loaded library keeps its pages after the folder is gone, so nothing is left behind
    with tempfile.TemporaryDirectory(prefix="galileo-sym-") as build:
        target = Path(build) / "libgalileo.so"
        compile_library(sorted(Path(folder).glob("*.c")), target, list(compiler))
        try:
            return ctypes.CDLL(str(target))
        except OSError as cause:  # such as a table that a lost or empty source should define
            missing = str(cause).removeprefix(f"{target}: ")
            raise CompilationError(f"the emitted C does not load ({missing}); run `galileo-sym emit`") from None


class NativeLibrary:
    """The functions of the emitted C as array functions; the same sources are compiled once in a process.

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
        self._library = _loaded(Path(folder), _digest(folder), tuple(compiler))

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
