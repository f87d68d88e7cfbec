"""Where a projectile lands, as a right triangle: the inverse range problem without cancellation, and without k."""

import sympy as sp
from sympy import And, Eq, Limit, cos, exp, sin

from galileo_sym.derivations.beyond.notation import notation, rho, z
from galileo_sym.derivations.projectile.notation import (
    RISING,
    SHOT,
    TRIAL_RANGE,
    U_OF_THETA,
    R,
    W_u,
    alpha,
    g,
    k,
    t,
    theta,
    u,
    v,
    x,
    y,
)  # fmt: skip
from galileo_sym.ledger import POSITIVE, Chapter, DerivationError, Domain, tell_chapter
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.primitives import phi1, phi2
from galileo_sym.tactics import elementary_limit, eliminate_angle, isolate

chapter = Chapter("beyond.landing_triangle", notation, "The landing as a right triangle (not printed)")

S_OF_THETA = (W_u - u).subs(u, U_OF_THETA)
NUMBERS = {alpha: k * v / g, z: S_OF_THETA / alpha, rho: g * TRIAL_RANGE / v**2, t: S_OF_THETA / k}
LANDING = Domain({**SHOT, theta: RISING}, where=NUMBERS)
PARABOLA = Domain({g: POSITIVE, v: POSITIVE, theta: RISING}, {z: 2 * sin(theta), R(theta): v**2 / g * sin(2 * theta)})
LEG, DROP = z * phi1(-alpha * z), z**2 * phi2(-alpha * z)  # v*t and g*t^2, reduced by resistance, as pure numbers


@chapter.derive(
    "beyond.landing.triangle",
    And(
        Eq(rho**2, (LEG - DROP) * (LEG + DROP)),
        Eq(rho, LEG * cos(theta)),
        Eq(DROP, LEG * sin(theta)),
    ),
    LANDING,
)
def triangle(stable__projectile__position__drag, def__alpha):
    """At impact the range and the fall are the legs of a right triangle: nothing cancels, and k may be 0."""
    pure = {t: z * v / g, k: isolate(def__alpha.equation, k).rhs}
    along, up = (
        sp.expand(g * stable__projectile__position__drag.of(place).subs(pure) / v**2) for place in (x(t), y(t))
    )
    launched, dropped = sp.cancel(along / cos(theta)), -up.coeff(sin(theta), 0)
    leg, drop, across = sp.symbols("leg drop across", positive=True)
    names = {launched: leg, dropped: drop}
    level = Eq(dropped, sp.expand(up + dropped), evaluate=False)
    sides = Eq(across, along.subs(names)), Eq(drop, level.rhs.subs(names), evaluate=False)
    circle = eliminate_angle(*sides, theta, (across, drop))
    square = isolate(circle.subs(across, sp.sqrt(across)), across).rhs
    return And(Eq(rho**2, sp.factor(square).subs({leg: launched, drop: dropped})), Eq(rho, along), level)


def _value_at_zero(fact, primitive):
    """The proved limit of a primitive at 0, told by its closed form."""
    told = next(e for e in fact.parts if not e.lhs.has(sp.Derivative))
    form, name = told.lhs.args[:2]
    if is_zero(form - primitive(-name).rewrite(exp)) is None:
        raise DerivationError(f"{told} is not about {primitive.__name__}")
    return told.rhs


@chapter.derive(
    "beyond.landing.no-resistance",
    And(
        Eq(Limit((LEG - DROP) * (LEG + DROP), alpha, 0, "+"), z**2 - z**4 / 4),
        Eq((g * R(theta) / v**2) ** 2, z**2 - z**4 / 4),
    ),
    PARABOLA,
)
def no_resistance(
    beyond__landing__triangle, stable__at_zero__phi1, stable__at_zero__phi2, nodrag__impact, nodrag__range
):
    """As alpha goes to 0 the equation goes to that of the parabola, where z = 2 sin(theta) and rho = sin(2 theta)."""
    square = beyond__landing__triangle.of(rho**2)
    facts = {phi1: stable__at_zero__phi1, phi2: stable__at_zero__phi2}
    values = {}
    for applied in square.atoms(*facts):
        if elementary_limit(applied.args[0], alpha, 0) != 0:
            raise DerivationError(f"{applied} is not taken near 0")
        values[applied] = _value_at_zero(facts[applied.func], applied.func)
    limit = sp.expand(square.subs(values))
    sine = isolate(Eq(z, g * nodrag__impact.of(t) / v, evaluate=False), sin(theta)).rhs
    length = next(e.rhs for e in nodrag__range.parts if e.rhs.has(cos))
    pure = sp.expand((g * length / v**2) ** 2).subs(cos(theta) ** 2, 1 - sin(theta) ** 2)
    return And(
        Eq(Limit(square, alpha, 0, "+"), limit, evaluate=False),
        Eq((g * R(theta) / v**2) ** 2, sp.expand(pure.subs(sin(theta), sine)), evaluate=False),
    )


if __name__ == "__main__":
    tell_chapter(chapter.name)
