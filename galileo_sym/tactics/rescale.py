"""Change of variables in a law of motion: other units of length and time, or time run backwards."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic


@tactic
def rescale(equation: sp.Eq, old, new, *, length=sp.S.One, time=sp.S.One) -> sp.Eq:
    """Put s(t) = length * S(z), t = time * z into an equation of motion, or into an initial value.

    By the chain rule a derivative of order n is multiplied by length/time^n.

    Parameters
    ----------
    equation : Eq
        In s(t) and its derivatives, or in their values at t = 0.
    old, new : applied functions
        s(t) and S(z).
    length, time : expressions
        The units, free of t and z; time = -1 runs the motion backwards.

    Returns
    -------
    Eq
        In S(z) and z.

    Raises
    ------
    DerivationError
        A derivative or integral of something else occurs, or a unit depends on the time, or may be 0.
    """
    t, z = old.args[0], new.args[0]
    if sp.sympify(length).has(t, z) or sp.sympify(time).has(t, z):
        raise DerivationError(f"the units {length} and {time} depend on the time")
    if not (sp.sympify(length).is_nonzero and sp.sympify(time).is_nonzero):
        raise DerivationError(f"one of the units {length} and {time} may be 0")

    def put(expr):
        if isinstance(expr, sp.Derivative) and expr.expr == old:
            order = sum(count for _, count in expr.variable_count)
            return length / time**order * new.diff(z, order)
        if isinstance(expr, sp.Subs) and isinstance(expr.expr, sp.Derivative) and expr.variables == (t,):
            return put(expr.expr).subs(z, expr.point[0] / time)
        if isinstance(expr, sp.Derivative | sp.Subs | sp.Integral):
            raise DerivationError(f"{expr} is not a derivative of {old}")
        if isinstance(expr, type(old)) and expr.func == old.func:
            return length * new.func(expr.args[0].subs(t, time * z) / time)
        if expr == t:
            return time * z
        return expr.func(*map(put, expr.args)) if expr.args else expr

    return sp.Eq(put(equation.lhs), put(equation.rhs), evaluate=False)
