"""Signs, monotony and order: the ladder and its kin climb what is true, and nothing else."""

from typing import ClassVar

import pytest
import sympy as sp
from sympy import Eq, Ge, Gt, Interval, Le, Lt, Rational, exp, oo, pi

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.tactics import (
    arguments_reversed,
    ladder,
    monotone,
    monotone_by_slope,
    not_negative,
    positive_before_root,
    restricted,
    sign_by_factors,
    values_ordered,
)

x, y, z = sp.symbols("x y z", real=True)
p, q, k = sp.symbols("p q k", positive=True)
refused = pytest.raises(DerivationError)

WHOLE = Interval(-oo, oo)


def _eq(left, right):
    return Eq(left, right, evaluate=False)


class TestSigns:
    @pytest.mark.parametrize("true", [exp(z) - 1 - z, sp.sinh(z) - z, z * exp(z) + z - 2 * exp(z) + 2, z - 1 + exp(-z)])
    def test_the_ladder_climbs(self, true):
        assert ladder(true, z) == Gt(true, 0, evaluate=False)

    @pytest.mark.parametrize(
        "false",
        [
            exp(z) - 1 - 2 * z,
            1 - z,
            z - 1,
            -exp(z),
            z - sp.sinh(z),
            z**2 / 2 - exp(z) + 1 + z + z**3 / 6,
            sp.S.Zero,
            z**2 - z / 10**9,
            exp(-z) - Rational(1, 10**9),
        ],
    )
    def test_the_ladder_does_not_climb_what_is_false(self, false):
        with pytest.raises(DerivationError, match="no proof"):
            ladder(false, z)

    def test_factors_of_known_sign(self):
        assert sign_by_factors(-p * (x - y), {x - y: Lt(x, y)}) == 1
        assert sign_by_factors(-p * (x - y), {x - y: Gt(x, y)}) == -1

    @pytest.mark.parametrize("facts", [{}, {x - y: Ge(x, y)}])
    def test_an_open_sign_is_not_guessed(self, facts):
        with pytest.raises(DerivationError, match="does not follow"):
            sign_by_factors(p * (x - y), facts)

    def test_a_fact_about_something_else_is_refused(self):
        with pytest.raises(DerivationError, match="says nothing"):
            sign_by_factors(p * (x - y), {x - y: Gt(x, 2 * y)})

    def test_not_negative(self):
        assert not_negative(p * (x - y), {x - y: Ge(x, y)}) == Ge(p * (x - y), 0, evaluate=False)
        for facts in ({}, {x - y: Le(x, y)}):
            with refused:
                not_negative(p * (x - y), facts)

    def test_monotony_by_the_slope(self):
        whole, turn = Interval.open(0, oo), Interval.Ropen(0, sp.atan(1 / k))
        assert monotone_by_slope(1 / p, p, whole) == StrictlyDecreasing(1 / p, p, whole)
        assert monotone_by_slope(1 + q * sp.tan(x), x, turn) == StrictlyIncreasing(1 + q * sp.tan(x), x, turn)
        for function, variable, where in (
            (p + 1 / p, p, whole),
            (-1 / x, x, Interval(-1, 1)),  # a pole between
            (sp.tan(x), x, Interval(0, pi)),
            (sp.tan(x), x, Interval(0, pi / 2)),
            (sp.tan(2 * x), x, Interval(0, 1)),
        ):
            with refused:
                monotone_by_slope(function, variable, where)

    def test_values_are_ordered_as_the_function_goes(self):
        rising, falling = (kind(x**3, x, Interval(0, 9)) for kind in (StrictlyIncreasing, StrictlyDecreasing))
        assert values_ordered(rising, 1, 2) == Lt(1, 8, evaluate=False)
        assert values_ordered(falling, 1, 2) == Lt(8, 1, evaluate=False)
        assert values_ordered(rising, 0, p, [Lt(p, 9)]) == Lt(0, p**3, evaluate=False)
        for low, high, known in (
            (2, 1, ()),
            (-1, 2, ()),
            (1, 10, ()),
            (0, p, ()),
            (q, p, [Lt(p, 9)]),
            (p, p, [Lt(p, 9)]),
        ):
            with refused:
                values_ordered(rising, low, high, known)

    def test_positive_before_the_root(self):
        falling = StrictlyDecreasing(1 - x**2, x, Interval(0, 9))
        inside = [Ge(y, 0), Le(y, 9)]
        assert positive_before_root(falling, 1, y, inside) == sp.Equivalent(Gt(1 - y**2, 0), Lt(y, 1))
        for root, place in ((1, y), (-1, 0)):
            with pytest.raises(DerivationError, match="not shown to lie"):
                positive_before_root(falling, root, place)
        with pytest.raises(DerivationError, match="vanish"):
            positive_before_root(falling, 2, y, inside)
        with pytest.raises(DerivationError, match="decreasing"):
            positive_before_root(StrictlyIncreasing(x - 1, x, Interval(0, 9)), 1, y, inside)

    FALLING = StrictlyDecreasing(exp(-x), x, Interval(0, oo))
    BELOW, IMAGE = Lt(exp(-p), q, evaluate=False), _eq(exp(-k), q)

    def test_arguments_are_reversed(self):
        assert arguments_reversed(self.FALLING, self.BELOW, p, self.IMAGE, k) == Lt(k, p, evaluate=False)

    @pytest.mark.parametrize(
        "changed",
        [
            {"claim": StrictlyIncreasing(exp(-x), x, Interval(0, oo))},
            {"claim": StrictlyDecreasing(exp(-2 * x), x, Interval(0, oo))},
            {"claim": StrictlyDecreasing(exp(-x), x, Interval(1, oo))},
            {"below": Lt(exp(-k), q, evaluate=False)},
            {"image": _eq(exp(-k), p)},
        ],
        ids=["rising", "another function", "outside the interval", "about another place", "another value"],
    )
    def test_arguments_are_not_reversed_without_ground(self, changed):
        given = {"claim": self.FALLING, "below": self.BELOW, "image": self.IMAGE} | changed
        with refused:
            arguments_reversed(given["claim"], given["below"], p, given["image"], k)

    def test_a_place_may_be_shown_to_lie_inside(self):
        beyond = StrictlyDecreasing(exp(-x), x, Interval(1, oo))
        facts = [Le(1, p, evaluate=False), Le(1, k, evaluate=False)]
        assert arguments_reversed(beyond, self.BELOW, p, self.IMAGE, k, facts) == Lt(k, p, evaluate=False)
        for short in (facts[:1], [Le(1, p, evaluate=False), Ge(1, k, evaluate=False)]):
            with pytest.raises(DerivationError, match="not shown to lie"):
                arguments_reversed(beyond, self.BELOW, p, self.IMAGE, k, short)


class TestSlopeTrials:
    """A slope that is told with the wrong sign is refused where it can be tried."""

    FALSE: ClassVar = {
        "x^2 rises": (x**2, WHOLE, 1),
        "x^2 rises to its end": (x**2, Interval(-3, -1), 1),
        "p x falls": (p * x, WHOLE, -1),
        "-x^2 rises up to p": (-(x**2), Interval(0, p), 1),
        "sin(x) rises beyond pi/2": (sp.sin(x), Interval(0, 3), 1),
        "a fold too small for any grid": (
            (x - Rational(1, 3)) ** 3 - (x - Rational(1, 3)) / 10**20,
            Interval(0, 1),
            1,
        ),
        "e^x - x rises": (exp(x) - x, WHOLE, 1),
        "1 - e^-x falls": (1 - exp(-x), Interval(0, oo), -1),
        "nothing changes": (p - 1, Interval(0, 1), 1),
    }

    @pytest.mark.parametrize(("function", "interval", "sign"), FALSE.values(), ids=FALSE)
    def test_it_is_refused(self, function, interval, sign):
        with refused:
            monotone(function, x, interval, sign)

    def test_true_neighbours_are_not(self):
        """A slope that is 0 at a place, at an end, or infinite there, is no counterexample."""
        for function, interval in ((x**3, WHOLE), (x**2, Interval(0, p)), (sp.sqrt(x), Interval(0, oo))):
            assert monotone(function, x, interval, 1) == StrictlyIncreasing(function, x, interval)

    def test_a_part_of_the_interval(self):
        rises = StrictlyIncreasing(x**2, x, Interval.open(0, oo))
        assert restricted(rises, Interval.Lopen(0, p)) == StrictlyIncreasing(x**2, x, Interval.Lopen(0, p))
        for part in (Interval(0, 1), Interval.open(-1, 1), WHOLE):
            with refused:
                restricted(rises, part)
