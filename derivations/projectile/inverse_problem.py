"""The inverse range problem: u, y and R, and the Lemma with each step of its proof."""

import sympy as sp
from galileo_sym.derivations.projectile.notation import (
    BETWEEN,
    BEYOND,
    CURVATURE,
    HALF_TURN,
    RISING,
    SHOT,
    SLOPE,
    TRIAL,
    TRIAL_Y,
    R,
    U,
    W_u,
    Y,
    g,
    k,
    notation,
    q,
    theta,
    u,
    v,
)  # fmt: skip
from sympy import And, Derivative, Eq, Gt, LambertW, Limit, Lt, cos, cot, exp, sin, tan

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
)  # fmt: skip
from galileo_sym.tactics.boxes import MINUS, PLUS

chapter = Chapter("projectile.inverse_problem", notation, "The inverse range problem: the Lemma")

G = (u + 1) ** 2 - (Y + 1) ** 2
SHORTFALL = 1 - Y / u
BELOW = Domain({u: BEYOND}, where=TRIAL_Y)
LAUNCH = Domain({**SHOT, theta: RISING}, where=TRIAL)
FLAT = Domain({**SHOT, theta: sp.FiniteSet(0)}, where=TRIAL)
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
def bounds(lemma__a__proof, claim__T_monotone, def__W, def__uyR):
    """W, the inverse of the rising half of T, takes arguments between -1/e and 0 to values between -1 and 0."""
    rising = next(e for e in claim__T_monotone.parts if isinstance(e, StrictlyIncreasing))
    inverse = def__uyR.of(Y)
    foot = next(e.rhs for e in def__W.parts if isinstance(e, sp.Ge) and e.lhs == LambertW(q))
    between = inverse_between(rising, inverse, inverse.args[0], foot, sp.S.Zero, lemma__a__proof.statement)
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
    found = step("implicit differentiation", implicit_derivative(lemma__b__implicit.equation, Y, u))
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
def numerator_positive(lemma__a, lemma__b, thm1__cor):
    """The numerator falls as u grows, towards 0 at u = -1."""
    falls = Eq(Derivative(G, u), sp.factor(sp.diff(G, u).subs(SLOPE, lemma__b.of(SLOPE))), evaluate=False)
    sign = compare_on(falls.rhs, sp.S.Zero, {**box_of(*lemma__a.parts), u: BEYOND})
    limit = Eq(Limit(G, u, *thm1__cor.lhs.args[2:]), _at_minus_1(G, thm1__cor), evaluate=False)
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


@chapter.derive("projectile.lemma.d.step1", Eq(Derivative(1 - Y / u, u), -SLOPE / u + Y / u**2), BELOW)
def product_rule(def__uyR):
    """The product rule for the factor of R that depends on u."""
    shortfall = sp.cancel(def__uyR.of(R(k, theta)) * k / (v * cos(theta)))
    return Eq(Derivative(sp.expand(shortfall), u), sp.expand(sp.diff(shortfall, u)), evaluate=False)


@chapter.derive("projectile.lemma.d.step2", Eq(Y / u, (Y + 1) / (u + 1) * SLOPE), BELOW)
def ratio_from_slope(lemma__b):
    """(b) solved for y/u."""
    return Eq(Y / u, sp.cancel(Y / u / lemma__b.of(SLOPE)) * SLOPE, evaluate=False)


@chapter.derive(
    "projectile.lemma.d",
    Eq(Derivative(1 - Y / u, u), -(1 - Y / u) * SLOPE / (u + 1)),
    BELOW,
)
def shortfall_slope(lemma__d__step1, lemma__d__step2):
    """Put y/u in, and collect."""
    put = lemma__d__step1.rhs.subs(Y / u**2, lemma__d__step2.rhs / u)
    return Eq(lemma__d__step1.lhs, sp.factor(put), evaluate=False)


@chapter.derive(
    "projectile.lemma.e.dku",
    And(Eq(Derivative(U(k, theta), k), -v / g * sin(theta)), Eq(Derivative(U(k, theta), k), (u + 1) / k)),
    LAUNCH,
)
def u_against_k(def__uyR):
    """u + 1 is proportional to k."""
    value = def__uyR.of(U(k, theta))
    sine = isolate(Eq(u, value, evaluate=False), sin(theta)).rhs
    found = Eq(Derivative(U(k, theta), k), sp.diff(value, k))
    return And(found, Eq(found.lhs, sp.cancel(found.rhs.subs(sin(theta), sine)), evaluate=False))


def _chain(definition, variable):
    """The derivative of R by the product and the chain rule, u being U(k, theta)."""
    outer = sp.cancel(definition.of(R(k, theta)) / SHORTFALL)
    if outer.has(u, Y):
        raise DerivationError(f"{definition.of(R(k, theta))} is not a multiple of {SHORTFALL}")
    inner = Derivative(SHORTFALL, u) * Derivative(U(k, theta), variable)
    return Eq(Derivative(R(k, theta), variable), sp.diff(outer, variable) * SHORTFALL + outer * inner, evaluate=False)


@chapter.derive(
    "projectile.lemma.e.chain",
    Eq(
        Derivative(R(k, theta), k),
        v * cos(theta) * (-(1 - Y / u) / k**2 + Derivative(1 - Y / u, u) * Derivative(U(k, theta), k) / k),
    ),
    LAUNCH,
)
def chain_rule(def__uyR):
    """Product and chain rule."""
    return _chain(def__uyR, k)


@chapter.derive(
    "projectile.lemma.e",
    Eq(Derivative(R(k, theta), k), -v * cos(theta) * (1 - Y / u) * (1 + SLOPE) / k**2),
    LAUNCH,
)
def range_against_k(lemma__e__chain, lemma__e__dku, lemma__d):
    """Put (d) and the derivative of u in."""
    inner = next(e.rhs for e in lemma__e__dku.parts if e.rhs.has(u))
    put = lemma__e__chain.rhs.subs({lemma__d.lhs: lemma__d.rhs, Derivative(U(k, theta), k): inner})
    return Eq(Derivative(R(k, theta), k), sp.factor(put), evaluate=False)


LEMMA_F = Eq(
    Derivative(R(k, theta), theta), -v / k * sin(theta) * (1 - Y / u) * (1 + SLOPE * cos(theta) ** 2 / sin(theta) ** 2)
)
LEMMA_F_2 = Eq(
    Derivative(R(k, theta), theta), -v / k * sin(theta) * cot(theta) ** 2 * (1 - Y / u) * (tan(theta) ** 2 + SLOPE)
)


@chapter.derive(
    "projectile.lemma.f",
    LEMMA_F,
    LAUNCH,
    erratum=Erratum(("S8",), "for 0 < theta <= pi/2: at theta = 0 it is 0/0 (the limit is 2 v^2/g)", LEMMA_F, FLAT),
)
def range_against_theta(def__uyR, lemma__d):
    """As (e): the chain rule with dU/dtheta = (u + 1) cos(theta)/sin(theta)."""
    value = def__uyR.of(U(k, theta))
    speed = isolate(Eq(u, value, evaluate=False), v).rhs
    inner = Eq(Derivative(U(k, theta), theta), sp.cancel(sp.diff(value, theta).subs(v, speed)), evaluate=False)
    step("u against theta", inner)
    chain = step("chain rule", _chain(def__uyR, theta))
    put = chain.rhs.subs({lemma__d.lhs: lemma__d.rhs, inner.lhs: inner.rhs})
    return Eq(chain.lhs, sp.factor(put), evaluate=False)


@chapter.derive(
    "projectile.lemma.f.second",
    LEMMA_F_2,
    Domain({**SHOT, theta: BETWEEN}, where=TRIAL),
    erratum=Erratum(("S8",), "for 0 < theta < pi/2: at both ends it is 0 times oo", LEMMA_F_2, FLAT),
)
def stationary_form(lemma__f):
    """Divide by what multiplies dy/du."""
    slope_part = sp.expand(lemma__f.rhs)
    coefficient = slope_part.coeff(SLOPE)
    rest = sp.simplify(slope_part.coeff(SLOPE, 0) / coefficient)
    return Eq(lemma__f.lhs, sp.factor(coefficient) * (rest + SLOPE), evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
