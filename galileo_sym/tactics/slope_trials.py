"""A slope is tried at exact points before a function is called monotone."""

from __future__ import annotations

from itertools import cycle, pairwise

import sympy as sp
from sympy.core.function import AppliedUndef

from galileo_sym.ledger import DerivationError
from galileo_sym.ledger.numeric import Untestable, sign
from galileo_sym.ledger.predicates import spread

_SIZES = [sp.Rational(*pair) for pair in ((7, 5), (31, 40), (23, 9), (3, 11))]  # of the other symbols


def require_slope(function, variable, interval, slope_sign: int) -> None:
    """Raise if a slope is seen to have the other sign inside an interval, or to be 0 throughout.

    The slope of a polynomial with known coefficients is decided between its roots; another function is tried at
    points spread over the interval. Functions with other symbols are tried if each of those has a sign; unknown
    functions are for the derivation to see to.
    """
    values = _values((function.free_symbols | interval.free_symbols) - {variable})
    if values is None or function.has(AppliedUndef, sp.Derivative):
        return
    slope, within = sp.diff(function, variable), _inside(interval, values)
    if within is None:
        return
    if slope == 0:
        raise DerivationError(f"{function} does not change with {variable}")
    for place in (*_between_roots(slope.subs(values), variable, within), *spread(within)):
        if _sign_at(slope, {**values, variable: place}) == -slope_sign:
            raise DerivationError(f"the slope of {function} has the sign {-slope_sign} at {variable} = {place}")


def _values(symbols):
    """Values for symbols; None if one has no sign that tells what values it may take."""
    if not all(s.is_positive or s.is_negative for s in symbols):
        return None
    named = zip(sorted(symbols, key=str), cycle(_SIZES))
    return {s: size if s.is_positive else -size for s, size in named}


def _inside(interval, values):
    """The open interval with values put in; None if they leave nothing of it, or make an end complex."""
    try:
        now = interval.subs(values)
    except ValueError:
        return None
    if not isinstance(now, sp.Interval):
        return None
    width = now.end - now.start
    return sp.Interval.open(now.start, now.end) if width.is_infinite or _sign_at(width, {}) > 0 else None


def _between_roots(slope, variable, interval):
    """A point of each part of the interval where a polynomial slope keeps one sign."""
    if not slope.is_polynomial(variable):
        return []
    polynomial = sp.Poly(slope, variable)
    if polynomial.domain not in (sp.ZZ, sp.QQ):
        return []
    roots = [root for root in sorted(set(polynomial.real_roots())) if interval.contains(root) == sp.true]
    return [_between(low, high) for low, high in pairwise([interval.start, *roots, interval.end])]


def _between(low, high):
    if low.is_finite and high.is_finite:
        return (low + high) / 2
    return low + 1 if low.is_finite else high - 1 if high.is_finite else sp.S.Zero


def _sign_at(slope, point):
    """The sign of the slope, 0 where it has no value."""
    try:
        return sign(slope, point)
    except (Untestable, ZeroDivisionError, ValueError, OverflowError):
        return 0
