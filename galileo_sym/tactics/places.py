"""What tactics ask of their premises: a direction of monotony, a place inside an interval."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.ledger.equivalence import is_zero


def direction(claim) -> int:
    """+1 for StrictlyIncreasing, -1 for StrictlyDecreasing; no other claim puts values in order."""
    if not isinstance(claim, StrictlyIncreasing | StrictlyDecreasing):
        raise DerivationError(f"{claim} does not say that a function is monotone")
    return 1 if isinstance(claim, StrictlyIncreasing) else -1


def require_inside(place, interval, known=()) -> None:
    """Raise unless a place is shown to lie in an interval.

    Parameters
    ----------
    place : expression
    interval : Interval
    known : sequence of Lt, Gt, Le, Ge
        Proved: that `place` is beyond the ends, where SymPy does not see it.
    """
    for low, high, strict in _order(place, interval):
        if not ordered(low, high, strict, known):
            raise DerivationError(f"{place} is not shown to lie in {interval}: {low} against {high}")


def _order(place, interval):
    """What must be in order for a place to lie in an interval: pairs, and whether strictly."""
    for one in place.args if isinstance(place, sp.Max) else (place,):
        yield one, interval.end, interval.right_open
    yield interval.start, place, interval.left_open


def ordered(low, high, strict: bool, known=()) -> bool:
    """Whether low < high (or low <= high) follows from assumptions, or is among the known relations."""
    if low is sp.S.NegativeInfinity or high is sp.oo:
        return True
    gap = sp.sympify(high - low)
    apart = _with_acute_angles(gap)
    if apart.is_positive or (apart.is_nonnegative and not strict):
        return True
    allowed = (sp.StrictLessThan, sp.StrictGreaterThan) if strict else sp.core.relational._Inequality
    return any(isinstance(r, allowed) and is_zero(r.gts - r.lts - gap) is not None for r in known)


def _with_acute_angles(expr):
    """The arctangent of something positive lies between 0 and pi/2, which SymPy does not know."""
    arcs = [e for e in expr.atoms(sp.atan) if e.args[0].is_positive]
    acute = {e: sp.pi / 2 / (1 + sp.Dummy("share", positive=True)) for e in arcs}
    return sp.factor(sp.together(expr.xreplace(acute))) if acute else expr
