"""False statements that a jump, a pole, or an end of an interval makes false: refused; true neighbours are not."""

import pytest
import sympy as sp
from sympy import Eq, Gt, Integer, Interval, Limit, Piecewise, Rational, atan, exp, oo, sign, sqrt, tan

from galileo_sym.ledger import (
    Continuous,
    DerivationError,
    ExactlyOneRoot,
    PowerSeries,
    StrictlyDecreasing,
    StrictlyIncreasing,
)
from galileo_sym.tactics import (
    affine_series,
    continuous_on,
    elementary_limit,
    extremum_between,
    filled_in,
    ladder,
    limit_inside,
    limit_of_parts,
    monotone,
    monotone_on_half_line,
    one_root,
    positive_before_root,
    rescale,
    slope_at_gap,
    taylor,
    trig_box,
    values_ordered,
)

x, y, q, z = sp.symbols("x y q z", real=True)
p = sp.Symbol("p", positive=True)
s, S = sp.Function("s"), sp.Function("S")
n = sp.Symbol("n", integer=True, nonnegative=True)
DOWN, UP, WHOLE = Interval(-oo, 0), Interval(0, oo), Interval(-1, 1)
BROKEN = Piecewise((x - 1, x < 0), (x + 1, True))


def _limit(expr, place, value, side="+"):
    return Eq(Limit(expr, x, place, side), value, evaluate=False)


FALSE = {
    "an arctangent that jumps is positive": lambda: ladder(atan(1 / (1 - x)), x),
    "a branch that drops is positive": lambda: ladder(Piecewise((x + 1, x < 1), (x - 50, True)), x),
    "-1/x rises through its pole": lambda: monotone(-1 / x, x, WHOLE, 1),
    "the tangent rises through its pole": lambda: monotone(tan(x), x, Interval(0, 3), 1),
    "the tangent rises on a half-line": lambda: monotone(tan(x / 9), x, UP, 1),
    "a broken line rises": lambda: monotone(-BROKEN, x, WHOLE, -1),
    "a constant falls": lambda: monotone(Integer(3), x, WHOLE, 0),
    "a saw tooth rises": lambda: monotone_on_half_line(x - 5 * sp.floor(x), x, UP),
    "2 < 1": lambda: values_ordered(StrictlyIncreasing(x, x, Interval(0, 5)), 2, 1),
    "9 < 1, outside": lambda: values_ordered(StrictlyIncreasing(x**2, x, UP), -3, 1),
    "positive before a root outside": lambda: positive_before_root(StrictlyDecreasing(1 - x**2, x, UP), -1, x),
    "a root in a gap": lambda: one_root(StrictlyIncreasing(BROKEN, x, WHOLE), Integer(0)),
    "a root at an open end": lambda: one_root(StrictlyIncreasing(x, x, Interval.open(0, 1)), Rational(1, 2)),
    "a root of x = x + 1": lambda: one_root(StrictlyIncreasing(x, x, Interval(-oo, oo)), x + 1),
    "an extremum of x": lambda: extremum_between(Continuous(x, x, DOWN), StrictlyIncreasing(x, x, UP)),
    "continuous and infinite": lambda: continuous_on(sp.zoo * x, x, WHOLE),
    "continuous with a wrong value inside": lambda: filled_in(
        Continuous(x, x, Interval.open(0, oo)), {Integer(0): Integer(0), Integer(5): Integer(7)}, [_limit(x, 0, 0)]
    ),
    "continuous since it rises": lambda: filled_in(
        StrictlyIncreasing(x + sign(x - 1), x, Interval.open(0, oo)),
        {Integer(0): Integer(-1)},
        [_limit(x + sign(x - 1), 0, -1)],
    ),
    "the limit of a sign": lambda: limit_inside(StrictlyIncreasing(sign(q), q, WHOLE), sign(x), x, 0),
    "a limit from outside": lambda: limit_inside(Continuous(sqrt(q), q, UP), sqrt(-x), x, 0),
    "0 times oo": lambda: limit_of_parts(x * y, {x: Integer(0), y: oo}),
    "the slope of |x| at 0": lambda: slope_at_gap(
        Eq(sp.Derivative(sp.Abs(x), x), sign(x), evaluate=False),
        StrictlyIncreasing(sp.Abs(x), x, WHOLE),
        StrictlyIncreasing(sign(x), x, WHOLE),
        Integer(0),
    ),
    "the limit of an oscillation": lambda: elementary_limit(sp.sin(1 / x), x, 0),
    "a motion in units of no length": lambda: rescale(Eq(s(x), 5, evaluate=False), s(x), S(z), length=Integer(0)),
    "a Taylor polynomial of |x|": lambda: taylor(sp.Abs(x), x, 0, 3),
    "coefficients that change": lambda: affine_series(PowerSeries(exp(x), x, 0, 1 / sp.factorial(n), n), x, 0),
}  # fmt: skip


@pytest.mark.parametrize("prove", FALSE.values(), ids=FALSE)
def test_it_is_not_proved(prove):
    with pytest.raises(DerivationError):
        prove()


def test_no_sign_of_a_wave_that_goes_and_comes_back():
    """cos(8 x (1 - x)) is 1 at both ends of [0, 1], and negative between them."""
    wave = sp.cos(8 * x * (1 - x))
    assert wave.subs(x, Rational(1, 2)) < 0
    assert trig_box(wave, x, Interval(0, 1)) == {}
    assert trig_box(sp.cos(x), x, Interval(0, 1)) == {sp.cos(x): Interval.open(0, oo)}


def test_true_neighbours_are_proved():
    """The same moves where the conditions hold."""
    assert ladder(atan(x), x) == Gt(atan(x), 0, evaluate=False)
    assert monotone(-1 / x, x, Interval.Lopen(0, 1), 1) == StrictlyIncreasing(-1 / x, x, Interval.Lopen(0, 1))
    assert monotone(tan(x), x, Interval(0, 1), 1).args[0] == tan(x)
    assert limit_inside(Continuous(sqrt(q), q, UP), sqrt(x), x, 0).rhs == 0
    ends = _limit(-1 / x, 0, -oo), Eq(Limit(-1 / x, x, oo), 0, evaluate=False)
    rising = StrictlyIncreasing(-1 / x, x, Interval.open(0, oo))
    assert one_root(rising, Integer(-5), ends=ends) == ExactlyOneRoot(5 - 1 / x, x, Interval.open(0, oo))
