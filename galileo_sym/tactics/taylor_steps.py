"""Linear equations of motion integrated in numbers, step by step, with a bound for the remainder of each step."""

from __future__ import annotations

import math
from itertools import islice

import mpmath
import sympy as sp
from mpmath import iv

from galileo_sym.ledger import DerivationError, tactic

from .motion_series import LinearLaw, initial_values, read_linear_law

TERMS = 30  # of the Taylor polynomial of a step, at least; about as many as there are digits is quickest
GUARD = 15  # decimal digits beyond those asked for


@tactic
def taylor_integrate(equation: sp.Eq, unknown, start: dict, values: dict, times, digits=40):
    """Enclose the solution of a law, and its derivatives below the order of the law, at some times.

    In a step of length h the derivatives at its start give the Taylor polynomial. Each later derivative is a sum of
    a_j times earlier ones, so that with m the order and L the largest of (m |a_j|)^(1/(m - j)) they grow at most like
    L^n, and what is left out is less than a geometric series. All is done in interval arithmetic; no closed form of
    the solution is used.

    Parameters
    ----------
    equation : Eq
        Linear with constant coefficients, as `read_linear_law` takes it.
    unknown : applied function
    start : dict
        Initial values at time 0.
    values : dict
        Exact numbers for the symbols of the law.
    times : increasing sequence of exact numbers, not negative
    digits : int

    Returns
    -------
    list of lists of intervals
        For each time, enclosures of the unknown and its lower derivatives, each known to `digits` digits.

    Raises
    ------
    DerivationError
        The law is of another kind, a symbol has no value, or an enclosure is too wide.
    """
    law = read_linear_law(equation, unknown)
    begin = initial_values(law, unknown, start)
    numbers = [sp.sympify(e).subs(values) for e in (*law.coefficients, law.level, *begin)]
    if any(not n.is_number for n in numbers):
        raise DerivationError(f"{sorted(set().union(*(n.free_symbols for n in numbers)), key=str)} have no value")
    m = law.order
    speed = float(max((m * abs(a)) ** sp.Rational(1, m - j) for j, a in enumerate(numbers[:m])))
    # intervals may grow like e^(L t), L/2 for the motions here, where a solution decays as fast
    working = digits + GUARD + math.ceil(speed * float(times[-1]) / math.log(10))
    before, iv.dps = iv.dps, working
    try:
        *coefficients, level = (_interval(n, working) for n in numbers[: m + 1])
        exact = LinearLaw(tuple(coefficients), level)
        state, now, told = [_interval(n, working) for n in numbers[m + 1 :]], sp.S.Zero, []
        for time in map(sp.sympify, times):
            state, now = _advance(exact, state, time - now, speed, working), time
            _require_narrow(state, digits)
            told.append(state)
        return told
    finally:
        iv.dps = before


def _require_narrow(state, digits):
    for value in state:
        width, size = mpmath.mpf(value.delta), max(abs(mpmath.mpf(value.a)), abs(mpmath.mpf(value.b)))
        if width > size * mpmath.mpf(10) ** -digits:
            raise DerivationError(f"the enclosure {value} is wider than {digits} digits allow")


def _interval(number, working):
    """An interval around an exact number."""
    if number.is_Rational:
        return iv.mpf(int(number.p)) / iv.mpf(int(number.q))
    with mpmath.workdps(working + 5):
        near = mpmath.mpf(sp.N(number, working + 5)._mpf_)
        off = abs(near) * mpmath.mpf(10) ** (-working - 3)
        return iv.mpf([near - off, near + off])


def _advance(law, state, span, speed, working):
    """The state a time `span` later, in equal steps short enough for the remainder to be below the rounding."""
    if span == 0:
        return state
    terms = max(TERMS, working)
    short = math.exp((math.lgamma(terms + 1) - working * math.log(10)) / terms)  # (L h)^terms/terms! = 10^-working
    steps = max(1, math.ceil(speed * float(span) / min(short, terms / 2)))
    h = _interval(span / steps, working)
    for _ in range(steps):
        state = _step(law, state, h, terms)
    return state


def _step(law, state, h, terms):
    derivatives = list(islice(law.derivatives(state), terms + 2 * law.order))
    following = []
    for j in range(law.order):
        value = iv.mpf(0)
        for n in reversed(range(terms)):  # d_j + h/1 (d_(j+1) + h/2 (d_(j+2) + ...
            value = derivatives[j + n] + value * h / (n + 1)
        bound = _remainder(law, derivatives[j + terms : j + terms + law.order], h, terms)
        following.append(value + iv.mpf([-bound, bound]))
    return following


def _remainder(law, later, h, terms):
    """A bound for all terms of order `terms` and more, from as many derivatives of that order on as the law has."""
    m = law.order
    rates = [iv.exp(iv.log(m * abs(a)) / (m - j)) for j, a in enumerate(law.coefficients) if a != 0]
    if not rates:
        return 0  # they all vanish: the solution is a polynomial
    rate = iv.mpf(max(r.b for r in rates))
    size = iv.mpf(max((abs(d) / rate**i).b for i, d in enumerate(later)))
    if not (rate * h).b < terms:
        raise DerivationError("the step is too long for the remainder to be bounded")
    return (size * h**terms / iv.factorial(terms) / (1 - rate * h / (terms + 1))).b
