"""The root of an equation in another unit of its unknown."""

import pytest
import sympy as sp
from sympy import Interval

from galileo_sym.ledger import DerivationError, ExactlyOneRoot, StrictlyIncreasing
from galileo_sym.tactics import root_at_scale

x, z = sp.symbols("x z", real=True)
c = sp.Symbol("c", positive=True)
ROOT = ExactlyOneRoot(x**2 - 2 * c**2, x, Interval.Lopen(0, 3 * c))


def test_the_interval_and_the_equation_are_scaled():
    assert root_at_scale(ROOT, z, c, over=c**2) == ExactlyOneRoot(z**2 - 2, z, Interval.Lopen(0, 3))
    endless = ExactlyOneRoot(x - c, x, Interval.open(0, sp.oo))
    assert root_at_scale(endless, z, c) == ExactlyOneRoot(c * z - c, z, Interval.open(0, sp.oo))


@pytest.mark.parametrize(
    ("claim", "unit", "over"),
    [
        (ROOT, -c, 1),  # turns the interval round
        (ROOT, sp.Symbol("d", real=True), 1),  # of unknown sign
        (ROOT, c, sp.Symbol("d", real=True)),  # may be 0
        (ROOT, 1 + z**2, 1),  # no unit
        (ROOT, c, 1 + x**2),  # other roots are possible only without it
        (StrictlyIncreasing(x, x, Interval(0, 1)), c, 1),
    ],
)
def test_refused(claim, unit, over):
    with pytest.raises(DerivationError):
        root_at_scale(claim, z, unit, over=over)
