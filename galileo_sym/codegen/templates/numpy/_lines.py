"""What the lines of the primitives are made of, on float64 arrays, and the choice among the forms of a primitive.

NumPy has no fused multiply-add: a * b + c, rounded twice, takes its place. Where an exact rest is due, the product is
taken apart.
"""

from math import inf

import numpy as np

from ._kernel import quiet, raise_divide, raise_invalid

_HIGH = np.int64(-(1 << 27))  # the bits of a double but the last 27 of its fraction


def row(text):
    """Sixteen doubles, written in hexadecimal."""
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


def product_rest(a, b, p):
    """a b - p, p next to a b, but for 2^-105 of it."""
    h = a * b
    a_hi, b_hi = _of_bits(bits(a) & _HIGH), _of_bits(bits(b) & _HIGH)
    a_lo, b_lo = a - a_hi, b - b_hi
    return (h - p) + ((((a_hi * b_hi - h) + a_hi * b_lo) + a_lo * b_hi) + a_lo * b_lo)


def flip(a, x):
    """-a where the sign bit of x is set."""
    return np.where(np.signbit(x), -a, a)


def piece(shifted, first, drop):
    """The bits above the dropped ones, less the first."""
    return (bits(shifted) >> drop) - first


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


def _serve(forms, good, m, signs, evaluate):
    """Each form on the lanes it serves; of two that overlap the later, and the first on all that is left."""
    hi, lo = np.full(m.shape, np.nan), np.zeros(m.shape)
    with quiet():
        for number in range(len(forms) - 1, -1, -1):
            begin, end = forms[number][:2]
            here = good & (m >= begin) & ((m < end) | (end == inf)) if number else good
            good = good & ~here
            if np.any(here):
                place = ... if np.all(here) else here
                hi[place], lo[place] = evaluate(forms[number], place)
    return (hi, lo) if signs is None else (flip(hi, signs), flip(lo, signs))


def single(primitive, x):
    """A primitive of x, as its double and the rest; NaN and 'invalid' beyond its domain, 'divide by zero' at a pole."""
    x = np.asarray(x, dtype=np.float64)
    lower, upper = primitive["domain"]
    good = (x >= lower) & (x <= upper)
    if np.any(~good & ~np.isnan(x)):
        raise_invalid()
    if primitive["pole"] is not None and np.any(x == primitive["pole"]):
        raise_divide()
    m = np.abs(x) if primitive["parity"] else x
    signs = x if primitive["parity"] == "odd" else None
    return _serve(primitive["forms"], good, m, signs, lambda form, here: form[2](m[here]))


def paired(primitive, x, x_lo):
    """The same of x + x_lo, abs(x_lo) no more than half an ulp of x."""
    x, x_lo = np.broadcast_arrays(np.asarray(x, dtype=np.float64), np.asarray(x_lo, dtype=np.float64))
    lower, upper = primitive["ends"]
    good = ~(np.isnan(x) | _before(x, x_lo, *lower) | _before(*upper, x, x_lo))
    if np.any(~good & ~np.isnan(x)):
        raise_invalid()
    m, m_lo = (np.abs(x), flip(x_lo, x)) if primitive["parity"] else (x, x_lo)
    signs = x if primitive["parity"] == "odd" else None
    return _serve(primitive["forms"], good, m, signs, lambda form, here: form[3](m[here], m_lo[here]))
