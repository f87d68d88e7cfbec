"""The inverse range problem: Lemma (d) to (f), the slopes of the range, with each step of the proofs."""

import sympy as sp
from sympy import And, Derivative, Eq, cos, cot, sin, tan

from galileo_sym.derivations.projectile.notation import (
    BETWEEN,
    BEYOND,
    RISING,
    SHOT,
    SLOPE,
    TRIAL,
    TRIAL_Y,
    R,
    U,
    Y,
    g,
    k,
    notation,
    theta,
    u,
    v,
)  # fmt: skip
from galileo_sym.ledger import (
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.tactics import (
    isolate,
)  # fmt: skip

chapter = Chapter("projectile.range_slopes", notation, "The inverse range problem: Lemma (d) to (f)")

SHORTFALL = 1 - Y / u
BELOW = Domain({u: BEYOND}, where=TRIAL_Y)
LAUNCH = Domain({**SHOT, theta: RISING}, where=TRIAL)
FLAT = Domain({**SHOT, theta: sp.FiniteSet(0)}, where=TRIAL)


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
