"""The symbolic moves that derivations are made of, one small module each."""

from .circles import Circle, read_circle, sine_maximum, trace_circle
from .eliminate import eliminate, eliminate_angle
from .implicit import implicit_derivative
from .limits import elementary_limit, limit_by_parameter
from .ode import at_rest, integrate_from_zero, solve_motion, start_of
from .signs import (
    ladder,
    monotone,
    monotone_through,
    not_negative,
    positive_before_root,
    sign_by_factors,
    values_ordered,
)
from .solve import isolate, substitute

__all__ = [
    "Circle",
    "at_rest",
    "elementary_limit",
    "eliminate",
    "eliminate_angle",
    "implicit_derivative",
    "integrate_from_zero",
    "isolate",
    "ladder",
    "limit_by_parameter",
    "monotone", "monotone_through", "not_negative", "positive_before_root",
    "read_circle",
    "sign_by_factors",
    "sine_maximum", "solve_motion",
    "start_of",
    "substitute",
    "trace_circle", "values_ordered",
]  # fmt: skip
