"""Section 3: the circles of the synchronous curve with sliding friction, equations (21) to (24)."""

import sympy as sp
from sympy import And, Eq, Gt, Ne, Tuple, atan, pi, sqrt, tan

from galileo_sym.derivations.chord.notation import (
    ACUTE,
    R,
    g,
    mu,
    notation,
    s,
    t,
    theta,
    theta_c,
    theta_max,
    x,
    x_c,
    y,
    y_c,
)
from galileo_sym.derivations.chord.shared import (
    ARC,
    CENTRE,
    EQ21,
    EQ24,
    LEFT_ARC,
    MOVING,
    WHOLE_CIRCLE,
    K,
    centred,
    doubled_coordinates,
    without_s,
)
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    Independent,
    step,
    tell_chapter,
)
from galileo_sym.tactics import (
    eliminate_angle,
    isolate,
    read_circle,
    sign_by_factors,
    solve_angle,
    solve_motion,
    start_of,
    undo_arctangent,
)

chapter = Chapter("chord.friction_circles", notation, "3. Sliding friction")


@chapter.derive("chord.eq21", EQ21, ARC, erratum=WHOLE_CIRCLE)
def circle(eq19, eq20):
    """Eliminate theta from (19) and (20)."""
    across, down = without_s(eq19, x), without_s(eq20, y)
    step("(19)", across)
    step("(20)", down)
    found = eliminate_angle(across, down, 2 * theta, (x, y))
    step("what is left when sin 2 theta and cos 2 theta are eliminated", found)
    return centred(found)


@chapter.derive(
    "chord.eq22", Eq(R(t), g * t**2 / 4 * sqrt(1 + mu**2)), Domain({g: POSITIVE, mu: POSITIVE, t: NONNEGATIVE})
)
def radius(eq21):
    """Read the radius off (21)."""
    step("the square of the radius", Eq(R(t) ** 2, eq21.rhs, evaluate=False))
    return Eq(R(t), read_circle(eq21.equation, x, y).radius)


@chapter.derive(
    "chord.claim.centre-off-axis", And(Eq(CENTRE, Tuple(-mu * g * t**2 / 4, g * t**2 / 4)), Ne(x_c(t), 0)), MOVING
)
def centre_off_axis(eq21):
    """Read the centre off (21)."""
    centre = read_circle(eq21.equation, x, y).centre
    if sign_by_factors(centre[0], {t: Gt(t, 0)}) != -1:
        raise DerivationError("the centre is not to the left")
    return And(Eq(CENTRE, Tuple(*centre)), Ne(x_c(t), 0))


@chapter.derive(
    "chord.claim.centre-accel-mu",
    And(
        Eq(x_c(t).diff(t, 2), -mu * g / 2),
        Eq(y_c(t).diff(t, 2), g / 2),
        Eq(sqrt(x_c(t).diff(t, 2) ** 2 + y_c(t).diff(t, 2) ** 2), g / 2 * sqrt(1 + mu**2)),
    ),
    Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE}, where={x_c(t): -mu * K, y_c(t): K}),
    erratum=Erratum(
        ("C6",),
        "(g/2) sqrt(1 + mu^2) is the magnitude along the oblique line; the vertical acceleration is g/2",
        Eq(y_c(t).diff(t, 2), g / 2 * sqrt(1 + mu**2)),
    ),
)
def centre_acceleration(eq21):
    """Differentiate the centre twice."""
    return acceleration(read_circle(eq21.equation, x, y).centre)


def acceleration(centre):
    """The acceleration of a centre: its components and its magnitude."""
    ax, ay = (sp.diff(c, t, 2) for c in centre)
    size = sqrt(x_c(t).diff(t, 2) ** 2 + y_c(t).diff(t, 2) ** 2)
    return And(
        Eq(x_c(t).diff(t, 2), ax), Eq(y_c(t).diff(t, 2), ay), Eq(size, sqrt(sp.factor(ax**2 + ay**2)), evaluate=False)
    )


@chapter.derive("chord.eq23", Eq(theta_c, atan(mu)), MOVING)
def line_angle(eq21):
    """The angle whose tangent is |x_c|/y_c."""
    a, b = read_circle(eq21.equation, x, y).centre
    ratio = step("tangent of the angle", Eq(tan(theta_c), sp.simplify(-a / b), evaluate=False))
    return solve_angle(Eq(tan(theta_c), ratio.rhs, evaluate=False), theta_c, ACUTE)


@chapter.derive(
    "chord.claim.centre-line-angle",
    And(Eq(x_c(t) / y_c(t), tan(-theta_c)), Independent(x_c(t) / y_c(t), t)),
    Domain(MOVING.ranges, where={x_c(t): -mu * K, y_c(t): K}),
)
def centre_line(eq21, eq23):
    """The direction of the centre, -mu, does not change; by (23) mu is the tangent of theta_c."""
    a, b = read_circle(eq21.equation, x, y).centre
    direction = sp.simplify(a / b)
    step("the centre", Eq(CENTRE, Tuple(a, b)))
    if direction.has(t):
        raise DerivationError(f"the direction {direction} changes")
    slope = isolate(eq23.equation, mu)
    line = Eq(x_c(t) / y_c(t), direction.subs(mu, slope.rhs), evaluate=False)
    return And(line, Independent(x_c(t) / y_c(t), t))


@chapter.derive("chord.support.theta-c-max", Eq(theta_c + theta_max, pi / 2), Domain({mu: POSITIVE}))
def angles_add_up(eq13, eq23):
    """By (23) mu is the tangent of theta_c; in (13) that is the arctangent of a cotangent, and theta_c is acute."""
    slope = isolate(eq23.equation, mu)
    cotangent = step("cotangent", Eq(theta_max, eq13.of(theta_max).subs(mu, slope.rhs), evaluate=False))
    complement = undo_arctangent(cotangent.rhs, theta_c, ACUTE)
    return Eq(theta_c + theta_max, theta_c + complement, evaluate=False)


@chapter.derive(
    "chord.eq24",
    EQ24,
    LEFT_ARC,
    erratum=Erratum(("C4",), "the arc is that with x <= 0, the vertical bead included"),
)
def left_circle(eq14, setup, eq7, eq8):
    """Solve (14) from rest, write the coordinates with 2 theta, and eliminate it."""
    path = step("the path", solve_motion(eq14.equation, s(t), start_of(setup.parts, s(t))))
    across, down = doubled_coordinates(path.rhs, setup, eq7.rhs, eq8.rhs)
    step("abscissa", Eq(x, across))
    step("ordinate", Eq(y, down))
    return centred(eliminate_angle(Eq(x, across), Eq(y, down), 2 * theta, (x, y)))


@chapter.derive(
    "chord.claim.negative-circle-same",
    And(
        Eq(R(t), g * t**2 / 4 * sqrt(1 + mu**2)),
        Eq(x_c(t).diff(t, 2), mu * g / 2),
        Eq(y_c(t).diff(t, 2), g / 2),
        Eq(sqrt(x_c(t).diff(t, 2) ** 2 + y_c(t).diff(t, 2) ** 2), g / 2 * sqrt(1 + mu**2)),
        Eq(x_c(t) / y_c(t), tan(theta_c)),
    ),
    Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE}, where={x_c(t): mu * K, y_c(t): K}),
)
def negative_circle(eq24, eq22, eq23):
    """Read centre and radius off (24); by (22) the radius is R(t), by (23) mu is the tangent of theta_c."""
    seen = read_circle(eq24.equation, x, y)
    as_on_the_right = sp.simplify(seen.radius.subs(g, isolate(eq22.equation, g).rhs))
    if as_on_the_right != R(t):
        raise DerivationError(f"the radius of (24) is {as_on_the_right}")
    direction = sp.simplify(seen.centre[0] / seen.centre[1])
    line = Eq(x_c(t) / y_c(t), direction.subs(mu, isolate(eq23.equation, mu).rhs), evaluate=False)
    return And(Eq(as_on_the_right, seen.radius, evaluate=False), *acceleration(seen.centre).args, line)


if __name__ == "__main__":
    tell_chapter(chapter.name)
