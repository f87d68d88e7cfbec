"""The angle of a direction in the first quadrant."""

import numpy as np

from ._scaled import ZERO_EXPONENT, Scaled, add, constant, div, fast_two_sum, load, mul, plain, select, sub
from ._tables import ANGLE_STEPS, COSINE, HALF_PI, SINE


def right_angle():
    """pi/2."""
    return Scaled(np.float64(HALF_PI[0]), np.float64(HALF_PI[1]), np.int32(0))


def elevation(opposite, adjacent):
    """Arctangent of opposite/adjacent, both >= 0 and not both 0: in [0, pi/2], as a pair with relative error 2**-65.

    The smaller share t = tan(angle) is turned back by the nearest table step i: tan(angle - i/64) is below 0.013.
    """
    steep = sub(opposite, adjacent).hi > 0.0
    t = div(select(steep, adjacent, opposite), select(steep, opposite, adjacent))
    u, _ = plain(t)
    i = np.rint(ANGLE_STEPS * (u / (1.0 + 0.28125 * u * u))).astype(np.int32)
    s = Scaled(SINE[0][i], SINE[1][i], np.where(i == 0, ZERO_EXPONENT, 0).astype(np.int32))
    c = Scaled(COSINE[0][i], COSINE[1][i], np.zeros_like(i))
    rest = div(sub(mul(t, c), s), add(c, mul(t, s)))
    w, _ = plain(rest)
    y = w * w
    bend = -y * (1.0 / 3.0 - y * (1.0 / 5.0 - y * (1.0 / 7.0 - y * (1.0 / 9.0))))
    angle = add(load(i / ANGLE_STEPS), mul(rest, Scaled(*fast_two_sum(np.ones_like(bend), bend), np.int32(0))))
    return select(steep, sub(right_angle(), angle), angle)


def arctangent(x):
    """Arctangent of a scaled pair >= 0."""
    return elevation(x, constant(1.0))
