"""Hypotheses put to use: a general statement at one value, an implication whose condition is supposed."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, ForAll, PowerSeries, Premise, tactic
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.ledger.predicates import Claim

from .places import direction, require_inside


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
        The place is not shown to lie in the interval, or has a variable that is bound inside.
    """
    if not isinstance(claim, ForAll):
        raise DerivationError(f"{claim} is not said of every value")
    statement, x, interval = claim.args
    require_inside(place, interval, inside)
    _require_free(place, statement)
    return statement.subs(x, place)


@tactic
def everywhere(claim, variable, interval) -> ForAll:
    """What a power series, or an equivalence, says of every value in an interval.

    Parameters
    ----------
    claim : PowerSeries, or Equivalent
        A function is the sum of its series for every real x; Equivalent(statement, Ge or Le), where the relation tells
        the values for which the statement holds.
    variable : Symbol
    interval : Interval

    Raises
    ------
    DerivationError
        The relation does not hold throughout the interval.
    """
    if isinstance(claim, PowerSeries):
        f, x, place, coefficient, n = claim.args
        told = sp.Eq(f, sp.Sum(coefficient * (x - place) ** n, (n, 0, sp.oo)), evaluate=False)
        return ForAll(told.xreplace({x: variable}), variable, interval)
    sides = claim.args if isinstance(claim, sp.Equivalent) else ()
    bounds = [e for e in sides if isinstance(e, sp.GreaterThan | sp.LessThan) and e.free_symbols == {variable}]
    if len(bounds) != 1 or interval.is_subset(bounds[0].as_set()) is not True:
        raise DerivationError(f"{claim} is not said of every {variable} in {interval}")
    (statement,) = (e for e in sides if e != bounds[0])
    return ForAll(statement, variable, interval)


def _require_free(place, statement):
    """A variable of the place must not be one that a claim inside the statement speaks of in general."""
    bound = set().union(*(part.bound_symbols for part in statement.atoms(Claim)))
    if bound & place.free_symbols:
        raise DerivationError(f"{place} has a variable that {statement} binds")


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
def conclusions(premise: Premise, variable, place) -> Premise:
    """What a conjunction with implications says of a place that meets their conditions.

    Parameters
    ----------
    premise : Premise
    variable : Symbol
        Of the conditions. It stays in what is returned, which is true of `place`.
    place : expression
        SymPy must see, from the signs of its symbols, that it meets the conditions.
    """
    told = []
    for part in premise.parts:
        condition, conclusion = part.args if isinstance(part, sp.Implies) else (sp.true, part)
        if condition.free_symbols - {variable} or condition.subs(variable, place) != sp.true:
            raise DerivationError(f"{place} is not shown to meet {condition}")
        told += sp.And.make_args(conclusion)
    return Premise(premise.id, sp.And(*told, evaluate=False))


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
    direction(claim)
    f, x, interval = claim.args
    for side, place in ((equal.lhs, one), (equal.rhs, other)):
        if interval.contains(place) is not sp.true or is_zero(side - f.subs(x, place)) is None:
            raise DerivationError(f"{side} is not the value of {f} at {place} in {interval}")
    return sp.Eq(one, other, evaluate=False)
