"""Flight in pure numbers: lengths in v^2/g, times in v/g, so that v and g drop out and alpha = k v/g is left."""

import sympy as sp
from sympy import And, Eq, cos, exp, sin

from galileo_sym.derivations.beyond.notation import X, Y, notation, rho, z
from galileo_sym.derivations.projectile.notation import (
    HALF_TURN,
    RISING,
    R,
    StationaryAngle,
    W_u,
    a,
    alpha,
    b,
    c,
    d,
    g,
    k,
    t,
    theta,
    theta_max,
    u,
    v,
    w,
    x,
    y,
)
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Independent,
    UniqueMaximum,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import rescale, solve_linear_exponential, solve_motion, start_of

chapter = Chapter("beyond.pure_flight", notation, "What the papers leave open: flight in pure numbers")

LENGTH, TIME = v**2 / g, v / g
SHOT = {g: POSITIVE, v: POSITIVE, alpha: POSITIVE, theta: HALF_TURN}
UNITS = {k: alpha / TIME}
RESISTED = 1 - exp(-alpha * z)
ACROSS = cos(theta) * RESISTED / alpha
UP = ((1 + alpha * sin(theta)) * RESISTED - alpha * z) / alpha**2
U = -1 - alpha * sin(theta)
FLIGHT = (-u + W_u) / alpha
RANGE = cos(theta) / alpha * (1 - W_u / u)
PURE = {u: U}
PLACE = {X(z): ACROSS, Y(z): UP}


def in_units(expr):
    """k written as alpha g/v, tidied: v and g must drop out."""
    pure = sp.expand(sp.powsimp(expr.subs(k, alpha / TIME)))
    if pure.has(v, g, k):
        raise DerivationError(f"the units are still seen in {pure}")
    return pure


@chapter.derive(
    "beyond.pure-flight.laws",
    And(
        Eq(X(z).diff(z, 2) + alpha * X(z).diff(z), 0),
        Eq(Y(z).diff(z, 2) + alpha * Y(z).diff(z), -1),
        Eq(X(0), 0),
        Eq(Y(0), 0),
        Eq(X(z).diff(z).subs(z, 0), cos(theta)),
        Eq(Y(z).diff(z).subs(z, 0), sin(theta)),
    ),
    Domain({**SHOT, z: NONNEGATIVE}, where={**UNITS, **PLACE}),
)
def laws(law__drag__x, law__drag__y, setup):
    """Put x = (v^2/g) X, y = (v^2/g) Y and t = (v/g) z into the laws and the initial values."""
    parts = []
    for law, old, new in ((law__drag__x, x(t), X(z)), (law__drag__y, y(t), Y(z))):
        changed = step("other units", rescale(law.equation, old, new, length=LENGTH, time=TIME))
        left, right = (sp.expand(side * TIME**2 / LENGTH) for side in changed.args)
        drag = right.coeff(new.diff(z)) * new.diff(z)
        parts.append(Eq(left - in_units(drag), in_units(right - drag), evaluate=False))
        for told, value in start_of(setup.parts, old).items():
            begin = rescale(Eq(told, value, evaluate=False), old, new, length=LENGTH, time=TIME)
            scale = next(e for e in sp.preorder_traversal(begin.lhs) if e in (new.subs(z, 0), new.diff(z).subs(z, 0)))
            parts.append(Eq(scale, in_units(begin.rhs * scale / begin.lhs), evaluate=False))
    return And(*parts)


@chapter.derive(
    "beyond.pure-flight.motion",
    And(Eq(X(z), sp.expand(ACROSS)), Eq(Y(z), sp.expand(UP))),
    Domain({**SHOT, z: NONNEGATIVE}, where=UNITS),
)
def motion(beyond__pure_flight__laws, drag__x, drag__y):
    """Solved from the launch; it is the paper's motion in the new units."""
    told, found = beyond__pure_flight__laws.parts, []
    for known, new in ((drag__x, X(z)), (drag__y, Y(z))):
        law = next(e for e in told if e.lhs.has(new.diff(z, 2)))
        found.append(solve_motion(law, new, start_of(told, new)))
        if is_zero(found[-1].rhs - in_units(known.rhs.subs(t, TIME * z) / LENGTH)) is None:
            raise DerivationError(f"{found[-1]} is not {known.statement} in the new units")
    return And(*found)


@chapter.derive(
    "beyond.pure-flight.impact",
    And(Eq(u, U), Eq(-alpha * z - u + u * exp(-alpha * z), 0)),
    Domain({alpha: POSITIVE, theta: RISING}, where={z: FLIGHT, **PURE}),
)
def impact(beyond__pure_flight__motion):
    """Y = 0, times alpha^2; u names the coefficient of the exponential."""
    landing = sp.expand(beyond__pure_flight__motion.of(Y(z)) * alpha**2)
    power = exp(-alpha * z)
    value = landing.coeff(power)
    rest = sp.expand(landing - value * power).subs(sin(theta), sp.solve(value - u, sin(theta))[0])
    return And(Eq(u, value), Eq(sp.expand(rest) + u * power, 0, evaluate=False))


@chapter.derive("beyond.pure-flight.time", Eq(z, FLIGHT), Domain({alpha: POSITIVE, theta: RISING}, where=PURE))
def time(beyond__pure_flight__impact, res3, claim__domain_W):
    """Result (3); the unknown is the pure number alpha z, whose coefficients are pure numbers, too."""
    equation = next(e for e in beyond__pure_flight__impact.parts if e.has(exp))
    exists = step("the argument of W is in its domain", claim__domain_W.subs(w, u))
    return solve_linear_exponential(res3.equation, (t, a, b, c, d), equation, z, exists)


@chapter.derive(
    "beyond.pure-flight.range",
    Eq(rho, RANGE),
    Domain({alpha: POSITIVE, theta: RISING}, where={**PURE, rho: ACROSS.subs(z, FLIGHT)}),
)
def flight_range(beyond__pure_flight__motion, beyond__pure_flight__time, range__expW):
    """X at the time of impact, with the power of e by result (1)."""
    there = beyond__pure_flight__motion.of(X(z)).subs(z, beyond__pure_flight__time.of(z))
    apart = sp.expand(there)
    if not apart.has(range__expW.lhs):
        raise DerivationError(f"{apart} has no {range__expW.lhs}")
    return Eq(rho, sp.expand(apart.subs(range__expW.lhs, range__expW.rhs)), evaluate=False)


@chapter.derive(
    "beyond.pure-flight.independent",
    And(
        Eq(t, v / g * z),
        Eq(R(k, theta), v**2 / g * rho),
        *(Independent(g * t / v, unit) for unit in (v, g)),
        *(Independent(g * R(k, theta) / v**2, unit) for unit in (v, g)),
    ),
    Domain(
        {**SHOT, theta: RISING},
        where={**UNITS, **PURE, t: alpha * FLIGHT / k, R(k, theta): v * alpha * RANGE / k, z: FLIGHT, rho: RANGE},
    ),
)
def independent(impact__time, range__u, beyond__pure_flight__time, beyond__pure_flight__range, def__u):
    """The paper's time and range, over v/g and v^2/g, are the pure ones: for a given alpha v and g drop out."""
    sine = step("u in alpha", Eq(u, in_units(def__u.of(u)), evaluate=False))
    same, free = [], []
    for symbol, paper, pure, unit in (
        (t, impact__time.of(t), beyond__pure_flight__time.equation, TIME),
        (R(k, theta), range__u.of(R(k, theta)), beyond__pure_flight__range.equation, LENGTH),
    ):
        ratio = in_units(paper / unit)
        if is_zero(ratio - pure.rhs) is None:
            raise DerivationError(f"{ratio} is not {pure.rhs}")
        same.append(Eq(symbol, unit * pure.lhs, evaluate=False))
        free += [Independent(symbol / unit, q) for q in (v, g) if not ratio.subs(u, sine.rhs).has(q)]
    return And(*same, *free)


@chapter.derive(
    "beyond.pure-flight.best-angle",
    UniqueMaximum(RANGE.subs(u, U), theta, HALF_TURN, theta_max),
    Domain({alpha: POSITIVE}, where={theta_max: StationaryAngle(alpha)}),
)
def best_angle(thm2__b, beyond__pure_flight__independent, beyond__pure_flight__range, def__u):
    """R = (v^2/g) rho, a positive unit that is free of theta: rho is largest where R is, and alpha alone is in rho."""
    top = next(e for e in thm2__b.parts if isinstance(e, UniqueMaximum))
    unit = beyond__pure_flight__independent.of(top.args[0]) / rho
    if not unit.is_positive or unit.has(theta):
        raise DerivationError(f"{unit} is not a unit")
    pure = beyond__pure_flight__range.of(rho).subs(u, in_units(def__u.of(u)))
    if pure.free_symbols != {alpha, theta}:
        raise DerivationError(f"{pure} depends on more than alpha and theta")
    return UniqueMaximum(pure, *top.args[1:])


if __name__ == "__main__":
    tell_chapter(chapter.name)
