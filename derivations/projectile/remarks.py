"""Remarks about the figures and in the conclusion: the best angle falls, no symmetry, one parameter, large alpha."""

import sympy as sp
from sympy import And, Eq, Gt, LambertW, Limit, Lt, cos, exp, pi, sin

from galileo_sym.derivations.projectile.notation import (
    BETWEEN,
    BEYOND,
    HALF_TURN,
    SHOT,
    TRIAL,
    TRIAL_RANGE,
    R,
    StationaryAngle,
    Theta,
    U,
    Y,
    alpha,
    alpha_0,
    g,
    k,
    notation,
    theta,
    theta_max,
    u,
    v,
    w,
)  # fmt: skip
from galileo_sym.derivations.projectile.shared import BEST, BEST_FROM_0, W_a
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Independent,
    StrictlyDecreasing,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.tactics import (
    bound_by_end,
    box_of,
    compare_on,
    compose_monotone,
    elementary_limit,
    isolate,
    ladder,
    monotone,
    sign_on,
    trig_box,
)  # fmt: skip

chapter = Chapter("projectile.remarks", notation, "Figures and concluding comments")

ALPHA = k * v / g
SHOTS = Domain(SHOT, where={**TRIAL, theta_max: StationaryAngle(ALPHA), Theta(alpha_0): BEST_FROM_0})
U_OF_ALPHA = -1 - alpha * sin(theta)


@chapter.derive(
    "projectile.claim.maxangle-drops-from-pi4",
    And(Lt(Theta(ALPHA), pi / 4), StrictlyDecreasing(Theta(ALPHA), k, POSITIVE)),
    SHOTS,
)
def best_angle_drops(mono__theta, cont__claim, def__alpha):
    """It falls from pi/4 as alpha = k v/g grows from 0."""
    ratio = def__alpha.of(alpha)
    rises = monotone(ratio, k, POSITIVE, sign_on(sp.diff(ratio, k), {}))
    below = bound_by_end(mono__theta.statement, alpha, Gt(alpha, 0, evaluate=False))
    start = cont__claim.of(Theta(0))
    if below.rhs != Theta(0) or not isinstance(below, Lt):
        raise DerivationError(f"{below} does not compare with {start}")
    falls = compose_monotone(mono__theta.statement, rises)
    return And(Lt(below.lhs.subs(alpha, ratio), start), falls)


@chapter.derive(
    "projectile.claim.asymmetry",
    And(
        Eq(R(k, theta_max - theta_max), 0),
        Lt(2 * theta_max, pi / 2),
        Gt(R(k, theta_max + theta_max), 0),
    ),
    SHOTS,
)
def no_symmetry(thm2__c, def__uyR, lemma__a):
    """As far below theta_max as the ground the range is 0; as far above it is not, since 2 theta_max < pi/2."""
    length = def__uyR.of(R(k, theta))
    flat = length.subs(Y, def__uyR.of(Y)).subs(u, def__uyR.of(U(k, theta))).subs(theta, 0)
    above = step("as far above", Lt(2 * thm2__c.statement.lts, 2 * thm2__c.statement.gts))
    if above.lhs != 2 * theta_max or above.rhs != BETWEEN.end:
        raise DerivationError(f"{above} does not place 2 theta_max inside {BETWEEN}")
    inside = {theta: above.lhs}
    lower = compare_on(def__uyR.of(U(k, theta)), -sp.S.One, trig_box(sin(theta), theta, BETWEEN))
    beyond = step("there u is below -1", lower.func(*(side.subs(inside) for side in lower.args), evaluate=False))
    if not isinstance(beyond, Lt):
        raise DerivationError(f"{beyond}: Lemma (a) does not hold")
    box = {**box_of(*lemma__a.parts), u: BEYOND, **trig_box(length, theta, BETWEEN)}
    positive = compare_on(length, sp.S.Zero, box)
    if not isinstance(positive, Gt):
        raise DerivationError(f"the range {length} is not positive")
    return And(Eq(R(k, 0), flat, evaluate=False), above, Gt(R(k, above.lhs), 0, evaluate=False))


SCALED = g * R(alpha * g / v, theta) / v**2


@chapter.derive(
    "projectile.claim.nondimensional",
    And(
        Eq(SCALED, cos(theta) / alpha * (1 - LambertW(U_OF_ALPHA * exp(U_OF_ALPHA)) / U_OF_ALPHA)),
        Independent(SCALED, v),
        Independent(SCALED, g),
    ),
    Domain({g: POSITIVE, v: POSITIVE, alpha: POSITIVE, theta: HALF_TURN}, where={R(k, theta): TRIAL_RANGE}),
)
def one_parameter(range__u, def__u, def__alpha):
    """Put k = alpha g/v: g and v drop out of the range in units of v^2/g."""
    resistance = isolate(def__alpha.equation, k).rhs
    scaled = g * range__u.lhs.subs(k, resistance) / v**2
    in_u = sp.expand(g / v**2 * range__u.rhs.subs(k, resistance))
    explicit = in_u.subs(u, def__u.of(u).subs(k, resistance))
    if explicit.free_symbols != {alpha, theta}:
        raise DerivationError(f"{explicit} depends on more than alpha and theta")
    return And(Eq(scaled, explicit, evaluate=False), Independent(scaled, v), Independent(scaled, g))


@chapter.derive(
    "projectile.support.large-alpha",
    Eq(Limit(Theta(alpha), alpha, sp.oo), 0),
    Domain({}, where={Theta(alpha): BEST}),
)
def flat_throws(support__unified_thm3, mono__alpha2, thm2__c):
    """Along alpha = sqrt(1 + w e^(w + 1)) the sine, below that of pi/4 as theta_max is below pi/4, goes to 0."""
    path = sp.sqrt(mono__alpha2.rhs.subs(W_a, w))
    if mono__alpha2.lhs != alpha**2 or elementary_limit(path, w, sp.oo) is not sp.oo:
        raise DerivationError(f"{mono__alpha2.statement} does not let alpha grow with W alone")
    explicit = support__unified_thm3.of(sin(theta_max))
    in_w = explicit.subs(W_a, w).subs(alpha, path)
    sine = elementary_limit(in_w, w, sp.oo)
    step("the sine", Eq(Limit(explicit, alpha, sp.oo), sine, evaluate=False))
    below, height = thm2__c.statement, sp.Dummy("h", positive=True)
    if not isinstance(below, Lt) or below.lhs != theta_max:
        raise DerivationError(f"{below} is no bound for theta_max")
    gap = sin(below.rhs) ** 2 - in_w.subs(w, height - 1) ** 2
    ladder(sp.expand(sp.simplify(gap * (exp(height) - 1) ** 2) * exp(-height)), height)
    return Eq(Limit(Theta(alpha), alpha, sp.oo), sp.asin(sine), evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
