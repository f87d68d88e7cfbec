"""Pairs at the ends of factors: driving forces that hold, rounding to doubles, what is out of range.

Emitted scenes hold these definitions, too: names of the emitted modules are imported as they are.
"""

from typing import NamedTuple

import numpy as np

from galileo_sym.generated._scaled import Scaled, store

MOST = 500  # exponents of factors whose product is sure to be a normal number
SPLITTER = 134217729.0  # 2**27 + 1: splits a double into 26 bits and the rest


class Rest(NamedTuple):
    """A driving force, 1 in place of what is not positive, and where that is."""

    force: Scaled
    held: np.ndarray


class Factor(NamedTuple):
    """Doubles, one array or two; and where they do not serve: out of range or infinite. None: they serve everywhere."""

    parts: tuple
    odd: np.ndarray | None


def sliding(force):
    """Return a driving force with 1 where it holds the bead, and where that is."""
    held = force.hi <= 0.0
    if not held.any():
        return Rest(force, held)
    one = Scaled(np.where(held, 1.0, force.hi), np.where(held, 0.0, force.lo), np.where(held, 0, force.e))
    return Rest(one, held)


def in_range(value):
    """Return a pair with 0 in place of what is out of range, and where that is; None if nothing is."""
    hi, lo, e = np.broadcast_arrays(*value)
    odd = ((e < -MOST) | (e > MOST)) & (hi != 0.0)
    if not odd.any():
        return value.hi, value.lo, np.where(hi == 0.0, 0, e), None
    return np.where(odd, 0.0, hi), np.where(odd, 0.0, lo), np.where(odd, 0, e), odd


def rounded_factor(value, at_rest, *forces):
    """Return a pair as doubles; the value at rest where one of the driving forces holds the bead."""
    hi, _, e, odd = in_range(value)
    return settled(np.ldexp(hi, e), odd, at_rest, *forces)


def settled(number, odd, at_rest, *forces):
    """Return doubles as a factor: the value at rest, in range, where one of the driving forces holds the bead."""
    for force in forces:
        if force.held.any():
            number = np.where(force.held, at_rest, number)
            odd = None if odd is None else odd & ~force.held
    return Factor((number,), odd)


def stored_factor(value, at_rest, *forces):
    """Return a pair as doubles of any size; the value at rest where one of the driving forces holds the bead."""
    for force in forces:  # what is not to be rounded raises no flag
        value = Scaled(*(np.where(force.held, 0, part) for part in value))
    number = store(value)
    for force in forces:
        number = np.where(force.held, at_rest, number)
    return Factor((number,), None)


def halved_factor(value):
    """Return a pair as two doubles, the first of 26 bits: products of two such are exact."""
    hi, lo, e, odd = in_range(value)
    high = SPLITTER * hi
    high = high - (high - hi)
    return Factor((np.ldexp(high, e), np.ldexp((hi - high) + lo, e)), odd)


def parted_factor(value):
    """Return a pair as two doubles, the first rounded to the nearest."""
    hi, lo, e, odd = in_range(value)
    return Factor((np.ldexp(hi, e), np.ldexp(lo, e)), odd)
