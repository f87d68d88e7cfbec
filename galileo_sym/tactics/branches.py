"""All solutions of f(w) = q, each by its branch of the inverse of f."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic
from galileo_sym.ledger.equivalence import is_zero

from .inverse import undo


@tactic
def all_preimages(inverses, variable, *, never=()) -> sp.Equivalent:
    """All solutions of f(w) = q on the real line, from inverses of f on intervals that cover it.

    On each interval f is one-to-one and W(f(w)) = w, so that f(w) = q leaves w = W(q) alone; and f(W(q)) = q.

    Parameters
    ----------
    inverses : sequence of triples (claim, round trip, values)
        As `undo` takes them, all of one f and one q.
    variable : Symbol
        The w of the claims.
    never : sequence of pairs (interval, relation)
        Where f does not take the value: a proved Lt(f(w), q) or Gt(f(w), q), strict, for every w of the interval.

    Returns
    -------
    Equivalent
        Eq(f(w), q) and Eq(w, W(q)), or the disjunction of those.

    Raises
    ------
    DerivationError
        The intervals do not cover the real line, or the inverses are not of one function and value.
    """
    (first, trip, _), value = inverses[0], inverses[0][1].rhs
    if not value.is_Symbol:
        raise DerivationError(f"{trip} does not say what {value} is for every {value}")
    function, roots, covered = first.args[0], [], sp.S.EmptySet
    for claim, round_trip, values in inverses:
        undo(claim, round_trip, values, variable)
        if claim.args[:2] != (function, variable) or round_trip.rhs != value:
            raise DerivationError(f"{claim} and {round_trip} do not speak of {first} and {trip}")
        roots.append(sp.Eq(variable, values.lhs, evaluate=False))
        covered |= claim.args[2]
    for interval, relation in never:
        strict = isinstance(relation, sp.StrictLessThan | sp.StrictGreaterThan)
        apart = relation.lhs - relation.rhs
        if not strict or (is_zero(apart - function + value) is None and is_zero(apart + function - value) is None):
            raise DerivationError(f"{relation} does not say that {function} is never {value}")
        covered |= interval
    if covered != sp.S.Reals and covered != sp.Interval(-sp.oo, sp.oo):
        raise DerivationError(f"solutions outside {covered} are not accounted for")
    return sp.Equivalent(sp.Eq(function, value, evaluate=False), sp.Or(*roots))
