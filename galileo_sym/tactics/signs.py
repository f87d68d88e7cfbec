"""Proofs of signs: the derivative ladder, products of known signs, monotony from the sign of a derivative."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing, tactic
from galileo_sym.ledger.equivalence import is_zero

from .breaks import require_no_break
from .places import direction, ordered, require_inside
from .slope_trials import require_slope

DEPTH = 8  # rungs of the ladder before giving up


@tactic
def ladder(expr, variable) -> sp.Gt:
    """Prove expr > 0 for every variable > 0: h(0) >= 0 and h' > 0, again and again, h being smooth from 0 on.

    Returns
    -------
    Gt
        Gt(expr, 0).

    Raises
    ------
    DerivationError
        The ladder ends without a proof, or the expression is made of what may jump or have a pole.
    """
    positive = sp.Dummy("x", positive=True)
    if not _climb(expr.subs(variable, positive), positive, DEPTH):
        raise DerivationError(f"no proof that {expr} > 0 for {variable} > 0")
    return sp.Gt(expr, 0, evaluate=False)


@tactic
def ladder_order(smaller, larger, variable) -> sp.Lt:
    """Prove smaller < larger for every variable > 0, by the ladder for the difference."""
    ladder(larger - smaller, variable)
    return sp.Lt(smaller, larger, evaluate=False)


def _climb(expr, x, depth):
    expr = sp.simplify(expr)
    if expr.is_positive or sp.factor(expr).is_positive:
        return True
    if depth == 0 or not all(_smooth(part, x) for part in sp.preorder_traversal(expr) if part.has(x)):
        return False
    foot = sp.simplify(expr.subs(x, 0))
    return bool(foot.is_nonnegative) and _climb(sp.diff(expr, x), x, depth - 1)


_SMOOTH = (sp.Symbol, sp.Add, sp.Mul, sp.exp, sp.sin, sp.cos, sp.sinh, sp.cosh, sp.tanh, sp.atan, sp.asinh)


def _smooth(part, x):
    """Whether the last operation of an expression is smooth for x >= 0."""
    if isinstance(part, sp.Pow):
        natural = part.exp.is_Integer and part.exp.is_nonnegative
        return natural or (part.base.is_positive is True and part.base.subs(x, 0).is_positive is True)
    if isinstance(part, sp.log):
        return part.args[0].is_positive is True and part.args[0].subs(x, 0).is_positive is True
    return isinstance(part, _SMOOTH)


@tactic
def sign_by_factors(expr, factors: dict) -> int:
    """The sign (+1 or -1) of a product from the signs of its factors.

    Parameters
    ----------
    factors : dict
        Proved inequalities about parts of the product: {part: Gt(part, 0) or Lt(part, 0)}; what is left over must
        have a sign that SymPy knows from its assumptions.
    """
    hidden = _hide(expr, factors)
    if hidden.is_positive:
        return 1
    if hidden.is_negative:
        return -1
    raise DerivationError(f"the sign of {expr} does not follow from {list(factors.values())}: {hidden}")


@tactic
def not_negative(expr, factors: dict) -> sp.Ge:
    """Prove expr >= 0 from the signs of its factors, as `sign_by_factors` does for strict signs."""
    if not _hide(expr, factors).is_nonnegative:
        raise DerivationError(f"{expr} >= 0 does not follow from {list(factors.values())}")
    return sp.Ge(expr, 0, evaluate=False)


def _hide(expr, factors):
    """The expression in factors, with the parts whose sign is known replaced by symbols of that sign."""
    names = {part: sp.Dummy("part", **_assumption(part, proved)) for part, proved in factors.items()}
    product = sp.factor(expr)
    return sp.factor(product.subs(names))


def _assumption(part, proved):
    difference = sp.simplify(proved.gts - proved.lts)
    strict = isinstance(proved, sp.StrictGreaterThan | sp.StrictLessThan)
    if sp.simplify(difference - part) == 0:
        return {"positive": True} if strict else {"nonnegative": True}
    if sp.simplify(difference + part) == 0:
        return {"negative": True} if strict else {"nonpositive": True}
    raise DerivationError(f"{proved} says nothing of {part}")


@tactic
def monotone(function, variable, interval, slope_sign: int):
    """A function with a derivative of one sign inside an interval is strictly monotone on it.

    Parameters
    ----------
    function : expression
        Continuous on the interval.
    slope_sign : int
        +1 or -1: the sign of the derivative inside, proved.

    Raises
    ------
    DerivationError
        The sign is neither, or the function is seen to jump or to have a pole in the interval, or a slope of the
        other sign.
    """
    if slope_sign not in (1, -1):
        raise DerivationError(f"{slope_sign} is not the sign of a slope of {function}")
    require_no_break(function, variable, interval)
    require_slope(function, variable, interval, slope_sign)
    kind = StrictlyIncreasing if slope_sign > 0 else StrictlyDecreasing
    return kind(function, variable, interval)


@tactic
def monotone_by_slope(function, variable, interval, factors=None):
    """Strict monotony from the sign of the slope, which follows from assumptions and from the signs of its factors.

    Parameters
    ----------
    function : expression
        In powers, sums and exponentials of `variable`, and its tangent.
    interval : Interval
        Inside a quarter turn, if there is a tangent: it has a pole beyond.
    factors : dict, optional
        As for `sign_by_factors`.
    """
    tangent = sp.tan(variable)
    if function.has(tangent):
        for end, is_open in ((interval.start, interval.left_open), (interval.end, interval.right_open)):
            require_inside(end, sp.Interval(-sp.pi / 2, sp.pi / 2, not is_open, not is_open))
    slope = sp.diff(function, variable).subs(tangent, sp.Dummy("tangent", real=True))
    return monotone(function, variable, interval, sign_by_factors(slope, factors or {}))


@tactic
def values_ordered(claim, low, high, known=()) -> sp.Lt:
    """From a monotone function and low < high in its interval: its smaller value, then its larger one.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
    low, high : expressions
    known : sequence of relations
        Proved: that low < high, and that both lie in the interval, where SymPy does not see it.
    """
    rises = direction(claim) > 0
    function, variable, interval = claim.args
    for place in (low, high):
        require_inside(place, interval, known)
    if not ordered(low, high, strict=True, known=known):
        raise DerivationError(f"{low} < {high} is not shown")
    first, last = function.subs(variable, low), function.subs(variable, high)
    return sp.Lt(first, last, evaluate=False) if rises else sp.Lt(last, first, evaluate=False)


@tactic
def restricted(claim, part, known=()):
    """Strict monotony on an interval holds on a part of it.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
    part : Interval
    known : sequence of relations
        Proved: that the ends of the part are inside, where SymPy does not see it.
    """
    function, variable, whole = claim.args
    low = ordered(whole.start, part.start, whole.left_open and not part.left_open, known)
    if not (low and ordered(part.end, whole.end, whole.right_open and not part.right_open, known)):
        raise DerivationError(f"{part} is not shown to lie in {whole}")
    return monotone(function, variable, part, direction(claim))


@tactic
def positive_before_root(claim, root, variable, known=()):
    """A strictly decreasing function that vanishes at `root` is positive exactly before it.

    Parameters
    ----------
    claim : StrictlyDecreasing
    root, variable : expressions
        Both in the interval of the claim; `known` has the relations that say so, where SymPy does not see it.
    """
    function, x, interval = claim.args
    for place in (root, variable):
        require_inside(place, interval, known)
    if not isinstance(claim, StrictlyDecreasing):
        raise DerivationError(f"{claim} is not a strictly decreasing function")
    if is_zero(function.subs(x, root)) is None:
        raise DerivationError(f"{function} does not vanish at {root}")
    return sp.Equivalent(sp.Gt(function.subs(x, variable), 0, evaluate=False), sp.Lt(variable, root, evaluate=False))


@tactic
def arguments_reversed(claim, below, low, image, high, inside=()) -> sp.Lt:
    """From a strictly decreasing f and f(low) < f(high): high < low.

    Parameters
    ----------
    claim : StrictlyDecreasing
    below : Lt
        Lt(f(low), v), proved.
    image : Eq
        Eq(f(high), v).
    inside : sequence of Le and Ge
        Proved: `low` or `high` does not pass an end of the interval, where SymPy does not see it.
    """
    function, x, interval = claim.args
    for place in (low, high):
        if interval.contains(place) is not sp.true and not any(_keeps(fact, place, interval) for fact in inside):
            raise DerivationError(f"{place} is not shown to lie in {interval}, where {function} decreases")
    strict = isinstance(below, sp.StrictLessThan | sp.StrictGreaterThan)
    fits = strict and isinstance(claim, StrictlyDecreasing) and is_zero(below.lts - function.subs(x, low))
    if not fits or is_zero(image.lhs - function.subs(x, high)) is None or is_zero(image.rhs - below.gts) is None:
        raise DerivationError(f"{below} and {image} are not about {claim}")
    return sp.Lt(high, low, evaluate=False)


def _keeps(fact, place, interval):
    """Whether a relation says that a place lies in a closed half-line."""
    low, high = interval.start, interval.end
    if low is sp.S.NegativeInfinity:
        return isinstance(fact, sp.GreaterThan | sp.LessThan) and (fact.lts, fact.gts) == (place, high)
    return high is sp.oo and isinstance(fact, sp.GreaterThan | sp.LessThan) and (fact.lts, fact.gts) == (low, place)
