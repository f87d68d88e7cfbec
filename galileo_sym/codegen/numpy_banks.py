"""Approximations for NumPy: how finely their pieces are cut, and how many terms are left on them."""

from math import comb

from galileo_sym.primitives.approximations import APPROXIMATIONS, coefficients
from galileo_sym.primitives.lines import columns

_FRACTION_BITS = 10  # of the pieces: 1024 a binade of x + offset
_TOLERANCE = 2.0**-60  # what the terms left out may come to, beside the value


def _value(piece, d):
    """A piece's polynomial at a distance from its centre."""
    c0, _, c1, _, *others = piece.coefficients
    return sum(c * d**k for k, c in enumerate((c0, c1, *others)))


def _terms_left(piece, lower, upper, finer):
    """Degree that is enough on every part of a piece, by a bound of all terms about a point s from the centre.

    The one of degree k is sum_j C(j, k) c_j s^(j - k), times half a part's width to the k; a whole width from 0 on.
    """
    c0, _, c1, _, *others = piece.coefficients
    sizes = [abs(c) for c in (c0, c1, *others)]
    reach = max(piece.centre - lower, upper - piece.centre)
    half = (upper - lower) / 2 ** (finer + 1) * (2 if lower == 0.0 else 1)
    least = min(abs(_value(piece, x - piece.centre)) for x in (lower or (0.0 if c0 else half), upper))
    terms = [
        half**k * sum(comb(j, k) * sizes[j] * reach ** (j - k) for j in range(k, len(sizes))) for k in range(len(sizes))
    ]
    return next(n for n in range(1, len(sizes)) if sum(terms[n + 1 :]) <= _TOLERANCE * least)


def cut(bank):
    """Return by how many bits the pieces of an approximation are cut, and the degree that is then enough.

    The functions are monotone, so that the least value on a piece is at one of its ends; near 0 one that is 0 there is
    held against its value at the end of the first part.
    """
    partition = APPROXIMATIONS[bank].partition
    finer = _FRACTION_BITS - partition.fraction_bits
    pieces = coefficients(bank)
    return finer, max(_terms_left(piece, *partition.bounds(i), finer) for i, piece in enumerate(pieces))


def bank_text(bank):
    """Return the source of an approximation."""
    partition = APPROXIMATIONS[bank].partition
    finer, degree = cut(bank)
    unit = float(coefficients(bank)[0].coefficients[0] == 0.0)
    texts = []
    for values in columns(bank).values():
        rows = [" ".join(v.hex() for v in values[i : i + 4]) for i in range(0, len(values), 4)]
        texts.append("        (\n" + "\n".join(f'            "{row} "' for row in rows) + "\n        ),\n")
    return (
        f"# {APPROXIMATIONS[bank].doc}\n{bank.upper()} = Bank(\n"
        f"    offset={partition.offset!r},\n    first={partition.first},\n    drop={partition.drop},\n"
        f"    finer={finer},\n    degree={degree},\n    unit={unit!r},\n    columns=(\n{''.join(texts)}    ),\n)\n"
    )
