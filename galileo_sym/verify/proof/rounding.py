"""Bounds of the rounding error of the emitted operations: piece by piece below the end, binade by binade above it."""

from dataclasses import dataclass
from fractions import Fraction

from .binary64 import DIGITS, LARGEST, exponent, grid, power, ulp
from .emitted import RefusedSource
from .expansion import ARGUMENT, Expansion, Symbols
from .pieces import HALF, NEAR, PREFIX, lookup, pieces
from .replay import Replay, Unproved, given

X = ((ARGUMENT, 1),)


@dataclass(frozen=True)
class Rounding:
    """The rounding errors over one range of x, absolute, as exact rationals.

    value: what the operations before the last one have done to the result; last: whether that one rounds, too;
    pair: the error of hi + lo, or of hi where there is no lo; least and largest: bounds of the absolute value of the
    form that is evaluated, without rounding errors; terms: that form, {power of d (of x beyond the end): coefficient}.
    Where the form vanishes with x, on the first piece, all but the terms are divided by x.
    """

    lower: Fraction
    upper: Fraction
    value: Fraction
    last: bool
    pair: Fraction
    least: Fraction
    largest: Fraction
    terms: dict


def _argument(piece, symbols, reach):
    """Return x = centre + d, a double of the piece, and the low part that may come with it."""
    step = ulp(symbols.atoms[ARGUMENT][0] if vanishes(piece) else piece.lower)
    x = given(Expansion.of(piece.centre) + Expansion.argument(), step)
    if vanishes(piece):  # an ulp is at most 2^-52 of x
        return {"x": x, "x_lo": given(Expansion.argument() * symbols.fresh(reach * power(1 - DIGITS)))}
    return {"x": x, "x_lo": given(symbols.fresh(ulp(piece.upper) * reach))}


def _polynomial(coefficients, d):
    """Return the polynomial at an expansion, by Horner's rule."""
    total = Expansion({})
    for coefficient in reversed(coefficients):
        total = total * d + Expansion.of(coefficient)
    return total


def _over(replay, exact, lower, upper, unit=()):
    """Return the bounds of a replay held against the exact form, all divided by a monomial."""
    symbols = replay.symbols
    hi, lo = replay.returned, replay.values.get("lo")
    pair = hi.rounded + lo.rounded if lo else hi.rounded
    return Rounding(
        lower=lower,
        upper=upper,
        value=symbols.largest((hi.exact - exact).over(unit)),
        last=hi.exact.terms != hi.rounded.terms,
        pair=symbols.largest((pair - exact).over(unit)),
        least=symbols.least(exact.over(unit)),
        largest=symbols.largest(exact.over(unit)),
        terms=exact.powers(),
    )


def _exact_rest(piece):
    """Return whether x - centre is exact: by Sterbenz's lemma, or since its grid and its size leave no more digits."""
    step = min(ulp(piece.lower), grid(piece.centre) or piece.upper)
    near_centre = piece.centre / 2 <= piece.lower and piece.upper <= 2 * piece.centre
    return near_centre or not piece.centre or max(abs(piece.d_lower), abs(piece.d_upper)) <= step * 2**DIGITS


def vanishes(piece):
    """Whether a piece begins at a zero of its polynomial, which is at x = 0."""
    return not (piece.lower or piece.centre or piece.coefficients[0])


def on_piece(emitted, function, piece, reach=HALF, tiny=Fraction(0)):
    """Return the bounds on one piece of a function.

    A low part of x has at most `reach` ulps of it. Where the polynomial vanishes at 0, x is no less than `tiny`.

    Raises
    ------
    RefusedSource, Unproved, Overflow
        As `near`.
    """
    symbols = Symbols(tiny if vanishes(piece) else piece.d_lower, piece.d_upper)
    if not _exact_rest(piece):
        raise Unproved(f"{function.name}, piece {piece.index}: x - centre is not proved exact")
    known = _argument(piece, symbols, reach)
    if not set(function.parameters) <= set(known):
        raise RefusedSource(f"{function.name} takes {', '.join(function.parameters)}, where x and x_lo are known")
    parameters = {name: known[name] for name in function.parameters}
    picked = {table: values[piece.index] for table, values in emitted.tables.items() if piece.index < len(values)}
    replay = Replay(function, symbols, parameters, picked, lookup(function)[0])
    argument = Expansion.argument()
    if "x_lo" in parameters:
        argument += parameters["x_lo"].rounded
    exact = _polynomial(piece.coefficients, argument)
    return _over(replay, exact, piece.lower, piece.upper, X if vanishes(piece) else ())


def near(emitted, name, suffix=NEAR):
    """Return the rounding errors on every piece.

    Parameters
    ----------
    emitted : Emitted
    name : str
        Such as "descent_factor".
    suffix : str
        NEAR, or PAIR: the form that takes x + x_lo with abs x_lo <= ulp(x)/2.

    Returns
    -------
    list of Rounding

    Raises
    ------
    RefusedSource, Unproved, Overflow
        If the code is outside the grammar or a side condition is not proved.
    """
    function = emitted.functions[f"{PREFIX}{name}{suffix}"]
    return [on_piece(emitted, function, piece) for piece in pieces(emitted, name, suffix)]


def _binades(first):
    """Return the ranges [lower, upper] of doubles from the first on, each within a binade."""
    ranges, lower = [], first
    while lower < LARGEST:
        upper = min(2 * power(exponent(lower)), LARGEST)
        ranges.append((lower, upper))
        lower = upper
    return ranges


def far(emitted, name, first):
    """Return the rounding errors of the far form on every binade.

    Parameters
    ----------
    emitted : Emitted
    name : str
        The primitive's.
    first : Fraction
        Where the far form begins; it is followed up to the largest double.

    Returns
    -------
    list of Rounding

    Raises
    ------
    RefusedSource, Unproved, Overflow
        As `near`.
    """
    function = emitted.functions[f"{PREFIX}{name}_far"]
    found = []
    for lower, upper in _binades(first):
        symbols = Symbols(lower, upper)
        replay = Replay(function, symbols, {"x": given(Expansion.argument(), ulp(lower))}, {})
        exact = replay.returned.exact.ideal()
        found.append(_over(replay, exact, lower, upper))
    return found
