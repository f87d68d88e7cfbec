"""The primitives: which approximations serve each, and what beyond them."""

from dataclasses import dataclass
from math import inf

from galileo_sym.primitives import best_frames, elementary, lambert_frames
from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.lines import Line

LARGEST = float.fromhex("0x1.fffffffffffffp+1023")


@dataclass(frozen=True)
class Kernel:
    """A primitive on x >= 0.

    ``banks`` are the approximations that serve one after the other, from 0 on; ``far`` the lines that give the result
    ``r`` beyond the last of them.
    """

    name: str
    doc: str
    banks: tuple
    far: tuple

    @property
    def end(self):
        """Where the far form begins."""
        return APPROXIMATIONS[self.banks[-1]].partition.end

    @property
    def thresholds(self):
        """Where one form gives way to the next."""
        return tuple(APPROXIMATIONS[bank].partition.end for bank in self.banks)

    @property
    def domain(self):
        """Least and greatest argument."""
        return 0.0, inf


BANKED = {
    kernel.name: kernel
    for kernel in (
        Kernel("phi1m", "(1 - exp(-z))/z", ("phi1m", "phi1m_tail"), (Line("r", "div", (1.0, "x")),)),
        Kernel(
            "phi2m",
            "(z - 1 + exp(-z))/z^2",
            ("phi2m", "phi2m_tail"),
            (  # (1 - 1/z)/z, with the rest of the division
                Line("y", "div", (1.0, "x")),
                Line("finite", "min", ("x", LARGEST)),
                Line("share", "fnma", ("y", "finite", 1.0)),
                Line("less", "sub", ("share", "y")),
                Line("r", "fma", ("less", "y", "y")),
            ),
        ),
        Kernel(
            "descent_factor",
            "tau/p with tau - 1 + exp(-tau) = p^2/2",
            ("descent_factor",),
            (Line("y", "div", (1.0, "x")), Line("r", "fma", ("x", 0.5, "y"))),
        ),
        Kernel(
            "flight_factor",
            "T/(2 b) with T = (1 + b)(1 - exp(-T))",
            ("flight_factor", "flight_tail"),
            (Line("y", "div", (0.5, "x")), Line("r", "add", (0.5, "y"))),
        ),
        Kernel(
            "range_factor",
            "(1 - exp(-T))/(2 b) with T = (1 + b)(1 - exp(-T))",
            ("range_factor", "range_tail"),
            (Line("r", "div", (0.5, "x")),),
        ),
    )
}

_FRAMES = (*best_frames.FRAMES, *lambert_frames.FRAMES, *elementary.FRAMES)
KERNELS = BANKED | {frame.name: frame for frame in _FRAMES}
