"""Limits of exponential quotients: against series known otherwise, and what is no such quotient is left alone."""

import pytest
import sympy as sp
from mpmath import mp
from sympy import exp, oo

from galileo_sym.tactics import elementary_limit
from galileo_sym.tactics.exponential_quotients import quotient_limit

s = sp.Symbol("s", positive=True)
x = sp.Symbol("x", real=True)
k, g = sp.symbols("k g", positive=True)

KNOWN = {
    "phi1": ((1 - exp(-x)) / x, 0, 1),
    "phi2 with units": (g * (k * x - 1 + exp(-k * x)) / (k**2 * x**2), 0, g / 2),
    "third order": ((sp.sinh(s) - s).rewrite(exp) / s**3, 0, sp.Rational(1, 6)),
    "higher above": ((exp(x) - 1) ** 2 / x, 0, 0),
    "at another place": ((exp(x) - sp.E) / (x - 1), 1, sp.E),
    "a fraction of fractions": (x / (x / (1 - exp(-x)) - 1), 0, 2),
}


@pytest.mark.parametrize("name", KNOWN)
def test_known_limits(name):
    expr, place, value = KNOWN[name]
    (variable,) = expr.free_symbols - {g, k}
    assert sp.simplify(quotient_limit(expr, variable, place) - value) == 0
    with mp.workdps(60):
        near = expr.subs({g: 3, k: 7, variable: place + sp.Rational(1, 10**25)}).evalf(60)
        assert abs(near - sp.sympify(value).subs({g: 3, k: 7})) < sp.Float("1e-20")


@pytest.mark.parametrize(
    ("expr", "place"),
    [
        (1 / x, 0),  # infinite
        (sp.sqrt(1 - exp(-s)) / s, 0),
        ((1 - exp(-(x**2))) / x**2, 0),
        (sp.sin(x) / x, 0),
        ((exp(-x) + 1) / x, oo),
        ((exp(k * x) - exp(g * x)) / x, 0),  # k - g may be 0
        (abs(x) / x, 0),
    ],
)
def test_what_is_no_such_quotient_is_left_to_others(expr, place):
    (variable,) = expr.free_symbols - {g, k}
    assert quotient_limit(expr, variable, place) is None


def test_a_quotient_of_units_is_taken_by_the_tactic():
    assert elementary_limit((exp(s) - 1 - s) / (s - 1 + exp(-s)), s, 0) == 1
