"""The root of an equation in another unit of its unknown."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, ExactlyOneRoot, tactic


@tactic
def root_at_scale(claim: ExactlyOneRoot, new, unit, *, over=sp.S.One) -> ExactlyOneRoot:
    """Put x = unit * new into a claim of one root: it has one root in the interval divided by the unit.

    Parameters
    ----------
    claim : ExactlyOneRoot
        Of f(x) in an interval.
    new : Symbol
        The unknown in the new unit.
    unit : expression
        Positive, free of x and of `new`.
    over : expression
        What the equation is divided by: not 0, free of `new`.

    Returns
    -------
    ExactlyOneRoot
        Of f(unit * new)/over.

    Raises
    ------
    DerivationError
        The unit is not known to be positive, the divisor to be other than 0, or one of them depends on the unknown.
    """
    if not isinstance(claim, ExactlyOneRoot):
        raise DerivationError(f"{claim} does not say that there is one root")
    f, x, interval = claim.args
    unit, over = sp.sympify(unit), sp.sympify(over)
    if unit.is_positive is not True or over.is_nonzero is not True:
        raise DerivationError(f"{unit} is not known to be positive, or {over} to be other than 0")
    if unit.has(x, new) or over.has(x, new) or f.has(new):
        raise DerivationError(f"{unit}, {over} or {f} depends on the unknown")
    start, end = (sp.expand(e / unit) if e.is_finite else e for e in (interval.start, interval.end))
    ends = sp.Interval(start, end, interval.left_open, interval.right_open)
    return ExactlyOneRoot(sp.expand(f.subs(x, unit * new) / over), new, ends)
