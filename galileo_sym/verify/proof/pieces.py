"""The pieces of a bank: which arguments come to each, its centre and its polynomial, all from the emitted C."""

from dataclasses import dataclass
from fractions import Fraction
from itertools import count

from .binary64 import RN, before, double_of_bits, ulp
from .dispatch import bank
from .emitted import Call, Name, Number, RefusedSource

NEAR, PAIR = "_near", "_near_pair"
PREFIX = "gs_"
HALF = Fraction(1, 2)


@dataclass(frozen=True)
class Piece:
    """One piece.

    Every x >= 0 that the emitted code looks up here lies in [lower, upper], and so does x + x_lo, x_lo within reach.
    The polynomial is the sum of coefficients[k] d^k, d = x - centre; coefficients[0] is the exact c0 + c0_lo.
    """

    index: int
    lower: Fraction
    upper: Fraction
    centre: Fraction
    coefficients: tuple

    @property
    def d_lower(self):
        """Least value of d."""
        return self.lower - self.centre

    @property
    def d_upper(self):
        """Greatest value of d."""
        return self.upper - self.centre


def _is(expression, operation, *arguments):
    """Return whether an expression is this operation, of these arguments where they are not None."""
    return (
        isinstance(expression, Call)
        and expression.operation == operation
        and all(want is None or want == found for want, found in zip(arguments, expression.arguments, strict=True))
    )


def lookup(function):
    """How a function finds its piece: gs_piece(u, first, drop), u = gs_add(x, gs_v_of(offset)).

    Returns
    -------
    tuple
        The name of the index, offset, first, drop.

    Raises
    ------
    RefusedSource
        If there is not exactly one look-up of that form.
    """
    found = [(name, e) for name, e in function.statements if _is(e, "gs_piece", None, None, None)]
    if len(found) == 1:
        name, (shifted, first, drop) = found[0][0], found[0][1].arguments
        if isinstance(shifted, Name):
            shifted = dict(function.statements).get(shifted.name)
        if _is(shifted, "gs_add", Name("x"), None) and _is(shifted.arguments[1], "gs_v_of", None):
            offset = shifted.arguments[1].arguments[0]
            if all(isinstance(constant, Number) for constant in (offset, first, drop)):
                return name, offset.value, int(first.value), int(drop.value)
    raise RefusedSource(f"{function.name}: no look-up gs_piece(u, first, drop) of u = gs_add(x, gs_v_of(offset))")


def centre_table(function):
    """Return the table of the centres: of the one gs_sub(x, gs_pick(table, index)).

    Raises
    ------
    RefusedSource
        If there is not exactly one such subtraction.
    """
    index = Name(lookup(function)[0])
    tables = [
        e.arguments[1].arguments[0].name
        for _, e in function.statements
        if _is(e, "gs_sub", Name("x"), None) and _is(e.arguments[1], "gs_pick", None, index)
    ]
    if len(tables) != 1:
        raise RefusedSource(f"{function.name}: {len(tables)} subtractions of a centre from x")
    return tables[0]


def require_served(function, size, begin, last):
    """Refuse a function if an argument from begin to the last is looked up outside its pieces."""
    _, offset, first, drop = lookup(function)
    bounds = [double_of_bits((first + i) << drop) for i in (0, size)]
    if offset < 0 or RN(begin + offset) < bounds[0] or RN(last + offset) >= bounds[-1]:
        raise RefusedSource(f"{function.name}: an x that it serves is looked up outside its {size} pieces")


def _intervals(function, size, reach):
    """Return the bounds of every piece, widened by what the rounding of x + offset and a low part of x may do."""
    _, offset, first, drop = lookup(function)
    bounds = [double_of_bits((first + i) << drop) for i in range(size + 1)]
    # RN(x + offset) >= v means x + offset >= v - ulp/2, and an ulp of x is no larger;
    # RN(x + offset) < w means x + offset <= w - ulp/2 of the double before w
    lower = [max(Fraction(0), v - offset - (HALF + reach) * ulp(v)) for v in bounds[:-1]]
    return list(zip(lower, (w - offset + (reach - HALF) * ulp(w) for w in bounds[1:]), strict=True))


def _polynomials(emitted, name, size):
    """Return the coefficients of every piece, high and low parts added."""
    stem = f"{PREFIX}{name}_c"
    columns = []
    for k in count():
        if f"{stem}{k}" not in emitted.tables:
            break
        low = emitted.tables.get(f"{stem}{k}_lo", (Fraction(0),) * size)
        columns.append([a + b for a, b in zip(emitted.tables[f"{stem}{k}"], low, strict=True)])
    return list(zip(*columns, strict=True))


def pieces(emitted, name, suffix=NEAR, served=None, reach=HALF):
    """Return the pieces of a bank.

    Parameters
    ----------
    emitted : Emitted
    name : str
        The bank's, such as "phi2m_tail".
    suffix : str
        NEAR or PAIR: which function's look-up is read.
    served : Bank, optional
        What it serves; by default what the functions that choose say.
    reach : Fraction
        How many ulps of x a low part may have at most.

    Returns
    -------
    list of Piece

    Raises
    ------
    RefusedSource
        If the function looks its piece up in another way, or a table is missing.
    """
    function = emitted.functions[f"{PREFIX}{name}{suffix}"]
    centres = emitted.tables[centre_table(function)]
    served = served or bank(emitted, name)
    require_served(function, len(centres), served.begin, before(served.end))
    intervals, polynomials = _intervals(function, len(centres), reach), _polynomials(emitted, name, len(centres))
    if not polynomials:
        raise RefusedSource(f"{name} has no table of coefficients {PREFIX}{name}_c0")
    rows = zip(intervals, centres, polynomials, strict=True)
    return [Piece(i, *interval, centre, polynomial) for i, (interval, centre, polynomial) in enumerate(rows)]
