"""Section 4, second half: the descent time by Lambert W, equations (33) to (36), with the branch for every drag."""

import sympy as sp
from sympy import And, Eq, Ge, Gt, Implies, Interval, LambertW, Le, Limit, Lt, Or, exp, oo

from galileo_sym.derivations.chord.notation import W_0, W_1, D, F, c, g, gamma, notation, q, t_AB, w, zeta
from galileo_sym.ledger import (
    POSITIVE,
    REAL,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    ExactlyOneRoot,
    StrictlyDecreasing,
    StrictlyIncreasing,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    arguments_reversed,
    check_root,
    conclusions,
    elementary_limit,
    isolate,
    least_value,
    monotone_on_half_line,
    one_root,
    other_branch,
    sign_by_factors,
)

chapter = Chapter("chord.descent_by_lambert_w", notation, "4. Motion under a resistive force proportional to velocity")

DROP = Domain({g: POSITIVE, D: POSITIVE, gamma: POSITIVE})
LINE = Domain({w: REAL})
FALLING = Interval(-oo, -1)
RISING = Interval(-1, oo)
BOTH_SIDES = Domain({w: sp.Union(FALLING, RISING, evaluate=False)})  # so that w = -1, where F is least, is tried

BELOW_0, FROM_0 = Interval.Ropen(-exp(-1), 0), Interval(0, oo)
VALUES = sp.Union(BELOW_0, FROM_0, evaluate=False)  # of F: each is taken once from 0 on, and twice below, but for -1/e
OTHER_ROOT = sp.Piecewise((LambertW(q, -1), q < 0), (LambertW(q), True))
ANY_OR_A_ROOT = sp.Union(sp.FiniteSet(LambertW(q)), sp.FiniteSet(OTHER_ROOT), REAL, evaluate=False)

EQ36 = Eq(t_AB, 1 / gamma + gamma * D / g + LambertW(-exp(-1 - gamma**2 * D / g)) / gamma)
ARRIVAL = Eq(D, g / gamma * t_AB - g / gamma**2 * (1 - exp(-gamma * t_AB)))
ONLY_LIMIT = Erratum(
    ("C7",),
    "the paper chooses W_0 by the limit gamma -> 0 only; it is right for every gamma > 0, and not for gamma < 0, where "
    "the positive root of (30) is that by W_(-1)",
    Implies(And(Gt(t_AB, 0, evaluate=False), ARRIVAL), EQ36),
    Domain(
        {g: sp.FiniteSet(1), D: sp.FiniteSet(1), gamma: sp.FiniteSet(-sp.Rational(1, 2))},
        where={t_AB: other_branch(EQ36.rhs)},
    ),
)


def part_of(premise, kind):
    """The part of a conjunction that is a claim, or an inequality, of one kind."""
    return next(p for p in premise.parts if isinstance(p, kind))


chapter.given("chord.eq34", Eq(F(w), w * exp(w)), LINE)


@chapter.derive(
    "chord.claim.F-monotone",
    And(StrictlyDecreasing(w * exp(w), w, FALLING), StrictlyIncreasing(w * exp(w), w, RISING)),
    LINE,
)
def f_monotone(eq34):
    """F' = (1 + w) e^w has the sign of 1 + w."""
    step("derivative", Eq(F(w).diff(w), sp.factor(sp.diff(eq34.rhs, w)), evaluate=False))
    return And(*(monotone_on_half_line(eq34.rhs, w, side) for side in (FALLING, RISING)))


@chapter.derive("chord.claim.F-minimum", And(Ge(w * exp(w), -exp(-1)), Eq(F(-1), -exp(-1))), BOTH_SIDES)
def f_minimum(eq34, claim__F_monotone):
    """F falls before w = -1 and rises after it."""
    falls, rises = (part_of(claim__F_monotone, kind) for kind in (StrictlyDecreasing, StrictlyIncreasing))
    least = least_value(falls, rises)
    return And(least, Eq(F(-1), eq34.rhs.subs(w, falls.args[2].end), evaluate=False))


chapter.given(
    "chord.claim.W-branches",
    And(
        Eq(W_0(q), LambertW(q)),
        Ge(W_0(q), -1),
        Eq(W_0(q) * exp(W_0(q)), q),
        Implies(Lt(q, 0), And(Eq(W_1(q), LambertW(q, -1)), Le(W_1(q), -1), Eq(W_1(q) * exp(W_1(q)), q))),
    ),
    Domain({q: VALUES}, where={W_0(q): LambertW(q), W_1(q): LambertW(q, -1)}),
    premises=("chord.claim.F-monotone",),
)

chapter.given(
    "chord.eq35",
    sp.Equivalent(Eq(w * exp(w), q), Or(Eq(w, LambertW(q)), And(Lt(q, 0), Eq(w, LambertW(q, -1))))),
    Domain({q: VALUES, w: ANY_OR_A_ROOT}),
    premises=("chord.eq34", "chord.claim.W-branches"),
    erratum=Erratum(("C9",), "multivalued as printed: W_0 for w >= -1 (q >= -1/e), W_(-1) for w <= -1 (-1/e <= q < 0)"),
)


@chapter.derive(
    "chord.eq33",
    Eq(F(gamma * t_AB - 1 - gamma**2 * D / g), -exp(-1 - gamma**2 * D / g)),
    Domain({g: POSITIVE, gamma: POSITIVE, t_AB: POSITIVE}),
)
def as_f(eq30, eq34):
    """Multiply (30) by (gamma^2/g) e^(gamma t - 1 - c) > 0, c = gamma^2 D/g: no root is gained or lost."""
    argument = sp.expand(gamma * t_AB - 1 - gamma**2 * D / g)
    factor = sp.exp(argument) * gamma**2 / g
    left = sp.expand((eq30.rhs - eq30.lhs) * factor)
    value = sp.simplify(eq34.rhs.subs(w, argument) - sp.powsimp(left))
    return Eq(F(argument), value, evaluate=False)


PRINCIPAL = Gt(1 + c + LambertW(-exp(-1 - c)), 0, evaluate=False)
OTHER = Lt(1 + c + LambertW(-exp(-1 - c), -1), 0, evaluate=False)


@chapter.derive("chord.claim.principal-branch", And(PRINCIPAL, OTHER), Domain({c: POSITIVE}), erratum=ONLY_LIMIT)
def principal_branch(claim__W_branches, claim__F_monotone, eq34):
    """W_0 >= -1 gives gamma t >= c > 0, c = gamma^2 D/g; F(-1-c) < -e^(-1-c), F falling, gives W_(-1) < -1-c."""
    value = -exp(-1 - c)
    branches = conclusions(claim__W_branches, q, value)
    bound = part_of(branches, sp.GreaterThan)
    least = 1 + c + bound.lts
    if bound.gts != W_0(q) or not least.is_positive:
        raise DerivationError(f"gamma t >= {least} is not positive")
    step("by W_0 the time is at least", Ge(1 + c + branches.of(W_0(q)).subs(q, value), least, evaluate=False))
    falls = part_of(claim__F_monotone, StrictlyDecreasing)
    below = step("a value below", Lt(eq34.rhs.subs(w, -1 - c), value, evaluate=False))
    if sign_by_factors(sp.factor(sp.expand(below.lts - below.gts)), {}) != -1:
        raise DerivationError(f"{below} is not known")
    root = branches.of(W_1(q)).subs(q, value)
    inverse = next(p for p in branches.parts if p.has(exp) and p.has(W_1))
    image = Eq(*(side.subs(q, value).subs(W_1(value), root) for side in inverse.args), evaluate=False)
    beyond = part_of(branches, sp.LessThan)
    if beyond.lts != W_1(q):
        raise DerivationError(f"{beyond} is not the bound of W_(-1)")
    inside = [step("W_(-1) lies where F falls", Le(root, beyond.gts, evaluate=False))]
    left = arguments_reversed(falls, below, -1 - c, image, root, inside)
    least_time = 1 + c + branches.of(W_0(q)).subs(q, value)
    return And(Gt(least_time, 0, evaluate=False), Lt(1 + c + left.lts, 1 + c + left.gts, evaluate=False))


@chapter.derive(
    "chord.eq36",
    EQ36,
    DROP,
    erratum=ONLY_LIMIT,
)
def descent_time(eq33, eq34, claim__W_branches, claim__principal_branch):
    """Invert F on the branch that gives a positive time."""
    argument, value = eq33.lhs.args[0], eq33.rhs
    step("(33) with F written out", Eq(eq34.rhs.subs(w, argument), value, evaluate=False))
    drop = gamma**2 * D / g
    branches = conclusions(claim__W_branches, q, value)
    positive = part_of(claim__principal_branch, sp.StrictGreaterThan).gts.subs(c, drop)
    for branch in (W_0, W_1):
        inverse = branches.of(branch(q)).subs(q, value)
        found = isolate(Eq(argument, inverse, evaluate=False), t_AB)
        if sp.simplify(sp.expand(gamma * found.rhs - positive)) == 0:
            return step("back from w to the time", Eq(t_AB, sp.expand(found.rhs)))
    raise DerivationError("neither branch gives the positive time")


HEIGHT = zeta - 1 + exp(-zeta)
BY_W = 1 + c + LambertW(-exp(-1 - c))


@chapter.derive(
    "chord.support.root-unique",
    And(
        ExactlyOneRoot(HEIGHT - c, zeta, POSITIVE),
        ExactlyOneRoot(HEIGHT - c, zeta, Interval.open(-oo, 0)),
        Eq(HEIGHT.subs(zeta, BY_W), c, evaluate=False),
        Eq(HEIGHT.subs(zeta, other_branch(BY_W)), c, evaluate=False),
        Gt(BY_W, 0, evaluate=False),
        Lt(other_branch(BY_W), 0, evaluate=False),
    ),
    Domain({c: POSITIVE, g: POSITIVE, gamma: POSITIVE}, where={D: c * g / gamma**2}),
)
def one_root_each(eq30, eq36, claim__principal_branch):
    """h = zeta - 1 + e^(-zeta), zeta = gamma t, rises from 0 to oo after 0, and falls from oo to 0 before it."""
    in_zeta = {t_AB: zeta / gamma}
    height = sp.expand(eq30.rhs.subs(in_zeta) * gamma**2 / g)
    drop = {D: c * g / gamma**2}
    level = sp.expand(eq30.lhs.subs(drop) * gamma**2 / g)
    facts = []
    for side in (POSITIVE, Interval.open(-oo, 0)):
        claim = monotone_on_half_line(height, zeta, side)
        places = ((side.start, "+"), (side.end, "-"))
        ends = [
            Eq(Limit(height, zeta, end, way), elementary_limit(height, zeta, end, way), evaluate=False)
            for end, way in places
        ]
        facts.append(one_root(claim, level, ends=ends))
    root = sp.expand(gamma * eq36.rhs.subs(drop))
    for found, sign in ((root, Gt), (other_branch(root), Lt)):
        facts.append(check_root(Eq(height, level, evaluate=False), zeta, found))
        told = part_of(claim__principal_branch, sign)
        if is_zero(told.lhs - found) is None:
            raise DerivationError(f"{told} is not about {found}")
        facts.append(sign(found, told.rhs, evaluate=False))
    return And(*facts)


if __name__ == "__main__":
    tell_chapter(chapter.name)
