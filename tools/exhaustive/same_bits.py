"""Hold all versions of the primitives, by all compilers there are, to the same bits. Exits with 1 if any differs.

A whole run of the emitted code renews tests/data/exhaustive.json and docs/exhaustive.md.
"""

import argparse
import ctypes
import shutil
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from exhaustive import libraries, results, wc_files  # noqa: E402 (the package stands beside the installed one)
from exhaustive.emitted import c_folder, digest  # noqa: E402
from galileo_sym.primitives.kernels import KERNELS  # noqa: E402
from galileo_sym.progress import progress_bar  # noqa: E402

COUNT = 50_000_000
CHUNK = 1 << 18
SHOWN = 20
SPECIAL = (np.nan, -np.nan, np.inf, -np.inf, 0.0, -0.0, -1.0, -5e-324)
KINDS = {"binary64": (np.float64, np.uint64, "n"), "binary32": (np.float32, np.uint32, "nf")}


class Inputs:
    """Chunks of inputs: random bits of all numbers and dense ones by turns, hard and special ones last."""

    def __init__(self, name, generator, count, seed):
        self._name, self._generator = name, libraries.load(generator)
        self._count, self._seed = count, seed
        self._typical, self._least = wc_files.typical(name), KERNELS[name].domain[0]

    def __iter__(self):
        state = ctypes.c_uint64(self._seed)
        ranges = ((5e-324, float(np.finfo(float).max), 0), (*self._typical, 1))
        for number in range(-(-self._count // CHUNK)):
            low, high, dense = ranges[number % 2]
            x = np.empty(CHUNK)
            bounds = (ctypes.c_double(low), ctypes.c_double(high), ctypes.c_int(dense))
            place = ctypes.c_void_p(x.ctypes.data)
            self._generator.random_inputs(ctypes.byref(state), ctypes.c_size_t(CHUNK), *bounds, place)
            if not dense and self._least < 0.0:
                x[::2] *= -1.0
            yield x
        yield np.array([*wc_files.read(self._name), *SPECIAL])


def as_binary32(x):
    """Round to floats; what is beyond their range becomes a float of the same leading bits, so that all occur."""
    with np.errstate(all="ignore"):
        narrow = x.astype(np.float32)
        leading = (x.view(np.uint64) >> np.uint64(32)).astype(np.uint32).view(np.float32)
    regular = (narrow > 0) & np.isfinite(narrow) | ~(x > 0) | np.isinf(x)
    return np.where(regular, narrow, leading)


def versions(name, tested, kind):
    """Return {version: function} of all libraries."""
    suffixes = ("plain", *libraries.suffixes())
    found = {
        f"{compiler} {suffix}": getattr(libraries.load(path), f"gs_{name}_{KINDS[kind][2]}_{suffix}")
        for compiler, path in tested.items()
        for suffix in suffixes
    }
    for function in found.values():
        function.restype = None
    return found


def bits_of(function, x, unsigned):
    """Return the bits of a version's values."""
    value = np.empty_like(x)
    function(ctypes.c_size_t(x.size), ctypes.c_void_p(x.ctypes.data), ctypes.c_void_p(value.ctypes.data))
    return value.view(unsigned)


def compare(name, tested, inputs, progress=None, total=0):
    """Hold every version to the bits of the first.

    Returns
    -------
    dict
        Inputs tried in ``binary64`` and ``binary32``, names of the ``versions``, how many values were ``differing``,
        ``examples`` of these, ``seconds``.
    """
    begin = time.perf_counter()
    found = {kind: versions(name, tested, kind) for kind in KINDS}
    row = {"binary64": 0, "binary32": 0, "versions": list(found["binary64"]), "differing": 0, "examples": []}
    for number, doubles in enumerate(inputs):
        for kind, (dtype, unsigned, _) in KINDS.items():
            x = doubles if dtype is np.float64 else as_binary32(doubles)
            (first, base), *others = found[kind].items()
            wanted = bits_of(base, x, unsigned)
            for version, function in others:
                other = np.flatnonzero(bits_of(function, x, unsigned) != wanted)
                row["differing"] += other.size
                row["examples"] += [
                    f"{version} and {first}, {kind}: {name}({float(x[i]).hex()})" for i in other[:SHOWN]
                ]
            row[kind] += x.size
        if progress:
            progress(number + 1, total, name)
    row["examples"] = row["examples"][:SHOWN]
    row["seconds"] = round(time.perf_counter() - begin, 1)
    return row


def main(arguments=None) -> int:
    """Compile, compare, tell, write; the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="primitives; all if none is given")
    parser.add_argument(
        "--count", type=int, default=COUNT, help="inputs of each kind; fewer than %(default)s are not kept"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sources", type=Path, help="a folder of C to try instead of the emitted one; nothing is kept")
    chosen = parser.parse_args(arguments)
    folder, differing = chosen.sources or c_folder(), 0
    sources = {name: digest(name, folder) for name in chosen.names or KERNELS}
    brief = chosen.sources is not None or chosen.count < COUNT
    with tempfile.TemporaryDirectory(prefix="galileo-sym-") as place:
        compilers = [c for c in ("gcc", "clang") if shutil.which(c)] or ["cc"]
        tested = {c: libraries.compile_tested(folder, Path(place) / f"{c}.so", [c], brief) for c in compilers}
        generator = libraries.compile_reference(Path(place) / "reference.so")
        for name, digest_of_it in sources.items():
            inputs = Inputs(name, generator, chosen.count, chosen.seed)
            with progress_bar(f"same bits, {name}") as progress:
                row = compare(name, tested, inputs, progress, -(-chosen.count // CHUNK) + 1)
            differing += row["differing"]
            print(
                f"{name}: {row['binary64']} inputs in binary64 and {row['binary32']} in binary32, "
                f"{len(row['versions'])} versions, {row['differing']} values with other bits; {row['seconds']:.0f} s"
            )
            print("".join(f"  {example}\n" for example in row["examples"]), end="")
            if not chosen.sources and chosen.count >= COUNT:
                results.keep_same_bits(name, row, digest_of_it)
    return int(differing > 0)


if __name__ == "__main__":
    sys.exit(main())
