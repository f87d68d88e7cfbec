"""A closed form for the maximum range angle: it falls as alpha grows, by the reciprocal of its sine."""

import sympy as sp
from sympy import And, Derivative, Eq, Equivalent, Ge, Gt, Interval, LambertW, Le, Ne, exp, sin, sqrt

from galileo_sym.derivations.projectile.notation import (
    BETWEEN,
    Theta,
    alpha,
    alpha_0,
    notation,
    q,
    theta,
    theta_max,
    w,
)  # fmt: skip
from galileo_sym.derivations.projectile.shared import (
    BEST,
    BEST_FROM_0,
    CASE_2,
    CASES,
    NOT_1,
    W_a,
    continuous_w,
)
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    Continuous,
    DerivationError,
    Domain,
    Erratum,
    ExactlyOneRoot,
    StrictlyDecreasing,
    StrictlyIncreasing,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    bound_by_end,
    closed_at_end,
    continuous_on,
    inner_monotone,
    isolate,
    monotone,
    sign_on,
    slope_at_gap,
    trig_box,
)  # fmt: skip
from galileo_sym.tactics.boxes import PLUS

chapter = Chapter("projectile.monotony", notation, "A closed form for the maximum range angle: monotony")

RECIPROCAL = 1 / sin(Theta(alpha))
SLOPE = Derivative(RECIPROCAL, alpha)
TRIAL = {Theta(alpha): BEST, theta_max: BEST, SLOPE: sp.diff(1 / sin(BEST), alpha)}
ABOVE = Domain({w: Interval(-1, sp.oo)})
NUMERATOR = (w - 1) * exp(w + 1) + w + 3
GROWTH = w * exp(w + 1) + 1


@chapter.derive("projectile.mono.inv", Eq(1 / sin(theta_max), (alpha**2 - 1) / (alpha * W_a) - 1 / alpha), CASE_2)
def reciprocal(thm3):
    """The reciprocal of Theorem 3's sine, term by term."""
    (general, when), _ = thm3.of(theta_max).args
    if when != Ne(alpha, 1):
        raise DerivationError(f"Theorem 3 has other cases: {when}")
    top, bottom = sp.fraction(sin(general).subs(W_a, w))
    terms = sum(c * part / top for part, c in sp.collect(bottom, w, evaluate=False).items())
    return Eq(1 / sin(theta_max), terms.subs(w, W_a), evaluate=False)


@chapter.derive(
    "projectile.mono.deriv",
    Eq(SLOPE, (W_a**2 + (2 + alpha**2) * W_a + 1 - alpha**2) / (alpha**2 * W_a * (1 + W_a))),
    Domain({alpha: NOT_1}, where=TRIAL),
)
def slope(mono__inv, res2):
    """The chain rule, with result (2) for the slope of W."""
    argument = W_a.args[0]
    inner = res2.of(Derivative(LambertW(q), q)).subs(q, argument).subs(W_a, w) * sp.diff(argument, alpha)
    step("slope of W against alpha", Eq(Derivative(W_a, alpha), inner.subs(w, W_a)))
    explicit = mono__inv.rhs.subs(W_a, w)
    total = sp.diff(explicit, alpha) + sp.diff(explicit, w) * inner
    return Eq(SLOPE, sp.factor(total).subs(w, W_a), evaluate=False)


@chapter.derive(
    "projectile.mono.alpha2", Eq(alpha**2, 1 + W_a * exp(W_a + 1)), Domain({alpha: NONNEGATIVE}, where={w: W_a})
)
def square(cont__WeW):
    """Multiply by e."""
    squared = sp.Dummy("square", nonnegative=True)
    told = cont__WeW.subs(W_a, w).subs(alpha, sqrt(squared))
    return Eq(alpha**2, sp.powsimp(isolate(told, squared).rhs).subs(w, W_a), evaluate=False)


def _above_foot(squared):
    """W is not -1 for alpha > 0: alpha^2 would be 0."""
    at_foot = squared.rhs.subs(W_a, w).subs(w, -1)
    if squared.lhs != alpha**2 or at_foot != 0:
        raise DerivationError(f"{squared.statement} does not say that alpha is 0 where W is -1")
    return step("W is not -1", Ne(1 + W_a, 0))


@chapter.derive(
    "projectile.mono.deriv2",
    Eq(SLOPE, ((W_a - 1) * exp(W_a + 1) + W_a + 3) / (alpha**2 * (1 + W_a))),
    Domain({alpha: CASES}, where=TRIAL),
)
def slope_in_w(mono__deriv, mono__alpha2, cont__claim, def__W, def__T, claim__T_monotone):
    """Put alpha^2 in above and cancel W; what is left holds at alpha = 1 too, by the mean value theorem."""
    top, bottom = sp.fraction(mono__deriv.rhs.subs(W_a, w))
    above = sp.expand(top.subs(alpha**2, mono__alpha2.rhs.subs(W_a, w)), power_exp=False)
    divided = sp.collect(sp.expand(above / w, power_exp=False), exp(w + 1)) / sp.cancel(bottom / w)
    found = Eq(mono__deriv.lhs, divided.subs(w, W_a), evaluate=False)
    facts = [_above_foot(mono__alpha2)]
    known = continuous_w(def__W, def__T, claim__T_monotone)
    formula = continuous_on(sp.factor(divided).subs(w, W_a), alpha, POSITIVE, known=[known], facts=facts)
    angle = next(e for e in cont__claim.parts if isinstance(e, Continuous))
    at_1 = sin(cont__claim.of(angle.args[0]).subs(alpha_0, 1))
    if not at_1.is_nonzero:
        raise DerivationError(f"the sine is {at_1} at alpha = 1")
    sine = Ne(sin(angle.args[0]), 0)  # near alpha = 1
    whole = continuous_on(1 / sin(angle.args[0]), alpha_0, angle.args[2], known=[angle], facts=[sine])
    step("at alpha = 1", Eq(divided.subs(w, W_a).subs(alpha, 1), formula.args[0].subs(alpha, 1)))
    return slope_at_gap(found, whole, formula, sp.S.One)


@chapter.derive(
    "projectile.mono.hprime",
    And(
        Eq(Derivative(NUMERATOR, w), GROWTH),
        Ge(GROWTH, 0),
        Equivalent(Eq(GROWTH, 0), Eq(w, -1)),
    ),
    ABOVE,
)
def numerator_grows(mono__deriv2, claim__domain_W, claim__T_monotone):
    """The slope of the numerator is e (w e^w + 1/e): T is least at -1, and only there, since it rises from there on."""
    numerator = sp.numer(mono__deriv2.rhs).subs(W_a, w)
    growth = sp.powsimp(sp.expand(sp.diff(numerator, w), power_exp=False))
    least = claim__domain_W.statement
    rising = next(e for e in claim__T_monotone.parts if isinstance(e, StrictlyIncreasing))
    beyond = bound_by_end(rising, w, Gt(w, -1))
    for told, kind in ((least, Ge), (beyond, Gt)):
        if not isinstance(told, kind) or is_zero(growth - exp(1) * (told.lhs - told.rhs)) is None:
            raise DerivationError(f"{told} says nothing of {growth}")
    foot = rising.args[2].start
    if is_zero(growth.subs(w, foot)) is None:
        raise DerivationError(f"{growth} is not 0 at {foot}")
    return And(
        Eq(Derivative(numerator, w), growth), Ge(growth, 0), Equivalent(Eq(growth, 0, evaluate=False), Eq(w, foot))
    )


def _told_sign(relation):
    """The sign that an inequality against 0 gives its left side, but where that vanishes."""
    if relation.rhs != 0:
        raise DerivationError(f"{relation} is not about a sign")
    return 1 if relation.gts == relation.lhs else -1


@chapter.derive(
    "projectile.mono.nonneg",
    And(Ge(NUMERATOR, 0), Equivalent(Eq(NUMERATOR, 0), Eq(w, -1))),
    ABOVE,
    erratum=Erratum(
        ("S17",),
        "'nonnegative' must be positive for W > -1, as it is: 0 at W = -1 only. Nor need alpha = 1 be left out, where "
        "the second form of the derivative is 3 - e",
    ),
)
def numerator_positive(mono__hprime):
    """It rises from -1 on, where it is 0."""
    slope = next(e for e in mono__hprime.parts if isinstance(e, Eq))
    sign = next(e for e in mono__hprime.parts if isinstance(e, Ge | Le))
    zero = next(e for e in mono__hprime.parts if isinstance(e, Equivalent))
    foot = next(e.rhs for e in zero.args if e.lhs == w)
    numerator = slope.lhs.expr
    vanishes = next(e for e in zero.args if e.lhs != w)
    if not all(is_zero(e - sp.diff(numerator, w)) for e in (slope.rhs, sign.lhs, vanishes.lhs)):
        raise DerivationError(f"{mono__hprime.statement} is not about the slope of {numerator}")
    rising = step("it rises", monotone(numerator, w, Interval(foot, sp.oo), _told_sign(sign)))
    beyond = step("beyond the end", sp.Implies(Gt(w, foot), bound_by_end(rising, w, Gt(w, foot))))
    relation = beyond.args[1]
    if is_zero(relation.rhs) is None:
        raise DerivationError(f"{numerator} is {relation.rhs} at {foot}")
    kind = Ge if isinstance(relation, Gt) else Le
    return And(kind(relation.lhs, 0), Equivalent(Eq(relation.lhs, 0), Eq(w, foot)))


@chapter.derive(
    "projectile.mono.inv-increasing",
    StrictlyIncreasing(RECIPROCAL, alpha, POSITIVE),
    Domain({alpha: CASES}, where=TRIAL),
)
def reciprocal_increases(mono__deriv2, mono__nonneg, mono__alpha2, def__W):
    """W is above -1 for alpha > 0, where the numerator and 1 + W are positive."""
    least = next(e for e in def__W.parts if isinstance(e, Ge) and e.lhs == LambertW(q))
    zero = next(e for e in mono__nonneg.parts if isinstance(e, Equivalent))
    sign = next(e for e in mono__nonneg.parts if isinstance(e, Ge))
    foot = next(e.rhs for e in zero.args if e.lhs == w)
    height = _above_foot(mono__alpha2)
    numerator = sign.lhs
    if least.rhs != foot or is_zero(height.lhs - (W_a - foot)) is None or sign.rhs != 0:
        raise DerivationError(f"{least} and {zero} leave W where the numerator vanishes")
    above, below = sp.symbols("above below", real=True)
    rest = sp.cancel(mono__deriv2.rhs.subs(W_a, w) * (1 + w) / numerator)
    slope_sign = sign_on(rest * above / below, {above: PLUS, below: PLUS})
    return monotone(mono__deriv2.lhs.expr, alpha, POSITIVE, slope_sign)


@chapter.derive(
    "projectile.mono.theta",
    StrictlyDecreasing(Theta(alpha_0), alpha_0, NONNEGATIVE),
    Domain({alpha_0: NONNEGATIVE}, where={**TRIAL, Theta(alpha_0): BEST_FROM_0}),
)
def angle_decreases(mono__inv_increasing, cont__claim, thm2__stationary):
    """The reciprocal of the sine falls on (0, pi/2), where theta_max is; at alpha = 0 theta_max is continuous."""
    root = next(e for e in thm2__stationary.parts if isinstance(e, ExactlyOneRoot))
    outer = 1 / sin(theta)
    falls = monotone(
        outer, theta, BETWEEN, sign_on(sp.diff(outer, theta), trig_box(sp.diff(outer, theta), theta, BETWEEN))
    )
    inner = inner_monotone(mono__inv_increasing.statement, falls, Theta(alpha), root.args[2])
    step("for alpha > 0", inner)
    angle = next(e for e in cont__claim.parts if isinstance(e, Continuous))
    return closed_at_end(inner, angle)


if __name__ == "__main__":
    tell_chapter(chapter.name)
