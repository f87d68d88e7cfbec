"""From one side of an extremum to the other, and what is said of every value in an interval."""

import pytest
import sympy as sp
from sympy import And, Eq, Equivalent, Ge, Gt, Interval, Le, Limit, Ne, Subs, Sum, exp, oo

from galileo_sym.ledger import DerivationError, ForAll, PowerSeries
from galileo_sym.ledger.local import HoldsBeside, MonotoneBeside
from galileo_sym.ledger.numeric import holds
from galileo_sym.tactics import everywhere, nonzero_along, reflected_beside, value_near

x, x_0, w = sp.symbols("x x_0 w", real=True)
h, c = sp.symbols("h c", positive=True)
n = sp.Symbol("n", integer=True, nonnegative=True)
a, f, g, y, F = (sp.Function(name, real=True) for name in ("a", "f", "g", "y", "F"))
BOTH, RIGHT = Interval(x_0 - h, x_0 + h), Interval(x_0, x_0 + h)
SERIES = ForAll(Eq(f(x), Sum(a(n) * (x - x_0) ** n, (n, 0, oo))), x, BOTH)
POLE = ForAll(Eq(f(x), Sum(a(n) * (x - x_0) ** (n - 1), (n, 0, oo))), x, BOTH)
UNDONE = ForAll(Eq(g(f(x)), x), x, RIGHT)
AFTER, BEFORE = MonotoneBeside(f(x), x, x_0, 1, c), MonotoneBeside(f(x), x, x_0, -1, -c)


def test_f_takes_its_values_again():
    beside, tends = reflected_beside(AFTER, BEFORE, SERIES, UNDONE)
    z = g(f(x))
    assert beside == HoldsBeside(And(Ge(z, x_0), Le(z, x_0 + h), Eq(f(z), f(x))), x, x_0, -1)
    assert tends == Eq(Limit(z, x, x_0, "-"), x_0, evaluate=False)


@pytest.mark.parametrize(
    "facts",
    [
        (AFTER, MonotoneBeside(f(x), x, x_0, -1, c), SERIES, UNDONE),  # x^3 does not come back
        (BEFORE, AFTER, SERIES, UNDONE),
        (AFTER, AFTER, SERIES, UNDONE),
        (AFTER, MonotoneBeside(f(x), x, x_0 + 1, -1, -c), SERIES, UNDONE),
        (AFTER, BEFORE, POLE, UNDONE),
        (AFTER, BEFORE, SERIES.args[0], UNDONE),  # for a single x
        (AFTER, BEFORE, SERIES, UNDONE.args[0]),
        (AFTER, BEFORE, SERIES, ForAll(Eq(g(f(x)), 2 * x), x, RIGHT)),
        (AFTER, BEFORE, SERIES, ForAll(Eq(f(g(x)), x), x, RIGHT)),
        (AFTER, BEFORE, SERIES, ForAll(Eq(g(f(x)), x), x, Interval(x_0 - h, x_0))),
        (AFTER, BEFORE, SERIES, ForAll(Eq(g(f(x)), x), x, Interval(x_0, x_0 + 2 * h))),  # beyond the series
    ],
)
def test_not_without_each_fact(facts):
    with pytest.raises(DerivationError):
        reflected_beside(*facts)


def test_not_zero_along_what_tends_to_the_place():
    tail = Sum(a(n) * (x - x_0) ** (n - 2), (n, 2, oo))
    near = value_near(Eq(F(x), tail), Eq(Subs(F(x), x, x_0), a(2)), Ne(a(2), 0))
    tends, at_end = Eq(Limit(y(x), x, x_0, "-"), x_0, evaluate=False), Eq(y(x_0), x_0)
    assert nonzero_along(near, tends, at_end) == HoldsBeside(Ne(F(y(x)), 0), x, x_0, -1)
    for other, end in (
        (Eq(Limit(y(x), x, x_0, "-"), x_0 + 1, evaluate=False), at_end),
        (Eq(Limit(y(x), x, x_0, "+"), x_0, evaluate=False), at_end),
        (tends, Eq(y(x_0), x_0 + 1)),
        (tends, Eq(g(x_0), x_0)),
    ):
        with pytest.raises(DerivationError):
            nonzero_along(near, other, end)


@pytest.mark.parametrize(
    ("statement", "side", "truth"),
    [
        (Ge(x**2 * (1 + 10**6 * x), 0), -1, True),
        (Ge(x, 0), -1, False),
        (Ge(x, 0), 1, True),
        (Gt(x, 0), 1, False),  # the place belongs to it
        (Eq(x**2, x), 1, False),
    ],
)
def test_what_holds_beside_a_place_is_tried(statement, side, truth):
    assert holds(HoldsBeside(statement, x, 0, side), {}) is truth


def test_a_series_said_of_every_value():
    series = PowerSeries(exp(w), w, 0, 1 / sp.factorial(n), n)
    told = everywhere(series, x, Interval(-1, 1))
    assert told == ForAll(Eq(exp(x), Sum(x**n / sp.factorial(n), (n, 0, oo)), evaluate=False), x, Interval(-1, 1))
    assert holds(told, {})


def test_an_equivalence_said_where_its_condition_holds():
    undone = Equivalent(Eq(g(f(w)), w), Ge(w, -1))
    half = Interval(-1, 0)
    assert everywhere(undone, w, half) == ForAll(Eq(g(f(w)), w), w, half)
    for claim, interval in (
        (undone, Interval(-2, 0)),
        (Equivalent(Eq(g(f(w)), w), Ge(x, -1)), half),
        (Eq(g(f(w)), w), half),
        (Ge(w, -1), half),
    ):
        with pytest.raises(DerivationError):
            everywhere(claim, w, interval)
