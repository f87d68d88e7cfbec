"""Approximations on pieces finer than the committed ones, which vectors pick out of sixteen.

Here a table costs no more for being long, and each operation passes through memory: so the committed polynomials are
expanded about the middle of each of many short pieces, when first used. There all but the constant terms are so small
that plain arithmetic leaves a value good to 2^-59, and few terms are left.
"""

from functools import cached_property

import numpy as np

from ._scaled import pair_add, pair_mul


class Bank:
    """A function on pieces: that of x is told by the leading bits of x + offset.

    `columns` are the committed coefficients, a text a column: centre, c0, its rest, c1, its rest, c2, ...; `finer`
    tells by how many bits their pieces are cut, `degree` what is enough on those. For a function that is x near 0
    `unit` is 1: c0 + d takes the place of c0, and c1 - 1 that of c1.
    """

    def __init__(self, offset, first, drop, finer, degree, unit, columns):
        self.offset, self.unit = offset, unit
        self.first, self.drop = first << finer, drop - finer
        self._finer, self._degree, self._columns = finer, degree, columns

    @cached_property
    def rows(self):
        """Centre, c0, its rest, c1, c2, ..., of each piece."""
        centre, *columns = (np.array([[float.fromhex(word)] for word in text.split()]) for text in self._columns)
        leading = (self.first + np.arange((centre.size << self._finer) + 1)) << self.drop
        bounds = leading.view(np.float64) - self.offset
        lower, upper = bounds[:-1], bounds[1:]
        middle = np.where(lower == 0.0, 0.0, 0.5 * (lower + upper))
        terms = _shifted(columns, middle.reshape(centre.size, -1) - centre, self._degree)
        (c0, c0_lo), (c1, c1_lo), *others = terms
        c1 = (c1 - self.unit) + c1_lo
        return middle, *(part.ravel() for part in (c0, c0_lo, c1, *(c for c, _ in others)))


def _shifted(columns, s, degree):
    """Coefficients, as pairs up to that of the slope, of polynomials about points at distances s from their centres."""
    zero = np.zeros_like(s)
    terms = [(columns[0] + zero, columns[1] + zero), (columns[2] + zero, columns[3] + zero)]
    terms += [(column + zero, zero) for column in columns[4:]]
    for k in range(degree + 1):
        for j in range(len(terms) - 2, k - 1, -1):
            if k < 2:
                terms[j] = pair_add(*terms[j], *pair_mul(*terms[j + 1], s, zero))
            else:
                terms[j] = terms[j][0] + terms[j + 1][0] * s, zero
    return terms[: degree + 1]


def _terms(bank, x):
    """c0 and its rest, the distance d from the centre, and c1 + d (c2 + ...)."""
    i = (x + bank.offset).view(np.int64)
    i >>= bank.drop
    i -= bank.first
    centre, c0, c0_lo, *others = bank.rows
    d = x - centre.take(i, mode="clip")
    t = others[-1].take(i, mode="clip")
    for row in others[-2::-1]:
        t *= d
        t += row.take(i, mode="clip")
    return c0.take(i, mode="clip"), c0_lo.take(i, mode="clip"), d, t


def _sum(bank, c0, d, p):
    """c0 + p, or c0 + d + p, as a pair."""
    if bank.unit:
        s = c0 + d
        p += (c0 - s) + d
        c0 = s
    r = c0 + p
    c0 -= r
    c0 += p
    return r, c0


def near(bank, x):
    """An approximation at x: the nearest double but for a little, and the rest."""
    c0, c0_lo, d, t = _terms(bank, x)
    t *= d
    t += c0_lo
    return _sum(bank, c0, d, t)


def near_pair(bank, x, x_lo):
    """The same at x + x_lo, abs(x_lo) no more than half an ulp of x."""
    c0, c0_lo, d, t = _terms(bank, x)
    t *= d + x_lo
    if bank.unit:
        t += x_lo
    t += c0_lo
    return _sum(bank, c0, d, t)
