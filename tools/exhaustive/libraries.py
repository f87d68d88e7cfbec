"""The emitted primitives and the reference, compiled into libraries and called through ctypes."""

import ctypes
import hashlib
from functools import cache
from pathlib import Path

from galileo_sym.codegen.kernels import TARGETS, runnable
from galileo_sym.libraries import FLAGS, compile_library, find_compiler

HERE = Path(__file__).resolve().parent
LISTED, LANES = 4096, 256  # as in judge.h and reference.h
REFERENCE_FLAGS = ("-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math")


class Report(ctypes.Structure):
    """As `report` in judge.h."""

    _fields_ = (
        *((name, ctypes.c_uint64) for name in ("right", "refused", "wrong", "undecided", "differing")),
        ("nearest", ctypes.c_double),
        ("nearest_input", ctypes.c_uint32),
        *((f"{name}_inputs", ctypes.c_uint32 * LISTED) for name in ("wrong", "undecided", "differing")),
    )

    def inputs(self, kind):
        """Return the bits of the listed inputs of a kind."""
        return list(getattr(self, f"{kind}_inputs")[: min(getattr(self, kind), LISTED)])


def compile_tested(folder, target, compiler=None, quickly=False):
    """Compile the emitted primitives, with the flags of the back end; quickly, for a run of a few inputs, with -O0."""
    flags = ["-O0" if quickly and flag == "-O2" else flag for flag in FLAGS]
    compile_library(sorted(Path(folder).glob("special*.c")), target, compiler or find_compiler(), flags)
    return target


def compile_reference(target, shift=None):
    """Compile the reference, the judge and the search; `shift` makes every reference value wrong by that much."""
    flags = [*FLAGS, *REFERENCE_FLAGS, *([f"-DREFERENCE_SHIFT={shift.hex()}"] if shift else [])]
    compile_library(sorted(HERE.glob("*.c")), target, find_compiler(), flags)
    return target


def reference_digest():
    """Return the SHA-256 of the sources of what judges."""
    paths = sorted({*HERE.glob("*.[ch]"), HERE / "certain.py"} - {HERE / "search.c", HERE / "search.h"})
    return hashlib.sha256(b"".join(path.read_bytes() for path in paths)).hexdigest()


@cache
def suffixes():
    """Return the versions that this machine can run, the plain one apart."""
    return runnable()[1:]


def narrower():
    """Return the vector versions that the public function does not choose on this machine."""
    return tuple(s for s in suffixes() if TARGETS[s][2] > 1)[1:]


@cache
def load(path):
    """Return a library that was compiled."""
    return ctypes.CDLL(str(path))


def judged(name, tested, reference, first, count):
    """Judge the binary32 function of a primitive at the inputs with the bits first ... first + count - 1.

    Parameters
    ----------
    name : str
        A primitive.
    tested, reference : path
        The compiled libraries.
    first, count : int
        Multiples of 256.

    Returns
    -------
    Report

    Raises
    ------
    LookupError
        If the reference has no such primitive.
    """
    code, judge = load(tested), load(reference)
    judge.reference_of.restype = ctypes.c_void_p
    of = judge.reference_of(name.encode())
    if of is None:
        raise LookupError(f"tools/exhaustive/reference.c has no reference for {name}: write one from its definition")
    functions = [getattr(code, f"gs_special_{name}_nf"), *(getattr(code, f"gs_{name}_nf_{s}") for s in narrower())]
    addresses = (ctypes.c_void_p * len(functions))(*(ctypes.cast(f, ctypes.c_void_p) for f in functions))
    found = Report(nearest=float("inf"))
    judge.judge.restype = None
    judge.judge(
        ctypes.c_void_p(of),
        addresses,
        ctypes.c_int(len(functions)),
        ctypes.c_uint32(first),
        ctypes.c_uint64(count),
        ctypes.byref(found),
    )
    return found


def value_of(name, tested, bits):
    """Return the bits of the tested function's value at the input with these bits, in the stretch that is judged."""
    function = getattr(load(tested), f"gs_special_{name}_nf")
    function.restype = None
    first = bits - bits % LANES
    x, y = (ctypes.c_uint32 * LANES)(*range(first, first + LANES)), (ctypes.c_uint32 * LANES)()
    function(ctypes.c_size_t(LANES), x, y)
    return y[bits - first]
