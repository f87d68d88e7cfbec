"""Look for inputs where the binary64 functions err most, and add those worse than the known ones to tests/data/NAME.wc.

Binary32 inputs that the exhaustive run found nearest a midpoint are added too.
"""

import argparse
import ctypes
import sys
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from exhaustive import certain, libraries, results, wc_files  # noqa: E402 (the package stands beside the installed one)
from exhaustive.emitted import c_folder  # noqa: E402
from galileo_sym.files import write_whole  # noqa: E402
from galileo_sym.primitives.kernels import KERNELS  # noqa: E402
from galileo_sym.progress import progress_bar  # noqa: E402

WORST = 8  # as in search.h
WORST_KEPT = 3  # of a piece


class Found(ctypes.Structure):
    """As `worst_found` in search.h."""

    _fields_ = (
        ("ulp", ctypes.c_double * WORST),
        ("input", ctypes.c_double * WORST),
        ("tried", ctypes.c_uint64),
        ("undecided", ctypes.c_uint64),
    )


class Measure:
    """Errors of the binary64 function of a primitive against the reference, in ulp."""

    def __init__(self, name, tested, reference):
        self._name = name
        self._library = libraries.load(reference)
        self._library.reference_of.restype = ctypes.c_void_p
        self._of = ctypes.c_void_p(self._library.reference_of(name.encode()))
        self._tested = getattr(libraries.load(tested), f"gs_special_{name}_n") if tested else None

    def values(self, x, hi, lo):
        """Fill in the reference values at x, 256 of them, as pairs."""
        self._library.reference_values(self._of, *(ctypes.c_void_p(array.ctypes.data) for array in (x, hi, lo)))

    def errors(self, inputs):
        """Return the error at each input, NaN outside of what the reference is made for."""
        x = np.array(inputs, dtype=float)
        inside = (abs(x) >= wc_files.SMALLEST) & (abs(x) <= wc_files.LARGEST.get(self._name, wc_files.LARGEST_ELSE))
        padded = np.ones(-(-x.size // libraries.LANES) * libraries.LANES)
        padded[: x.size] = np.where(inside, x, 1.0)
        ulp = np.empty_like(padded)
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in (padded, ulp)]
        self._library.errors(self._of, self._tested, ctypes.c_size_t(padded.size), *pointers)
        return np.where(inside, ulp[: x.size], np.nan)

    def search(self, seed, count, low, high, dense):
        """Return [(error, input), ...], the worst first, of random inputs from low to high, both of one sign."""
        found, state = Found(ulp=(-1.0,) * WORST), ctypes.c_uint64(seed)
        bounds = (ctypes.c_double(low), ctypes.c_double(high), ctypes.c_int(dense))
        steps = ctypes.c_uint64(count - count % libraries.LANES)
        self._library.search(self._of, self._tested, ctypes.byref(state), steps, *bounds, ctypes.byref(found))
        return sorted(zip(found.ulp, found.input, strict=True), reverse=True)


def searched(measure, name, seed, count, known, progress):
    """Return the inputs that are worse than any known one of their piece."""
    added, sizes = [], wc_files.sizes(name)
    for number, (low, high, sign) in enumerate(sizes):
        here = [x for x in known if low <= sign * x < high]
        worst = max([-1.0, *measure.errors(here)]) if here else -1.0
        seeds = [seed + 2 * number, seed + 2 * number + 1]
        found = [measure.search(s, count // 2, sign * low, sign * high, dense) for dense, s in enumerate(seeds)]
        ulp, x = max(found[0][0], found[1][0])
        if ulp > worst:
            added.append(x)
        if progress:
            progress(number + 1, len(sizes), name)
    return added


def worst_of(measure, name, inputs):
    """Return the worst inputs of every piece."""
    errors = dict(zip(inputs, measure.errors(inputs), strict=True))
    found = []
    for low, high, sign in wc_files.sizes(name):
        here = sorted((x for x in inputs if low <= sign * x <= high), key=errors.get, reverse=True)
        found += here[:WORST_KEPT]
    return list(dict.fromkeys(found))


def text_of(name, measure, hard, single):
    """Return the file: ends of pieces, the worst in binary64 with their errors, the hardest in binary32."""
    lines = [
        f"# {name}: inputs that are hard to get right, made by `make hard-cases`",
        "# ends of pieces and of ranges",
    ]
    lines += [x.hex() for x in wc_files.ends(name)]
    lines += ["# the worst found in binary64: error in ulp"]
    errors = measure.errors(hard) if hard else []
    lines += [f"{x.hex()} # {ulp:.4f}" for ulp, x in sorted(zip(errors, hard, strict=True), reverse=True)]
    lines += ["# the nearest to a midpoint of floats"]
    lines += [x.hex() for x in single]
    return "\n".join(lines) + "\n"


def main(arguments=None) -> int:
    """Search, and write the files."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="primitives; all if none is given")
    parser.add_argument("--seed", type=int, required=True, help="another one tries other inputs")
    parser.add_argument("--count", type=int, default=1 << 20, help="inputs a piece")
    chosen = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory(prefix="galileo-sym-") as place:
        tested = libraries.compile_tested(c_folder(), Path(place) / "tested.so")
        reference = libraries.compile_reference(Path(place) / "reference.so")
        for name in chosen.names or KERNELS:
            measure = Measure(name, tested, reference)
            row = results.kept()["exhaustive"].get(name, {"inputs": {"hard": []}})
            single = sorted(certain.of_bits(int(bits, 16)) for bits in row["inputs"]["hard"])
            given = {*wc_files.ends(name), *single}
            known = [x for x in wc_files.read(name) if x not in given]
            with progress_bar(f"hard cases, {name}") as progress:
                new = searched(measure, name, chosen.seed, chosen.count, known, progress)
            hard = worst_of(measure, name, [*known, *new])
            write_whole(wc_files.path_of(name), text_of(name, measure, hard, single).encode())
            worst = max(measure.errors(hard))
            tried = chosen.count * len(wc_files.sizes(name))
            print(f"{name}: {tried} tried, {len(new)} added, {len(hard)} kept; the worst errs by {worst:.4f} ulp")
    return 0


if __name__ == "__main__":
    sys.exit(main())
