"""What the tables of the scaled layer hold: a primitive by its equation, or a curve x(s), f(s), s being the time.

The curves are those of the flight time T at b = k v sin(theta)/g, b = T phi2(-T)/phi1(-T), and of the s of the best
angle, alpha = s sqrt(phi1_slope(s)): both rise with the time, so each x has one f. All is analytic at 0.
"""

from dataclasses import dataclass

from flint import arb

from galileo_sym.verify.proof.approximation_equations import EQUATIONS, Equation, offset_root
from galileo_sym.verify.proof.approximation_functions import (
    Mean,
    cos,
    cosh,
    exp,
    log,
    log_mean,
    phi1,
    phi1_slope,
    phi2,
    sin,
    sqrt,
)

sinh_lag = Mean(lambda w: (exp(w) - exp(-w) - 2 * w) / w / w / w * 0.5, arb(1) / 6, cosh)  # weight (1 - t)^2/2


@dataclass(frozen=True)
class Curve:
    """A table's function by a parameter.

    Attributes
    ----------
    argument, value : callable
        Of the parameter, a series or a disc; the argument rises with it.
    """

    argument: object
    value: object


def _rise(T):
    return T * phi2(-T) / phi1(-T)


def _range_loss(T):
    """-dR/db of R = (1 - exp(-T))/(2 b), with all powers of T cancelled."""
    first, second = phi1(-T), phi2(-T)
    return exp(-T) * sinh_lag(T) * first * first * first / (second * second * phi1_slope(-T))


def _grown_balance(T):
    """b exp(b - T)/(T - b)."""
    return exp(_rise(T) - T) * phi2(-T) / phi1_slope(-T)


def _acot(x, f):
    return x * sin(f) - cos(f), f * (x * cos(f) + sin(f))


def _log1p(x, f):
    return exp(f) - 1 - x, f * exp(f)


def _branch_factor(q, f):
    """exp(-W) at W exp(W) = (q^2/2 - 1)/e: 1 + (v - 1) exp(v) = q^2/2 with v = 1 + W."""
    root, slope = offset_root(1 - log(f), 1)
    return root - q, slope


# a table's name: its equation, or curve
DEFINITIONS = {
    **{name: EQUATIONS[name] for name in ("phi1m", "phi2m", "descent_factor", "flight_factor", "range_factor")},
    **{name: EQUATIONS[name] for name in ("best_angle", "max_range_factor")},
    "wright_omega": EQUATIONS["omega"],
    "w0_offset": EQUATIONS["rise_factor"],
    "wm1_offset": EQUATIONS["fall_factor"],
    "principal": Equation(_branch_factor),
    "acot": Equation(_acot, below=1.6),
    "phi0m": Equation(lambda x, f: (f - exp(-x), f)),
    "log1p": Equation(_log1p, over_x=lambda x, ratio: (ratio - log_mean(x), ratio)),
    "range_loss": Curve(_rise, _range_loss),
    "grown_balance": Curve(_rise, _grown_balance),
    "best_time": Curve(lambda s: s * sqrt(phi1_slope(s)), lambda s: 1 / sqrt(phi1_slope(s))),
}
