"""A theorem about unknown functions, applied to given ones."""

from __future__ import annotations

import sympy as sp
from sympy.core.relational import Relational

from galileo_sym.ledger import tactic


@tactic
def said_of(statement, functions: dict, symbols: dict):
    """A statement about unknown functions, said of given ones.

    Parameters
    ----------
    functions : dict
        {f(x): expression in x}, one for each unknown function.
    symbols : dict
        Put in afterwards, such as {x_0: -1}.
    """
    bodies = {applied.func: sp.Lambda(applied.args, body) for applied, body in functions.items()}
    return _put(_put(statement, bodies), symbols)


def _put(expr, table):
    """The expression with functions (by Lambda) or symbols put in; relations stay as they are, unevaluated."""
    if expr in table:
        return table[expr]
    if not expr.args or isinstance(expr, sp.Lambda):
        return expr
    args = [_put(arg, table) for arg in expr.args]
    if expr.func in table:
        return table[expr.func](*args)
    return expr.func(*args, evaluate=False) if isinstance(expr, Relational) else expr.func(*args)
