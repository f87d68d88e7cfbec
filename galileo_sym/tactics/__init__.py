"""The symbolic moves that derivations are made of, one small module each."""

from .boxes import box_of, compare_on, sign_by_ladder, sign_on, trig_box
from .circles import Circle, read_circle, sine_maximum, trace_circle
from .eliminate import eliminate, eliminate_angle
from .factors import first_order, introduce, limits_at_zero, twin_at_zero
from .implicit import implicit_derivative
from .inverse import inverse_between, undo
from .limits import elementary_limit, limit_along, limit_by_parameter
from .linear_exponential import (
    check_root,
    other_branch,
    read_coefficients,
    require_real,
    root_of_product,
    simplify_inside,
    solve_linear_exponential,
)
from .ode import at_rest, integrate_from_zero, solve_motion, start_of
from .roots import (
    above_limit,
    bound_by_end,
    least_value,
    monotone_on_half_line,
    one_root,
    sides_of_root,
    unique_maximum,
)
from .signs import (
    arguments_reversed,
    ladder,
    monotone,
    monotone_through,
    not_negative,
    positive_before_root,
    sign_by_factors,
    values_ordered,
)
from .solve import isolate, substitute, unhide

__all__ = [
    "Circle",
    "above_limit",
    "arguments_reversed",
    "at_rest",
    "bound_by_end",
    "box_of",
    "check_root",
    "compare_on",
    "elementary_limit",
    "eliminate",
    "eliminate_angle",
    "first_order",
    "implicit_derivative",
    "integrate_from_zero",
    "introduce",
    "inverse_between",
    "isolate",
    "ladder",
    "least_value",
    "limit_along",
    "limit_by_parameter",
    "limits_at_zero",
    "monotone",
    "monotone_on_half_line",
    "monotone_through",
    "not_negative",
    "one_root",
    "other_branch",
    "positive_before_root",
    "read_circle",
    "read_coefficients",
    "require_real",
    "root_of_product",
    "sides_of_root",
    "sign_by_factors",
    "sign_by_ladder",
    "sign_on",
    "simplify_inside",
    "sine_maximum",
    "solve_linear_exponential",
    "solve_motion",
    "start_of",
    "substitute",
    "trace_circle",
    "trig_box",
    "twin_at_zero",
    "undo",
    "unhide",
    "unique_maximum",
    "values_ordered",
]
