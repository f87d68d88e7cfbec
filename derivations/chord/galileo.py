"""Sections 1 and 2: Galileo's kinematical paradox without resistance, equations (1) to (11)."""

import sympy as sp
from sympy import Abs, And, Eq, Interval, Tuple, Union, cos, pi, sin, sqrt

from galileo_sym.derivations.chord.notation import (
    D,
    R,
    g,
    notation,
    s,
    s_AB,
    s_BC,
    t,
    t_AB,
    t_AC,
    t_BC,
    tau,
    theta,
    x,
    x_c,
    y,
    y_c,
)  # fmt: skip
from galileo_sym.derivations.chord.shared import without_s
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
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    at_rest,
    eliminate_angle,
    isolate,
    read_circle,
    solve_motion,
    start_of,
    trace_circle,
)

chapter = Chapter("chord.galileo", notation, "2. Galileo's kinematical paradox: a brief review")

QUARTER = Interval(-pi / 2, pi / 2)
INSIDE = Interval.open(-pi / 2, pi / 2)
NOT_UPRIGHT = Union(Interval.open(-pi / 2, 0), Interval.open(0, pi / 2), evaluate=False)
MOTION = Domain({g: POSITIVE, t: NONNEGATIVE, theta: QUARTER})
CHORD = Domain({g: POSITIVE, D: POSITIVE, theta: INSIDE})
FALL = Domain({g: POSITIVE, D: POSITIVE})
MOMENT = Domain({g: POSITIVE, t: POSITIVE, theta: QUARTER})
LENGTH_ZERO = Erratum(
    ("C10",),
    "cos(theta) > 0 is needed: at theta = ±pi/2 the chord has length 0 and t_AB is 0/0",
    Eq(t_AB, sqrt(2 * s_AB / (g * cos(theta))), evaluate=False),
    Domain({g: POSITIVE, D: POSITIVE, theta: sp.FiniteSet(pi / 2)}, where={t_AB: sqrt(2 * D / g), s_AB: sp.S.Zero}),
)

chapter.given(
    "chord.setup",
    And(Eq(x, s(t) * sin(theta)), Eq(y, s(t) * cos(theta)), Eq(s(0), 0), Eq(s(t).diff(t).subs(t, 0), 0)),
    MOTION,
)

chapter.given(
    "chord.law.frictionless",
    Eq(s(t).diff(t, 2), g * cos(theta)),
    MOTION,
    premises=("chord.setup",),
)


@chapter.derive("chord.eq1", Eq(s(t), g * t**2 / 2 * cos(theta)), MOTION)
def distance(setup, law__frictionless):
    """Integrate the law from rest at A."""
    return solve_motion(law__frictionless.equation, s(t), start_of(setup.parts, s(t)))


@chapter.derive(
    "chord.eq2",
    Eq(t_AB, sqrt(2 * s_AB / (g * cos(theta)))),
    Domain({g: POSITIVE, s_AB: POSITIVE, theta: INSIDE}),
    erratum=LENGTH_ZERO,
)
def time_along_chord(eq1):
    """The bead is at B when s = s_AB; only the positive root is a time after the release."""
    arrival = Eq(s_AB, eq1.rhs.subs(t, t_AB), evaluate=False)
    found = isolate(arrival, t_AB, hide={cos(theta): sp.Symbol("c", positive=True)})
    step("put back in (1)", arrival)
    return found


@chapter.derive("chord.eq3", Eq(s_AB, D * cos(theta)), CHORD)
def chord_length(setup):
    """Meet the ray from A with the circle on the diameter AC; the angle at B is then a right one (Thales)."""
    place = sp.Matrix([setup.of(x), setup.of(y)]).subs(s(t), s_AB)  # of a bead at the distance s_AB from A
    below = place.subs(theta, 0)
    lowest = D * below / sp.sqrt(below.dot(below))  # C, the other end of the diameter
    on_circle = Eq((place - lowest / 2).dot(place - lowest / 2), lowest.dot(lowest) / 4, evaluate=False)
    length = sp.Symbol("length", real=True)
    on_ray = Eq(sp.simplify(on_circle.lhs), on_circle.rhs, evaluate=False).subs(s_AB, length)
    found = isolate(on_ray, length, drop={0: "the point A itself"})
    step("as far from the middle of AC as A", on_circle)
    to_a = place.subs(s_AB, found.rhs)
    step("BA and BC are perpendicular", Eq(to_a.dot(to_a - lowest), 0, evaluate=False))
    return found.subs(length, s_AB)


@chapter.derive("chord.eq4", Eq(t_AB, sqrt(2 * D / g)), CHORD, erratum=LENGTH_ZERO)
def descent_time(eq2, eq3):
    """Put the length of the chord in: the cosines cancel."""
    upright = sp.Symbol("upright", positive=True)  # the cosine, positive inside the assumptions
    plain = {cos(theta): upright}
    return Eq(t_AB, sp.simplify(eq2.rhs.subs(plain).subs(s_AB, eq3.of(s_AB).subs(plain))))


@chapter.derive(
    "chord.claim.paradox-AB",
    And(Eq(t_AB, sqrt(2 * D / g)), Independent(t_AB, theta)),
    Domain(CHORD.ranges, where={t_AB: sqrt(2 * s_AB / (g * cos(theta))), s_AB: D * cos(theta)}),
    erratum=Erratum(("C10",), "for |theta| < pi/2: at theta = ±pi/2 the chord has length 0 and no descent time"),
)
def paradox(eq4):
    """The angle is not in (4)."""
    if eq4.of(t_AB).has(theta):
        raise DerivationError(f"{eq4.statement} depends on the angle")
    return And(eq4.equation, Independent(t_AB, theta))


@chapter.derive(
    "chord.claim.paradox-BC",
    Eq(t_BC, sqrt(2 * D / g)),
    Domain({g: POSITIVE, D: POSITIVE, theta: NOT_UPRIGHT}),
)
def paradox_from_b(law__frictionless, eq3):
    """BC is inclined by pi/2 - |theta|, and Pythagoras gives its length D sin|theta|."""
    steep = law__frictionless.subs(theta, pi / 2 - Abs(theta))
    motion = solve_motion(steep, s(t), at_rest(s(t))).rhs
    length = isolate(
        Eq(s_BC**2, D**2 - eq3.of(s_AB) ** 2),
        s_BC,
        hide={sp.cos(theta) ** 2: 1 - sp.Symbol("sine", positive=True) ** 2},
    )
    length = length.subs(sp.Symbol("sine", positive=True), sin(Abs(theta)))
    step("length of BC", length)
    arrival = Eq(length.rhs, motion.subs(t, t_BC), evaluate=False)
    step("arrival at C", arrival)
    return isolate(arrival, t_BC, hide={sin(Abs(theta)): sp.Symbol("c", positive=True)})


@chapter.derive(
    "chord.claim.free-fall-AC-equals-slide-BC",
    And(Eq(t_AC, sqrt(2 * D / g)), Eq(t_BC, sqrt(2 * D / g)), Eq(t_AC, t_BC)),
    Domain({g: POSITIVE, D: POSITIVE, theta: NOT_UPRIGHT}),
)
def fall_and_slide(claim__paradox_BC, eq1):
    """The fall along AC is (1) at theta = 0."""
    fall = isolate(Eq(D, eq1.rhs.subs({theta: 0, t: t_AC}), evaluate=False), t_AC)
    slide = Eq(t_BC, claim__paradox_BC.of(t_BC))
    return And(fall, slide, step("equal times", Eq(t_AC, t_BC)))


@chapter.derive("chord.eq7", Eq(2 * sin(theta) * cos(theta), sin(2 * theta)), Domain({theta: REAL}))
def double_sine():
    """Addition theorem."""
    return Eq(sp.expand_trig(sin(2 * theta)), sin(2 * theta), evaluate=False)


@chapter.derive("chord.eq8", Eq(2 * cos(theta) ** 2, 1 + cos(2 * theta)), Domain({theta: REAL}))
def double_cosine():
    """Addition theorem."""
    return Eq(1 + sp.expand_trig(cos(2 * theta)), 1 + cos(2 * theta), evaluate=False)


@chapter.derive("chord.eq5", And(Eq(x, s(t) * sin(theta)), Eq(x, g * t**2 / 4 * sin(2 * theta))), MOTION)
def abscissa(setup, eq1, eq7):
    """Multiply (1) by the sine and use (7)."""
    product = sp.expand(setup.of(x).subs(s(t), eq1.rhs))
    return And(Eq(x, setup.of(x)), Eq(x, product.subs(sin(theta) * cos(theta), eq7.rhs / 2), evaluate=False))


@chapter.derive("chord.eq6", And(Eq(y, s(t) * cos(theta)), Eq(y, g * t**2 / 4 * (1 + cos(2 * theta)))), MOTION)
def ordinate(setup, eq1, eq8):
    """Multiply (1) by the cosine and use (8)."""
    product = sp.expand(setup.of(y).subs(s(t), eq1.rhs))
    return And(Eq(y, setup.of(y)), Eq(y, product.subs(cos(theta) ** 2, eq8.rhs / 2), evaluate=False))


@chapter.derive("chord.eq9", Eq(x**2 + (y - g * t**2 / 4) ** 2, (g * t**2 / 4) ** 2), MOTION)
def synchronous_circle(eq5, eq6):
    """Eliminate theta."""
    return eliminate_angle(without_s(eq5, x), without_s(eq6, y), 2 * theta, (x, y))


@chapter.derive("chord.eq10", Eq(R(t), g * t**2 / 4), Domain({g: POSITIVE, t: NONNEGATIVE}))
def radius(eq9):
    """Complete the squares in (9)."""
    step("the lowest point is a diameter away from A", eq9.equation.subs({x: 0, y: 2 * R(t)}))
    return Eq(R(t), read_circle(eq9.equation, x, y).radius)


CENTRE = Tuple(x_c(t), y_c(t))


@chapter.derive(
    "chord.claim.centre-accel",
    And(Eq(CENTRE, Tuple(0, g * t**2 / 4)), Eq(x_c(t).diff(t, 2), 0), Eq(y_c(t).diff(t, 2), g / 2)),
    Domain({g: POSITIVE, t: NONNEGATIVE}),
)
def centre_acceleration(eq9):
    """Read the centre off (9) and differentiate it twice."""
    centre = read_circle(eq9.equation, x, y).centre
    accelerations = (Eq(c(t).diff(t, 2), sp.diff(e, t, 2)) for c, e in zip((x_c, y_c), centre, strict=True))
    return And(Eq(CENTRE, Tuple(*centre)), *accelerations)


@chapter.derive(
    "chord.claim.sync-curve",
    TracesOnce(
        Tuple(g * t**2 / 4 * sin(2 * theta), g * t**2 / 4 * (1 + cos(2 * theta))),
        theta,
        QUARTER,
        Eq(x**2 + (y - g * t**2 / 4) ** 2, (g * t**2 / 4) ** 2),
        sp.true,
        Tuple(x, y),
        sp.atan(x / y),
    ),
    MOMENT,
    erratum=Erratum(("C10",), "the whole circle takes -pi/2 <= theta <= pi/2; both ends give the point A"),
)
def whole_circle(eq5, eq6, eq9):
    """Seen from the centre, the bead is at the angle 2 theta, which runs through a whole turn."""
    point = (without_s(eq5, x).rhs, without_s(eq6, y).rhs)
    moving = {t: step("after the release", sp.Gt(t, 0))}
    return trace_circle(point, theta, QUARTER, eq9.equation, sp.true, (x, y), sp.atan(x / y), facts=moving)


@chapter.derive(
    "chord.claim.expanding-circle-g2",
    And(
        Eq(x**2 + (y - g * t**2 / 4) ** 2, (g * t**2 / 4) ** 2),
        Eq((0 - x_c(t)) ** 2 + (0 - y_c(t)) ** 2, (g * t**2 / 4) ** 2),
        Eq(CENTRE, Tuple(0, g * t**2 / 4)),
        Eq(y_c(t).diff(t, 2), g / 2),
    ),
    MOTION,
)
def expanding_circle(eq5, eq6, eq9, claim__centre_accel):
    """All beads are on (9), which passes through A; the centre has a constant acceleration."""
    on_circle(eq9.equation, eq5, eq6)
    if is_zero((eq9.lhs - eq9.rhs).subs({x: 0, y: 0})) is None:
        raise DerivationError("(9) does not pass through A")
    centre = claim__centre_accel.of(x_c(t)), claim__centre_accel.of(y_c(t))
    through_a = Eq(x_c(t) ** 2 + y_c(t) ** 2, centre[0] ** 2 + centre[1] ** 2, evaluate=False)
    return And(eq9.equation, through_a, Eq(CENTRE, Tuple(*centre)), Eq(y_c(t).diff(t, 2), sp.diff(centre[1], t, 2)))


def on_circle(circle, eq5, eq6):
    """Refuse a circle on which the beads (5), (6) are not."""
    bead = {x: without_s(eq5, x).rhs, y: without_s(eq6, y).rhs}
    if is_zero((circle.lhs - circle.rhs).subs(bead)) is None:
        raise DerivationError(f"the beads {bead} are not on {circle}")
    step("a bead", Eq(Tuple(x, y), Tuple(bead[x], bead[y]), evaluate=False))


@chapter.derive("chord.eq11", Eq(tau, sqrt(2 * D / g)), FALL)
def free_fall(eq1):
    """(1) along the vertical diameter."""
    return isolate(Eq(D, eq1.rhs.subs({theta: 0, t: tau}), evaluate=False), tau)


@chapter.derive(
    "chord.claim.sync-circle-at-tau",
    Eq(x**2 + (y - D / 2) ** 2, (D / 2) ** 2),
    Domain({g: POSITIVE, D: POSITIVE, theta: QUARTER}, where={t: tau}),
)
def circle_at_tau(eq9, eq11, eq5, eq6):
    """Put t = tau in (9): the circle ABC."""
    on_circle(eq9.equation, eq5, eq6)
    return eq9.equation.subs(t, tau).subs(tau, eq11.rhs)


if __name__ == "__main__":
    tell_chapter(chapter.name)
