"""Limits taken where SymPy is right: never through Lambert W, always by a parameter that removes it."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic

from .exponential_quotients import quotient_limit


@tactic
def elementary_limit(expr, variable, point, direction="+"):
    """The limit of an expression in elementary functions.

    Raises
    ------
    DerivationError
        The expression contains LambertW (SymPy's answer would be silently wrong: parametrise first), the variable's
        own sign forbids the side (SymPy would silently take the other one), or SymPy finds no limit.
    """
    cannot = {"+": variable.is_nonpositive, "-": variable.is_nonnegative}[direction]
    if cannot and sp.sympify(point).is_zero is not False:
        raise DerivationError(f"{variable} cannot come to {point} from the side {direction!r}: it has a sign")
    if expr.has(sp.LambertW):
        raise DerivationError(f"remove LambertW by a parameter before taking the limit of {expr}")
    known = quotient_limit(expr, variable, point)
    if known is not None:
        return known
    found = sp.limit(expr, variable, point, direction)
    if found.has(sp.Limit, sp.AccumBounds) or found is sp.nan:
        raise DerivationError(f"no limit found of {expr} as {variable} goes to {point}")
    return sp.simplify(found)


@tactic
def limit_by_parameter(expr, variable, point, direction, parameter, path, at, side="+"):
    """The limit of f(x), x -> point, along x = path(s), s -> at.

    `expr` must already be written in the parameter s; `path` is checked to tend to `point` from the side
    `direction`, monotonically near it.
    """
    require_approach(variable, point, direction, parameter, path, at, side)
    return elementary_limit(expr, parameter, at, side)


@tactic
def limit_along(known: sp.Eq, parameter, path, at, side="+"):
    """The limit of f(path(s)) as s -> at, from a proved limit Eq(Limit(f(x), x, point, direction), value)."""
    _, variable, point, direction = known.lhs.args
    require_approach(variable, point, str(direction), parameter, path, at, side)
    return known.rhs


def require_approach(variable, point, direction, parameter, path, at, side):
    """Raise unless a path tends to a point, from one side, as its parameter goes to a place."""
    if elementary_limit(path, parameter, at, side) != point:
        raise DerivationError(f"{variable} = {path} does not tend to {point} as {parameter} goes to {at}")
    order, slope = _first_slope(path, parameter, at, side)
    moves = slope * (1 if side == "+" else (-1) ** order)
    if not (moves.is_positive if direction == "+" else moves.is_negative):
        raise DerivationError(f"{variable} = {path} does not approach {point} from the side {direction!r}")


def _first_slope(path, parameter, at, side):
    """The first derivative that does not tend to 0: it decides from which side the path comes."""
    for order in (1, 2, 3):
        slope = elementary_limit(sp.diff(path, parameter, order), parameter, at, side)
        if slope != 0:
            break
    return order, slope
