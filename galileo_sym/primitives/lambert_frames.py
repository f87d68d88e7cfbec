"""W on both real branches, and 1 + W of what is close to -1/e, each in a variable in which it is smooth.

At the branch point that is the square root of the distance from it; far away, the logarithm. So there is no iteration,
and no cancellation: 1 + W0 and 1 + W-1 of -exp(-1 - x) never meet the exponential.
"""

from math import inf, nextafter

from mpmath import mp, mpf

from galileo_sym.primitives.frames import Frame, Range
from galileo_sym.primitives.lines import Line
from galileo_sym.primitives.pairs import (
    LARGEST,
    add_exact,
    logarithm,
    product,
    result,
    root,
    scale,
    settled,
    single,
)

LEAST_POSITIVE = 5e-324
with mp.workdps(60):
    INVERSE_E = float(mp.exp(-1))
    INVERSE_E_LO = float(mp.exp(-1) - mpf(INVERSE_E))
LEAST = nextafter(-INVERSE_E, 0)  # -INVERSE_E lies below -1/e

_TINY = 2.0**-900  # below, the rest of sqrt(2 x) would underflow; 2^108 x has one that does not
_SCALE = 108
_NO_MORE_RISE = 43.9  # from here 1 + W0(-exp(-1 - x)) is 1 but for 2^-64
_FALL_END = 112.0  # sqrt(2 x) < 15
_LOG_END = 60.0  # for y beyond, log(1 + sigma) is y to the last digit, sigma - log(1 + sigma) = exp(y)
_LARGE = 21.5  # sqrt(x + 1/e) < 4.6875, log x > 3
_BRANCH_END = -0.124  # sqrt(x + 1/e) < 1/2, -x < 1/8
_MIDDLE_END = -(2.0**-7)
_SMALL = -1e-49  # sqrt(-2 - 2 log(-x)) is 14.95
_SUBNORMAL_SCALE = 64

_ROOT = [*scale("twice", "x", 2.0), *root("p", "twice")]
_TINY_ROOT = [
    *scale("grown", "x", 2.0 ** (_SCALE + 1)),
    *root("p", "grown"),
    *scale("w", "p", 2.0 ** (-_SCALE // 2)),
]

# sqrt(x + 1/e), the sum without any error but that of the third double of 1/e
_BRANCH_ROOT = [
    Line("sum", "add", ("x", INVERSE_E)),
    Line("sum_rest", "sum_rest", ("x", INVERSE_E, "sum")),
    Line("e_lo", "add", ("x_lo", INVERSE_E_LO)),
    Line("sum_off", "add", ("sum_rest", "e_lo")),
    Line("delta", "add", ("sum", "sum_off")),
    Line("delta_lo", "rest", ("sum", "sum_off", "delta")),
    *root("q", "delta"),
]


def _factored(bank):
    """p times a factor, as w."""
    return [Line("f", "near_pair", (bank, "p", "p_lo")), *product("w", "p", "f")]


_FALL_FAR = [  # x + log(1 + sigma)
    Line("finite", "min", ("x", LARGEST)),
    Line("finite_lo", "copy", ("x_lo",)),
    *logarithm("y", "finite"),
    Line("bounded", "min", ("y", _LOG_END)),
    Line("beyond", "sub", ("y", "bounded")),
    Line("f", "near_pair", ("fall_log", "bounded", "y_lo")),
    Line("log", "add", ("f", "beyond")),
    Line("f_all", "add", ("f_lo", "x_lo")),
    Line("w_s", "add", ("finite", "log")),
    Line("w_rest", "rest", ("finite", "log", "w_s")),
    Line("w_off", "add", ("w_rest", "f_all")),
    *settled("w", "w_s", "w_off"),
]

_NEAR_ZERO = 2.0**-20  # within, W0(x)/x is taken from its series: x - x^2 can be a midpoint of floats but for x^4
_FELT = 2.0**-250  # below, x alone is W0(x), and its square would underflow
_SERIES_OF_RATIO = [  # 1 - x + 3/2 x^2 - 8/3 x^3
    Line("distance", "abs", ("x",)),
    Line("felt", "at_least", ("distance", _FELT)),
    Line("y", "select", ("felt", "x", 0.0)),
    Line("minus", "mul", ("y", -1.0)),
    Line("g_s", "add", (1.0, "minus")),
    Line("g_rest", "rest", (1.0, "minus", "g_s")),
    Line("g_square", "mul", ("y", "y")),
    Line("g_tail", "fma", ("y", -8 / 3, 1.5)),
    Line("g_off", "fma", ("g_square", "g_tail", "g_rest")),
    Line("g", "add", ("g_s", "g_off")),
    Line("g_lo", "rest", ("g_s", "g_off", "g")),
]

_W0 = [
    *_BRANCH_ROOT,
    Line("h", "near_pair", ("w0_ratio", "q", "q_lo")),
    *_SERIES_OF_RATIO,
    Line("close", "less", ("distance", _NEAR_ZERO)),
    Line("f", "select", ("close", "g", "h")),
    Line("f_lo", "select", ("close", "g_lo", "h_lo")),
    *product("w", "x", "f"),
    Line("size", "abs", ("w",)),
    Line("r", "flip", ("size", "x")),  # -0 at -0
    Line("lo", "copy", ("w_lo",)),
]

_W0_LARGE = [*logarithm("y", "x"), Line("w", "near_pair", ("omega", "y", "y_lo")), *result("w")]


def _wm1(bank, scaled):
    """W-1 by its offset: -1 - p fall_factor(p), p^2/2 = -1 - log(-x)."""
    return [
        Line("m0", "abs", ("x",)),
        Line("m", "mul", ("m0", 2.0**scaled)),
        Line("m_lo", "mul", ("x_lo", -(2.0**scaled))),
        *logarithm("y", "m", float(scaled)),
        *scale("z", "y", -2.0),
        *add_exact("twice", "z", -2.0),
        *root("p", "twice"),
        *_factored(bank),
        *add_exact("v", "w", 1.0),
        *result("v", -1.0),
    ]


_WM1_BRANCH = [*_BRANCH_ROOT, Line("w", "near_pair", ("wm1_branch", "q", "q_lo")), *result("w", -1.0)]
_WM1_MIDDLE = [
    Line("m", "abs", ("x",)),
    Line("m_lo", "mul", ("x_lo", -1.0)),
    Line("w", "near_pair", ("wm1_middle", "m", "m_lo")),
    *result("w", -1.0),
]


def _range(begin, end, lines):
    return Range(begin, end, tuple(lines))


# where the argument is a pair, from -1/e as a pair on
_ON_W0 = ((-INVERSE_E, -INVERSE_E_LO), (inf, 0.0))
_ON_WM1 = ((-INVERSE_E, -INVERSE_E_LO), (0.0, 0.0))


FRAMES = (
    Frame(
        "w0_offset",
        "1 + W0(-exp(-1 - x))",
        ("rise_factor",),
        (
            _range(_TINY, _NO_MORE_RISE, [*_ROOT, *_factored("rise_factor"), *result("w")]),
            _range(0.0, _TINY, [*_TINY_ROOT, *result("w")]),
            _range(_NO_MORE_RISE, inf, single("min", "x", 1.0)),
        ),
        (0.0, inf),
    ),
    Frame(
        "wm1_offset",
        "1 + W-1(-exp(-1 - x))",
        ("fall_factor", "log", "fall_log"),
        (
            _range(_TINY, _FALL_END, [*_ROOT, *_factored("fall_factor"), *result("w", -1.0)]),
            _range(0.0, _TINY, [*_TINY_ROOT, *result("w", -1.0)]),
            _range(_FALL_END, inf, [*_FALL_FAR, *result("w", -1.0)]),
            _range(inf, inf, single("mul", "x", -1.0)),
        ),
        (0.0, inf),
    ),
    Frame(
        "w0",
        "W0(x): w exp(w) = x, w >= -1",
        ("w0_ratio", "log", "omega"),
        (_range(LEAST, _LARGE, _W0), _range(_LARGE, inf, _W0_LARGE), _range(inf, inf, single("copy", "x"))),
        (LEAST, inf),
        pair_domain=_ON_W0,
    ),
    Frame(
        "wm1",
        "W-1(x): w exp(w) = x, w <= -1; -inf at 0",
        ("wm1_branch", "wm1_middle", "log", "fall_factor", "fall_tail"),
        (
            _range(LEAST, _BRANCH_END, _WM1_BRANCH),
            _range(_BRANCH_END, _MIDDLE_END, _WM1_MIDDLE),
            _range(_MIDDLE_END, _SMALL, _wm1("fall_factor", 0)),
            _range(_SMALL, 0.0, _wm1("fall_tail", _SUBNORMAL_SCALE)),
            _range(0.0, LEAST_POSITIVE, single("sub", "x", inf)),
        ),
        (LEAST, 0.0),
        pair_domain=_ON_WM1,
        pole=0.0,
    ),
)
