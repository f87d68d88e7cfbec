"""How [0, end) is cut into pieces, and the polynomial on each, fitted in multiprecision.

Piece i holds the x for which x + offset, rounded, has the same exponent and the same leading bits of the fraction: an
index that costs an addition, a shift and a subtraction. Pieces so grow with x, as the distance from a singularity at
-offset does. On a piece with centre c the function is c0 + d (c1 + d (c2 + ...)), d = x - c; c0 and c1 are pairs of
doubles, since their rounding is the only one that the result would feel.
"""

import struct
from dataclasses import dataclass

from mpmath import mp, mpf

COUNT = 16
_DIGITS = 60
_CHECKS = 9


def bits_of(value):
    """Return the bits of a double as an integer."""
    return struct.unpack("<q", struct.pack("<d", value))[0]


def _double(bits):
    return struct.unpack("<d", struct.pack("<q", bits))[0]


@dataclass(frozen=True)
class Partition:
    """The pieces that an offset gives; the offset lies on the grid of leading bits, so that piece 0 starts at 0.

    ``start`` is the number of the first of the `COUNT` pieces, for what does not start at 0;
    a binade of x + offset has 2^``fraction_bits`` pieces.
    """

    offset: float
    start: int = 0
    fraction_bits: int = 2

    def __post_init__(self):
        if bits_of(self.offset) % (1 << self.drop):
            raise ValueError(
                f"offset {self.offset} must have no more than {self.fraction_bits} bits after the leading one"
            )

    @property
    def drop(self):
        """How many of the last bits of x + offset the number of its piece does not depend on."""
        return 52 - self.fraction_bits

    @property
    def first(self):
        """Leading bits of the first piece, subtracted to get the index."""
        return self.number(self.offset) + self.start

    def number(self, shifted):
        """Leading bits of x + offset, counted on through all positive doubles."""
        return bits_of(shifted) >> self.drop

    @property
    def begin(self):
        """Where the first piece begins."""
        return self.bounds(0)[0]

    @property
    def end(self):
        """Where the last piece ends."""
        return self.bounds(COUNT - 1)[1]

    def bounds(self, index):
        """Return (lower, upper), exact doubles."""
        lower, upper = (_double((self.first + i) << self.drop) - self.offset for i in (index, index + 1))
        return lower, upper

    def centre(self, index):
        """Return the point c that d is counted from: 0 for the piece that begins there, so that d is exact.

        Elsewhere c/2 < x < 2 c makes it exact; where the middle leaves no room below for the blur of the bounds by the
        rounding of x + offset, c is a little less.
        """
        lower, upper = self.bounds(index)
        middle = (lower + upper) / 2
        return 0.0 if not lower else middle * (1 - 2.0**-10) if middle == 2 * lower else middle


@dataclass(frozen=True)
class Piece:
    """One polynomial: centre, coefficients (c0, c0_lo, c1, c1_lo, c2, ..., cn), largest relative error found."""

    centre: float
    coefficients: tuple
    error: float

    def value(self, x):
        """Return the polynomial at an mpf, without rounding of the coefficients' products."""
        c0, c0_lo, c1, c1_lo, *rest = map(mpf, self.coefficients)
        d = x - self.centre
        return (c0 + c0_lo) + d * ((c1 + c1_lo) + d * mp.polyval(rest[::-1], d))


def _pair(value):
    head = float(value)
    return head, float(value - mpf(head))


def solve(function, lower, upper, centre, known, powers):
    """Return the coefficients of powers of d = x - centre that, with the known ones, interpolate at Chebyshev nodes."""
    half, middle = (mpf(upper) - lower) / 2, (mpf(upper) + lower) / 2
    nodes = [middle + half * mp.cos(mp.pi * (2 * j + 1) / (2 * len(powers))) - centre for j in range(len(powers))]
    left = [function(centre + d) - sum(c * d**k for k, c in known.items()) for d in nodes]
    matrix = mp.matrix([[(d / half) ** k for k in powers] for d in nodes])
    scaled = mp.lu_solve(matrix, mp.matrix(left))
    return {k: scaled[i] / half**k for i, k in enumerate(powers)}


def _coefficients(function, lower, upper, centre, degree):
    """Powers of d, up to the rounding of all to doubles.

    Where d runs from 0 it gets twice as large as elsewhere: there c0 is the value at 0, c2 and c3 are doubles already,
    and what their rounding misses is taken up by the other coefficients.
    """
    known = {} if centre else {0: function(mpf(0))}
    for rounded in () if centre else (2, 3):
        free = [k for k in range(degree + 1) if k not in known]
        known[rounded] = mpf(float(solve(function, lower, upper, centre, known, free)[rounded]))
    free = [k for k in range(degree + 1) if k not in known]
    known |= solve(function, lower, upper, centre, known, free)
    return [known[k] for k in range(degree + 1)]


def fit_piece(function, partition, index, degree):
    """Fit one piece.

    Parameters
    ----------
    function : callable
        From mpf to mpf, correct to the working precision; at 0 too.
    partition : Partition
    index : int
    degree : int

    Returns
    -------
    Piece
        With the coefficients rounded to doubles, and the error measured on these between the nodes and at the ends.
    """
    with mp.workdps(_DIGITS):
        lower, upper = partition.bounds(index)
        centre = mpf(partition.centre(index))
        exact = _coefficients(function, lower, upper, centre, degree)
        coefficients = (*_pair(exact[0]), *_pair(exact[1]), *(float(c) for c in exact[2:]))
        piece = Piece(float(centre), coefficients, 0.0)
        points = [lower + (mpf(upper) - lower) * j / _CHECKS for j in range(_CHECKS + 1)]
        error = max(abs(piece.value(x) / value - 1) for x in points if (value := function(x)))
        return Piece(float(centre), coefficients, float(error))
