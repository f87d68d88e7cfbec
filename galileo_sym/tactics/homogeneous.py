"""The functional equation f(lambda u) = lambda f(u), 0 < lambda <= 1, with lambda the cosine of an angle."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, Independent, tactic
from galileo_sym.ledger.equivalence import is_zero


@tactic
def independent_sides(equation: sp.Eq, variable, hidden=()) -> tuple:
    """Both sides of an equation are independent of a variable, since the right one is.

    Parameters
    ----------
    equation : Eq
        Holds for every value of `variable`.
    hidden : sequence of undefined functions
        Those that depend on `variable`, though it is not among their arguments.

    Returns
    -------
    pair of Independent
        Of the left side and of the right side.
    """
    left, right = equation.args
    if right.has(variable, *hidden):
        raise DerivationError(f"{right} depends on {variable}")
    return Independent(left, variable), Independent(right, variable)


@tactic
def homogeneous(claim: Independent, function, hidden=()) -> sp.Eq:
    """From f(cos(a) u)/cos(a), independent of the angle a, and its value at a = 0: f(cos(a) u) = cos(a) f(u).

    Parameters
    ----------
    claim : Independent
    function : undefined function, f
    hidden : sequence of undefined functions
        Those that depend on the angle, though it is not among their arguments: u must have none.
    """
    quotient, angle = claim.args
    if quotient.has(*hidden):
        raise DerivationError(f"what {quotient} is at {angle} = 0 is not known: {hidden} depend on it")
    inside = [e for e in quotient.atoms(function) if e.has(angle)]
    if len(inside) != 1 or not isinstance(claim, Independent):
        raise DerivationError(f"{claim} is not about one value of {function}")
    start = quotient.subs(angle, 0)
    weight = quotient / inside[0]
    return sp.Eq(inside[0], sp.cancel(start / weight), evaluate=False)


def _read(equation, function, angle):
    """The speed u of f(cos(angle) u) = cos(angle) f(u)."""
    left, right = equation.args
    if not isinstance(left, function):
        raise DerivationError(f"{left} is not a value of {function}")
    speed = left.args[0].subs(angle, 0)
    weight = sp.cos(angle)
    if is_zero(left.args[0] - weight * speed) is None or is_zero(right - weight * function(speed)) is None:
        raise DerivationError(f"{equation} is not homogeneous in cos({angle})")
    return speed


@tactic
def proportional_below(equation: sp.Eq, function, angle, value, above) -> sp.Eq:
    """From f(cos(a) u) = cos(a) f(u), |a| < pi/2, to u f(v) = v f(u) for 0 < v <= u: take a = acos(v/u).

    No regularity of f is needed.

    Parameters
    ----------
    equation : Eq
    function : undefined function, f
    angle : Symbol, a
    value : expression, v
        Positive.
    above : Gt or Ge
        Proved: u is above `value`, or above a Max of which it is one.
    """
    speed = _read(equation, function, angle)
    bound = above.lts
    if not value.is_positive or above.gts != speed or value not in sp.Max.make_args(bound):
        raise DerivationError(f"{above} does not say that 0 < {value} <= {speed}")
    chosen = equation.subs(angle, sp.acos(value / speed))
    return sp.Eq(speed * chosen.lhs, sp.expand(speed * chosen.rhs), evaluate=False)


@tactic
def by_differentiation(equation: sp.Eq, function, angle, value) -> tuple:
    """The same for an f that is differentiable: f(cos(a) u) = cos(a) f(u), differentiated by a, is v f'(v) = f(v).

    Returns
    -------
    pair of Eq
        The differential equation, and its solution Eq(f(v), C1*v).
    """
    speed = _read(equation, function, angle)
    v = sp.Symbol("v", positive=True)
    opposite = sp.Dummy("sine", positive=True)  # the angle is not 0: there the slope by the angle says nothing
    slope = sp.diff(equation.lhs - equation.rhs, angle).subs(function(speed), function(v) / sp.cos(angle))
    slope = slope.subs(speed, v / sp.cos(angle)).doit().subs(sp.sin(angle), opposite)
    derivative = sp.Derivative(function(v), v)
    roots = sp.solve(slope, derivative)
    if len(roots) != 1:
        raise DerivationError(f"{slope} does not determine the slope of {function}")
    law = sp.Eq(v * derivative, sp.simplify(v * roots[0]), evaluate=False)
    solution = sp.dsolve(law.lhs - law.rhs, function(v))
    return tuple(e.xreplace({v: value}) for e in (law, solution))
