"""Order of arguments and order of values: what a strictly monotone function carries over."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic

from .places import direction


@tactic
def same_order(claim, low, high, inside=None) -> sp.Equivalent:
    """A strictly monotone function orders two values as it orders their arguments, or the other way round.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
        Of f on an interval.
    low, high : expressions
        Two places in the interval.
    inside : dict, optional
        {place: Interval that it is known to lie in}, where SymPy does not see it.

    Returns
    -------
    Equivalent
        Lt(f(low), f(high)), or Gt for a decreasing f, and Lt(low, high).

    Raises
    ------
    DerivationError
        The claim is not about a monotone function, or a place is not shown to lie in its interval.
    """
    rises = direction(claim) > 0
    f, x, interval = claim.args
    for place in (low, high):
        known = (inside or {}).get(place, sp.FiniteSet(place))
        if interval.contains(place) is not sp.true and known.is_subset(interval) is not True:
            raise DerivationError(f"{place} is not shown to lie in {interval}, where {f} is monotone")
    values = sp.Lt if rises else sp.Gt
    return sp.Equivalent(values(f.subs(x, low), f.subs(x, high), evaluate=False), sp.Lt(low, high, evaluate=False))
