"""Stable forms of the projectile formulas: the value without resistance times a factor of one dimensionless number."""

import sympy as sp
from sympy import Derivative, Eq, Interval, LambertW, Limit, Lt, Tuple, asin, cos, exp, pi, sin

from galileo_sym.derivations.projectile.notation import (
    SLOPE,
    TRIAL,
    R,
    U,
    Y,
    alpha,
    g,
    k,
    notation,
    t,
    theta,
    theta_max,
    u,
    v,
    x,
    y,
)  # fmt: skip
from galileo_sym.ledger import POSITIVE, Chapter, DerivationError, Domain, UniqueMaximum, step, tell_chapter
from galileo_sym.primitives import (
    best_angle,
    best_sine,
    flight_factor,
    max_range_factor,
    phi1,
    phi2,
    range_balance,
    range_factor,
    range_loss,
)
from galileo_sym.tactics import elementary_limit, introduce, isolate, limit_with_part

chapter = Chapter("stable.projectile", notation, "stable forms (not printed)")

ANGLES = {theta: Interval.Lopen(0, pi / 2)}
SHOT = {g: POSITIVE, v: POSITIVE}
FREE = Domain({**SHOT, **ANGLES})
DRAG = Domain({**SHOT, k: POSITIVE, **ANGLES})
FLIGHT = Domain({**SHOT, t: POSITIVE, **ANGLES})
DRAG_SLOPE = Domain({**SHOT, k: POSITIVE, **ANGLES}, where=TRIAL)
DRAG_FLIGHT = Domain({**SHOT, k: POSITIVE, t: POSITIVE, **ANGLES})

B = k * v * sin(theta) / g
TIME = 2 * v * sin(theta) / g
REACH = 2 * v**2 * sin(theta) * cos(theta) / g
ACROSS = v * t * cos(theta)
UP = v * t * sin(theta)
BEST_SHOT = Domain(SHOT, where={R(pi / 4): REACH.subs(theta, pi / 4)})
W_BEST = LambertW(((k * v / g) ** 2 - 1) * exp(-1))
LARGEST = v / k * sp.sqrt(1 - (2 + W_BEST) * exp(-1 - W_BEST))  # for trials, by beyond.inverse.largest


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


@chapter.derive(
    "stable.projectile.velocity.free",
    Eq(Tuple(x(t).diff(t), y(t).diff(t)), Tuple(v * cos(theta), v * sin(theta) - g * t)),
    FLIGHT,
)
def velocity_free(nodrag__x, nodrag__y):
    """Nothing cancels but at the apex, where the upward velocity is 0."""
    return Eq(Tuple(x(t).diff(t), y(t).diff(t)), Tuple(*(sp.diff(place.rhs, t) for place in (nodrag__x, nodrag__y))))


@chapter.derive(
    "stable.projectile.velocity.drag",
    Eq(
        Tuple(x(t).diff(t), y(t).diff(t)),
        Tuple(v * cos(theta) * exp(-k * t), v * sin(theta) * exp(-k * t) - g * t * phi1(-k * t)),
    ),
    DRAG_FLIGHT,
)
def velocity_drag(drag__vx, drag__vy):
    """What is launched fades by the exponential; it is taken out by phi1 from the term in g."""
    up = sp.expand(drag__vy.rhs)
    fallen = introduce(up.coeff(v, 0), phi1(-k * t), closed=exp)
    return Eq(Tuple(x(t).diff(t), y(t).diff(t)), Tuple(drag__vx.rhs, up.coeff(v) * v + fallen))


SLOPE_FREE = 2 * v**2 / g * (cos(theta) ** 2 - sin(theta) ** 2)


@chapter.derive("stable.projectile.range_slope_theta.free", Eq(Derivative(R(theta), theta), SLOPE_FREE), FREE)
def range_slope_free(nodrag__range):
    """Nothing cancels but at pi/4, where the range is largest."""
    length = next(e for e in nodrag__range.parts if not e.rhs.has(2 * theta)).rhs
    return Eq(Derivative(R(theta), theta), sp.factor_terms(sp.diff(length, theta)), evaluate=False)


def in_factors(slope, lemma_b, definitions):
    """A slope of the range by the Lemma, with range_factor and range_balance at b in place of y(u) and its slope."""
    number, at = sp.Dummy("b", positive=True), definitions.of(U(k, theta))
    put = {number: sp.expand(-1 - at)}
    step("b", Eq(u, -1 - put[number], evaluate=False))
    height = definitions.of(Y)
    steep, share = (
        sp.simplify(introduce(form.subs(Y, height).subs(u, -1 - number), factor(number))).subs(put)
        for form, factor in ((lemma_b.of(SLOPE), range_balance), (1 - Y / u, range_factor))
    )
    step("the slope of y", Eq(SLOPE, steep, evaluate=False))
    step("the share of the range", Eq(1 - Y / u, share, evaluate=False))
    return slope.subs(SLOPE, steep).subs(Y, u * (1 - share))


@chapter.derive(
    "stable.projectile.range_slope_theta.drag",
    Eq(
        Derivative(R(k, theta), theta),
        2 * v**2 / g * range_factor(B) * (cos(theta) ** 2 * range_balance(B) - sin(theta) ** 2),
    ),
    DRAG_SLOPE,
)
def range_slope_drag(lemma__f, lemma__b, def__uyR):
    """Lemma (f) with W taken out of y and dy/du at b; what is left cancels at theta_max alone."""
    slope = in_factors(lemma__f.rhs, lemma__b, def__uyR)
    return Eq(lemma__f.lhs, sp.factor(slope), evaluate=False)


@chapter.derive(
    "stable.projectile.range_slope_k.drag",
    Eq(Derivative(R(k, theta), k), -REACH * v * sin(theta) / g * range_loss(B)),
    DRAG_SLOPE,
    premises=(
        *("projectile.lemma.e", "projectile.lemma.b", "projectile.def.uyR"),
        *("stable.projectile.horizontal_range.drag", "stable.range_loss"),
    ),
)
def range_loss_drag(lemma_e, lemma_b, definitions, length, loss):
    """Lemma (e) in the same way; 1 - range_balance, which cancels for small k, is in range_loss. The slope of the
    stable range agrees.
    """
    slope = in_factors(lemma_e.rhs, lemma_b, definitions)
    closed, name = range_loss(B).rewrite(range_balance), range_factor(B)
    (factor,) = sp.solve(closed - range_loss(B), name)
    found = sp.simplify(slope.subs(name, factor))
    if found.has(range_balance):
        raise DerivationError(f"{slope} is not a multiple of {closed}")
    (number,) = loss.rhs.args
    shared = sp.Dummy("share")
    outer = length.rhs.subs(name, shared)
    inner = -loss.of(-Derivative(range_factor(number), number)).subs(number, B) * sp.diff(B, k)
    again = step("the slope of the stable range", Eq(lemma_e.lhs, sp.diff(outer, shared) * inner, evaluate=False))
    if outer.has(k) or sp.simplify(found - again.rhs) != 0:
        raise DerivationError(f"{found} is not the slope of {length.rhs}")
    return Eq(lemma_e.lhs, found, evaluate=False)


@chapter.derive(
    "stable.projectile.range_slope_k.free",
    Eq(Limit(Derivative(R(k, theta), k), k, 0, "+"), -REACH * v * sin(theta) / g * sp.Rational(4, 3)),
    Domain({**SHOT, **ANGLES}, where=TRIAL),
    premises=("stable.projectile.range_slope_k.drag", "stable.at-zero.range_loss"),
)
def range_loss_free(slope, at_zero):
    """Of what depends on k, range_loss alone is left where the resistance vanishes: its limit."""
    told = next(e for e in at_zero.parts if not e.lhs.has(Derivative))
    form, number, place, _ = told.lhs.args
    if form != range_loss(number).rewrite(LambertW) or elementary_limit(B, k, 0) != place:
        raise DerivationError(f"{told} is not the limit of {range_loss(B)}")
    value = limit_with_part(slope.rhs, range_loss(B), told.rhs, k, 0)
    return Eq(Limit(slope.lhs, k, 0, "+"), value, evaluate=False)


@chapter.derive("stable.projectile.max_range.free", Eq(R(pi / 4), v**2 / g), BEST_SHOT)
def max_range_free(nodrag__claim__max_pi4):
    """Nothing cancels: the range at the place of its maximum."""
    place = next(e for e in nodrag__claim__max_pi4.parts if isinstance(e, UniqueMaximum)).args[3]
    return Eq(R(place), nodrag__claim__max_pi4.of(R(place)))


@chapter.derive(
    "stable.projectile.max_range.drag",
    Eq(R(k, theta_max), v**2 / g * max_range_factor(k * v / g)),
    Domain({**SHOT, k: POSITIVE}, where={R(k, theta_max): LARGEST}),
)
def max_range_drag(beyond__inverse__largest, def__alpha):
    """The square of k R/v is that of the factor times alpha, but for a number."""
    largest, factor = beyond__inverse__largest, max_range_factor(alpha)
    square = (alpha * factor).rewrite(LambertW) ** 2
    rest = sp.simplify(sp.expand(largest.rhs) / sp.expand(square))
    if rest.free_symbols:
        raise DerivationError(f"{largest.rhs} is not proportional to {square}")
    share = step("the share of v/k", Eq(k * R(k, theta_max) / v, sp.sqrt(rest) * alpha * factor, evaluate=False))
    return Eq(R(k, theta_max), (v / k * share.rhs).subs(alpha, def__alpha.of(alpha)), evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
