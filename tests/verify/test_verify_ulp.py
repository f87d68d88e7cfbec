"""Errors in ulps: binade boundaries, subnormals, zero, infinities, NaN, both formats."""

import math
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx

from galileo_sym.verify.enclosure import INFINITE, ZERO, Enclosure
from galileo_sym.verify.ulp import BINARY32, BINARY64, representable, rounded_up, ulp_error

TINY = math.ldexp(1.0, -1074)
MAX = float(np.finfo(np.float64).max)


def exactly(man, exp=0, scale=None):
    return Enclosure(ball(man, man, exp), scale)


def ball(low, high, exp=0):
    """The ball between two dyadic numbers, exactly."""
    with ctx.workprec(4000):
        middle, radius = (arb(low) + high) / 2, (arb(high) - low) / 2
        return (arb(middle, radius) if low < high else middle) * arb(2) ** exp


def between(low, high):
    return Enclosure(ball(low, high))


@pytest.mark.parametrize(
    ("value", "exact", "error"),
    [
        (1.0, exactly(1), 0.0),
        (math.nextafter(1.0, 2.0), exactly(1), 1.0),
        (math.nextafter(1.0, 0.0), exactly(1), 0.5),
        # just below a binade the unit is the smaller one
        (1.0, exactly(2**60 - 2**4, -60), 2.0**-56 / 2.0**-53),
        (math.nextafter(1.0, 2.0), exactly(2**60 - 2**4, -60), (2.0**-52 + 2.0**-56) / 2.0**-53),
        (-3.0, exactly(-3), 0.0),
        (3.0, exactly(-3), 6 / 2.0**-51),
        (0.0, ZERO, 0.0),
        (-0.0, ZERO, 0.0),
        (TINY, ZERO, 1.0),
        (5 * TINY, exactly(9, -1075), 0.5),
        (0.0, exactly(1, -1075), 0.5),
        (0.0, exactly(1, -1074), 1.0),
        (math.ldexp(1.0, -1022), exactly(2**52 - 1, -1074), 1.0),
        (math.inf, INFINITE, 0.0),
        (MAX, INFINITE, math.inf),
        (-math.inf, INFINITE, math.inf),
        (math.nan, exactly(1), math.inf),
        (math.nan, INFINITE, math.inf),
        (math.inf, exactly(1, 1024), 0.0),
        (math.inf, exactly(2**54 - 1, 970), 0.0),
        (math.inf, exactly(2**55 - 3, 969), 0.75),
        (-math.inf, exactly(1, 1024), math.inf),
        (MAX, exactly(1, 1024), 1.0),
        (math.inf, exactly(1), math.inf),
    ],
)
def test_error(value, exact, error):
    assert ulp_error(value, exact) == error


def test_binary32():
    exact = exactly(1)
    assert ulp_error(np.nextafter(np.float32(1), np.float32(2)), exact, BINARY32) == 1.0
    assert ulp_error(np.float32(0), exactly(1, -149), BINARY32) == 1.0
    assert ulp_error(np.float32(np.inf), exactly(1, 128), BINARY32) == 0.0
    assert ulp_error(float(np.finfo(np.float32).max), exactly(1, 128), BINARY32) == 1.0
    assert ulp_error(1.0, exact, BINARY32) == ulp_error(1.0, exact, BINARY64) == 0.0


def test_upper_bound_over_the_enclosure():
    # a radius is rounded up to 30 bits
    assert 8.0 <= ulp_error(1.0, between(1.0 + 2.0**-51, 1.0 + 2.0**-49)) < 8.0 * (1 + 2.0**-27)
    # an enclosure across a binade boundary: the smaller unit counts
    assert 2.0 <= ulp_error(1.0, between(1.0 - 2.0**-53, 1.0 + 2.0**-52)) < 2.0 * (1 + 2.0**-27)
    assert ulp_error(1.0, between(-1.0, 1.0)) == math.inf


def test_never_rounds_down():
    exact = exactly(3**90)
    value = float(3**90)
    true = abs(Fraction(value) - 3**90) / Fraction(2) ** (143 - 53)
    assert 0 < true <= Fraction(ulp_error(value, exact))


def test_scale_replaces_the_unit():
    assert ulp_error(2.0**-52, Enclosure(arb(0), arb(1))) == 1.0
    assert ulp_error(2.0**-52, Enclosure(arb(0), arb(8))) == 0.125


@pytest.mark.parametrize(
    ("exact", "holds"),
    [
        (ZERO, True),
        (INFINITE, True),
        (exactly(1, -1074), True),
        (exactly(1, -1075), False),
        (exactly(1, 1023), True),
        (exactly(1, 1024), False),
        (Enclosure(arb(0), arb(0)), True),
        (Enclosure(ball(-1, 1), arb(2) ** 1024), False),
    ],
)
def test_representable(exact, holds):
    assert representable(exact) is holds


@pytest.mark.parametrize("error", [0.5, 0.50001, 1.234567, 3.9999, 1e-9, 12345.6, 0.1 + 0.2, 7e300])
def test_rounded_up(error):
    rounded = rounded_up(error)
    assert error <= rounded <= error * 1.011
    assert len(repr(rounded).split("e")[0].replace(".", "").strip("0")) <= 3


def test_rounded_up_keeps_zero_and_infinity():
    assert rounded_up(0.0) == 0.0
    assert rounded_up(math.inf) == math.inf
