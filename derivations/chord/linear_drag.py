"""Section 4: a resistive force proportional to velocity, equations (28) to (36)."""

import sympy as sp
from sympy import And, Eq, Gt, Interval, LambertW, Lt, Tuple, atan, cos, exp, oo, pi, sin

from galileo_sym.derivations.chord.notation import (
    D,
    R,
    f,
    g,
    gamma,
    notation,
    s,
    s_AB,
    t,
    t_AB,
    theta,
    v,
    x,
    x_c,
    y,
    y_c,
)
from galileo_sym.derivations.chord.shared import doubled_coordinates
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    ExactlyOneRoot,
    Independent,
    TracesOnce,
    step,
    tell_chapter,
)
from galileo_sym.tactics import (
    at_rest,
    elementary_limit,
    eliminate_angle,
    ladder,
    ladder_order,
    monotone_on_half_line,
    one_root,
    read_circle,
    solve_motion,
    trace_circle,
)

chapter = Chapter("chord.linear_drag", notation, "4. Motion under a resistive force proportional to velocity")

QUARTER = Interval(-pi / 2, pi / 2)
INSIDE = Interval.open(-pi / 2, pi / 2)
MOTION = Domain({g: POSITIVE, gamma: POSITIVE, t: NONNEGATIVE, theta: QUARTER})
CIRCLE = Domain({g: POSITIVE, gamma: POSITIVE, t: POSITIVE, theta: QUARTER})
TIMES = Domain({g: POSITIVE, gamma: POSITIVE, t: NONNEGATIVE})
DESCENT = Domain({g: POSITIVE, D: POSITIVE, gamma: POSITIVE, theta: INSIDE})
DRAG = gamma * v  # the resistive force for unit mass that section 4 is about
FALLEN = g / gamma * t - g / gamma**2 * (1 - exp(-gamma * t))
FALLEN_AB = g / gamma * t_AB - g / gamma**2 * (1 - exp(-gamma * t_AB))
ALONG = gamma**2 * s_AB / (g * cos(theta))
BY_CHORD = (1 + ALONG + LambertW(-exp(-1 - ALONG))) / gamma  # when the bead has gone the length of its chord


@chapter.derive(
    "chord.eq28",
    Eq(s(t).diff(t, 2), g * cos(theta) - gamma * s(t).diff(t)),
    Domain(MOTION.ranges, where={f(v): DRAG}),
)
def motion(eq50):
    """(50) with the resistive force that this section assumes, gamma v for unit mass."""
    return eq50.equation.replace(f, sp.Lambda(v, DRAG))


@chapter.derive("chord.eq29", Eq(s(t), FALLEN * cos(theta)), MOTION)
def distance(eq28):
    """Solve (28) from rest."""
    return solve_motion(eq28.equation, s(t), at_rest(s(t)))


@chapter.derive(
    "chord.eq30",
    Eq(D, FALLEN_AB),
    Domain({g: POSITIVE, gamma: POSITIVE, t_AB: POSITIVE, theta: INSIDE}),
    erratum=Erratum(("C8",), "the equation has exactly one positive root (and one negative one), which is not argued"),
)
def impact(eq29, eq3):
    """Put s = D cos(theta) and divide by the cosine."""
    arrival = Eq(eq3.of(s_AB), eq29.rhs.subs(t, t_AB), evaluate=False)
    return Eq(D, sp.expand(arrival.rhs / (arrival.lhs / D)), evaluate=False)


@chapter.derive("chord.eq32", Eq(R(t), g / (2 * gamma) * t - g / (2 * gamma**2) * (1 - exp(-gamma * t))), TIMES)
def radius(eq29):
    """The fall along the vertical is a diameter."""
    step("a diameter", Eq(2 * R(t), eq29.rhs.subs(theta, 0), evaluate=False))
    return Eq(R(t), sp.expand(eq29.rhs.subs(theta, 0) / 2))


@chapter.derive("chord.eq31", Eq(x**2 + (y - R(t)) ** 2, R(t) ** 2), CIRCLE)
def synchronous_circle(eq29, eq32, setup, eq7, eq8):
    """x = R sin 2 theta, y = R (1 + cos 2 theta); eliminate theta."""
    rho = sp.Symbol("rho", positive=True)  # a plain name for R(t) while the basis is computed
    across, down = point_at(eq29, eq32, setup, eq7, eq8)
    equations = [step("coordinate", Eq(c, e)).subs(R(t), rho) for c, e in ((x, across), (y, down))]
    return eliminate_angle(*equations, 2 * theta, (x, y)).subs(rho, R(t))


def point_at(path, half, setup, double_sine, double_cosine):
    """x and y of a bead, with R(t) for half the fall along the vertical."""
    along = sp.simplify(path.rhs / half.rhs) * R(t)
    across, down = doubled_coordinates(along, setup, double_sine.rhs, double_cosine.rhs)
    return across, sp.expand(down)


@chapter.derive(
    "chord.claim.drag-sync-circles",
    And(
        TracesOnce(
            Tuple(R(t) * sin(2 * theta), R(t) * (1 + cos(2 * theta))),
            theta,
            QUARTER,
            Eq(x**2 + (y - R(t)) ** 2, R(t) ** 2),
            sp.true,
            Tuple(x, y),
            atan(x / y),
        ),
        Gt(R(t), 0),
        Eq(Tuple(x_c(t), y_c(t)), Tuple(0, R(t))),
    ),
    CIRCLE,
)
def whole_circles(eq29, eq31, eq32, setup, eq7, eq8):
    """Seen from the centre the bead is at the angle 2 theta; the centre is R below A, so the x-axis is a tangent."""
    seen = read_circle(eq31.equation, x, y)
    if seen.centre[0] != 0 or seen.centre[1] != seen.radius:
        raise DerivationError(f"a circle with the centre {seen.centre} and radius {seen.radius} does not touch in A")
    point = point_at(eq29, eq32, setup, eq7, eq8)
    grown = ladder(eq32.rhs, t).subs(eq32.rhs, eq32.lhs)
    traced = trace_circle(point, theta, QUARTER, eq31.equation, sp.true, (x, y), atan(x / y), facts={R(t): grown})
    return And(traced, grown, Eq(Tuple(x_c(t), y_c(t)), Tuple(*seen.centre)))


@chapter.derive(
    "chord.claim.paradox-persists-linear-drag",
    And(Independent(t_AB, theta), ExactlyOneRoot(FALLEN_AB - D, t_AB, Interval.open(0, oo))),
    Domain(DESCENT.ranges, where={t_AB: BY_CHORD, s_AB: D * cos(theta)}),
    erratum=Erratum(("C8",), "that the root is unique is not argued"),
)
def paradox_persists(eq30):
    """The right side of (30) increases from 0 without bound, so one positive time belongs to each D, whatever theta."""
    if eq30.statement.has(theta):
        raise DerivationError(f"{eq30.statement} depends on the angle")
    fall = eq30.rhs
    rising = monotone_on_half_line(fall, t_AB, Interval.open(0, oo))
    ends = (Eq(sp.Limit(fall, t_AB, 0, "+"), elementary_limit(fall, t_AB, 0), evaluate=False),)
    ends += (Eq(sp.Limit(fall, t_AB, oo, "-"), elementary_limit(fall, t_AB, oo, "-"), evaluate=False),)
    return And(Independent(t_AB, theta), one_root(rising, D, ends=ends))


@chapter.derive(
    "chord.claim.radius-slower",
    And(Gt(R(t), 0), Lt(R(t), g * t**2 / 4), Lt(R(t).diff(t), g * t / 2)),
    Domain({g: POSITIVE, gamma: POSITIVE, t: POSITIVE}, where={R(t): FALLEN / 2}),
)
def grows_more_slowly(eq32, eq10):
    """By the derivative ladder: both radii, and both slopes, begin with 0 and the derivatives are in this order."""
    slopes = [sp.diff(e.rhs, t) for e in (eq32, eq10)]
    grown, slower = ladder(eq32.rhs, t), ladder_order(eq32.rhs, eq10.rhs, t)
    slower_slope = ladder_order(*slopes, t)
    named = {eq32.rhs: eq32.lhs, slopes[0]: sp.Derivative(eq32.lhs, t)}
    return And(*(e.subs(named) for e in (grown, slower, slower_slope)))


if __name__ == "__main__":
    tell_chapter(chapter.name)
