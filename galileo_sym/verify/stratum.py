"""What the strata of both papers share: the form of a stratum, and draws that recur."""

from collections.abc import Callable
from typing import NamedTuple

from .sampling import HALF_PI, step

NEAR = 64  # places within which "near" is tried


class Stratum(NamedTuple):
    """A region of the inputs.

    Attributes
    ----------
    name : str
        As shown, and as recorded in certificates.
    needs : tuple of str
        Variables the kernel must have for the stratum to apply.
    draw : callable
        Takes a `Draw` and the set of the kernel's variables, gives a dict of floats.
    """

    name: str
    needs: tuple
    draw: Callable


def tiny(draw):
    """Exponents of a drag that changes the last digits, or none at all."""
    return (-60, -8) if draw.chance(0.6) else (-1020, -60)


def slight(draw):
    """An angle near 0 of either sign, 0 included."""
    return draw.sign() * (0.0 if draw.chance(0.05) else draw.magnitude(-1020, -10))


def some_zero(draw, low, high):
    """Zero or an ordinary value, so that arrays hold both."""
    return draw.magnitude(low, high) if draw.chance(0.5) else 0.0


def grid_angle(draw, top):
    """An angle within 4 places of a multiple of 1/128 up to top/128, or of pi/4 if that is below."""
    middle = draw.chance(0.1) and top / 128.0 > HALF_PI / 2
    return step(HALF_PI / 2 if middle else draw.integer(1, top) / 128.0, draw.integer(-4, 4))
