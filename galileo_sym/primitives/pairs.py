"""Lines that compute with pairs of doubles, hi + lo: sums, products, quotients, roots and the logarithm.

Each function returns lines that define ``name`` and ``name_lo``, the nearest double and the rest; other names in them
begin with ``name_``. A pair among the arguments is given by the name of its hi. Where its lo is 0, as that of x alone
is, `lines.alone` takes away what serves it.
"""

from mpmath import mp, mpf

from galileo_sym.primitives.lines import Line

LARGEST = float.fromhex("0x1.fffffffffffffp+1023")
_NOT_ZERO = 2.0**-1000  # far below any root that is taken, and added to the divisor of its rest

with mp.workdps(60):
    # 42 bits, so that the products with exponents are exact, and the rest
    LOG_2 = float(mp.floor(mp.log(2) * 2**42)) / 2**42
    LOG_2_LO = float(mp.log(2) - mpf(LOG_2))


def settled(name, high, low):
    """The pair of a sum high + low, abs high >= abs low."""
    return [Line(name, "add", (high, low)), Line(f"{name}_lo", "rest", (high, low, name))]


def add_exact(name, pair, exact):
    """The sum of a pair and a smaller, or any other, exact number."""
    return [
        Line(f"{name}_s", "add", (pair, exact)),
        Line(f"{name}_rest", "sum_rest", (pair, exact, f"{name}_s")),
        Line(f"{name}_off", "add", (f"{name}_rest", f"{pair}_lo")),
        *settled(name, f"{name}_s", f"{name}_off"),
    ]


def scale(name, pair, factor):
    """A pair times a power of two, or its negative."""
    return [Line(name, "mul", (pair, factor)), Line(f"{name}_lo", "mul", (f"{pair}_lo", factor))]


def plus(name, a, b):
    """The sum of two pairs."""
    return [
        Line(f"{name}_s", "add", (a, b)),
        Line(f"{name}_rest", "sum_rest", (a, b, f"{name}_s")),
        Line(f"{name}_los", "add", (f"{a}_lo", f"{b}_lo")),
        Line(f"{name}_off", "add", (f"{name}_rest", f"{name}_los")),
        *settled(name, f"{name}_s", f"{name}_off"),
    ]


def product(name, a, b):
    """The product of two pairs."""
    return [
        Line(f"{name}_h", "mul", (a, b)),
        Line(f"{name}_e0", "product_rest", (a, b, f"{name}_h")),
        Line(f"{name}_e1", "fma", (a, f"{b}_lo", f"{name}_e0")),
        Line(f"{name}_e2", "fma", (b, f"{a}_lo", f"{name}_e1")),
        *settled(name, f"{name}_h", f"{name}_e2"),
    ]


def quotient(name, a, b):
    """The quotient of two pairs."""
    return [
        Line(f"{name}_q", "div", (a, b)),
        Line(f"{name}_e0", "product_rest", (f"{name}_q", b, a)),
        Line(f"{name}_e1", "sub", (f"{a}_lo", f"{name}_e0")),
        Line(f"{name}_e2", "fnma", (f"{name}_q", f"{b}_lo", f"{name}_e1")),
        Line(f"{name}_off", "div", (f"{name}_e2", b)),
        *settled(name, f"{name}_q", f"{name}_off"),
    ]


def inverse(name, b, scaled=1.0):
    """A power of two over a pair; 0 at infinity."""
    return [
        Line(f"{name}_q", "div", (scaled, b)),
        Line(f"{name}_finite", "min", (b, LARGEST)),
        Line(f"{name}_e0", "product_rest", (f"{name}_q", f"{name}_finite", scaled)),
        Line(f"{name}_e1", "fma", (f"{name}_q", f"{b}_lo", f"{name}_e0")),
        Line(f"{name}_minus", "mul", (f"{name}_q", -1.0 / scaled)),
        Line(f"{name}_off", "mul", (f"{name}_minus", f"{name}_e1")),
        *settled(name, f"{name}_q", f"{name}_off"),
    ]


def root(name, a):
    """The square root of a pair, not settled: hi is the root of the pair's hi; 0 of 0."""
    return [
        Line(name, "sqrt", (a,)),
        Line(f"{name}_e0", "product_rest", (name, name, a)),
        Line(f"{name}_e1", "sub", (f"{name}_e0", f"{a}_lo")),
        Line(f"{name}_twice", "fma", (name, -2.0, -_NOT_ZERO)),
        Line(f"{name}_lo", "div", (f"{name}_e1", f"{name}_twice")),
    ]


def logarithm(name, x, scaled=0.0):
    """The logarithm of a pair times 2^-scaled, positive and normal; where it is not near 0, good to 2^-60 of itself."""
    return [
        Line(f"{name}_k0", "exponent", (x,)),
        Line(f"{name}_k", "sub", (f"{name}_k0", scaled)),
        Line(f"{name}_m", "mantissa", (x,)),
        Line(f"{name}_part", "near", ("log", f"{name}_m")),
        Line(f"{name}_whole", "mul", (f"{name}_k", LOG_2)),
        Line(f"{name}_s", "add", (f"{name}_whole", f"{name}_part")),
        Line(f"{name}_rest", "sum_rest", (f"{name}_whole", f"{name}_part", f"{name}_s")),
        Line(f"{name}_off", "fma", (f"{name}_k", LOG_2_LO, f"{name}_part_lo")),
        Line(f"{name}_e", "add", (f"{name}_rest", f"{name}_off")),
        Line(f"{name}_ratio", "div", (f"{x}_lo", x)),
        Line(f"{name}_all", "add", (f"{name}_e", f"{name}_ratio")),
        *settled(name, f"{name}_s", f"{name}_all"),
    ]


def series(name, x, coefficients):
    """A polynomial in x by Horner's rule, in plain arithmetic; defines ``name`` alone."""
    *others, last = coefficients
    lines = [Line(f"{name}_{len(others)}", "copy", (last,))]
    for k in range(len(others) - 1, -1, -1):
        lines.append(Line(f"{name}_{k}" if k else name, "fma", (f"{name}_{k + 1}", x, others[k])))
    return lines


def result(pair, sign=1.0):
    """The pair, or its negative, as the result of a range."""
    if sign < 0:
        return [Line("r", "sub", (0.0, pair)), Line("lo", "sub", (0.0, f"{pair}_lo"))]
    return [Line("r", "copy", (pair,)), Line("lo", "copy", (f"{pair}_lo",))]


def single(operation, *operands):
    """One operation as the result of a range, exact there."""
    return [Line("r", operation, operands), Line("lo", "copy", (0.0,))]
