"""The inverse range problem: Theorem 2, the shape of the range as a function of resistance and angle."""

import sympy as sp
from sympy import And, Derivative, Eq, Equivalent, Gt, Interval, Le, Limit, Lt, pi, tan

from galileo_sym.derivations.projectile.notation import (
    BETWEEN,
    BEYOND,
    CURVATURE,
    HALF_TURN,
    SHOT,
    SLOPE,
    TRIAL,
    TRIAL_RANGE,
    R,
    StationaryAngle,
    U,
    Y,
    g,
    k,
    notation,
    r,
    share,
    theta,
    theta_max,
    u,
    v,
    w,
)  # fmt: skip
from galileo_sym.derivations.projectile.shared import continuous_w
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    Continuous,
    DerivationError,
    Domain,
    Erratum,
    ExactlyOneRoot,
    StrictlyDecreasing,
    StrictlyIncreasing,
    UniqueMaximum,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.tactics import (
    box_of,
    compare_on,
    continuous_on,
    elementary_limit,
    limit_along,
    monotone,
    one_root,
    sides_of_root,
    sign_on,
    trig_box,
    unique_maximum,
)  # fmt: skip

chapter = Chapter("projectile.theorem_2", notation, "The inverse range problem: Theorem 2")

RANGE = R(k, theta)
FACTOR = tan(theta) ** 2 + SLOPE
BEST = StationaryAngle(k * v / g)
ANGLES = Domain({**SHOT, theta: BETWEEN}, where=TRIAL)
ALL_ANGLES = Domain({**SHOT, theta: HALF_TURN}, where=TRIAL)
SHOTS = Domain(SHOT, where={**TRIAL, theta_max: BEST})
LEFT, RIGHT = Interval(0, theta_max), Interval(theta_max, pi / 2)


@chapter.derive(
    "projectile.thm2.a",
    StrictlyDecreasing(RANGE, k, POSITIVE),
    ANGLES,
    erratum=Erratum(
        ("S9",),
        "for 0 < theta < pi/2 only: at 0 and at pi/2 the range is 0 for every k",
        StrictlyDecreasing(RANGE, k, POSITIVE),
        Domain({**SHOT, theta: sp.FiniteSet(0)}, where=TRIAL),
    ),
)
def falls_with_resistance(lemma__e, lemma__a, lemma__c):
    """In Lemma (e) 1 - y/u and 1 + dy/du are positive."""
    slope = lemma__e.rhs
    box = {**box_of(*lemma__a.parts, *lemma__c.parts), u: BEYOND, **trig_box(slope, theta, BETWEEN)}
    fall = step("slope against k", compare_on(slope, sp.S.Zero, box))
    return monotone(lemma__e.lhs.expr, k, POSITIVE, 1 if isinstance(fall, Gt) else -1)


@chapter.derive("projectile.thm2.factor-increasing", StrictlyIncreasing(FACTOR, theta, BETWEEN), ANGLES)
def factor_increases(lemma__c, def__uyR):
    """tan^2 increases, u falls, and dy/du falls with u."""
    inner = sp.diff(def__uyR.of(U(k, theta)), theta)
    grows = sp.diff(tan(theta) ** 2, theta) + CURVATURE * inner
    signs = {**trig_box(grows, theta, BETWEEN), **box_of(*lemma__c.parts)}
    rise = step("slope of the factor", compare_on(grows, sp.S.Zero, signs))
    return monotone(FACTOR, theta, BETWEEN, 1 if isinstance(rise, Gt) else -1)


@chapter.derive("projectile.thm2.limit-0", Eq(Limit(FACTOR, theta, 0, "+"), -1), SHOTS)
def limit_at_0(lemma__c__slope_limit, def__uyR):
    """As theta goes to 0, tan goes to 0 and u to -1 from below."""
    known = next(e for e in lemma__c__slope_limit.parts if not e.rhs.has(Limit))
    slope = limit_along(known, theta, def__uyR.of(U(k, theta)), 0)
    return Eq(Limit(FACTOR, theta, 0, "+"), elementary_limit(FACTOR - SLOPE, theta, 0) + slope, evaluate=False)


@chapter.derive(
    "projectile.thm2.limit-pi2",
    Eq(Limit(FACTOR, theta, pi / 2, "-"), sp.oo),
    ANGLES,
    erratum=Erratum(
        ("S10",),
        "the limit is from below, theta -> pi/2-; pi/2+ is outside the domain. The sentence 'Since tan^2 is also "
        "increasing ...' stands twice",
    ),
)
def limit_at_right_angle(lemma__c):
    """dy/du is bounded, and tan^2 is not."""
    bound = next(e for e in lemma__c.parts if isinstance(e, Gt) and e.lhs == SLOPE)
    below = step("a lower bound", Gt(FACTOR, FACTOR.subs(bound.lhs, bound.rhs)))
    limit = elementary_limit(below.rhs, theta, pi / 2, "-")
    if limit is not sp.oo:
        raise DerivationError(f"the lower bound {below.rhs} goes to {limit}, not to infinity")
    return Eq(Limit(FACTOR, theta, pi / 2, "-"), limit, evaluate=False)


@chapter.derive("beyond.thm2.continuous", And(Eq(RANGE, TRIAL_RANGE), Continuous(RANGE, theta, HALF_TURN)), ALL_ANGLES)
def continuous_range(def__uyR, def__W, def__T, claim__T_monotone, claim__u_le_minus1, claim__domain_W):
    """W is continuous from -1/e on, down to where u e^u gets as theta goes to 0; and u is not 0."""
    known = continuous_w(def__W, def__T, claim__T_monotone)
    path = def__uyR.of(U(k, theta))
    length = def__uyR.of(RANGE).subs(Y, def__uyR.of(Y)).subs(u, path)
    below = next(e for e in claim__u_le_minus1.parts if isinstance(e, Le))
    if below.lhs != u or not below.rhs.is_negative:
        raise DerivationError(f"{below} does not say that u is negative")
    facts = Lt(path, 0, evaluate=False), claim__domain_W.subs(w, path)
    for fact in facts:
        step("at every elevation", fact)
    found = continuous_on(length, theta, HALF_TURN, known=[known], facts=facts)
    return And(Eq(RANGE, length), Continuous(RANGE, *found.args[1:]))


def _signs(form, bounds):
    """Where the parts of dR/dtheta lie."""
    return {**box_of(*bounds.parts), u: BEYOND, **trig_box(form.rhs, theta, BETWEEN)}


@chapter.derive(
    "projectile.thm2.stationary",
    And(
        Equivalent(Eq(Derivative(RANGE, theta), 0), Eq(tan(theta) ** 2 + SLOPE, 0)),
        ExactlyOneRoot(tan(theta) ** 2 + SLOPE, theta, BETWEEN),
    ),
    Domain({**SHOT, theta: sp.Union(BETWEEN, sp.FiniteSet(BEST), evaluate=False)}, where=TRIAL),
)
def stationary(lemma__f__second, lemma__a, thm2__factor_increasing, thm2__limit_0, thm2__limit_pi2):
    """The rest of the slope has no zero; the factor increases from -1 to oo, so that it vanishes once."""
    sign_on(sp.cancel(lemma__f__second.rhs / FACTOR), _signs(lemma__f__second, lemma__a))
    ends = (thm2__limit_0.equation, thm2__limit_pi2.equation)
    once = one_root(thm2__factor_increasing.statement, sp.S.Zero, ends=ends)
    same = Equivalent(Eq(lemma__f__second.lhs, 0), Eq(once.args[0], 0))
    return And(same, once)


@chapter.derive(
    "projectile.thm2.b",
    And(
        UniqueMaximum(RANGE, theta, HALF_TURN, theta_max),
        StrictlyIncreasing(RANGE, theta, LEFT),
        StrictlyDecreasing(RANGE, theta, RIGHT),
    ),
    SHOTS,
)
def maximum(thm2__stationary, thm2__factor_increasing, lemma__f__second, lemma__a, beyond__thm2__continuous):
    """Let theta_max be the root: dR/dtheta is positive on its left and negative on its right."""
    once = next(e for e in thm2__stationary.parts if isinstance(e, ExactlyOneRoot))
    increases = thm2__factor_increasing.statement
    signs = _signs(lemma__f__second, lemma__a)
    whole = next(e for e in beyond__thm2__continuous.parts if isinstance(e, Continuous))
    sides = sides_of_root(lemma__f__second.equation, whole, theta_max, once, increases, signs)
    return And(unique_maximum(*sides), *sides)


@chapter.derive("projectile.thm2.c", Lt(theta_max, pi / 4), Domain(SHOT, where={**TRIAL, theta: BEST, theta_max: BEST}))
def below_pi4(thm2__stationary, lemma__c):
    """tan^2 = -dy/du < 1."""
    condition = next(e for e in thm2__stationary.parts if isinstance(e, Equivalent))
    zero = next(e for e in condition.args if e.has(tan))
    bound = next(e for e in lemma__c.parts if isinstance(e, Gt) and e.lhs == SLOPE)
    square = sp.solve(zero.subs(tan(theta) ** 2, sp.Symbol("square")), sp.Symbol("square"))[0]
    highest = square.subs(SLOPE, bound.rhs)
    step("tan^2 at theta_max", Lt(tan(theta_max) ** 2, highest))
    return Lt(theta_max, sp.atan(sp.sqrt(highest)))


@chapter.derive(
    "projectile.thm2.d",
    And(ExactlyOneRoot(RANGE - r, theta, LEFT), ExactlyOneRoot(RANGE - r, theta, RIGHT)),
    Domain({**SHOT, share: Interval.Ropen(0, 1)}, where={**SHOTS.where, r: share * TRIAL_RANGE.subs(theta, BEST)}),
)
def two_angles(thm2__b, def__uyR):
    """The range rises from 0 to its maximum and falls to 0 again."""
    length = def__uyR.of(RANGE).subs(Y, def__uyR.of(Y)).subs(u, def__uyR.of(U(k, theta)))
    ground = [Eq(R(k, angle), length.subs(theta, angle), evaluate=False) for angle in (sp.S.Zero, pi / 2)]
    submaximal = Lt(r, R(k, theta_max), evaluate=False)
    rising = next(e for e in thm2__b.parts if isinstance(e, StrictlyIncreasing))
    falling = next(e for e in thm2__b.parts if isinstance(e, StrictlyDecreasing))
    return And(
        one_root(rising, r, ends=(ground[0], None), assuming=(submaximal,)),
        one_root(falling, r, ends=(None, ground[1]), assuming=(submaximal,)),
    )


if __name__ == "__main__":
    tell_chapter(chapter.name)
