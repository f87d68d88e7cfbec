"""Finding the range without resistance: the parabola, the range, and the best angle pi/4."""

import sympy as sp
from sympy import And, Eq, Interval, cos, pi, sin, tan

from galileo_sym.derivations.projectile.notation import (
    HALF_TURN,
    RISING,
    R,
    delta,
    g,
    notation,
    r,
    share,
    t,
    theta,
    v,
    x,
    y,
)  # fmt: skip
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    ExactlyOneRoot,
    Independent,
    UniqueMaximum,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.tactics import (
    isolate,
    monotone,
    one_root,
    sign_on,
    solve_motion,
    start_of,
    substitute,
    trig_box,
    unique_maximum,
)  # fmt: skip

chapter = Chapter("projectile.no_resistance", notation, "Finding the range without resistance")

FLIGHT = Domain({g: POSITIVE, v: POSITIVE, t: NONNEGATIVE, theta: HALF_TURN})
LAUNCH = Domain({g: POSITIVE, v: POSITIVE, theta: HALF_TURN})
LOW, HIGH = Interval(0, pi / 4), Interval(pi / 4, pi / 2)

chapter.given(
    "projectile.setup",
    And(
        Eq(x(0), 0),
        Eq(y(0), 0),
        Eq(x(t).diff(t).subs(t, 0), v * cos(theta)),
        Eq(y(t).diff(t).subs(t, 0), v * sin(theta)),
    ),
    FLIGHT,
)

chapter.given("projectile.law.nodrag.x", Eq(x(t).diff(t, 2), 0), FLIGHT, premises=("projectile.setup",))

chapter.given("projectile.law.nodrag.y", Eq(y(t).diff(t, 2), -g), FLIGHT, premises=("projectile.setup",))


@chapter.derive("projectile.nodrag.x", Eq(x(t), v * cos(theta) * t), FLIGHT)
def abscissa(law__nodrag__x, setup):
    """Integrate the law twice with the initial values."""
    return solve_motion(law__nodrag__x.equation, x(t), start_of(setup.parts, x(t)))


@chapter.derive("projectile.nodrag.y", Eq(y(t), -g * t**2 / 2 + v * sin(theta) * t), FLIGHT)
def height(law__nodrag__y, setup):
    """Integrate the law twice with the initial values."""
    return solve_motion(law__nodrag__y.equation, y(t), start_of(setup.parts, y(t)))


@chapter.derive(
    "projectile.nodrag.claim.parabola",
    Eq(y(t), x(t) * tan(theta) - g * x(t) ** 2 / (2 * v**2 * cos(theta) ** 2)),
    Domain({g: POSITIVE, v: POSITIVE, t: NONNEGATIVE, theta: Interval.Ropen(0, pi / 2)}),
)
def parabola(nodrag__x, nodrag__y):
    """Eliminate the time: it is linear in x, so y is quadratic in x."""
    place = sp.Dummy("place", real=True)
    hide = {cos(theta): sp.Symbol("c", positive=True)}
    time = isolate(Eq(place, nodrag__x.rhs, evaluate=False), t, hide=hide).rhs
    path = sp.expand(nodrag__y.rhs.subs(t, time))
    if sp.degree(path, place) != 2:
        raise DerivationError(f"{path} is not a parabola")
    step("time in terms of x", Eq(t, time.subs(place, x(t)), evaluate=False))
    return Eq(y(t), path.subs(place, x(t)).subs(sin(theta) / cos(theta), tan(theta)), evaluate=False)


@chapter.derive(
    "projectile.nodrag.impact",
    Eq(t, 2 * v * sin(theta) / g),
    Domain({g: POSITIVE, v: POSITIVE, theta: RISING}),
)
def impact(nodrag__y):
    """Set the height to 0 and drop t = 0."""
    landing = Eq(nodrag__y.rhs, 0, evaluate=False)
    found = isolate(landing, t, drop={sp.S.Zero: "the launch itself"})
    step("the projectile lands when", landing)
    return found


@chapter.derive(
    "projectile.nodrag.range",
    And(
        Eq(R(theta), 2 * v**2 / g * sin(theta) * cos(theta)),
        Eq(R(theta), v**2 / g * sin(2 * theta)),
    ),
    LAUNCH,
)
def flat_range(nodrag__x, nodrag__impact):
    """The range is x at the time of impact; then the addition theorem."""
    product = substitute(Eq(R(theta), nodrag__x.rhs, evaluate=False), {t: nodrag__impact.of(t)}, tidy=sp.expand)
    ratio = sp.cancel(product.rhs / (sin(theta) * cos(theta)))
    return And(product, Eq(R(theta), ratio * sin(2 * theta) / 2, evaluate=False))


def _branches(flight_range):
    """The range rises on [0, pi/4] and falls on [pi/4, pi/2], by the sign of its slope."""
    length = next(part.rhs for part in flight_range.parts if part.rhs.has(sin(2 * theta)))
    slope = sp.diff(length, theta)
    step("slope of the range", Eq(sp.Derivative(R(theta), theta), slope))
    signs = {part: sign_on(slope, trig_box(slope, theta, part.interior)) for part in (LOW, HIGH)}
    return length, [monotone(length, theta, part, sign) for part, sign in signs.items()]


@chapter.derive(
    "projectile.nodrag.claim.max-pi4",
    And(UniqueMaximum(v**2 / g * sin(2 * theta), theta, HALF_TURN, pi / 4), Eq(R(pi / 4), v**2 / g)),
    LAUNCH,
)
def best_angle(nodrag__range):
    """cos(2 theta) is positive below pi/4 and negative above."""
    length, (rising, falling) = _branches(nodrag__range)
    top = unique_maximum(rising, falling)
    return And(top, Eq(R(top.args[3]), length.subs(theta, top.args[3])))


@chapter.derive(
    "projectile.nodrag.claim.pairs",
    And(
        Eq(R(pi / 4 - delta), v**2 / g * cos(2 * delta)),
        Eq(R(pi / 4 + delta), v**2 / g * cos(2 * delta)),
        ExactlyOneRoot(v**2 / g * sin(2 * theta) - r, theta, LOW),
        ExactlyOneRoot(v**2 / g * sin(2 * theta) - r, theta, HIGH),
    ),
    Domain({**LAUNCH.ranges, share: Interval.Ropen(0, 1), delta: Interval.Lopen(0, pi / 4)}, {r: share * v**2 / g}),
)
def pairs(nodrag__range, nodrag__claim__max_pi4):
    """The range is even about pi/4, and on either side it takes each submaximal value once."""
    length, sides = _branches(nodrag__range)
    submaximal = sp.Lt(r, nodrag__claim__max_pi4.of(R(pi / 4)), evaluate=False)
    even = [
        Eq(R(angle), sp.expand_trig(length.subs(theta, angle)), evaluate=False)
        for angle in (pi / 4 - delta, pi / 4 + delta)
    ]
    return And(*even, *(one_root(side, r, assuming=(submaximal,)) for side in sides))


PURE_RANGE = g * R(theta) / v**2


@chapter.derive(
    "projectile.nodrag.claim.independent-v-g",
    And(Eq(PURE_RANGE, sin(2 * theta)), Independent(PURE_RANGE, v), Independent(PURE_RANGE, g)),
    LAUNCH,
)
def no_parameters(nodrag__range):
    """In units of v^2/g the range is a function of the angle alone; so are its maximum and its symmetry."""
    scaled = sp.cancel(PURE_RANGE.subs(R(theta), nodrag__range.of(R(theta))))
    if scaled.free_symbols != {theta}:
        raise DerivationError(f"{scaled} depends on more than theta")
    return And(Eq(PURE_RANGE, scaled), Independent(PURE_RANGE, v), Independent(PURE_RANGE, g))


if __name__ == "__main__":
    tell_chapter(chapter.name)
