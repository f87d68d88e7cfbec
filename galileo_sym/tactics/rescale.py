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
        The old function or time is left over, or a unit depends on the time.
    """
    t, z = old.args[0], new.args[0]
    if sp.sympify(length).has(t, z) or sp.sympify(time).has(t, z):
        raise DerivationError(f"the units {length} and {time} depend on the time")

    def put(expr):
        if isinstance(expr, sp.Derivative) and expr.expr == old:
            order = sum(count for _, count in expr.variable_count)
            return length / time**order * new.diff(z, order)
        if isinstance(expr, sp.Subs) and expr.expr.has(old.func):
            return put(expr.expr).subs(z, _at(expr, t) / time)
        if isinstance(expr, type(old)) and expr.func == old.func:
            return length * new.func(expr.args[0].subs(t, time * z) / time)
        if expr == t:
            return time * z
        return expr.func(*map(put, expr.args)) if expr.args else expr

    result = sp.Eq(put(equation.lhs), put(equation.rhs), evaluate=False)
    if result.has(old.func) or (z != t and result.has(t)):
        raise DerivationError(f"{old} is not changed to {new} throughout: {result}")
    return result


def _at(value, t):
    if value.variables != (t,):
        raise DerivationError(f"{value} is not a value at a time {t}")
    return value.point[0]
