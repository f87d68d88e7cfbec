"""Both halves joined: how many ulps a result can be wrong, piece by piece, and a pair relative to the value."""

from dataclasses import dataclass
from fractions import Fraction

from . import rounding
from .approximation import piece_bounds
from .approximation_far import FAR_FORMS, far_bound
from .binary64 import DIGITS, power, ulp
from .dispatch import primitives
from .emitted import RefusedSource
from .pieces import NEAR, PAIR, pieces

_FAR = "_far"


@dataclass(frozen=True)
class Proved:
    """What is proved of one piece of one function, or of a far form; upper bounds, exact rationals.

    piece is None for a far form. approximation is relative; rounding is in ulps, the last operation's half an ulp left
    out; total is the error of the result in ulps of the true value; pair that of hi + lo, relative.
    """

    function: str
    piece: object
    lower: Fraction
    upper: Fraction
    approximation: Fraction
    rounding: Fraction
    total: Fraction
    pair: Fraction


def _joined(function, piece, approximation, found, least):
    """Return the bounds of one range from those of its halves.

    With v the sum of hi before its rounding, f the value and abs(v - f) <= e <= ulp(f)/2, RN(v) is within ulp(f)/2 + e
    of f: in the binade of f it is within half an ulp of v, below it within less; and where v lies beyond the next power
    of two by some s <= e, RN(v) is no farther from v than that power is, so within s + e <= 2 e of f.
    """
    unit = ulp(max(least, found.least / (1 + approximation)))
    # ulp(f) > abs(f) 2^-53, and no less than that of the least f
    missed = approximation * min(power(DIGITS), found.largest / (1 - approximation) / unit)
    total = found.value / unit + missed + Fraction(found.last, 2)
    pair = (found.pair / found.least) * (1 + approximation) + approximation
    return Proved(function, piece, found.lower, found.upper, approximation, found.value / unit, total, pair)


def _near(emitted, name, bank):
    """Return the bounds of both functions of a bank."""
    polynomials = pieces(emitted, bank, NEAR)
    if pieces(emitted, bank, PAIR) != polynomials:
        raise RefusedSource(f"gs_{bank}{PAIR} does not stand on the pieces of gs_{bank}{NEAR}")
    half = piece_bounds(name, polynomials)
    return [
        _joined(f"gs_{bank}{suffix}", b.piece, Fraction(b.relative), found, Fraction(b.smallest))
        for suffix in (NEAR, PAIR)
        for b, found in zip(half, rounding.near(emitted, bank, suffix), strict=True)
    ]


def _far(emitted, name, first):
    """Return the worst of every bound over the binades of the far form, as one range."""
    approximation = Fraction(far_bound(name, first))
    rows = []
    for found in rounding.far(emitted, name, first):
        if found.terms != FAR_FORMS[name].terms:
            raise RefusedSource(f"gs_{name}_far is {found.terms}, which is not the form that was bounded")
        rows.append(_joined(f"gs_{name}{_FAR}", None, approximation, found, Fraction(0)))
    worst = (max(getattr(row, part) for row in rows) for part in ("rounding", "total", "pair"))
    return Proved(rows[0].function, None, first, rows[-1].upper, approximation, *worst)


def prove(emitted, name):
    """Prove the bounds of one primitive.

    Parameters
    ----------
    emitted : Emitted
        The parsed C.
    name : str
        Such as "flight_factor".

    Returns
    -------
    list of Proved
        Every piece of every function that serves it, the far form last.

    Raises
    ------
    RefusedSource, Unproved, Overflow
        If the C is outside the grammar, or a bound or a side condition cannot be proved.
    """
    served = primitives(emitted)[name]
    rows = [row for bank in served.banks for row in _near(emitted, name, bank.name)]
    return [*rows, _far(emitted, name, served.far_from)]
