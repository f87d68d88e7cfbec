"""A limit theorem for inverse functions: Theorem 1, for any real-analytic f that is not constant."""

import sympy as sp
from sympy import And, Eq, Gt, Implies, Limit, Mod, Ne, Subs, Sum

from galileo_sym.derivations.projectile.analytic_notation import (
    ANALYTIC,
    AROUND,
    EXTREMUM,
    FAMILY,
    GAP,
    INVERSE,
    INVERSE_FAMILY,
    LEADS,
    LEFT,
    LEFT_OF_IT,
    QUARTER,
    REFLECTED,
    ROUND_TRIP,
    SERIES,
    VALUES,
    F,
    N,
    X,
    a,
    f,
    h,
    i,
    notation,
    q,
    x,
    x_0,
    y,
)  # fmt: skip
from galileo_sym.ledger import Chapter, DerivationError, Domain, step, tell_chapter
from galileo_sym.ledger.local import MonotoneBeside
from galileo_sym.tactics import (
    even_at_extremum,
    inverse_tends,
    modus_ponens,
    monotone_beside,
    negative_root,
    split_series,
    take_out,
    value_at_centre,
    value_near,
)  # fmt: skip

chapter = Chapter(
    "projectile.limit_theorem", notation, "A limit theorem for inverse functions and its application: Theorem 1"
)

NEAR = Domain(AROUND, where=FAMILY, supposing=ANALYTIC)
ASIDE = Domain({**AROUND, h: sp.Interval.Lopen(0, QUARTER)}, where=FAMILY, supposing=ANALYTIC)
BELOW = Domain(LEFT_OF_IT, where=INVERSE_FAMILY, supposing=(*ANALYTIC, *INVERSE))
BELOW_EXTREMUM = Domain(LEFT_OF_IT, where=INVERSE_FAMILY, supposing=(*ANALYTIC, EXTREMUM, *INVERSE))
ANY_FUNCTION = Domain(LEFT_OF_IT, where=INVERSE_FAMILY)
IS_EVEN = Eq(Mod(N, 2), 0)
TURN = (y(x) - x_0) / X


@chapter.derive(
    "projectile.thm1.factor",
    And(
        Eq(f(x), a(0) + X**N * F(x)),
        Eq(F(x), Sum(a(i) * X ** (i - N), (i, N, sp.oo))),
        Eq(Subs(F(x), x, x_0), a(N)),
        Ne(a(N), 0),
    ),
    NEAR,
)
def factor():
    """Leave out the terms below N, the least index above 0 with a_N not 0 (f is not constant); take (x - x_0)^N out."""
    constant, tail = split_series(SERIES.rhs, GAP)
    step("the terms that are left", Eq(f(x), constant + tail))
    rest = take_out(tail, X**N)
    value = value_at_centre(rest, x, x_0)
    return And(
        Eq(f(x), constant + X**N * F(x)),
        Eq(F(x), rest),
        Eq(Subs(F(x), x, x_0), value),
        LEADS.subs(LEADS.lhs, value),
    )


def _near(factored):
    """What the factorisation says of F near x_0, where it is continuous."""
    nonzero = next((e for e in factored.parts if isinstance(e, Ne)), None)
    if nonzero is None:
        raise DerivationError(f"{factored.id} does not say that F is not 0 at x_0")
    centre = Subs(F(x), x, x_0)
    return value_near(Eq(F(x), factored.of(F(x))), Eq(centre, factored.of(centre)), nonzero)


def _deviation(factored):
    """f(x) - f(x_0) by the factorisation."""
    return factored.of(f(x)) - factored.of(f(x)).subs(x, x_0)


@chapter.derive("projectile.thm1.N-even", Implies(EXTREMUM, IS_EVEN), ASIDE)
def even_order(thm1__factor):
    """For odd N f - f(x_0) = (x - x_0)^N F(x) changes sign at x_0, since F keeps its own: that is no extremum."""
    odd = step("for odd N", even_at_extremum(_deviation(thm1__factor), x, N, _near(thm1__factor), h))
    parity = odd.args[0].lhs
    return Implies(EXTREMUM, Eq(parity, 1 - odd.args[0].rhs))


@chapter.derive(
    "projectile.thm1.monotone",
    And(MonotoneBeside(f(x), x, x_0, 1, a(N)), MonotoneBeside(f(x), x, x_0, -1, (-1) ** (N - 1) * a(N))),
    NEAR,
)
def monotone_parts(thm1__factor):
    """The slope is (x - x_0)^(N - 1) times N F(x) + (x - x_0) F'(x), which is N a_N at x_0 and keeps its sign."""
    factored = Eq(f(x), thm1__factor.of(f(x)), evaluate=False)
    return And(*monotone_beside(factored, x, N, _near(thm1__factor)))


@chapter.derive("projectile.thm1.ratio", Eq((y(x) - x_0) ** N / X**N, F(x) / F(y(x))), BELOW)
def ratio(thm1__factor):
    """f(y) = f(x), since f undoes its inverse; divide the two factorisations."""
    _near(thm1__factor)
    told = step("f undoes its inverse", ROUND_TRIP.subs(q, f(x)).subs(REFLECTED.rhs, REFLECTED.lhs))
    body = sp.Lambda(x, thm1__factor.of(f(x)) - a(0))
    left, right = (side.replace(f, body) for side in told.args)
    step("with the factorisation", Eq(left, right, evaluate=False))
    over = X**N * F(y(x))
    return Eq(left / over, right / over, evaluate=False)


@chapter.derive("projectile.thm1.root", Eq(TURN, -((F(x) / F(y(x))) ** (1 / N))), BELOW_EXTREMUM)
def root(thm1__ratio, thm1__N_even):
    """N is even, and y >= x_0 > x: the real N-th root of the ratio is the negative one."""
    even = modus_ponens(thm1__N_even.statement, (EXTREMUM,))
    above = step("y is not below x_0", VALUES.subs(q, f(x)).subs(REFLECTED.rhs, REFLECTED.lhs))
    sides = {
        above.lhs: above.rhs + sp.Dummy("up", nonnegative=True),
        LEFT.lhs: LEFT.rhs - sp.Dummy("down", positive=True),
    }
    if not TURN.subs(sides, simultaneous=True).is_nonpositive:
        raise DerivationError(f"{above} and {LEFT} do not say that {TURN} is not positive")
    opposite = step("x and y are on either side", sp.Le(TURN, 0))
    return negative_root(thm1__ratio.equation, N, even, opposite)


@chapter.derive(
    "projectile.thm1",
    Implies(
        And(*ANALYTIC, EXTREMUM, *INVERSE),
        And(
            MonotoneBeside(f(x), x, x_0, 1, a(N)),
            MonotoneBeside(f(x), x, x_0, -1, -a(N)),
            Eq(Limit(TURN, x, x_0, "-"), -1),
        ),
    ),
    ANY_FUNCTION,
)
def theorem_1(thm1__factor, thm1__N_even, thm1__monotone, thm1__root):
    """As x goes to x_0, y = g(f(x)) does, g being continuous; so F(x) and F(y) both tend to a_N, which is not 0."""
    near = _near(thm1__factor)
    even = modus_ponens(thm1__N_even.statement, (EXTREMUM,))
    right, left = _sides(thm1__monotone)
    left = left.func(*left.args[:4], _for_even(left.args[4], even))
    if left.args[4] + right.args[4] != 0:
        raise DerivationError(f"f does not return on the left of x_0 to the values on its right: {left}, {right}")
    step("f(x) is among the values of f to the right", Gt((f(x) - Subs(f(x), x, x_0)) * right.args[4], 0))
    tends = step("y tends to x_0", inverse_tends(right, ROUND_TRIP, VALUES, REFLECTED))
    if tends.rhs != near.place:
        raise DerivationError(f"F is not known near {tends.rhs}")
    values = {F(x): near.value, F(y(x)): near.value}
    limit = thm1__root.rhs.xreplace(values)
    return Implies(And(*ANALYTIC, EXTREMUM, *INVERSE), And(right, left, Eq(Limit(thm1__root.lhs, x, x_0, "-"), limit)))


def _sides(claims):
    """The claims about the right and about the left of x_0."""
    parts = {e.args[3]: e for e in claims.parts if isinstance(e, MonotoneBeside)}
    if set(parts) != {1, -1}:
        raise DerivationError(f"{claims.id} does not speak of both sides")
    return parts[sp.S.One], parts[sp.S.NegativeOne]


def _for_even(expr, even):
    """An expression in N where N is even."""
    if even != IS_EVEN:
        raise DerivationError(f"{even} does not say that N is even")
    half = sp.Dummy("half", integer=True, positive=True)
    name = sp.Dummy("name", real=True)
    return expr.xreplace({a(N): name}).subs(N, 2 * half).xreplace({name: a(N)})


@chapter.derive(
    "beyond.thm1.next-coefficient",
    Eq(Limit((y(x) - x_0 + X) / X**2, x, x_0, "-"), -2 * a(N + 1) / (N * a(N))),
    BELOW_EXTREMUM,
)
def next_coefficient(thm1, thm1__root, thm1__factor):
    """Newton and Puiseux: y - x_0 = -X + c X^2 + ..., with c from the N-th root of F(x)/F(y) to first order in X.

    F(x_0 + Z) = a_N + a_(N+1) Z + o(Z), for Z = X and for Z = y - x_0, which is X times Theorem 1's -1 + o(1).
    """
    near = _near(thm1__factor)
    limit = next(e for e in sp.And.make_args(modus_ponens(thm1.statement, BELOW_EXTREMUM.supposing)) if e.has(Limit))
    away = sp.Dummy("away", real=True)
    term, (index, first, _) = thm1__factor.of(F(x)).args
    slope = sp.powsimp(term.subs(index, first + 1)) / X
    if slope.has(x) or limit.lhs.args[0] != thm1__root.lhs:
        raise DerivationError(f"{slope} is not the slope of F at x_0, or {limit} is about something else")
    in_order = {F(x): near.value + slope * away, F(y(x)): near.value + slope * limit.rhs * away}
    ratio_of = thm1__root.rhs.xreplace(in_order)
    step("Theorem 1 is the first order", Eq(limit.lhs, ratio_of.subs(away, 0)))
    second = sp.simplify(sp.diff(ratio_of, away).subs(away, 0))
    whole = sp.cancel(thm1__root.lhs - limit.rhs) / X
    return Eq(Limit(sp.factor(whole), x, x_0, "-"), second, evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
