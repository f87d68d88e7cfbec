"""The files of hard cases, `tests/data/NAME.wc`: an input a line, hexadecimal, with what it is about after `#`."""

from itertools import pairwise
from math import copysign, inf, nextafter
from pathlib import Path

import numpy as np

from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.frames import Frame
from galileo_sym.primitives.kernels import KERNELS
from galileo_sym.primitives.pieces import COUNT

FOLDER = Path(__file__).resolve().parents[2] / "tests" / "data"
LARGEST_FLOAT = float(np.finfo(np.float32).max)
EXTREMES = (5e-324, 2.0**-1022, 2.0**-149, 2.0**-126, 2.0**-54, 2.0**-25, 2.0**127, LARGEST_FLOAT)
EXTREMES += (2.0**1023, float(np.finfo(np.float64).max))
NEIGHBOURS = 2  # on either side of an end
PARTS = 8  # of a range that is not of one approximation alone
SMALLEST = 2.0**-200  # what the references are made for
LARGEST = {"exp_minus": 512.0}
LARGEST_ELSE = 2.0**200


def within(name, x):
    """Return whether a number is in the domain of a primitive, not 0 and finite."""
    least, greatest = KERNELS[name].domain
    return least <= x <= greatest and x != 0.0 and abs(x) < inf


def thresholds(name):
    """Return where one formula of a primitive gives way to another, and the finite ends of its domain."""
    kernel = KERNELS[name]
    if not isinstance(kernel, Frame):
        partitions = [APPROXIMATIONS[bank].partition for bank in kernel.banks]
        return sorted({partition.bounds(i)[1] for partition in partitions for i in range(COUNT)})
    ends = {r.begin for r in kernel.ranges} | {r.end for r in kernel.ranges} | set(kernel.domain)
    return sorted(x for x in (ends | {-x for x in ends} if kernel.parity else ends) if within(name, x))


def _parts(low, high):
    """Cut [low, high): alike in ratio if it is long and does not begin at 0."""
    if low > 0.0 and high > 64.0 * low:
        ends = [low * (high / low) ** (k / PARTS) for k in range(PARTS)]
    else:
        ends = [low + (high - low) * (k / PARTS) for k in range(PARTS)]
    return list(pairwise([*ends, high]))


def sizes(name):
    """Return intervals of abs(x) that cover what the reference is made for, each with the sign of x.

    Returns
    -------
    list of (float, float, float)
        Low, high, sign: pieces of an approximation, or parts of a range.
    """
    kernel, largest = KERNELS[name], LARGEST.get(name, LARGEST_ELSE)
    found = []
    for sign in (1.0, -1.0) if kernel.domain[0] < 0.0 else (1.0,):
        inner = [sign * x for x in thresholds(name) if SMALLEST < sign * x < largest]
        outer = sign * kernel.domain[0 if sign < 0.0 else 1]
        ends = sorted({SMALLEST, *inner, min(largest, outer)}) if outer > SMALLEST else []
        spans = list(pairwise(ends))
        cut = [part for span in spans for part in _parts(*span)] if isinstance(kernel, Frame) else spans
        found += [(low, high, sign) for low, high in cut]
    return found


def typical(name):
    """Return an interval in which most arguments lie."""
    kernel = KERNELS[name]
    if not isinstance(kernel, Frame):
        return 0.0, 1.25 * kernel.end
    first = kernel.ranges[0]
    return (-first.end if kernel.parity else first.begin), first.end


def _neighbours(x, kind, step):
    found = []
    for towards in (-inf, inf):
        neighbour = kind(x)
        for _ in range(NEIGHBOURS):
            neighbour = step(neighbour, kind(towards))
            found.append(float(neighbour))
    return found


def ends(name):
    """Return the thresholds and the doubles and floats next to them, and the extremes, as far as they are arguments."""
    found = [copysign(x, sign) for x in EXTREMES for sign in (1.0, -1.0)]
    for begin in thresholds(name):
        found += [begin, *_neighbours(begin, float, nextafter)]
        if abs(begin) < LARGEST_FLOAT / 2:
            found += _neighbours(begin, np.float32, np.nextafter)
    return sorted({x for x in found if within(name, x)})


def path_of(name):
    """Return where the hard cases of a primitive are."""
    return FOLDER / f"{name}.wc"


def read(name):
    """Return the committed inputs of a primitive, exact doubles; none if there is no file."""
    path = path_of(name)
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    return [float.fromhex(text) for text in (line.partition("#")[0].strip() for line in lines) if text]


def floats(inputs):
    """Return those of the inputs that are floats, as an array."""
    x = np.array(inputs)
    with np.errstate(over="ignore"):
        return x[x.astype(np.float32) == x].astype(np.float32)
