"""Samples of the compiled primitives against multiprecision: a maximum above the proved bound refutes the proof."""

from fractions import Fraction

import numpy as np

from .binary64 import exponent, power, ulp
from .references import reference

_LEAST = -60  # of the exponents drawn near 0: what lies below is 1 ulp of the value at 0 at most
_PAST = 12  # binades drawn beyond the last bank


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


def errors(name, x, values):
    """Return errors of a primitive in ulps of the true value.

    Parameters
    ----------
    name : str
        The primitive.
    x : ndarray
        Positive arguments.
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
        exact = Fraction(int(true.man)) * power(int(true.exp))
        found.append(float(abs(Fraction(float(value)) - exact) / ulp(exact)))
    return found
