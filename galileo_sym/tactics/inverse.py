"""Inverse functions of a monotone function: what the inverse undoes, and its bounds."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyIncreasing, tactic
from galileo_sym.ledger.equivalence import is_zero

from .places import direction


@tactic
def undo(claim, round_trip: sp.Eq, values, place) -> sp.Equivalent:
    """W(f(w)) = w exactly for those w that lie where W takes its values.

    f is one-to-one there, and f(W(f(w))) = f(w); elsewhere w cannot be a value of W.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
        Of f, on the interval where the inverse W takes its values.
    round_trip : Eq
        Eq(f(W(q)), q).
    values : Ge or Le
        Ge(W(q), end) or Le(W(q), end): where W takes its values.
    place : expression
        Put for w in the result.

    Returns
    -------
    Equivalent
        Eq(W(f(place)), place) and the relation of `place` to the end.
    """
    direction(claim)
    f, w, interval = claim.args
    inverse, end = values.lhs, values.rhs
    if interval != (sp.Interval(end, sp.oo) if isinstance(values, sp.Ge) else sp.Interval(-sp.oo, end)):
        raise DerivationError(f"{claim} does not cover {values}: f may take a value twice")
    value = round_trip.rhs
    if is_zero(round_trip.lhs - f.subs(w, inverse)) is None:
        raise DerivationError(f"{round_trip} does not say that {inverse} is the inverse of {f}")
    back = inverse.subs(value, f.subs(w, place))
    return sp.Equivalent(sp.Eq(back, place, evaluate=False), values.func(place, end, evaluate=False))


@tactic
def inverse_between(claim: StrictlyIncreasing, round_trip: sp.Eq, values: sp.Ge, argument, high, bounds) -> sp.And:
    """The inverse W of an increasing function f lies between its least value and `high` where its argument says so.

    Parameters
    ----------
    claim : StrictlyIncreasing
        Of f, on an interval that contains the least value and `high`.
    round_trip : Eq
        Eq(f(W(q)), q).
    values : Ge
        Ge(W(q), low): where W takes its values.
    argument : expression
    high : number
    bounds : And
        Proved: argument > f(low) and argument < f(high).

    Returns
    -------
    And
        Gt(W(argument), low) and Lt(W(argument), high).
    """
    f, w, interval = claim.args
    low, inverse = values.rhs, values.lhs.subs(round_trip.rhs, argument)
    covered = isinstance(values, sp.GreaterThan) and interval == sp.Interval(low, sp.oo) and round_trip.rhs.is_Symbol
    if not covered or is_zero(round_trip.lhs - f.subs(w, values.lhs)) is None:
        raise DerivationError(f"{round_trip} and {values} do not make an inverse of {claim}")
    if not isinstance(claim, StrictlyIncreasing) or not (low in interval and high in interval):
        raise DerivationError(f"{claim} does not compare {low} and {high}")
    above = sp.Gt(argument, f.subs(w, low), evaluate=False)
    below = sp.Lt(argument, f.subs(w, high), evaluate=False)
    for relation in (above, below):
        if relation not in bounds.args:
            raise DerivationError(f"{relation} is not among {bounds}")
    return sp.And(sp.Gt(inverse, low, evaluate=False), sp.Lt(inverse, high, evaluate=False))
