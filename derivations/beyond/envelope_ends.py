"""The envelope of trajectories where it begins and ends, and without resistance: the parabola of safety."""

import sympy as sp
from sympy import And, Derivative, Eq, Equivalent, Interval, Limit, cos, exp, log, pi, sin, tan

from galileo_sym.derivations.beyond.envelope_shared import HEIGHT, PERPENDICULAR, XI, sine_of_contact
from galileo_sym.derivations.beyond.notation import notation, x_e, y_e
from galileo_sym.derivations.projectile.notation import (
    SHOT,
    TRIAL_RANGE,
    R,
    StationaryAngle,
    alpha,
    g,
    k,
    s,
    t,
    theta,
    theta_max,
    v,
    x,
    y,
)  # fmt: skip
from galileo_sym.derivations.projectile.shared import W_a
from galileo_sym.ledger import POSITIVE, Chapter, DerivationError, Domain, tell_chapter
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import elementary_limit, eliminate_one, isolate

chapter = Chapter("beyond.envelope_ends", notation, "The ends of the envelope, and no resistance (not printed)")

PARABOLA = v**2 / (2 * g) - g * x_e**2 / (2 * v**2)
BELOW = Interval.open(0, pi / 2)
LEFT = exp(-1 - W_a)
AT_GROUND = Domain(
    SHOT,
    where={
        alpha: k * v / g,
        s: 1 + W_a,
        t: (1 + W_a) / k,
        theta_max: StationaryAngle(k * v / g),
        theta: theta_max,
        R(k, theta): TRIAL_RANGE,
        x_e: v / k * sp.sqrt((1 - LEFT) ** 2 - alpha**2 * LEFT**2),
        y_e: g / k**2 * (-W_a + (alpha**2 - 1) * LEFT),
        x(t): v * cos(theta) * (1 - exp(-k * t)) / k,
        y(t): ((g / k + v * sin(theta)) * (1 - exp(-k * t)) - g * t) / k,
    },
)


@chapter.derive(
    "beyond.envelope.ground",
    And(
        Eq(y_e, 0),
        Eq(x_e, R(k, theta_max)),
        Eq(PERPENDICULAR.subs(theta, theta_max), 0),
    ),
    AT_GROUND,
)
def ground(beyond__envelope__parametric, beyond__envelope__condition, support__kT_at_max, beyond__inverse__largest):
    """The envelope comes down at the largest range, where the flight ends at a right angle to its launch."""
    known = {alpha**2: support__kT_at_max.of(alpha**2)}
    height, square = (sp.expand(beyond__envelope__parametric.of(e)).subs(known) for e in (k**2 * y_e / g, XI**2))
    length = sp.Dummy("length", positive=True)
    at_time = sp.simplify(square).subs(s, support__kT_at_max.of(s))
    if is_zero(at_time - beyond__inverse__largest.rhs) is None:
        raise DerivationError(f"{at_time} is not {beyond__inverse__largest.rhs}")
    place = isolate(Eq(XI**2, beyond__inverse__largest.lhs.subs(R(k, theta_max), length), evaluate=False), x_e).rhs
    if is_zero(support__kT_at_max.of(sin(theta_max)) - sine_of_contact(beyond__envelope__condition)) is None:
        raise DerivationError("the sine of theta_max is not that of contact")
    meeting = next(e for e in beyond__envelope__condition.parts if isinstance(e, Equivalent) and e.has(PERPENDICULAR))
    perpendicular = next(e for e in meeting.args if e.lhs != sin(theta)).subs(theta, theta_max)
    landing = Eq(y_e, sp.simplify(height) * g / k**2, evaluate=False)
    return And(
        landing,
        Eq(x_e, place.subs(length, R(k, theta_max))),
        perpendicular,
    )


@chapter.derive(
    "beyond.envelope.foot",
    Eq(Limit(HEIGHT, x_e, 0, "+"), g / k**2 * (alpha - log(1 + alpha))),
    Domain({**SHOT}, where={alpha: k * v / g}),
)
def foot(beyond__envelope__explicit, drag__y, def__alpha):
    """Above the launch it is as high as a vertical shot comes, where the velocity is 0."""
    height, left = drag__y.rhs.subs(theta, pi / 2), sp.Dummy("left", positive=True)
    at_rest = Eq(sp.diff(height, t).subs(exp(-k * t), left), 0, evaluate=False)
    top = height.subs(exp(-k * t), left).subs(t, -log(left) / k).subs(left, isolate(at_rest, left).rhs)
    limit = elementary_limit(beyond__envelope__explicit.of(y_e), x_e, 0)
    difference = (top - limit).subs(v, isolate(def__alpha.equation, v).rhs)
    if sp.simplify(sp.expand_log(sp.simplify(difference))) != 0:
        raise DerivationError(f"the envelope begins at {limit}, a vertical shot comes up to {top}")
    return Eq(Limit(HEIGHT, x_e, 0, "+"), limit, evaluate=False)


@chapter.derive(
    "beyond.envelope.safety",
    And(Eq(tan(theta), v**2 / (g * x_e)), Eq(y_e, PARABOLA), Eq(Derivative(PARABOLA, x_e), -1 / tan(theta))),
    Domain(
        {g: POSITIVE, v: POSITIVE, theta: BELOW},
        where={x_e: v**2 / (g * tan(theta)), y_e: v**2 / (2 * g) * (1 - 1 / tan(theta) ** 2)},
    ),
)
def safety(nodrag__claim__parabola):
    """Without resistance: eliminate tan(theta) from the path and its derivative. At x_e = 0 all trajectories meet."""
    tangent = sp.Symbol("tangent", positive=True)
    path = nodrag__claim__parabola.rhs.subs(x(t), x_e)
    path = sp.expand(path.subs(cos(theta), 1 / sp.sqrt(1 + tangent**2)).subs(tan(theta), tangent))
    stationary = sp.diff(path, tangent)
    found = eliminate_one(path - y_e, stationary, tangent, (x_e, y_e), {x_e: "x_e > 0 beyond the launch"})
    envelope = isolate(found, y_e)
    steep = isolate(Eq(stationary, 0, evaluate=False), tangent).rhs
    slope = sp.diff(envelope.rhs, x_e).subs(x_e, isolate(Eq(tangent, steep, evaluate=False), x_e).rhs)
    return And(
        Eq(tan(theta), steep),
        envelope,
        Eq(Derivative(sp.expand(envelope.rhs), x_e), slope.subs(tangent, tan(theta)), evaluate=False),
    )


@chapter.derive(
    "beyond.envelope.no-resistance",
    Eq(Limit(HEIGHT.subs(alpha, k * v / g), k, 0, "+"), PARABOLA),
    Domain({g: POSITIVE, v: POSITIVE, x_e: POSITIVE}),
)
def no_resistance(beyond__envelope__explicit, def__alpha, beyond__envelope__safety):
    """As k goes to 0 the envelope goes to the parabola of safety."""
    height = beyond__envelope__explicit.of(y_e).subs(alpha, def__alpha.rhs)
    limit = sp.expand(elementary_limit(height, k, 0))
    if is_zero(limit - beyond__envelope__safety.of(y_e)) is None:
        raise DerivationError(f"{limit} is not the parabola of safety")
    return Eq(Limit(height, k, 0, "+"), limit, evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
