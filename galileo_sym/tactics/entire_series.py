"""Power series that converge everywhere: of a polynomial times an exponential, scaled, and divided by a power."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, PowerSeries, step, tactic
from galileo_sym.ledger.equivalence import is_zero


@tactic
def entire_series(expr, variable, place, n) -> PowerSeries:
    """The power series about a place of p(x) e^(c x + d), p a polynomial: its sum is the function for every real x.

    Leibniz's rule gives the derivative of order n, and induction proves it. In Lagrange's remainder this derivative is
    bounded by a polynomial in n times |c|^n, over n!: it vanishes as n grows, whatever x is.

    Parameters
    ----------
    expr : expression
    variable : Symbol
    place : expression
    n : Symbol
        Integer and not negative: the order of a term.

    Raises
    ------
    DerivationError
        The expression is not of that form, or the induction fails.
    """
    power = [e for e in expr.atoms(sp.exp) if e.has(variable)]
    rest = sp.cancel(expr / power[0]) if len(power) == 1 else expr
    exponent = power[0].args[0] if power else variable**2
    if not (rest.is_polynomial(variable) and exponent.is_polynomial(variable) and sp.degree(exponent, variable) == 1):
        raise DerivationError(f"{expr} is not a polynomial in {variable} times one exponential")
    slope = sp.diff(exponent, variable)
    leibniz = sum(
        sp.ff(n, i) / sp.factorial(i) * slope ** (n - i) * sp.diff(rest, variable, i)
        for i in range(sp.degree(rest, variable) + 1)
    )
    derivative = sp.factor(sp.expand_func(leibniz)) * power[0]
    after = step("the next derivative", sp.Eq(sp.Derivative(derivative, variable), derivative.subs(n, n + 1)))
    if is_zero(derivative.subs(n, 0) - expr) is None or is_zero(after.lhs.doit() - after.rhs) is None:
        raise DerivationError(f"{derivative} is not the derivative of order {n} of {expr}")
    coefficient = derivative.subs(variable, place) / sp.factorial(n)
    ratio = sp.combsimp(coefficient.subs(n, n + 1) / coefficient)
    step("the ratio of coefficients goes to 0", sp.Eq(sp.Limit(ratio, n, sp.oo), sp.limit(ratio, n, sp.oo)))
    if sp.limit(ratio, n, sp.oo) != 0:
        raise DerivationError(f"the series with coefficients {coefficient} need not converge everywhere")
    return PowerSeries(expr, variable, place, coefficient, n)


@tactic
def affine_series(series: PowerSeries, factor, constant) -> PowerSeries:
    """The series of factor f + constant, both free of the variable and of the order."""
    f, x, place, coefficient, n = series.args
    if sp.sympify(factor).has(x, n) or sp.sympify(constant).has(x, n):
        raise DerivationError(f"{factor} or {constant} changes with {x} or {n}")
    first = constant * sp.KroneckerDelta(n, 0)
    return PowerSeries(sp.powsimp(sp.expand(factor * f)) + constant, x, place, factor * coefficient + first, n)


@tactic
def divide_series(series: PowerSeries, power: int) -> PowerSeries:
    """The series of f/(x - place)^power, where the terms below that order vanish.

    Raises
    ------
    DerivationError
        A term below is not 0: the quotient has a pole.
    """
    f, x, place, coefficient, n = series.args
    for order in range(power):
        if is_zero(coefficient.subs(n, order)) is None:
            raise DerivationError(f"the term of order {order} of {f} is not 0: no division by ({x} - {place})^{power}")
    return PowerSeries(f / (x - place) ** power, x, place, coefficient.subs(n, n + power), n)


def with_tail(series: PowerSeries, terms: int, at):
    """The sum of a series at a place, its first terms written out."""
    _, _, place, coefficient, n = series.args
    first = sum(coefficient.subs(n, i) * (at - place) ** i for i in range(terms))
    return first + sp.Sum(coefficient * (at - place) ** n, (n, terms, sp.oo))


def times_sum(expr, factor):
    """Multiply a sum of terms, infinite ones included, term by term."""
    return sp.Add(*(_times(term, factor) for term in sp.Add.make_args(expr)))


def _times(term, factor):
    series = next((e for e in sp.Mul.make_args(term) if isinstance(e, sp.Sum)), None)
    if series is None:
        return term * factor
    return sp.Sum(sp.powsimp(series.args[0] * factor * term / series), *series.args[1:])


def renumber(expr, by: int):
    """Count the terms of infinite series from `by` less."""

    def shifted(series):
        term, (n, first, last) = series.args
        return sp.Sum(term.subs(n, n + by), (n, first - by, last))

    return expr.replace(lambda e: isinstance(e, sp.Sum), shifted)
