"""Inverse trigonometric functions in one form, so that equal angles look alike."""

from __future__ import annotations

import sympy as sp

_ARCS = (sp.asin, sp.acos, sp.atan, sp.acot)


def as_arctangents(expr):
    """Write arcs as arctangents: of each positive x and 1/x, whose arctangents add up to pi/2, the first in order.

    An arcsine or arccosine is left alone unless 1 - x^2 is known to be positive.
    """
    if not expr.has(*_ARCS):
        return expr
    return sp.expand(expr.replace(lambda e: isinstance(e, _ARCS), _arc))


def _arc(arc):
    x = arc.args[0]
    if isinstance(arc, sp.atan):
        return _arctangent(x)
    if isinstance(arc, sp.acot):
        return _arctangent(1 / x) if x.is_nonzero else arc
    rest = sp.factor(1 - x**2)
    if not rest.is_positive:
        return arc
    angle = _arctangent(sp.simplify(x / sp.sqrt(rest)))
    return angle if isinstance(arc, sp.asin) else sp.pi / 2 - angle


def _arctangent(x):
    other = 1 / x
    first = min(x, other, key=sp.default_sort_key)
    if first == x or not (x.is_positive or x.is_negative):
        return sp.atan(x)
    return (sp.pi / 2 if x.is_positive else -sp.pi / 2) - sp.atan(other)
