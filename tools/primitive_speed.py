"""How long the primitives take: every version of the emitted C beside numpy.exp and numpy.expm1 in the same run.

    python tools/primitive_speed.py [--compiler CC] [--points N] [--rounds R] [--write]

For each primitive: operations of the typical path, scalar latency (each call waits for the one before), and array
throughput of each version on N doubles of its range, as medians of R interleaved rounds; ratios are to numpy.exp on as
many doubles. Shared machines are noisy: compare ratios, of one run.
"""

import argparse
import ctypes
import datetime
import platform
import statistics
import sys
import tempfile
import time
from collections import Counter
from functools import partial
from pathlib import Path

import numpy as np

from galileo_sym.codegen.kernels import runnable
from galileo_sym.files import write_whole
from galileo_sym.libraries import compile_library, find_compiler
from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.kernels import BANKED, KERNELS
from galileo_sym.primitives.lines import near_lines
from galileo_sym.verify.back_ends import generated_folder

ROOT = Path(__file__).resolve().parent.parent
HEAD = """\
# Speed of the primitives

Made by `python tools/primitive_speed.py --write` on {date}, on a shared {machine} machine: compare ratios. Operations
are those of the typical path; a column picked out of a table counts apart. Scalar is the latency of a call, the rest is
of arrays.

"""
LATENCY = """#include "galileo.h"
double gs_latency(double (*f)(double), double x, long count);
double gs_latency(double (*f)(double), double x, long count)
{
    double value = 0.0;
    for (long j = 0; j < count; j++)
        value = f(x + 0.0 * value);
    return value;
}
"""
CALLS = 20000
LONGEST = 32.0  # arguments of a range without end go so far


def supported():
    """Suffixes of the versions this machine runs."""
    plain, *vectors = runnable()
    return [*vectors, plain]


def typical(name):
    """Return (begin, end, lines) of the path that a vector takes unless one of its lanes needs another."""
    if name in BANKED:
        bank = BANKED[name].banks[0]
        return 0.0, APPROXIMATIONS[bank].partition.end, near_lines(bank, False)
    first = KERNELS[name].ranges[0]
    return first.begin, min(first.end, LONGEST), list(first.lines)


def operations(name):
    """How many operations of each kind the typical path takes; a column picked counts as one."""
    total, lines = Counter(), typical(name)[2]
    while lines:
        line = lines.pop()
        if line.operation in ("near", "near_pair"):
            lines += near_lines(line.operands[0], line.operation == "near_pair")
            continue
        total[line.operation] += line.operation not in ("pick", "copy")
        total["pick"] += sum(isinstance(operand, tuple) for operand in line.operands)
    return +total


def build(compiler):
    """Compile the emitted C with the loop that measures latency."""
    with tempfile.TemporaryDirectory(prefix="galileo-sym-") as folder:
        loop = Path(folder) / "latency.c"
        loop.write_text(LATENCY, encoding="utf-8")
        sources = sorted((generated_folder() / "c").glob("*.c"))
        target = Path(folder) / "libspeed.so"
        compile_library([*sources, loop], target, compiler)
        return ctypes.CDLL(str(target))


def address(array):
    """Pointer to the first element."""
    return ctypes.c_void_p(array.ctypes.data)


def contenders(library, names, points):
    """Return {(name, version): callable without arguments}, each on doubles spread over its typical range."""
    rng = np.random.default_rng(1)
    value, x = np.empty(points), rng.uniform(0.0, 10.0, points)
    found = {("numpy.exp", ""): partial(np.exp, x, out=value), ("numpy.expm1", ""): partial(np.expm1, x, out=value)}
    for name in names:
        drawn = rng.uniform(*typical(name)[:2], points)
        pointers = (address(drawn), address(value))
        for version in supported():
            call = partial(getattr(library, f"gs_{name}_n_{version}"), ctypes.c_size_t(points), *pointers)
            call.kept = drawn  # the library holds its address only
            found[name, version] = call
    return found


def timed(call):
    """Nanoseconds of one call."""
    start = time.perf_counter_ns()
    call()
    return time.perf_counter_ns() - start


def medians(calls, rounds):
    """Median nanoseconds of each contender, over interleaved rounds."""
    samples = {key: [] for key in calls}
    for _ in range(rounds):
        for key, call in calls.items():
            call()  # what ran before leaves caches and clocks in another state
            samples[key].append(timed(call))
    return {key: statistics.median(values) for key, values in samples.items()}


def latencies(library, names):
    """Nanoseconds a scalar call, each waiting for the one before."""
    library.gs_latency.restype = ctypes.c_double
    library.gs_latency.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_long]
    found = {}
    for name in names:
        function = ctypes.cast(getattr(library, f"gs_special_{name}"), ctypes.c_void_p)
        begin, end, _ = typical(name)
        x = begin + (end - begin) / 16
        found[name] = min(timed(partial(library.gs_latency, function, x, CALLS)) for _ in range(9)) / CALLS
    return found


def table(points, rounds, compiler):
    """Measure, and return a Markdown table."""
    library, names = build(compiler), list(KERNELS)
    found = medians(contenders(library, names, points), rounds)
    wait = latencies(library, names)
    exp = found["numpy.exp", ""]
    lines = [
        f"{points} doubles of each range, {' '.join(compiler)}, medians of {rounds} rounds;",
        f"numpy.exp {exp / points:.2f} ns an element, numpy.expm1 {found['numpy.expm1', ''] / exp:.2f} times that",
        "",
        f"| primitive | range | operations | scalar, ns | {' | '.join(f'{v}, × exp' for v in supported())} |",
        "|---" * (4 + len(supported())) + "|",
    ]
    for name in names:
        counts = operations(name)
        text = f"{sum(counts.values()) - counts['pick']} + {counts['pick']} picked"
        ratios = " | ".join(f"{found[name, version] / exp:.2f}" for version in supported())
        begin, end, _ = typical(name)
        lines.append(f"| {name} | {begin:.4g} to {end:.4g} | {text} | {wait[name]:.1f} | {ratios} |")
    return "\n".join(lines) + "\n"


def main(arguments=None):
    """Print the table, or write it to docs/primitive_speed.md."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compiler", help="command of the C compiler; by default $CC, cc, gcc or clang")
    parser.add_argument("--points", type=int, default=10000, help="length of the arrays")
    parser.add_argument("--rounds", type=int, default=301, help="interleaved rounds")
    parser.add_argument("--write", action="store_true", help="to docs/primitive_speed.md, with the date")
    options = parser.parse_args(arguments)
    compiler = [options.compiler] if options.compiler else find_compiler()
    text = table(options.points, options.rounds, compiler)
    if options.write:
        page = HEAD.format(date=datetime.date.today().isoformat(), machine=platform.machine())
        write_whole(ROOT / "docs" / "primitive_speed.md", f"{page}{text}".encode())
    else:
        print(text, end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
