"""The symbolic moves that derivations are made of, one small module each."""

from .angles import Wave, as_wave, solve_angle, undo_arctangent
from .beside import (
    even_at_extremum,
    extremum_between,
    monotone_beside,
    negative_root,
    value_near,
)
from .boxes import box_of, compare_on, sign_by_ladder, sign_on, trig_box, zeros_from_0_on
from .branches import all_preimages
from .circles import Circle, read_circle, sine_maximum, trace_circle
from .composition import compose_monotone, inner_monotone
from .continuity import (
    closed_at_end,
    continuous_inverse,
    continuous_on,
    filled_in,
    limit_inside,
    limit_of_parts,
    limit_of_ratio,
    slope_at_gap,
)
from .eliminate import eliminate, eliminate_angle
from .entire_series import affine_series, divide_series, entire_series, renumber, times_sum, with_tail
from .factors import first_order, introduce, limits_at_zero, twin_at_zero
from .homogeneous import by_differentiation, homogeneous, independent_sides, proportional_below
from .hypotheses import conclusions, everywhere, instantiate, modus_ponens, same_argument
from .implicit import above_end, implicit_derivative
from .inverse import inverse_between, undo
from .known_limits import limit_of_inverse, limit_with_part
from .leading_terms import split_series, take_out, value_at_centre
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
from .motion_series import sum_of_series, taylor_of_motion
from .ode import at_rest, integrate_from_zero, solve_motion, start_of
from .order import same_order
from .reflection import nonzero_along, reflected_beside
from .rescale import rescale
from .resultants import eliminate_one
from .reversion import revert_minimum, taylor
from .roots import (
    above_limit,
    bound_by_end,
    least_value,
    monotone_on_half_line,
    one_root,
    sides_of_root,
    unique_maximum,
)
from .scaled_roots import root_at_scale
from .signs import (
    arguments_reversed,
    ladder,
    ladder_order,
    monotone,
    monotone_by_slope,
    not_negative,
    positive_before_root,
    restricted,
    sign_by_factors,
    values_ordered,
)
from .solve import isolate, substitute, unhide
from .theorems import said_of

__all__ = [
    "Circle",
    "Wave",
    "above_end",
    "above_limit",
    "affine_series",
    "all_preimages",
    "arguments_reversed",
    "as_wave",
    "at_rest",
    "bound_by_end",
    "box_of",
    "by_differentiation",
    "check_root",
    "closed_at_end",
    "compare_on",
    "compose_monotone",
    "conclusions",
    "continuous_inverse",
    "continuous_on",
    "divide_series",
    "elementary_limit",
    "eliminate",
    "eliminate_angle",
    "eliminate_one",
    "entire_series",
    "even_at_extremum",
    "everywhere",
    "extremum_between",
    "filled_in",
    "first_order",
    "homogeneous",
    "implicit_derivative",
    "independent_sides",
    "inner_monotone",
    "instantiate",
    "integrate_from_zero",
    "introduce",
    "inverse_between",
    "isolate",
    "ladder",
    "ladder_order",
    "least_value",
    "limit_along",
    "limit_by_parameter",
    "limit_inside",
    "limit_of_inverse",
    "limit_of_parts",
    "limit_of_ratio",
    "limit_with_part",
    "limits_at_zero",
    "modus_ponens",
    "monotone",
    "monotone_beside",
    "monotone_by_slope",
    "monotone_on_half_line",
    "negative_root",
    "nonzero_along",
    "not_negative",
    "one_root",
    "other_branch",
    "positive_before_root",
    "proportional_below",
    "read_circle",
    "read_coefficients",
    "reflected_beside",
    "renumber",
    "require_real",
    "rescale",
    "restricted",
    "revert_minimum",
    "root_at_scale",
    "root_of_product",
    "said_of",
    "same_argument",
    "same_order",
    "sides_of_root",
    "sign_by_factors",
    "sign_by_ladder",
    "sign_on",
    "simplify_inside",
    "sine_maximum",
    "slope_at_gap",
    "solve_angle",
    "solve_linear_exponential",
    "solve_motion",
    "split_series",
    "start_of",
    "substitute",
    "sum_of_series",
    "take_out",
    "taylor",
    "taylor_of_motion",
    "times_sum",
    "trace_circle",
    "trig_box",
    "twin_at_zero",
    "undo",
    "undo_arctangent",
    "unhide",
    "unique_maximum",
    "value_at_centre",
    "value_near",
    "values_ordered",
    "with_tail",
    "zeros_from_0_on",
]
