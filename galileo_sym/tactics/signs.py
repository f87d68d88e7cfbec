"""Proofs of signs: the derivative ladder, products of known signs, monotony from the sign of a derivative."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing, tactic

DEPTH = 8  # rungs of the ladder before giving up


@tactic
def ladder(expr, variable) -> sp.Gt:
    """Prove expr > 0 for every variable > 0: h(0) >= 0 and h' > 0, again and again.

    Returns
    -------
    Gt
        Gt(expr, 0).
    """
    positive = sp.Dummy("x", positive=True)
    if not _climb(expr.subs(variable, positive), positive, DEPTH):
        raise DerivationError(f"no proof that {expr} > 0 for {variable} > 0")
    return sp.Gt(expr, 0, evaluate=False)


def _climb(expr, x, depth):
    expr = sp.simplify(expr)
    if expr.is_positive or sp.factor(expr).is_positive:
        return True
    if depth == 0:
        return False
    foot = sp.simplify(expr.subs(x, 0))
    return bool(foot.is_nonnegative) and _climb(sp.diff(expr, x), x, depth - 1)


@tactic
def sign_by_factors(expr, factors: dict) -> int:
    """The sign (+1 or -1) of a product from the signs of its factors.

    Parameters
    ----------
    factors : dict
        Proved inequalities about parts of the product: {part: Gt(part, 0) or Lt(part, 0)}; what is left over must
        have a sign that SymPy knows from its assumptions.
    """
    names = {}
    for part, proved in factors.items():
        names[part] = sp.Dummy("part", **_assumption(part, proved))
    hidden = sp.factor(expr.subs(names)) if names else expr
    left = hidden.free_symbols
    if hidden.is_positive:
        return 1
    if hidden.is_negative:
        return -1
    raise DerivationError(f"the sign of {expr} does not follow from {list(factors.values())} ({hidden}, {left})")


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
    """A function with a derivative of one sign inside an interval is strictly monotone on it."""
    kind = StrictlyIncreasing if slope_sign > 0 else StrictlyDecreasing
    return kind(function, variable, interval)
