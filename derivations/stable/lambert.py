"""Stable forms of W and of the roots (3): W near its branch point, its logarithm elsewhere; W never meets exp."""

import sympy as sp
from sympy import E, Eq, Ge, Gt, Interval, LambertW, Le, Tuple, exp, log, sqrt

from galileo_sym.derivations.projectile.notation import T, a, b, c, d, notation, q, t, w
from galileo_sym.ledger import POSITIVE, REAL, Chapter, DerivationError, Domain, step, tell_chapter
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.primitives import branch_factor, phi1, w0_offset, wm1_offset
from galileo_sym.tactics import introduce

chapter = Chapter("stable.lambert", notation, "stable forms (not printed)")

BRANCH_POINT = -exp(-1)
NOT_0 = sp.Union(Interval.open(-sp.oo, 0), Interval.open(0, sp.oo), evaluate=False)
BETA, KAPPA = b * d / a, c * d / a
DISTANCE = BETA - 1 - log(-KAPPA)
BY_W, BY_OTHER = -b / a - LambertW(q) / d, -b / a - LambertW(q, -1) / d


def equations(values, **more):
    """All equations with W's argument q in `values`."""
    return Domain({a: NOT_0, b: REAL, d: NOT_0, q: values, **more}, where={c: q * a * exp(b * d / a) / d})


@chapter.derive(
    "stable.lambert.w0",
    Eq(LambertW(q), q * branch_factor(sqrt(2 * (1 + E * q)))),
    Domain({q: Interval(BRANCH_POINT, sp.oo)}),
)
def principal_branch(res1):
    """W = x/e^W, and e^(-W) is regular in sqrt(2 (1 + e x)), at the branch point as at 0."""
    equation = res1.equation
    rest = equation.rhs / exp(LambertW(q))
    if rest.has(exp):
        raise DerivationError(f"{equation} does not have W e^W on one side")
    factor = branch_factor(sqrt(2 * (1 + E * q)))
    closed = factor.rewrite(LambertW)
    shrunk = next(iter(closed.atoms(LambertW)))
    if is_zero(shrunk.args[0] - q) is None or closed != exp(-shrunk):
        raise DerivationError(f"{factor} is not exp(-W)")
    step("W over e^(-W)", Eq(rest, equation.lhs * exp(-LambertW(q)), evaluate=False))
    return Eq(LambertW(q), LambertW(q) / rest * equation.lhs * factor)


@chapter.derive("stable.lambert.w0.large", Eq(LambertW(q) + log(LambertW(q)), log(q)), Domain({q: POSITIVE}))
def principal_branch_by_log(res1):
    """The logarithm of (1): both factors are positive for x > 0."""
    size = sp.Dummy("size", positive=True)
    product = res1.equation.rhs.subs(LambertW(q), size)
    return Eq(sp.expand_log(log(product)).subs(size, LambertW(q)), log(res1.equation.lhs))


def _inverse(definition, power, branch):
    """The product that is q, and where W takes its values, from the definitions of W and T."""
    round_trip = next(e for e in definition.parts if isinstance(e, Eq) and e.lhs == T(branch))
    values = next(e for e in definition.parts if isinstance(e, Ge | Le) and e.lhs == branch)
    return power.of(T(w)), round_trip.rhs, values


@chapter.derive(
    "stable.lambert.wm1",
    Eq(LambertW(q, -1), -1 + wm1_offset(-1 - log(-q))),
    Domain({q: Interval.Ropen(BRANCH_POINT, 0)}),
)
def lower_branch(def__W, def__T):
    """The logarithm of -x = -W e^W at W = -1 - s: s - log(1 + s) = -1 - log(-x)."""
    product, argument, values = _inverse(def__W, def__T, LambertW(q, -1))
    if not isinstance(values, Le) or values.rhs != -1:
        raise DerivationError(f"{values} does not bound W_(-1) from above by -1")
    below = sp.Dummy("s", nonnegative=True)
    lag = -1 - sp.expand_log(log(-product.subs(w, -1 - below)))
    if is_zero(lag - (below - log(1 + below))) is None:
        raise DerivationError(f"{lag} is not what the offset solves")
    distance = -1 - log(-argument)
    return Eq(LambertW(q, -1), sp.expand(introduce(LambertW(argument, -1), wm1_offset(distance))))


def _argument(factored):
    """Q of z e^z = Q, from the factored equation, as its factor in front of a power of e and the exponent."""
    (product,) = (e for e in sp.Mul.make_args(factored.rhs) if e.is_Add)
    if is_zero(factored.lhs - factored.rhs) is None:
        raise DerivationError(f"{factored} does not hold")
    value = -sum(e for e in product.args if not e.has(t))
    (power,) = (e for e in sp.Mul.make_args(value) if isinstance(e, exp))
    step("argument of W", Eq(q, value, evaluate=False))
    return value / power, power.args[0]


@chapter.derive(
    "stable.lambert.linear_exponential_roots",
    Eq(Tuple(BY_W, BY_OTHER), Tuple((1 - BETA - w0_offset(DISTANCE)) / d, (1 - BETA - wm1_offset(DISTANCE)) / d)),
    equations(Interval.open(BRANCH_POINT, 0)),
)
def two_roots(beyond__real_roots__two, beyond__real_roots__factor):
    """For Q < 0 the offsets of W at -1 - log(-Q) = b d/a - 1 - log(-c d/a), in which Q is never formed."""
    front, exponent = _argument(beyond__real_roots__factor.equation)
    distance = -1 - (log(-front) + exponent)
    step("distance", Eq(-1 - log(-q), distance, evaluate=False))
    roots = next(e for e in beyond__real_roots__two.statement.args if isinstance(e, sp.Or)).args
    by_w, by_other = (next(e.rhs for e in roots if e.rhs.has(x)) for x in (LambertW(q), LambertW(q, -1)))
    forms = [
        introduce(root, offset(-1 - log(-q))).subs(log(-q), -1 - distance)
        for root, offset in ((by_w, w0_offset), (by_other, wm1_offset))
    ]
    return Eq(Tuple(by_w, by_other), Tuple(*forms))


@chapter.derive(
    "stable.lambert.linear_exponential_roots.large",
    Eq(BY_W, log(LambertW(q) / KAPPA) / d),
    equations(POSITIVE),
)
def root_of_large_w(beyond__real_roots__one, beyond__real_roots__factor, res1):
    """W e^W = Q is e^(-W - b d/a) = W/(c d/a): a logarithm, where -b d/a - W would cancel."""
    front, exponent = _argument(beyond__real_roots__factor.equation)
    root = next(e for e in beyond__real_roots__one.statement.args if e.lhs == t).rhs
    shrunk = res1.equation.rhs / exp(LambertW(q))
    if shrunk.has(exp) or res1.equation.lhs != q:
        raise DerivationError(f"{res1.statement} does not have W e^W on one side")
    ratio = shrunk / front
    step("power of e", Eq(exp(exponent - LambertW(q)), ratio, evaluate=False))
    if is_zero(sp.expand(d * root) - (exponent - LambertW(q))) is None:
        raise DerivationError(f"{root} is not the root with W")
    return Eq(root, log(ratio) / d)


@chapter.derive(
    "stable.lambert.linear_exponential_roots.residual",
    Eq((a * t + b + c * exp(d * t)) * d / a, (b + c) * d / a + d * t + KAPPA * d * t * phi1(d * t)),
    Domain({a: NOT_0, b: REAL, c: REAL, d: NOT_0, t: NOT_0}),
)
def residual(beyond__real_roots__factor):
    """What Newton's steps drive to 0: for small d t nothing is left of the large terms that b + c cancels."""
    factored = beyond__real_roots__factor.equation
    scaled = sp.expand(sp.powsimp(sp.expand(factored.rhs * d / a)))
    return Eq(factored.lhs * d / a, introduce(scaled, phi1(d * t), closed=exp))


@chapter.derive(
    "stable.lambert.linear_exponential_roots.exists",
    sp.Equivalent(Ge(q, BRANCH_POINT), Ge(DISTANCE, 0)),
    equations(Interval.open(-sp.oo, 0)),
)
def existence(beyond__real_roots__factor, claim__domain_W):
    """The logarithm rises: -Q <= 1/e, where z e^z = Q has a root, is log(-Q) <= -1."""
    front, exponent = _argument(beyond__real_roots__factor.equation)
    least = claim__domain_W.statement
    if not (isinstance(least, Ge) and least.lhs == w * exp(w)):
        raise DerivationError(f"{least} does not bound w e^w")
    height = sp.expand_log(log(-least.rhs))
    step("a root needs", Gt(exp(height), 0, evaluate=False))
    return sp.Equivalent(Ge(q, least.rhs), Ge(height - (log(-front) + exponent), 0, evaluate=False))


if __name__ == "__main__":
    tell_chapter(chapter.name)
