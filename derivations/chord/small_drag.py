"""Section 4, end: Lambert W near its branch point, equations (37) to (39), and the descent time at small drag."""

import sympy as sp
from sympy import And, Eq, Gt, Interval, LambertW, Limit, exp, sqrt

from galileo_sym.derivations.chord.notation import W_0, W_1, D, F, g, gamma, h, notation, q, w
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
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    conclusions,
    elementary_limit,
    isolate,
    limit_along,
    limit_by_parameter,
    limit_with_part,
    other_branch,
    revert_minimum,
    taylor,
    undo,
)

chapter = Chapter("chord.small_drag", notation, "4. Motion under a resistive force proportional to velocity")

PLACE = Domain({})
BESIDE = Domain({h: Interval.open(0, 1)})
LEAST = -exp(-1)
PARABOLA = -exp(-1) + exp(-1) / 2 * (w + 1) ** 2
ROOT = sqrt(2 * (sp.E * q + 1))
ONE_SIDED = Erratum(
    ("C11",),
    "one-sided, q -> (-1/e)+, where the root is real; with p = ±sqrt(2(eq + 1)) the next term is -p^2/3 in both",
)


def remainder(side):
    """What is left of F beyond its parabola, over (w + 1)^3, near w = -1."""
    return Limit((F(w) - PARABOLA) / (w + 1) ** 3, w, -1, side)


@chapter.derive(
    "chord.eq37", And(Eq(remainder("+"), exp(-1) / 3), Eq(remainder("-"), exp(-1) / 3, evaluate=False)), PLACE
)
def expansion(eq34, claim__F_minimum):
    """Taylor's polynomial at the minimum; the remainder over (w + 1)^3 has one limit from both sides."""
    least = next(e for e in claim__F_minimum.parts if isinstance(e, Eq))
    place = least.lhs.args[0]
    square = taylor(eq34.rhs, w, place, 2)
    if is_zero(square.subs(w, place) - least.rhs) is None:
        raise DerivationError(f"{square} does not begin with the least value {least.rhs}")
    ratio = (eq34.lhs - square) / (w - place) ** 3
    known = ratio.subs(eq34.lhs, eq34.rhs)
    return And(*(Eq(Limit(ratio, w, place, d), elementary_limit(known, w, place, d), evaluate=False) for d in "+-"))


def near_branch_point(branch, sign):
    """(38) or (39): the limits that say W(q) = -1 ± p - p^2/3 + o(p^2), p = sqrt(2 (e q + 1))."""
    lead = (branch(q) + 1) / ROOT
    rest = (branch(q) + 1 - sign * ROOT) / (sp.E * q + 1)
    return And(
        Eq(Limit(lead, q, LEAST, "+"), sign, evaluate=False),
        Eq(Limit(rest, q, LEAST, "+"), -sp.Rational(2, 3), evaluate=False),
    )


def invert(eq37, branches, monotony, branch):
    """Revert (37) to a series in the root, on both sides; limits along q = F(-1 ± h) tell which one W is."""
    bound = next(e for e in branches.parts if isinstance(e, sp.Ge | sp.Le) and e.lhs == branch(q))
    sign, side = (1, "+") if isinstance(bound, sp.Ge) else (-1, "-")
    cubic, place = as_polynomial(eq37, side)
    least, half = cubic.coeff_monomial(1), cubic.coeff_monomial(h**2)
    p = sp.Dummy("p")
    series = {k.coeff(p): k for k in revert_minimum(cubic.as_expr(), h, p)}
    root = sqrt(sp.expand((q - least) / half))
    path = along(branches, monotony, bound, place + sign * h)

    def limit(expr):
        on_path = expr.subs(branch(q), place + sign * h).subs(q, path)
        return limit_by_parameter(on_path, q, least, "+", h, path, 0)

    lead = (branch(q) - place) / root
    first = limit(lead)
    step("the sign of the root", Eq(Limit(lead, q, least, "+"), first, evaluate=False))
    rest = (branch(q) - place - first * root) / sp.expand(root**2 / 2)
    second = limit(rest)
    if is_zero(second - 2 * series[first].coeff(p, 2)) is None:
        raise DerivationError(f"the series {series[first]} of (37) is not that of {branch(q)}: {second} is the limit")
    return And(*(Eq(Limit(e, q, least, "+"), v, evaluate=False) for e, v in ((lead, first), (rest, second))))


def as_polynomial(eq37, side):
    """F(-1 + h) up to h^3, and the place -1, from the remainder on one side."""
    told = next(e for e in eq37.parts if str(e.lhs.args[3]) == side)
    ratio, _, place, _ = told.lhs.args
    over, under = sp.fraction(ratio)
    cubic = sp.expand((F(w) - over + told.rhs * under).subs(w, place + h))
    return sp.Poly(cubic, h), place


def along(branches, monotony, bound, place):
    """q = F(place), where W(q) is that place: F is one-to-one on each side of its minimum."""
    kind = StrictlyIncreasing if isinstance(bound, sp.Ge) else StrictlyDecreasing
    claim = next(c for c in monotony.parts if isinstance(c, kind))
    round_trip = next(e for e in branches.parts if isinstance(e, Eq) and e.lhs.has(exp) and e.lhs.has(bound.lhs))
    same, inside = sorted(undo(claim, round_trip, bound, place).args, key=lambda e: not isinstance(e, Eq))
    if not (inside.gts - inside.lts).is_positive:
        raise DerivationError(f"{inside} is not known")
    path = same.lhs.args[0]
    told = branches.of(bound.lhs).subs(q, path)
    step("along this path", Eq(told, same.rhs, evaluate=False))  # unevaluated: SymPy takes W_(-1) for another number
    return path


@chapter.derive("chord.eq38", near_branch_point(W_0, 1), BESIDE, erratum=ONE_SIDED)
def principal(eq37, claim__W_branches, claim__F_monotone):
    """(37) inverted for w > -1."""
    return invert(eq37, claim__W_branches, claim__F_monotone, W_0)


@chapter.derive(
    "chord.eq39", near_branch_point(W_1, -1), Domain(BESIDE.ranges, where={W_1(q): LambertW(q, -1)}), erratum=ONE_SIDED
)
def other(eq37, claim__W_branches, claim__F_monotone):
    """(37) inverted for w < -1, where q = F(-1 - h) is negative."""
    falling, w, side = next(c for c in claim__F_monotone.parts if isinstance(c, StrictlyDecreasing)).args
    branches = conclusions(claim__W_branches, q, falling.subs(w, side.end - h))
    return invert(eq37, branches, claim__F_monotone, W_1)


TIME = 1 / gamma + gamma * D / g + LambertW(-exp(-1 - gamma**2 * D / g)) / gamma


@chapter.derive(
    "chord.claim.gamma-limit-pm",
    And(
        Eq(Limit(TIME, gamma, 0, "+"), sqrt(2 * D / g)),
        Eq(Limit(other_branch(TIME), gamma, 0, "+"), -sqrt(2 * D / g)),
    ),
    Domain({g: POSITIVE, D: POSITIVE}),
)
def small_drag(eq36, eq38, eq39, claim__W_branches):
    """In (36) put W = -1 + rho sqrt(2 (e q + 1)), q = -e^(-1 - c): rho goes to 1 by (38), to -1 by (39)."""
    facts = []
    for near, branch, time in ((eq38, W_0, eq36.rhs), (eq39, W_1, other_branch(eq36.rhs))):
        known = next(e for e in near.parts if sp.denom(e.lhs.args[0]).is_Pow)  # over the root, not over its square
        (inverse,) = time.atoms(LambertW)
        path = inverse.args[0]
        rho, name = sp.symbols("rho name", real=True)
        value = conclusions(claim__W_branches, q, path).of(branch(q))
        ratio = known.lhs.args[0].subs(branch(q), value).subs(inverse.subs(path, q), name)
        put = isolate(Eq(rho, ratio, evaluate=False), name).rhs.subs(q, path)
        slope = limit_along(known, gamma, path, 0)
        limit = limit_with_part(time.subs(inverse, put), rho, slope, gamma, 0)
        facts.append(Eq(Limit(time, gamma, 0, "+"), limit, evaluate=False))
    if not (facts[0].rhs.is_positive and facts[1].rhs.is_negative):
        raise DerivationError("the two branches do not give times of opposite signs")
    step("a time is positive, which W_0 alone gives", Gt(facts[0].rhs, 0, evaluate=False))
    return And(*facts)


if __name__ == "__main__":
    tell_chapter(chapter.name)
