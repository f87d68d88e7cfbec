"""The operations that evaluate each primitive, in order: what both languages print, and what the proof replays.

A line is a name, an operation and its operands, which are names, numbers or columns of a table. All operations are
IEEE binary64: ``add``, ``sub``, ``mul``, ``div``, ``fma``, ``fnma(a, b, c)`` = c - a b;
``rest(a, b, s)``, the exact rest of s = a + b rounded where
|a| >= |b|; ``product_rest(a, b, p)``, the exact rest of p = a b rounded; ``pick(column, i)``, a coefficient of piece i.
"""

from dataclasses import dataclass

from galileo_sym.primitives.approximations import APPROXIMATIONS, coefficients

LARGEST = float.fromhex("0x1.fffffffffffffp+1023")


@dataclass(frozen=True)
class Line:
    """``name = operation(*operands)``."""

    name: str
    operation: str
    operands: tuple


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


def columns(bank):
    """Return {column: values by piece} of an approximation, in the order of evaluation."""
    names = ["centre", "c0", "c0_lo", "c1", "c1_lo"]
    names += [f"c{k}" for k in range(2, APPROXIMATIONS[bank].degree + 1)]
    rows = [(piece.centre, *piece.coefficients) for piece in coefficients(bank)]
    return dict(zip(names, zip(*rows, strict=True), strict=True))


def near_lines(bank, paired):
    """Return the lines that evaluate an approximation at x, or at x + x_lo if paired: the result as r + lo.

    All but the last steps of Horner's rule are in plain arithmetic; the last ones keep what is rounded away.
    """
    partition, degree = APPROXIMATIONS[bank].partition, APPROXIMATIONS[bank].degree
    lines = [
        Line("u", "add", ("x", partition.offset)),
        Line("i", "piece", ("u", partition.first, partition.drop)),
        Line("d", "sub", ("x", ("pick", "centre"))),
        Line(f"q{degree}", "pick", (("pick", f"c{degree}"),)),
    ]
    lines += [Line(f"q{k}", "fma", (f"q{k + 1}", "d", ("pick", f"c{k}"))) for k in range(degree - 1, 1, -1)]
    lines += [
        Line("c1", "pick", (("pick", "c1"),)),
        Line("h", "mul", ("q2", "d")),
        Line("t", "add", ("c1", "h")),
        Line("t_rest", "rest", ("c1", "h", "t")),
        Line("t_lo", "add", ("t_rest", ("pick", "c1_lo"))),
        Line("p", "mul", ("d", "t")),
        Line("p_rest", "product_rest", ("d", "t", "p")),
        Line("p_lo", "fma", ("d", "t_lo", "p_rest")),
    ]
    if paired:  # f(x + x_lo) - f(x), with c1 + 2 h for the slope
        lines += [
            Line("slope", "add", ("t", "h")),
            Line("p_all", "fma", ("x_lo", "slope", "p_lo")),
        ]
    lines += [
        Line("c0", "pick", (("pick", "c0"),)),
        Line("s", "add", ("c0", "p")),
        Line("s_rest", "rest", ("c0", "p", "s")),
        Line("s_lo", "add", ("p_all" if paired else "p_lo", ("pick", "c0_lo"))),
        Line("e", "add", ("s_rest", "s_lo")),
        Line("r", "add", ("s", "e")),
        Line("lo", "rest", ("s", "e", "r")),
    ]
    return lines


KERNELS = {
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
