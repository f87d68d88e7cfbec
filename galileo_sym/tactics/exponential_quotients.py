"""Limits of quotients of sums of x^m e^(c x), by the first terms of their power series."""

from __future__ import annotations

import sympy as sp

MOST = 40  # terms of a series; a quotient that needs more is left to others


def quotient_limit(expr, variable, point):
    """The limit of an exponential quotient at a finite point, the same from both sides.

    Returns
    -------
    expression or None
        None if the expression is no quotient of sums of c*x^m*exp(d*x), if the limit is infinite, or if a coefficient
        cannot be told from 0.
    """
    if not sp.sympify(point).is_finite:
        return None
    near = sp.Dummy("near", real=True)
    moved = sp.powsimp(sp.expand_power_exp(expr.subs(variable, point + near)))
    leads = [_leading(side, near) for side in sp.fraction(sp.together(sp.powdenest(moved)))]
    if None in leads:
        return None
    (order, above), (power, below) = leads
    if order < power:
        return None
    return sp.S.Zero if order > power else sp.simplify(above / below)


def _leading(expr, x):
    """The order and the coefficient of the first term of a power series; None where they are not certain."""
    terms = [_term(e, x) for e in sp.Add.make_args(sp.expand(sp.powsimp(sp.expand(expr))))]
    if None in terms:
        return None
    for order in range(MOST):
        pieces = (c * d ** (order - m) / sp.factorial(order - m) for c, m, d in terms if m <= order)
        coefficient = sp.expand(sum(pieces, sp.S.Zero))
        if coefficient.is_zero is False:
            return order, coefficient
        if coefficient != 0:
            return None
    return None


def _term(expr, x):
    """(c, m, d) of c*x^m*exp(d*x)."""
    constant, rest = expr.as_independent(x, as_Add=False)
    power, rate = sp.S.Zero, sp.S.Zero
    for factor in sp.Mul.make_args(rest):
        if isinstance(factor, sp.exp):
            slope = sp.diff(factor.args[0], x)
            left = sp.expand(factor.args[0] - slope * x)
            if slope.has(x) or left.has(x):
                return None
            rate, constant = rate + slope, constant * sp.exp(left)
        elif factor != 1:
            base, exponent = factor.as_base_exp()
            if base != x or not (exponent.is_Integer and exponent.is_nonnegative):
                return None
            power += exponent
    return constant, int(power), rate
