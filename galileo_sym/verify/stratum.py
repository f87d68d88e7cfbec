"""A stratum: a region of the inputs in which errors are sampled apart."""

from collections.abc import Callable
from typing import NamedTuple


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
