"""Section 5: sliding friction and linear drag together, equations (40) to (49)."""

import sympy as sp
from sympy import Abs, And, Eq, FiniteSet, Ge, Gt, Implies, Interval, LambertW, Rational, atan, cos, exp, sin, sqrt, tan

from galileo_sym.derivations.chord.notation import (
    W_0,
    D,
    R,
    X,
    Y,
    g,
    gamma,
    mu,
    n,
    notation,
    q,
    s,
    s_AB,
    sigma,
    t,
    t_AB,
    theta,
    x,
    xt,
    y,
    yt,
)
from galileo_sym.derivations.chord.shared import (
    LAST_FROM_0,
    WITH_OR_WITHOUT,
    doubled_coordinates,
    require_without_friction,
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
    above_end,
    at_rest,
    check_root,
    compose_monotone,
    eliminate_angle,
    implicit_derivative,
    isolate,
    ladder,
    monotone,
    monotone_by_slope,
    read_circle,
    sign_by_ladder,
    solve_motion,
)

chapter = Chapter(
    "chord.friction_and_drag", notation, "5. Motion under sliding friction and resistive force proportional to velocity"
)

LAST = atan(1 / mu)
BOTH = {g: POSITIVE, gamma: POSITIVE, mu: POSITIVE}
MOTION = Domain({**BOTH, t: NONNEGATIVE, theta: Interval(0, LAST)})
MOTION_LEFT = Domain({**BOTH, t: NONNEGATIVE, theta: Interval.Ropen(-LAST, 0)})
DESCENT = Domain({**BOTH, t_AB: POSITIVE, theta: Interval.Ropen(0, LAST)})
CLOSED = Erratum(
    ("C1",), "at |theta| = theta_max the bead stays at A (s = 0): the closed range does no harm to positions"
)
FALLEN = g / gamma * t - g / gamma**2 * (1 - exp(-gamma * t))
FALLEN_AB = FALLEN.subs(t, t_AB)


@chapter.derive(
    "chord.eq40",
    Eq(s(t).diff(t, 2), g * (cos(theta) - mu * sin(theta)) - gamma * s(t).diff(t)),
    MOTION,
    erratum=CLOSED,
)
def motion(eq12, eq28):
    """The drag of (28) added to the forces of (12)."""
    drag = sp.expand(eq28.rhs - eq28.rhs.subs(s(t).diff(t), 0))
    return Eq(s(t).diff(t, 2), eq12.rhs + drag, evaluate=False)


@chapter.derive("chord.eq41", Eq(s(t), FALLEN * (cos(theta) - mu * sin(theta))), MOTION)
def distance(eq40):
    """Solve (40) from rest."""
    return solve_motion(eq40.equation, s(t), at_rest(s(t)))


@chapter.derive(
    "chord.claim.negative-theta-sign",
    And(
        Eq(s(t).diff(t, 2), g * (cos(theta) + mu * sin(theta)) - gamma * s(t).diff(t)),
        Eq(s(t), FALLEN * (cos(theta) + mu * sin(theta))),
    ),
    MOTION_LEFT,
    erratum=CLOSED,
    elsewhere=("chord.eq14", "chord.eq28"),
)
def negative_angles(eq14, eq28, eq40):
    """The drag added to (14): (40) with -mu for mu."""
    drag = sp.expand(eq28.rhs - eq28.rhs.subs(s(t).diff(t), 0))
    left = Eq(s(t).diff(t, 2), eq14.rhs + drag, evaluate=False)
    if sp.expand(left.rhs - eq40.rhs.subs(mu, -mu)) != 0:
        raise DerivationError("the motion for theta < 0 is not (40) with -mu")
    return And(left, solve_motion(left, s(t), at_rest(s(t))))


EQ42 = Eq(D, FALLEN_AB * (1 - mu * tan(theta)))
C3 = "strictly |theta| < theta_max: at theta_max the right side is 0 for every time, and no time is the descent time"


@chapter.derive(
    "chord.eq42",
    EQ42,
    DESCENT,
    erratum=Erratum(("C3",), C3, EQ42, Domain({**BOTH, D: POSITIVE, t_AB: POSITIVE, theta: sp.FiniteSet(LAST)})),
)
def impact(eq41, eq3):
    """Put s = D cos(theta) and divide by the cosine."""
    arrival = step("arrival at B", Eq(eq3.of(s_AB), eq41.rhs.subs(t, t_AB), evaluate=False))
    over = sp.expand(arrival.rhs / (arrival.lhs / D)).replace(sin, lambda a: tan(a) * cos(a))
    return Eq(D, sp.expand(over), evaluate=False)


N_OF_THETA = 1 - mu * tan(Abs(theta))
EQ43 = Eq(
    t_AB,
    LambertW(-exp(-1 - D * gamma**2 / (g * N_OF_THETA))) / gamma + 1 / gamma + D * gamma / (g * N_OF_THETA),
)


@chapter.derive(
    "chord.eq43",
    EQ43,
    Domain(
        {**BOTH, mu: NONNEGATIVE, D: POSITIVE, theta: Interval.open(-LAST_FROM_0, LAST_FROM_0)},
        where={n: N_OF_THETA},
    ),
    erratum=Erratum(
        ("C3",),
        "strictly |theta| < theta_max (n > 0)",
        EQ43,
        Domain({**BOTH, D: POSITIVE, theta: sp.FiniteSet(LAST)}, where={t_AB: sqrt(2 * D / g)}),
    ),
    elsewhere=("chord.eq30", "chord.eq36"),
)
def descent_time(eq42, eq30, eq36, claim__negative_theta_sign):
    """(42), divided by n = 1 - mu tan|theta|, is (30) with D/n for D: so the time is (36) with D/n for D.

    Without friction n is 1, and it is (36) itself.
    """
    right = sp.simplify(eq42.rhs / eq30.rhs)
    left = claim__negative_theta_sign.of(s(t)).subs(t, t_AB) / cos(theta) / eq30.rhs
    mirrored = sp.simplify(sp.expand(left).replace(tan, lambda a: sin(a) / cos(a)) - (1 + mu * sin(theta) / cos(theta)))
    if sp.simplify(right - (1 - mu * tan(theta))) != 0 or mirrored != 0:
        raise DerivationError("(42) is not (30) with D/n")
    step("(42) with n", Eq(D / n, eq30.rhs, evaluate=False))
    time = eq36.rhs.subs(D, D / n).subs(n, right.subs(theta, Abs(theta)))
    if is_zero(time.subs(mu, 0) - eq36.rhs) is None:
        raise DerivationError("without friction it is not (36)")
    return Eq(t_AB, time)


def _after_start(by_n, branches):
    """The time is positive: W's argument is above -1/e, so that W is above -1."""
    (inverse,) = by_n.atoms(LambertW)
    values = next(e for e in branches.parts if isinstance(e, Ge))
    round_trip = next(e for e in branches.parts if isinstance(e, Eq) and e.rhs == q)
    image = round_trip.lhs.subs(W_0(q), values.rhs)
    bound = above_end(round_trip, values, Gt(q, image, evaluate=False))
    beyond = sp.expand(by_n.subs(inverse, bound.rhs + sp.Dummy("above", positive=True)))
    depth = sp.Dummy("depth", positive=True)
    ladder(inverse.args[0].subs(D, g * n * depth / gamma**2) - image, depth)
    if not beyond.is_positive:
        raise DerivationError(f"{by_n} is not shown to be positive by {bound}")
    return step("after the start", Gt(t_AB, 0, evaluate=False))


TIME_OF_N = LambertW(-exp(-1 - D * gamma**2 / (g * n))) / gamma + 1 / gamma + D * gamma / (g * n)
HALVES = ((1, Interval.Ropen(0, LAST)), (-1, Interval.Lopen(-LAST, 0)))


@chapter.derive(
    "chord.claim.both-theta-dependent",
    And(
        StrictlyIncreasing(TIME_OF_N.subs(n, 1 - mu * tan(theta)), theta, Interval.Ropen(0, LAST)),
        StrictlyDecreasing(TIME_OF_N.subs(n, 1 + mu * tan(theta)), theta, Interval.Lopen(-LAST, 0)),
    ),
    Domain({**BOTH, D: POSITIVE, theta: Interval.Ropen(0, LAST)}, where={n: 1 - mu * tan(theta)}),
)
def theta_matters(eq42, eq43, claim__W_branches):
    """(42) is D = n h(t) with h and h' positive for t > 0: t falls as n rises, and n falls as |theta| rises."""
    fallen = eq42.rhs.subs(theta, 0)
    share = sp.simplify(eq42.rhs / fallen)
    by_n = sp.expand(eq43.rhs.subs(tan(Abs(theta)), isolate(Eq(n, share, evaluate=False), tan(theta)).rhs))
    check_root(Eq(n * fallen, D, evaluate=False), t_AB, by_n)
    time, z = sp.Function("time"), sp.Symbol("z", positive=True)
    later = _after_start(by_n, claim__W_branches).subs(t_AB, time(n))
    slope = implicit_derivative(Eq(n * fallen.subs(t_AB, time(n)), D), time(n), n, later).rhs.subs(time(n), z / gamma)
    outer = monotone(by_n, n, POSITIVE, sign_by_ladder(slope, z))
    facts = []
    for side, angles in HALVES:
        along = share.subs(theta, side * theta)
        inner = monotone_by_slope(along, theta, angles)
        facts.append(compose_monotone(outer, step("n on one side", inner)))
    return And(*facts)


@chapter.derive("chord.eq45", Eq(Y(t), g / (2 * gamma) * t - g / (2 * gamma**2) * (1 - exp(-gamma * t))), MOTION)
def depth(eq41):
    """Half the fall along the vertical."""
    step("a diameter", Eq(2 * Y(t), eq41.rhs.subs(theta, 0), evaluate=False))
    return Eq(Y(t), sp.expand(eq41.rhs.subs(theta, 0) / 2))


EQ44 = Eq((x + sigma * X(t)) ** 2 + (y - Y(t)) ** 2, R(t) ** 2)
SIDES = Domain({**BOTH, t: POSITIVE, sigma: sp.FiniteSet(1, -1), theta: Interval(0, LAST)})
X_OF = sigma * Y(t) * (sin(2 * theta) - mu * (1 - cos(2 * theta)))
Y_OF = Y(t) * (1 + cos(2 * theta) - mu * sin(2 * theta))
BEADS = Domain(SIDES.ranges, where={x: X_OF, y: Y_OF})


def circle_with_y(eq41, eq45, setup, eq7, eq8):
    """The circle on which the beads of one side are, theta eliminated, with Y(t) for half the fall."""
    along = sp.simplify(eq41.rhs / (2 * eq45.rhs)) * 2 * Y(t)
    across, down = doubled_coordinates(along, setup, eq7.rhs, eq8.rhs)
    step("abscissa for theta >= 0", Eq(sigma * x, across))
    step("ordinate for theta >= 0", Eq(y, down))
    plain = sp.Symbol("plain", positive=True)  # a name for Y(t) while the basis is computed
    found = eliminate_angle(Eq(x, across).subs(Y(t), plain), Eq(y, down).subs(Y(t), plain), 2 * theta, (x, y))
    return read_circle(found.subs(plain, Y(t)), x, y)


@chapter.derive("chord.eq46", Eq(X(t), mu * Y(t)), BEADS)
def sideways(eq41, eq45, setup, eq7, eq8):
    """Read the centre off."""
    return Eq(X(t), -circle_with_y(eq41, eq45, setup, eq7, eq8).centre[0])


@chapter.derive("chord.eq47", Eq(R(t), sqrt(1 + mu**2) * Y(t)), BEADS)
def radius(eq41, eq45, setup, eq7, eq8):
    """Read the radius off."""
    return Eq(R(t), circle_with_y(eq41, eq45, setup, eq7, eq8).radius)


@chapter.derive(
    "chord.eq44",
    EQ44,
    BEADS,
    erratum=Erratum(
        ("C5",),
        "the circles are traced on x >= 0 (theta >= 0) and x <= 0 (theta <= 0) only: theta > theta_max gives no bead",
        Implies(EQ44, Ge(sigma * x, 0)),
        Domain(
            {**SIDES.ranges, mu: FiniteSet(Rational(1, 2)), theta: FiniteSet(Rational(13, 10))},
            where={**BEADS.where, X(t): mu * Y(t), R(t): sqrt(1 + mu**2) * Y(t), Y(t): FALLEN / 2},
        ),
    ),
)
def synchronous_curve(eq41, eq45, eq46, eq47, setup, eq7, eq8, claim__negative_theta_sign):
    """Eliminate theta; for theta < 0 the beads are the mirror images."""
    seen = circle_with_y(eq41, eq45, setup, eq7, eq8)
    mirror = claim__negative_theta_sign.of(s(t)).subs(theta, -theta)
    if sp.simplify(mirror - eq41.rhs) != 0:
        raise DerivationError("beads on the two sides are not mirror images")
    centre = -seen.centre[0].subs(eq46.rhs, X(t))
    size = seen.radius.subs(eq47.rhs, R(t))
    return Eq((x + sigma * centre) ** 2 + (y - seen.centre[1]) ** 2, size**2, evaluate=False)


chapter.given("chord.eq48", And(Eq(xt, x / Y(t)), Eq(yt, y / Y(t))), Domain({t: POSITIVE}))


@chapter.derive(
    "chord.eq49",
    Eq((xt + sigma * mu) ** 2 + (yt - 1) ** 2, 1 + mu**2),
    Domain({**BEADS.ranges, **WITH_OR_WITHOUT}, where={**BEADS.where, Y(t): FALLEN / 2}),
)
def rescaled(eq44, eq46, eq47, eq48, eq31):
    """Divide (44) by Y(t)^2; for mu = 0 (44) is (31)."""
    require_without_friction(eq44.subs({X(t): eq46.rhs, R(t): eq47.rhs}), eq31.subs(R(t), Y(t)))
    put = {c: isolate(Eq(name, eq48.of(name), evaluate=False), c).rhs for c, name in ((x, xt), (y, yt))}
    left, right = (side.subs(put).subs({X(t): eq46.rhs, R(t): eq47.rhs}) for side in eq44.equation.args)
    return Eq(sp.expand(left / Y(t) ** 2), sp.expand(right / Y(t) ** 2), evaluate=False)


@chapter.derive(
    "chord.claim.same-rescaled-curve",
    And(
        Implies(Eq(sigma, 1), Eq((xt + mu) ** 2 + (yt - 1) ** 2, 1 + mu**2), evaluate=False),
        Implies(Eq(sigma, -1), Eq((xt - mu) ** 2 + (yt - 1) ** 2, 1 + mu**2), evaluate=False),
        evaluate=False,
    ),
    Domain(BEADS.ranges, where={xt: X_OF / Y(t), yt: Y_OF / Y(t), Y(t): FALLEN / 2}),
)
def same_curve(eq49, eq26, eq27):
    """(49) is (26) on the right, where sigma = 1, and (27) on the left."""
    said = []
    for side, theirs in ((1, eq26), (-1, eq27)):
        mine = eq49.equation.subs(sigma, side)
        if sp.expand((mine.lhs - mine.rhs) - (theirs.lhs - theirs.rhs)) != 0:
            raise DerivationError(f"{mine} is not {theirs.id}")
        said.append(Implies(Eq(sigma, side), mine, evaluate=False))
    return And(*said, evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
