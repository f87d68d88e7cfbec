"""Exact ends of balls as mpmath's numbers, for comparison with what mpmath finds."""

from mpmath import mp, mpf


def exactly(point):
    """A ball without radius as an mpf, which the working precision must hold."""
    mantissa, exponent = map(int, point.man_exp())
    value = mpf(mantissa) * mpf(2) ** exponent
    assert mantissa.bit_length() < mp.prec
    return value


def ball_ends(ball):
    """Both ends of a ball."""
    middle, radius = exactly(ball.mid()), exactly(ball.rad())
    return middle - radius, middle + radius


def ends(enclosure):
    """Both ends of an enclosure."""
    return ball_ends(enclosure.ball)
