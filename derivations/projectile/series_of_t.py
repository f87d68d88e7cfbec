"""A closed form for the maximum range angle: w e^w in powers of w + 1, and alpha^2 with it."""

import sympy as sp
from sympy import And, Eq, Sum, exp, factorial

from galileo_sym.derivations.projectile.notation import H, alpha, n, notation, q, w
from galileo_sym.derivations.projectile.shared import E1, W_a
from galileo_sym.ledger import (
    NONNEGATIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    PowerSeries,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    affine_series,
    divide_series,
    entire_series,
    not_negative,
    renumber,
    times_sum,
    with_tail,
)  # fmt: skip

chapter = Chapter("projectile.series_of_t", notation, "A closed form for the maximum range angle: a power series")

FROM_0 = Domain({alpha: NONNEGATIVE}, where={w: W_a})
TERM = (n - 1) / factorial(n)  # of the series about w = -1, times e
HEIGHT = W_a + 1


@chapter.derive("projectile.cont.WeW", Eq(W_a * exp(W_a), (alpha**2 - 1) / E1), FROM_0)
def product(res1):
    """(1) at x = (alpha^2 - 1)/e, which is in the domain of W."""
    argument = W_a.args[0]
    step("the argument of W", not_negative(sp.expand(argument + exp(-1)), {}))
    return Eq(res1.rhs.subs(q, argument), res1.lhs.subs(q, argument), evaluate=False)


@chapter.derive(
    "projectile.cont.series",
    And(
        Eq(
            -exp(-1) + HEIGHT**2 / (2 * E1) + 2 * HEIGHT**3 / (6 * E1) + Sum(TERM / E1 * HEIGHT**n, (n, 4, sp.oo)),
            (alpha**2 - 1) / E1,
        ),
        PowerSeries(w * exp(w), w, -1, TERM / E1, n),
    ),
    Domain({alpha: NONNEGATIVE, n: NONNEGATIVE}, where={w: W_a}),
)
def series_of_t(cont__WeW):
    """The derivative of order n of w e^w is (w + n) e^w, and at -1 it is (n - 1)/e."""
    series = entire_series(cont__WeW.lhs.subs(W_a, w), w, -1, n)
    return And(Eq(with_tail(series, 4, W_a), cont__WeW.rhs, evaluate=False), series)


def _equation(premise):
    return next(e for e in premise.parts if isinstance(e, Eq))


def _series(premise):
    return next(e for e in premise.parts if isinstance(e, PowerSeries))


@chapter.derive(
    "projectile.cont.series2",
    Eq(HEIGHT**2 / 2 + 2 * HEIGHT**3 / 6 + Sum(TERM * HEIGHT**n, (n, 4, sp.oo)), alpha**2),
    FROM_0,
)
def series_of_square(cont__series):
    """Multiply by e, term by term, and add 1."""
    told = _equation(cont__series)
    return Eq(times_sum(told.lhs, E1) + 1, sp.expand(told.rhs * E1) + 1, evaluate=False)


@chapter.derive(
    "projectile.cont.H",
    And(
        Eq(alpha**2, HEIGHT**2 * H(W_a)),
        Eq(
            H(w),
            sp.Rational(1, 2)
            + sp.Rational(2, 6) * (w + 1)
            + Sum((n + 1) / factorial(n + 2) * (w + 1) ** n, (n, 2, sp.oo)),
        ),
        PowerSeries((1 + w * exp(w + 1)) / (w + 1) ** 2, w, -1, (n + 1) / factorial(n + 2), n),
        Eq(H(-1), sp.Rational(1, 2)),
    ),
    FROM_0,
    erratum=Erratum(("S15",), "H(w) is H(W); a '6' stands alone, and the dot of theta_max is no derivative"),
)
def quotient(cont__series2, cont__series):
    """Divide by (W + 1)^2, term by term; the series of (1 + w e^(w + 1))/(w + 1)^2 has the same terms."""
    inside = renumber(times_sum(cont__series2.lhs, HEIGHT**-2), 2).subs(W_a, w)
    entire = divide_series(affine_series(_series(cont__series), E1, 1), 2)
    if is_zero(inside - with_tail(entire, 2, w)) is None:
        raise DerivationError(f"{inside} is not the series of {entire}")
    at_foot = entire.args[3].subs(n, 0)
    return And(
        Eq(cont__series2.rhs, HEIGHT**2 * H(W_a), evaluate=False),
        Eq(H(w), inside, evaluate=False),
        entire,
        Eq(H(entire.args[2]), at_foot, evaluate=False),
    )


if __name__ == "__main__":
    tell_chapter(chapter.name)
