"""The one-variable functions behind the two papers, without overflow, cancellation or iteration, for every argument.

All are dimensionless. Arguments are array-likes; float64 and float32 in, the same out; scalars give scalars. Outside
the domain the result is NaN, with NumPy's 'invalid' floating-point error state; NaN gives NaN without it. All functions
take ``out``, ``where``, ``dtype`` and ``casting`` as NumPy's ufuncs do.

Accuracy, for float64: within 0.55 ulp of the exact result at every point sampled, from the smallest arguments to the
largest (claimed bound: 2 ulp); float32 results are those, rounded to float32 once. The C functions ``gs_special_*`` are
made of the same operations but for fused multiply-adds, which NumPy lacks: one result in some thousands differs in the
last place.
"""

from galileo_sym._backend import ufunc

__all__ = [  # noqa: RUF022 (in the order of this module)
    "phi1m",
    "phi2m",
    "descent_factor",
    "flight_factor",
    "range_factor",
    "best_sine",
    "best_angle",
    "max_range_factor",
    "w0_offset",
    "wm1_offset",
    "w0",
    "wm1",
    "exp_minus",
    "sin",
    "cos",
    "arctan",
]

phi1m = ufunc("phi1m")
phi2m = ufunc("phi2m")
descent_factor = ufunc("descent_factor")
flight_factor = ufunc("flight_factor")
range_factor = ufunc("range_factor")
best_sine = ufunc("best_sine")
best_angle = ufunc("best_angle")
max_range_factor = ufunc("max_range_factor")
w0_offset = ufunc("w0_offset")
wm1_offset = ufunc("wm1_offset")
w0 = ufunc("w0")
wm1 = ufunc("wm1")
exp_minus = ufunc("exp_minus")
sin = ufunc("sin")
cos = ufunc("cos")
arctan = ufunc("arctan")
