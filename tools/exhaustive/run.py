"""Try the binary32 function of every primitive at all 2^32 inputs. Exits with 1 if a value is wrong or unsettled.

A whole run of the emitted code renews tests/data/exhaustive.json and docs/exhaustive.md; a part of it, or one of other
code, writes nothing. An interrupted run goes on where it stopped.
"""

import argparse
import os
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from exhaustive import certain, libraries, results  # noqa: E402 (the package stands beside the installed one)
from exhaustive.emitted import c_folder, digest  # noqa: E402
from exhaustive.sweep import ALL, sweep  # noqa: E402
from galileo_sym.primitives.kernels import KERNELS  # noqa: E402
from galileo_sym.progress import progress_bar  # noqa: E402

SHOWN = 20


def span_of(text):
    """Read FIRST:END, hexadecimal bits."""
    first, end = (int(part, 16) for part in text.split(":"))
    if not 0 <= first < end <= ALL or first % libraries.LANES or end % libraries.LANES:
        raise argparse.ArgumentTypeError(f"{text}: bits from 0 to 100000000, in steps of {libraries.LANES:x}")
    return first, end


def tell(found):
    """Say what was found, in a line, and which inputs are at fault."""
    name = found["primitive"]
    print(
        f"{name}: {found['right']} right, {found['refused']} refused, {found['by_arb']} of all settled by Arb, "
        f"{found['wrong']} wrong, {found['unsettled']} unsettled, {found['differing']} with other bits in another "
        f"version; {found['seconds']:.0f} s"
    )
    for kind in results.FAULTS:
        for bits in found["inputs"][kind][:SHOWN]:
            print(f"  {kind}: {name}({certain.of_bits(bits).hex()}), bits {bits:08x}")


def arguments_of(arguments):
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="primitives; all if none is given")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    parser.add_argument(
        "--span", type=span_of, default=(0, ALL), metavar="FIRST:END", help="bits of inputs, hexadecimal"
    )
    parser.add_argument("--sources", type=Path, help="a folder of C to try instead of the emitted one")
    parser.add_argument("--shift", type=float.fromhex, help="make the reference wrong by this much")
    parser.add_argument(
        "--stale", action="store_true", help="only primitives whose committed result is of other sources"
    )
    chosen = parser.parse_args(arguments)
    unknown = sorted(set(chosen.names) - set(KERNELS))
    if unknown:
        parser.error(f"no primitive {', '.join(unknown)}; there are {', '.join(KERNELS)}")
    return chosen


def main(arguments=None) -> int:
    """Compile, try, tell, write; the exit code."""
    chosen = arguments_of(arguments)
    folder = chosen.sources or c_folder()
    whole = chosen.span == (0, ALL) and not chosen.sources and not chosen.shift
    names = chosen.names or list(KERNELS)
    if chosen.stale:
        names = [name for name in names if results.stale(name)]
    sources = {name: digest(name, folder) for name in names}
    faults = 0
    with tempfile.TemporaryDirectory(prefix="galileo-sym-") as place:
        tested = libraries.compile_tested(folder, Path(place) / "tested.so", quickly=not whole)
        reference = libraries.compile_reference(Path(place) / "reference.so", chosen.shift)
        for name in names:
            state = ROOT / "build" / "exhaustive" / f"{name}.json" if whole else None
            with progress_bar(f"exhaustive, {name}") as progress:
                found = sweep(name, tested, reference, sources[name], chosen.span, state, chosen.processes, progress)
            tell(found)
            faults += results.faults(found)
            if whole:
                state.unlink(missing_ok=True)
                results.keep_exhaustive(found, sources[name])
    return int(faults > 0)


if __name__ == "__main__":
    sys.exit(main())
