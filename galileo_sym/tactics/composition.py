"""Monotony of a composition from that of its parts."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic

from .places import direction
from .signs import monotone
from .solve import unhide


@tactic
def compose_monotone(outer, inner):
    """f(n(x)) on the interval of x, f and n both continuous and strictly monotone.

    Parameters
    ----------
    outer, inner : StrictlyIncreasing or StrictlyDecreasing
        Of f(n) and of n(x). The values of n, which lie between those at the ends, must be where f is known.

    Returns
    -------
    StrictlyIncreasing or StrictlyDecreasing
        Increasing if both have one direction.
    """
    way = direction(outer) * direction(inner)
    f, n, known = outer.args
    g, x, interval = inner.args
    _require_no_other_way(outer, x)
    ends = ((interval.start, interval.left_open), (interval.end, interval.right_open))
    for end, is_open in ends if known != sp.S.Reals else ():
        value = sp.simplify(g.subs(x, end))
        on_edge = is_open and value in (known.start, known.end)
        if known.contains(value) is not sp.true and not on_edge:
            raise DerivationError(f"{g} is {value} at {x} = {end}, where {outer} says nothing")
    return monotone(unhide(f, {n: g}), x, interval, way)


def _require_no_other_way(outer, x):
    """f(n) must not depend on x beside: for each x it would be another function."""
    f, n, known = outer.args
    if x != n and (f.has(x) or known.has(x)):
        raise DerivationError(f"{outer} depends on {x}, and not through {n} alone")


@tactic
def inner_monotone(claim, outer, inner, values):
    """n(x) is strictly monotone if f(n(x)) is, and f where n takes its values.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
        Of f(n(x)).
    outer : StrictlyIncreasing or StrictlyDecreasing
        Of f.
    inner : expression
        n(x).
    values : Interval
        Where n(x) is known to lie.

    Returns
    -------
    StrictlyIncreasing or StrictlyDecreasing
        Of n(x): increasing if both have one direction.
    """
    way = direction(claim) * direction(outer)
    both, x, interval = claim.args
    f, n, known = outer.args
    _require_no_other_way(outer, x)
    if both != f.subs(n, inner) or values.is_subset(known) is not True:
        raise DerivationError(f"{claim} is not {outer} of {inner}, with values in {values}")
    return monotone(inner, x, interval, way)
