"""The primitives where drag vanishes: closed form 0/0, value and first derivative by a parameter that removes W.

With s = gamma t (or k t) at the arrival: p^2/2 = s - 1 + e^(-s); 1 + b = s/(1 - e^(-s)); a^2 = 1 + (s - 1) e^s.
"""

import sympy as sp
from sympy import Derivative, Eq, Ge, LambertW, Rational, exp, pi, sin, sqrt

from galileo_sym.derivations.projectile.notation import alpha, theta_max
from galileo_sym.derivations.stable.notation import a, b, notation, p, s, z
from galileo_sym.ledger import POSITIVE, Chapter, DerivationError, Domain, step, tell_chapter
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.primitives import (
    best_angle,
    best_sine,
    best_time,
    descent_factor,
    flight_factor,
    max_range_factor,
    phi1,
    phi2,
    range_balance,
    range_factor,
    range_loss,
)
from galileo_sym.tactics import elementary_limit, introduce, ladder, limits_at_zero

chapter = Chapter("stable.singularities", notation, "stable forms (not printed)")

P_OF_S = sqrt(2 * (s - 1 + exp(-s)))
B_OF_S = s / (1 - exp(-s)) - 1


def by_parameter(form, x, path, w_in_s, in_s):
    """Value and slope at x = 0 of a form in W, along x = path(s), s -> 0+.

    W at x = path(s) is `w_in_s`, and the form `in_s`: both are checked here, and that W is on the principal branch.
    """
    (w_atom,) = form.atoms(LambertW)
    argument = w_atom.args[0].subs(x, path)
    if is_zero(w_in_s * exp(w_in_s) - argument) is None:
        raise DerivationError(f"{w_in_s} is not a W of {argument}")
    step("the principal branch", Ge(w_in_s, -1, evaluate=False))
    ladder(sp.expand((1 + w_in_s) * sp.denom(sp.together(w_in_s))), s)
    if is_zero(form.xreplace({w_atom: w_in_s}).subs(x, path) - in_s) is None:
        raise DerivationError(f"{form} is not {in_s} along {x} = {path}")
    if elementary_limit(path, s, 0) != 0:
        raise DerivationError(f"{path} does not tend to 0")
    slope = elementary_limit(sp.diff(in_s, s) / sp.diff(path, s), s, 0)
    return limits_at_zero(form, x, elementary_limit(in_s, s, 0), slope)


DESCENT = descent_factor(p).rewrite(LambertW)
FLIGHT = flight_factor(b).rewrite(LambertW)
RANGE = range_factor(b).rewrite(LambertW)
BALANCE = range_balance(b).rewrite(LambertW)
LOSS = range_loss(b).rewrite(LambertW)
LARGEST = max_range_factor(a).rewrite(LambertW)
SINE = best_sine(a).rewrite(LambertW)
TIME = best_time(a).rewrite(LambertW)
ANGLE = best_angle(a).rewrite(LambertW)
W_FLIGHT = -s / (exp(s) - 1)
RANGE_OF_S = (1 - exp(-s)) / (2 * B_OF_S)
BALANCE_OF_S = (s - 1 + exp(-s)) / (exp(s) - 1 - s)


@chapter.derive(
    "stable.at-zero.phi1", limits_at_zero(phi1(-z).rewrite(exp), z, 1, -Rational(1, 2)), Domain({z: POSITIVE})
)
def phi1_at_zero():
    """An elementary form: SymPy's limit is right."""
    form = phi1(-z).rewrite(exp)
    return limits_at_zero(form, z, elementary_limit(form, z, 0), elementary_limit(sp.diff(form, z), z, 0))


@chapter.derive(
    "stable.at-zero.phi2",
    limits_at_zero(phi2(-z).rewrite(exp), z, Rational(1, 2), -Rational(1, 6)),
    Domain({z: POSITIVE}),
)
def phi2_at_zero():
    """An elementary form: SymPy's limit is right."""
    form = phi2(-z).rewrite(exp)
    return limits_at_zero(form, z, elementary_limit(form, z, 0), elementary_limit(sp.diff(form, z), z, 0))


@chapter.derive("stable.at-zero.descent_factor", limits_at_zero(DESCENT, p, 1, Rational(1, 6)), Domain({s: POSITIVE}))
def descent_at_zero():
    """W = -e^(-s), and the factor is s/p."""
    return by_parameter(DESCENT, p, P_OF_S, -exp(-s), s / P_OF_S)


@chapter.derive("stable.at-zero.flight_factor", limits_at_zero(FLIGHT, b, 1, -Rational(1, 3)), Domain({s: POSITIVE}))
def flight_at_zero():
    """W = -s/(e^s - 1), and the factor is s/(2 b)."""
    return by_parameter(FLIGHT, b, B_OF_S, W_FLIGHT, s / (2 * B_OF_S))


@chapter.derive("stable.at-zero.range_factor", limits_at_zero(RANGE, b, 1, -Rational(4, 3)), Domain({s: POSITIVE}))
def range_at_zero():
    """W = -s/(e^s - 1), and the factor is (1 - e^(-s))/(2 b)."""
    return by_parameter(RANGE, b, B_OF_S, W_FLIGHT, RANGE_OF_S)


@chapter.derive("stable.at-zero.range_balance", limits_at_zero(BALANCE, b, 1, -Rational(4, 3)), Domain({s: POSITIVE}))
def balance_at_zero():
    """W = -s/(e^s - 1), and the balance is tan^2 of the elevation of largest range, by s."""
    return by_parameter(BALANCE, b, B_OF_S, W_FLIGHT, BALANCE_OF_S)


@chapter.derive(
    "stable.range_loss", Eq(-Derivative(range_factor(b), b), range_loss(b), evaluate=False), Domain({b: POSITIVE})
)
def loss_is_slope():
    """The slope of the closed form over the form itself, times b, is 1 less the balance."""
    share = sp.simplify(-b * sp.diff(RANGE, b) / RANGE)
    balance = sp.simplify(introduce(1 - share, range_balance(b)))
    step("the share lost", Eq(share, 1 - balance, evaluate=False))
    slope = range_factor(b) * (1 - balance) / b
    return Eq(-Derivative(range_factor(b), b), slope.subs(range_loss(b).rewrite(range_balance), range_loss(b)))


@chapter.derive(
    "stable.at-zero.range_loss", limits_at_zero(LOSS, b, Rational(4, 3), -Rational(28, 9)), Domain({s: POSITIVE})
)
def loss_at_zero():
    """W = -s/(e^s - 1), and the loss is range_factor (1 - range_balance)/b."""
    return by_parameter(LOSS, b, B_OF_S, W_FLIGHT, RANGE_OF_S * (1 - BALANCE_OF_S) / B_OF_S)


@chapter.derive(
    "stable.at-zero.best_sine", limits_at_zero(SINE, a, 1 / sqrt(2), -Rational(1, 6)), Domain({s: POSITIVE})
)
def best_sine_at_zero(projectile__support__kT_at_max):
    """W, alpha and the sine at the best angle are known along s, the impact time times k."""
    told = projectile__support__kT_at_max
    path, one_more = sqrt(told.of(alpha**2)), told.of(s)
    w_in_s = s - one_more.xreplace(dict.fromkeys(one_more.atoms(LambertW), sp.S.Zero))
    return by_parameter(SINE, a, path, w_in_s, told.of(sin(theta_max)).subs(alpha, path))


@chapter.derive("stable.at-zero.best_time", limits_at_zero(TIME, a, sqrt(2), -Rational(2, 3)), Domain({s: POSITIVE}))
def best_time_at_zero(projectile__support__kT_at_max):
    """W and alpha at the best angle are known along s, the impact time times k."""
    told = projectile__support__kT_at_max
    path, one_more = sqrt(told.of(alpha**2)), told.of(s)
    w_in_s = s - one_more.xreplace(dict.fromkeys(one_more.atoms(LambertW), sp.S.Zero))
    return by_parameter(TIME, a, path, w_in_s, s / path)


@chapter.derive(
    "stable.at-zero.max_range_factor", limits_at_zero(LARGEST, a, 1, -2 * sqrt(2) / 3), Domain({s: POSITIVE})
)
def largest_range_at_zero(projectile__support__kT_at_max):
    """W and alpha at the best angle are known along s, the impact time times k."""
    told = projectile__support__kT_at_max
    path, one_more = sqrt(told.of(alpha**2)), told.of(s)
    w_in_s = s - one_more.xreplace(dict.fromkeys(one_more.atoms(LambertW), sp.S.Zero))
    return by_parameter(LARGEST, a, path, w_in_s, sqrt(1 - (1 + s) * exp(-s)) / path)


@chapter.derive(
    "stable.at-zero.best_angle",
    limits_at_zero(ANGLE, a, pi / 4, -sqrt(2) / 6),
    Domain({s: POSITIVE}),
    premises=("stable.at-zero.best_sine",),
)
def best_angle_at_zero(sine_at_zero):
    """The arcsine is smooth at the limit of the sine: the chain rule."""
    at_zero = {e.lhs.args[0]: e.rhs for e in sine_at_zero.parts}
    sine = sp.Function("sine", real=True)(a)
    angle = ANGLE.xreplace({SINE: sine})
    if angle.has(LambertW):
        raise DerivationError(f"{ANGLE} is no function of {SINE}")
    value, slope = at_zero[SINE], at_zero[sp.Derivative(SINE, a)]
    put = (sp.Derivative(sine, a), slope), (sine, value)
    return limits_at_zero(ANGLE, a, angle.subs(sine, value), sp.simplify(sp.diff(angle, a).subs(put)))


if __name__ == "__main__":
    tell_chapter(chapter.name)
