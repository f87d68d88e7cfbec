"""What the chapters on the envelope share: the path of a projectile, and points where it touches the envelope."""

from sympy import Derivative, Eq, Equivalent, FiniteSet, Interval, Union, asin, cos, exp, log, sin, sqrt, tan

from galileo_sym.derivations.beyond.notation import part, x_e, y_e
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

# points of contact by what is left of the speed there, share/(1 + alpha): all of the envelope but its foot theta = pi/2
SPEED_LEFT = share / (1 + k * v / g)
SINE_THERE = k * v / g * SPEED_LEFT / (1 - SPEED_LEFT)


def contact(sine=SINE_THERE):
    """What the symbols stand for where the trajectory with the sine `sine` is at the time of contact."""
    return {
        alpha: k * v / g,
        s: -log(SPEED_LEFT),
        t: -log(SPEED_LEFT) / k,
        theta: asin(sine),
        x_e: v / k * sqrt(1 - sine**2) * (1 - SPEED_LEFT),
        y_e: g / k**2 * ((1 + k * v / g * sine) * (1 - SPEED_LEFT) + log(SPEED_LEFT)),
    }


INSIDE = Interval.open(0, 1)
TOUCHING = Domain({**SHOT, share: INSIDE}, where=contact())
# the trajectories that touch, and flatter ones at the time when that one does
ABOUT = Domain({**SHOT, share: INSIDE, part: Union(FiniteSet(1), INSIDE, evaluate=False)}, contact(part * SINE_THERE))


def sine_of_contact(condition):
    """The sine at which the height at x_e is stationary."""
    told = next(e for e in condition.parts if isinstance(e, Equivalent) and e.has(PATH))
    stationary, there = sorted(told.args, key=lambda e: e.lhs == sin(theta))
    difference = condition.of(Derivative(PATH, theta))
    if stationary != Eq(Derivative(PATH, theta), 0) or is_zero(difference.subs(sin(theta), there.rhs)) is None:
        raise DerivationError(f"{condition.statement} contradicts itself")
    return there.rhs
