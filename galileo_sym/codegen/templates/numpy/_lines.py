"""What the lines of the primitives are made of, on vectors of float64, and the choice among the forms of a primitive.

NumPy has no fused multiply-add: a * b + c, rounded twice, takes its place. Where an exact rest is due, the product is
taken apart.
"""

from math import inf

import numpy as np

from ._chunks import extent, in_chunks
from ._kernel import quiet, raise_divide, raise_invalid

_HIGH = np.int64(-(1 << 27))  # the bits of a double but the last 27 of its fraction


def row(text):
    """Doubles, written in hexadecimal."""
    return np.array([float.fromhex(word) for word in text.split()])


def bits(x):
    """The bits of doubles, as integers."""
    return np.asarray(x, dtype=np.float64).view(np.int64)


def _of_bits(i):
    return np.asarray(i, dtype=np.int64).view(np.float64)


def sum_rest(a, b, s):
    """The exact rest of s = a + b, rounded."""
    b_part = s - a
    return (a - (s - b_part)) + (b - b_part)


def _halves(a):
    high = _of_bits(bits(a) & _HIGH)
    return high, a - high


def product_rest(a, b, p):
    """a b - p, p next to a b, but for 2^-105 of it."""
    h = a * b
    a_hi, a_lo = _halves(a)
    b_hi, b_lo = (a_hi, a_lo) if b is a else _halves(b)
    return (h - p) + ((((a_hi * b_hi - h) + a_hi * b_lo) + a_lo * b_hi) + a_lo * b_lo)


def fnma(a, b, c):
    """c - a b, c next to a b, but for 2^-105 of it."""
    return -product_rest(a, b, c)


def flip(a, x):
    """-a where the sign bit of x is set."""
    return np.copysign(1.0, x) * a


def low_index(u):
    """The last four bits."""
    return bits(u) & 15


def power(u):
    """2**-n, n the bits of u above the last four."""
    return _of_bits(0x3FF0000000000000 - (bits(u) >> 4 << 52))


def exponent(x):
    """k with x = 2**k m, 2 <= m < 4."""
    return ((bits(x) >> 52) - 1024).astype(np.float64)


def mantissa(x):
    """m with x = 2**k m, 2 <= m < 4."""
    return _of_bits((bits(x) & 0xFFFFFFFFFFFFF) | 0x4000000000000000)


def to_odd(hi, lo):
    """hi + lo cut off at an odd last bit, which a later rounding to binary32 cannot mistake for a tie."""
    i = bits(hi)
    step = np.where((i ^ bits(lo)) < 0, -1, 1)
    return _of_bits(np.where((lo != 0.0) & (i % 2 == 0), i + step, i))


def _before(x, x_lo, y, y_lo):
    return (x < y) | ((x == y) & (x_lo < y_lo))


def _common(forms, least, most):
    """The form that serves all numbers from the least to the most, or None; of two that overlap the later."""
    for number in range(len(forms) - 1, -1, -1):
        begin, end = forms[number][:2]
        if begin <= least and (most < end or (end == inf and number == len(forms) - 1)):
            return forms[number]
    return None


def _each(forms, good, m, m_lo):
    """Each form on the lanes it serves; of two that overlap the later, and the first on all that is left."""
    hi, lo = np.full(m.shape, np.nan), np.zeros(m.shape)
    for number in range(len(forms) - 1, -1, -1):
        begin, end = forms[number][:2]
        here = good & (m >= begin) & ((m < end) | (end == inf)) if number else good
        good = good & ~here
        place = np.flatnonzero(here)
        if place.size:
            hi[place], lo[place] = _of_form(forms[number], m[place], None if m_lo is None else m_lo[place])
    return hi, lo


def _of_form(form, m, m_lo):
    return form[2](m) if m_lo is None else form[3](m, m_lo)


def inside(primitive, m, m_lo=None):
    """A primitive of m + m_lo, all inside its domain."""
    form = _common(primitive["forms"], *extent(m))
    return _each(primitive["forms"], np.full(m.shape, True), m, m_lo) if form is None else _of_form(form, m, m_lo)


def _told(primitive, x, x_lo):
    """The lanes in the domain; 'invalid' for others but NaN, 'divide by zero' at a pole."""
    lower, upper = primitive["ends" if x_lo is not None else "domain"]
    if x_lo is None:
        good = (x >= lower) & (x <= upper)
    else:
        good = ~(np.isnan(x) | _before(x, x_lo, *lower) | _before(*upper, x, x_lo))
    if np.any(~good & ~np.isnan(x)):
        raise_invalid()
    if x_lo is None and primitive["pole"] is not None and np.any(x == primitive["pole"]):
        raise_divide()
    return good


def _served(primitive, x, x_lo=None):
    """A primitive of x + x_lo, of any numbers; by one form, if that serves all of them."""
    parity, forms = primitive["parity"], primitive["forms"]
    lower, upper = primitive["domain"]
    with quiet():
        m, m_lo = (np.abs(x) if parity else x), x_lo
        if parity:
            sign = np.copysign(1.0, x)
            m_lo = None if x_lo is None else sign * x_lo
        least, most = extent(m)
        form = _common(forms, least, most) if (parity or lower < least) and most < upper else None
    good = _told(primitive, x, x_lo) if form is None else None
    with quiet():
        hi, lo = _each(forms, good, m, m_lo) if form is None else _of_form(form, m, m_lo)
        return (sign * hi, sign * lo) if parity == "odd" else (hi, lo)


def single(primitive, x):
    """A primitive of x, as its double and the rest; NaN and 'invalid' beyond its domain, 'divide by zero' at a pole."""
    return in_chunks(lambda x: _served(primitive, x), [x], 2)


def paired(primitive, x, x_lo):
    """The same of x + x_lo, abs(x_lo) no more than half an ulp of x."""
    return in_chunks(lambda x, x_lo: _served(primitive, x, x_lo), [x, x_lo], 2)
