"""A quick look whether an expression can vanish identically: its value at a few points of its symbols."""

from __future__ import annotations

import random

import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef

from . import numeric

DIGITS = (30, 60)
_NOT_LOOKED_AT = (sp.Limit, sp.Sum, sp.Integral, sp.Subs, sp.Order, sp.Piecewise, sp.Lambda)


def nonzero_somewhere(expr) -> bool:
    """Whether an expression is certainly not 0 for some values that its symbols may have.

    Unknown functions count as symbols. False says nothing: it may be 0, or without a value at the points tried.
    """
    if expr.has(*_NOT_LOOKED_AT):
        return False
    expr = expr.replace(lambda e: isinstance(e, sp.Derivative), lambda e: e.doit())
    if expr.has(sp.Derivative, sp.Subs):  # of unknown functions
        return False
    expr = expr.xreplace({f: _like(f) for f in expr.atoms(AppliedUndef)})
    symbols = sorted(expr.free_symbols, key=lambda s: (s.name, str(s.assumptions0)))
    rng = random.Random(len(symbols))
    for _ in range(2):
        point = {s: _value(s, rng) for s in symbols}
        if None in point.values():
            return False
        try:
            rough, fine = (numeric.value(expr, point, digits) for digits in DIGITS)
        except (ValueError, ZeroDivisionError, TypeError, OverflowError, NameError):
            continue
        if mp.isfinite(fine) and abs(rough - fine) < abs(fine) * mp.mpf(10) ** -10:  # rounding would be another
            return True
    return False


def _like(function):
    signs = {name: True for name in ("positive", "nonnegative", "negative") if getattr(function, f"is_{name}")}
    return sp.Dummy("value", real=True, **signs)


def _value(symbol, rng):
    """A value as the symbol's assumptions have it; None for symbols of other kinds."""
    if symbol.is_integer:
        return sp.Integer(rng.randint(3, 7)) if not symbol.is_nonpositive else None
    if symbol.is_real is False or symbol.is_zero:
        return None
    size = sp.Rational(rng.randint(200, 1900), 1000)
    return -size if symbol.is_nonpositive else size
