"""The one-variable functions that are served as they are, in words; dimensionless."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Special:
    """A one-variable function: what it is, where, what it returns, and where it comes from."""

    name: str
    summary: str
    domain: str
    returned: str
    source: str


_TABLE = (
    Special(
        "phi1m",
        "phi1(-x) = (1 - exp(-x))/x.",
        "``x >= 0``",
        "1 at 0, decreasing to 0 at infinity.",
        "Equation (29) of the chord paper: the share of a speed that drag leaves, averaged over the time",
    ),
    Special(
        "phi2m",
        "phi2(-x) = (x - 1 + exp(-x))/x**2.",
        "``x >= 0``",
        "1/2 at 0, decreasing to 0 at infinity.",
        "Equation (29) of the chord paper: half the share of a distance that drag leaves",
    ),
    Special(
        "descent_factor",
        "tau/x with tau - 1 + exp(-tau) = x**2/2, tau >= 0.",
        "``x >= 0``, the drag coefficient over mass times the descent time without drag",
        "1 at 0, increasing to infinity: the descent time with drag over the one without.",
        "Equations (30), (36), (42) and (43) of the chord paper",
    ),
    Special(
        "flight_factor",
        "T/(2 x) with T = (1 + x)(1 - exp(-T)), T >= 0.",
        "``x >= 0``, k v sin(theta)/g",
        "1 at 0, decreasing to 1/2 at infinity: the flight time with resistance over the one without.",
        "The time of impact by result (3) of the projectile paper",
    ),
    Special(
        "range_factor",
        "(1 - exp(-T))/(2 x) with T = (1 + x)(1 - exp(-T)), T >= 0.",
        "``x >= 0``, k v sin(theta)/g",
        "1 at 0, decreasing to 0 at infinity: the range with resistance over the one without.",
        "The range formula of the projectile paper",
    ),
    Special(
        "best_sine",
        "x/(exp(s) - 1) with 1 + (s - 1) exp(s) = x**2, s >= 0.",
        "``x >= 0``, k v/g",
        "sqrt(1/2) at 0, decreasing to 0 at infinity: the sine of the angle of greatest range.",
        "Theorem 3 of the projectile paper, both cases in one form",
    ),
    Special(
        "best_angle",
        "asin(x/(exp(s) - 1)) with 1 + (s - 1) exp(s) = x**2, s >= 0.",
        "``x >= 0``, k v/g",
        "pi/4 at 0, decreasing to 0 at infinity: the angle of greatest range in rad.",
        "Theorem 3 of the projectile paper",
    ),
    Special(
        "max_range_factor",
        "sqrt(1 - (1 + s) exp(-s))/x with 1 + (s - 1) exp(s) = x**2, s >= 0.",
        "``x >= 0``, k v/g",
        "1 at 0, decreasing to 0 at infinity: the greatest range over the one without resistance, v**2/g.",
        "Theorem 3 of the projectile paper, put into its range formula",
    ),
    Special(
        "w0_offset",
        "1 + W0(-exp(-1 - x)).",
        "``x >= 0``",
        "0 at 0, of its sign, increasing to 1 at infinity.",
        "Equation (30) of the chord paper, beside the branch point",
    ),
    Special(
        "wm1_offset",
        "1 + W-1(-exp(-1 - x)).",
        "``x >= 0``",
        "0 at 0, decreasing to -inf at infinity.",
        "The other branch in equation (30) of the chord paper: the root at a negative time",
    ),
    Special(
        "w0",
        "Principal real branch of the Lambert W function: the w >= -1 with w exp(w) = x.",
        "``x >= -1/e``; the double nearest -1/e lies below it, and gives NaN",
        "0 at 0, of its sign; infinite at infinity.",
        "Result (1) of the projectile paper",
    ),
    Special(
        "wm1",
        "Lower real branch of the Lambert W function: the w <= -1 with w exp(w) = x.",
        "``-1/e <= x <= 0``; the double nearest -1/e lies below it, and gives NaN",
        "Decreasing from -1 at the branch point to -inf at 0, there without an error state.",
        "The other real branch in result (1) of the projectile paper",
    ),
    Special(
        "exp_minus",
        "exp(-x).",
        "``x >= 0``",
        "1 at 0, decreasing to 0 at infinity; rounded once where it is subnormal, too.",
        "The decay of every speed with linear drag, equation (29) of the chord paper",
    ),
    Special(
        "sin",
        "Sine.",
        "``|x| <= pi/2``, the double nearest pi/2; an angle in rad",
        "Odd, to the bit.",
        "The angle of a chord, equation (4) of the chord paper, or of elevation",
    ),
    Special(
        "cos",
        "Cosine.",
        "``|x| <= pi/2``, the double nearest pi/2; an angle in rad",
        "Even, to the bit.",
        "The angle of a chord, equation (4) of the chord paper, or of elevation",
    ),
    Special(
        "arctan",
        "Arctangent.",
        "every real number and infinity",
        "An angle in rad, between the doubles nearest -pi/2 and pi/2; odd, to the bit.",
        "The angle from which friction holds a bead, equation (13) of the chord paper",
    ),
)

SPECIAL = {special.name: special for special in _TABLE}
