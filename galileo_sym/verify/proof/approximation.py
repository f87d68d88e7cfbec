"""Proved bounds of the approximation error: how far each piece's exact polynomial is from the primitive.

The polynomial P is put into the primitive's equation. For the true value f and some F between f and P the mean value
theorem says log(P/f) = residual(P)/slope(F), slope being that with respect to log F. The quotient is bounded by ball
arithmetic for every x of the piece and every F within a factor exp(+-2^-40) of P; if the bound is less than 2^-40, the
residual has exactly one root there, which is f. The polynomial is exact: rounding errors are the other half.
"""

from dataclasses import dataclass, replace

from flint import arb, arb_poly

from galileo_sym.verify.proof.approximation_calculus import (
    analytic,
    exact,
    float_above,
    float_below,
    precision,
    quotient_bound,
    span,
)
from galileo_sym.verify.proof.approximation_equations import EQUATIONS
from galileo_sym.verify.proof.approximation_functions import NotAnalytic
from galileo_sym.verify.proof.pieces import pieces

NEIGHBOURHOOD = 2.0**-40
DEPTH = 4  # halvings of a piece on which a function is not shown to be analytic


class Unproved(ArithmeticError):
    """No bound could be proved; the message says for which piece and why."""


@dataclass(frozen=True)
class Bound:
    """What is proved of one piece.

    Attributes
    ----------
    piece : int
        Its number.
    low, high : float
        The x it holds for (rounded outward).
    relative : float
        Upper bound of |P/f - 1|.
    smallest, largest : float
        Bounds of the primitive's value f.
    """

    piece: int
    low: float
    high: float
    relative: float
    smallest: float
    largest: float


def _on_the_unit_interval(lower, upper, piece):
    """x and P as polynomials in u, which runs from -1 to 1 while x goes from lower to upper."""
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    d = arb_poly([exact(middle - piece.centre), exact(half)])
    return arb_poly([exact(middle), exact(half)]), arb_poly([exact(c) for c in piece.coefficients])(d)


def _relative_error(equation, x, P):
    """Upper bound of |P/f - 1|."""
    near = P * (1 + arb(0, 2 * NEIGHBOURHOOD))
    residual = analytic(lambda x, f: equation.terms(x, f)[0], x, P)
    slope = analytic(lambda x, f: equation.terms(x, f)[1], x, near)
    bound = quotient_bound(residual, slope)
    if bound is None:
        raise Unproved("the slope of the equation may vanish: the root is not shown to be unique")
    if not bound < NEIGHBOURHOOD:
        raise Unproved(f"a bound of {float(bound):.3g}, where less than {NEIGHBOURHOOD:.3g} is needed")
    return (bound.exp() - 1).upper()


def _part(equation, lower, upper, piece, depth=0):
    """Bound of |P/f - 1| and a lower and an upper bound of f for lower <= x <= upper; by halves where that helps."""
    x, P = _on_the_unit_interval(lower, upper, piece)
    low, high = span(P)
    if not low > 0 or not (equation.below is None or high < equation.below):
        raise Unproved("the polynomial leaves the interval in which the root is unique")
    try:
        relative = _relative_error(equation, x, P)
    except NotAnalytic:
        if depth == DEPTH:
            raise
        middle = (lower + upper) / 2
        parts = [_part(equation, *ends, piece, depth + 1) for ends in ((lower, middle), (middle, upper))]
        relatives, lows, highs = zip(*parts, strict=True)
        return max(relatives), min(lows), max(highs)
    return relative, (low / (1 + relative)).lower(), (high / (1 - relative)).upper()


def _part_over_x(equation, piece):
    """The same for a piece on which x and f begin with 0, by the quotient of f and x."""
    first, *others = piece.coefficients
    if piece.centre or first:
        raise Unproved("the polynomial is not 0 where the primitive is")
    quotient = replace(piece, coefficients=tuple(others))
    relative, _, largest = _part(replace(equation, terms=equation.over_x), piece.lower, piece.upper, quotient)
    return relative, arb(0), largest * exact(piece.upper)


def piece_bound(equation, piece):
    if equation.over_x and piece.lower <= 0:
        relative, smallest, largest = _part_over_x(equation, piece)
    else:
        relative, smallest, largest = _part(equation, piece.lower, piece.upper, piece)
    return Bound(
        piece.index,
        float_below(exact(piece.lower)) if piece.lower else 0.0,
        float_above(exact(piece.upper)),
        float_above(relative),
        max(float_below(smallest), float(equation.least)),
        float_above(largest),
    )


def piece_bounds(name, polynomials):
    """Bound the approximation error of some pieces of a primitive.

    Parameters
    ----------
    name : str
        The primitive, one of `EQUATIONS`.
    polynomials : iterable of Piece

    Returns
    -------
    list of Bound

    Raises
    ------
    Unproved
        If the primitive has no equation here, or if for some piece no bound below 2^-40 can be proved.
    """
    if name not in EQUATIONS:
        raise Unproved(f"{name} has no equation in approximation_equations.py")
    found = []
    with precision():
        for piece in polynomials:
            try:
                found.append(piece_bound(EQUATIONS[name], piece))
            except (Unproved, NotAnalytic) as cause:
                raise Unproved(f"{name}, piece {piece.index}: {cause}") from cause
    return found


def approximation_bound(name, emitted, bank=None):
    """Bound the approximation error of every piece of an emitted primitive; as `piece_bounds`.

    Parameters
    ----------
    name : str
        The primitive, which says what is approximated.
    emitted : Emitted
        The parsed C file.
    bank : str, optional
        Whose tables are judged: gs_<bank>_near; by default those of the primitive's own name.
    """
    return piece_bounds(name, pieces(emitted, bank or name))
