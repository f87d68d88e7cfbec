"""How long the primitives take: every version of the emitted C beside numpy.exp and numpy.expm1 in the same run.

    python tools/primitive_speed.py [--compiler CC] [--points N] [--rounds R]

For each primitive: operations of the typical path, scalar latency (each call waits for the one before), and array
throughput of each version on N doubles of the first pieces, as medians of R interleaved rounds; ratios are to
numpy.exp on the same count. Shared machines are noisy: compare ratios, of one run.
"""

import argparse
import ctypes
import statistics
import sys
import tempfile
import time
from collections import Counter
from functools import partial
from pathlib import Path

import numpy as np

from galileo_sym.codegen.kernels import TARGETS
from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.kernels import KERNELS, near_lines
from galileo_sym.verify.back_ends import generated_folder
from galileo_sym.verify.native import compile_library, find_compiler

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


def supported():
    """Suffixes of the versions this machine runs."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return ["plain"]
    flags = set(next((line for line in lines if line.startswith("flags")), "").split())
    return [*(s for s, (_, features, _) in TARGETS.items() if set(features.split(",")) <= flags), "plain"]


def operations(name):
    """How many operations of each kind the first bank of a primitive takes; a column picked counts as one."""
    total = Counter()
    for line in near_lines(KERNELS[name].banks[0], False):
        total[line.operation] += line.operation != "pick"
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


def contenders(library, names, x):
    """Return {(name, version): callable without arguments}."""
    value = np.empty_like(x)
    found = {("numpy.exp", ""): lambda: np.exp(x, out=value), ("numpy.expm1", ""): lambda: np.expm1(x, out=value)}
    size, pointers = ctypes.c_size_t(x.size), (address(x), address(value))
    for name in names:
        for version in supported():
            found[name, version] = partial(getattr(library, f"gs_{name}_n_{version}"), size, *pointers)
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


def latencies(library, names, x):
    """Nanoseconds a scalar call, each waiting for the one before."""
    library.gs_latency.restype = ctypes.c_double
    library.gs_latency.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_long]
    found = {}
    for name in names:
        function = ctypes.cast(getattr(library, f"gs_special_{name}"), ctypes.c_void_p)
        found[name] = min(timed(lambda f=function: library.gs_latency(f, x, CALLS)) for _ in range(9)) / CALLS
    return found


def main(arguments=None):
    """Measure, and print a Markdown table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compiler", help="command of the C compiler; by default $CC, cc, gcc or clang")
    parser.add_argument("--points", type=int, default=10000, help="length of the arrays")
    parser.add_argument("--rounds", type=int, default=301, help="interleaved rounds")
    options = parser.parse_args(arguments)
    compiler = [options.compiler] if options.compiler else find_compiler()
    library, names = build(compiler), list(KERNELS)
    ends = [APPROXIMATIONS[KERNELS[name].banks[0]].partition.end for name in names]
    x = np.random.default_rng(1).uniform(0.0, min(ends), options.points)
    found = medians(contenders(library, names, x), options.rounds)
    wait = latencies(library, names, 0.75)
    exp = found["numpy.exp", ""]
    print(f"{options.points} doubles in [0, {min(ends)}), {' '.join(compiler)}, medians of {options.rounds} rounds;")
    expm1 = found["numpy.expm1", ""] / exp
    print(f"numpy.exp {exp / options.points:.2f} ns an element, numpy.expm1 {expm1:.2f} times that\n")
    print(f"| primitive | operations | scalar, ns | {' | '.join(f'{v}, × exp' for v in supported())} |")
    print("|---" * (3 + len(supported())) + "|")
    for name in names:
        counts = operations(name)
        text = f"{sum(counts.values()) - counts['pick']} + {counts['pick']} picked"
        ratios = " | ".join(f"{found[name, version] / exp:.2f}" for version in supported())
        print(f"| {name} | {text} | {wait[name]:.1f} | {ratios} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
