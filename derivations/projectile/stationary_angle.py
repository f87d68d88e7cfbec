"""A closed form for the maximum range angle: from dR/dtheta = 0 to an equation between u and alpha."""

import sympy as sp
from sympy import (
    And,
    Derivative,
    Eq,
    Equivalent,
    LambertW,
    cos,
    exp,
    sin,
    tan,
)

from galileo_sym.derivations.projectile.notation import (
    BETWEEN,
    SHOT,
    SLOPE,
    TRIAL_Y,
    U_OF_THETA,
    U,
    W_u,
    Y,
    alpha,
    g,
    k,
    notation,
    s,
    t,
    theta,
    theta_max,
    u,
    v,
)  # fmt: skip
from galileo_sym.derivations.projectile.shared import (
    ALL_CASES,
    AT_BEST,
    CASES,
    E1,
    U_AT_BEST,
    W_a,
    identity_at,
    sine_of_u,
    tidy_exponents,
)
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    Independent,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    isolate,
)  # fmt: skip

chapter = Chapter("projectile.stationary_angle", notation, "A closed form for the maximum range angle: the condition")

chapter.given(
    "projectile.def.alpha",
    Eq(alpha, k * v / g),
    Domain(SHOT),
    erratum=Erratum(("S11",), "alpha = k v/g, not k v/e (nor k v/rho, below figure 6)", Eq(alpha, k * v / E1)),
)


def _condition(stationary):
    """The equation tan^2 + dy/du = 0 of Theorem 2."""
    same = next(e for e in stationary.parts if isinstance(e, Equivalent))
    return next(e for e in same.args if e.has(tan))


def _vanishing(equation):
    """What an equation says to be 0."""
    return equation.lhs - equation.rhs


U_OF_ALPHA = -1 - alpha * sin(theta)
Y_OF_ALPHA = LambertW(U_OF_ALPHA * exp(U_OF_ALPHA))
FACTOR_OF_ALPHA = tan(theta) ** 2 + (U_OF_ALPHA + 1) * Y_OF_ALPHA / ((Y_OF_ALPHA + 1) * U_OF_ALPHA)


@chapter.derive(
    "projectile.thm3.only-alpha",
    And(
        Eq(tan(theta) ** 2 + SLOPE, FACTOR_OF_ALPHA),
        Independent(tan(theta) ** 2 + SLOPE, v),
        Independent(tan(theta) ** 2 + SLOPE, g),
    ),
    Domain(
        {g: POSITIVE, v: POSITIVE, alpha: POSITIVE, theta: BETWEEN}, where={**TRIAL_Y, u: U_OF_THETA, k: alpha * g / v}
    ),
)
def only_alpha(thm2__stationary, lemma__b, def__uyR, def__alpha):
    """Where tan^2 + dy/du vanishes, k, v and g enter through u alone, and there through alpha: with k = alpha g/v."""
    factor = _vanishing(_condition(thm2__stationary))
    resistance = isolate(def__alpha.equation, k).rhs
    named = sp.cancel(def__uyR.of(U(k, theta)).subs(k, resistance))
    explicit = factor.subs(SLOPE, lemma__b.of(SLOPE)).subs(Y, def__uyR.of(Y)).subs(u, named)
    if explicit.has(v, g, k):
        raise DerivationError(f"{explicit} depends on more than alpha and theta")
    return And(Eq(factor, explicit), *(Independent(factor, parameter) for parameter in (v, g)))


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
    sine = step("the sine in terms of u", Eq(sin(theta_max), sine_of_u(def__u, def__alpha)))
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
    return Eq(sp.cancel(ratio.lhs.subs(Y, found)), tidy_exponents(ratio.rhs.subs(Y, found)), evaluate=False)


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
    height = sine_of_u(def__u, def__alpha).subs(u, u_of_s) * alpha
    squared = step("alpha against s", Eq(alpha**2, sp.expand(sp.simplify(height**2 / sine_2)), evaluate=False))
    sine = Eq(sin(theta_max), alpha * sp.simplify(sine_2 / height), evaluate=False)
    same, above = identity_at(claim__W_identity, s - 1)
    in_s, in_alpha = ((side - 1) * exp(-1) for side in (squared.rhs, squared.lhs))
    if is_zero(same.lhs.args[0] - in_s) is None or not above.is_positive:
        raise DerivationError(f"{same} does not invert {in_s}")
    found = isolate(Eq(LambertW(in_alpha), same.rhs, evaluate=False), s)
    name = next(e for e in support__s_param.parts if e.lhs == s and e.rhs.has(t))
    return And(squared, sine, found, Eq(name.rhs, found.rhs, evaluate=False))


if __name__ == "__main__":
    tell_chapter(chapter.name)
