"""Conjunctions that differ in one part, and inequalities that differ in their bound."""

from __future__ import annotations

import sympy as sp

from .cases import for_multiples
from .check import digits
from .environment import definitions, equations, resolve
from .equivalence import ORDERED, equivalent, is_zero
from .verdict import Kind

STRICT = (sp.StrictGreaterThan, sp.StrictLessThan)


def part_by_part(derived, other, declaration, known) -> tuple | None:
    """Kind, method and counterexample where two statements, true both, differ in one part; None if that says nothing.

    An inequality bounds a quantity, and is another statement than one that bounds it elsewhere, though both be true: a
    value between the bounds tells them apart.
    """
    if _covered(derived, other) and _covered(other, derived):
        return Kind.PROVED, "each part follows from one of the other's", None
    shared, mine, theirs = _differing(derived, other)
    if mine is None:
        return None
    if isinstance(mine, sp.Implies) and isinstance(theirs, sp.Implies) and mine.args[0] == theirs.args[0]:
        return part_by_part(mine.args[1], theirs.args[1], declaration, known)
    how = for_multiples(mine, theirs, declaration.domain, known)
    if how is not None:
        return Kind.PROVED, how, None
    apart = _between_bounds(mine, theirs, declaration)
    if apart is not None:
        return apart
    put = definitions(sp.And(*shared, evaluate=False))
    if _follows(mine, put, declaration.domain) and _follows(theirs, put, declaration.domain):
        return Kind.PROVED, "they differ in what follows from the parts they share", None
    return None


def _covered(one, other):
    """Whether each part of a statement follows from a part of another: it is the same, or a looser bound."""
    ours, theirs = [s.args if isinstance(s, sp.And) else (s,) for s in (one, other)]
    return all(any(_implied(part, known) for known in theirs) for part in ours)


def _implied(part, known):
    if part == known:
        return True
    if not (isinstance(part, ORDERED) and isinstance(known, ORDERED)):
        return False
    room = sp.expand((part.gts - part.lts) - (known.gts - known.lts))
    looser = room.is_number and (room.is_positive or (room == 0 and isinstance(known, STRICT)))
    return bool(looser) or equivalent(part, known) is not None


def _differing(derived, other):
    """The parts that two conjunctions share, and the one part of each that the other has not."""
    ours, rest = [list(s.args) if isinstance(s, sp.And) else [s] for s in (derived, other)]
    shared, alone = [], []
    for part in ours:
        twin = next((r for r in rest if equivalent(part, r)), None)
        if twin is None:
            alone.append(part)
        else:
            shared.append(part)
            rest.remove(twin)
    return (shared, alone[0], rest[0]) if len(alone) == len(rest) == 1 else (shared, None, None)


def _between_bounds(mine, theirs, declaration):
    if not (isinstance(mine, ORDERED) and isinstance(theirs, ORDERED)):
        return None
    room = sp.simplify((theirs.gts - theirs.lts) - (mine.gts - mine.lts))
    if not room.is_number or (room == 0 and isinstance(mine, STRICT) == isinstance(theirs, STRICT)):
        return None
    looser = room > 0 or (room == 0 and isinstance(mine, STRICT))
    who = ("other", "derived") if looser else ("derived", "other")
    point = declaration.domain.points(1, declaration.id)[0]
    excess = mine.gts - mine.lts
    shown = {str(s): digits(v) for s, v in point.items() if s in excess.free_symbols}
    method = f"as bounds: the {who[0]} one allows this value, the {who[1]} one does not"
    return Kind.REFUTED, method, {**shown, str(excess): digits(-room / 2)}


def _follows(part, put, domain):
    """Whether an equation becomes an identity with something put in."""
    pairs = list(equations(resolve(part, put, frozenset(domain.ranges))))
    return bool(pairs) and all(is_zero(a - b) is not None for a, b in pairs)
