"""Contact with the envelope of trajectories: each touches it once, and none passes it."""

import sympy as sp
from sympy import And, Derivative, Eq, Equivalent, Gt, Interval, Lt, acos, atan, cos, exp, log, pi, sin, tan

from galileo_sym.derivations.beyond.envelope_shared import (
    HEIGHT,
    INSIDE,
    PATH,
    PERPENDICULAR,
    ROOT,
    TOUCHING,
    XI,
    sine_of_contact,
)  # fmt: skip
from galileo_sym.derivations.beyond.notation import notation, x_e, y_e
from galileo_sym.derivations.projectile.notation import SHOT, alpha, g, k, s, share, t, theta, v, x, y
from galileo_sym.ledger import Chapter, DerivationError, Domain, UniqueMaximum, tell_chapter
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import compare_on, isolate, monotone, sign_on, trig_box, unique_maximum

chapter = Chapter("beyond.envelope_contact", notation, "Contact with the envelope of trajectories (not printed)")

BELOW = Interval.open(0, pi / 2)
REACHING = Interval.Ropen(0, acos(XI))  # elevations that come as far as x_e
TANGENT = alpha * (1 - XI**2) / (XI * (1 + ROOT))
ANYWHERE = Domain({**SHOT, share: INSIDE}, where={alpha: k * v / g, x_e: share * v / k})
root, here = sp.Dummy("root", positive=True), sp.Dummy("here", positive=True)


def _in_decay(drag_x, parametric, left, place):
    """Sine and cosine of the elevation at which a trajectory touches, in terms of e^(-s) and x_e = place*v/k."""
    upright = sp.Dummy("upright", positive=True)
    sine = sp.factor(parametric.of(sin(theta)).subs(exp(s), 1 / left))
    across = (drag_x.rhs * k / v).subs(exp(-k * t), left).subs(cos(theta), upright)
    return sine, isolate(Eq(place, across, evaluate=False), upright).rhs


def _contact(drag_x, explicit, parametric):
    """The same in terms of x_e = here*v/k and the root alone."""
    return _in_decay(drag_x, parametric, explicit.of(exp(-s)).subs({ROOT: root, x_e: here * v / k}), here)


def _without_alpha(expr):
    """An expression in root and here: alpha^2 from root^2 = alpha^2 + (1 - alpha^2) here^2."""
    return sp.factor(sp.expand(expr).subs(alpha**2, (root**2 - here**2) / (1 - here**2)))


@chapter.derive("beyond.envelope.elevation", Eq(tan(theta), TANGENT), TOUCHING)
def elevation(beyond__envelope__explicit, beyond__envelope__parametric, drag__x):
    """The elevation to be taken so as to come as high as possible at x_e."""
    sine, cosine = _contact(drag__x, beyond__envelope__explicit, beyond__envelope__parametric)
    if sp.cancel(_without_alpha(sine**2 + cosine**2)) != 1:
        raise DerivationError(f"{sine} and {cosine} are not the sine and the cosine of an angle")
    return Eq(tan(theta), sp.factor(sine / cosine).subs({root: ROOT, here: XI}), evaluate=False)


@chapter.derive(
    "beyond.envelope.highest",
    And(
        UniqueMaximum(PATH, theta, REACHING, atan(TANGENT)),
        Eq(PATH.subs(theta, atan(TANGENT)), HEIGHT),
    ),
    ANYWHERE,
)
def highest(
    beyond__envelope__condition,
    beyond__envelope__elevation,
    beyond__envelope__explicit,
    beyond__envelope__parametric,
    drag__x,
):
    """The slope against theta falls through 0 at the elevation of contact: no other trajectory comes as high at x_e."""
    sine, cosine = _contact(drag__x, beyond__envelope__explicit, beyond__envelope__parametric)
    difference = sine_of_contact(beyond__envelope__condition) - sin(theta)
    decay = sp.Dummy("decay", positive=True)
    rest = sp.cancel((beyond__envelope__condition.of(Derivative(PATH, theta)) / difference).subs(exp(s), 1 / decay))
    sign = sign_on(rest, {decay: INSIDE, cos(theta): INSIDE})
    time = isolate(Eq(here, (drag__x.rhs * k / v).subs(exp(-k * t), decay), evaluate=False), decay).rhs
    factor = sp.expand(sp.cancel(difference.subs(exp(s), 1 / decay).subs(decay, time)))
    if sign_on(sp.diff(factor, theta), trig_box(factor, theta, BELOW)) > 0:
        raise DerivationError(f"{factor} does not fall")
    if is_zero(factor.subs({sin(theta): sine, cos(theta): cosine})) is None:
        raise DerivationError(f"{factor} is not 0 where the trajectory touches")
    compare_on(cosine, here, {here: INSIDE})
    place = atan(beyond__envelope__elevation.rhs)
    if is_zero(sp.factor(sine / cosine).subs({root: ROOT, here: XI}) - beyond__envelope__elevation.rhs) is None:
        raise DerivationError(f"{place} is not the elevation of contact")
    rising = monotone(PATH, theta, Interval(0, place), sign)
    falling = monotone(PATH, theta, Interval.Ropen(place, acos(XI)), -sign)
    at_place = {tan(theta): sine / cosine, cos(theta): cosine}
    raised = sp.expand(k**2 * PATH / g).subs(x_e, here * v / k).subs(v, alpha * g / k).subs(at_place)
    flat, power = raised.as_independent(log, as_Add=True)
    top = g / k**2 * (_without_alpha(flat) + log(sp.cancel(power.args[0]))).subs({root: ROOT, here: XI})
    return And(unique_maximum(rising, falling), Eq(PATH.subs(theta, place), top, evaluate=False))


@chapter.derive(
    "beyond.envelope.touches",
    And(
        Eq(Derivative(PATH, x_e), -cos(theta) / sin(theta)),
        Eq(Derivative(HEIGHT, x_e), -cos(theta) / sin(theta)),
        Gt(Derivative(HEIGHT, (x_e, 2)) - Derivative(PATH, (x_e, 2)), 0),
    ),
    TOUCHING,
)
def touches(
    beyond__envelope__path,
    beyond__envelope__slope,
    beyond__envelope__condition,
    beyond__envelope__parametric,
    beyond__envelope__explicit,
    drag__x,
):
    """Both have the slope -cot(theta) there, and the envelope bends away upwards from the trajectory."""
    sine_of_contact(beyond__envelope__condition)
    across, up = sp.symbols("across up", real=True)
    velocity = {Derivative(x(t), t): across, Derivative(y(t), t): up}
    meeting = next(e for e in beyond__envelope__condition.parts if isinstance(e, Equivalent) and e.has(PERPENDICULAR))
    perpendicular = next(e for e in meeting.args if e.lhs != sin(theta)).subs(velocity)
    flight = beyond__envelope__slope.of(Derivative(PATH, x_e)).subs(velocity)
    of_path = flight.subs(up, isolate(perpendicular, up, hide={sin(theta): sp.Dummy("sine", positive=True)}).rhs)
    decay, place = sp.symbols("decay place", positive=True)
    square, height = (
        sp.expand(beyond__envelope__parametric.of(e))
        .subs(exp(-2 * s), decay**2)
        .subs(exp(-s), decay)
        .subs(s, -log(decay))
        for e in (XI**2, k**2 * y_e / g)
    )
    forward = sp.diff(square, decay) / (2 * place)  # d xi/d decay
    of_envelope = sp.cancel(sp.diff(height, decay) / forward) / alpha
    sine, cosine = _in_decay(drag__x, beyond__envelope__parametric, decay, place)
    if is_zero(of_envelope + cosine / sine) is None:
        raise DerivationError(f"the envelope has the slope {of_envelope}, not {-cosine / sine}")
    turn = (sp.diff(of_envelope, decay) + sp.diff(of_envelope, place) * forward) / forward * k / v
    told = beyond__envelope__path.rhs.subs(x(t), x_e)
    path = sp.diff(told, x_e, 2).subs({x_e: place * v / k, cos(theta): cosine})
    over, under = sp.fraction(sp.together((turn - path).subs(v, alpha * g / k)))
    bend = sp.factor(sp.rem(sp.expand(over), place**2 - square, place)) / sp.factor(under)
    envelope = beyond__envelope__explicit.of(y_e)
    apart = Derivative(envelope, (x_e, 2)) - Derivative(told, (x_e, 2))
    return And(
        Eq(Derivative(told, x_e), of_path),
        Eq(Derivative(envelope, x_e), of_path),
        (Gt if sign_on(bend, {decay: INSIDE}) > 0 else Lt)(apart, 0, evaluate=False),
    )


if __name__ == "__main__":
    tell_chapter(chapter.name)
