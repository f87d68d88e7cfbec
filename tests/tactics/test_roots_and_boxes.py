"""Tactics on signs, roots and inverses: what they prove, and what they refuse."""

import pytest
import sympy as sp
from sympy import And, Eq, Ge, Gt, Interval, LambertW, Le, Limit, Lt, exp, oo

from galileo_sym.ledger import (
    Continuous,
    DerivationError,
    ExactlyOneRoot,
    StrictlyDecreasing,
    StrictlyIncreasing,
    UniqueMaximum,
)
from galileo_sym.tactics import (
    above_limit,
    bound_by_end,
    box_of,
    compare_on,
    inverse_between,
    least_value,
    limit_along,
    monotone_on_half_line,
    one_root,
    sides_of_root,
    sign_by_ladder,
    sign_on,
    trig_box,
    undo,
    unique_maximum,
    zeros_from_0_on,
)

x, q = sp.symbols("x q", real=True)
p, h = sp.symbols("p h", positive=True)
LEFT, RIGHT = Interval(-oo, -1), Interval(-1, oo)
PRODUCT = x * exp(x)
FALLING, RISING = StrictlyDecreasing(PRODUCT, x, LEFT), StrictlyIncreasing(PRODUCT, x, RIGHT)


def test_sign_of_a_rational_expression_on_a_box():
    assert sign_on((x + 1) * x, {x: Interval.open(-1, 0)}) == -1
    assert compare_on(x / (x - 1), sp.S.One, {x: Interval.open(1, oo)}) == Gt(x / (x - 1), 1, evaluate=False)


@pytest.mark.parametrize(
    ("expr", "box"),
    [
        (x, {x: Interval.open(-1, 1)}),
        (x**2 - 2, {x: Interval.open(0, oo)}),
        (x * q, {x: Interval.open(0, 1)}),
        (x, {x: Interval.open(-oo, oo)}),
    ],
)
def test_sign_that_changes_or_is_unknown_is_refused(expr, box):
    with pytest.raises(DerivationError):
        sign_on(expr, box)


def test_box_from_inequalities():
    assert box_of(And(Gt(x, -1), Lt(x, 0)), Gt(q, 2)) == {x: Interval.open(-1, 0), q: Interval.open(2, oo)}


def test_trigonometric_signs_hold_only_in_their_quadrant():
    inside = trig_box(sp.cos(2 * x), x, Interval.Ropen(0, sp.pi / 4))
    assert sign_on(sp.cos(2 * x), inside) == 1
    assert sign_on(sp.cos(2 * x), trig_box(sp.cos(2 * x), x, Interval.Lopen(sp.pi / 4, sp.pi / 2))) == -1
    assert trig_box(sp.cos(2 * x), x, Interval(0, sp.pi / 2)) == {}
    assert trig_box(sp.sin(x), x, Interval(0, 1)) == trig_box(sp.tan(x), x, Interval.Lopen(0, sp.pi / 2)) == {}


def test_sign_by_ladder_of_a_quotient():
    assert sign_by_ladder(-(exp(p) - 1 - p) / (exp(p) - 1) ** 2, p) == -1
    with pytest.raises(DerivationError):
        sign_by_ladder(p - 1, p)


def test_monotony_on_half_lines():
    assert monotone_on_half_line(PRODUCT, x, LEFT) == FALLING
    assert monotone_on_half_line(PRODUCT, x, RIGHT) == RISING
    with pytest.raises(DerivationError):
        monotone_on_half_line(PRODUCT, x, Interval(-2, oo))


def test_least_value_needs_a_fall_then_a_rise():
    assert least_value(FALLING, RISING) == Ge(PRODUCT, -exp(-1), evaluate=False)
    for pair in ((RISING, FALLING), (FALLING, StrictlyIncreasing(PRODUCT, x, Interval(0, oo)))):
        with pytest.raises(DerivationError):
            least_value(*pair)


def test_unique_maximum_needs_a_rise_then_a_fall():
    rising, falling = StrictlyIncreasing(-(x**2), x, Interval(-1, 0)), StrictlyDecreasing(-(x**2), x, Interval(0, 1))
    assert unique_maximum(rising, falling) == UniqueMaximum(-(x**2), x, Interval(-1, 1), 0)
    for pair in ((falling, rising), (rising, StrictlyDecreasing(-(x**4), x, Interval(0, 1)))):
        with pytest.raises(DerivationError):
            unique_maximum(*pair)


def test_bound_by_the_end_of_a_half_line():
    assert bound_by_end(FALLING, q, Lt(q, -1)) == Gt(q * exp(q), -exp(-1), evaluate=False)
    for inside in (Gt(q, -1), Lt(q, 0), Le(q, -1)):
        with pytest.raises(DerivationError):
            bound_by_end(FALLING, q, inside)


SQUARE = StrictlyIncreasing(x**2, x, Interval(0, 3))


def test_one_root_between_the_end_values():
    assert one_root(SQUARE, sp.Integer(4)) == ExactlyOneRoot(x**2 - 4, x, Interval(0, 3))
    assert one_root(SQUARE, sp.S.Zero) == ExactlyOneRoot(x**2, x, Interval(0, 3))
    assert one_root(SQUARE, p, assuming=(Lt(p, 9),)) == ExactlyOneRoot(x**2 - p, x, Interval(0, 3))


@pytest.mark.parametrize(
    ("claim", "level", "ends", "assuming"),
    [
        (SQUARE, sp.Integer(10), (None, None), ()),
        (SQUARE, sp.Integer(-1), (None, None), ()),
        (SQUARE, p, (None, None), ()),
        (StrictlyIncreasing(x**2, x, Interval.open(0, 3)), sp.Integer(9), (None, None), ()),
        (SQUARE, sp.Integer(10), (None, Eq(sp.Function("f")(3), 11)), ()),
        (SQUARE, p, (None, None), (Gt(p, 9),)),
    ],
)
def test_root_outside_the_end_values_is_refused(claim, level, ends, assuming):
    with pytest.raises(DerivationError):
        one_root(claim, level, ends=ends, assuming=assuming)


def test_function_that_falls_lies_above_its_limit():
    limit = Eq(Limit(-x, x, 0, "-"), 0, evaluate=False)
    slope = Eq(sp.Derivative(-x, x), q)
    assert above_limit(Lt(q, 0), limit, slope=slope) == Gt(-x, 0, evaluate=False)
    for falls in (Gt(q, 0), Lt(q, 1), Lt(p, 0, evaluate=False)):
        with pytest.raises(DerivationError):
            above_limit(falls, limit, slope=slope)


def test_sides_of_a_root():
    factor, root = StrictlyIncreasing(x - q, x, Interval.open(0, 1)), ExactlyOneRoot(x - q, x, Interval.open(0, 1))
    slope, box = Eq(sp.Derivative(-((x - q) ** 2) * p, x), -2 * p * (x - q)), {p: Interval.open(0, 1)}
    whole = Continuous(slope.lhs.expr, x, Interval(0, 1))
    left, right = sides_of_root(slope, whole, q, root, factor, box)
    assert (type(left), type(right)) == (StrictlyIncreasing, StrictlyDecreasing)
    for other in (ExactlyOneRoot(x, x, Interval.open(0, 1)), ExactlyOneRoot(x - q, x, Interval.open(0, 2)), factor):
        with pytest.raises(DerivationError):
            sides_of_root(slope, whole, q, other, factor, box)
    for wrong in (Eq(slope.lhs, -2 * x * (x - q)), Eq(slope.lhs, x), Eq(sp.Derivative(q**2 * p, q), slope.rhs)):
        with pytest.raises(DerivationError):
            sides_of_root(wrong, whole, q, root, factor, box)
    for gap in (whole.func(*whole.args[:2], Interval(0, 2)), whole.func(x, *whole.args[1:]), sp.Not(whole)):
        with pytest.raises(DerivationError):
            sides_of_root(slope, gap, q, root, factor, box)


ROUND_TRIP = Eq(LambertW(q) * exp(LambertW(q)), q)


def test_inverse_undoes_where_it_takes_its_values():
    same = undo(RISING, ROUND_TRIP, Ge(LambertW(q), -1), x)
    assert set(same.args) == {Eq(LambertW(PRODUCT), x, evaluate=False), Ge(x, -1)}
    for claim, round_trip in ((FALLING, ROUND_TRIP), (RISING, Eq(LambertW(q) * exp(2 * LambertW(q)), q))):
        with pytest.raises(DerivationError):
            undo(claim, round_trip, Ge(LambertW(q), -1), x)


def test_inverse_between_needs_both_bounds():
    inverse, values = LambertW(q), Ge(LambertW(q), -1, evaluate=False)
    bounds = And(Gt(q, -exp(-1)), Lt(q, 0))
    expected = And(Gt(inverse, -1, evaluate=False), Lt(inverse, 0, evaluate=False))
    assert inverse_between(RISING, ROUND_TRIP, values, q, sp.S.Zero, bounds) == expected
    for claim, round_trip, told, high in (
        (RISING, ROUND_TRIP, values, sp.S.One),
        (FALLING, ROUND_TRIP, values, sp.S.Zero),
        (RISING, Eq(2 * LambertW(q) * exp(LambertW(q)), q), values, sp.S.Zero),
        (RISING, ROUND_TRIP, Ge(LambertW(q), -2, evaluate=False), sp.S.Zero),
    ):
        with pytest.raises(DerivationError):
            inverse_between(claim, round_trip, told, q, high, bounds)


def test_limit_along_a_path_needs_the_right_side():
    known = Eq(Limit(sp.sign(x), x, 0, "-"), -1, evaluate=False)
    assert limit_along(known, h, -h, 0) == -1
    for path in (h, 1 - h):
        with pytest.raises(DerivationError):
            limit_along(known, h, path, 0)


def test_every_zero_from_0_on():
    """A zero that a solver may overlook is either found or asked for."""
    h, c = sp.Symbol("h", real=True), sp.Symbol("c", real=True)
    assert zeros_from_0_on((h - 1) * (sp.exp(h) - 1), h) == {0, 1}
    assert zeros_from_0_on((h + 2) * sp.exp(h) * (2 * h - 3) ** 2 / (h + 5), h) == {sp.Rational(3, 2)}
    for hidden in (sp.exp(h) - 3 * h, sp.sin(h), h**2 - 2, h - c, (h - 1) * (sp.exp(h) - 1 - 2 * h)):
        with pytest.raises(DerivationError):
            zeros_from_0_on(hidden, h)
