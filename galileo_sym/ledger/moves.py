"""A point where one statement holds and another does not, found by moving a quantity off its true value."""

from __future__ import annotations

import random

import mpmath
import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef

from . import numeric
from .check import POINTS, digits, ready_to_try

STARTS = 6  # starting values for the search of a root of the other statement


def moved_apart(holding, failing, declaration, given, pinned=frozenset()) -> dict | None:
    """A point where `holding` holds and `failing` fails, one dependent quantity of `failing` having been moved.

    Parameters
    ----------
    given : dict
        What dependent quantities stand for.
    pinned : set of expr
        Quantities that must keep their value.
    """
    for quantity in sorted(_dependent(failing, declaration.domain, given) - pinned, key=str):
        found = _move(quantity, holding, failing, declaration, given)
        if found is not None:
            return found
    return None


def _dependent(statement, domain, given):
    """Symbols, f(t) and derivatives that a statement speaks of, and that are not independent variables."""
    kinds = sp.Symbol | AppliedUndef | sp.Derivative
    spoken = (e for e in sp.preorder_traversal(statement) if isinstance(e, kinds))
    return {e for e in spoken if e in given and e not in domain.ranges}


def _move(quantity, holding, failing, declaration, given):
    domain, seed = declaration.domain, declaration.id
    within = declaration.notation.ranges.get(quantity, sp.S.Reals)
    symbol = _as_symbol(quantity)
    statements = [statement.xreplace({quantity: symbol}) for statement in (holding, failing)]
    if any(_speaks_of(quantity, statement) for statement in statements):
        return None  # f(t) does not move without its derivatives
    known = {k: v for k, v in given.items() if k != quantity}
    (loose_holding, loose_failing), ranges = ready_to_try(sp.Tuple(*statements), domain, known)
    if symbol not in loose_failing.free_symbols:
        return None
    place, _ = ready_to_try(sp.Eq(symbol, given[quantity], evaluate=False), domain, known)
    rng = random.Random(seed)
    for point in type(domain)(ranges).points(POINTS // 2, seed):
        try:
            here = numeric.value(place.rhs, point, 60)
        except ZeroDivisionError:
            continue
        except numeric.Untestable:  # it depends on an unknown function: any value will do to start from
            here = mpmath.mpf(1)
        for guess in _roots(loose_holding, symbol, point, here, rng):
            if not _allowed(symbol, guess, within):
                continue
            moved = {**point, symbol: guess}
            if numeric.holds(loose_holding, moved) and not numeric.holds(loose_failing, moved):
                return {str(quantity if s == symbol else s): digits(v) for s, v in moved.items()}
    return None


def _as_symbol(quantity):
    """A symbol of the same sign, to be moved in the place of f(t) or a derivative."""
    if isinstance(quantity, sp.Symbol):
        return quantity
    signs = {name: True for name in ("positive", "nonnegative") if getattr(quantity, f"is_{name}")}
    return sp.Dummy("moved", real=True, **signs)


def _speaks_of(quantity, statement):
    """Whether the unknown function of a quantity is left in a statement."""
    functions = {f.func for f in quantity.atoms(AppliedUndef)}
    return any(f.func in functions for f in statement.atoms(AppliedUndef))


def _roots(statement, symbol, point, near, rng):
    """Values of `symbol` that may satisfy a statement: roots of an equation near and far, for others any beside."""
    plain = isinstance(statement, sp.Eq) and not isinstance(statement.lhs, sp.Tuple)
    if symbol not in statement.free_symbols or not plain:
        beside = (near + mpmath.mpf(1) / 3, 2 * near, near / 2, near - mpmath.mpf(1) / 3, -near)
        return list(beside)
    found = []
    for _ in range(STARTS):
        start = near * mpmath.mpf(rng.uniform(-3, 3)) + mpmath.mpf(rng.uniform(-1, 1))
        root = _newton(statement.lhs - statement.rhs, symbol, point, start)
        if root is not None:
            found.append(root)
    return found


def _newton(expr, symbol, point, start):
    def f(x):
        return numeric.value(expr, {**point, symbol: x}, 260)

    try:
        with mp.workdps(260):
            root = mp.findroot(f, start, tol=mp.mpf(10) ** -480, maxsteps=60, verify=False)
            good = mp.isfinite(root) and abs(mp.im(root)) == 0 and abs(f(root)) < mp.mpf(10) ** -200
            return mp.re(root) if good else None
    except (ValueError, ZeroDivisionError, TypeError, numeric.Untestable):
        return None


def _allowed(symbol, value, within):
    """Whether a value is one that the quantity can have: of its sign, and in its range in the notation."""
    if (symbol.is_positive and value <= 0) or (symbol.is_nonnegative and value < 0):
        return False
    return within is sp.S.Reals or float(within.start) < value < float(within.end)
