"""Bounds of analytic functions of u on [-1, 1]: Taylor coefficients as balls, and a proved bound of their tail.

By Cauchy's estimate the coefficient of u^k is at most M/R^k where M bounds the function on the disc |u| <= R, R > 1.
Polynomials are bounded by their Chebyshev coefficients, which is close for the errors of near-minimax approximations.
"""

import math
from dataclasses import dataclass
from functools import cache

from flint import arb, arb_mat, arb_poly, arb_series, ctx

from galileo_sym.verify.proof.approximation_functions import Disc, NotAnalytic

PRECISION = 320  # bits; the division by a series whose zero lies on the unit circle costs a few of them
ORDER = 128  # Taylor coefficients kept
RADII = (6, 4, 3, 2, 1.75)  # of the discs tried; the one that gives the smallest tail is taken


@cache
def _to_chebyshev(size):
    """Matrix that takes the coefficients of a polynomial to those of its Chebyshev expansion; all entries >= 0."""
    table = [[arb(0)] * size for _ in range(size)]
    for k in range(size):
        for j in range(k, -1, -2):
            table[k][j] = arb(math.comb(k, (k - j) // 2)) * arb(2) ** ((1 if j else 0) - k)
    return arb_mat(table)


def chebyshev(coefficients):
    """Chebyshev coefficients of a polynomial on [-1, 1]."""
    size = len(coefficients)
    return (arb_mat([coefficients]) * _to_chebyshev(size)).entries() if size else [arb(0)]


def sum_of_moduli(coefficients):
    """Upper bound of the sum of the absolute values."""
    return sum(map(abs, coefficients), arb(0)).upper()


def largest(polynomial):
    """Upper bound of |polynomial| on [-1, 1]: the sum of its Chebyshev coefficients' absolute values."""
    return sum_of_moduli(chebyshev(polynomial.coeffs()))


def span(polynomial):
    """Lower and upper bound of a polynomial on [-1, 1]: its ends where its slope keeps its sign."""
    slope = chebyshev(polynomial.derivative().coeffs())
    if abs(slope[0]) > sum_of_moduli(slope[1:]):
        ends = polynomial(arb(-1)), polynomial(arb(1))
        return min(end.lower() for end in ends), max(end.upper() for end in ends)
    middle, *others = chebyshev(polynomial.coeffs())
    reach = sum_of_moduli(others)
    return (middle - reach).lower(), (middle + reach).upper()


@dataclass(frozen=True)
class Analytic:
    """A function of u: a polynomial with exact coefficients, and a bound of what it leaves out for |u| <= 1."""

    polynomial: arb_poly
    tail: arb


def analytic(formula, *arguments):
    """Expand formula(*arguments) about u = 0.

    Parameters
    ----------
    formula : callable
        Uses the operations of this module.
    arguments : arb_poly
        Polynomials in u.

    Raises
    ------
    NotAnalytic
        If on no disc of radius above 1 the function is shown to be analytic.
    """
    try:
        series = formula(*(arb_series(argument.coeffs(), ORDER) for argument in arguments))
    except ValueError as cause:  # python-flint's word for a division by what may vanish
        raise NotAnalytic(f"no Taylor series at the centre of the piece: {cause}") from cause
    coefficients = series.coeffs()
    if series.prec < ORDER or not all(c.is_finite() for c in coefficients):
        raise NotAnalytic("a function has no Taylor series at the centre of the piece")
    tails = []
    for radius in RADII:
        try:
            bound = formula(*(Disc(argument, radius) for argument in arguments)).bound()
        except NotAnalytic:
            continue
        if bound.is_finite():
            tails.append((bound * arb(radius) ** -ORDER / (1 - 1 / arb(radius))).upper())
    if not tails:
        raise NotAnalytic("no disc larger than the piece is free of singularities")
    rounding = sum((c.rad() for c in coefficients), arb(0))
    return Analytic(arb_poly([c.mid() for c in coefficients]), (min(tails) + rounding).upper())


def quotient_bound(numerator, denominator):
    """Upper bound of |numerator/denominator| for -1 <= u <= 1; None if the denominator may vanish there.

    Any polynomial q serves: numerator = q * denominator + rest, so the quotient is at most |q| + |rest/denominator|.
    """
    low, high = span(denominator.polynomial)
    least = (low if low > 0 else -high) - denominator.tail
    if not least > 0:
        return None
    r, s = (arb_series(part.polynomial.coeffs(), ORDER) for part in (numerator, denominator))
    q = arb_poly([c.mid() for c in (r / s).coeffs()])
    rest = sum_of_moduli((numerator.polynomial - q * denominator.polynomial).coeffs()) + numerator.tail
    size = largest(q)
    return (size + (rest + size * denominator.tail) / least).upper()


def exact(value):
    """A rational number as the smallest ball."""
    return arb(value.numerator) / value.denominator


def float_above(ball):
    """A double that is no less than any number in a ball."""
    return math.nextafter(float(ball.upper()), math.inf)


def float_below(ball):
    """A double that is no greater than any number in a ball."""
    return math.nextafter(float(ball.lower()), -math.inf)


class precision:  # noqa: N801 (used like contextlib.nullcontext)
    """Context in which the balls of this module have their bits and series their order."""

    def __enter__(self):
        self._saved = ctx.prec, ctx.cap
        ctx.prec, ctx.cap = PRECISION, ORDER

    def __exit__(self, *exception):
        ctx.prec, ctx.cap = self._saved
