"""Section 3, first half: motion with sliding friction, equations (12) to (20)."""

import sympy as sp
from sympy import Abs, And, Eq, Gt, Interval, Le, Lt, atan, cos, pi, sin, sqrt, tan

from galileo_sym.derivations.chord.notation import (
    ACUTE,
    D,
    F_f,
    F_g,
    N,
    g,
    m,
    mu,
    n,
    notation,
    s,
    s_AB,
    t,
    t_AB,
    theta,
    theta_max,
    x,
    y,
)
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    StrictlyDecreasing,
    StrictlyIncreasing,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    compose_monotone,
    isolate,
    monotone_by_slope,
    positive_before_root,
    solve_angle,
    solve_motion,
    start_of,
    substitute,
    values_ordered,
)

chapter = Chapter("chord.sliding_friction", notation, "3. Sliding friction")

LAST = atan(1 / mu)
TO_THE_RIGHT = Interval.Ropen(0, LAST)
TO_THE_LEFT = Interval.open(-LAST, 0)
SLIDING = Domain({g: POSITIVE, mu: POSITIVE, t: NONNEGATIVE, theta: TO_THE_RIGHT})
SLIDING_LEFT = Domain({g: POSITIVE, mu: POSITIVE, t: NONNEGATIVE, theta: TO_THE_LEFT})
POSITIONS = Domain({g: POSITIVE, mu: POSITIVE, t: NONNEGATIVE, theta: Interval(0, LAST)})
DESCENT = Domain({g: POSITIVE, D: POSITIVE, mu: POSITIVE, theta: TO_THE_RIGHT})
# all angles, in pieces: so that theta_max itself is tried
ABOUT_LAST = sp.Union(
    Interval.open(-pi / 2, -LAST),
    sp.FiniteSet(-LAST),
    Interval.open(-LAST, LAST),
    sp.FiniteSet(LAST),
    Interval.open(LAST, pi / 2),
    evaluate=False,
)
WITH_MASS = Domain({m: POSITIVE, **SLIDING.ranges})
WITH_MASS_LEFT = Domain({m: POSITIVE, **SLIDING_LEFT.ranges})
LAW = Domain({g: POSITIVE, m: POSITIVE, mu: NONNEGATIVE, theta: Interval.open(-pi / 2, pi / 2)})

REST_AT_END = Erratum(
    ("C1",),
    "at |theta| = theta_max the right side is 0 and the bead stays at A: the range is open, as in (14), at both ends",
)
STRICT = Erratum(
    ("C1", "C2"),
    "from rest the inequality must be strict; the coefficient of static friction is taken to be mu_k, and mu_k > 0",
)


def endless(printed, time, end=LAST):
    """C3: at theta_max the time is infinite; no finite time satisfies the printed equation there."""
    return Erratum(
        ("C3",),
        "strictly |theta| < theta_max: at theta_max the denominator vanishes and the time is infinite",
        printed,
        Domain({g: POSITIVE, D: POSITIVE, s_AB: POSITIVE, mu: POSITIVE, theta: sp.FiniteSet(end)}, where={t_AB: time}),
    )


chapter.given(
    "chord.law.friction",
    And(Eq(N, m * g * sin(Abs(theta))), Eq(F_f, mu * N), Eq(F_g, m * g * cos(theta))),
    LAW,
    premises=("chord.setup",),
    erratum=Erratum(("C2",), "static friction is ignored: its coefficient is taken to be mu_k"),
)


def newton_along_chord(friction, law, side):
    """m s'' = gravity along the chord - friction, for a bead that slides down; side is the sign of theta."""
    pull = law.of(F_g)
    hold = friction.subs(N, law.of(N)).subs(Abs(theta), side * theta)
    step("Newton along the chord", Eq(m * s(t).diff(t, 2), pull - hold, evaluate=False))
    return Eq(s(t).diff(t, 2), sp.factor(sp.expand((pull - hold) / m)), evaluate=False)


@chapter.derive(
    "chord.eq12",
    Eq(s(t).diff(t, 2), g * (cos(theta) - mu * sin(theta))),
    Domain({m: POSITIVE, **SLIDING.ranges}),
    erratum=STRICT,
)
def motion(law__friction):
    """Newton's law along the chord, theta >= 0."""
    return newton_along_chord(law__friction.of(F_f), law__friction, 1)


@chapter.derive(
    "chord.eq14",
    Eq(s(t).diff(t, 2), g * (cos(theta) + mu * sin(theta))),
    Domain({m: POSITIVE, **SLIDING_LEFT.ranges}),
    erratum=REST_AT_END,
)
def motion_left(law__friction):
    """Newton's law along the chord, theta < 0: the normal force is -m g sin(theta)."""
    return newton_along_chord(law__friction.of(F_f), law__friction, -1)


@chapter.derive("chord.eq13", Eq(theta_max, atan(1 / mu)), Domain({g: POSITIVE, mu: POSITIVE}), erratum=STRICT)
def largest_angle(eq12):
    """The acceleration vanishes at theta_max."""
    balance = step("no acceleration", Eq(0, eq12.rhs.subs(theta, theta_max), evaluate=False))
    return solve_angle(balance, theta_max, ACUTE)


@chapter.derive(
    "chord.claim.slides-iff",
    sp.Equivalent(Gt(cos(theta) - mu * sin(Abs(theta)), 0), Lt(Abs(theta), theta_max)),
    Domain({g: POSITIVE, mu: POSITIVE, theta: ABOUT_LAST}),
    erratum=Erratum(
        ("C1", "C2"),
        "printed with theta <= theta_max: at theta_max the bead stays at A (needs also static = kinetic friction)",
        sp.Equivalent(Gt(cos(theta) - mu * sin(Abs(theta)), 0), Le(Abs(theta), theta_max)),
        Domain({mu: POSITIVE, theta: sp.FiniteSet(LAST, -LAST)}, where={theta_max: LAST}),
    ),
)
def slides_iff(eq12, eq13, eq14):
    """The acceleration has the sign of 1 - mu*tan|theta|, which decreases and vanishes at theta_max."""
    angle = sp.Dummy("angle", nonnegative=True)
    right = eq12.rhs.subs(theta, angle)
    if sp.simplify(right - eq14.rhs.subs(theta, -angle)) != 0:
        raise DerivationError("(12) and (14) are not mirror images")
    factor = sp.expand(right / (g * cos(angle))).replace(sin, lambda a: tan(a) * cos(a))
    falling = monotone_by_slope(factor, angle, Interval.Ropen(0, pi / 2))
    chords = step("all chords", Lt(Abs(theta), pi / 2))
    before = positive_before_root(falling, eq13.of(theta_max), Abs(theta), [chords])
    times_cosine = sp.expand(factor.subs(angle, Abs(theta)) * cos(theta)).subs(
        tan(Abs(theta)) * cos(theta), sin(Abs(theta))
    )
    condition = next(a for a in before.args if isinstance(a, sp.StrictLessThan))
    return sp.Equivalent(Gt(times_cosine, 0), condition.subs(eq13.of(theta_max), theta_max))


@chapter.derive("chord.eq15", Eq(s(t), g * t**2 / 2 * (cos(theta) - mu * sin(theta))), POSITIONS)
def distance(eq12, setup):
    """Solve (12) from rest."""
    return solve_motion(eq12.equation, s(t), start_of(setup.parts, s(t)))


EQ16 = Eq(t_AB, sqrt(2 * s_AB / (g * (cos(theta) - mu * sin(theta)))))


@chapter.derive(
    "chord.eq16",
    EQ16,
    Domain({g: POSITIVE, s_AB: POSITIVE, mu: POSITIVE, theta: TO_THE_RIGHT}),
    erratum=endless(EQ16, sqrt(2 * s_AB / g)),
)
def time_along_chord(eq15, claim__slides_iff):
    """The bead is at B when s = s_AB."""
    return arrival_time(eq15.equation, s_AB, claim__slides_iff, 1)


def arrival_time(motion, length, slides, side):
    """Solve for the time at which a bead that slides is at B; only the positive root is after the release."""
    arrival = step("arrival at B", Eq(length, sp.factor(motion.rhs.subs(t, t_AB)), evaluate=False))
    (pull,) = (e for e in sp.Mul.make_args(arrival.rhs) if e.has(theta))
    told = slides.statement.atoms(sp.StrictGreaterThan).pop().subs(Abs(theta), side * theta)
    if is_zero(pull - (told.lhs - told.rhs)) is None:
        raise DerivationError(f"{told} does not say that {pull} is positive")
    step("the bead slides", told)
    return isolate(arrival, t_AB, hide={pull: sp.Symbol("pull", positive=True)})


EQ17 = Eq(t_AB, sqrt((2 * D / g) / (1 - mu * tan(theta))))
EQ18 = Eq(t_AB, sqrt((2 * D / g) / (1 + mu * tan(theta))))


@chapter.derive("chord.eq17", EQ17, DESCENT, erratum=endless(EQ17, sqrt(2 * D / g)))
def descent_time(eq16, eq3):
    """Put the length of the chord in and divide by the cosine."""
    return substitute(eq16.equation, {s_AB: eq3.of(s_AB)}, tidy=over_cosine)


def over_cosine(root):
    """Write a square root of a quotient of sines and cosines with the tangent alone."""
    inside = sp.simplify(root**2)
    top, bottom = sp.fraction(inside)
    tangent = sp.expand(bottom / cos(theta)).replace(sin, lambda a: tan(a) * cos(a))
    return sqrt(sp.simplify(top / cos(theta)) / tangent)


@chapter.derive(
    "chord.eq18",
    EQ18,
    Domain({g: POSITIVE, D: POSITIVE, mu: POSITIVE, theta: Interval.Lopen(-LAST, 0)}),
    erratum=endless(EQ18, sqrt(2 * D / g), -LAST),
)
def descent_time_left(eq14, eq3, setup, claim__slides_iff):
    """The same with (14)."""
    path = solve_motion(eq14.equation, s(t), start_of(setup.parts, s(t)))
    return substitute(arrival_time(path, s_AB, claim__slides_iff, -1), {s_AB: eq3.of(s_AB)}, tidy=over_cosine)


@chapter.derive(
    "chord.claim.steeper-sooner",
    And(
        StrictlyIncreasing(EQ17.rhs, theta, TO_THE_RIGHT),
        StrictlyDecreasing(EQ18.rhs, theta, Interval.Lopen(-LAST, 0)),
    ),
    DESCENT,
)
def steeper_sooner(eq17, eq18):
    """The time falls with n = 1 - mu*tan|theta| > 0, and n falls with |theta|."""
    sides = ((eq17.rhs, -1, TO_THE_RIGHT), (eq18.rhs, 1, Interval.Lopen(-LAST, 0)))
    facts = []
    for time, sign, where in sides:
        by_n = monotone_by_slope(sp.simplify(time.subs(tan(theta), sign * (n - 1) / mu)), n, POSITIVE)
        inner = step("n on one side", monotone_by_slope(1 + sign * mu * tan(theta), theta, where))
        facts.append(compose_monotone(by_n, inner))
    return And(*facts)


@chapter.derive(
    "chord.claim.friction-breaks-paradox",
    Lt(sqrt(2 * D / g), sqrt((2 * D / g) / (1 - mu * tan(theta)))),
    Domain({g: POSITIVE, D: POSITIVE, mu: POSITIVE, theta: Interval.open(0, LAST)}),
)
def friction_breaks_paradox(claim__steeper_sooner):
    """The vertical chord is the quickest."""
    rising = next(part for part in claim__steeper_sooner.parts if isinstance(part, StrictlyIncreasing))
    inside = [step("beside the vertical", Gt(theta, 0)), step("a bead that slides", Lt(theta, LAST))]
    return values_ordered(rising, 0, theta, inside)


@chapter.derive(
    "chord.eq19",
    And(Eq(x, s(t) * sin(theta)), Eq(x, g * t**2 / 4 * (sin(2 * theta) - mu * (1 - cos(2 * theta))))),
    POSITIONS,
)
def abscissa(eq15, eq7, eq8, setup):
    """Multiply (15) by the sine; use (7), and (8) with cos^2 = 1 - sin^2."""
    product = sp.expand(setup.of(x).subs(s(t), eq15.rhs))
    square = 1 - eq8.rhs / 2
    doubled = product.subs(sin(theta) * cos(theta), eq7.rhs / 2).subs(sin(theta) ** 2, square)
    return And(Eq(x, setup.of(x)), Eq(x, doubled, evaluate=False))


@chapter.derive(
    "chord.eq20",
    And(Eq(y, s(t) * cos(theta)), Eq(y, g * t**2 / 4 * ((1 + cos(2 * theta)) - mu * sin(2 * theta)))),
    POSITIONS,
)
def ordinate(eq15, eq7, eq8, setup):
    """Multiply (15) by the cosine; use (7) and (8)."""
    product = sp.expand(setup.of(y).subs(s(t), eq15.rhs))
    doubled = product.subs(sin(theta) * cos(theta), eq7.rhs / 2).subs(cos(theta) ** 2, eq8.rhs / 2)
    return And(Eq(y, setup.of(y)), Eq(y, doubled, evaluate=False))


if __name__ == "__main__":
    tell_chapter(chapter.name)
