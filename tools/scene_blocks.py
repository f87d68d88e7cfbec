"""Reduce a scene's grid that is larger than memory block by block, and write another one to memory-mapped files.

    python tools/scene_blocks.py [--times N] [--angles N] [--max-bytes N] [--mapped-bytes N] [--folder DIR] [--write]

Prints both runs: points, blocks, time, and the most memory of the process, as the system counts it; each in a process
of its own. Exits with 1 if either took more than max-bytes beside what the process had before, its axes and what the
reduction keeps. `--write` also writes docs/scene_blocks.md, if both held.
"""

import argparse
import datetime
import json
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from galileo_sym import Scene
from galileo_sym.files import write_whole

ROOT = Path(__file__).resolve().parent.parent
SPINDLE = Scene("chord", over=("t", "theta"), outputs=("x", "y"), g=9.81, mu=0.36, gamma=0.5)
SPARE = 32 * 2**20  # bytes for what the allocator keeps
HEAD = """\
# Grids larger than memory

Made by `make scene-blocks` on {date}; not written by hand. Beads with friction and drag, outputs x and y, over times
and angles, by `Scene.blocks` with `max_bytes` of {allowed}. Memory is the most that the process had (`ru_maxrss`), less
what it had with its axes and before the first block; each run is a process of its own.

| run | times x angles | bytes of the grid | blocks | seconds | most memory |
|---|---|---|---|---|---|
"""


def megabytes(count):
    """A number of bytes in MB, as text."""
    return f"{count / 1e6:.1f} MB"


def most_memory():
    """The most bytes that this process has had."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def axes_of(times, angles):
    """Times and angles of the grid."""
    return {"t": np.linspace(0.0, 10.0, times), "theta": np.linspace(-1.57, 1.57, angles)}


def reduced(times, angles, max_bytes, folder):
    """Sum, least and greatest of each output at each angle; how many blocks that took."""
    sums, least, most = np.zeros((2, angles)), np.full((2, angles), np.inf), np.full((2, angles), -np.inf)
    count = 0
    for index, found in blocks(times, angles, max_bytes, None):
        count += 1
        for place, values in enumerate(found):
            columns = place, index[1]
            sums[columns] += values.sum(axis=0)
            np.minimum(least[columns], values.min(axis=0), out=least[columns])
            np.maximum(most[columns], values.max(axis=0), out=most[columns])
    last = SPINDLE(t=axes_of(times, angles)["t"][[0, -1]], theta=axes_of(times, angles)["theta"])
    for place, ends in enumerate(last):  # beads go one way: the first and the last time are the extremes
        held = np.array_equal(least[place], ends.min(axis=0)) and np.array_equal(most[place], ends.max(axis=0))
        if not (held and np.all(np.abs(sums[place]) <= times * np.abs(ends[1]) * (1.0 + 1e-9))):
            raise RuntimeError("the reduction is wrong")
    return count


def mapped(times, angles, max_bytes, folder):
    """Write both outputs to files; how many blocks that took."""
    names = [Path(folder) / f"{output}.npy" for output in SPINDLE.outputs]
    out = tuple(np.lib.format.open_memmap(name, "w+", np.float64, (times, angles)) for name in names)
    count = sum(1 for _ in blocks(times, angles, max_bytes, out))
    axes = axes_of(times, angles)
    some = np.linspace(0, times - 1, 5).astype(int)
    expected = SPINDLE(t=axes["t"][some], theta=axes["theta"])
    for name, values in zip(names, expected, strict=True):
        if not np.array_equal(np.load(name, mmap_mode="r")[some], values):
            raise RuntimeError("the files are wrong")
    return count


def blocks(times, angles, max_bytes, out):
    """The blocks of the grid, with a bar on a terminal."""
    return SPINDLE.blocks(max_bytes=max_bytes, out=out, progress=True, **axes_of(times, angles))


RUNS = {"reduced: sum, min, max at each angle": reduced, "memory-mapped output": mapped}


def one(name, times, angles, max_bytes, folder):
    """Carry out a run in this process; what it took."""
    SPINDLE(t=np.ones(10), theta=np.ones(10))  # all is loaded
    axes_of(times, angles)
    before, start = most_memory(), time.perf_counter()
    count = RUNS[name](times, angles, max_bytes, folder)
    return {"blocks": count, "seconds": time.perf_counter() - start, "memory": most_memory() - before}


def measured(name, times, angles, max_bytes, folder):
    """What a run takes in a process of its own."""
    words = [sys.executable, __file__, "--run", name, "--times", times, "--angles", angles]
    words += ["--max-bytes", max_bytes, "--folder", folder]
    done = subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE)
    return {"times": times, "angles": angles, **json.loads(done.stdout)}


def arguments_of(arguments):
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--times", type=int, default=10**6)
    parser.add_argument("--angles", type=int, default=10**4)
    parser.add_argument("--max-bytes", type=int, default=128 * 2**20)
    parser.add_argument("--mapped-bytes", type=int, default=16 * 10**8, help="of both files, on the disk of --folder")
    parser.add_argument("--folder", help="for the files; one of the system's temporary ones by default")
    parser.add_argument("--write", action="store_true", help="write docs/scene_blocks.md")
    parser.add_argument("--run", choices=RUNS, help=argparse.SUPPRESS)
    return parser.parse_args(arguments)


def main(arguments=None) -> int:
    """Run both, tell, write; the exit code."""
    chosen = arguments_of(arguments)
    if chosen.run:
        print(json.dumps(one(chosen.run, chosen.times, chosen.angles, chosen.max_bytes, chosen.folder)))
        return 0
    rows = max(1, chosen.mapped_bytes // (16 * chosen.angles))
    with tempfile.TemporaryDirectory(dir=chosen.folder) as folder:
        if shutil.disk_usage(folder).free < 2 * chosen.mapped_bytes:
            print(f"{folder}: less than {megabytes(2 * chosen.mapped_bytes)} are free: give another --folder")
            return 2
        lengths = dict(zip(RUNS, (chosen.times, rows), strict=True))
        found = {name: measured(name, n, chosen.angles, chosen.max_bytes, folder) for name, n in lengths.items()}
    lines = [
        f"| {name} | {row['times']} x {row['angles']} | {megabytes(16 * row['times'] * row['angles'])} "
        f"| {row['blocks']} | {row['seconds']:.1f} | {megabytes(row['memory'])} |"
        for name, row in found.items()
    ]
    date = datetime.date.today().isoformat()
    text = HEAD.format(date=date, allowed=megabytes(chosen.max_bytes)) + "\n".join(lines) + "\n"
    print(text, end="")
    kept = 7 * 8 * chosen.angles + 16 * (chosen.times + chosen.angles)
    if any(row["memory"] > chosen.max_bytes + kept + SPARE for row in found.values()):
        print(f"more memory than max_bytes={chosen.max_bytes}, what the reduction keeps and {megabytes(SPARE)}")
        return 1
    if chosen.write:
        write_whole(ROOT / "docs" / "scene_blocks.md", text.encode())
    return 0


if __name__ == "__main__":
    sys.exit(main())
