"""Section 6: which resistive forces f(v) preserve Galileo's paradox, equations (50) to (53)."""

import sympy as sp
from sympy import And, Eq, Gt, Implies, Interval, LambertW, Lt, Max, Tuple, atan, cos, exp, log, oo, pi, sin

from galileo_sym.derivations.chord.notation import (
    AB,
    D,
    R,
    T,
    b,
    f,
    g,
    gamma,
    notation,
    s,
    s_AB,
    t,
    t_0,
    theta,
    v,
    v_1,
    v_sup,
    when,
    x,
    y,
)  # fmt: skip
from galileo_sym.derivations.chord.shared import centred
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    ForAll,
    Independent,
    StrictlyIncreasing,
    TracesOnce,
    step,
    tell_chapter,
)
from galileo_sym.tactics import (
    by_differentiation,
    elementary_limit,
    eliminate,
    homogeneous,
    independent_sides,
    instantiate,
    isolate,
    modus_ponens,
    proportional_below,
    same_argument,
    sign_by_factors,
    trace_circle,
    values_ordered,
)

chapter = Chapter("chord.which_forces", notation, "6. Which dissipative forces preserve Galileo's paradox?")

INSIDE = Interval.open(-pi / 2, pi / 2)
SPEED = 2 * R(t).diff(t)  # along AC

# 2R(t) is the distance along AC. The paradox: whatever D, when the bead on AC is at C, at T(D), each other is at its B.
NEVER_BACK = StrictlyIncreasing(2 * R(t), t, Interval(0, oo))
PARADOX = ForAll(And(Eq(2 * R(T(D)), D), Eq(s(T(D)), AB(D))), D, Interval.open(0, 2 * R(t_0)))
SUPPOSED = (NEVER_BACK, PARADOX)


def linear(drag):
    """What is put in for the unknowns where a statement is tried: the motions with linear drag."""
    fallen = g / drag * t - g / drag**2 * (1 - exp(-drag * t))
    descent = 1 / drag + drag * D / g + LambertW(-exp(-1 - drag**2 * D / g)) / drag
    return {f(v): drag * v, s(t): fallen * cos(theta), R(t): fallen / 2, T(D): descent, AB(D): D * cos(theta)}


UNTIL = {g: POSITIVE, gamma: POSITIVE, t_0: POSITIVE, theta: INSIDE, t: Interval.Ropen(0, t_0)}
BEAD = {x: s(t) * sin(theta), y: s(t) * cos(theta)}
MOVING = Domain({**UNTIL, t: Interval.open(0, t_0)}, {**linear(gamma), **BEAD}, SUPPOSED)
MOTION = Domain(UNTIL, linear(gamma), SUPPOSED)

CIRCLE = Eq(x**2 + (y - R(t)) ** 2, R(t) ** 2)
BEAD_AT = Tuple(2 * R(t) * sin(theta) * cos(theta), 2 * R(t) * cos(theta) ** 2)
BUT_FOR_A = TracesOnce(BEAD_AT, theta, INSIDE, CIRCLE, Gt(y, 0), Tuple(x, y), atan(x / y))
CONDITION = Eq(f(SPEED * cos(theta)) / (2 * cos(theta)), g / 2 - R(t).diff(t, 2))

chapter.given(
    "chord.eq50",
    Eq(s(t).diff(t, 2), g * cos(theta) - f(s(t).diff(t))),
    Domain({g: POSITIVE, t: NONNEGATIVE, theta: Interval(-pi / 2, pi / 2)}),
    premises=("chord.setup",),
    erratum=Erratum(
        ("C13",),
        "f must be a function of the speed alone, the same on every chord: sliding friction, which depends on theta "
        "through the normal force, is not of this form",
    ),
)


@chapter.derive(
    "chord.claim.paradox-implies-circles",
    Implies(
        And(*SUPPOSED),
        And(CIRCLE, Eq(Tuple(x, y), BEAD_AT), BUT_FOR_A, Gt(s(t), 0), Eq(2 * R(t).diff(t, 2), g - f(SPEED))),
    ),
    Domain(MOVING.ranges, MOVING.where),
    erratum=Erratum(
        ("C13",),
        "this needs the paradox for every D, in order that (51) holds at every time: with one circle only, nothing is "
        "said of other times; the bead on AC must start and never turn back",
    ),
)
def circles(eq3, eq50, setup):
    """At the time t take D = 2R(t), the distance along AC: then T(D) = t, and every bead is at its B.

    Seen from the centre that B is at the angle 2 theta: all beads together are on the whole circle but for A.
    """
    moving = [step("after the release", Gt(t, 0)), step("and before t_0", Lt(t, t_0))]
    below = values_ordered(NEVER_BACK, 0, t, moving).subs(R(0), setup.of(s(0)) / 2)  # 2R is s at theta = 0
    above = values_ordered(NEVER_BACK, t, t_0, moving)
    inside = [step("the bead has left A", below), step("it is not yet where it is at t_0", above)]
    on_ac, on_ab = sorted(instantiate(PARADOX, 2 * R(t), inside).args, key=lambda e: e.has(s))
    now = step("2R takes no value twice", same_argument(NEVER_BACK, on_ac, T(2 * R(t)), t))
    chord = on_ab.subs(AB(2 * R(t)), eq3.of(s_AB).subs(D, 2 * R(t)))
    path = step("every bead is at its B", chord.subs(now.lhs, now.rhs))
    upright = step("inside a quarter turn", Gt(cos(theta), 0))
    if sign_by_factors(path.rhs, {2 * R(t): Gt(below.gts, below.lts), cos(theta): upright}) < 0:
        raise DerivationError("the beads move upwards")
    vertical = eq50.subs(theta, 0).subs(s(t), 2 * R(t)).doit()
    circle = circle_of(path, setup)
    point = Tuple(*(setup.of(place).subs(s(t), path.rhs) for place in (x, y)))
    radius = {R(t): Gt(below.gts / 2, below.lts / 2)}
    traced = trace_circle(point, theta, INSIDE, circle, Gt(y, 0), (x, y), atan(x / y), facts=radius)
    motion = Eq(2 * R(t).diff(t, 2), vertical.rhs)
    return Implies(And(*SUPPOSED), And(circle, Eq(Tuple(x, y), point), traced, Gt(s(t), 0), motion))


def circle_of(path, setup):
    """Eliminate the angle from the coordinates of a bead on its path."""
    c, sine, rho = sp.symbols("c sine rho", positive=True)
    plain = {cos(theta): c, sin(theta): sine, R(t): rho}
    on_path = [setup.of(place).subs(s(t), path.rhs).subs(plain) - place for place in (x, y)]
    found = eliminate([*on_path, c**2 + sine**2 - 1], (c, sine), (x, y))
    return centred(found.subs(rho, R(t)))


@chapter.derive("chord.eq51", CIRCLE, MOVING)
def synchronous_circle(claim__paradox_implies_circles):
    """The conclusion of the claim before, the paradox supposed."""
    conclusion = modus_ponens(claim__paradox_implies_circles.statement, SUPPOSED)
    return centred(next(e for e in conclusion.args if isinstance(e, Eq) and e.lhs.has(x) and e.rhs.has(R)))


@chapter.derive(
    "chord.eq52",
    Eq(s(t), 2 * R(t) * cos(theta)),
    MOTION,
    erratum=Erratum(
        ("C14",),
        "(51) has the root s = 0, too: it is dropped since, by the paradox, each bead has left A",
        Implies(CIRCLE.subs(BEAD), Eq(s(t), 2 * R(t) * cos(theta))),
        Domain({**UNTIL, t: Interval.open(0, t_0)}, where={s(t): sp.S.Zero}),
    ),
)
def path(eq51, setup, claim__paradox_implies_circles):
    """Put x = s sin(theta), y = s cos(theta) in (51): s = 0 or s = 2 R cos(theta). At t = 0 both are right."""
    told = modus_ponens(claim__paradox_implies_circles.statement, SUPPOSED).args
    moved = next(e for e in told if e.args[0] == s(t))
    if not isinstance(moved, sp.StrictGreaterThan) or moved.rhs != 0 or setup.of(s(0)) != 0:
        raise DerivationError(f"{moved} does not say that the bead has left A")
    length = sp.Dummy("s", real=True)
    bead = {place: setup.of(place).subs(s(t), length) for place in (x, y)}
    on_chord = sp.factor(sp.trigsimp(sp.expand((eq51.lhs - eq51.rhs).subs(bead))))
    step("(51) on the chord", Eq(on_chord.subs(length, s(t)), 0, evaluate=False))
    return isolate(Eq(on_chord, 0, evaluate=False), length, drop={0: "the bead has left A"}).subs(length, s(t))


def condition_for(law, along):
    """What the equation of motion says of R if s = 2 R(t) cos(theta), divided by 2 cos(theta)."""
    moved = law.subs(s(t), along).doit()
    balance = sp.Eq(moved.rhs - moved.lhs, 0, evaluate=False)
    force = f(sp.diff(along, t))
    rest = sp.expand((balance.lhs + force) / (2 * cos(theta)))
    return Eq(force / (2 * cos(theta)), rest, evaluate=False)


@chapter.derive("chord.eq53", CONDITION, MOTION)
def condition(eq50, eq52):
    """Put (52) in (50) and divide by 2 cos(theta), which is not 0 inside a quarter turn."""
    return condition_for(eq50.equation, eq52.of(s(t)))


@chapter.derive(
    "chord.claim.rhs-independent",
    And(
        Independent(g / 2 - R(t).diff(t, 2), theta),
        Independent(f(SPEED * cos(theta)) / (2 * cos(theta)), theta),
        Eq(f(SPEED * cos(theta)), cos(theta) * f(SPEED)),
    ),
    Domain(UNTIL, {**MOTION.where, R(t): s(t) / (2 * cos(theta))}, SUPPOSED),  # as it is seen on each chord
)
def independent(eq53):
    """R(t) does not depend on theta, so neither does the left side, which is therefore what it is at theta = 0."""
    left, right = independent_sides(eq53.equation, theta, hidden=(s,))
    return And(right, left, homogeneous(left, f, hidden=(s,)))


LAW = ForAll(Eq(s(t).diff(t, 2), g * cos(theta) - f(s(t).diff(t))), t, Interval.Ropen(0, t_0))
SPEED_THEN = 2 * sp.Subs(R(t).diff(t), t, when(v))
REACHED = ForAll(And(Gt(SPEED_THEN, v), Lt(when(v), t_0)), v, Interval.open(0, v_sup))
HYPOTHESES = And(LAW, *SUPPOSED, REACHED)
UP_TO = {g: POSITIVE, b: POSITIVE, v_sup: Interval.open(0, g / b), theta: INSIDE, v_1: Interval.open(0, v_sup)}
REACHES = -log(1 - b * v / g) / b  # the time at which the bead on AC has the speed v
UNKNOWNS = {
    **linear(b),
    t_0: REACHES.subs(v, v_sup),
    when(v): (REACHES + REACHES.subs(v, v_sup)) / 2,
    gamma: f(v_1) / v_1,
}
# the literal statement fails for a force that is linear up to 4.9 m/s, a speed no bead reaches
KINKED = {f(v): sp.Piecewise((2 * v, v <= sp.Rational(49, 10)), (2 * v + 7 * (v - sp.Rational(49, 10)) ** 2, True))}


@chapter.derive(
    "chord.claim.only-linear",
    Implies(HYPOTHESES, And(Eq(f(0), 0), ForAll(Eq(f(v), gamma * v), v, Interval.open(0, v_sup)))),
    Domain({**UP_TO, v: Interval.open(0, v_sup)}, UNKNOWNS),
    erratum=Erratum(
        ("C13",),
        "only for the speeds 0 <= v < v_sup reached from rest (g/gamma at last, for gamma > 0): above them f is "
        "free. The paradox is needed for every D, and f must not depend on theta",
        Implies(HYPOTHESES, ForAll(Eq(f(v), gamma * v), v, POSITIVE)),
        Domain({**UP_TO, g: sp.FiniteSet(sp.Rational(49, 5)), b: sp.FiniteSet(2)}, {**UNKNOWNS, **KINKED}),
    ),
)
def only_linear(claim__rhs_independent, eq50, setup):
    """While the bead on AC has the speed u, those on the other chords have all speeds below: f(v)/v = f(u)/u.

    So f(v)/v is the same for any two speeds below v_sup: take u above both. No regularity of f is needed; where f is
    differentiable, dsolve finds the same. gamma stands for f(v_1)/v_1, with any v_1 below v_sup.
    """
    law = ForAll(eq50.equation, t, Interval.Ropen(0, t_0))
    scaling = next(e for e in claim__rhs_independent.parts if isinstance(e, Eq))
    below = [Lt(v, v_sup), Lt(v_1, v_sup)]
    speed = instantiate(REACHED, Max(v, v_1), below).args
    faster = next(e for e in speed if isinstance(e, sp.StrictGreaterThan))
    moment = next(e for e in speed if isinstance(e, sp.StrictLessThan) and e.rhs == t_0).lhs
    step("two speeds v and v_1, and a time at which the bead on AC is faster", faster)
    then = scaling.xreplace({R(t).diff(t): sp.Subs(R(t).diff(t), t, moment)})
    ratios = [proportional_below(then, f, theta, one, faster) for one in (v, v_1)]
    for ratio in ratios:
        step("the chord on which the bead has that speed then", ratio)
    top = isolate(ratios[1], f(faster.lhs))
    constant = isolate(ratios[0].subs(top.lhs, top.rhs), f(v))
    with_gamma = Eq(constant.lhs, constant.rhs.subs(f(v_1), gamma * v_1), evaluate=False)
    equation, solution = by_differentiation(scaling, f, theta, v)
    step("where f is differentiable", equation)
    if sp.simplify(solution.rhs.subs(sp.Symbol("C1"), gamma) - with_gamma.rhs) != 0:
        raise DerivationError(f"{solution} is not {with_gamma}")
    still = scaling.subs(R(t).diff(t), setup.of(s(t).diff(t).subs(t, 0)) / 2)  # t = 0, and 2R is s at theta = 0
    at_rest = step("at t = 0, on the chord at 60 degrees", isolate(still.subs(theta, pi / 3), f(0)))
    conclusion = And(at_rest, ForAll(with_gamma, v, Interval.open(0, v_sup)))
    return Implies(And(law, *SUPPOSED, REACHED), conclusion)


HALF = g / (2 * gamma) * t - g / (2 * gamma**2) * (1 - exp(-gamma * t))
BOTH_SIDES = g / 2 * (1 - exp(-gamma * t))


@chapter.derive(
    "chord.claim.linear-suffices",
    And(Eq(CONDITION.lhs, BOTH_SIDES), Eq(CONDITION.rhs, BOTH_SIDES)),
    Domain(
        {g: POSITIVE, gamma: POSITIVE, t: NONNEGATIVE, theta: INSIDE},
        where={f(v): gamma * v, R(t): HALF, s(t): 2 * R(t) * cos(theta)},
    ),
)
def linear_suffices(eq50, eq32, setup):
    """The condition (53), here formed anew since the paradox is not supposed, holds for gamma v and the R of (32).

    So s = 2 R cos(theta) satisfies (50); it starts at rest in A. Its speed on AC tends to g/gamma.
    """
    asked = condition_for(eq50.equation, 2 * R(t) * cos(theta))
    half = eq32.of(R(t))
    sides = [e.subs(R(t), half).doit().replace(f, lambda speed: gamma * speed) for e in asked.args]
    sides = [sp.expand(sp.cancel(side)) for side in sides]
    if sp.expand(sides[0] - sides[1]) != 0:
        raise DerivationError(f"{sides} differ")
    for begin, order in ((s(0), 0), (s(t).diff(t).subs(t, 0), 1)):
        found = sp.diff(2 * half * cos(theta), t, order).subs(t, 0)
        if sp.simplify(found - setup.of(begin)) != 0:
            raise DerivationError(f"the motion begins with {begin} = {found}")
    fastest = elementary_limit(2 * sp.diff(half, t), t, oo, "-")
    step("speeds that are reached", Lt(2 * sp.diff(half, t), fastest, evaluate=False))
    step("and v_sup", Eq(sp.Limit(2 * sp.diff(half, t), t, oo, "-"), fastest, evaluate=False))
    return And(*(Eq(left, right) for left, right in zip(asked.args, sides, strict=True)))


if __name__ == "__main__":
    tell_chapter(chapter.name)
