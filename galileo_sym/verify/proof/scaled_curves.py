"""Approximation bounds of tables whose function is a curve x(s), f(s): the polynomial at x(s) against f(s), s followed.

Each x of a piece is x(s) for some s between two numbers at which x(s) is proved to lie on either side of the piece.
"""

from flint import arb, arb_poly, arb_series

from .approximation import DEPTH, Bound, Unproved
from .approximation_calculus import analytic, exact, float_above, float_below, quotient_bound, span
from .approximation_functions import NotAnalytic

_BISECTIONS = 160
_MARGIN = arb(2) ** -80


def _at(function, s):
    """The value of a formula of the calculus at one number."""
    return function(arb_series([s], 1))[0]


def _ends(argument, lower, upper):
    """Return two parameters, the piece between their arguments."""
    found = []
    for x, outward in ((lower, -1), (upper, 1)):
        low, high = arb(-1), arb(2)
        while _at(argument, high) < x:
            high *= 2
        for _ in range(_BISECTIONS):
            middle = ((low + high) / 2).mid()
            low, high = (low, middle) if _at(argument, middle) > x else (middle, high)
        found.append((low + outward * _MARGIN * (1 + abs(low))).mid())
    if not (_at(argument, found[0]) < lower and _at(argument, found[1]) > upper):
        raise Unproved("the parameters at the ends of the piece are not separated from it")
    return found


def _horner(coefficients, d):
    last, *others = (exact(c) for c in reversed(coefficients))
    total = last
    for coefficient in others:
        total = d * total + coefficient
    return total


def _part(curve, low, high, piece, depth=0):
    """Bound of |P/f - 1| and bounds of f for low <= s <= high; by halves where that helps."""
    s = arb_poly([(low + high) / 2, (high - low) / 2])
    try:
        value = analytic(curve.value, s)
        missed = analytic(
            lambda s: _horner(piece.coefficients, curve.argument(s) - exact(piece.centre)) - curve.value(s), s
        )
    except NotAnalytic:
        if depth == DEPTH:
            raise
        middle = ((low + high) / 2).mid()
        parts = [_part(curve, *ends, piece, depth + 1) for ends in ((low, middle), (middle, high))]
        relatives, smallest, largest = zip(*parts, strict=True)
        return max(relatives), min(smallest), max(largest)
    relative = quotient_bound(missed, value)
    if relative is None:
        raise Unproved("the function may vanish")
    smallest, largest = span(value.polynomial)
    return relative, (smallest - value.tail).lower(), (largest + value.tail).upper()


def curve_bound(curve, piece):
    """Bound the approximation error of one piece; within the calculus' precision.

    Parameters
    ----------
    curve : Curve
    piece : Piece

    Returns
    -------
    Bound

    Raises
    ------
    Unproved, NotAnalytic
        If no bound can be proved.
    """
    low, high = _ends(curve.argument, exact(piece.lower), exact(piece.upper))
    relative, smallest, largest = _part(curve, low, high, piece)
    return Bound(
        piece.index,
        float_below(exact(piece.lower)),
        float_above(exact(piece.upper)),
        float_above(relative),
        float_below(smallest),
        float_above(largest),
    )
