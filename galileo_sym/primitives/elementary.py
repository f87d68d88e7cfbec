"""exp(-z), sine, cosine and arctangent, in the frame of the other primitives."""

from math import inf, nextafter

from mpmath import mp, mpf

from galileo_sym.primitives.frames import Frame, Range
from galileo_sym.primitives.lines import Line
from galileo_sym.primitives.pairs import result, single

_DIGITS = 80


def _parts(value, count):
    """Doubles that add up to an mpf, each the nearest to what the ones before it leave."""
    parts = []
    for _ in range(count):
        parts.append(float(value))
        value -= parts[-1]
    return tuple(parts)


def _cut(value, bits):
    """The multiple of 2^-bits below an mpf, and the rest."""
    head = float(mp.floor(value * 2**bits)) / 2**bits
    return head, float(value - mpf(head))


with mp.workdps(_DIGITS):
    HALF_PI = _parts(mp.pi / 2, 3)
    # how far a sixteenth of a binade goes: 38 bits, so that the products with 0 to 2^15 are exact, and the rest;
    # with 32 bits, up to 2^21
    STEP, STEP_LO = _cut(mp.log(2) / 16, 42)
    SHORT_STEP, SHORT_STEP_LO = _cut(mp.log(2) / 16, 36)
    NEAREST_STEP = float(mp.log(2) / 16)
    STEPS = float(16 / mp.log(2))  # in a unit
    SIXTEENTHS = {
        name: tuple(_parts(mpf(2) ** (mpf(-j) / 16), 2)[part] for j in range(16))
        for part, name in enumerate(("sixteenth", "sixteenth_lo"))
    }
_SERIES = tuple(float(1 / mp.factorial(k)) for k in range(2, 9))  # of (exp(t) - 1 - t)/t^2
_LAST = 745.25  # exp(-z) rounds to 0 from 745.14 on
_NORMAL = 640.0  # up to here no rest of exp(-z) underflows
_SHIFT = 2.0**52 + 2.0**51  # what is added to round to an integer, found in the last bits
_TINY = 2.0**-250  # below, what an odd function leaves of x is lost, and would underflow


def _exponential(given, step=STEP, step_lo=STEP_LO):
    """hi + lo = exp(-x) times 2^m, 2^-m = power times 2^-given: the multiple k = 16 m + j of log(2)/16 next to x."""
    shift = _SHIFT - 16 * given
    return [
        Line("u", "fma", ("x", STEPS, shift)),
        Line("k", "sub", ("u", shift)),
        Line("j", "low_index", ("u",)),
        Line("power", "power", ("u",)),
        Line("t_hi", "product_rest", ("k", step, "x")),  # k STEP is exact, and so is the difference
        Line("t", "fma", ("k", step_lo, "t_hi")),
        Line("t_off", "sub", ("t_hi", "t")),
        Line("t_lo", "fma", ("k", step_lo, "t_off")),
        Line("minus", "mul", ("x_lo", -1.0)),
        Line("v", "add", ("t", "minus")),
        Line("v_rest", "sum_rest", ("t", "minus", "v")),
        Line("v_lo", "add", ("t_lo", "v_rest")),
        Line("felt", "at_least", ("x", _TINY)),  # a smaller square would underflow
        Line("base", "select", ("felt", "v", 0.0)),
        Line("square", "mul", ("base", "base")),
        Line("q8", "copy", (_SERIES[-1],)),
        *(Line(f"q{n}", "fma", (f"q{n + 1}", "v", _SERIES[n - 2])) for n in range(7, 1, -1)),
        Line("h", "fma", ("square", "q2", "v_lo")),
        Line("c", "copy", (("pick", "sixteenth", "j"),)),
        Line("c_lo", "copy", (("pick", "sixteenth_lo", "j"),)),
        Line("p", "mul", ("c", "v")),
        Line("p_rest", "product_rest", ("c", "v", "p")),
        Line("p_lo", "fma", ("c", "h", "p_rest")),
        Line("s", "add", ("c", "p")),
        Line("s_rest", "rest", ("c", "p", "s")),
        Line("c_rest", "fma", ("c_lo", "v", "c_lo")),
        Line("s_lo", "add", ("p_lo", "c_rest")),
        Line("e", "add", ("s_rest", "s_lo")),
        Line("hi", "add", ("s", "e")),
        Line("hi_lo", "rest", ("s", "e", "hi")),
    ]


_FEWER = [  # the same to 2^-42, which binary32 does not feel
    Line("u", "fma", ("x", STEPS, _SHIFT)),
    Line("k", "sub", ("u", _SHIFT)),
    Line("j", "low_index", ("u",)),
    Line("power", "power", ("u",)),
    Line("t", "product_rest", ("k", NEAREST_STEP, "x")),
    Line("q5", "copy", (_SERIES[3],)),
    *(Line(f"q{n}", "fma", (f"q{n + 1}", "t", _SERIES[n - 2])) for n in (4, 3, 2)),
    Line("q1", "fma", ("q2", "t", 1.0)),
    Line("q0", "fma", ("q1", "t", 1.0)),
    Line("c", "mul", (("pick", "sixteenth", "j"), "power")),
    Line("r", "mul", ("q0", "c")),
]

_BELOW = 900  # binades taken off beforehand where exp(-x) may be subnormal


def _subnormal():
    """One rounding, to the last place of the subnormals, by subtracting 2^53 of these; then exact scaling."""
    return [
        *_exponential(_BELOW),
        Line("size", "mul", ("hi", "power")),
        Line("coarse", "less", ("size", 2.0 ** (_BELOW - 1022))),
        Line("grid", "div", (-(2.0 ** (_BELOW - 1021)), "power")),
        Line("round", "select", ("coarse", "grid", 0.0)),
        Line("g", "add", ("round", "hi")),
        Line("g_rest", "rest", ("round", "hi", "g")),
        Line("g_lo", "add", ("g_rest", "hi_lo")),
        Line("rounded", "add", ("g", "g_lo")),
        Line("value", "sub", ("rounded", "round")),
        Line("scaled", "mul", ("value", "power")),
        Line("exact", "mul", ("scaled", 2.0**-_BELOW)),
        Line("small", "select", ("coarse", "hi", 0.0)),  # the flag that exact scaling does not raise
        Line("smaller", "mul", ("small", 2.0**-600)),
        Line("nothing", "mul", ("smaller", "smaller")),
        Line("r", "add", ("exact", "nothing")),
        Line("lo", "copy", (0.0,)),
    ]


_SCALED = 2.0**15  # up to here exp(-x) is also given as a pair and a power of two
_EXP_MANTISSA = Frame(
    "exp_mantissa",
    "exp(-z) 2^m, m by exp_exponent; 0 from 2^15 on",
    (),
    (
        Range(0.0, _SCALED, (*_exponential(0, SHORT_STEP, SHORT_STEP_LO), *result("hi"))),
        Range(_SCALED, inf, tuple(single("copy", 0.0))),
    ),
    (0.0, inf),
    tables=SIXTEENTHS,
)
_EXP_EXPONENT = Frame(
    "exp_exponent",
    "the integer m by which exp_mantissa scales",
    (),
    (
        Range(
            0.0,
            _SCALED,
            (
                Line("u", "fma", ("x", STEPS, _SHIFT)),
                Line("k", "sub", ("u", _SHIFT)),
                Line("j", "low_index", ("u",)),
                Line("sixteenths", "sub", ("k", ("pick", "count", "j"))),
                Line("r", "mul", ("sixteenths", 0.0625)),
                Line("lo", "copy", (0.0,)),
            ),
        ),
        Range(_SCALED, inf, tuple(single("copy", 0.0))),
    ),
    (0.0, inf),
    tables={"count": tuple(float(j) for j in range(16))},
)
SCALED = (_EXP_MANTISSA, _EXP_EXPONENT)

_EXP_MINUS = Frame(
    "exp_minus",
    "exp(-z)",
    (),
    (
        Range(
            0.0,
            _NORMAL,
            (*_exponential(0), Line("r", "mul", ("hi", "power")), Line("lo", "mul", ("hi_lo", "power"))),
            fewer=tuple(_FEWER),
        ),
        Range(_NORMAL, _LAST, tuple(_subnormal())),
        Range(
            _LAST,
            inf,
            (Line("y", "div", (2.0**-1000, "x")), Line("r", "mul", ("y", "y")), Line("lo", "copy", (0.0,))),
            instead=inf,
        ),
    ),
    (0.0, inf),
    tables=SIXTEENTHS,
)


def _like_x(bank):
    """An approximation that is x at 0, and for tiny x."""
    return (
        Line("felt", "at_least", ("x", _TINY)),
        Line("y", "select", ("felt", "x", _TINY)),
        Line("y_lo", "select", ("felt", "x_lo", 0.0)),
        Line("f", "near_pair", (bank, "y", "y_lo")),
        Line("r", "select", ("felt", "f", "x")),
        Line("lo", "select", ("felt", "f_lo", "x_lo")),
    )


_COSINE = (  # sin(pi/2 - x)
    Line("y0", "sub", (HALF_PI[0], "x")),
    Line("y0_rest", "sub", (HALF_PI[0], "y0")),
    Line("y0_lo", "sub", ("y0_rest", "x")),
    Line("minus", "mul", ("x_lo", -1.0)),
    Line("second", "add", ("minus", HALF_PI[1])),
    Line("second_rest", "sum_rest", ("minus", HALF_PI[1], "second")),
    Line("third", "add", ("second_rest", HALF_PI[2])),
    Line("y_off", "add", ("y0_lo", "second")),
    Line("y", "add", ("y0", "y_off")),
    Line("y_rest", "rest", ("y0", "y_off", "y")),
    Line("y_lo", "add", ("y_rest", "third")),
    Line("f", "near_pair", ("sine", "y", "y_lo")),
    *result("f"),
)

_ARCTANGENT_FAR = (  # pi/2 - (y - y^3/3 + ...), y = 1/x; beyond 2^100 the double is that of infinity
    Line("finite", "min", ("x", 2.0**100)),
    Line("lost", "at_least", ("x", 2.0**100)),
    Line("finite_lo", "select", ("lost", 0.0, "x_lo")),
    Line("y", "div", (-1.0, "finite")),
    Line("y_rest", "fma", ("y", "finite", 1.0)),
    Line("y_all", "fma", ("y", "finite_lo", "y_rest")),
    Line("square", "mul", ("y", "y")),
    Line("a9", "copy", (1 / 9,)),
    Line("a7", "fma", ("a9", "square", -1 / 7)),
    Line("a5", "fma", ("a7", "square", 1 / 5)),
    Line("a3", "fma", ("a5", "square", -1 / 3)),
    Line("a", "fma", ("a3", "square", "y_all")),
    Line("s", "add", (HALF_PI[0], "y")),
    Line("s_rest", "rest", (HALF_PI[0], "y", "s")),
    Line("s_lo", "fma", ("y", "a", HALF_PI[1])),
    Line("e", "add", ("s_rest", "s_lo")),
    Line("r", "add", ("s", "e")),
    Line("lo", "rest", ("s", "e", "r")),
)

_TO_HALF_PI = ((-HALF_PI[0], -HALF_PI[1]), HALF_PI[:2])
_ON_A_QUADRANT = (0.0, nextafter(HALF_PI[0], inf))
FRAMES = (
    _EXP_MINUS,
    Frame(
        "sin",
        "sin(x)",
        ("sine",),
        (Range(*_ON_A_QUADRANT, _like_x("sine")),),
        (-HALF_PI[0], HALF_PI[0]),
        "odd",
        pair_domain=_TO_HALF_PI,
    ),
    Frame(
        "cos",
        "cos(x)",
        ("sine",),
        (Range(*_ON_A_QUADRANT, _COSINE),),
        (-HALF_PI[0], HALF_PI[0]),
        "even",
        pair_domain=_TO_HALF_PI,
    ),
    Frame(
        "arctan",
        "arctan(x)",
        ("arctangent", "arctangent_tail"),
        (
            Range(0.0, 3.75, _like_x("arctangent")),
            Range(
                3.75, 63.75, (Line("r", "near_pair", ("arctangent_tail", "x", "x_lo")), Line("lo", "copy", ("r_lo",)))
            ),
            Range(63.75, inf, _ARCTANGENT_FAR),
        ),
        (-inf, inf),
        "odd",
    ),
)
