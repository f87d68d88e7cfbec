"""Section 3: the synchronous curve with sliding friction, two arcs that meet in corners."""

import sympy as sp
from sympy import And, Eq, Gt, Le, Lt, Ne, Or, Tuple, atan, cos, sin, sqrt

from galileo_sym.derivations.chord.notation import (
    ACUTE,
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
    y,
)
from galileo_sym.derivations.chord.shared import (
    ARC,
    EQ21,
    EQ24,
    LAST,
    LEFT,
    LEFT_POINT,
    MOVING,
    ONE_ARC,
    RIGHT,
    RIGHT_POINT,
    K,
    doubled_coordinates,
    slope_at_vertical,
    without_s,
)
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    ForAll,
    TracesOnce,
    UniqueMaximum,
    step,
    tell_chapter,
)
from galileo_sym.tactics import (
    as_wave,
    isolate,
    not_negative,
    read_circle,
    sine_maximum,
    solve_motion,
    start_of,
    trace_circle,
)

chapter = Chapter("chord.spindle", notation, "3. Sliding friction")

RIGHT_ARC = TracesOnce(RIGHT_POINT, theta, RIGHT, EQ21, sp.Ge(x, 0), Tuple(x, y), atan(x / y))
LEFT_ARC_TRACED = TracesOnce(LEFT_POINT, theta, LEFT, EQ24, sp.Le(x, 0), Tuple(x, y), atan(x / y))


@chapter.derive(
    "chord.support.lens-parametrisation",
    And(
        Eq(x / K + mu, sqrt(1 + mu**2) * sin(2 * theta + theta_c)),
        Eq(y / K - 1, sqrt(1 + mu**2) * cos(2 * theta + theta_c)),
    ),
    ARC,
)
def lens(eq19, eq20, eq23):
    """Collect the sine and the cosine of 2 theta in one wave; by (23) its offset atan(mu) is theta_c."""
    forms = []
    for coordinate, premise, turn in ((x, eq19, sin), (y, eq20, cos)):
        wave = as_wave(sp.expand(without_s(premise, coordinate).rhs / K), 2 * theta, turn)
        offset = wave.offset.subs(eq23.of(theta_c), theta_c)
        forms.append(Eq(coordinate / K - wave.level, wave.amplitude * turn(2 * theta + offset), evaluate=False))
    return And(*forms)


@chapter.derive(
    "chord.claim.arc-x-positive",
    RIGHT_ARC,
    ARC,
    erratum=Erratum(("C5",), ONE_ARC, RIGHT_ARC.func(*RIGHT_ARC.args[:4], sp.true, *RIGHT_ARC.args[5:])),
)
def right_arc(eq19, eq20, eq21, eq23, support__theta_c_max):
    """Seen from the centre the bead is at the angle 2 theta + theta_c, from theta_c to pi - theta_c."""
    point = (without_s(eq19, x).rhs, without_s(eq20, y).rhs)
    offset = eq23.of(theta_c)
    complement = isolate(support__theta_c_max.equation, theta_max).rhs.subs(theta_c, offset)
    moving = {t: step("after the release", Gt(t, 0))}
    return trace_circle(
        point, theta, RIGHT, eq21.equation, sp.Ge(x, 0), (x, y), atan(x / y), offset, {LAST: complement}, moving
    )


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
    point = doubled_coordinates(path.rhs, setup, eq7.rhs, eq8.rhs)
    offset = eq23.of(theta_c)
    complement = isolate(support__theta_c_max.equation, theta_max).rhs.subs(theta_c, offset)
    moving = {t: step("after the release", Gt(t, 0))}
    left = trace_circle(
        point, theta, LEFT, eq24.equation, sp.Le(x, 0), (x, y), atan(x / y), -offset, {LAST: complement}, moving
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


@chapter.derive(
    "chord.claim.spindle",
    And(
        UniqueMaximum(RIGHT_POINT[0], theta, RIGHT, LAST / 2),
        Eq(Tuple(x, y), Tuple(K * (sqrt(1 + mu**2) - mu), K)),
        ForAll(Le((RIGHT_POINT[0] - mu * K) ** 2 + (RIGHT_POINT[1] - K) ** 2, K**2 * (1 + mu**2)), theta, RIGHT),
        ForAll(Le((LEFT_POINT[0] + mu * K) ** 2 + (LEFT_POINT[1] - K) ** 2, K**2 * (1 + mu**2)), theta, LEFT),
    ),
    Domain(
        {g: POSITIVE, mu: POSITIVE, t: POSITIVE, theta: sp.FiniteSet(LAST / 2)},
        where={theta_c: atan(mu), x: RIGHT_POINT[0], y: RIGHT_POINT[1]},
    ),
)
def spindle(claim__union_of_arcs, support__lens_parametrisation, support__theta_c_max, eq21, eq24, eq13):
    """Widest where 2 theta + theta_c = pi/2; each arc lies inside the other one's circle, so that they bound a lens."""
    arc, left_arc = (next(a for a in claim__union_of_arcs.parts if a.args[4] == side(x, 0)) for side in (sp.Ge, Le))
    across = next(e for e in support__lens_parametrisation.parts if e.lhs.has(x))
    acute = isolate(support__theta_c_max.equation, theta_max).rhs
    widest = sine_maximum(across.rhs, theta, theta_c, (sp.S.Zero, acute), ACUTE)
    known = {theta_c: isolate(support__theta_c_max.equation, theta_c).rhs}
    place_of_widest = sp.expand(widest.subs(known)).subs(theta_max, eq13.of(theta_max))
    step("the widest point", Eq(theta, place_of_widest, evaluate=False))
    height = next(e for e in support__lens_parametrisation.parts if e.lhs.has(y))
    place = [isolate(e.subs(theta, widest), c).rhs for e, c in ((across, x), (height, y))]
    return And(
        UniqueMaximum(arc.args[0][0], theta, arc.args[2], place_of_widest),
        Eq(Tuple(x, y), Tuple(*place)),
        within_other(arc, eq21, eq24),
        within_other(left_arc, eq24, eq21),
    )


def within_other(arc, own, other):
    """Each point of an arc lies in the disc of the other circle: on its own one the two equations differ by c*x."""
    (across, down), angle, angles, _, region, _, _ = arc.args
    not_negative(sp.factor((own.lhs - own.rhs) - (other.lhs - other.rhs)), {x: region})
    seen = read_circle(other.equation, x, y)
    a, b = seen.centre
    return ForAll(Le((across - a) ** 2 + (down - b) ** 2, seen.radius**2, evaluate=False), angle, angles)


if __name__ == "__main__":
    tell_chapter(chapter.name)
