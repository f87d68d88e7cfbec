"""The few one-variable functions behind everything: definition, value at any precision, approximation."""

from galileo_sym.primitives.functions import (
    FUNCTIONS,
    Primitive,
    best_angle,
    best_sine,
    descent_factor,
    driving,
    flight_factor,
    phi1,
    phi2,
    range_factor,
)
from galileo_sym.primitives.multiprecision import mp_value

__all__ = [
    "FUNCTIONS",
    "Primitive",
    "best_angle",
    "best_sine",
    "descent_factor",
    "driving",
    "flight_factor",
    "mp_value",
    "phi1",
    "phi2",
    "range_factor",
]
