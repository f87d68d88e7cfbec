"""The inverse range problem: u, y and R, and Lemma (a) to (c) with each step of the proofs."""

import sympy as sp
from sympy import And, Derivative, Eq, Gt, LambertW, Limit, Lt, cos, exp, sin

from galileo_sym.derivations.projectile.notation import (
    BEYOND,
    CURVATURE,
    HALF_TURN,
    SHOT,
    SLOPE,
    TRIAL_Y,
    R,
    U,
    W_u,
    Y,
    g,
    k,
    notation,
    q,
    s,
    theta,
    u,
    v,
)  # fmt: skip
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    StrictlyDecreasing,
    StrictlyIncreasing,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    above_limit,
    bound_by_end,
    box_of,
    compare_on,
    implicit_derivative,
    inverse_between,
    isolate,
    limit_by_parameter,
)  # fmt: skip
from galileo_sym.tactics.boxes import MINUS, PLUS

chapter = Chapter("projectile.inverse_problem", notation, "The inverse range problem: Lemma (a) to (c)")

G = (u + 1) ** 2 - (Y + 1) ** 2
BELOW = Domain({u: BEYOND}, where=TRIAL_Y)
AT_MINUS_1 = Domain({}, where=TRIAL_Y)

chapter.given(
    "projectile.def.uyR",
    And(
        Eq(u, U(k, theta)),
        Eq(U(k, theta), -1 - v / g * k * sin(theta)),
        Eq(Y, W_u),
        Eq(R(k, theta), v * cos(theta) / k * (1 - Y / u)),
    ),
    Domain({**SHOT, theta: HALF_TURN}),
    premises=("projectile.def.u", "projectile.range.u"),
)


@chapter.derive("projectile.lemma.a.proof", And(Gt(u * exp(u), -exp(-1)), Lt(u * exp(u), 0, evaluate=False)), BELOW)
def product_between(claim__T_monotone):
    """T falls up to -1, so that it is above T(-1) below -1; it has the sign of u."""
    falling = next(e for e in claim__T_monotone.parts if isinstance(e, StrictlyDecreasing))
    above = bound_by_end(falling, u, Lt(u, -1))
    return And(above, compare_on(above.lhs, sp.S.Zero, {exp(u): POSITIVE, u: BEYOND}))


@chapter.derive(
    "projectile.lemma.a",
    And(Gt(Y, -1), Lt(Y, 0), Gt(Y / u, 0), Lt(Y / u, 1)),
    BELOW,
    erratum=Erratum(
        ("S6",),
        "the implication is the other way round: for all u < -1, and hence for all 0 < theta <= pi/2",
    ),
)
def bounds(lemma__a__proof, claim__T_monotone, def__W, res1, def__uyR):
    """W, the inverse of the rising half of T, takes arguments between -1/e and 0 to values between -1 and 0."""
    rising = next(e for e in claim__T_monotone.parts if isinstance(e, StrictlyIncreasing))
    inverse = def__uyR.of(Y)
    values = next(e for e in def__W.parts if isinstance(e, sp.Ge) and e.lhs == LambertW(q))
    round_trip, bounded = res1.equation.reversed, lemma__a__proof.statement
    between = inverse_between(rising, round_trip, values, inverse.args[0], sp.S.Zero, bounded)
    inside = step("values of W", between.subs(inverse, Y))
    box = {**box_of(inside), u: BEYOND}
    return And(inside, *(compare_on(Y / u, bound, box) for bound in (sp.S.Zero, sp.S.One)))


@chapter.derive("projectile.lemma.b.implicit", Eq(Y * exp(Y), u * exp(u)), BELOW)
def product_kept(res1, def__uyR):
    """(1) at x = u e^u."""
    inverse = def__uyR.of(Y)
    return res1.subs(q, inverse.args[0]).subs(inverse, Y).reversed


@chapter.derive(
    "projectile.lemma.b",
    And(
        Eq(SLOPE, (u + 1) * Y / ((Y + 1) * u)),
        Eq(SLOPE, (1 + 1 / u) / (1 + 1 / Y)),
        Lt((u + 1) * Y / ((Y + 1) * u), 0),
    ),
    BELOW,
)
def slope(lemma__b__implicit, lemma__a):
    """Implicit differentiation; e^y from y e^y = u e^u; the sign from (a)."""
    between = [e for e in lemma__a.parts if Y in e.args]
    found = step("implicit differentiation", implicit_derivative(lemma__b__implicit.equation, Y, u, *between))
    power = sp.Dummy("power", positive=True)
    growth = isolate(lemma__b__implicit.subs(exp(Y), power), power).rhs
    first = sp.factor(found.rhs.subs(exp(Y), growth))
    top, bottom = (sp.expand(part / (u * Y)) for part in sp.fraction(first))
    sign = compare_on(first, sp.S.Zero, {**box_of(*lemma__a.parts), u: BEYOND})
    return And(Eq(SLOPE, first), Eq(SLOPE, top / bottom), sign)


@chapter.derive(
    "projectile.lemma.c.slope-limit",
    And(
        Eq(Limit(SLOPE, u, -1, "-"), Limit((u + 1) / (Y + 1), u, -1, "-") * Limit(Y / u, u, -1, "-")),
        Eq(Limit(SLOPE, u, -1, "-"), -1),
    ),
    AT_MINUS_1,
)
def slope_limit(lemma__b, thm1__cor):
    """The slope is a product; one factor is the reciprocal of the corollary's, the other tends to 1."""
    ratio = thm1__cor.lhs.args[0].subs(W_u, Y)
    first, second = 1 / ratio, sp.cancel(lemma__b.of(SLOPE) * ratio)
    if is_zero(second - Y / u) is None:
        raise DerivationError(f"{lemma__b.of(SLOPE)} is not y/u times {first}")
    limits = [Limit(part, u, *thm1__cor.lhs.args[2:]) for part in (first, second)]
    values = [_at_minus_1(part, thm1__cor) for part in (first, second)]
    for limit, value in zip(limits, values, strict=True):
        step("a factor", Eq(limit, value, evaluate=False))
    whole = Limit(SLOPE, u, *thm1__cor.lhs.args[2:])
    return And(Eq(whole, sp.Mul(*limits), evaluate=False), Eq(whole, sp.Mul(*values), evaluate=False))


def _at_minus_1(expr, corollary):
    """The limit of a rational expression in u and y where the corollary gives that of rho = (y + 1)/(u + 1)."""
    rho, height = sp.symbols("rho height", real=True)
    ratio, _, point, _ = corollary.lhs.args
    y_of_rho = isolate(Eq(rho, ratio.subs(W_u, height), evaluate=False), height).rhs
    return sp.cancel(expr.subs(Y, y_of_rho)).subs({rho: corollary.rhs, u: point})


@chapter.derive(
    "projectile.lemma.c.second",
    Eq(CURVATURE, ((u + 1) ** 2 - (Y + 1) ** 2) / (u**2 * Y**2 * (1 + 1 / Y) ** 3)),
    BELOW,
    erratum=Erratum(
        ("S7",),
        "in dy/du, from which this is derived, 1 + 1/y is printed as 1 + 1/v",
        Eq(SLOPE, (1 + 1 / u) / (1 + 1 / v)),
        Domain({u: BEYOND, v: POSITIVE}, where=TRIAL_Y),
    ),
)
def second_derivative(lemma__b):
    """Differentiate (b), and put dy/du in."""
    first = lemma__b.of(SLOPE)
    again = step("differentiate (b)", Eq(CURVATURE, sp.diff(first, u)))
    return Eq(CURVATURE, sp.factor(again.rhs.subs(SLOPE, first)), evaluate=False)


@chapter.derive("projectile.lemma.c.denominator", Lt(u**2 * Y**2 * (1 + 1 / Y) ** 3, 0), BELOW)
def denominator_negative(lemma__a, lemma__c__second):
    """u^2 y^2 (1 + 1/y)^3 is u^2/y times (1 + y)^3."""
    over = sp.cancel(G / lemma__c__second.rhs)
    return compare_on(over, sp.S.Zero, {**box_of(*lemma__a.parts), u: BEYOND})


@chapter.derive(
    "projectile.lemma.c.G",
    And(
        Eq(Derivative(G, u), 2 * (u + 1) * (1 - Y / u)),
        Lt(2 * (u + 1) * (1 - Y / u), 0),
        Eq(Limit(G, u, -1, "-"), 0),
        Gt(G, 0),
    ),
    BELOW,
)
def numerator_positive(lemma__a, lemma__b, support__s_param):
    """The numerator falls as u grows, towards 0 at u = -1."""
    falls = Eq(Derivative(G, u), sp.factor(sp.diff(G, u).subs(SLOPE, lemma__b.of(SLOPE))), evaluate=False)
    sign = compare_on(falls.rhs, sp.S.Zero, {**box_of(*lemma__a.parts), u: BEYOND})
    in_s, u_of_s = support__s_param.of(W_u), support__s_param.of(u)
    found = limit_by_parameter(G.subs(Y, in_s).subs(u, u_of_s), u, -1, "-", s, u_of_s, 0)
    limit = Eq(Limit(G, u, -1, "-"), found, evaluate=False)
    return And(falls, sign, limit, above_limit(sign, limit, slope=falls))


SIDES = {sp.StrictGreaterThan: PLUS, sp.StrictLessThan: MINUS}


@chapter.derive("projectile.lemma.c", And(Lt(CURVATURE, 0), Gt(SLOPE, -1), Lt(SLOPE, 0)), BELOW)
def concave(lemma__c__second, lemma__c__denominator, lemma__c__G, lemma__c__slope_limit, lemma__b):
    """A positive numerator over a negative denominator; so dy/du falls towards -1; it is negative by (b)."""
    over, under = lemma__c__G.parts, lemma__c__denominator.statement
    top = next(e for e in over if isinstance(e, Gt))
    if is_zero(lemma__c__second.rhs - top.lhs / under.lhs) is None:
        raise DerivationError(f"{lemma__c__second.rhs} is not {top.lhs} over {under.lhs}")
    above, below = sp.symbols("above below", real=True)
    sign = compare_on(above / below, sp.S.Zero, {above: SIDES[type(top)], below: SIDES[type(under)]})
    curved = sign.subs(above / below, CURVATURE)
    negative = next(e for e in lemma__b.parts if isinstance(e, Lt))
    limit = next(e for e in lemma__c__slope_limit.parts if not e.rhs.has(Limit))
    return And(curved, above_limit(curved, limit), negative.subs(lemma__b.of(SLOPE), SLOPE))


if __name__ == "__main__":
    tell_chapter(chapter.name)
