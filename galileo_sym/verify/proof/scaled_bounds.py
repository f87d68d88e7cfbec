"""Both halves for the tables of the scaled layer: the error of the pair hi + lo that gs_lookup returns, relative."""

from dataclasses import dataclass, replace
from fractions import Fraction

from .approximation import Unproved, piece_bound
from .approximation_calculus import precision
from .approximation_functions import NotAnalytic
from .binary64 import DIGITS, ulp
from .emitted import Call, Name, RefusedSource
from .expansion import Expansion, Symbols
from .replay import Replay, given
from .scaled_curves import curve_bound
from .scaled_equations import DEFINITIONS, Curve


@dataclass(frozen=True)
class TableBound:
    """What is proved of one piece of a table: upper bounds, exact rationals.

    approximation and rounding are relative to the value; where that is 0 at the piece's end (unit is "1"), rounding is
    absolute. pair is that of hi + lo, both halves joined.
    """

    table: str
    piece: int
    lower: Fraction
    upper: Fraction
    approximation: Fraction
    rounding: Fraction
    pair: Fraction
    unit: str


NEAR_ZERO = Fraction(1, 2**20)
_DIFFERENCE = Call("gs_sub", (Name("x"), Call("gs_pick", (Name("row0"), Name("i")))))
DISTANCE = (
    ("d.a", _DIFFERENCE),
    ("d.b", Name("x_lo")),
    ("d.hi", Call("gs_add", (Name("d.a"), Name("d.b")))),
    ("d.lo", Call("gs_sum_rest", (Name("d.a"), Name("d.b"), Name("d.hi")))),
)


def _value(coefficients, d):
    total = Expansion({})
    for coefficient in reversed(coefficients):
        total = total * d + Expansion.of(coefficient)
    return total


class _NearZero(Replay):
    """Where a value may vanish, gs_rest may be inexact: it is then within a few roundings of a + b - s."""

    def unordered_rest(self, a, b, s, _sizes):
        """Wrong by 2^-53 (abs(s - a) + abs(b - (s - a))) at most, neither of which is above 3 (abs a + abs b)."""
        exact = a.rounded + b.rounded - s.rounded
        size = self.symbols.largest(a.rounded) + self.symbols.largest(b.rounded)
        return given(exact + self.symbols.fresh(8 * size / 2**DIGITS))


def _ranges(piece):
    """Return (replay, lower, upper) of d: in one range, or binade by binade where the polynomial vanishes at 0."""
    slack = ulp(1 + piece.upper)
    lower, upper = piece.d_lower - slack, piece.d_upper + slack
    if piece.coefficients[0] or piece.centre:
        return [(Replay, lower, upper)]
    ranges, begin = [(_NearZero, lower, NEAR_ZERO)], NEAR_ZERO
    while begin < upper:
        ranges.append((Replay, begin, min(2 * begin, upper)))
        begin *= 2
    return ranges


def _rounding(lookup, piece, row):
    """Return bounds of the rounding error, of the value from below and from above, all absolute.

    The argument of the expansions is d.hi, and d.lo what its rounding left: their sum is x + x_lo - centre.
    """
    tables = {f"row{k}": v for k, v in enumerate(row)}
    _require_exact_distance(lookup, piece, tables)
    rest, found = replace(lookup, statements=lookup.statements[len(DISTANCE) :]), []
    for kind, lower, upper in _ranges(piece):
        symbols = Symbols(lower, upper)
        d, d_lo = given(Expansion.argument()), given(symbols.fresh(ulp(max(-lower, upper)) / 2))
        replay = kind(rest, symbols, {"d.hi": d, "d.lo": d_lo}, tables, "i")
        returned = replay.returned.rounded + replay.values["lo"].rounded
        true = _value(piece.coefficients, Expansion.argument() + d_lo.rounded)
        found.append((symbols.largest(returned - true), symbols.least(true), symbols.largest(true)))
    errors, least, largest = zip(*found, strict=True)
    return max(errors), min(least), max(largest)


def _require_exact_distance(lookup, piece, tables):
    """Hold the first statements of gs_lookup against (d.hi, d.lo) = gs_two_sum(x - row[0], x_lo), x - row[0] exact."""
    if lookup.statements[: len(DISTANCE)] != DISTANCE:
        raise RefusedSource("gs_lookup does not begin with the distance of x + x_lo from the centre as a pair")
    symbols = Symbols(piece.d_lower, piece.d_upper)
    x = given(Expansion.of(piece.centre) + Expansion.argument(), ulp(max(piece.lower, Fraction(0))))
    first = replace(lookup, statements=DISTANCE[:1], returned=Name("d.a"))
    difference = Replay(first, symbols, {"x": x}, tables, "i").returned
    if difference.rounded.terms != Expansion.argument().terms:
        raise Unproved(f"piece {piece.index}: x - centre is not proved exact")


def _approximation(definition, piece):
    try:
        bound = curve_bound(definition, piece) if isinstance(definition, Curve) else piece_bound(definition, piece)
    except (Unproved, NotAnalytic) as cause:
        raise Unproved(f"piece {piece.index}: {cause}") from cause
    return Fraction(bound.relative)


def table_bounds(lookup, table):
    """Prove the bounds of one table.

    Parameters
    ----------
    lookup : Function
        gs_lookup, lowered.
    table : ScaledTable

    Returns
    -------
    list of TableBound
        One a piece, for x + x_lo in it, x a double and x_lo no more than half an ulp of 1 + x.

    Raises
    ------
    RefusedSource, Unproved, Overflow
        If the C is outside the grammar, or a bound or a side condition cannot be proved.
    """
    if table.name not in DEFINITIONS:
        raise Unproved(f"the table {table.name} has no definition in scaled_equations.py")
    definition, rows = DEFINITIONS[table.name], []
    with precision():
        for piece, row in table.pieces:
            approximation = _approximation(definition, piece)
            rounding, least, largest = _rounding(lookup, piece, row)
            if least:
                rounding /= least
                pair, unit = approximation + rounding * (1 + approximation), "f"
            else:
                pair, unit = rounding + approximation * largest / (1 - approximation), "1"
            rows.append(
                TableBound(table.name, piece.index, piece.lower, piece.upper, approximation, rounding, pair, unit)
            )
    return rows
