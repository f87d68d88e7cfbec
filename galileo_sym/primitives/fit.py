"""Piecewise polynomials for a smooth function of x >= 0, on a grid that is uniform within each binade of 1 + x.

On a piece with centre c the function is c0 + d (c1 + d (c2 + ...)), d = x - c, with c0 and c1 as pairs of doubles: only
terms below 2**-8 of the result are rounded to doubles, and the result is an unevaluated sum hi + lo.
"""

from math import frexp, ldexp

from mpmath import mp, mpf

from galileo_sym.primitives.pieces import Piece

PER_BINADE = 16
_DIGITS = 45
_CHECKS = 7


def pieces_up_to(x_max):
    """Return how many pieces cover [0, x_max]; x_max must be the end of one."""
    mantissa, exponent = frexp(1 + x_max)
    count = (exponent - 1) * PER_BINADE + (mantissa - 0.5) * 2 * PER_BINADE
    if count != int(count) or ldexp(mantissa, exponent) - 1 != x_max:
        raise ValueError(f"x_max = {x_max} is not the end of a piece: 1 + x_max must be 2**i (1 + j/{PER_BINADE})")
    return int(count)


def piece_bounds(index):
    """Return (lower, upper, centre) of a piece; the first is anchored at 0, where the value is exact."""
    binade, step = divmod(index, PER_BINADE)
    lower, upper = (ldexp(1 + s / PER_BINADE, binade) - 1 for s in (step, step + 1))
    return lower, upper, 0.0 if index == 0 else (lower + upper) / 2


def _difference_quotient(function, lower, upper, centre, nodes):
    """Powers of d = x - centre in the interpolant of (f(x) - f(centre))/d at Chebyshev nodes."""
    half, middle = (mpf(upper) - lower) / 2, (mpf(upper) + lower) / 2
    anchor = function(mpf(centre))
    points = [middle + half * mp.cos(mp.pi * (2 * j + 1) / (2 * nodes)) - centre for j in range(nodes)]
    points = [d if abs(d) > mp.eps ** (mpf(1) / 3) else half / 64 for d in points]
    slopes = [(function(centre + d) - anchor) / d for d in points]
    for level in range(1, nodes):  # Newton's divided differences
        for j in range(nodes - 1, level - 1, -1):
            slopes[j] = (slopes[j] - slopes[j - 1]) / (points[j] - points[j - level])
    coefficients = [mpf(0)] * nodes
    for j in range(nodes - 1, -1, -1):  # Horner, from the Newton form to powers of d
        coefficients = [slopes[j] - points[j] * coefficients[0]] + [
            coefficients[i - 1] - points[j] * coefficients[i] for i in range(1, nodes)
        ]
    return anchor, coefficients


def _pair(value):
    head = float(value)
    return head, float(value - mpf(head))


def polynomial(coefficients, d):
    """The value of a piece at a distance d from its centre, by its coefficients, to the working precision."""
    tail = mpf(0)
    for c in reversed(coefficients[4:]):
        tail = tail * d + c
    tail = tail * d + coefficients[3] + coefficients[2]
    return tail * d + coefficients[1] + coefficients[0]


def fit_piece(function, index, degree):
    """Fit one piece.

    Parameters
    ----------
    function : callable
        From mpf to mpf, accurate to the working precision.
    index : int
        The piece, counted from x = 0.
    degree : int
        Of the polynomial in d.

    Returns
    -------
    Piece
        With the coefficients rounded to doubles and the error measured on these, between the nodes and at the ends.
    """
    with mp.workdps(_DIGITS):
        lower, upper, centre = piece_bounds(index)
        anchor, exact = _difference_quotient(function, lower, upper, centre, degree)
        coefficients = (*_pair(anchor), *_pair(exact[0]), *(float(c) for c in exact[1:]))
        worst = mpf(0)
        for j in range(_CHECKS + 1):
            x = lower + (mpf(upper) - lower) * j / _CHECKS
            value = function(x)
            missed = abs(polynomial(coefficients, x - centre) - value)
            worst = max(worst, missed / abs(value) if value else missed)
        return Piece(centre, coefficients, float(worst))


def fit(function, x_max, degree, tolerance):
    """Fit all pieces on [0, x_max].

    Raises
    ------
    ArithmeticError
        If a piece errs by more than the tolerance: the degree is too low.
    """
    pieces = tuple(fit_piece(function, index, degree) for index in range(pieces_up_to(x_max)))
    worst = max(range(len(pieces)), key=lambda i: pieces[i].error)
    if pieces[worst].error > tolerance:
        raise ArithmeticError(
            f"piece {worst} errs by {pieces[worst].error:.2e}, more than {tolerance:.2e}: raise the degree {degree}"
        )
    return pieces
