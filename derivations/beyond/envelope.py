"""The envelope of trajectories with linear resistance: v, k and g are given, the elevation runs through all values."""

import sympy as sp
from sympy import And, Derivative, Eq, Equivalent, Interval, cos, exp, log, pi, sin, tan

from galileo_sym.derivations.beyond.envelope_shared import (
    FLIGHT_SLOPE,
    FLYING,
    HEIGHT,
    INSIDE,
    PATH,
    PERPENDICULAR,
    ROOT,
    SINE,
    TOUCHING,
    XI,
    sine_of_contact,
)  # fmt: skip
from galileo_sym.derivations.beyond.notation import notation, x_e, y_e
from galileo_sym.derivations.projectile.notation import SHOT, alpha, g, k, s, share, t, theta, v, x, y
from galileo_sym.ledger import Chapter, DerivationError, Domain, step, tell_chapter
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import eliminate, isolate, sign_by_ladder, sign_on

chapter = Chapter("beyond.envelope", notation, "The envelope of trajectories (not printed)")

# all times, by the share of the way to the wall v cos(theta)/k
FLIGHT = Domain({**SHOT, share: Interval.Ropen(0, 1), theta: Interval.Ropen(0, pi / 2)}, {t: -log(1 - share) / k})


@chapter.derive(
    "beyond.envelope.path",
    Eq(y(t), PATH.subs(x_e, x(t))),
    FLIGHT,
)
def path(drag__x, drag__y):
    """Eliminate the time: e^(-kt) is linear in x."""
    decay, place = sp.Dummy("decay", positive=True), sp.Dummy("place", real=True)
    left = isolate(Eq(place, drag__x.rhs.subs(exp(-k * t), decay), evaluate=False), decay).rhs
    left = step("what is left of the speed", Eq(exp(-k * t), sp.expand(left).subs(place, x(t)))).rhs
    height = sp.expand(drag__y.rhs).subs(exp(-k * t), decay).subs(t, -log(decay) / k)
    powers, rest = sp.expand(height).as_independent(log(decay), as_Add=True)[::-1]
    flat = sp.expand(sp.expand(rest).subs(decay, left)).subs(sin(theta) / cos(theta), tan(theta))
    return Eq(y(t), flat + powers.subs(decay, left), evaluate=False)


@chapter.derive(
    "beyond.envelope.slope",
    And(
        Eq(Derivative(PATH, x_e), FLIGHT_SLOPE),
        Eq(Derivative(PATH, theta), (exp(k * t) - 1) / (k * v * cos(theta)) * PERPENDICULAR),
    ),
    FLYING,
)
def slope(beyond__envelope__path, drag__x, drag__vx, drag__vy):
    """A path has the direction of flight; how its height at x_e changes with theta is decided by the velocities.

    It is their product, at launch and there: the height is stationary where they are perpendicular.
    """
    height = beyond__envelope__path.rhs.subs(x(t), x_e)
    sine, cosine, decay = sp.symbols("sine cosine decay", positive=True)
    plain = {sin(theta): sine, cos(theta): cosine, tan(theta): sine / cosine, exp(-k * t): decay}
    place = drag__x.rhs.subs(plain)
    turned, along = (sp.together(sp.diff(height, z).subs(plain).subs(x_e, place)) for z in (theta, x_e))
    launch = {Derivative(x(t), t): drag__vx.rhs, Derivative(y(t), t): drag__vy.rhs}
    direction, product = (e.subs(launch).subs(plain) for e in (FLIGHT_SLOPE, PERPENDICULAR))
    if sp.cancel(along / direction) != 1:
        raise DerivationError(f"{height} has the slope {along}, and the flight {direction}")
    across = sp.expand(sp.cancel(turned / product)).subs({decay: exp(-k * t), cosine: cos(theta), sine: sin(theta)})
    return And(
        Eq(Derivative(height, x_e), FLIGHT_SLOPE),
        Eq(Derivative(height, theta), sp.factor(across) * PERPENDICULAR, evaluate=False),
    )


@chapter.derive(
    "beyond.envelope.condition",
    And(
        Eq(Derivative(PATH, theta), g * (exp(s) - 1) ** 2 * (SINE - sin(theta)) / (k**2 * exp(s) * cos(theta))),
        Equivalent(Eq(Derivative(PATH, theta), 0), Eq(sin(theta), SINE)),
        Equivalent(Eq(PERPENDICULAR, 0), Eq(sin(theta), SINE)),
    ),
    FLYING,
)
def condition(beyond__envelope__slope, drag__vx, drag__vy, def__alpha):
    """Neighbouring trajectories meet where the projectile flies at a right angle to its launch: sin = alpha/(e^s - 1).

    What multiplies the difference of the sines is not 0 at any time after the launch.
    """
    launch = {Derivative(x(t), t): drag__vx.rhs, Derivative(y(t), t): drag__vy.rhs}
    speed = isolate(def__alpha.equation, v).rhs
    sine, upright = sp.Symbol("sine", real=True), sp.Symbol("upright", positive=True)
    found = []
    for told in (beyond__envelope__slope.of(Derivative(PATH, theta)), PERPENDICULAR):
        in_time = sp.expand(told.subs(launch).doit()).subs(t, s / k).subs(cos(theta), upright)
        linear = sp.Poly(sp.expand(in_time).subs(sin(theta) ** 2, 1 - upright**2).subs(sin(theta), sine), sine)
        per_sine, constant = (sp.factor(linear.coeff_monomial(m)) for m in (sine, 1))
        sign_by_ladder(per_sine, s)
        found.append((per_sine.subs(upright, cos(theta)), sp.simplify((-constant / per_sine).subs(v, speed))))
    (per_sine, place), (_, again) = found
    if is_zero(place - again) is None:
        raise DerivationError(f"the height is stationary at the sine {place}, the velocities perpendicular at {again}")
    slope_is_0 = Eq(Derivative(PATH, theta), 0, evaluate=False)
    here = Eq(sin(theta), place)
    return And(
        Eq(slope_is_0.lhs, per_sine * (sin(theta) - place), evaluate=False),
        Equivalent(slope_is_0, here),
        Equivalent(Eq(PERPENDICULAR, 0, evaluate=False), here),
    )


DECAY = exp(-s)


@chapter.derive(
    "beyond.envelope.parametric",
    And(
        Eq(sin(theta), SINE),
        Eq(XI**2, (1 - DECAY) ** 2 - alpha**2 * DECAY**2),
        Eq(k**2 * y_e / g, 1 - s + (alpha**2 - 1) * DECAY),
    ),
    TOUCHING,
)
def parametric(beyond__envelope__condition, drag__x, drag__y, def__alpha):
    """The sine of contact put into x and y: the envelope in terms of s."""
    sine = sine_of_contact(beyond__envelope__condition)
    pure = {t: s / k, v: isolate(def__alpha.equation, v).rhs}
    square = sp.expand((k * drag__x.rhs / v) ** 2).subs(cos(theta) ** 2, 1 - sin(theta) ** 2).subs(pure)
    height = sp.expand(k**2 * drag__y.rhs / g).subs(pure)
    across, up = (sp.expand(sp.simplify(e.subs(sin(theta), sine))) for e in (square, height))
    return And(Eq(sin(theta), sine), Eq(XI**2, across), Eq(k**2 * y_e / g, up))


@chapter.derive(
    "beyond.envelope.conic",
    Eq((k**2 * y_e / g + s) ** 2, alpha**2 + (1 - alpha**2) * XI**2),
    TOUCHING,
)
def conic(beyond__envelope__parametric):
    """Eliminate e^(-s): the height, raised by s, lies on a conic, for every alpha."""
    decay, square, raised = sp.symbols("decay square raised", positive=True)
    height = sp.expand(beyond__envelope__parametric.of(k**2 * y_e / g) + s)
    across = sp.expand(beyond__envelope__parametric.of(XI**2)).subs(exp(-2 * s), decay**2)
    equations = [side.subs(DECAY, decay) - name for side, name in ((height, raised), (across, square))]
    found = eliminate(equations, (decay,), (raised, square, alpha))  # alpha is no coefficient: it may be 1
    told = isolate(found.subs(raised, sp.sqrt(raised)), raised).rhs
    return Eq((k**2 * y_e / g + s) ** 2, sp.collect(sp.expand(told), square).subs(square, XI**2), evaluate=False)


@chapter.derive(
    "beyond.envelope.explicit",
    And(Eq(DECAY, (1 - XI**2) / (1 + ROOT)), Eq(y_e, HEIGHT)),
    TOUCHING,
)
def explicit(beyond__envelope__parametric, beyond__envelope__conic):
    """The raised height is positive, which tells its sign; e^(-s) follows, linearly, and with it s."""
    decay, raised, square = sp.symbols("decay raised square", positive=True)
    in_s = sp.expand(beyond__envelope__parametric.of(k**2 * y_e / g) + s).subs(DECAY, decay)
    if sign_on(in_s, {decay: INSIDE}) < 0:
        raise DerivationError(f"{in_s} is not positive")
    root = sp.sqrt(beyond__envelope__conic.rhs)
    lever = isolate(Eq(raised, in_s.subs(alpha, sp.sqrt(square)), evaluate=False), square).rhs
    across = sp.expand(beyond__envelope__parametric.of(XI**2)).subs(exp(-2 * s), decay**2).subs(DECAY, decay)
    linear = Eq(square, sp.expand(across.subs(alpha, sp.sqrt(lever))), evaluate=False)
    in_x = isolate(linear, decay).rhs.subs({raised: root, square: XI**2})
    return And(Eq(DECAY, in_x), Eq(y_e, g / k**2 * (root + log(in_x)), evaluate=False))


if __name__ == "__main__":
    tell_chapter(chapter.name)
