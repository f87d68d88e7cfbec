"""Monotony of a composition from that of its parts."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyIncreasing, tactic

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
