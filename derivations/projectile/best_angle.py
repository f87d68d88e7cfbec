"""A closed form for the maximum range angle: Theorem 3, both cases, from dR/dtheta = 0."""

import sympy as sp
from galileo_sym.derivations.projectile.notation import (
    BETWEEN,
    BEYOND,
    SHOT,
    SLOPE,
    TRIAL_Y,
    U_OF_THETA,
    StationaryAngle,
    U,
    W_u,
    Y,
    a,
    a_3,
    alpha,
    b,
    b_3,
    c,
    c_3,
    d,
    d_3,
    g,
    k,
    notation,
    q,
    s,
    t,
    tau,
    theta,
    theta_max,
    u,
    v,
    w,
)  # fmt: skip
from sympy import (
    And,
    Derivative,
    Eq,
    Equivalent,
    Ge,
    Gt,
    Interval,
    LambertW,
    Lt,
    Ne,
    Piecewise,
    asin,
    cos,
    exp,
    sin,
    tan,
)

from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    Independent,
    UniqueMaximum,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    check_root,
    compare_on,
    isolate,
    other_branch,
    read_coefficients,
    sign_by_ladder,
    simplify_inside,
)  # fmt: skip

chapter = Chapter("projectile.best_angle", notation, "A closed form for the maximum range angle")

E1 = exp(1)
W_a = LambertW((alpha**2 - 1) / E1)
BEST = StationaryAngle(alpha)
U_AT_BEST = -1 - alpha * sin(BEST)
AT_BEST = {
    **TRIAL_Y,
    theta_max: BEST,
    u: U_AT_BEST,
    tau: 1 / (alpha**2 - 1 - U_AT_BEST),
}
BELOW_1, ABOVE_1 = Interval.open(0, 1), Interval.open(1, sp.oo)
CASES = sp.Union(BELOW_1, sp.FiniteSet(1), ABOVE_1, evaluate=False)
NOT_1 = sp.Union(BELOW_1, ABOVE_1, evaluate=False)
ALL_CASES = Domain({alpha: CASES}, where=AT_BEST)
CASE_1 = Domain({alpha: sp.FiniteSet(1)}, where=AT_BEST)
CASE_2 = Domain({alpha: NOT_1}, where=AT_BEST)

chapter.given(
    "projectile.def.alpha",
    Eq(alpha, k * v / g),
    Domain(SHOT),
    erratum=Erratum(("S11",), "alpha = k v/g, not k v/e (nor k v/rho, below figure 6)", Eq(alpha, k * v / E1)),
)


def _sine(def_u, def_alpha):
    """sin(theta) in terms of u and alpha, from the definitions of both."""
    resistance = isolate(def_alpha.equation, k).rhs
    return sp.cancel(isolate(def_u.equation, sin(theta)).rhs.subs(k, resistance))


def _condition(stationary):
    """The equation tan^2 + dy/du = 0 of Theorem 2."""
    same = next(e for e in stationary.parts if isinstance(e, Equivalent))
    return next(e for e in same.args if e.has(tan))


U_OF_ALPHA = -1 - alpha * sin(theta)
Y_OF_ALPHA = LambertW(U_OF_ALPHA * exp(U_OF_ALPHA))
FACTOR_OF_ALPHA = tan(theta) ** 2 + (U_OF_ALPHA + 1) * Y_OF_ALPHA / ((Y_OF_ALPHA + 1) * U_OF_ALPHA)


@chapter.derive(
    "projectile.thm3.only-alpha",
    And(
        Eq(tan(theta) ** 2 + SLOPE, FACTOR_OF_ALPHA),
        Independent(FACTOR_OF_ALPHA, v),
        Independent(FACTOR_OF_ALPHA, g),
        Independent(FACTOR_OF_ALPHA, k),
    ),
    Domain(
        {g: POSITIVE, v: POSITIVE, alpha: POSITIVE, theta: BETWEEN}, where={**TRIAL_Y, u: U_OF_THETA, k: alpha * g / v}
    ),
)
def only_alpha(thm2__stationary, lemma__b, def__uyR, def__alpha):
    """Where tan^2 + dy/du vanishes, k, v and g enter through u alone, and there through alpha."""
    factor = _condition(thm2__stationary).lhs
    resistance = isolate(def__alpha.equation, k).rhs
    named = sp.cancel(def__uyR.of(U(k, theta)).subs(k, resistance))
    explicit = factor.subs(SLOPE, lemma__b.of(SLOPE)).subs(Y, def__uyR.of(Y)).subs(u, named)
    if explicit.has(v, g, k):
        raise DerivationError(f"{explicit} depends on more than alpha and theta")
    return And(Eq(factor, explicit), *(Independent(explicit, parameter) for parameter in (v, g, k)))


@chapter.derive(
    "projectile.thm3.stationary",
    Eq(sin(theta_max) ** 2 / cos(theta_max) ** 2 + SLOPE, 0),
    ALL_CASES,
)
def stationary(thm2__stationary):
    """Theorem 2 at theta_max, with the tangent written out."""
    condition = _condition(thm2__stationary).subs(theta, theta_max)
    return condition.subs(tan(theta_max), sin(theta_max) / cos(theta_max))


def _in_sine(equation, square):
    """A condition on sin^2 and cos^2 of theta_max as one on sin^2."""
    return equation.subs(cos(theta_max) ** 2, 1 - square).subs(sin(theta_max) ** 2, square)


@chapter.derive("projectile.support.y-of-u-at-max", Eq(Y, -u * (u + 1) / (alpha**2 - 1 - u)), ALL_CASES)
def y_at_best_angle(thm3__stationary, lemma__b, def__u, def__alpha):
    """Put sin = -(u + 1)/alpha and (b) in, and solve for y."""
    sine = step("the sine in terms of u", Eq(sin(theta_max), _sine(def__u, def__alpha)))
    condition = _in_sine(thm3__stationary.equation, sine.rhs**2)
    condition = step("stationarity in u and y", condition.subs(SLOPE, lemma__b.of(SLOPE)))
    height = sp.Dummy("y", real=True)
    found = isolate(condition.subs(Y, height), height)
    return Eq(Y, sp.factor(found.rhs), evaluate=False)


@chapter.derive(
    "projectile.thm3.exp-eq",
    Eq(-(u + 1) / (alpha**2 - 1 - u), exp(alpha**2 * u / (alpha**2 - 1 - u))),
    ALL_CASES,
)
def exponential_equation(support__y_of_u_at_max, lemma__b__implicit):
    """y/u = e^(u - y) is y e^y = u e^u divided by u e^y; put y in."""
    both = (sp.powsimp(side / (u * exp(Y))) for side in (lemma__b__implicit.lhs, lemma__b__implicit.rhs))
    ratio = step("divide by u e^y", Eq(*both))
    found = support__y_of_u_at_max.of(Y)
    (power,) = ratio.rhs.atoms(exp)
    return Eq(sp.cancel(ratio.lhs.subs(Y, found)), exp(sp.cancel(power.args[0].subs(Y, found))), evaluate=False)


@chapter.derive(
    "projectile.thm3.case1.u",
    And(Eq((u + 1) / u, exp(-1)), Eq(u, -E1 / (E1 - 1))),
    CASE_1,
    erratum=Erratum(("S13",), "u = -e/(e - 1): the fraction bar is lost in -e/e^-1", Eq(u, -E1 / E1**-1), CASE_1),
)
def case_1(thm3__exp_eq):
    """With alpha = 1 the exponent is -1, and the equation is linear in u."""
    at_1 = thm3__exp_eq.equation.subs(alpha, 1)
    linear = Eq(sp.expand(sp.cancel(at_1.lhs)), sp.simplify(at_1.rhs), evaluate=False)
    return And(linear, isolate(linear, u))


@chapter.derive(
    "projectile.thm3.case1.sin",
    Eq(sin(theta_max), 1 / (E1 - 1)),
    CASE_1,
    erratum=Erratum(("S13",), "1/(e - 1): the fraction bar is lost in 1/e^-1", Eq(sin(theta_max), E1), CASE_1),
)
def sine_1(thm3__case1__u, def__u, def__alpha):
    """sin = -(u + 1)/alpha."""
    sine = _sine(def__u, def__alpha).subs({u: thm3__case1__u.of(u), alpha: 1})
    return Eq(sin(theta_max), sp.simplify(sine), evaluate=False)


@chapter.derive(
    "projectile.thm3.case2.subst",
    And(
        Eq(tau, 1 / (alpha**2 - 1 - u)),
        Eq(u, alpha**2 - 1 - 1 / tau),
        Eq(-(alpha**2 - 1 / tau) * tau, exp(alpha**2 * (alpha**2 - 1 - 1 / tau) * tau)),
    ),
    CASE_2,
)
def substitution(thm3__exp_eq):
    """Name the reciprocal of the denominator tau (the paper's t)."""
    under = sp.denom(sp.together(thm3__exp_eq.lhs))
    sign = -1 if sp.Poly(under, u).LC().is_positive else 1
    named = Eq(tau, 1 / sp.expand(sign * under), evaluate=False)
    back = isolate(named, u)
    left = sp.cancel(thm3__exp_eq.lhs.subs(u, back.rhs))
    (power,) = thm3__exp_eq.rhs.atoms(exp)
    return And(named, back, Eq(left, exp(sp.cancel(power.args[0].subs(u, back.rhs))), evaluate=False))


@chapter.derive(
    "projectile.thm3.case2.t-eq",
    Eq(alpha**2 * tau - 1 + exp(alpha**2 * (alpha**2 - 1) * tau - alpha**2), 0),
    CASE_2,
)
def linear_exponential(thm3__case2__subst):
    """Bring everything to one side."""
    equation = next(e for e in thm3__case2__subst.parts if e.has(exp))
    return Eq(sp.expand(equation.rhs - equation.lhs, power_exp=False), 0, evaluate=False)


COEFFICIENTS = {"a": a_3, "b": b_3, "c": c_3, "d": d_3}


@chapter.derive(
    "projectile.thm3.case2.abcd",
    And(Eq(a_3, alpha**2), Eq(b_3, -1), Eq(c_3, exp(-(alpha**2))), Eq(d_3, alpha**2 * (alpha**2 - 1))),
    CASE_2,
)
def coefficients(thm3__case2__t_eq):
    """The form of result (3)."""
    found = read_coefficients(thm3__case2__t_eq.equation, tau)
    return And(*(Eq(COEFFICIENTS[name], value) for name, value in found.items()))


def _identity(claim, z):
    """W(z e^z) = z, and by how much z must be above the least value of W."""
    same = next(e for e in claim.statement.args if isinstance(e, Eq))
    above = next(e for e in claim.statement.args if isinstance(e, Ge))
    return Eq(same.lhs.subs(w, z), same.rhs.subs(w, z), evaluate=False), (above.lhs - above.rhs).subs(w, z)


@chapter.derive(
    "projectile.thm3.case2.t",
    Eq(tau, 1 / alpha**2 - W_a / (alpha**2 * (alpha**2 - 1))),
    CASE_2,
    erratum=Erratum(
        ("S12",),
        "for 0 < alpha < 1 the equation has a second real root, by W_{-1}, which the proof does not reject",
    ),
)
def solve_for_tau(thm3__case2__abcd, thm3__case2__t_eq, thm3__case2__subst, res3, claim__W_identity):
    """Result (3). Its z = -d (tau + b/a) is above -1 because u < -1, which singles out the branch W."""
    put = {name: thm3__case2__abcd.of(of_3) for name, of_3 in zip((a, b, c, d), COEFFICIENTS.values(), strict=True)}
    root = simplify_inside(res3.rhs.subs(put, simultaneous=True))
    check_root(thm3__case2__t_eq.equation, tau, root)
    z = (-d * (tau + b / a)).subs(put, simultaneous=True)
    in_u = sp.factor(sp.cancel(z.subs(tau, thm3__case2__subst.of(tau))))
    same, height = _identity(claim__W_identity, in_u)
    if not isinstance(step("z is above -1", compare_on(height, sp.S.Zero, {u: BEYOND})), Gt):
        raise DerivationError(f"{in_u} is not a value of W")
    step("so that W(z e^z) is z", same)
    return Eq(tau, root, evaluate=False)


@chapter.derive(
    "projectile.support.branch-thm3",
    Lt(alpha * other_branch(W_a) / (alpha**2 - 1 - other_branch(W_a)), 0),
    Domain({alpha: BELOW_1}),
)
def reject_other_branch(thm3__case2__t, thm3__case2__subst, def__u, def__alpha, def__W, def__T):
    """The root by W_{-1} has the sine alpha/(e^(1 + w) - 1) with w < -1, which is negative."""
    other = other_branch(thm3__case2__t.rhs)
    (inverse,) = other.atoms(LambertW)
    sine = _sine(def__u, def__alpha).subs(u, thm3__case2__subst.of(u)).subs(tau, other)
    in_w = sp.cancel(sine.subs(inverse, w))
    round_trip = next(e for e in def__W.parts if isinstance(e, Eq) and e.lhs.args == (LambertW(q, -1),))
    product = Eq(def__T.of(round_trip.lhs.func(w)), inverse.args[0], evaluate=False)
    square = sp.Dummy("square", positive=True)
    in_w_alone = isolate(product.subs(alpha, sp.sqrt(square)), square).rhs
    elementary = sp.simplify(in_w.subs(alpha**2, in_w_alone) / alpha)
    top = next(e.rhs for e in def__W.parts if isinstance(e, sp.Le) and e.lhs == LambertW(q, -1))
    below = sp.Dummy("h", positive=True)
    if sign_by_ladder(elementary.subs(w, top - below), below) > 0:
        raise DerivationError(f"the sine {alpha * elementary} is positive")
    step("the sine in terms of w", Eq(in_w.subs(w, inverse), (alpha * elementary).subs(w, inverse)))
    return Lt(in_w.subs(w, inverse), 0, evaluate=False)


@chapter.derive("projectile.thm3.case2.sin", Eq(sin(theta_max), alpha * W_a / (alpha**2 - 1 - W_a)), CASE_2)
def sine_2(thm3__case2__t, thm3__case2__subst, def__u, def__alpha):
    """Back from tau to u and to the sine."""
    at = step("u at the best angle", Eq(u, thm3__case2__subst.of(u).subs(tau, thm3__case2__t.of(tau))))
    return Eq(sin(theta_max), sp.cancel(_sine(def__u, def__alpha).subs(u, at.rhs)), evaluate=False)


@chapter.derive(
    "projectile.thm3",
    Eq(
        theta_max,
        Piecewise((asin(alpha * W_a / (alpha**2 - 1 - W_a)), Ne(alpha, 1)), (asin(1 / (E1 - 1)), True)),
    ),
    ALL_CASES,
    erratum=Erratum(
        ("S12",),
        "for alpha > 0, and W the branch W_0: for 0 < alpha < 1 the root by W_{-1} has a negative sine",
    ),
)
def theorem_3(thm3__case1__sin, thm3__case2__sin, thm2__b, support__branch_thm3):
    """theta_max is between 0 and pi/2, where the sine has an inverse; a negative sine is not one of it."""
    largest = next(e for e in thm2__b.parts if isinstance(e, UniqueMaximum))
    _, _, whole, place = largest.args
    if not whole.is_subset(Interval(0, sp.pi / 2)):
        raise DerivationError(f"the sine has no inverse on {whole}")
    rejected = support__branch_thm3.statement
    if not isinstance(rejected, Lt) or is_zero(rejected.lhs - other_branch(thm3__case2__sin.rhs)) is None:
        raise DerivationError(f"{rejected} does not reject the root by W_{{-1}}")
    step("the root by W_{-1}, for alpha < 1", sp.Implies(Lt(alpha, 1), rejected))
    cases = [thm3__case2__sin, thm3__case1__sin]
    for case, told in zip(cases, ("alpha is not 1", "alpha is 1"), strict=True):
        when = Ne(alpha, 1) if case is cases[0] else Eq(alpha, 1)
        step(f"the sine if {told}", sp.Implies(when, case.equation))
    general, special = (asin(case.of(sin(theta_max))) for case in cases)
    return Eq(place, Piecewise((general, Ne(alpha, 1)), (special, True)), evaluate=False)


@chapter.derive("projectile.support.unified-thm3", Eq(sin(theta_max), alpha / (exp(1 + W_a) - 1)), ALL_CASES)
def unified(thm3, res1):
    """alpha^2 - 1 = e W e^W by (1); at alpha = 1, where W = 0, the formula gives case 1 too."""
    (general, _), (special, _) = thm3.of(theta_max).args
    (inverse,) = general.atoms(LambertW)
    by_1 = res1.subs(q, inverse.args[0]).subs(inverse, w)
    square = sp.Dummy("square", positive=True)
    in_w = isolate(by_1.subs(alpha, sp.sqrt(square)), square).rhs
    step("alpha^2 by (1)", Eq(alpha**2, in_w.subs(w, inverse)))
    sine = sp.simplify(sin(general).subs(inverse, w).subs(alpha**2, in_w)).subs(w, inverse)
    if is_zero(sine.subs(alpha, 1) - sin(special)) is None:
        raise DerivationError(f"{sine} is not {sin(special)} at alpha = 1")
    return Eq(sin(theta_max), sine, evaluate=False)


@chapter.derive(
    "projectile.support.kT-at-max",
    And(
        Eq(alpha**2, 1 + (s - 1) * exp(s)),
        Eq(sin(theta_max), alpha / (exp(s) - 1)),
        Eq(s, 1 + W_a),
        Eq(k * t, 1 + W_a),
    ),
    Domain(
        {k: POSITIVE, alpha: CASES},
        where={**AT_BEST, s: (W_u - u).subs(u, U_AT_BEST), t: (W_u - u).subs(u, U_AT_BEST) / k},
    ),
)
def time_at_best_angle(support__s_param, thm3__stationary, claim__W_identity, def__u, def__alpha):
    """In s = k t everything is elementary; s > 0 selects the branch W, without result (3)."""
    u_of_s = support__s_param.of(u)
    slope = support__s_param.of(Derivative(W_u, u))
    square = sp.Dummy("square", positive=True)
    sine_2 = isolate(_in_sine(thm3__stationary.subs(SLOPE, slope), square), square).rhs
    height = _sine(def__u, def__alpha).subs(u, u_of_s) * alpha
    squared = step("alpha against s", Eq(alpha**2, sp.expand(sp.simplify(height**2 / sine_2)), evaluate=False))
    sine = Eq(sin(theta_max), alpha * sp.simplify(sine_2 / height), evaluate=False)
    same, above = _identity(claim__W_identity, s - 1)
    in_s, in_alpha = ((side - 1) * exp(-1) for side in (squared.rhs, squared.lhs))
    if is_zero(same.lhs.args[0] - in_s) is None or not above.is_positive:
        raise DerivationError(f"{same} does not invert {in_s}")
    found = isolate(Eq(LambertW(in_alpha), same.rhs, evaluate=False), s)
    name = next(e for e in support__s_param.parts if e.lhs == s and e.rhs.has(t))
    return And(squared, sine, found, Eq(name.rhs, found.rhs, evaluate=False))


if __name__ == "__main__":
    tell_chapter(chapter.name)
