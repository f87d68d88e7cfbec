"""Stable forms of the projectile formulas: the value without resistance times a factor of one dimensionless number."""

import sympy as sp
from sympy import Eq, Interval, Lt, Tuple, asin, cos, exp, pi, sin

from galileo_sym.derivations.projectile.notation import R, alpha, g, k, notation, t, theta, theta_max, u, v, x, y
from galileo_sym.ledger import POSITIVE, Chapter, DerivationError, Domain, step, tell_chapter
from galileo_sym.primitives import best_angle, best_sine, flight_factor, phi1, phi2, range_factor
from galileo_sym.tactics import introduce, isolate

chapter = Chapter("stable.projectile", notation, "stable forms (not printed)")

ANGLES = {theta: Interval.Lopen(0, pi / 2)}
SHOT = {g: POSITIVE, v: POSITIVE}
FREE = Domain({**SHOT, **ANGLES})
DRAG = Domain({**SHOT, k: POSITIVE, **ANGLES})
FLIGHT = Domain({**SHOT, t: POSITIVE, **ANGLES})
DRAG_FLIGHT = Domain({**SHOT, k: POSITIVE, t: POSITIVE, **ANGLES})

B = k * v * sin(theta) / g
TIME = 2 * v * sin(theta) / g
REACH = 2 * v**2 * sin(theta) * cos(theta) / g
ACROSS = v * t * cos(theta)
UP = v * t * sin(theta)


@chapter.derive("stable.projectile.flight_time.free", Eq(t, TIME), FREE)
def flight_free(nodrag__impact):
    """Nothing cancels."""
    return Eq(t, nodrag__impact.of(t))


@chapter.derive("stable.projectile.flight_time.drag", Eq(t, TIME * flight_factor(B)), DRAG)
def flight_drag(impact__time, def__u):
    """W is taken out of the impact time by the factor at b = -1 - u."""
    number = sp.expand(-1 - def__u.of(u))
    step("b", Eq(u, -1 - number))
    return Eq(t, introduce(impact__time.of(t).subs(u, def__u.of(u)), flight_factor(number)))


@chapter.derive("stable.projectile.horizontal_range.free", Eq(R(theta), REACH), FREE)
def range_free(nodrag__range):
    """Nothing cancels: the first of the printed forms."""
    return next(e for e in nodrag__range.parts if not e.rhs.has(2 * theta))


@chapter.derive("stable.projectile.horizontal_range.drag", Eq(R(k, theta), REACH * range_factor(B)), DRAG)
def range_drag(range__full):
    """W is taken out of the range formula by the factor at b."""
    return Eq(R(k, theta), sp.factor(introduce(range__full.of(R(k, theta)), range_factor(B))))


@chapter.derive("stable.projectile.position.free", Eq(Tuple(x(t), y(t)), Tuple(ACROSS, UP - g * t**2 / 2)), FLIGHT)
def position_free(nodrag__x, nodrag__y):
    """Nothing cancels but at landing, where the height is 0."""
    return Eq(Tuple(x(t), y(t)), Tuple(nodrag__x.rhs, nodrag__y.rhs))


@chapter.derive(
    "stable.projectile.position.drag",
    Eq(Tuple(x(t), y(t)), Tuple(ACROSS * phi1(-k * t), UP * phi1(-k * t) - g * t**2 * phi2(-k * t))),
    DRAG_FLIGHT,
)
def position_drag(drag__x, drag__y):
    """The exponential is taken out by phi1 from the terms in v, by phi2 from those in g."""
    height = sp.expand(drag__y.rhs)
    launched, fallen = height.coeff(v) * v, height.coeff(v, 0)
    terms = ((drag__x.rhs, phi1), (launched, phi1), (fallen, phi2))
    across, up, down = (introduce(e, factor(-k * t), closed=exp) for e, factor in terms)
    return Eq(Tuple(x(t), y(t)), Tuple(across, up + down))


@chapter.derive("stable.projectile.best_angle", Eq(theta_max, best_angle(alpha)), Domain({alpha: POSITIVE}))
def angle_of_largest_range(support__unified_thm3, thm2__c):
    """W is taken out of the sine of theta_max by best_sine, alpha = 1 included; theta_max < pi/4 is its arcsine."""
    sine = sp.Dummy("sine", positive=True)
    bound = thm2__c.statement
    if not (isinstance(bound, Lt) and bound.lhs == theta_max and bound.rhs <= pi / 2):
        raise DerivationError(f"{bound} does not say that theta_max is acute")
    named = introduce(support__unified_thm3.of(sin(theta_max)), best_sine(alpha))
    step("sine", Eq(sin(theta_max), named))
    obtuse = {pi - asin(sine): "theta_max is acute"}
    angle = isolate(Eq(sin(theta_max), sine), theta_max, drop=obtuse).rhs.subs(sine, named)
    step("arcsine", Eq(theta_max, angle))
    return Eq(theta_max, angle.subs(best_angle(alpha).rewrite(asin), best_angle(alpha)))


if __name__ == "__main__":
    tell_chapter(chapter.name)
