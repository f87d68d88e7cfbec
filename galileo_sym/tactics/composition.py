"""Monotony of a composition from that of its parts."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing, tactic

from .signs import monotone


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
    f, n, known = outer.args
    g, x, interval = inner.args
    ends = ((interval.start, interval.left_open), (interval.end, interval.right_open))
    for end, is_open in ends:
        value = sp.simplify(g.subs(x, end))
        on_edge = is_open and value in (known.start, known.end)
        if known.contains(value) is not sp.true and not on_edge:
            raise DerivationError(f"{g} is {value} at {x} = {end}, where {outer} says nothing")
    same = isinstance(outer, StrictlyIncreasing) == isinstance(inner, StrictlyIncreasing)
    return monotone(f.subs(n, g), x, interval, 1 if same else -1)


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
    for told in (claim, outer):
        if not isinstance(told, StrictlyIncreasing | StrictlyDecreasing):
            raise DerivationError(f"{told} does not say that a function is monotone")
    both, x, interval = claim.args
    f, n, known = outer.args
    if both != f.subs(n, inner) or values.is_subset(known) is not True:
        raise DerivationError(f"{claim} is not {outer} of {inner}, with values in {values}")
    return monotone(inner, x, interval, 1 if isinstance(claim, type(outer)) else -1)
