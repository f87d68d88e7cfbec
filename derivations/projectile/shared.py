"""What the sections on the best angle share: the cases of alpha, the sine in terms of u, and W(z e^z) = z."""

import sympy as sp
from sympy import Eq, Ge, Interval, LambertW, exp, sin

from galileo_sym.derivations.projectile.notation import (
    TRIAL_Y,
    StationaryAngle,
    T,
    alpha,
    alpha_0,
    k,
    q,
    tau,
    theta,
    theta_max,
    u,
    w,
)
from galileo_sym.ledger import Domain, StrictlyIncreasing, step
from galileo_sym.tactics import continuous_inverse, isolate

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


# theta_max as a function of alpha, its value at 0 that of a throw without resistance
BEST_FROM_0 = sp.Piecewise((sp.pi / 4, Eq(alpha_0, 0)), (StationaryAngle(alpha_0), True))


def continuous_w(definition, power, monotone):
    """W is continuous from -1/e on, as the inverse of the rising half of T."""
    round_trip = next(e for e in definition.parts if isinstance(e, Eq) and e.lhs == T(LambertW(q)))
    values = next(e for e in definition.parts if isinstance(e, Ge) and e.lhs == LambertW(q))
    rising = next(e for e in monotone.parts if isinstance(e, StrictlyIncreasing))
    product = Eq(power.of(T(w)).subs(w, LambertW(q)), round_trip.rhs, evaluate=False)
    return step("W is continuous", continuous_inverse(rising, product, values))


def sine_of_u(def_u, def_alpha):
    """sin(theta) in terms of u and alpha, from the definitions of both."""
    resistance = isolate(def_alpha.equation, k).rhs
    return sp.cancel(isolate(def_u.equation, sin(theta)).rhs.subs(k, resistance))


def identity_at(claim, z):
    """W(z e^z) = z, and by how much z must be above the least value of W."""
    same = next(e for e in claim.statement.args if isinstance(e, Eq))
    above = next(e for e in claim.statement.args if isinstance(e, Ge))
    return Eq(same.lhs.subs(w, z), same.rhs.subs(w, z), evaluate=False), (above.lhs - above.rhs).subs(w, z)


def lead_positive(fraction, symbol):
    """The same fraction with a positive leading coefficient below, as it is printed."""
    top, bottom = sp.fraction(fraction)
    sign = -1 if sp.Poly(bottom, symbol).LC().is_negative else 1
    return (sign * top) / (sign * bottom).expand()


def tidy_exponents(expr):
    """Exponents as fractions in lowest terms."""
    return expr.replace(lambda e: isinstance(e, exp), lambda e: exp(sp.cancel(e.args[0])))
