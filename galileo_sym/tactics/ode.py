"""Linear equations of motion solved with initial values."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, step, tactic


@tactic
def solve_motion(equation: sp.Eq, unknown, start: dict) -> sp.Eq:
    """Solve a linear differential equation and check the solution by putting it back.

    Parameters
    ----------
    equation : Eq
        In `unknown` and its derivatives.
    unknown : applied function, such as s(t)
    start : dict
        Initial values: {s(0): 0, Derivative(s(t), t).subs(t, 0): 0}.

    Returns
    -------
    Eq
        Eq(s(t), expression).

    Raises
    ------
    DerivationError
        The equation is not linear, or has too few initial values, so that there are other solutions; or the solution
        found misses the equation or an initial value.
    """
    _require_linear(equation, unknown)
    time = unknown.args[0]
    plain, back = _plain(equation, unknown)
    begin = {_rename(k, plain): _rename(sp.sympify(v), plain) for k, v in start.items()}
    found = sp.dsolve(_rename(equation, plain), _rename(unknown, plain), ics=begin)
    expression = sp.expand(_rename(found.rhs, back))
    known = {time}.union(equation.free_symbols, *(sp.sympify(v).free_symbols for v in start.values()))
    if expression.free_symbols - known:
        raise DerivationError(f"{start} does not determine the constants in {expression}")
    _check(equation, unknown, expression, start, time)
    return sp.Eq(unknown, expression, evaluate=False)


def _require_linear(equation, unknown):
    derivatives = {e for e in equation.atoms(sp.Derivative) if e.expr == unknown}
    names = {e: sp.Dummy("part") for e in (unknown, *derivatives)}
    # at once, and from the outside: the function stands inside its derivatives, too
    hidden = sp.expand((equation.lhs - equation.rhs).xreplace(names))
    if not hidden.is_polynomial(*names.values()) or sp.Poly(hidden, *names.values()).total_degree() != 1:
        raise DerivationError(f"{equation} is not linear in {unknown}")


def _plain(equation, unknown):
    """Coefficients with cosines in them are hidden from dsolve behind plain symbols."""
    coefficients = sorted(equation.atoms(sp.sin, sp.cos, sp.tan), key=str)
    plain = {c: sp.Dummy(f"c{i}", real=True) for i, c in enumerate(coefficients)}
    return plain, {v: k for k, v in plain.items()}


def _rename(expr, table):
    return sp.sympify(expr).xreplace(table)


def _check(equation, unknown, expression, start, time):
    motion = sp.Lambda(time, expression)
    residual = (equation.lhs - equation.rhs).subs(unknown, expression).doit()
    if sp.simplify(residual) != 0:
        raise DerivationError(f"{expression} does not solve {equation}: {residual} is left")
    for condition, wanted in start.items():
        order = sum(d[1] for d in condition.expr.variable_count) if isinstance(condition, sp.Subs) else 0
        got = sp.diff(motion(time), time, order).subs(time, 0) if order else motion(sp.S.Zero)
        if sp.simplify(got - wanted) != 0:
            raise DerivationError(f"{expression} starts with {condition} = {got}, not {wanted}")


def at_rest(unknown) -> dict:
    """Initial values of a body released from rest at the origin."""
    time = unknown.args[0]
    return {unknown.subs(time, 0): 0, unknown.diff(time).subs(time, 0): 0}


def start_of(statements, unknown) -> dict:
    """The initial values of `unknown` among some equations: those about x(0) and x'(0)."""

    def about_start(side):
        if isinstance(side, sp.Subs):
            return side.expr.has(unknown.func)
        return isinstance(side, type(unknown)) and side.func == unknown.func and side.args == (0,)

    return {e.lhs: e.rhs for e in statements if about_start(e.lhs)}


@tactic
def integrate_from_zero(equation: sp.Eq, unknown) -> sp.Eq:
    """From Eq(Derivative(x(t), t), f(t)) and x(0) = 0 to x(t), the integral of f from 0 to t."""
    time = unknown.args[0]
    if equation.lhs != sp.Derivative(unknown, time):
        raise DerivationError(f"{equation} does not give the derivative of {unknown}")
    dummy = sp.Dummy("t", real=True)
    value = sp.integrate(sp.expand(equation.rhs.subs(time, dummy)), (dummy, 0, time))
    if sp.simplify(sp.diff(value, time) - equation.rhs) != 0 or value.subs(time, 0) != 0:
        raise DerivationError(f"{value} is not the integral of {equation.rhs} from 0")
    return step("integrate from 0", sp.Eq(unknown, value, evaluate=False))
