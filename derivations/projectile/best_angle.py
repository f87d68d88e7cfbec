"""A closed form for the maximum range angle: Theorem 3, both cases."""

import sympy as sp
from sympy import (
    And,
    Eq,
    Gt,
    Interval,
    LambertW,
    Lt,
    Ne,
    Piecewise,
    asin,
    exp,
    sin,
)

from galileo_sym.derivations.projectile.notation import (
    BEYOND,
    a,
    a_3,
    alpha,
    b,
    b_3,
    c,
    c_3,
    d,
    d_3,
    notation,
    q,
    tau,
    theta_max,
    u,
    w,
)  # fmt: skip
from galileo_sym.derivations.projectile.shared import (
    ALL_CASES,
    BELOW_1,
    CASE_1,
    CASE_2,
    E1,
    W_a,
    identity_at,
    lead_positive,
    sine_of_u,
    tidy_exponents,
)
from galileo_sym.ledger import (
    Chapter,
    DerivationError,
    Domain,
    Erratum,
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

chapter = Chapter("projectile.best_angle", notation, "A closed form for the maximum range angle: Theorem 3")


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
    sine = sine_of_u(def__u, def__alpha).subs({u: thm3__case1__u.of(u), alpha: 1})
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
    return And(named, back, Eq(left, tidy_exponents(thm3__exp_eq.rhs.subs(u, back.rhs)), evaluate=False))


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
    step("the same equation", Eq(a_3 * tau + b_3 + c_3 * exp(d_3 * tau), 0))
    return And(*(Eq(COEFFICIENTS[name], value) for name, value in found.items()))


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
    """z = -d (tau + b/a) is above -1, since u < -1: so z = W(z e^z), and z e^z is the argument of W in result (3)."""
    put = {name: thm3__case2__abcd.of(of_3) for name, of_3 in zip((a, b, c, d), COEFFICIENTS.values(), strict=True)}
    z = (-d * (tau + b / a)).subs(put, simultaneous=True)
    in_u = sp.factor(sp.cancel(z.subs(tau, thm3__case2__subst.of(tau))))
    same, height = identity_at(claim__W_identity, in_u)
    if not isinstance(step("z is above -1", compare_on(height, sp.S.Zero, {u: BEYOND})), Gt):
        raise DerivationError(f"{in_u} is not a value of W")
    step("so that W(z e^z) is z", same)
    product = _product_by(thm3__case2__t_eq.equation, z)
    by_w = Eq(z, same.lhs.func(product), evaluate=False)
    root = simplify_inside(isolate(by_w, tau).rhs)
    told = simplify_inside(res3.rhs.subs(put, simultaneous=True))
    if is_zero(root - told) is None:
        raise DerivationError(f"the root {root} is not the one of result (3), {told}")
    check_root(thm3__case2__t_eq.equation, tau, root)
    return Eq(tau, root, evaluate=False)


def _product_by(equation, z):
    """What z e^z is where a tau + b + c e^(d tau) = 0: the exponential of the equation is linear in tau."""
    (growth,) = (e for e in equation.lhs.atoms(exp) if e.has(tau))
    power = sp.Dummy("power", positive=True)
    left = isolate(equation.subs(growth, power), power).rhs  # what the exponential is
    rest = sp.expand(z + growth.args[0])  # of the exponent of e^z
    if rest.has(tau):
        raise DerivationError(f"e^({z}) is no multiple of 1/{growth}")
    return sp.simplify(sp.cancel(z / left) * exp(rest))


@chapter.derive(
    "projectile.support.branch-thm3",
    Lt(alpha * other_branch(W_a) / (alpha**2 - 1 - other_branch(W_a)), 0),
    Domain({alpha: BELOW_1}),
)
def reject_other_branch(thm3__case2__t, thm3__case2__subst, def__u, def__alpha, def__W, def__T):
    """The root by W_{-1} has the sine alpha/(e^(1 + w) - 1) with w < -1, which is negative."""
    other = other_branch(thm3__case2__t.rhs)
    (inverse,) = other.atoms(LambertW)
    sine = sine_of_u(def__u, def__alpha).subs(u, thm3__case2__subst.of(u)).subs(tau, other)
    in_w = lead_positive(sp.cancel(sine.subs(inverse, w)), alpha)
    round_trip = next(e for e in def__W.parts if isinstance(e, Eq) and e.lhs.args == (LambertW(q, -1),))
    product = Eq(def__T.of(round_trip.lhs.func(w)), inverse.args[0], evaluate=False)
    square = sp.Dummy("square", positive=True)
    in_w_alone = isolate(product.subs(alpha, sp.sqrt(square)), square).rhs
    elementary = sp.simplify((in_w / alpha).subs(alpha**2, in_w_alone))
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
    (inverse,) = at.rhs.atoms(LambertW)
    sine = lead_positive(sp.cancel(sine_of_u(def__u, def__alpha).subs(u, at.rhs.subs(inverse, w))), alpha)
    return Eq(sin(theta_max), sine.subs(w, inverse), evaluate=False)


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
    sine = alpha * sp.simplify((sin(general) / alpha).subs(inverse, w).subs(alpha**2, in_w)).subs(w, inverse)
    if is_zero(sine.subs(alpha, 1) - sin(special)) is None:
        raise DerivationError(f"{sine} is not {sin(special)} at alpha = 1")
    return Eq(sin(theta_max), sine, evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
