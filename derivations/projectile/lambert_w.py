"""The Lambert W function: results (1), (2) and (3)."""

import sympy as sp
from sympy import And, Eq, Equivalent, Ge, Gt, Interval, LambertW, Le, Lt, Ne, exp

from galileo_sym.derivations.projectile.notation import T, a, b, c, d, notation, q, t, w
from galileo_sym.ledger import (
    REAL,
    Chapter,
    Domain,
    Erratum,
    StrictlyDecreasing,
    StrictlyIncreasing,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.tactics import (
    above_end,
    check_root,
    implicit_derivative,
    isolate,
    least_value,
    monotone_on_half_line,
    other_branch,
    require_real,
    root_of_product,
    undo,
)  # fmt: skip

chapter = Chapter("projectile.lambert_w", notation, "The Lambert W function")

BRANCH_POINT = -exp(-1)
ANY_W = Domain({w: REAL})
ARGUMENT = Interval(BRANCH_POINT, sp.oo)
NONZERO = sp.Union(Interval.open(BRANCH_POINT, 0), Interval.open(0, sp.oo), evaluate=False)
REALS_BUT_0 = sp.Union(Interval.open(-sp.oo, 0), Interval.open(0, sp.oo), evaluate=False)
COEFFICIENTS = {a: REALS_BUT_0, b: REAL, d: REALS_BUT_0}

# any t solves the equation with the c that is chosen here
HOLDS_AT_T = Domain({**COEFFICIENTS, t: REAL}, where={c: -(a * t + b) / exp(d * t)})
# any argument q of W belongs to the c that is chosen here
REAL_ROOT = Domain({**COEFFICIENTS, q: ARGUMENT}, where={c: q * a * exp(b * d / a) / d})

chapter.given("projectile.def.T", Eq(T(w), w * exp(w)), ANY_W)


@chapter.derive(
    "projectile.claim.T-monotone",
    And(
        StrictlyDecreasing(w * exp(w), w, Interval(-sp.oo, -1)),
        StrictlyIncreasing(w * exp(w), w, Interval(-1, sp.oo)),
    ),
    ANY_W,
)
def monotone_parts(def__T):
    """T' = (1 + w) e^w has the sign of 1 + w."""
    body = def__T.of(T(w))
    slope = step("slope of T", Eq(sp.Derivative(T(w), w), sp.factor(sp.diff(body, w))))
    turn = isolate(Eq(slope.rhs, 0), w).rhs
    halves = Interval(-sp.oo, turn), Interval(turn, sp.oo)
    return And(*(monotone_on_half_line(body, w, half) for half in halves))


def _halves(monotone):
    """The claims about the falling and about the rising half of T."""
    parts = {type(claim): claim for claim in monotone.parts}
    return parts[StrictlyDecreasing], parts[StrictlyIncreasing]


chapter.given(
    "projectile.def.W",
    And(
        Eq(T(LambertW(q)), q),
        Ge(LambertW(q), -1),
        Eq(T(LambertW(q, -1)), q),
        Le(LambertW(q, -1), -1),
    ),
    Domain({q: Interval.Ropen(BRANCH_POINT, 0)}),
    premises=("projectile.claim.T-monotone",),
    erratum=Erratum(("S18",), "Corless et al. is reference [3] of the list, not [2]"),
)


def _branch(definition, power, branch):
    """What the definitions of W and T say of a branch: Eq(W(q)*exp(W(q)), q), and where W takes its values."""
    round_trip = next(e for e in definition.parts if isinstance(e, Eq) and e.lhs == T(branch))
    values = next(e for e in definition.parts if isinstance(e, Ge | Le) and e.lhs == branch)
    return Eq(power.of(T(w)).subs(w, branch), round_trip.rhs, evaluate=False), values


@chapter.derive("projectile.claim.domain-W", Ge(w * exp(w), -exp(-1)), ANY_W)
def domain_of_w(claim__T_monotone):
    """T falls up to -1 and rises from there on: it is least at -1."""
    return least_value(*_halves(claim__T_monotone))


@chapter.derive("projectile.res1", Eq(q, LambertW(q) * exp(LambertW(q))), Domain({q: ARGUMENT}))
def result_1(def__W, def__T):
    """W is the inverse of T."""
    round_trip, _ = _branch(def__W, def__T, LambertW(q))
    return round_trip.reversed


@chapter.derive(
    "projectile.res2",
    Eq(sp.Derivative(LambertW(q), q), LambertW(q) / (q * (1 + LambertW(q)))),
    Domain({q: NONZERO}),
    erratum=Erratum(
        ("S1",),
        "for x > -1/e, x != 0: at x = -1/e the denominator x (1 + W) is 0 and W has no derivative",
        And(
            Ne(q * (1 + LambertW(q)), 0),
            Eq(sp.Derivative(LambertW(q), q), LambertW(q) / (q * (1 + LambertW(q)))),
        ),
        Domain({q: sp.FiniteSet(BRANCH_POINT)}),
    ),
)
def result_2(res1, def__W):
    """Differentiate (1) implicitly, and put e^W = x/W in. W is above -1 beyond -1/e, so that T rises with W."""
    inverse = sp.Function("inverse", real=True)(q)
    values = next(e for e in def__W.parts if isinstance(e, Ge) and e.lhs == LambertW(q))
    above = step("above -1", above_end(res1.equation.reversed, values, Gt(q, BRANCH_POINT, evaluate=False)))
    named, bound = (told.subs(LambertW(q), inverse) for told in (res1.equation, above))
    slope = implicit_derivative(named, inverse, q, bound).rhs.subs(inverse, LambertW(q))
    power = sp.Dummy("power", positive=True)
    growth = isolate(res1.subs(exp(LambertW(q)), power), power).rhs
    step("exponential of W", Eq(exp(LambertW(q)), growth, evaluate=False))
    return Eq(sp.Derivative(LambertW(q), q), sp.factor(slope.subs(exp(LambertW(q)), growth)), evaluate=False)


@chapter.derive("projectile.claim.W-identity", Equivalent(Eq(LambertW(w * exp(w)), w), Ge(w, -1)), ANY_W)
def identity(def__W, def__T, claim__T_monotone):
    """W takes the values from -1 on, where T is one-to-one; below -1 the identity cannot hold."""
    round_trip, values = _branch(def__W, def__T, LambertW(q))
    _, rising = _halves(claim__T_monotone)
    return undo(rising, round_trip, values, w)


def _times(equation, factor):
    """Multiply both sides, which are products with one power of e."""
    return Eq(_collected(equation.lhs * factor), _collected(equation.rhs * factor), evaluate=False)


def _collected(product):
    rest, powers = sp.sift(sp.Mul.make_args(product), lambda e: isinstance(e, exp), binary=True)[::-1]
    return sp.expand(sp.Mul(*rest)) * exp(sp.expand(sum(e.args[0] for e in powers)))


@chapter.derive("projectile.res3.step1", Eq((a * t + b) * exp(-d * t), -c), HOLDS_AT_T)
def divide_by_exponential():
    """Multiply the equation by e^(-dt), and bring c to the right."""
    equation = step("the equation to be solved", Eq(a * t + b + c * exp(d * t), 0, evaluate=False))
    divided = sp.collect(sp.expand(equation.lhs * exp(-d * t)), exp(-d * t))
    return Eq(divided - c, -c, evaluate=False)


@chapter.derive("projectile.res3.step2", Eq((-d * t - d * b / a) * exp(-d * t), c * d / a), HOLDS_AT_T)
def scale(res3__step1):
    """Multiply by -d/a."""
    return _times(res3__step1.equation, -d / a)


@chapter.derive(
    "projectile.res3.step3",
    Eq((-d * t - d * b / a) * exp(-d * t - d * b / a), c * d / a * exp(-d * b / a)),
    HOLDS_AT_T,
)
def complete_exponent(res3__step2):
    """Multiply by e^(-db/a): the left side has the form z e^z."""
    return _times(res3__step2.equation, exp(-d * b / a))


@chapter.derive(
    "projectile.res3.step4",
    Eq(-d * t - d * b / a, LambertW(c * d / a * exp(-d * b / a))),
    Domain(REAL_ROOT.ranges, where={**REAL_ROOT.where, t: -b / a - LambertW(q) / d}),
)
def apply_w(res3__step3, res1):
    """z e^z = Q is satisfied if z = W(Q), by (1)."""
    return root_of_product(res3__step3.equation, res1.equation, q)


@chapter.derive(
    "projectile.res3",
    Eq(t, -b / a - LambertW(c * d * exp(-b * d / a) / a) / d),
    REAL_ROOT,
    erratum=Erratum(
        ("S2",),
        "a solution, of possibly two: with Q = c d e^(-bd/a)/a there is one real root (W) for Q >= 0, two (W and "
        "W_{-1}) for -1/e < Q < 0, a double one for Q = -1/e, and none for Q < -1/e",
    ),
)
def result_3(res3__step4, res3__step3, def__W, def__T, claim__T_monotone, claim__domain_W):
    """Solve for t. Every real root has z = W(Q) or z = W_{-1}(Q), as z is above or below -1."""
    found = isolate(res3__step4.equation, t)
    equation = Eq(a * t + b + c * exp(d * t), 0, evaluate=False)
    check_root(equation, t, found.rhs)
    z, argument = res3__step4.lhs, res3__step3.rhs
    least = step("a real root needs", claim__domain_W.subs(w, z).subs(res3__step3.lhs, argument))
    require_real(res3__step4.rhs, least)
    falling, rising = _halves(claim__T_monotone)
    for claim, branch in ((rising, LambertW(q)), (falling, LambertW(q, -1))):
        round_trip, values = _branch(def__W, def__T, branch)
        same = undo(claim, round_trip, values, z)
        step(f"roots by the branch with values {values.rel_op} {values.rhs}", same)
    check_root(equation, t, other_branch(found.rhs), when=And(Ge(argument, BRANCH_POINT), Lt(argument, 0)))
    return found


if __name__ == "__main__":
    tell_chapter(chapter.name)
