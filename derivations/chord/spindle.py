"""Section 3, second half: the synchronous curve with sliding friction, two arcs of circles, equations (21) to (27)."""

import sympy as sp
from galileo_sym.derivations.chord.notation import (
    R,
    g,
    mu,
    notation,
    s,
    slope_left,
    slope_right,
    t,
    theta,
    theta_c,
    theta_max,
    x,
    x_c,
    xt,
    y,
    y_c,
    yt,
)
from sympy import And, Eq, Gt, Interval, Le, Lt, Ne, Or, Tuple, atan, cos, pi, sin, sqrt, tan

from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    REAL,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    Independent,
    TracesOnce,
    UniqueMaximum,
    step,
    tell_chapter,
)
from galileo_sym.tactics import (
    eliminate_angle,
    isolate,
    read_circle,
    sign_by_factors,
    sine_maximum,
    solve_motion,
    start_of,
    trace_circle,
)

chapter = Chapter("chord.spindle", notation, "3. Sliding friction")

LAST = atan(1 / mu)
K = g * t**2 / 4
RIGHT = Interval(0, LAST)
LEFT = Interval(-LAST, 0)
ARC = Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE, theta: RIGHT})
LEFT_ARC = Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE, theta: LEFT})
CENTRE = Tuple(x_c(t), y_c(t))
MOVING = Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE})
EQ21 = Eq((x + mu * g * t**2 / 4) ** 2 + (y - g * t**2 / 4) ** 2, (g * t**2 / 4) ** 2 * (1 + mu**2))
EQ24 = Eq((x - mu * g * t**2 / 4) ** 2 + (y - g * t**2 / 4) ** 2, (g * t**2 / 4) ** 2 * (1 + mu**2))
ONE_ARC = (
    "elimination gives the whole circle; only the arc x >= 0 is traced, completely and once, by 0 <= theta <= theta_max"
)


def without_s(premise, coordinate):
    """The equation of a coordinate that does not mention s(t)."""
    return next(e for e in premise.parts if e.lhs == coordinate and not e.rhs.has(s))


@chapter.derive("chord.eq21", EQ21, ARC, erratum=Erratum(("C5",), ONE_ARC))
def circle(eq19, eq20):
    """Eliminate theta from (19) and (20)."""
    across, down = without_s(eq19, x), without_s(eq20, y)
    step("(19)", across)
    step("(20)", down)
    found = eliminate_angle(across, down, 2 * theta, (x, y))
    step("what is left when sin 2 theta and cos 2 theta are eliminated", found)
    return centred(found)


def centred(found):
    """The equation of a circle, with its centre and radius in sight."""
    seen = read_circle(found, x, y)
    (a, b), rho = seen.centre, seen.radius
    return Eq((x - a) ** 2 + (y - b) ** 2, rho**2, evaluate=False)


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
    return isolate(Eq(tan(theta_c), ratio.rhs, evaluate=False), theta_c)


@chapter.derive(
    "chord.claim.centre-line-angle",
    And(Eq(x_c(t) / y_c(t), tan(-theta_c)), Independent(-mu, t)),
    MOVING,
)
def centre_line(eq21, eq23):
    """The direction of the centre does not change."""
    a, b = read_circle(eq21.equation, x, y).centre
    direction = sp.simplify(a / b)
    step("the centre", Eq(CENTRE, Tuple(a, b)))
    if sp.simplify(direction - tan(-eq23.of(theta_c))) != 0:
        raise DerivationError("the centre does not move at the angle -theta_c")
    return And(Eq(x_c(t) / y_c(t), tan(-theta_c), evaluate=False), Independent(direction, t))


@chapter.derive("chord.support.theta-c-max", Eq(theta_c + theta_max, pi / 2), Domain({mu: POSITIVE}))
def angles_add_up(eq13, eq23):
    """The tangent of theta_max is the cotangent of theta_c, and both are acute."""
    product = tan(eq23.of(theta_c)) * tan(eq13.of(theta_max))
    if sp.simplify(product) != 1:
        raise DerivationError(f"tan(theta_c)*tan(theta_max) = {product}")
    step("cotangent", Eq(tan(theta_max), 1 / tan(theta_c), evaluate=False))
    return Eq(theta_c + theta_max, pi / 2)


@chapter.derive(
    "chord.support.lens-parametrisation",
    And(
        Eq(x / K + mu, sqrt(1 + mu**2) * sin(2 * theta + theta_c)),
        Eq(y / K - 1, sqrt(1 + mu**2) * cos(2 * theta + theta_c)),
    ),
    ARC,
)
def lens(eq19, eq20, eq23):
    """Collect the sine and the cosine of 2 theta with the angle theta_c."""
    forms = []
    for coordinate, premise, shift, turn in ((x, eq19, mu, sin), (y, eq20, -1, cos)):
        rescaled = sp.expand(without_s(premise, coordinate).rhs / K) + shift
        both = sqrt(1 + mu**2) * turn(2 * theta + eq23.of(theta_c))
        opened = sp.expand_trig(both).expand()
        if sp.simplify(sp.expand_trig(rescaled) - opened) != 0:
            raise DerivationError(f"{rescaled} is not {both}")
        forms.append(Eq(coordinate / K + shift, sqrt(1 + mu**2) * turn(2 * theta + theta_c), evaluate=False))
    return And(*forms)


RIGHT_POINT = Tuple(K * (sin(2 * theta) - mu * (1 - cos(2 * theta))), K * (1 + cos(2 * theta) - mu * sin(2 * theta)))
LEFT_POINT = Tuple(K * (sin(2 * theta) + mu * (1 - cos(2 * theta))), K * (1 + cos(2 * theta) + mu * sin(2 * theta)))
RIGHT_ARC = TracesOnce(RIGHT_POINT, theta, RIGHT, EQ21, sp.Ge(x, 0), Tuple(x, y), atan(x / y))
LEFT_ARC_TRACED = TracesOnce(LEFT_POINT, theta, LEFT, EQ24, sp.Le(x, 0), Tuple(x, y), atan(x / y))


@chapter.derive("chord.claim.arc-x-positive", RIGHT_ARC, ARC, erratum=Erratum(("C5",), ONE_ARC))
def right_arc(eq19, eq20, eq21, eq23, support__theta_c_max):
    """Seen from the centre the bead is at the angle 2 theta + theta_c, from theta_c to pi - theta_c."""
    point = (without_s(eq19, x).rhs, without_s(eq20, y).rhs)
    offset = eq23.of(theta_c)
    complement = isolate(support__theta_c_max.equation, theta_max).rhs.subs(theta_c, offset)
    return trace_circle(
        point, theta, RIGHT, eq21.equation, sp.Ge(x, 0), (x, y), atan(x / y), offset, using={LAST: complement}
    )


@chapter.derive(
    "chord.eq24",
    EQ24,
    LEFT_ARC,
    erratum=Erratum(("C4",), "the arc is that with x <= 0, the vertical bead included"),
)
def left_circle(eq14, setup, eq7, eq8):
    """Solve (14) from rest, write the coordinates with 2 theta, and eliminate it."""
    path = step("the path", solve_motion(eq14.equation, s(t), start_of(setup.parts, s(t))))
    across, down = left_coordinates(path.rhs, setup, eq7.rhs, eq8.rhs)
    step("abscissa", Eq(x, across))
    step("ordinate", Eq(y, down))
    return centred(eliminate_angle(Eq(x, across), Eq(y, down), 2 * theta, (x, y)))


def left_coordinates(path, setup, double_sine, double_cosine):
    """x and y of a bead at distance `path`, with sines and cosines of 2 theta."""
    put = {sin(theta) * cos(theta): double_sine / 2}
    across = sp.expand(setup.of(x).subs(s(t), path)).subs(put).subs(sin(theta) ** 2, 1 - double_cosine / 2)
    down = sp.expand(setup.of(y).subs(s(t), path)).subs(put).subs(cos(theta) ** 2, double_cosine / 2)
    return across, down


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
    """Read centre and radius off (24)."""
    seen = read_circle(eq24.equation, x, y)
    if sp.simplify(seen.radius - eq22.rhs) != 0:
        raise DerivationError("the radii of (21) and (24) differ")
    if sp.simplify(seen.centre[0] / seen.centre[1] - tan(eq23.of(theta_c))) != 0:
        raise DerivationError("the centre does not move at the angle theta_c")
    line = Eq(x_c(t) / y_c(t), tan(theta_c), evaluate=False)
    return And(Eq(R(t), seen.radius), *acceleration(seen.centre).args, line)


@chapter.derive(
    "chord.claim.union-of-arcs",
    And(RIGHT_ARC, LEFT_ARC_TRACED),
    Domain({**ARC.ranges}),
    erratum=Erratum(
        ("C4",),
        "printed with x > 0 and x < 0, which leaves out the bead theta = 0 at (0, g t^2/2), and A",
        Or(Gt(x, 0), Lt(x, 0)),
        Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE, theta: sp.FiniteSet(0, LAST / 2)}, where={x: RIGHT_POINT[0]}),
    ),
)
def union(claim__arc_x_positive, eq14, eq24, setup, eq7, eq8, eq23, support__theta_c_max):
    """The left arc is traced by (14) as the right one is by (12)."""
    path = solve_motion(eq14.equation, s(t), start_of(setup.parts, s(t)))
    point = left_coordinates(path.rhs, setup, eq7.rhs, eq8.rhs)
    offset = eq23.of(theta_c)
    complement = isolate(support__theta_c_max.equation, theta_max).rhs.subs(theta_c, offset)
    left = trace_circle(
        point, theta, LEFT, eq24.equation, sp.Le(x, 0), (x, y), atan(x / y), -offset, using={LAST: complement}
    )
    return And(claim__arc_x_positive.statement, left)


@chapter.derive(
    "chord.claim.friction-sync-not-circle",
    And(Eq(slope_right, -mu), Eq(slope_left, mu), Ne(slope_right, slope_left)),
    MOVING,
)
def not_a_circle(claim__union_of_arcs):
    """At the vertical bead the two arcs meet at an angle, and no circle has a corner."""
    slopes = [slope_at_vertical(arc) for arc in claim__union_of_arcs.parts]
    right, left = sorted(slopes, key=lambda e: e.is_positive)
    if sp.simplify(right - left).is_zero is not False:
        raise DerivationError("the slopes are equal")
    return And(Eq(slope_right, right), Eq(slope_left, left), Ne(slope_right, slope_left))


def slope_at_vertical(arc):
    """dy/dx of an arc at theta = 0."""
    across, down = arc.args[0]
    return sp.simplify((sp.diff(down, theta) / sp.diff(across, theta)).subs(theta, 0))


@chapter.derive(
    "chord.claim.spindle",
    And(
        UniqueMaximum(RIGHT_POINT[0], theta, RIGHT, LAST / 2),
        Eq(Tuple(x, y), Tuple(K * (sqrt(1 + mu**2) - mu), K)),
        Le((x - mu * K) ** 2 + (y - K) ** 2, K**2 * (1 + mu**2)),
    ),
    Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE, theta: sp.FiniteSet(LAST / 2)}, where={theta_c: atan(mu)}),
)
def spindle(claim__union_of_arcs, support__lens_parametrisation, support__theta_c_max, eq21, eq24, eq13):
    """Widest where 2 theta + theta_c = pi/2; the right arc lies inside the left circle."""
    arc = next(a for a in claim__union_of_arcs.parts if a.args[4] == sp.Ge(x, 0))
    across = next(e for e in support__lens_parametrisation.parts if e.lhs.has(x))
    acute = isolate(support__theta_c_max.equation, theta_max).rhs
    widest = sine_maximum(across.rhs, theta, theta_c, (sp.S.Zero, acute))
    known = {theta_c: isolate(support__theta_c_max.equation, theta_c).rhs}
    place_of_widest = sp.expand(widest.subs(known)).subs(theta_max, eq13.of(theta_max))
    step("the widest point", Eq(theta, place_of_widest, evaluate=False))
    height = next(e for e in support__lens_parametrisation.parts if e.lhs.has(y))
    place = [isolate(e.subs(theta, widest), c).rhs for e, c in ((across, x), (height, y))]
    inside = sp.factor((eq24.lhs - eq24.rhs) - (eq21.lhs - eq21.rhs))
    step("on (21) the left side of (24) differs from the right one by", Le(inside, 0, evaluate=False))
    if sign_by_factors(inside, {t: Gt(t, 0), x: Gt(x, 0)}) != -1:
        raise DerivationError(f"{inside} has not the sign of -x")
    seen = read_circle(eq24.equation, x, y)
    disc = Le((x - seen.centre[0]) ** 2 + (y - seen.centre[1]) ** 2, seen.radius**2, evaluate=False)
    return And(
        UniqueMaximum(arc.args[0][0], theta, arc.args[2], place_of_widest),
        Eq(Tuple(x, y), Tuple(*place)),
        disc,
    )


chapter.given(
    "chord.eq25",
    And(Eq(xt, x / (g * t**2 / 4)), Eq(yt, y / (g * t**2 / 4))),
    Domain({g: POSITIVE, t: POSITIVE, x: REAL, y: REAL}),
)

EQ26 = Eq((xt + mu) ** 2 + (yt - 1) ** 2, 1 + mu**2)
EQ27 = Eq((xt - mu) ** 2 + (yt - 1) ** 2, 1 + mu**2)


def rescale(circle_equation, definition):
    """Put x = K xt and y = K yt in, and divide by K^2."""
    put = {c: isolate(Eq(name, definition.of(name), evaluate=False), c).rhs for c, name in ((x, xt), (y, yt))}
    left, right = (sp.expand(side.subs(put) / K**2) for side in circle_equation.args)
    return Eq(left, right, evaluate=False)


@chapter.derive("chord.eq26", EQ26, Domain(ARC.ranges, where={x: RIGHT_POINT[0], y: RIGHT_POINT[1]}))
def rescaled_right(eq21, eq25):
    """Rescale (21)."""
    return rescale(eq21.equation, eq25)


@chapter.derive("chord.eq27", EQ27, Domain(LEFT_ARC.ranges, where={x: LEFT_POINT[0], y: LEFT_POINT[1]}))
def rescaled_left(eq24, eq25):
    """Rescale (24)."""
    return rescale(eq24.equation, eq25)


if __name__ == "__main__":
    tell_chapter(chapter.name)
