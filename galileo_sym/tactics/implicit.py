"""Functions that are given by an equation: their derivatives, and where they do not take an end value."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic
from galileo_sym.ledger.equivalence import is_zero

from .boxes import box_of, sign_by_ladder, sign_on

_ALWAYS_SMOOTH = (sp.Symbol, sp.Add, sp.Mul, sp.exp, sp.sin, sp.cos)


@tactic
def implicit_derivative(equation: sp.Eq, unknown, variable, *facts, box=None) -> sp.Eq:
    """Differentiate an equation F(x, y) = 0 and solve for the derivative of the unknown function y(x).

    F rises with y, or falls, on an open interval where y lies: y(x) is the only root there, has a derivative by the
    implicit function theorem, and what it is divided by is not 0.

    Parameters
    ----------
    equation : Eq
        Between `variable` and `unknown`, such as Eq(y(u)*exp(y(u)), u*exp(u)); smooth in both.
    unknown : applied function, y(u)
    variable : Symbol, u
    *facts : Lt, Gt, or And of those
        Proved: between which numbers the unknown lies.
    box : dict, optional
        {part: open Interval} for the sign of dF/dy, if both ends are finite, as for `sign_on`.

    Returns
    -------
    Eq
        Eq(Derivative(y(u), u), expression in u and y(u)).

    Raises
    ------
    DerivationError
        F is not seen to be smooth, the facts do not say where y lies, or dF/dy may vanish there.
    """
    slope, name, height = sp.Derivative(unknown, variable), sp.Dummy("slope"), sp.Dummy("height", real=True)
    excess = equation.lhs - equation.rhs
    plain = excess.subs(unknown, height)
    for part in sp.preorder_traversal(plain):
        if part.has(variable, height) and not _smooth(part):
            raise DerivationError(f"{part} is not seen to be smooth in {variable} and {unknown}")
    _require_one_sign(sp.diff(plain, height), height, box_of(*facts).get(unknown), box or {})
    total = sp.diff(excess, variable).doit().subs(slope, name)
    roots = sp.solve(total, name)
    if len(roots) != 1:
        raise DerivationError(f"the derivative of {unknown} is not determined by {equation}: {roots}")
    return sp.Eq(slope, roots[0], evaluate=False)


def _smooth(part):
    return isinstance(part, _ALWAYS_SMOOTH) or (part.is_Pow and part.exp.is_Integer and part.exp.is_positive)


def _require_one_sign(partial, height, values, box):
    """Raise unless a partial derivative keeps one sign while the height runs through an open interval."""
    if not isinstance(values, sp.Interval):
        raise DerivationError("where the unknown function lies is not told by the facts")
    if values.start.is_finite and values.end.is_finite:
        sign_on(partial, {height: values, **box})
        return
    away = sp.Dummy("h", positive=True)
    place = values.start + away if values.start.is_finite else values.end - away
    if sign_by_ladder(partial.subs(height, place), away) not in (1, -1):
        raise DerivationError(f"{partial} may vanish in {values}")


@tactic
def above_end(round_trip: sp.Eq, values: sp.Ge, inside: sp.Gt) -> sp.Gt:
    """An inverse of f does not take its least value but at the image of it.

    Parameters
    ----------
    round_trip : Eq
        Eq(f(W(q)), q), f written out.
    values : Ge
        Ge(W(q), low).
    inside : Gt
        Gt(q, f(low)), proved or supposed.

    Returns
    -------
    Gt
        Gt(W(q), low): where W were low, q would be f(low).
    """
    inverse, low = values.lhs, values.rhs
    image = round_trip.lhs.subs(inverse, low)
    fits = isinstance(values, sp.GreaterThan) and isinstance(inside, sp.StrictGreaterThan)
    if not fits or not round_trip.lhs.has(inverse) or is_zero(inside.lhs - round_trip.rhs) is None:
        raise DerivationError(f"{values} and {inside} are not about {round_trip}")
    if image.has(round_trip.rhs) or is_zero(inside.rhs - image) is None:
        raise DerivationError(f"{inside} does not say that {round_trip.rhs} is above {image}")
    return sp.Gt(inverse, low, evaluate=False)
