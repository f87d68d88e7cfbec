"""Limits put together from limits that are known: of a part of an expression, or of an inverse function."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing, tactic
from galileo_sym.ledger.equivalence import is_zero

from .limits import elementary_limit
from .places import ordered

_ENDLESS = (sp.oo, sp.S.NegativeInfinity, sp.zoo, sp.nan)


@tactic
def limit_with_part(expr, part, value, variable, point, direction="+"):
    """The limit of a polynomial in a part whose own limit is known, with elementary coefficients.

    Parameters
    ----------
    expr : expression in `variable` and `part`
    part : symbol or applied function
        Depends on the variable.
    value : expression
        Its proved limit, finite.
    """
    name = sp.Dummy("part", real=True)
    hidden = sp.expand(expr.subs(part, name))
    if not hidden.is_polynomial(name):
        raise DerivationError(f"{expr} is not a polynomial in {part}")
    value = sp.sympify(value)
    if value.has(*_ENDLESS):
        raise DerivationError(f"the limit of {part} is not finite")
    total = sp.S.Zero
    for (power,), coefficient in sp.Poly(hidden, name).terms():
        limit = elementary_limit(coefficient, variable, point, direction)
        if limit.has(*_ENDLESS):
            raise DerivationError(f"in {expr} the coefficient of {part}**{power} grows without bound")
        total += limit * value**power
    return sp.simplify(total)


@tactic
def limit_of_inverse(claim, round_trip: sp.Eq, values, above: sp.Gt) -> sp.Expr:
    """The limit of W(a) where a tends to a value inside the range of f: W of that value.

    The inverse of a continuous function that is strictly monotone on an interval is continuous.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
        Of f, on the half-line where its inverse W takes its values.
    round_trip : Eq
        Eq(f(W(q)), q).
    values : Ge or Le
        Ge(W(q), end) or Le(W(q), end).
    above : Gt
        Proved: the limit of a is above f(end), the least value. It must lie below what f tends to far out, too.

    Returns
    -------
    expression
        W(limit of a).
    """
    f, w, interval = claim.args
    inverse, end = values.lhs, values.rhs
    rising = isinstance(values, sp.GreaterThan)
    kind, side = (
        (StrictlyIncreasing, sp.Interval(end, sp.oo)) if rising else (StrictlyDecreasing, sp.Interval(-sp.oo, end))
    )
    if not isinstance(claim, kind) or interval != side:
        raise DerivationError(f"{claim} is not about the values {values}, above the least one at {end}")
    if is_zero(round_trip.lhs - f.subs(w, inverse)) is None or not round_trip.rhs.is_Symbol:
        raise DerivationError(f"{round_trip} does not say that {inverse} is the inverse of {f}")
    if not isinstance(above, sp.StrictGreaterThan) or is_zero(above.rhs - f.subs(w, end)) is None:
        raise DerivationError(f"{above} does not compare a limit with the least value of {f}")
    far = elementary_limit(f, w, sp.oo if rising else -sp.oo, "-" if rising else "+")
    if not ordered(above.lhs, far, strict=True):
        raise DerivationError(f"{above.lhs} is not shown to be below {far}, what {f} tends to")
    return inverse.subs(round_trip.rhs, above.lhs)
