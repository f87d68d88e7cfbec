"""What the papers' formulas need of a pair, and is no primitive of its own."""

from math import inf, nextafter

from mpmath import mp, mpf

from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.elementary import HALF_PI, SCALED
from galileo_sym.primitives.frames import Frame, Range
from galileo_sym.primitives.lines import Line
from galileo_sym.primitives.pairs import add_exact, inverse, plus, product, quotient, result, scale, single

_TO_ARCTANGENT = 0.28125  # beyond it 1/x is below 3.75, where the pieces of the arctangent end
_TINY = 2.0**100  # beyond it acot(x) is 1/x
_OMEGA_START, _OMEGA, _OMEGA_TAIL = (
    APPROXIMATIONS[bank].partition.end for bank in ("omega_start", "omega", "omega_tail")
)

_ACOT_NEAR = (  # pi/2 - arctan(x)
    Line("felt", "at_least", ("x", 2.0**-250)),
    Line("y", "select", ("felt", "x", 0.0)),
    Line("y_lo", "select", ("felt", "x_lo", 0.0)),
    Line("f", "near_pair", ("arctangent", "y", "y_lo")),
    Line("minus", "mul", ("f", -1.0)),
    Line("minus_lo", "mul", ("f_lo", -1.0)),
    Line("right", "copy", (HALF_PI[0],)),
    Line("right_lo", "copy", (HALF_PI[1],)),
    *plus("a", "right", "minus"),
    *result("a"),
)
_ACOT = (*inverse("y", "x"), Line("f", "near_pair", ("arctangent", "y", "y_lo")), *result("f"))


def _near(bank):
    return Line("f", "near_pair", (bank, "x", "x_lo")), *result("f")


def _range_frame(name, doc, bank, near, far, at_infinity=()):
    """A function of the kind of the range factor, on two banks of pieces and beyond."""
    banks = (bank, f"{bank}_tail")
    first, second = (APPROXIMATIONS[bank].partition.end for bank in banks)
    ranges = Range(0.0, first, near(banks[0])), Range(first, second, near(banks[1])), Range(second, inf, far)
    return Frame(name, doc, banks, ranges + at_infinity, (0.0, inf))


def _loss(bank):
    """A bank over (1 + x)^2."""
    return (
        Line("g", "near_pair", (bank, "x", "x_lo")),
        *add_exact("more", "x", 1.0),
        *product("square", "more", "more"),
        *quotient("f", "g", "square"),
        *result("f"),
    )


with mp.workdps(60):
    INVERSE_E = float(mp.exp(-1)), float(mp.exp(-1) - mpf(float(mp.exp(-1))))
_LOSS_FAR = (*inverse("y", "x"), *scale("half", "y", 0.5), *product("f", "half", "y"), *result("f"))  # 1/(2 x^2)
_BALANCE_FAR = (  # x/e
    Line("e", "copy", (INVERSE_E[0],)),
    Line("e_lo", "copy", (INVERSE_E[1],)),
    *product("f", "x", "e"),
    *result("f"),
)


FRAMES = (
    *SCALED,
    _range_frame("range_loss", "the slope of range_factor, negative", "grown_loss", _loss, _LOSS_FAR),
    _range_frame(
        "grown_balance",
        "b exp(b - T)/(T - b) with T = (1 + b)(1 - exp(-T))",
        "grown_balance",
        _near,
        _BALANCE_FAR,
        (Range(inf, inf, tuple(single("copy", "x"))),),
    ),
    Frame(
        "acot",
        "the angle in [0, pi/2] whose cotangent is x",
        ("arctangent",),
        (
            Range(_TO_ARCTANGENT, _TINY, _ACOT),
            Range(0.0, _TO_ARCTANGENT, _ACOT_NEAR),
            Range(_TINY, inf, (*inverse("y", "x"), *result("y"))),
        ),
        (0.0, inf),
    ),
    Frame(
        "wright_omega",
        "w with w + log(w) = y, y below 2^17",
        ("omega_start", "omega", "omega_tail"),
        (
            Range(0.0, _OMEGA_START, _near("omega_start")),
            Range(_OMEGA_START, _OMEGA, _near("omega")),
            Range(_OMEGA, _OMEGA_TAIL, _near("omega_tail")),
        ),
        (0.0, nextafter(_OMEGA_TAIL, 0)),
    ),
)
