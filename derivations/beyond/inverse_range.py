"""The inverse range problem: which elevations give a range r, as one equation in s = k t, monotone on either side."""

import sympy as sp
from sympy import And, Eq, Equivalent, Interval, LambertW, Limit, Lt, cos, exp, pi, sin

from galileo_sym.derivations.beyond.notation import notation, rho
from galileo_sym.derivations.projectile.notation import (
    HALF_TURN,
    RISING,
    SHOT,
    TRIAL_RANGE,
    U_OF_THETA,
    R,
    StationaryAngle,
    W_u,
    alpha,
    g,
    k,
    s,
    share,
    theta,
    theta_max,
    u,
    v,
)  # fmt: skip
from galileo_sym.derivations.projectile.shared import W_a
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    ExactlyOneRoot,
    StrictlyDecreasing,
    StrictlyIncreasing,
    UniqueMaximum,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    compare_on,
    compose_monotone,
    eliminate_angle,
    isolate,
    monotone,
    monotone_by_slope,
    one_root,
    positive_before_root,
    restricted,
    same_order,
    sign_by_ladder,
    sign_on,
    trig_box,
    unique_maximum,
)  # fmt: skip

chapter = Chapter("beyond.inverse_range", notation, "The inverse range problem reduced to one equation (not printed)")

BEST = StationaryAngle(k * v / g)
S_OF_THETA = (W_u - u).subs(u, U_OF_THETA)
IMPACT = {u: U_OF_THETA, alpha: k * v / g, s: S_OF_THETA, R(k, theta): TRIAL_RANGE, theta_max: BEST}
SHOTS = Domain(SHOT, where=IMPACT)
LAUNCH = Domain({**SHOT, theta: RISING}, where=IMPACT)

CLIMB = s / (1 - exp(-s)) - 1  # alpha*sin(theta)
SQUARE = (1 - exp(-s)) ** 2 - (s - 1 + exp(-s)) ** 2 / alpha**2  # (k*r/v)**2
S_BEST = 1 + W_a
S_TOP = 1 + alpha + LambertW(-(1 + alpha) * exp(-1 - alpha))
LEVEL = (alpha * rho) ** 2  # (k*r/v)**2
TIMES = Interval.open(0, sp.oo)
LOW, HIGH = Interval(0, S_BEST), Interval(S_BEST, S_TOP)


def _part(premise, kind):
    return next(e for e in premise.parts if isinstance(e, kind))


@chapter.derive(
    "beyond.inverse.by-time",
    And(Eq(alpha * sin(theta), CLIMB), Eq(k * R(k, theta) / v, cos(theta) * (1 - exp(-s)))),
    LAUNCH,
)
def by_time(support__s_param, def__u, def__alpha, range__u):
    """u and W(u e^u) in terms of s = k t give the sine, and the range over the cosine."""
    u_of_s, w_of_s = support__s_param.of(u), support__s_param.of(W_u)
    named = def__u.rhs.subs(k, isolate(def__alpha.equation, k).rhs)
    height = sp.expand(u_of_s - named.subs(sin(theta), 0)) / named.coeff(sin(theta))
    across = sp.cancel(range__u.rhs * k / v).subs(W_u, w_of_s).subs(u, u_of_s)
    return And(
        Eq(alpha * sin(theta), sp.expand(alpha * height)),
        Eq(k * R(k, theta) / v, cos(theta) * sp.simplify(across / cos(theta)), evaluate=False),
    )


@chapter.derive("beyond.inverse.equation", Eq((k * R(k, theta) / v) ** 2, SQUARE), LAUNCH)
def equation(beyond__inverse__by_time):
    """Eliminate theta: what is left is one equation between s, alpha and the range."""
    across, height, reach, climb = sp.symbols("across height reach climb", positive=True)
    up, along = (beyond__inverse__by_time.of(e) for e in (alpha * sin(theta), k * R(k, theta) / v))
    lever = sp.cancel(along / cos(theta))
    found = eliminate_angle(
        Eq(across, cos(theta) * reach), Eq(height, alpha * sin(theta)), theta, (across, height)
    )  # the names stand for k*R/v, alpha*sin(theta) and 1 - e^(-s)
    squared = isolate(found.subs(across, sp.sqrt(climb)), climb).rhs
    product = sp.expand(sp.simplify(sp.expand(up * lever)))
    apart = sp.expand(squared.subs(height, climb / reach)).subs({climb: product, reach: lever})
    return Eq((k * R(k, theta) / v) ** 2, apart, evaluate=False)


@chapter.derive(
    "beyond.inverse.bijection",
    And(
        StrictlyIncreasing(CLIMB, s, TIMES),
        Eq(CLIMB.subs(s, S_TOP), alpha),
        ExactlyOneRoot(CLIMB - alpha * sin(theta), s, Interval.Lopen(0, S_TOP)),
    ),
    Domain({alpha: POSITIVE, theta: RISING}),
)
def bijection(beyond__inverse__by_time, support__u_bijection, impact__time, def__u, def__alpha):
    """alpha*sin(theta) = -1 - u(s) rises with s from 0 to alpha: one s in (0, s_top] belongs to each theta."""
    falling, climb = _part(support__u_bijection, StrictlyDecreasing), beyond__inverse__by_time.of(alpha * sin(theta))
    turn, value = sp.simplify(sp.diff(climb, s) / sp.diff(falling.args[0], s)), sp.Dummy("u", real=True)
    outer = sp.simplify(climb - turn * falling.args[0]) + turn * value
    foot = next(e for e in support__u_bijection.parts if isinstance(e, Eq) and e.lhs.args[2] == 0)
    rising = compose_monotone(monotone_by_slope(outer, value, Interval(-sp.oo, sp.oo)), falling)
    climb = rising.args[0]
    start = outer.subs(value, foot.rhs)
    steepest = def__u.rhs.subs(k, isolate(def__alpha.equation, k).rhs).subs(theta, pi / 2)
    top = sp.expand(impact__time.rhs * k).subs(u, steepest)
    end = Eq(climb.subs(s, top), alpha, evaluate=False)
    if is_zero(end.lhs - end.rhs) is None:
        raise DerivationError(f"{climb} is not alpha at {top}")
    upto = restricted(rising, Interval.Lopen(0, top))
    positive = compare_on(alpha * sin(theta), sp.S.Zero, trig_box(sin(theta), theta, RISING))
    limit = Eq(Limit(climb, s, 0, "+"), start, evaluate=False)
    known = (positive, sp.Le(alpha * sin(theta), alpha))  # a sine is at most 1
    return And(rising, end, one_root(upto, alpha * sin(theta), ends=(limit, end), assuming=known))


def _order_by_s(of_angles, of_times, values):
    """Put the order of two sines in place of that of two values of alpha*sin(theta) in terms of s."""
    sines, angles = of_angles.args if of_angles.args[0].has(sin) else of_angles.args[::-1]
    climbs, times = of_times.args if of_times.args[0].has(exp) else of_times.args[::-1]
    if climbs.func != sines.func or any(
        is_zero(values[c] - e) is None for c, e in zip(climbs.args, sines.args, strict=True)
    ):
        raise DerivationError(f"{climbs} is not {sines}")
    return Equivalent(angles, times)


@chapter.derive(
    "beyond.inverse.order",
    And(Equivalent(Lt(theta, theta_max), Lt(s, S_BEST)), Lt(S_BEST, S_TOP)),
    LAUNCH,
)
def order(beyond__inverse__bijection, beyond__inverse__by_time, support__kT_at_max, thm2__c):
    """s rises with the sine, hence with theta; theta_max is below pi/2, and has the sine alpha/(e^s - 1)."""
    best, top = sp.symbols("best top", positive=True)
    last = _part(beyond__inverse__bijection, ExactlyOneRoot).args[2].end
    end = _part(beyond__inverse__bijection, Eq)
    climb = beyond__inverse__by_time.of(alpha * sin(theta))
    largest = sp.expand(alpha * support__kT_at_max.of(sin(theta_max))).subs(alpha**2, support__kT_at_max.of(alpha**2))
    if is_zero(climb - largest) is None or end.lhs != climb.subs(s, last):
        raise DerivationError(f"{climb} is not {largest} at theta_max, or {end} is not about it")
    below = thm2__c.statement
    if not isinstance(below, Lt) or below.lhs != theta_max or not below.rhs < pi / 2:
        raise DerivationError(f"{below} does not say that theta_max is below pi/2")
    cosine = sign_on(cos(theta), trig_box(cos(theta), theta, HALF_TURN.interior))
    sine = monotone(alpha * sin(theta), theta, HALF_TURN, cosine)
    inside = {theta: RISING, theta_max: Interval.open(0, below.rhs)}
    rising = _part(beyond__inverse__bijection, StrictlyIncreasing)
    heights = {
        climb: alpha * sin(theta),
        climb.subs(s, best): alpha * sin(theta_max),
        climb.subs(s, top): end.rhs,
    }
    found = []
    for angles, times in (((theta, theta_max), (s, best)), ((theta_max, pi / 2), (best, top))):
        pair = same_order(sine, *angles, inside), same_order(rising, *times)
        found.append(_order_by_s(*pair, heights))
    named = {best: support__kT_at_max.of(s), top: last}
    same, later = (e.subs(named) for e in found)
    return And(same, next(e for e in later.args if e.has(LambertW)))


@chapter.derive(
    "beyond.inverse.peak",
    And(
        UniqueMaximum(SQUARE, s, Interval(0, S_TOP), S_BEST),
        StrictlyIncreasing(SQUARE, s, LOW),
        StrictlyDecreasing(SQUARE, s, HIGH),
    ),
    Domain({alpha: POSITIVE, s: POSITIVE}),
)
def peak(beyond__inverse__equation, beyond__inverse__order, support__kT_at_max):
    """The slope has the sign of alpha^2 - 1 - (s - 1)e^s, which falls, and vanishes where theta is theta_max."""
    square = beyond__inverse__equation.rhs
    factor = alpha**2 - support__kT_at_max.of(alpha**2)
    rest = sp.simplify(sp.expand(sp.diff(square, s)) / factor)
    positive = sign_by_ladder(rest, s)
    step("slope", Eq(sp.Derivative(square, s), rest * factor, evaluate=False))
    best = support__kT_at_max.of(s)
    falling = monotone(factor, s, Interval(0, sp.oo), sign_by_ladder(sp.diff(factor, s), s))
    before = positive_before_root(falling, best, s, [step("after the launch", sp.Gt(best, 0))])
    step("the slope is positive before theta_max", before)
    later = _part(beyond__inverse__order, Lt)
    if later.lhs != best:
        raise DerivationError(f"{later} does not say that {best} comes first")
    rising = monotone(square, s, Interval(0, best), positive)
    sinking = monotone(square, s, Interval(best, later.rhs), -positive)
    return And(unique_maximum(rising, sinking), rising, sinking)


@chapter.derive(
    "beyond.inverse.largest",
    Eq((k * R(k, theta_max) / v) ** 2, 1 - (2 + W_a) * exp(-1 - W_a)),
    SHOTS,
)
def largest(beyond__inverse__equation, support__kT_at_max):
    """At theta_max alpha^2 = 1 + (s - 1)e^s, and s = 1 + W: the largest range in closed form."""
    in_s = beyond__inverse__equation.rhs.subs(alpha**2, support__kT_at_max.of(alpha**2))
    square = sp.simplify(in_s).subs(s, support__kT_at_max.of(s))
    return Eq(beyond__inverse__equation.lhs.subs(theta, theta_max), square, evaluate=False)


@chapter.derive(
    "beyond.inverse.two-times",
    And(ExactlyOneRoot(SQUARE - LEVEL, s, LOW), ExactlyOneRoot(SQUARE - LEVEL, s, HIGH)),
    Domain(
        {alpha: POSITIVE, share: Interval.Ropen(0, 1)},
        where={rho: share * sp.sqrt(1 - (1 + S_BEST) * exp(-S_BEST)) / alpha},
    ),
)
def two_times(beyond__inverse__peak, beyond__inverse__largest, beyond__inverse__bijection, def__alpha):
    """The square rises from 0 to its largest value and falls to 0 again: a low and a high shot for each r < M."""
    rising, falling = (_part(beyond__inverse__peak, kind) for kind in (StrictlyIncreasing, StrictlyDecreasing))
    square, _, before = rising.args
    summit = Eq(square.subs(s, before.end), beyond__inverse__largest.lhs, evaluate=False)
    in_w = sp.expand(beyond__inverse__largest.rhs)
    if is_zero(square.subs(s, before.end) - in_w) is None:
        raise DerivationError(f"{square} is not {in_w} at {before.end}")
    top = falling.args[2].end
    end = _part(beyond__inverse__bijection, Eq)
    climb = _part(beyond__inverse__bijection, StrictlyIncreasing).args[0]
    decay = sp.Dummy("decay", positive=True)
    time = isolate(Eq(climb.rewrite(exp).subs(exp(s), 1 / decay), end.rhs, evaluate=False), s).rhs
    at_top = sp.expand(square).subs(exp(-s), decay).subs(exp(-2 * s), decay**2).subs(s, time)
    if end.lhs != climb.subs(s, top) or is_zero(at_top) is None:
        raise DerivationError(f"{end} does not say that the range is 0 at {top}")
    ground = Eq(square.subs(s, top), 0, evaluate=False)
    length = {R(k, theta_max): rho * v**2 / g, k: isolate(def__alpha.equation, k).rhs}
    level = beyond__inverse__largest.lhs.subs(length)
    submaximal = Lt(level, beyond__inverse__largest.lhs, evaluate=False)  # r < M, squared
    return And(
        one_root(rising, level, ends=(None, summit), assuming=(submaximal,)),
        one_root(falling, level, ends=(summit, ground), assuming=(submaximal,)),
    )


if __name__ == "__main__":
    tell_chapter(chapter.name)
