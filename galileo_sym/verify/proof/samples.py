"""Samples of the compiled primitives against multiprecision: a maximum above the proved bound refutes the proof."""

from fractions import Fraction

import numpy as np
from mpmath import mag

from .binary64 import exponent, power, ulp
from .references import reference

_LEAST = -60  # of the exponents drawn near 0: what lies below is 1 ulp of the value at 0 at most
_VANISHING = -5000  # of a reference's exponents: as good as 0 for any double
_PAST = 12  # binades drawn beyond the last bank
SMALLEST_DRAWN, LARGEST_DRAWN = 5e-324, 1.7e308


def points(served, count, seed):
    """Draw arguments of a primitive: spread over its banks and their binades, and beyond; and both sides of every end.

    Parameters
    ----------
    served : Served
    count : int
        How many are drawn at random.
    seed : int

    Returns
    -------
    ndarray
    """
    random = np.random.default_rng(seed)
    last = float(served.far_from)
    ends = np.array([last, *(float(bank.begin) for bank in served.banks[1:])])
    steps = np.array([2.0**e * (1 + s / 4) for e in range(-8, exponent(served.far_from) + 2) for s in range(4)])
    drawn = [
        random.uniform(0, last, count // 2),
        2.0 ** random.uniform(_LEAST, np.log2(last), count // 4),
        2.0 ** random.uniform(np.log2(last), np.log2(last) + _PAST, count // 4),
    ]
    return np.concatenate([*drawn, *(np.nextafter(at, to) for at in (ends, steps) for to in (at, 0, np.inf))])


def frame_points(frame, count, seed):
    """Draw arguments of a frame's primitive: evenly and by magnitude in each range, and both sides of every end.

    Parameters
    ----------
    frame : Frame
    count : int
        How many are drawn at random in all.
    seed : int

    Returns
    -------
    ndarray
        Without 0.
    """
    random = np.random.default_rng(seed)
    drawn, share = [], count // (2 * len(frame.ranges))
    low, high = (float(np.clip(float(end), -LARGEST_DRAWN, LARGEST_DRAWN)) for end in (frame.low, frame.high))
    for served in frame.ranges:
        ends = [float(np.clip(float(end), low, high)) for end in (served.begin, served.end)]
        sizes = np.log2(np.clip(np.abs(ends), SMALLEST_DRAWN, LARGEST_DRAWN))
        sign = -1.0 if ends[0] < 0 else 1.0
        drawn += [random.uniform(ends[0], min(ends[1], ends[0] + _PAST), share)]
        drawn += [sign * 2.0 ** random.uniform(*sorted(sizes), share)]
        drawn += [np.nextafter(ends, to) for to in (ends, -np.inf, np.inf)]
    x = np.concatenate(drawn)
    if frame.parity:
        x = x * random.choice([-1.0, 1.0], x.size)
    return x[(x != 0) & (x >= low) & (x <= high)]


def errors(name, x, values):
    """Return errors of a primitive in ulps of the true value.

    Parameters
    ----------
    name : str
        The primitive.
    x : ndarray
        Arguments other than 0.
    values : ndarray
        What was computed there.

    Returns
    -------
    list of float

    Raises
    ------
    NoReference
        If the primitive has no definition to be held against.
    """
    found = []
    for at, value in zip(x, values, strict=True):
        true = reference(name, float(at))
        vanishing = mag(true) < _VANISHING  # 2^-10^300 as a fraction would fill the memory
        exact = Fraction(0) if vanishing else Fraction(int(true.man)) * power(int(true.exp)) * (-1 if true < 0 else 1)
        found.append(float(abs(Fraction(float(value)) - exact) / ulp(exact)))
    return found
