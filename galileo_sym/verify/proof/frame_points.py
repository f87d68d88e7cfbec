"""Ranges at one argument, infinity or 0, where a primitive has a limit: run in binary64, infinities included."""

from fractions import Fraction
from math import inf

from .binary64 import RN, ulp
from .emitted import Call, LookUp, Name
from .reals import table
from .replay import Unproved

# the limits, a real number by its name
LIMITS = {
    ("exp_minus", inf): Fraction(0),
    ("arctan", inf): "pi/2",
    ("w0", inf): inf,
    ("wm1", 0): -inf,
    ("w0_offset", inf): Fraction(1),
    ("wm1_offset", inf): -inf,
    ("best_sine", inf): Fraction(0),
    ("best_angle", inf): Fraction(0),
    ("max_range_factor", inf): Fraction(0),
}
_OPERATIONS = {
    "gs_v_of": lambda a: a,
    "gs_add": lambda a, b: a + b,
    "gs_sub": lambda a, b: a - b,
    "gs_mul": lambda a, b: a * b,
    "gs_div": lambda a, b: a / b,
    "gs_fma": lambda a, b, c: a * b + c,
    "gs_fms": lambda a, b, c: a * b - c,
    "gs_fnma": lambda a, b, c: c - a * b,
    "gs_min": min,
    "gs_rest": lambda a, b, s: _rounded(a - s) + b,
    "gs_product_rest": lambda a, b, p: a * b - p,
}


def _rounded(value):
    return value if isinstance(value, float) else RN(value)


def value_at(function, x):
    """Return what a range gives for one argument: a Fraction, or an infinity as a float.

    Raises
    ------
    Unproved
        If it does more than sums, products, quotients and comparisons, or gives NaN.
    """
    values = {"x": x}

    def value(expression):
        if isinstance(expression, Name):
            return values[expression.name]
        if not isinstance(expression, Call):
            return expression.value
        if expression.operation not in _OPERATIONS:
            raise Unproved(f"{function.name} at {x}: {expression.operation} of an infinity or of 0")
        return _rounded(_OPERATIONS[expression.operation](*map(value, expression.arguments)))

    for name, expression in function.statements:
        if isinstance(expression, LookUp):
            raise Unproved(f"{function.name} at {x}: {expression.function} is looked up")
        values[name] = value(expression)
    return value(function.returned)


def error_at(name, function, x):
    """Return the error at one argument in ulps of the limit there: at most 1/2, and 0 where the limit is a double.

    Raises
    ------
    Unproved
        If the primitive has no limit here, or the result is another.
    """
    limit, found = LIMITS.get((name, x)), value_at(function, x)
    if isinstance(limit, str):
        error = max(abs(end - found) for end in table()[limit]) / ulp(found)
        if error <= Fraction(1, 2):
            return error
    elif limit is not None and found == limit:
        return Fraction(0)
    raise Unproved(f"{function.name}: {found} at {x}, where {limit} is due")
