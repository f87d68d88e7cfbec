"""The letters of Theorem 1, where f, g, h, x and y are not those of projectiles, its hypotheses, and a family to try.

The family is f(x) = 2/3 + a_N X^N e^(b X) with X = x - x_0. There f(y) = f(x) with y > x_0 > x, N even, is solved by W:
y - x_0 = -X e^(b X/N - W(z)), z = -(b/N) X e^(b X/N); derivations know nothing of it.
"""

import sympy as sp
from sympy import Eq, Ge, Interval, Le, Ne, Sum, exp

from galileo_sym.ledger import ONE, REAL, ForAll, Notation
from galileo_sym.ledger.local import AllZero, LocalExtremum

notation = Notation("projectile")
symbol, function = notation.symbol, notation.function

x_0 = symbol("x_0", ONE, "place of the extremum")
x = symbol("x", ONE, "a place near x_0")
q = symbol("q", ONE, "a value of f")
h = symbol("h", ONE, "a small distance from x_0: f is its power series up to there", positive=True)
N = symbol("N", ONE, "least index above 0 of a coefficient that is not 0", integer=True, positive=True)
i = symbol("i", ONE, "index of the power series", integer=True, nonnegative=True)
lead = symbol("lead", ONE, "a_N in trials", real=True, nonzero=True)
away = symbol("away", ONE, "x - x_0 in trials")
b = symbol("b", ONE, "growth of F in trials")

f = function("f", ONE, "a function, real-analytic near x_0 and not constant")
a = function("a", ONE, "coefficients of its power series")
F = function("F", ONE, "(f(x) - a_0)/(x - x_0)^N")
g = function("g", ONE, "the inverse of f on [x_0, x_0 + h]; anything where f has no value there")
y = function("y", ONE, "g(f(x))")

X = x - x_0
SERIES = ForAll(Eq(f(x), Sum(a(i) * X**i, (i, 0, sp.oo)), evaluate=False), x, Interval(x_0 - h, x_0 + h))
GAP = AllZero(a(i), i, 1, N - 1)
LEADS = Ne(a(N), 0)
EXTREMUM = LocalExtremum(f(x), x, x_0)
INVERSE = ForAll(Eq(g(f(x)), x), x, Interval(x_0, x_0 + h))
REFLECTED = ForAll(Eq(y(x), g(f(x))), x, Interval(x_0 - h, x_0))

ANALYTIC = (SERIES, GAP, LEADS)
INVERTED = (INVERSE, REFLECTED)

# f takes its value at x again at y, to the right of x_0, where F is not 0
RETURNS = (Ge(y(x), x_0), Le(y(x), x_0 + h), Eq(f(y(x)), f(x)))
DIVISOR = Ne(F(y(x)), 0)

LEVEL, QUARTER = sp.Rational(2, 3), sp.Rational(1, 4)
_ROOT = ((q - LEVEL) / lead) ** (1 / N)
FAMILY = {
    x: x_0 + away,
    f(x): LEVEL + lead * X**N * exp(b * X),
    F(x): lead * exp(b * X),
    a(i): sp.Piecewise((LEVEL, Eq(i, 0)), (0, i < N), (lead * b ** (i - N) / sp.factorial(i - N), True)),
}
INVERSE_FAMILY = {
    **FAMILY,
    g(q): x_0 + _ROOT * exp(-sp.LambertW(b * _ROOT / N)),
    y(x): x_0 - X * exp(b * X / N - sp.LambertW(-b * X / N * exp(b * X / N))),
}
COEFFICIENTS = {x_0: REAL, lead: sp.FiniteSet(-2, sp.Rational(3, 5)), b: sp.FiniteSet(-1, 0, sp.Rational(1, 2))}
NEAR_IT = Interval.Lopen(0, QUARTER)
EVEN_ORDERS = {**COEFFICIENTS, N: sp.FiniteSet(2, 4, 6), h: NEAR_IT}
AROUND = {**COEFFICIENTS, N: sp.FiniteSet(1, 2, 3, 4), h: NEAR_IT, away: Interval(-h, h)}
LEFT_OF_IT = {**EVEN_ORDERS, away: Interval.Ropen(-h, 0)}
