"""Result (3) completed: how many real roots a t + b + c e^(d t) = 0 has, and each one by its branch of W."""

import sympy as sp
from sympy import And, Eq, Equivalent, Ge, Gt, Implies, Interval, LambertW, Le, Lt, Or, exp

from galileo_sym.derivations.beyond.notation import notation
from galileo_sym.derivations.projectile.notation import BEYOND, T, W_u, a, b, c, d, k, q, t, u, w
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    REAL,
    Chapter,
    DerivationError,
    Domain,
    StrictlyDecreasing,
    StrictlyIncreasing,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import all_preimages, bound_by_end, isolate, ladder, read_coefficients, same_order

chapter = Chapter("beyond.real_roots", notation, "What the papers leave open: every real root of a t + b + c e^(d t)")

BRANCH_POINT = -exp(-1)
NOT_0 = sp.Union(Interval.open(-sp.oo, 0), Interval.open(0, sp.oo), evaluate=False)
LEFT_SIDE = a * t + b + c * exp(d * t)
BY_W, BY_OTHER = -b / a - LambertW(q) / d, -b / a - LambertW(q, -1) / d
TURN = 1 / d - b / a  # where the slope a + c d e^(d t) vanishes if q = -1/e
TURN_BELOW = -sp.log(-q) / d - b / a  # and for any q < 0
Z = -d * t - d * b / a
Q = c * d / a * exp(-d * b / a)


def equations(values, *roots):
    """All equations with W's argument q in `values`, and all times; the roots are among those that are tried."""
    times = sp.Union(REAL, sp.FiniteSet(*roots), evaluate=False) if roots else REAL
    return Domain({a: NOT_0, b: REAL, d: NOT_0, q: values, t: times}, where={c: q * a * exp(b * d / a) / d})


TWO = Interval.open(BRANCH_POINT, 0)


@chapter.derive(
    "beyond.real-roots.factor", Eq(LEFT_SIDE, -a / d * exp(d * t + d * b / a) * (Z * exp(Z) - Q)), equations(REAL)
)
def factor(res3__step1, res3__step3):
    """Steps 1 to 3 multiply by what is never 0: no root is gained or lost on the way to z e^z = Q."""
    first, last = res3__step1.equation, res3__step3.equation
    left, product = sp.expand((first.lhs - first.rhs) * exp(d * t)), last.lhs - last.rhs
    rest = sp.powsimp(left.coeff(b) / sp.expand(last.lhs).coeff(b))
    if is_zero(left - rest * product) is None:
        raise DerivationError(f"{left} is not a multiple of {product}")
    return Eq(left, rest * product, evaluate=False)


def _product(factored):
    """Eq(z e^z, Q) from the factored equation: its other factor is never 0."""
    (product,) = (e for e in sp.Mul.make_args(factored.rhs) if e.is_Add)
    rest = factored.rhs / product
    if not rest.is_nonzero or is_zero(factored.lhs - factored.rhs) is None:
        raise DerivationError(f"{factored.rhs} may vanish where {product} does not")
    value = -sum(e for e in product.args if not e.has(t))
    step("name the argument of W", Eq(q, value, evaluate=False))
    return Eq(product + value, value, evaluate=False)


def _factor_in_exponent(product):
    """The z of z e^z."""
    return next(e.args[0] for e in sp.Mul.make_args(product) if isinstance(e, exp))


def _halves(monotone):
    """The claims about the falling and about the rising half of T."""
    parts = {type(claim): claim for claim in monotone.parts}
    return parts[StrictlyDecreasing], parts[StrictlyIncreasing]


def _inverse(definition, power, branch):
    """Eq(W(q) e^W(q), q) and where W takes its values, from the definitions of W and T."""
    round_trip = next(e for e in definition.parts if isinstance(e, Eq) and e.lhs == T(branch))
    values = next(e for e in definition.parts if isinstance(e, Ge | Le) and e.lhs == branch)
    return Eq(power.of(T(w)).subs(w, branch), round_trip.rhs, evaluate=False), values


def _in_time(factored, preimages):
    """The solutions of w e^w = q, with w = z, as times."""
    product = _product(factored)
    roots, same = sorted(preimages.args, key=lambda e: e.has(exp))
    z = _factor_in_exponent(product.lhs)
    if is_zero(product.lhs - same.lhs.subs(w, z)) is None:
        raise DerivationError(f"{product.lhs} is not {same.lhs}")
    roots = roots.args if isinstance(roots, Or) else (roots,)
    times = [isolate(Eq(z, root.rhs, evaluate=False), t) for root in roots]
    return Equivalent(Eq(factored.lhs, 0, evaluate=False), Or(*times) if len(times) > 1 else times[0])


@chapter.derive(
    "beyond.real-roots.none", Lt(a * d * LEFT_SIDE, 0), equations(Interval.open(-sp.oo, BRANCH_POINT), TURN_BELOW)
)
def none(beyond__real_roots__factor, claim__domain_W):
    """z e^z is never below -1/e, and Q is: the left side keeps the sign of -a d, even where it comes nearest to 0."""
    factored = beyond__real_roots__factor.equation
    product = _product(factored)
    least = claim__domain_W.statement
    z = _factor_in_exponent(product.lhs)
    if not isinstance(least, Ge) or is_zero(least.lhs.subs(w, z) - product.lhs) is None or least.rhs != BRANCH_POINT:
        raise DerivationError(f"{least} does not bound {product.lhs}")
    above = step("too high", Gt(least.lhs.subs(w, z), q, evaluate=False))
    excess, rest = sp.Dummy("excess", positive=True), factored.rhs / (product.lhs - product.rhs)
    sign = (a * d * rest * excess).is_positive, (a * d * rest * excess).is_negative
    if not any(sign) or is_zero(factored.rhs - rest * (above.lhs - product.rhs)) is None:
        raise DerivationError(f"the sign of {rest} is not that of a d, nor of -a d")
    return (Gt if sign[0] else Lt)(a * d * factored.lhs, 0, evaluate=False)


@chapter.derive(
    "beyond.real-roots.two",
    Equivalent(Eq(LEFT_SIDE, 0), Or(Eq(t, BY_W), Eq(t, BY_OTHER))),
    equations(TWO, BY_W, BY_OTHER),
)
def two(beyond__real_roots__factor, def__W, def__T, claim__T_monotone):
    """z >= -1 belongs to W, z <= -1 to W_{-1}: T is one-to-one on each side."""
    falling, rising = _halves(claim__T_monotone)
    inverses = [
        (half, *_inverse(def__W, def__T, branch))
        for half, branch in ((rising, LambertW(q)), (falling, LambertW(q, -1)))
    ]
    return _in_time(beyond__real_roots__factor.equation, all_preimages(inverses, w))


@chapter.derive("beyond.real-roots.one", Equivalent(Eq(LEFT_SIDE, 0), Eq(t, BY_W)), equations(NONNEGATIVE, BY_W))
def one(beyond__real_roots__factor, res1, def__W, claim__T_monotone):
    """z e^z < 0 <= Q for z < 0, so the root is the one by W."""
    falling, rising = _halves(claim__T_monotone)
    below = sp.Dummy("below", positive=True)
    function, place = falling.args[0], falling.args[2].end - below
    negative = ladder(-function.subs(w, place), below)
    never = Lt(-negative.lhs.subs(below, falling.args[2].end - w), q, evaluate=False)
    step("no root where z < -1", Implies(Lt(Z, falling.args[2].end, evaluate=False), never.subs(w, Z)))
    values = next(e for e in def__W.parts if isinstance(e, Ge) and e.lhs == LambertW(q))
    inverses = [(rising, res1.equation.reversed, values)]
    found = all_preimages(inverses, w, never=[(Interval.open(falling.args[2].start, falling.args[2].end), never)])
    return _in_time(beyond__real_roots__factor.equation, found)


@chapter.derive(
    "beyond.real-roots.double",
    And(
        Equivalent(Eq(LEFT_SIDE, 0), Eq(t, TURN)),
        Eq(a + c * d * exp(1 - b * d / a), 0),
        Eq(c * d**2 * exp(1 - b * d / a), -a * d),
    ),
    equations(sp.FiniteSet(BRANCH_POINT), TURN),
)
def double(beyond__real_roots__two, beyond__real_roots__factor):
    """Both branches give -1 at -1/e; the slope vanishes there, and the curvature is -a d, not 0."""
    value = _product(beyond__real_roots__factor.equation).rhs
    condition, roots = sorted(beyond__real_roots__two.statement.args, key=lambda e: e.has(LambertW))
    if not isinstance(roots, Or):
        raise DerivationError(f"{roots} is not a list of roots")
    merged = {isolate(e.subs(q, BRANCH_POINT), t) for e in roots.args}
    if len(merged) != 1:
        raise DerivationError(f"the roots {merged} do not fall together")
    (root,) = merged
    left = condition.lhs
    held = isolate(Eq(value, BRANCH_POINT, evaluate=False), c).rhs
    slopes = [sp.diff(left, t, order).subs(t, root.rhs) for order in (1, 2)]
    values = [sp.simplify(s.subs(c, held)) for s in slopes]
    return And(Equivalent(condition, root), *(Eq(s, v, evaluate=False) for s, v in zip(slopes, values, strict=True)))


@chapter.derive("beyond.real-roots.order", Gt(d * (BY_OTHER - BY_W), 0), equations(TWO))
def order(beyond__real_roots__two, def__W, def__T, claim__T_monotone):
    """W > -1 > W_{-1} above -1/e: for d < 0, as in flight, the root by W is the later one."""
    bounds = []
    for half, branch in zip(_halves(claim__T_monotone), (LambertW(q, -1), LambertW(q)), strict=True):
        round_trip, values = _inverse(def__W, def__T, branch)
        end = values.rhs
        inside = {branch: Interval(end, sp.oo) if isinstance(values, Ge) else Interval(-sp.oo, end)}
        if is_zero(round_trip.lhs - half.args[0].subs(w, branch)) is None or round_trip.rhs != q:
            raise DerivationError(f"{round_trip} does not say that {branch} is the inverse of T")
        places = (end, branch) if isinstance(values, Ge) else (branch, end)
        told, strict = sorted(same_order(half, *places, inside=inside).args, key=lambda e: e.has(exp), reverse=True)
        step("value above -1/e", told)
        bounds.append(strict)
    high, low = sp.Dummy("high", positive=True), sp.Dummy("low", negative=True)
    names = {bounds[1].gts: bounds[1].lts + high, bounds[0].lts: bounds[0].gts + low}
    roots = next(e for e in beyond__real_roots__two.statement.args if isinstance(e, Or)).args
    by_w = next(e.rhs for e in roots if e.rhs.has(bounds[1].gts))
    by_other = next(e.rhs for e in roots if e.rhs.has(bounds[0].lts))
    apart = d * (by_other - by_w)
    if not sp.expand(apart).subs(names).is_positive:
        raise DerivationError(f"the order of {by_w} and {by_other} is open")
    return Gt(apart, 0, evaluate=False)


FLIGHT = -k * t - u + u * exp(-k * t)
LANDING = (-u + W_u) / k


@chapter.derive(
    "beyond.real-roots.impact",
    And(Equivalent(Eq(FLIGHT, 0), Or(Eq(t, 0), Eq(t, LANDING))), Gt(LANDING, 0)),
    Domain({k: POSITIVE, u: BEYOND, t: sp.Union(REAL, sp.FiniteSet(0, LANDING), evaluate=False)}),
)
def impact(impact__eq_u, beyond__real_roots__two, claim__trivial_root, claim__T_monotone, def__W):
    """For u < -1 the argument u e^u is between -1/e and 0: launch by W_{-1}, landing by W, nothing else."""
    equation = impact__eq_u.equation
    names = dict(zip((a, b, c, d), (v for _, v in read_coefficients(equation, t).items()), strict=True))
    falling, _ = _halves(claim__T_monotone)
    argument = falling.args[0].subs(w, u)
    if is_zero(Q.subs(names, simultaneous=True) - argument) is None or not argument.is_negative:
        raise DerivationError(f"the argument of W is not {argument}, or not negative")
    step("above -1/e", bound_by_end(falling, u, Lt(u, -1, evaluate=False)))
    step("below 0", Lt(argument, 0, evaluate=False))
    roots = next(e for e in beyond__real_roots__two.statement.args if isinstance(e, Or))
    launch = next(e for e in claim__trivial_root.parts if e.rhs == u)
    times = [
        Eq(t, sp.expand(e.rhs.subs({**names, q: argument}, simultaneous=True).subs(launch.lhs, launch.rhs)))
        for e in roots.args
    ]
    landing = next(e for e in times if e.has(LambertW))
    bound = next(e for e in def__W.parts if isinstance(e, Ge) and e.lhs == LambertW(q))
    beyond = sp.Dummy("beyond", positive=True)
    least = landing.rhs.subs(W_u, bound.rhs).subs(u, -1 - beyond)
    if not (sp.simplify(least).is_positive and sp.diff(landing.rhs.subs(W_u, w), w).is_positive):
        raise DerivationError(f"{landing} is not shown to be after the launch")
    return And(Equivalent(Eq(equation.lhs, 0, evaluate=False), Or(*times)), Gt(landing.rhs, 0, evaluate=False))


if __name__ == "__main__":
    tell_chapter(chapter.name)
