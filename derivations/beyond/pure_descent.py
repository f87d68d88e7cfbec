"""Descent in pure numbers: lengths in D, times in sqrt(2 D/g), so that D and g drop out."""

import sympy as sp
from sympy import Abs, And, Eq, Interval, LambertW, atan, cos, exp, sin, sqrt, tan

from galileo_sym.derivations.beyond.chord_notation import S, notation, p_n, tau_AB, z
from galileo_sym.derivations.chord.notation import D, g, gamma, mu, n, p, s, s_AB, t, t_AB, theta
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Independent,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import at_rest, rescale, solve_motion

chapter = Chapter("beyond.pure_descent", notation, "What the papers leave open: descent in pure numbers")

LAST = atan(1 / mu)
UNIT = sqrt(2 * D / g)
SIZES = {g: POSITIVE, D: POSITIVE}
NUMBERS = {p: POSITIVE, mu: POSITIVE}
FALLEN = 2 * (p * z - 1 + exp(-p * z)) / p**2
SLIDES = {z: NONNEGATIVE, theta: Interval(0, LAST)}
DRAG = {gamma: p / UNIT}
PRINTED = LambertW(-exp(-1 - D * gamma**2 / (g * n))) / gamma + 1 / gamma + D * gamma / (g * n)  # (43)
TIME = (1 + p**2 / (2 * n) + LambertW(-exp(-1 - p**2 / (2 * n)))) / p


def in_units(expr):
    """gamma written as p over the unit of time, tidied: D and g must drop out."""
    pure = sp.expand(sp.powsimp(expr.subs(gamma, p / UNIT)))
    if pure.has(D, g):
        raise DerivationError(f"the units are still seen in {pure}")
    return pure


@chapter.derive(
    "beyond.pure-descent.law",
    Eq(S(z).diff(z, 2) + p * S(z).diff(z), 2 * cos(theta) - 2 * mu * sin(theta)),
    Domain({**SIZES, **NUMBERS, **SLIDES}, where={**DRAG, S(z): FALLEN * (cos(theta) - mu * sin(theta))}),
)
def law(eq40):
    """Put s = D S, t = sqrt(2 D/g) z into (40), and divide by g/2."""
    changed = step("other units", rescale(eq40.equation, s(t), S(z), length=D, time=UNIT))
    left, right = (sp.expand(side * UNIT**2 / D) for side in changed.args)
    drag = right.coeff(S(z).diff(z)) * S(z).diff(z)
    return Eq(left - in_units(drag), in_units(right - drag), evaluate=False)


@chapter.derive(
    "beyond.pure-descent.distance",
    Eq(S(z), FALLEN * (cos(theta) - mu * sin(theta))),
    Domain({**SIZES, **NUMBERS, **SLIDES}, where=DRAG),
)
def distance(beyond__pure_descent__law, eq41):
    """Solved from rest; it is (41) in the new units."""
    found = solve_motion(beyond__pure_descent__law.equation, S(z), at_rest(S(z)))
    known = in_units(eq41.rhs.subs(t, UNIT * z) / D)
    if is_zero(found.rhs - known) is None:
        raise DerivationError(f"{found} is not (41), {known}")
    return found


@chapter.derive(
    "beyond.pure-descent.arrival",
    Eq(p**2 / (2 * n), p * tau_AB - 1 + exp(-p * tau_AB)),
    Domain({**NUMBERS, theta: Interval.Ropen(0, LAST)}, where={n: 1 - mu * tan(theta), tau_AB: TIME}),
)
def arrival(beyond__pure_descent__distance, eq3):
    """S = cos(theta) in B: divide by the cosine, and name n = 1 - mu tan(theta)."""
    there = Eq(eq3.of(s_AB) / D, beyond__pure_descent__distance.rhs.subs(z, tau_AB), evaluate=False)
    over = [sp.expand(sp.expand(side / cos(theta)).subs(sin(theta), tan(theta) * cos(theta))) for side in there.args]
    ratio = sp.factor(over[1]).subs(mu, (1 - n) / tan(theta))
    left, right = (sp.expand(sp.simplify(side) * p**2 / (2 * n)) for side in (over[0], ratio))
    return Eq(left, right, evaluate=False)


@chapter.derive(
    "beyond.pure-descent.time",
    And(Eq(tau_AB, TIME), Eq(t_AB, UNIT * tau_AB), Independent(t_AB / UNIT, D), Independent(t_AB / UNIT, g)),
    Domain(
        {**SIZES, **NUMBERS, theta: Interval.open(-LAST, LAST)},
        where={**DRAG, n: 1 - mu * tan(Abs(theta)), t_AB: PRINTED},
    ),
)
def time(eq43):
    """(43) over the unit of time, with n for 1 - mu tan|theta|: for given p and n neither D nor g is left."""
    ratio = eq43.rhs.subs(tan(Abs(theta)), (1 - n) / mu) / UNIT
    found = Eq(tau_AB, in_units(ratio))
    free = [Independent(t_AB / UNIT, q) for q in (D, g) if not found.has(q)]
    return And(found, Eq(t_AB, UNIT * tau_AB, evaluate=False), *free)


ONE_NUMBER = (1 + p_n**2 / 2 + LambertW(-exp(-1 - p_n**2 / 2))) / p_n


@chapter.derive(
    "beyond.pure-descent.one-number",
    Eq(tau_AB * sqrt(n), ONE_NUMBER),
    Domain({p_n: POSITIVE, n: Interval.Lopen(0, 1)}, where={p: p_n * sqrt(n), tau_AB: TIME}),
)
def one_number(beyond__pure_descent__time):
    """Friction and drag together: over sqrt(2 D/(g n)) the time depends on p_n = p/sqrt(n) alone."""
    alone = sp.expand(beyond__pure_descent__time.of(tau_AB).subs(p, p_n * sqrt(n)) * sqrt(n))
    if alone.free_symbols != {p_n}:
        raise DerivationError(f"{alone} depends on more than {p_n}")
    return Eq(tau_AB * sqrt(n), alone)


if __name__ == "__main__":
    tell_chapter(chapter.name)
