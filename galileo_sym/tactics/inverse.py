"""Inverse functions of a monotone function: what the inverse undoes, and its bounds."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyIncreasing, tactic
from galileo_sym.ledger.equivalence import is_zero


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
def inverse_between(claim: StrictlyIncreasing, inverse, argument, low, high, bounds) -> sp.And:
    """The inverse W of an increasing function f lies between `low` and `high` where its argument does.

    Parameters
    ----------
    claim : StrictlyIncreasing
        Of f, on an interval that contains `low` and `high`.
    inverse : expression
        W(argument), with values in that interval.
    low, high : numbers
    bounds : And
        Proved: argument > f(low) and argument < f(high).

    Returns
    -------
    And
        Gt(inverse, low) and Lt(inverse, high).
    """
    f, w, interval = claim.args
    if not isinstance(claim, StrictlyIncreasing) or not (low in interval and high in interval):
        raise DerivationError(f"{claim} does not compare {low} and {high}")
    above = sp.Gt(argument, f.subs(w, low), evaluate=False)
    below = sp.Lt(argument, f.subs(w, high), evaluate=False)
    for relation in (above, below):
        if relation not in bounds.args:
            raise DerivationError(f"{relation} is not among {bounds}")
    return sp.And(sp.Gt(inverse, low, evaluate=False), sp.Lt(inverse, high, evaluate=False))
