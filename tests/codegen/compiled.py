"""The emitted C, compiled once for the tests and called through ctypes."""

import ctypes
import os
import shutil
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import galileo_sym.generated
from galileo_sym.libraries import COMPILERS, FLAGS, kept_library

SOURCES = Path(galileo_sym.generated.__file__).parent / "c"


def compilers():
    """Names of the C compilers there are; of two names for the same program, the first."""
    names = [os.environ.get("CC"), *COMPILERS]  # the one that verification takes comes first: one compilation for both
    found = {}
    for name in filter(None, names):
        if place := shutil.which(name):
            found.setdefault(os.path.realpath(place), name)
    return list(found.values())


def first_compiler():
    """Name of the first C compiler; skips the test where there is none."""
    found = compilers()
    if not found:
        pytest.skip("no C compiler on PATH: the C back end is not tested")
    return found[0]


@cache
def library(compiler=None):
    """Build and load the emitted C; skips the test where there is no compiler."""
    return ctypes.CDLL(str(place(compiler or first_compiler())))


@cache
def place(compiler, level="-O2", pattern="*.c"):
    """Where the library is that a compiler makes of the emitted C; warnings are errors."""
    return kept_library(sorted(SOURCES.glob(pattern)), [compiler], [level if flag == "-O2" else flag for flag in FLAGS])


def call(name, arguments, outputs, dtype=np.float64):
    """Call an array function on broadcast arguments; returns a list of arrays."""
    arrays = [np.ascontiguousarray(a, dtype=dtype) for a in np.broadcast_arrays(*arguments)]
    results = [np.empty_like(arrays[0]) for _ in range(outputs)]
    function = getattr(library(), name)
    function.restype = None
    function(ctypes.c_size_t(arrays[0].size), *(ctypes.c_void_p(a.ctypes.data) for a in [*arrays, *results]))
    return results
