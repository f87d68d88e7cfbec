"""Elementary limits, factors taken out, inverses undone: each only where its conditions are met."""

import pytest
import sympy as sp
from sympy import And, Eq, Ge, Gt, Interval, LambertW, Limit, Lt, Rational, exp, oo, sqrt

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.primitives import descent_factor, phi2
from galileo_sym.tactics import (
    above_end,
    elementary_limit,
    first_order,
    implicit_derivative,
    introduce,
    inverse_between,
    least_value,
    limit_along,
    limit_by_parameter,
    undo,
)

x, y, z = sp.symbols("x y z", real=True)
p, q, k, g = sp.symbols("p q k g", positive=True)
t = sp.Symbol("t", nonnegative=True)
f = sp.Function("f")
refused = pytest.raises(DerivationError)


def _eq(left, right):
    return Eq(left, right, evaluate=False)


FOLDED = {
    "no y in the equation": (x**2 - 1, (Gt(f(x), 0),)),
    "nothing is known of y": (f(x) * exp(f(x)) - x, ()),
    "y may be where T turns": (f(x) * exp(f(x)) - x, (Gt(f(x), -2),)),
    "on the circle, at its ends": (f(x) ** 2 + x**2 - 1, (Gt(f(x), -1), Lt(f(x), 1))),
    "W >= -1 is not enough": (f(x) * exp(f(x)) - x, (Ge(f(x), -1),)),
    "a corner": (sp.Abs(f(x) - 3) + f(x) - x, (Gt(f(x), 0),)),
    "no value between 1 and -1": (f(x) ** 3 - x, (Gt(f(x), 1), Lt(f(x), -1))),
}


class TestLimits:
    def test_elementary(self):
        assert elementary_limit((exp(z) - 1 - z) / z**2, z, 0) == Rational(1, 2)

    @pytest.mark.parametrize("w", [LambertW(z), LambertW(z, -1), 1 + LambertW(-exp(-1 - z))])
    def test_a_limit_through_w_is_refused(self, w):
        with pytest.raises(DerivationError, match="LambertW"):
            elementary_limit(w / z, z, 0)

    def test_along_a_path(self):
        path = sqrt(2 * (p - 1 + exp(-p)))
        assert limit_by_parameter(p / path, x, 0, "+", p, path, 0) == 1

    @pytest.mark.parametrize(("path", "direction"), [(1 + p, "+"), (p, "-"), (-p, "+"), (p**0, "+")])
    def test_a_path_that_goes_elsewhere_is_refused(self, path, direction):
        known = _eq(Limit(f(x), x, 0, direction), sp.S.One)
        with refused:
            limit_along(known, p, path, 0)

    def test_a_known_limit_along_a_path(self):
        assert limit_along(_eq(Limit(f(x), x, -1, "-"), q), p, -1 - p, 0) == q


class TestFactors:
    DESCENT = 1 / k + k * p / g + LambertW(-exp(-1 - k**2 * p / g)) / k
    FACTOR = descent_factor(k * sqrt(2 * p / g))

    def test_w_is_taken_out(self):
        form = introduce(self.DESCENT, self.FACTOR)
        assert form.equals(sqrt(2 * p / g) * self.FACTOR)
        assert not form.has(LambertW)

    @pytest.mark.parametrize("factor", [descent_factor(k * sqrt(p / g)), descent_factor(2 * k * sqrt(2 * p / g))])
    def test_a_factor_at_another_argument_is_refused(self, factor):
        with refused:
            introduce(self.DESCENT, factor)

    def test_another_branch_is_refused(self):
        other = self.DESCENT.xreplace({w: LambertW(w.args[0], -1) for w in self.DESCENT.atoms(LambertW)})
        with refused:
            introduce(other, self.FACTOR)

    def test_an_exponential_is_taken_out(self):
        fallen = t / k - (1 - exp(-k * t)) / k**2
        assert introduce(fallen, phi2(-k * t), closed=exp).equals(t**2 * phi2(-k * t))
        for factor in (phi2(k * t), phi2(-2 * k * t)):
            with refused:
                introduce(fallen, factor, closed=exp)

    def test_first_order(self):
        slope = Rational(1, 6)
        assert first_order(p * descent_factor(q * k), k, {descent_factor: slope}) == (p, p * q / 6)
        value, wrong = first_order(p * descent_factor(q * k), k, {descent_factor: slope / 2})
        assert (value, wrong) == (p, p * q / 12)

    @pytest.mark.parametrize("argument", [q * k**2, 1 + k, exp(k)])
    def test_first_order_needs_an_argument_proportional_to_the_force(self, argument):
        with pytest.raises(DerivationError, match="not a multiple"):
            first_order(descent_factor(argument), k, {descent_factor: Rational(1, 6)})


class TestInverses:
    RISING = StrictlyIncreasing(x * exp(x), x, Interval(-1, oo))
    ROUND = _eq(LambertW(y) * exp(LambertW(y)), y)

    def test_w_undoes_f_where_it_takes_its_values(self):
        found = undo(self.RISING, self.ROUND, Ge(LambertW(y), -1, evaluate=False), z)
        assert found == sp.Equivalent(_eq(LambertW(z * exp(z)), z), Ge(z, -1, evaluate=False))

    def test_w_undoes_nothing_beyond(self):
        for claim, trip in (
            (StrictlyIncreasing(x * exp(x), x, Interval(0, oo)), self.ROUND),
            (self.RISING, _eq(2 * LambertW(y) * exp(LambertW(y)), y)),
        ):
            with refused:
                undo(claim, trip, Ge(LambertW(y), -1, evaluate=False), z)

    def test_bounds_of_the_inverse(self):
        bounds = And(Gt(q, x * exp(x), evaluate=False).subs(x, -1), Lt(q, 0, evaluate=False), evaluate=False)
        sides = And(Gt(y, -exp(-1), evaluate=False), Lt(y, 0, evaluate=False), evaluate=False)
        values = Ge(LambertW(y), -1, evaluate=False)
        assert inverse_between(self.RISING, self.ROUND, values, y, 0, sides).args
        with refused:
            inverse_between(self.RISING, self.ROUND, values, y, 0, bounds)

    def test_the_derivative_of_w(self):
        w = f(x)
        found = implicit_derivative(_eq(w * exp(w), x), w, x, Gt(w, -1))
        assert found.rhs.equals(exp(-w) / (1 + w))

    @pytest.mark.parametrize(("excess", "facts"), FOLDED.values(), ids=FOLDED)
    def test_a_function_that_may_have_no_derivative_is_refused(self, excess, facts):
        with refused:
            implicit_derivative(_eq(excess, sp.S.Zero), f(x), x, *facts)

    def test_a_root_between_two_numbers(self):
        """The upper half of the circle, near its top."""
        upper = Gt(f(x), 0), Lt(f(x), 2)
        assert implicit_derivative(_eq(f(x) ** 2 + x**2, sp.S.One), f(x), x, *upper).rhs == -x / f(x)

    def test_the_least_value_is_taken_at_its_image_only(self):
        values = Ge(LambertW(y), -1, evaluate=False)
        assert above_end(self.ROUND, values, Gt(y, -exp(-1))) == Gt(LambertW(y), -1, evaluate=False)
        for inside in (Ge(y, -exp(-1), evaluate=False), Gt(y, -1), Gt(z, -exp(-1)), Lt(y, -exp(-1))):
            with refused:
                above_end(self.ROUND, values, inside)
        with refused:
            above_end(self.ROUND, sp.Le(LambertW(y), -1, evaluate=False), Gt(y, -exp(-1)))

    def test_least_value(self):
        falls, rises = StrictlyDecreasing(x**2, x, Interval(-oo, 0)), StrictlyIncreasing(x**2, x, Interval(0, oo))
        assert least_value(falls, rises) == Ge(x**2, 0, evaluate=False)
        gap = StrictlyIncreasing(x**2, x, Interval(1, oo))
        other = StrictlyIncreasing(x**4, x, Interval(0, oo))
        for pair in ((falls, gap), (falls, other), (rises, falls), (falls, falls)):
            with refused:
                least_value(*pair)
