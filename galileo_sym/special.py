"""The one-variable functions behind the two papers, without overflow, cancellation or iteration, for every argument.

All are dimensionless. Arguments are array-likes; float64 and float32 in, the same out; scalars give scalars. Outside
the domain the result is NaN, with NumPy's 'invalid' floating-point error state; NaN gives NaN without it. All functions
take ``out``, ``where``, ``dtype`` and ``casting`` as NumPy's ufuncs do.

Accuracy, for float64: within 0.55 ulp of the exact result at every point sampled, from the smallest arguments to the
largest (claimed bound: 2 ulp); float32 results are those, rounded to float32 once. The C functions ``gs_special_*`` are
made of the same operations but for fused multiply-adds, which NumPy lacks: one result in some thousands differs in the
last place.
"""

from galileo_sym._front import serve
from galileo_sym.generated.special import FUNCTIONS

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

_DOC = """{summary}

    Parameters
    ----------
    x : array_like
        Dimensionless; {domain}.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        {returned}

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    {source}. Claimed bound: 2 ulp (0.55 at every point sampled).
    """


def _function(name, summary, domain, returned, source):
    def function(x, out=None, where=True, dtype=None, casting="same_kind"):
        return serve(FUNCTIONS[name], (x,), {}, out=out, where=where, dtype=dtype, casting=casting)

    function.__name__ = function.__qualname__ = name
    function.__doc__ = _DOC.format(summary=summary, domain=domain, returned=returned, source=source)
    return function


phi1m = _function(
    "phi1m",
    "phi1(-x) = (1 - exp(-x))/x.",
    "``x >= 0``",
    "1 at 0, decreasing to 0 at infinity.",
    "Equation (29) of the chord paper: the share of a speed that drag leaves, averaged over the time",
)
phi2m = _function(
    "phi2m",
    "phi2(-x) = (x - 1 + exp(-x))/x**2.",
    "``x >= 0``",
    "1/2 at 0, decreasing to 0 at infinity.",
    "Equation (29) of the chord paper: half the share of a distance that drag leaves",
)
descent_factor = _function(
    "descent_factor",
    "tau/x with tau - 1 + exp(-tau) = x**2/2, tau >= 0.",
    "``x >= 0``, the drag coefficient over mass times the descent time without drag",
    "1 at 0, increasing to infinity: the descent time with drag over the one without.",
    "Equations (30), (36), (42) and (43) of the chord paper",
)
flight_factor = _function(
    "flight_factor",
    "T/(2 x) with T = (1 + x)(1 - exp(-T)), T >= 0.",
    "``x >= 0``, k v sin(theta)/g",
    "1 at 0, decreasing to 1/2 at infinity: the flight time with resistance over the one without.",
    "The time of impact by result (3) of the projectile paper",
)
range_factor = _function(
    "range_factor",
    "(1 - exp(-T))/(2 x) with T = (1 + x)(1 - exp(-T)), T >= 0.",
    "``x >= 0``, k v sin(theta)/g",
    "1 at 0, decreasing to 0 at infinity: the range with resistance over the one without.",
    "The range formula of the projectile paper",
)
best_sine = _function(
    "best_sine",
    "x/(exp(s) - 1) with 1 + (s - 1) exp(s) = x**2, s >= 0.",
    "``x >= 0``, k v/g",
    "sqrt(1/2) at 0, decreasing to 0 at infinity: the sine of the angle of greatest range.",
    "Theorem 3 of the projectile paper, both cases in one form",
)
best_angle = _function(
    "best_angle",
    "asin(x/(exp(s) - 1)) with 1 + (s - 1) exp(s) = x**2, s >= 0.",
    "``x >= 0``, k v/g",
    "pi/4 at 0, decreasing to 0 at infinity: the angle of greatest range in rad.",
    "Theorem 3 of the projectile paper",
)
max_range_factor = _function(
    "max_range_factor",
    "sqrt(1 - (1 + s) exp(-s))/x with 1 + (s - 1) exp(s) = x**2, s >= 0.",
    "``x >= 0``, k v/g",
    "1 at 0, decreasing to 0 at infinity: the greatest range over the one without resistance, v**2/g.",
    "Theorem 3 of the projectile paper, put into its range formula",
)
w0_offset = _function(
    "w0_offset",
    "1 + W0(-exp(-1 - x)).",
    "``x >= 0``",
    "0 at 0, of its sign, increasing to 1 at infinity.",
    "Equation (30) of the chord paper, beside the branch point",
)
wm1_offset = _function(
    "wm1_offset",
    "1 + W-1(-exp(-1 - x)).",
    "``x >= 0``",
    "0 at 0, decreasing to -inf at infinity.",
    "The other branch in equation (30) of the chord paper: the root at a negative time",
)
w0 = _function(
    "w0",
    "Principal real branch of the Lambert W function: the w >= -1 with w exp(w) = x.",
    "``x >= -1/e``; the double nearest -1/e lies below it, and gives NaN",
    "0 at 0, of its sign; infinite at infinity.",
    "Result (1) of the projectile paper",
)
wm1 = _function(
    "wm1",
    "Lower real branch of the Lambert W function: the w <= -1 with w exp(w) = x.",
    "``-1/e <= x <= 0``; the double nearest -1/e lies below it, and gives NaN",
    "Decreasing from -1 at the branch point to -inf at 0, there without an error state.",
    "The other real branch in result (1) of the projectile paper",
)
exp_minus = _function(
    "exp_minus",
    "exp(-x).",
    "``x >= 0``",
    "1 at 0, decreasing to 0 at infinity; rounded once where it is subnormal, too.",
    "The decay of every speed with linear drag, equation (29) of the chord paper",
)
sin = _function(
    "sin",
    "Sine.",
    "``|x| <= pi/2``, the double nearest pi/2; an angle in rad",
    "Odd, to the bit.",
    "The angle of a chord, equation (4) of the chord paper, or of elevation",
)
cos = _function(
    "cos",
    "Cosine.",
    "``|x| <= pi/2``, the double nearest pi/2; an angle in rad",
    "Even, to the bit.",
    "The angle of a chord, equation (4) of the chord paper, or of elevation",
)
arctan = _function(
    "arctan",
    "Arctangent.",
    "every real number and infinity",
    "An angle in rad, between the doubles nearest -pi/2 and pi/2; odd, to the bit.",
    "The angle from which friction holds a bead, equation (13) of the chord paper",
)
