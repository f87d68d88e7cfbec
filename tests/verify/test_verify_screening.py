"""The screening of a sample: its bounds hold the errors found from the enclosures, and no larger error escapes it."""

import math

import numpy as np
import pytest
from flint import arb, ctx

from galileo_sym.verify.enclosure import ABSENT, INFINITE, ZERO, Enclosure
from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.measure import Task, measure, take_sample
from galileo_sym.verify.sampling import step
from galileo_sym.verify.screening import Rounded, error_bounds, rounded
from galileo_sym.verify.ulp import ulp_error

LEAST, MOST = math.ulp(0.0), math.nextafter(math.inf, 0.0)
with ctx.workprec(200):
    TINY = arb(0, 1) * arb(2) ** -900  # a width far below 2**-90 of the results that it is added to
    EXACT = [
        *(Enclosure(arb(x)) for x in (1.0, -3.0, 0.1, LEAST, 5 * LEAST, 2.0**-1022, MOST)),
        *(Enclosure(arb(x) * arb(2) ** -1074) for x in (0.25, 0.5, 1.5, 2.0**52 - 0.5)),
        *(Enclosure(arb(x) + y * arb(2) ** -60) for x in (1.0, -2.0) for y in (-1, 1)),
        Enclosure(arb(2) ** -3000),
        Enclosure(arb(2) ** 1024),
        Enclosure(arb(1) / 3 + TINY),
        Enclosure(arb(1) + TINY),
        Enclosure(TINY * arb(2) ** -900),
        Enclosure(arb(2) ** -70, arb(0.1)),
        Enclosure(arb(0), arb(4)),
        Enclosure(arb(-1) / 7 * arb(2) ** -1060, arb(2) ** -1040),
        ZERO,
        INFINITE,
        ABSENT,
    ]


@pytest.mark.parametrize("enclosure", EXACT, ids=range(len(EXACT)))
def test_bounds_hold_every_error(enclosure):
    value, rest, unit = rounded(enclosure)
    beside = [step(value, places) for places in (-9, -1, 0, 1, 2)] if value > 0 else [value]
    results = np.array(
        [*beside, value * 1.001, value * 1e9, 0.0, LEAST, 1.0, -1.0, MOST, math.inf, -math.inf, math.nan]
    )
    exact = Rounded(*(np.full(results.shape, x) for x in (value, rest, unit)))
    lower, upper = error_bounds(results, exact)
    for least, result, most in zip(lower, results, upper, strict=True):
        assert least <= ulp_error(result, enclosure) <= most
    if math.isfinite(value) and rest:
        near = np.isfinite(upper) & (upper < 1e6)
        assert near[results == value].all()
        assert (upper - lower <= 2.0**-28 * (1 + upper))[near].all()


def spoil(values, rng):
    """Results some of which are wrong in every way."""
    values = values * (1 + rng.integers(-3, 4, values.shape) * 2.0**-52)
    values[5], values[7] = np.nan, -values[7]
    return values


@pytest.mark.parametrize(
    ("place", "flaw"),
    [
        (("projectile.velocity", "drag", "near-apex"), None),
        (("chord.position", "friction", "near-theta-max"), None),
        (("chord.max_angle", "all", "tiny-friction"), None),
        (("chord.distance", "friction", "at-rest"), None),
        (("lambert.linear_exponential_roots", "all", "degenerate"), None),
        (("projectile.velocity", "drag", "near-apex"), spoil),
        (("chord.distance", "friction", "at-rest"), lambda values, rng: values + LEAST),
    ],
)
def test_the_first_of_the_largest_errors_is_found(place, flaw):
    sample = take_sample(Task(*place, 60, 3))
    rng = np.random.default_rng(1)
    results = [exact.value if flaw is None else flaw(exact.value, rng) for exact in sample.exact]
    errors = [
        (ulp_error(values[index], enclosure), -index, name)
        for index in range(sample.size)
        for name, values, enclosure in zip(FUNCTIONS[place[0]].outputs, results, sample.references(index), strict=True)
    ]
    largest = max(error for error, _, _ in errors)
    first = next(-index for error, index, _ in errors if error == largest)
    found = measure(sample, results)
    assert (found.error, found.worst) == (largest, sample.point(first))
