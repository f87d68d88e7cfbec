"""The emitted C, compiled once for the tests and called through ctypes."""

import ctypes
import os
import shutil
import subprocess
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np
import pytest

import galileo_sym.generated

SOURCES = Path(galileo_sym.generated.__file__).parent / "c"
FLAGS = ["-std=c99", "-O2", "-ffp-contract=off", "-fPIC", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]


def compilers():
    """Names of the C compilers there are; of two names for the same program, the first."""
    names = [os.environ.get("CC"), "gcc", "clang", "cc"]
    found = {}
    for name in filter(None, names):
        if place := shutil.which(name):
            found.setdefault(os.path.realpath(place), name)
    return list(found.values())


@cache
def library(compiler=None):
    """Build and load the emitted C; skips the test where there is no compiler."""
    found = compilers()
    if not found:
        pytest.skip("no C compiler on PATH: the C back end is not tested")
    target = Path(mkdtemp(prefix="galileo")) / "libgalileo.so"
    sources = sorted(map(str, SOURCES.glob("*.c")))
    subprocess.run([compiler or found[0], *FLAGS, "-shared", *sources, "-o", str(target), "-lm"], check=True)
    return ctypes.CDLL(str(target))


def call(name, arguments, outputs, dtype=np.float64):
    """Call an array function on broadcast arguments; returns a list of arrays."""
    arrays = [np.ascontiguousarray(a, dtype=dtype) for a in np.broadcast_arrays(*arguments)]
    results = [np.empty_like(arrays[0]) for _ in range(outputs)]
    function = getattr(library(), name)
    function.restype = None
    function(ctypes.c_size_t(arrays[0].size), *(ctypes.c_void_p(a.ctypes.data) for a in [*arrays, *results]))
    return results
