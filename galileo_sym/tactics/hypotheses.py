"""Hypotheses put to use: a general statement at one value, an implication whose condition is supposed."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, ForAll, StrictlyDecreasing, StrictlyIncreasing, tactic
from galileo_sym.ledger.equivalence import is_zero


@tactic
def instantiate(claim: ForAll, place, inside=()) -> sp.Basic:
    """What holds for every x of an interval, at one place in it.

    Parameters
    ----------
    claim : ForAll
    place : expression
    inside : sequence of Lt, Gt, Le, Ge
        Proved: that `place` is beyond the ends of the interval, where SymPy does not see it.

    Raises
    ------
    DerivationError
        The place is not shown to lie in the interval.
    """
    if not isinstance(claim, ForAll):
        raise DerivationError(f"{claim} is not said of every value")
    statement, x, interval = claim.args
    for low, high, strict in _order(place, interval):
        if not _ordered(low, high, strict, inside):
            raise DerivationError(f"{place} is not shown to lie in {interval}: {low} against {high}")
    return statement.subs(x, place)


def _order(place, interval):
    """What must be in order for a place to lie in an interval: pairs, and whether strictly."""
    for one in place.args if isinstance(place, sp.Max) else (place,):
        yield one, interval.end, interval.right_open
    yield interval.start, place, interval.left_open


def _ordered(low, high, strict, known):
    if low is sp.S.NegativeInfinity or high is sp.oo:
        return True
    gap = high - low
    if gap.is_positive or (gap.is_nonnegative and not strict):
        return True
    allowed = (sp.StrictLessThan, sp.StrictGreaterThan) if strict else sp.core.relational._Inequality
    return any(isinstance(r, allowed) and is_zero(r.gts - r.lts - gap) is not None for r in known)


@tactic
def modus_ponens(implication: sp.Implies, supposed) -> sp.Basic:
    """The conclusion of an implication, each of whose conditions is supposed."""
    if not isinstance(implication, sp.Implies):
        raise DerivationError(f"{implication} is not an implication")
    condition, conclusion = implication.args
    missing = [c for c in sp.And.make_args(condition) if c not in supposed]
    if missing:
        raise DerivationError(f"not supposed: {missing}")
    return conclusion


@tactic
def same_argument(claim, equal: sp.Eq, one, other) -> sp.Eq:
    """A strictly monotone function takes no value twice: from f(a) = f(b) to a = b.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
        Of f, on an interval that contains both a and b.
    equal : Eq
        Eq(f(a), f(b)), proved.
    one, other : expressions a and b
    """
    if not isinstance(claim, StrictlyIncreasing | StrictlyDecreasing):
        raise DerivationError(f"{claim} does not exclude that a value is taken twice")
    f, x, interval = claim.args
    for side, place in ((equal.lhs, one), (equal.rhs, other)):
        if interval.contains(place) is not sp.true or is_zero(side - f.subs(x, place)) is None:
            raise DerivationError(f"{side} is not the value of {f} at {place} in {interval}")
    return sp.Eq(one, other, evaluate=False)
