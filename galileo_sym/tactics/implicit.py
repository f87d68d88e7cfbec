"""Derivatives of functions that are given by an equation."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic


@tactic
def implicit_derivative(equation: sp.Eq, unknown, variable) -> sp.Eq:
    """Differentiate an equation and solve for the derivative of the unknown function.

    Parameters
    ----------
    equation : Eq
        Between `variable` and `unknown`, such as Eq(y(u)*exp(y(u)), u*exp(u)).
    unknown : applied function, y(u)
    variable : Symbol, u

    Returns
    -------
    Eq
        Eq(Derivative(y(u), u), expression in u and y(u)).
    """
    slope = sp.Derivative(unknown, variable)
    name = sp.Dummy("slope")
    total = sp.diff(equation.lhs - equation.rhs, variable).doit().subs(slope, name)
    roots = sp.solve(total, name)
    if len(roots) != 1:
        raise DerivationError(f"the derivative of {unknown} is not determined by {equation}: {roots}")
    return sp.Eq(slope, roots[0], evaluate=False)
