"""Section 4: a resistive force proportional to velocity, equations (28) to (36)."""

import sympy as sp
from sympy import And, Eq, Gt, Interval, Lt, Tuple, atan, cos, exp, oo, pi, sin

from galileo_sym.derivations.chord.notation import (
    D,
    F_d,
    F_g,
    R,
    g,
    gamma,
    m,
    notation,
    s,
    s_AB,
    t,
    t_AB,
    theta,
    x,
    y,
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
    monotone,
    one_root,
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
FALLEN = g / gamma * t - g / gamma**2 * (1 - exp(-gamma * t))
FALLEN_AB = g / gamma * t_AB - g / gamma**2 * (1 - exp(-gamma * t_AB))


@chapter.derive(
    "chord.eq28",
    Eq(s(t).diff(t, 2), g * cos(theta) - gamma * s(t).diff(t)),
    Domain({m: POSITIVE, **MOTION.ranges}),
)
def motion(law__friction):
    """Newton's law along the chord: gravity, and a drag of gamma for unit mass and speed, against the motion."""
    pull = step("gravity along the chord", Eq(F_g, law__friction.of(F_g)))
    drag = step("drag", Eq(F_d, m * gamma * s(t).diff(t), evaluate=False))
    return Eq(s(t).diff(t, 2), sp.expand((pull.rhs - drag.rhs) / m), evaluate=False)


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
    ),
    CIRCLE,
)
def whole_circles(eq29, eq31, eq32, setup, eq7, eq8):
    """Seen from the centre the bead is at the angle 2 theta; the circle touches the x-axis in A."""
    touching = eq31.equation.subs(y, 0)
    if sp.solve(touching.lhs - touching.rhs, x) != [0]:
        raise DerivationError("the circle does not touch the x-axis in A alone")
    point = point_at(eq29, eq32, setup, eq7, eq8)
    traced = trace_circle(point, theta, QUARTER, eq31.equation, sp.true, (x, y), atan(x / y))
    z = sp.Symbol("z", positive=True)
    ladder(sp.expand(eq32.rhs.subs(t, z / gamma) * gamma**2 / g), z)
    return And(traced, Gt(R(t), 0))


@chapter.derive(
    "chord.claim.paradox-persists-linear-drag",
    And(Independent(FALLEN_AB, theta), ExactlyOneRoot(FALLEN_AB - D, t_AB, Interval.open(0, oo))),
    Domain({**DESCENT.ranges, t_AB: POSITIVE}),
    erratum=Erratum(("C8",), "that the root is unique is not argued"),
)
def paradox_persists(eq30):
    """The right side of (30) increases from 0 without bound, so one positive time belongs to each D, whatever theta."""
    fall = eq30.rhs
    slope = sp.expand(sp.diff(fall, t_AB) * gamma / g)
    z = sp.Symbol("z", positive=True)
    ladder(slope.subs(t_AB, z / gamma), z)
    rising = monotone(fall, t_AB, Interval.open(0, oo), 1)
    ends = (Eq(sp.Limit(fall, t_AB, 0, "+"), elementary_limit(fall, t_AB, 0), evaluate=False),)
    ends += (Eq(sp.Limit(fall, t_AB, oo, "-"), elementary_limit(fall, t_AB, oo, "-"), evaluate=False),)
    return And(Independent(fall, theta), one_root(rising, D, ends=ends))


@chapter.derive(
    "chord.claim.radius-slower",
    And(Gt(R(t), 0), Lt(R(t), g * t**2 / 4), Lt(R(t).diff(t), g * t / 2)),
    Domain({g: POSITIVE, gamma: POSITIVE, t: POSITIVE}, where={R(t): FALLEN / 2}),
)
def grows_more_slowly(eq32, eq10):
    """With z = gamma t: z^2/2 > z - 1 + e^(-z) > 0, and z > 1 - e^(-z)."""
    z = sp.Symbol("z", positive=True)
    unit = {t: z / gamma}
    scale = 2 * gamma**2 / g
    with_drag, without = (sp.expand(e.rhs.subs(unit) * scale) for e in (eq32, eq10))
    ladder(with_drag, z)
    ladder(without - with_drag, z)
    slopes = [sp.expand(sp.diff(e.rhs, t).subs(unit) * 2 * gamma / g) for e in (eq32, eq10)]
    ladder(slopes[1] - slopes[0], z)
    return And(Gt(R(t), 0), Lt(R(t), eq10.rhs), Lt(R(t).diff(t), sp.diff(eq10.rhs, t)))


if __name__ == "__main__":
    tell_chapter(chapter.name)
