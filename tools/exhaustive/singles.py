"""Hold the quick binary32 primitives to those by pairs, which `run.py` judges. Exits with 1 if a bit differs.

The widest version that the machine can run is tried at all 2^32 inputs, the others at some of them. A whole run
renews tests/data/exhaustive.json and docs/exhaustive.md.
"""

import argparse
import ctypes
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from exhaustive import libraries, results  # noqa: E402 (the package stands beside the installed one)
from exhaustive.emitted import c_folder, singles_digest  # noqa: E402
from galileo_sym.codegen.kernels import TARGETS  # noqa: E402
from galileo_sym.primitives.kernels import KERNELS  # noqa: E402
from galileo_sym.progress import progress_bar  # noqa: E402

STRETCH = 1 << 20
STRETCHES = (1 << 32) // STRETCH
SHARES = {8: 1, 4: 16, 1: 256}  # of versions of so many lanes, one stretch of so many is tried


def differing(library, name, version, stretch):
    """Return the inputs of a stretch at which the quick version has other bits than that by pairs.

    Parameters
    ----------
    library : path
        The compiled primitives.
    name, version : str
        A primitive, and the suffix of one of its versions.
    stretch : int
        Which of the stretches of inputs, in the order of their bits.
    """
    bits = np.arange(stretch * STRETCH, (stretch + 1) * STRETCH, dtype=np.uint32)
    found = []
    for kind in ("nf", "ns"):
        value = np.empty_like(bits)
        function = getattr(libraries.load(library), f"gs_{name}_{kind}_{version}")
        function.restype = None
        function(ctypes.c_size_t(bits.size), ctypes.c_void_p(bits.ctypes.data), ctypes.c_void_p(value.ctypes.data))
        found.append(value)
    return bits[found[0] != found[1]]


def compare(library, name, stretches=range(STRETCHES), progress=None):
    """Compare all versions that this machine can run.

    Returns
    -------
    dict
        ``inputs`` tried by version, how many were ``differing``, ``examples`` of these (bits), ``seconds``.
    """
    begin = time.perf_counter()
    row = {"inputs": {}, "differing": 0, "examples": []}
    runnable = ("plain", *libraries.suffixes())
    widest = max(runnable, key=lambda version: TARGETS[version][2] if version in TARGETS else 0)
    for version in runnable:
        share = SHARES[1 if version == "plain" else TARGETS[version][2]]
        chosen = stretches[:: share if version != widest else 1]
        with ThreadPoolExecutor(2) as pool:
            found = pool.map(lambda stretch, v=version: differing(library, name, v, stretch), chosen)
            for number, bits in enumerate(found, 1):
                row["differing"] += bits.size
                row["examples"] += [f"{version}: {one:08x}" for one in bits[:20]]
                if progress:
                    progress(number, len(chosen), f"{name}, {version}")
        row["inputs"][version] = len(chosen) * STRETCH
    return row | {"examples": row["examples"][:20], "seconds": round(time.perf_counter() - begin, 1)}


def main(arguments=None) -> int:
    """Compile, compare, tell, write; the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="primitives; all whose result is missing or stale if none is given")
    parser.add_argument("--every", type=int, default=1, help="try one stretch of so many; then nothing is kept")
    chosen = parser.parse_args(arguments)
    total = 0
    with tempfile.TemporaryDirectory(prefix="galileo-sym-") as place:
        library = libraries.compile_tested(c_folder(), Path(place) / "tested.so")
        for name in chosen.names or [name for name in KERNELS if results.stale(name, "singles")]:
            with progress_bar(f"quick binary32, {name}") as progress:
                row = compare(library, name, range(0, STRETCHES, chosen.every), progress)
            total += row["differing"]
            inputs = ", ".join(f"{version} {count}" for version, count in row["inputs"].items())
            print(f"{name}: {inputs} inputs, {row['differing']} with other bits; {row['seconds']:.0f} s", flush=True)
            print("".join(f"  {example}\n" for example in row["examples"]), end="")
            if chosen.every == 1:
                results.keep_singles(name, row, singles_digest(name))
    return int(total > 0)


if __name__ == "__main__":
    sys.exit(main())
