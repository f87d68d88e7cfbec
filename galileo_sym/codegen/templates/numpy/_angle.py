"""Sine, cosine and the driving force cos(theta) - mu sin(|theta|) on [-pi/2, pi/2], exact in sign."""

from typing import NamedTuple

import numpy as np

from ._scaled import Scaled, div, fast_two_sum, load, mul, plain, select, sub, two_prod, two_sum
from ._tables import ANGLE_STEPS, COSINE, COSM1, HALF_PI, SINC, SINE

_QUARTER_PI = 0.7853981633974483
_CLOSE = 2.0**-10  # share of the cosine below which the driving force needs more than the pairs of sine and cosine
_PASSES = 4


class Angle(NamedTuple):
    """|theta|, or its complement where that is smaller, as x + x2 + x3; with the sine (>= 0), cosine and sign."""

    x: np.ndarray
    x2: np.ndarray
    x3: np.ndarray
    complement: np.ndarray
    sign: np.ndarray
    s: Scaled
    c: Scaled


def _nearest_step(x):
    i = np.rint(x * ANGLE_STEPS)
    return i.astype(np.int32), x - i / ANGLE_STEPS


def _sine_cosine(x, x2):
    """Sine and cosine of x + x2 in [0, pi/4], as pairs with relative error about 2**-68."""
    i, d = _nearest_step(x)
    s, s2, c, c2 = SINE[0][i], SINE[1][i], COSINE[0][i], COSINE[1][i]
    q = d * d
    sd = d * (q * (SINC[0][0] + q * (SINC[1][0] + q * (SINC[2][0] + q * SINC[3][0])))) + x2
    cd = q * (COSM1[0][0] + q * (COSM1[1][0] + q * (COSM1[2][0] + q * COSM1[3][0])))
    p, t = two_prod(c, d)
    h, low = two_sum(s, p)
    sine = fast_two_sum(h, low + (t + (s2 + (c * sd + c2 * d + s * cd))))
    p, t = two_prod(s, d)
    h, low = two_sum(c, -p)
    cosine = fast_two_sum(h, low + ((c2 + (c * cd - s * sd - s2 * d)) - t))
    return sine, cosine


def angle(theta):
    """Prepare theta, |theta| <= float(pi/2)."""
    a = np.abs(theta)
    complement = a > _QUARTER_PI
    r, r2 = two_sum(HALF_PI[0] - a, HALF_PI[1])
    r2, r3 = two_sum(r2, HALF_PI[2])
    x, x2, x3 = (np.where(complement, y, z) for y, z in ((r, a), (r2, 0.0), (r3 + HALF_PI[3], 0.0)))
    tiny = x < 2.0**-60
    sine, cosine = _sine_cosine(np.where(tiny, 0.0, x), x2)
    zero = np.zeros_like(x, dtype=np.int32)
    sine, cosine = select(tiny, load(x), Scaled(*sine, zero)), Scaled(*cosine, zero)
    s, c = select(complement, cosine, sine), select(complement, sine, cosine)
    return Angle(x, x2, x3, complement, np.copysign(1.0, theta), s, c)


def sine(angle):
    """Sine of theta."""
    return Scaled(angle.sign * angle.s.hi, angle.sign * angle.s.lo, angle.s.e)


def cosine(angle):
    """Cosine of theta."""
    return angle.c


def _products(a, b):
    """Terms whose sum is the product of two sums of three doubles."""
    return [
        *two_prod(a[0], b[0]),
        *two_prod(a[0], b[1]),
        *two_prod(a[1], b[0]),
        a[0] * b[2],
        a[1] * b[1],
        a[2] * b[0],
    ]


def _triple(terms):
    """Sum of doubles as three: exact transformations move the rounding errors down before anything is dropped."""
    terms = list(terms)
    for _ in range(_PASSES):
        for j in range(1, len(terms)):
            terms[j], terms[j - 1] = two_sum(terms[j], terms[j - 1])
    rest = terms[0]
    for term in terms[1:-2]:
        rest = rest + term
    return [terms[-1], terms[-2], rest]


def _series(rows, q):
    """q (r1 + q (r2 + ...))."""
    total = [part + 0.0 * q[0] for part in rows[-1]]
    for row in rows[-2::-1]:
        total = _triple([*_products(total, q), *row])
    return _triple(_products(total, q))


def _close_driving(a, mu):
    """The driving force where cosine and friction nearly cancel: a pair with error about 2**-150 of the cosine.

    P - mu Q with (P, Q) = (cos, sin) of theta, or (sin, cos) of its complement; dP/dx = turn Q, dQ/dx = -turn P. At a
    distance d from the nearest table step it is (P - mu Q) cos(d) + turn (Q + mu P) sin(d), in sums of three doubles.
    """
    i, d = _nearest_step(a.x)
    sines, cosines = [row[i] for row in SINE], [row[i] for row in COSINE]
    P = [np.where(a.complement, s, c) for s, c in zip(sines, cosines, strict=True)]
    Q = [np.where(a.complement, c, s) for s, c in zip(sines, cosines, strict=True)]
    turn = np.where(a.complement, 1.0, -1.0)
    m = np.ldexp(mu.hi, np.minimum(mu.e, 20))  # less than mu only where Q = 0
    unit, k = np.frexp(d)
    h, low = two_prod(mu.hi, unit)
    far, farther = two_prod(m, a.x2)
    friction = _triple([np.ldexp(h, mu.e + k), np.ldexp(low, mu.e + k), far, farther, m * a.x3])  # mu d
    at_step = _triple([*P, *(-t for t in _products([m, 0.0 * m, 0.0 * m], Q))])
    drift = _triple([turn * t for t in (*_products([d, a.x2, a.x3], Q), *_products(friction, P))])
    small = np.abs(d) < 2.0**-100
    z = [np.where(small, 0.0, part) for part in (d, a.x2, a.x3)]
    q = _triple(_products(z, z))
    bend, twist = _products(at_step, _series(COSM1, q)), _products(drift, _series(SINC, q))
    hi, lo, _ = _triple([*bend, *twist, *at_step, *drift])
    return hi, lo


def driving(a, mu):
    """cos(theta) - mu sin(|theta|), mu >= 0: sign right, pair accurate however much cancels."""
    n = sub(a.c, mul(mu, a.s))
    share, _ = plain(div(n, a.c))
    close = np.broadcast_to(np.abs(share) < _CLOSE, n.hi.shape)
    if not np.any(close):
        return n
    shape = n.hi.shape
    part = [np.broadcast_to(x, shape)[close] for x in (a.x, a.x2, a.x3, a.complement)]
    hi, lo = _close_driving(Angle(*part, None, None, None), Scaled(*(np.broadcast_to(x, shape)[close] for x in mu)))
    n = Scaled(*(np.array(np.broadcast_to(x, shape)) for x in n))
    n.hi[close], n.lo[close], n.e[close] = hi, lo, 0
    return n
