"""What each primitive is: an equation whose only positive root f is the primitive at x; no W is evaluated.

Each row gives, for x >= 0 and f > 0, the residual (0 where f is the primitive) and f times its derivative with respect
to f, up to sign. Both are analytic at x = 0. The second keeps its sign for all f > 0 unless the row says otherwise, so
the root is unique, and a polynomial in place of f is judged by its residual alone. Definitions: design section 5.
"""

from dataclasses import dataclass

from flint import arb

from galileo_sym.verify.proof.approximation_functions import (
    bump,
    bump_slope,
    cos,
    exp,
    log,
    log_lag,
    log_mean,
    phi1,
    phi1_slope,
    phi2,
    sin,
    sinc,
    sqrt,
)


@dataclass(frozen=True)
class Equation:
    """A primitive's definition.

    Attributes
    ----------
    terms : callable
        Takes x and f; returns the residual and its logarithmic slope, as above.
    least : int
        A lower bound of the primitive on x >= 0 that follows from its definition and is attained at 0; else 0.
    below : float or None
        The root is the only one between 0 and this; None: the only positive one.
    over_x : callable or None
        For a primitive that is 0 at 0: takes x and f/x, on the piece that begins there; no other needs it.
    """

    terms: object
    least: int = 0
    below: float | None = None
    over_x: object = None


def _phi1m(x, f):
    return f - phi1(-x), f


def _phi2m(x, f):
    return f - phi2(-x), f


def _time(x, time):
    """tau = x time with tau - 1 + exp(-tau) = x^2/2, divided by x^2/2; the slope is that with respect to time."""
    return 2 * time * time * phi2(-x * time) - 1, 2 * time * phi1(-x * time)


def _descent_factor(x, f):
    residual, slope = _time(x, f)
    return residual, f * slope


def _rise_factor(x, f):
    """x f = 1 - exp(-tau) = tau - x^2/2, so f is the descent factor less x/2."""
    residual, slope = _time(x, f + x * 0.5)
    return residual, f * slope


def _fall_factor(x, f):
    """With w = log(1 + sigma) = sigma - x^2/2: exp(w) - 1 - w = x^2/2, divided by x^2/2, where x lag = w.

    At a root exp(w) = 1 + x f > 1, so w > 0, where the left side rises.
    """
    lag = f - x * 0.5
    return 2 * lag * lag * phi2(x * lag) - 1, 2 * f * lag * phi1(x * lag)


def _flight_factor(x, f):
    """T = (1 + x)(1 - exp(-T)) is 1 = (1 + x) phi1(-T) or, as phi1(-T) = 1 - T phi2(-T), x phi1(-T) = T phi2(-T)."""
    T = 2 * x * f
    return 2 * f * phi2(-T) - phi1(-T), 2 * f * (1 + x) * phi1_slope(-T)


def _range_factor(x, f):
    """1 - exp(-T) = T/(1 + x): the flight factor over 1 + x."""
    return _flight_factor(x, (1 + x) * f)


def _grown_loss(x, f):
    """With the flight factor F = 1 - x G it is 2 (1 - x G)(1 - (1 + 2 x) G)/(1 - 2 x G): a quadratic equation for G.

    G in 2 F phi2(-T) = phi1(-T), divided by x, as phi1(w) = 2 phi2(w) + w bump(w): that has one root T > 0, T = 2 x F.
    """
    half = 1 + 3 * x - x * f
    root = sqrt(half * half - 2 * x * (1 + 2 * x) * (2 - f))
    G = (2 - f) / (half + root)
    F = 1 - x * G
    w = -2 * x * F
    slope = -phi2(w) - x * bump(w) + 2 * x * x * (F * bump_slope(w) - G * bump(w))
    return F * bump(w) - G * phi2(w), f * slope * (1 - 2 * x * G) / root * -0.5


def _grown_balance(x, f):
    """With F = 1 - lack the balance is (1 - x + 2 x lack)/((1 + x)(1 - 2 lack)); times x what the loss is put into."""
    balance = (1 + x) * f * exp(-x)
    lack = (balance - 1 + x) / (2 * (x + balance))
    w = -2 * x * (1 - lack)
    slope = -phi2(w) - x * bump(w) + 2 * x * (x * (1 - lack) * bump_slope(w) - lack * bump(w))
    return x * (1 - lack) * bump(w) - lack * phi2(w), balance * slope / (2 * (x + balance) * (x + balance))


def _grown_loss_tail(x, f):
    """The same for large x, in D = T - x: (1 + 2 x) D^2 + 2 x^2 (1 - f) D = x^2, and D = 1 - (1 + x) exp(-x - D)."""
    root = sqrt((1 - f) * (1 - f) + (1 + 2 * x) / (x * x))
    D = 1 / (1 - f + root)
    decay = (1 + x) * exp(-x - D)
    return D - 1 + decay, f * (1 - decay) * D / root


def _grown_balance_tail(x, f):
    """The same for large x, in D = T - x = x/(x + balance), for f = x exp(-D)/D; the slope is D^2."""
    total = x + (1 + x) * f * exp(-x)
    D = x / total
    return log(f) + D - log(total), D * D


def _best_sine(x, f):
    """exp(s) = 1 + y with y = x/f turns 1 + (s - 1) exp(s) = x^2 into (1 + y) log(1 + y) - y = (f y)^2."""
    y = x / f
    return 1 - log_lag(y) / (f * f), log_mean(y) / (f * f)


def _best_angle(x, f):
    """The sine of f is the best sine; the slope keeps its sign for 0 < f < pi/2."""
    sine = sin(f)
    residual, slope = _best_sine(x, sine)
    return residual, slope * f * cos(f) / sine


def _max_range_factor(x, f):
    """(1 + s) exp(-s) = 1 - (x f)^2 and (x^2 - 1) exp(-s) = s - 1 give s^2 = x^2 + (1 - x^2)(x f)^2 as product.

    That s, which the quotient of the two then satisfies, is put into the first, divided by x^2. As
    (1 - x^2) exp(-s) <= 1 the slope is at least f^2.
    """
    square = 1 + (1 - x * x) * f * f
    s = x * sqrt(square)
    return square * phi1_slope(-s) - f * f, f * f * (2 - (1 - x * x) * exp(-s))


def offset_root(v, sign):
    """Return sqrt(2 (1 + (v - 1) exp(v))) with a sign, and its derivative: it rises with v through 0."""
    root = sqrt(2 * phi1_slope(v))
    return sign * v * root, exp(v) / root


def _w0_ratio(x, f):
    """f = W/X = exp(-W) with X = x^2 - 1/e, v = 1 + W: 1 + (v - 1) exp(v) = e x^2, whose root rises with v.

    v < 0, the other branch, would make x < 0.
    """
    root, slope = offset_root(1 - log(f), 1)
    return root - (2 * arb(1).exp()).sqrt() * x, slope


def _wm1_branch(x, f):
    """f = -W with X = x^2 - 1/e, v = 1 - f: as for the ratio of the other branch, with x for -x."""
    root, slope = offset_root(1 - f, -1)
    return root - (2 * arb(1).exp()).sqrt() * x, f * slope


def _wm1_middle(x, f):
    """f exp(-f) = x with f > 1."""
    return f - log(f) + log(x), f - 1


def _log(x, f):
    return exp(f) - x, f * exp(f)


def _fall_log(x, f):
    """f = log(1 + sigma) is exp(f) = 1 + exp(x) + f, divided by exp(x); it is convex and 0 < exp(x) at f = 0."""
    return exp(f - x) - 1 - (1 + f) * exp(-x), f * (exp(f - x) - exp(-x))


def _omega(x, f):
    return f + log(f) - x, f + 1


def _sine(x, f):
    return f - sin(x), f


def _sine_over_x(x, ratio):
    return ratio - sinc(x), ratio


def _arctangent(x, f):
    """The tangent of f is x; the slope keeps its sign for 0 < f < pi/2."""
    return sin(f) - x * cos(f), f * (cos(f) + x * sin(f))


def _arctangent_over_x(x, ratio):
    f = x * ratio
    return ratio * sinc(f) - cos(f), ratio * (cos(f) + x * sin(f))


EQUATIONS = {
    "phi1m": Equation(_phi1m),
    "phi2m": Equation(_phi2m),
    "descent_factor": Equation(_descent_factor, least=1),  # x^2/2 = tau - 1 + exp(-tau) <= tau^2/2
    "flight_factor": Equation(_flight_factor),
    "range_factor": Equation(_range_factor),
    "grown_loss": Equation(_grown_loss),
    "grown_loss_tail": Equation(_grown_loss_tail),
    "grown_balance": Equation(_grown_balance),
    "grown_balance_tail": Equation(_grown_balance_tail),
    "best_sine": Equation(_best_sine),
    "best_angle": Equation(_best_angle, below=1.5),
    "max_range_factor": Equation(_max_range_factor),
    "w0_ratio": Equation(_w0_ratio),
    "rise_factor": Equation(_rise_factor),
    "fall_factor": Equation(_fall_factor, least=1),  # x^2/2 = sigma - log(1 + sigma) <= sigma^2/2
    "wm1_branch": Equation(_wm1_branch, least=1),
    "wm1_middle": Equation(_wm1_middle, least=1),
    "fall_log": Equation(_fall_log),
    "log": Equation(_log),
    "omega": Equation(_omega),
    "sine": Equation(_sine, over_x=_sine_over_x),
    "arctangent": Equation(_arctangent, below=1.5625, over_x=_arctangent_over_x),
}
