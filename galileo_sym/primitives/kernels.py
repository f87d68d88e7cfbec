"""The primitives: which approximations serve each, and what beyond them."""

from dataclasses import dataclass
from math import inf
from typing import ClassVar

from galileo_sym.primitives import best_frames, elementary, lambert_frames
from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.frames import Range
from galileo_sym.primitives.lines import Line
from galileo_sym.primitives.pairs import LARGEST, add_exact, inverse, plus, product, result, scale, single


@dataclass(frozen=True)
class Kernel:
    """A primitive on x >= 0.

    ``banks`` are the approximations that serve one after the other, from 0 on; ``far`` the lines that give the result
    ``r`` beyond the last of them; ``far_pair`` those that give it as ``r`` and ``lo`` at x + x_lo, and ``at_infinity``
    those for infinity if they are others.
    """

    name: str
    doc: str
    banks: tuple
    far: tuple
    far_pair: tuple
    at_infinity: tuple = ()
    parity = ""
    pole = None
    tables: ClassVar[dict] = {}

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

    @property
    def ends(self):
        """The same as pairs."""
        return (0.0, 0.0), (inf, 0.0)

    @property
    def ranges(self):
        """What serves x + x_lo where, as in a frame."""
        begins = (0.0, *self.thresholds)
        near = ((Line("f", "near_pair", (bank, "x", "x_lo")), *result("f")) for bank in self.banks)
        finite = tuple(map(Range, begins, (*self.thresholds, inf), (*near, self.far_pair)))
        return finite + ((Range(inf, inf, self.at_infinity),) if self.at_infinity else ())


_INVERSE = inverse("y", "x")
_HALF_INVERSE = inverse("y", "x", 0.5)


BANKED = {
    kernel.name: kernel
    for kernel in (
        Kernel(
            "phi1m",
            "(1 - exp(-z))/z",
            ("phi1m", "phi1m_tail"),
            (Line("r", "div", (1.0, "x")),),
            (*_INVERSE, *result("y")),
        ),
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
            (
                *_INVERSE,
                *product("square", "y", "y"),
                *scale("minus", "square", -1.0),
                *plus("f", "y", "minus"),
                *result("f"),
            ),
        ),
        Kernel(
            "descent_factor",
            "tau/p with tau - 1 + exp(-tau) = p^2/2",
            ("descent_factor",),
            (Line("y", "div", (1.0, "x")), Line("r", "fma", ("x", 0.5, "y"))),
            (*_INVERSE, *scale("half", "x", 0.5), *plus("f", "half", "y"), *result("f")),
            tuple(single("copy", "x")),
        ),
        Kernel(
            "flight_factor",
            "T/(2 b) with T = (1 + b)(1 - exp(-T))",
            ("flight_factor",),
            (Line("y", "div", (0.5, "x")), Line("r", "add", (0.5, "y"))),
            (*_HALF_INVERSE, *add_exact("f", "y", 0.5), *result("f")),
        ),
        Kernel(
            "range_factor",
            "(1 - exp(-T))/(2 b) with T = (1 + b)(1 - exp(-T))",
            ("range_factor", "range_tail"),
            (Line("r", "div", (0.5, "x")),),
            (*_HALF_INVERSE, *result("y")),
        ),
    )
}

_FRAMES = (*best_frames.FRAMES, *lambert_frames.FRAMES, *elementary.FRAMES)
KERNELS = BANKED | {frame.name: frame for frame in _FRAMES}
