"""The angle of greatest range, its sine, and the greatest range itself, for every resistance a.

Beyond the pieces s = 1 + w, w + log(w) = log((a^2 - 1)/e), and exp(s) = (a^2 - 1)/w.
"""

from math import comb, inf

from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.frames import Frame, Range
from galileo_sym.primitives.lines import Line
from galileo_sym.primitives.pairs import (
    LARGEST,
    add_exact,
    logarithm,
    product,
    quotient,
    result,
    root,
    scale,
    series,
    single,
)

_VERY_FAR = 2.0**554  # log(a^2/e) is 767.02; one bank ends at 768, the next begins at 512
_SQUARE = 2.0**500  # beyond, w (2 + w)/(a^2 - 1) is as good as 0
_LOGARITHM = tuple(-1 / k for k in range(1, 12))  # log(1 - z)/z, z <= 1/56.25
_ARCSINE = tuple(comb(2 * k, k) / 4**k / (2 * k + 1) for k in range(1, 13))  # (asin(s)/s - 1)/s^2 in s^2 <= 0.048


def _omega(bank):
    return [
        Line("a", "min", ("x", LARGEST)),
        Line("a_lo", "copy", ("x_lo",)),
        *logarithm("half", "a"),
        *scale("whole", "half", 2.0),
        *add_exact("less", "whole", -1.0),
        Line("inverse", "div", (1.0, "a")),
        Line("z", "mul", ("inverse", "inverse")),
        *series("c", "z", _LOGARITHM),
        Line("off", "fma", ("c", "z", "less_lo")),
        Line("y", "add", ("less", "off")),
        Line("y_lo", "rest", ("less", "off", "y")),
        Line("w", "near_pair", (bank, "y", "y_lo")),
    ]


_SINE = [  # w/(a - (1 + w)/a)
    *add_exact("s", "w", 1.0),
    *quotient("g", "s", "a"),
    Line("minus", "mul", ("g", -1.0)),
    Line("g_less", "sub", ("g_lo", "a_lo")),
    Line("d", "add", ("a", "minus")),
    Line("d_rest", "rest", ("a", "minus", "d")),
    Line("d_lo", "sub", ("d_rest", "g_less")),
    *quotient("sine", "w", "d"),
]
_SINE_ALONE = [*_SINE, *result("sine")]

_ANGLE = [
    *_SINE,
    Line("square", "mul", ("sine", "sine")),
    *series("more", "square", _ARCSINE),
    Line("share", "mul", ("square", "more")),
    Line("half_square", "mul", ("square", 0.5)),
    Line("sine_all", "fma", ("half_square", "sine_lo", "sine_lo")),
    Line("angle_off", "fma", ("sine", "share", "sine_all")),
    Line("angle", "add", ("sine", "angle_off")),
    Line("angle_lo", "rest", ("sine", "angle_off", "angle")),
    *result("angle"),
]

_RANGE = [  # sqrt(1 - w (2 + w)/(a^2 - 1))/a
    *add_exact("t", "w", 2.0),
    *product("n", "t", "w"),
    Line("b", "min", ("a", _SQUARE)),
    Line("lost", "at_least", ("a", _SQUARE)),
    Line("b_lo", "select", ("lost", 0.0, "a_lo")),
    *product("square", "b", "b"),
    *add_exact("d", "square", -1.0),
    *quotient("v", "n", "d"),
    *scale("minus", "v", -1.0),
    *add_exact("left", "minus", 1.0),
    *root("top", "left"),
    *quotient("factor", "top", "a"),
    *result("factor"),
]

# 1/a: the root is 1 but for 2^-1087. A rest that may be subnormal is not added: that would round twice, and by 3/4 ulp.
_RANGE_VERY_FAR = [
    Line("a", "min", ("x", LARGEST)),
    Line("q", "div", (1.0, "a")),
    Line("q_e0", "product_rest", ("q", "a", 1.0)),
    Line("q_e1", "fma", ("q", "x_lo", "q_e0")),
    Line("minus", "mul", ("q", -1.0)),
    Line("r", "fma", ("minus", "q_e1", "q")),
    Line("back", "sub", ("q", "r")),
    Line("off", "mul", ("minus", "q_e1")),
    Line("lo", "add", ("back", "off")),
]


def _frame(name, doc, lines, very_far):
    far = APPROXIMATIONS[name].partition.end
    return Frame(
        name,
        doc,
        (name, "log", "omega", "omega_tail"),
        (
            Range(0.0, far, (Line("f", "near_pair", (name, "x", "x_lo")), *result("f"))),
            Range(far, _VERY_FAR, (*_omega("omega"), *lines)),
            Range(_VERY_FAR, inf, tuple(very_far)),
            Range(inf, inf, tuple(single("div", 1.0, "x"))),
        ),
        (0.0, inf),
    )


_TAIL = _omega("omega_tail")
FRAMES = (
    _frame("best_sine", "a/(exp(s) - 1), 1 + (s - 1) exp(s) = a^2", _SINE_ALONE, [*_TAIL, *_SINE_ALONE]),
    _frame("best_angle", "asin of best_sine", _ANGLE, [*_TAIL, *_ANGLE]),
    _frame("max_range_factor", "sqrt(1 - (1 + s) exp(-s))/a, 1 + (s - 1) exp(s) = a^2", _RANGE, _RANGE_VERY_FAR),
)
