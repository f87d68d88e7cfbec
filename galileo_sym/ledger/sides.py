"""Equivalences tried where one side holds: points at random seldom satisfy an equation."""

from __future__ import annotations

import random
from collections.abc import Iterator

import mpmath
import sympy as sp
from mpmath import mp

from . import numeric
from .check import POINTS, digits, inside, ready_to_try
from .equivalence import ORDERED

STARTS = 3  # for a root, from every point
DIGITS = 260


def where_a_side_holds(statement, derived, declaration, given) -> dict | None:
    """A point where `derived` holds, and one side of an equivalence in `statement`, but not the other."""
    domain = declaration.domain
    (ready, truth), ranges = ready_to_try(sp.Tuple(statement, derived), domain, given)
    if ready.free_symbols - set(ranges):
        return None
    rng = random.Random(declaration.id)
    points = type(domain)(ranges).points(POINTS, declaration.id)
    for system in _systems(ready):
        spoken = set().union(*(e.free_symbols for e in system))
        free = [s for s in ranges if s in spoken and not isinstance(ranges[s], sp.FiniteSet)][-len(system) :]
        for point in points if len(free) == len(system) else ():
            for there in (p for root in _roots(system, free, point, rng) for p in _beside(root, free[-1])):
                if inside(domain.inside, there) and numeric.holds(truth, there) and not numeric.holds(ready, there):
                    return {str(s): digits(v) for s, v in there.items()}
    return None


def _systems(statement) -> Iterator[list]:
    """What vanishes on a side of an equivalence, or where a bound there is reached: lists of expressions."""
    for equivalence in sorted(statement.atoms(sp.Equivalent), key=sp.default_sort_key):
        for side in equivalence.args:
            for case in side.args if isinstance(side, sp.Or) else (side,):
                parts = case.args if isinstance(case, sp.And) else (case,)
                plain = [p for p in parts if isinstance(p, sp.Eq) and not isinstance(p.lhs, sp.Tuple)]
                if plain:
                    yield list(dict.fromkeys(sp.expand(p.lhs - p.rhs) for p in plain))
                yield from ([p.lhs - p.rhs] for p in parts if isinstance(p, ORDERED))


def _beside(point, symbol):
    """A point and some to either side of it: there the truth of a bound changes."""
    for away in map(mpmath.mpf, (0, "1e-9", "-1e-9", "0.3", "-0.3")):
        yield {**point, symbol: point[symbol] + away}


def _roots(system, unknowns, point, rng):
    def residuals(*values):
        here = {**point, **dict(zip(unknowns, values, strict=True))}
        return [numeric.value(e, here, DIGITS) for e in system]

    for _ in range(STARTS):
        start = [mpmath.mpf(rng.uniform(-3, 3)) for _ in unknowns]
        try:
            with mp.workdps(DIGITS):
                found = mp.findroot(residuals, start, tol=mp.mpf(10) ** -400, maxsteps=60, verify=False)
                values = list(found) if isinstance(found, mp.matrix) else [found]
                if max(map(abs, residuals(*values))) < mp.mpf(10) ** -200 and not any(map(mp.im, values)):
                    yield {**point, **dict(zip(unknowns, map(mp.re, values), strict=True))}
        except (ValueError, ZeroDivisionError, TypeError, numeric.Untestable):
            continue
