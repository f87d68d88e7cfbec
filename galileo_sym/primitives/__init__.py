"""The few one-variable functions behind everything: definition, value at any precision, approximation."""

from galileo_sym.multiprecision import mp_value
from galileo_sym.primitives.branches import OF_BRANCHES, branch_factor, w0_offset, wm1_offset
from galileo_sym.primitives.functions import FUNCTIONS as OF_MOTION
from galileo_sym.primitives.functions import (
    Primitive,
    best_angle,
    best_sine,
    best_time,
    descent_factor,
    driving,
    flight_factor,
    max_range_factor,
    phi1,
    phi2,
    range_balance,
    range_factor,
    range_loss,
)

FUNCTIONS = {**OF_MOTION, **OF_BRANCHES}

__all__ = [
    "FUNCTIONS",
    "Primitive",
    "best_angle",
    "best_sine",
    "best_time",
    "branch_factor",
    "descent_factor",
    "driving",
    "flight_factor",
    "max_range_factor",
    "mp_value",
    "phi1",
    "phi2",
    "range_balance",
    "range_factor",
    "range_loss",
    "w0_offset",
    "wm1_offset",
]
