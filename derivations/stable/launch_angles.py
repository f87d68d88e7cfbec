"""Stable form of the launch angles: one equation in the square of the time of flight, concave whatever the resistance.

In units of v/g and v^2/g the time of flight z and the range rho are moderate numbers, and so is the equation at k = 0.
"""

import sympy as sp
from sympy import And, Derivative, Eq, Equivalent, Gt, Interval, LambertW, Lt, Tuple, atan, cos, exp, pi, sin, sqrt, tan

from galileo_sym.derivations.beyond.notation import notation, rho, z
from galileo_sym.derivations.projectile.notation import (
    SHOT,
    TRIAL_RANGE,
    U_OF_THETA,
    R,
    StationaryAngle,
    W_u,
    alpha,
    delta,
    g,
    k,
    r,
    s,
    share,
    theta,
    theta_max,
    u,
    v,
)  # fmt: skip
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    ExactlyOneRoot,
    StrictlyDecreasing,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.primitives import best_time, flight_factor, phi1, phi2
from galileo_sym.tactics import introduce, isolate, monotone, root_at_scale, sign_by_ladder

chapter = Chapter("stable.launch_angles", notation, "stable forms (not printed)")

S_OF_THETA = (W_u - u).subs(u, U_OF_THETA)
IMPACT = {
    u: U_OF_THETA,
    alpha: k * v / g,
    s: S_OF_THETA,
    R(k, theta): TRIAL_RANGE,
    theta_max: StationaryAngle(k * v / g),
    rho: g * TRIAL_RANGE / v**2,
    z: g * S_OF_THETA / (k * v),
}
LAUNCH = Domain({**SHOT, theta: Interval.open(0, pi / 2)}, where=IMPACT)

FIRST, SECOND, FADING = phi1(-alpha * z), phi2(-alpha * z), exp(-alpha * z)
SQUARE = z**2 * FIRST**2 - z**4 * SECOND**2
RISE = z**2 * SECOND
SLOPE = FIRST * (FADING - RISE)
BEND = FIRST**2 / 2 + alpha / (2 * z) * ((FIRST - SECOND) * (FADING - RISE) + FIRST * FADING)
BEST, LAST = best_time(alpha), 2 * flight_factor(alpha)

PURE = g * r / v**2
TANGENT = PURE / (1 + sqrt(1 - PURE) * sqrt(1 + PURE))


@chapter.derive(
    "stable.projectile.launch_angles.free",
    Eq(Tuple(pi / 4 - delta, pi / 4 + delta), Tuple(atan(TANGENT), pi / 2 - atan(TANGENT))),
    Domain({g: POSITIVE, v: POSITIVE, delta: Interval.Lopen(0, pi / 4)}, where={r: v**2 / g * cos(2 * delta)}),
)
def angles_free(projectile__nodrag__claim__pairs):
    """Both angles have the range r = v^2/g cos(2 delta); the tangent of half the complement of 2 delta."""
    low, high = pi / 4 - delta, pi / 4 + delta
    level, other = (projectile__nodrag__claim__pairs.of(R(angle)) for angle in (low, high))
    if is_zero(level - other) is None:
        raise DerivationError(f"{level} and {other} are not one range")
    of_double = sp.expand(level.subs(cos(delta), sqrt((1 + cos(2 * delta)) / 2)))
    cosine = isolate(Eq(of_double, r, evaluate=False), cos(2 * delta)).rhs
    double = sp.expand(2 * low)
    half = sin(double) / (1 + cos(double))
    step("half the angle", Eq(tan(low), half, evaluate=False))
    tangent = half.subs({cos(2 * delta): cosine, sin(2 * delta): sqrt(1 - cosine) * sqrt(1 + cosine)})
    return Eq(Tuple(low, high), Tuple(atan(tangent), sp.expand(low + high) - atan(tangent)))


@chapter.derive(
    "stable.projectile.launch_angles.drag",
    And(Eq(rho**2, SQUARE), Eq(tan(theta), RISE / rho)),
    LAUNCH,
)
def angles_drag(beyond__inverse__equation, beyond__inverse__by_time, projectile__def__alpha):
    """The exponentials are taken out by phi1 and phi2; alpha stays in their argument s = alpha z only."""
    pure = {R(k, theta): rho * v**2 / g, k: isolate(projectile__def__alpha.equation, k).rhs}
    decay = sp.Dummy("decay", positive=True)
    by_first, by_second = (introduce(exp(-s), factor, closed=exp) for factor in (phi1(-s), phi2(-s)))
    square = sp.expand(beyond__inverse__equation.rhs).subs({exp(-2 * s): decay**2, exp(-s): decay})
    across, up = (sp.expand(square).coeff(alpha, n) for n in (0, -2))
    if sp.expand(square - across - up / alpha**2) != 0:
        raise DerivationError(f"{square} is not of the second degree in 1/alpha")
    reach, drop = sp.expand(across.subs(decay, by_first)), sp.expand(up.subs(decay, by_second))
    level = beyond__inverse__equation.lhs.subs(pure) / rho**2
    climb, along = (beyond__inverse__by_time.of(e) for e in (alpha * sin(theta), k * R(k, theta) / v))
    lag = sp.expand(sp.simplify(climb * sp.cancel(along / cos(theta)))).subs(exp(-s), by_second)
    height = sp.expand(lag) / alpha / sp.cancel((k * R(k, theta) / v).subs(pure))
    terms = (reach / level, drop / alpha**2 / level, height)
    first, second, tangent = (sp.expand(e.subs(s, alpha * z)) for e in terms)
    return And(Eq(rho**2, first + second), Eq(tan(theta), tangent))


@chapter.derive(
    "stable.projectile.launch_angles.slopes",
    And(
        Eq(Derivative(SQUARE, z) / (2 * z), SLOPE),
        Eq(-Derivative(SLOPE, z) / (2 * z), BEND),
        Eq(Derivative(RISE, z) / (2 * z), FIRST / 2),
    ),
    Domain({alpha: POSITIVE, z: POSITIVE}),
    premises=("stable.projectile.launch_angles.drag",),
)
def slopes(angles):
    """Derivatives by z**2, in a form whose terms do not cancel but where they must: at the largest range."""
    square, rise = angles.of(rho**2), angles.of(tan(theta)) * rho
    lean = sp.expand(sp.diff(rise, z) / (2 * z))
    by_first = sp.expand(sp.cancel(sp.diff(square, z) / (2 * z) / FIRST))
    falling = by_first.coeff(z, 2) * z**2
    rest = sp.simplify((by_first - falling).rewrite(exp)) + falling
    slope = FIRST * rest
    named = sp.Dummy("rest", real=True)
    bend = -sp.factor(sp.diff(FIRST, z)) * named / (2 * z) - sp.expand(FIRST * sp.diff(rest, z) / (2 * z))
    return And(
        Eq(Derivative(square, z) / (2 * z), slope),
        Eq(-Derivative(slope, z) / (2 * z), bend.subs(named, rest)),
        Eq(Derivative(rise, z) / (2 * z), lean),
    )


@chapter.derive(
    "stable.projectile.launch_angles.concave",
    And(Gt(BEND, 0), StrictlyDecreasing(SLOPE, z, Interval.open(0, sp.oo))),
    Domain({alpha: POSITIVE, z: POSITIVE}),
    premises=("stable.projectile.launch_angles.slopes",),
)
def concave(slopes):
    """In s = alpha z the bend is a part without alpha and one in alpha**2, both positive by the ladder."""
    (slope,) = (e.rhs for e in slopes.parts if e.rhs == SLOPE)
    bend = slopes.of(-Derivative(slope, z) / (2 * z))
    in_s = sp.expand(bend.subs(z, s / alpha))
    parts = [in_s.coeff(alpha, n) for n in (0, 2)]
    if sp.expand(in_s - parts[0] - parts[1] * alpha**2) != 0:
        raise DerivationError(f"{in_s} has other powers of alpha")
    signs = [sign_by_ladder(sp.expand(part.rewrite(exp)), s) for part in parts]
    if signs != [1, 1]:
        raise DerivationError(f"the parts of {bend} have the signs {signs}")
    return And(Gt(bend, 0, evaluate=False), monotone(slope, z, Interval.open(0, sp.oo), -1))


@chapter.derive(
    "stable.projectile.launch_angles.order",
    And(Equivalent(Lt(theta, theta_max), Lt(z, BEST)), Lt(BEST, LAST)),
    LAUNCH,
)
def order(beyond__inverse__order):
    """The same order in units of v/g: W is taken out of s at theta_max, and of s at pi/2."""
    same = next(e for e in beyond__inverse__order.parts if isinstance(e, Equivalent))
    later = next(e for e in beyond__inverse__order.parts if isinstance(e, Lt))
    angles, times = sorted(same.args, key=lambda e: e.has(s))
    best, last = (_named(e) for e in later.args)
    if times.rhs != later.lhs:
        raise DerivationError(f"{times} and {later} do not speak of one time")
    return And(Equivalent(angles, Lt(z, best)), Lt(best, last))


def _named(time):
    """A time s in terms of W as a time z, by the primitives."""
    for factor in (BEST * alpha, LAST * alpha):
        if is_zero(time - factor.rewrite(LambertW)) is not None:
            return factor / alpha
    raise DerivationError(f"{time} is neither that of the largest range nor the last one")


@chapter.derive(
    "stable.projectile.launch_angles.two-times",
    And(
        ExactlyOneRoot(SQUARE - rho**2, z, Interval(0, BEST)),
        ExactlyOneRoot(SQUARE - rho**2, z, Interval(BEST, LAST)),
    ),
    Domain(
        {alpha: POSITIVE, share: Interval.Ropen(0, 1)},
        where={rho: share * sp.sqrt(1 - (1 + alpha * BEST) * exp(-alpha * BEST)) / alpha},
    ),
    premises=("beyond.inverse.two-times", "stable.projectile.launch_angles.drag"),
)
def two_times(times, angles):
    """The equation has one root on either side of the best time: s = alpha z, and the equation divided by alpha**2."""
    found = []
    for claim in times.parts:
        scaled = root_at_scale(claim, z, alpha, over=alpha**2)
        equation, _, interval = scaled.args
        balance = angles.of(rho**2) - rho**2
        if is_zero(equation - balance) is None:
            raise DerivationError(f"{equation} is not {balance}")
        ends = [e if e == 0 else _named(sp.expand(e * alpha)) for e in (interval.start, interval.end)]
        found.append(ExactlyOneRoot(balance, z, Interval(*ends)))
    return And(*found)


if __name__ == "__main__":
    tell_chapter(chapter.name)
