"""Where a function may jump, or has no value: what a claim of continuity is to be tried at."""

from __future__ import annotations

from itertools import pairwise

import sympy as sp
from mpmath import mp

from .predicates import spread

DIGITS = 60  # of a place found as a change of sign: more than the distance at which continuity is tried
MOST = 12  # places of one part

# what vanishes where a function jumps, has a corner or a pole
_VANISHING = {
    sp.sign: lambda e: e.args[0],
    sp.Heaviside: lambda e: e.args[0],
    sp.Abs: lambda e: e.args[0],
    sp.log: lambda e: e.args[0],
    sp.floor: lambda e: sp.sin(sp.pi * e.args[0]),
    sp.ceiling: lambda e: sp.sin(sp.pi * e.args[0]),
    sp.frac: lambda e: sp.sin(sp.pi * e.args[0]),
    sp.Mod: lambda e: sp.sin(sp.pi * e.args[0] / e.args[1]),
    sp.tan: lambda e: sp.cos(e.args[0]),
    sp.cot: lambda e: sp.sin(e.args[0]),
    sp.Pow: lambda e: e.base if e.exp.is_negative else sp.S.One,
}


def breaking_places(f, x, interval):
    """Places inside an interval where a part of f may break, as far as no other quantity decides on them."""
    suspects = {vanishing(e) for kind, vanishing in _VANISHING.items() for e in f.atoms(kind)}
    known = [s for s in suspects if s.free_symbols == {x} and not s.has(sp.LambertW)]
    if interval.free_symbols:
        return []
    places = [place for s in sorted(known, key=sp.default_sort_key) for place in _zeros(s, x, interval)[:MOST]]
    return [place for place in places if interval.contains(place) == sp.true]


def _zeros(expr, x, interval):
    """Zeros of an expression: all of a polynomial over the rationals, else those seen as changes of sign."""
    if expr.is_polynomial(x) and sp.Poly(expr, x).domain in (sp.ZZ, sp.QQ):
        return sorted(set(sp.Poly(expr, x).real_roots()))
    value = sp.lambdify(x, expr, "mpmath")
    with mp.workdps(DIGITS):
        grid = [mp.mpmathify(sp.N(place, DIGITS)) for place in spread(interval, 33)]
        changes = [pair for pair in pairwise(grid) if _change(value, *pair)][:MOST]
        return [sp.Float(_bisected(value, *pair), DIGITS) for pair in changes]


def _change(value, low, high):
    """Whether a real value changes its sign, or is 0 at an end."""
    try:
        first, last = value(low), value(high)
    except ZeroDivisionError:
        return False
    return mp.im(first) == mp.im(last) == 0 and mp.re(first) * mp.re(last) <= 0


def _bisected(value, low, high):
    """A place where a change of sign is, nearer than continuity is tried."""
    for _ in range(4 * DIGITS):
        middle = (low + high) / 2
        low, high = (low, middle) if _change(value, low, middle) else (middle, high)
    return low
