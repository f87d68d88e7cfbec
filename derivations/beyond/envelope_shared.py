"""What the chapters on the envelope share: the path of a projectile, and points where it touches the envelope."""

from sympy import Derivative, Eq, Equivalent, FiniteSet, Interval, Union, asin, cos, exp, log, sin, sqrt, tan

from galileo_sym.derivations.beyond.notation import sigma, x_e, y_e
from galileo_sym.derivations.projectile.notation import SHOT, alpha, g, k, s, share, t, theta, v, x, y
from galileo_sym.ledger import DerivationError, Domain
from galileo_sym.ledger.equivalence import is_zero

PATH = x_e * tan(theta) + g * x_e / (k * v * cos(theta)) + g / k**2 * log(1 - k * x_e / (v * cos(theta)))
FLIGHT_SLOPE = Derivative(y(t), t) / Derivative(x(t), t)
PERPENDICULAR = v * cos(theta) * Derivative(x(t), t) + v * sin(theta) * Derivative(y(t), t)
SINE = alpha / (exp(s) - 1)

XI = k * x_e / v
ROOT = sqrt(alpha**2 + (1 - alpha**2) * XI**2)
HEIGHT = g / k**2 * (ROOT + log((1 - XI**2) / (1 + ROOT)))

INSIDE = Interval.open(0, 1)


def _flight(left):
    """What the symbols stand for at the elevation with the sine sigma when `left` of the speed is left across."""
    return {
        alpha: k * v / g,
        s: -log(left),
        t: -log(left) / k,
        theta: asin(sigma),
        x_e: v / k * sqrt(1 - sigma**2) * (1 - left),
        y_e: g / k**2 * ((1 + k * v / g * sigma) * (1 - left) + log(left)),
    }


AT_CONTACT = sigma / (sigma + k * v / g)
# all elevations between 0 and pi/2 at all times, the time of contact among them, and at that time
FLYING = Domain({**SHOT, sigma: INSIDE, share: Union(FiniteSet(AT_CONTACT), INSIDE, evaluate=False)}, _flight(share))
TOUCHING = Domain({**SHOT, sigma: INSIDE}, where=_flight(AT_CONTACT))


def sine_of_contact(condition):
    """The sine at which the height at x_e is stationary."""
    told = next(e for e in condition.parts if isinstance(e, Equivalent) and e.has(PATH))
    stationary, there = sorted(told.args, key=lambda e: e.lhs == sin(theta))
    difference = condition.of(Derivative(PATH, theta))
    if stationary != Eq(Derivative(PATH, theta), 0) or is_zero(difference.subs(sin(theta), there.rhs)) is None:
        raise DerivationError(f"{condition.statement} contradicts itself")
    return there.rhs
