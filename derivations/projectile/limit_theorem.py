"""A limit theorem for inverse functions: Theorem 1, for any real-analytic f that is not constant."""

import sympy as sp
from sympy import And, Eq, Implies, Interval, Limit, Mod, Ne, Subs, Sum

from galileo_sym.derivations.projectile.analytic_notation import (
    ANALYTIC,
    AROUND,
    DIVISOR,
    EVEN_ORDERS,
    EXTREMUM,
    FAMILY,
    GAP,
    INVERSE,
    INVERSE_FAMILY,
    INVERTED,
    LEADS,
    LEFT_OF_IT,
    REFLECTED,
    RETURNS,
    SERIES,
    F,
    N,
    X,
    a,
    away,
    f,
    h,
    i,
    notation,
    x,
    x_0,
    y,
)  # fmt: skip
from galileo_sym.ledger import Chapter, DerivationError, Domain, ForAll, step, tell_chapter
from galileo_sym.ledger.local import HoldsBeside, MonotoneBeside
from galileo_sym.tactics import (
    even_at_extremum,
    instantiate,
    limit_with_part,
    modus_ponens,
    monotone_beside,
    negative_root,
    nonzero_along,
    reflected_beside,
    split_series,
    take_out,
    value_at_centre,
    value_near,
)  # fmt: skip
from galileo_sym.tactics.places import ordered

chapter = Chapter(
    "projectile.limit_theorem", notation, "A limit theorem for inverse functions and its application: Theorem 1"
)

NEAR = Domain(AROUND, where=FAMILY, supposing=ANALYTIC)
LEFT = Domain(LEFT_OF_IT, where=INVERSE_FAMILY, supposing=ANALYTIC)
LEFT_OF_EXTREMUM = Domain(LEFT_OF_IT, where=INVERSE_FAMILY, supposing=(*ANALYTIC, EXTREMUM))
SUPPOSED = (*ANALYTIC, EXTREMUM, *INVERTED)
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
    within = instantiate(SERIES, FAMILY[x], NEAR.inside.args).subs(away, X)
    constant, tail = split_series(within.rhs, GAP)
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


@chapter.derive("projectile.thm1.N-even", Implies(EXTREMUM, IS_EVEN), NEAR)
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


@chapter.derive(
    "projectile.thm1.ratio", Implies(And(*RETURNS, DIVISOR), Eq((y(x) - x_0) ** N / X**N, F(x) / F(y(x)))), LEFT
)
def ratio(thm1__factor):
    """Where f(y) = f(x), both within h of x_0, divide the two factorisations."""
    _near(thm1__factor)
    *there, same = RETURNS
    factored = Eq(f(x), thm1__factor.of(f(x)), evaluate=False)
    on_the_right = instantiate(ForAll(factored, x, Interval(x_0, x_0 + h)), y(x), there)
    told = step(
        "with the factorisation",
        Implies(And(*RETURNS), same.subs({e.lhs: e.rhs for e in (on_the_right, factored)}, simultaneous=True)),
    )
    left, right = (side - a(0) for side in told.args[1].args)
    over = X**N * DIVISOR.lhs
    return Implies(And(*RETURNS, DIVISOR), Eq(left / over, right / over, evaluate=False))


@chapter.derive(
    "projectile.thm1.root",
    Implies(And(*RETURNS, DIVISOR), Eq(TURN, -((F(x) / F(y(x))) ** (1 / N)))),
    LEFT_OF_EXTREMUM,
)
def root(thm1__ratio, thm1__N_even):
    """N is even, and y >= x_0 > x: the real N-th root of the ratio is the negative one."""
    even = modus_ponens(thm1__N_even.statement, (EXTREMUM,))
    above, *_ = RETURNS
    if not ordered(FAMILY[x], x_0, strict=True, known=LEFT.inside.args):
        raise DerivationError(f"{x} is not shown to be below {x_0}")
    sides = {
        above.lhs: above.rhs + sp.Dummy("up", nonnegative=True),
        x: x_0 - sp.Dummy("down", positive=True),
    }
    if not TURN.subs(sides, simultaneous=True).is_nonpositive:
        raise DerivationError(f"{above} does not say that {TURN} is not positive")
    opposite = sp.Le(TURN, 0)
    step("x and y are on either side", Implies(above, opposite))
    power = modus_ponens(thm1__ratio.statement, (*RETURNS, DIVISOR))
    return Implies(And(*RETURNS, DIVISOR), negative_root(power, N, even, opposite))


@chapter.derive(
    "projectile.thm1",
    Implies(
        And(*SUPPOSED),
        And(
            MonotoneBeside(f(x), x, x_0, 1, a(N)),
            MonotoneBeside(f(x), x, x_0, -1, -a(N)),
            HoldsBeside(And(*RETURNS), x, x_0, -1),
            Eq(Limit(TURN, x, x_0, "-"), -1),
        ),
    ),
    Domain(EVEN_ORDERS, where=INVERSE_FAMILY),
)
def theorem_1(thm1__factor, thm1__N_even, thm1__monotone, thm1__root):
    """To the left f takes values that it takes to the right, at y; y goes to x_0, F(x) and F(y) to a_N, not 0."""
    near = _near(thm1__factor)
    even = modus_ponens(thm1__N_even.statement, (EXTREMUM,))
    right, left = _sides(thm1__monotone)
    left = left.func(*left.args[:4], _for_even(left.args[4], even))
    reflected = reflected_beside(right, left, SERIES, INVERSE)
    defined, tends = (_named(claim) for claim in reflected)
    step("y is defined near x_0", defined)
    step("y tends to x_0", tends)
    equation = _root_beside(thm1__root, defined, nonzero_along(near, tends, _at_centre()))
    limit = equation.rhs.xreplace({F(x): near.value, F(y(x)): near.value})
    return Implies(And(*SUPPOSED), And(right, left, defined, Eq(Limit(equation.lhs, x, x_0, "-"), limit)))


def _named(claim):
    """A claim about g(f(x)), for x up to x_0, said of y(x)."""
    name = REFLECTED.args[0]
    return claim.xreplace({name.rhs: name.lhs})


def _at_centre():
    """y(x_0) = g(f(x_0)), which is x_0."""
    named, undone = (instantiate(claim, x_0) for claim in (REFLECTED, INVERSE))
    return named.subs(undone.lhs, undone.rhs)


def _root_beside(rooted, defined, nonzero):
    """The equation of the root near x_0: its conditions hold there."""
    if {claim.args[1:] for claim in (defined, nonzero)} != {(x, x_0, sp.S.NegativeOne)}:
        raise DerivationError(f"{defined} and {nonzero} are not about the left of {x_0}")
    return modus_ponens(rooted.statement, (*defined.args[0].args, step("F(y) is not 0", nonzero).args[0]))


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
    Domain(EVEN_ORDERS, where=INVERSE_FAMILY, supposing=SUPPOSED),
)
def next_coefficient(thm1, thm1__root, thm1__factor):
    """Newton and Puiseux: y - x_0 = -X + c X^2 + ..., with c from the N-th root of F(x)/F(y) to first order in X.

    F(x_0 + Z) = a_N + a_(N+1) Z + o(Z), for Z = X and for Z = y - x_0, which is X times Theorem 1's -1 + o(1).
    """
    near = _near(thm1__factor)
    told = modus_ponens(thm1.statement, SUPPOSED).args
    limit = next(e for e in told if e.has(Limit))
    turn, small = limit.lhs.args[0], sp.Dummy("turn", real=True)
    tends = Eq(Limit(y(x), *limit.lhs.args[1:]), limit_with_part(x_0 + small * X, small, limit.rhs, x, x_0, "-"))
    defined = next(e for e in told if isinstance(e, HoldsBeside))
    equation = _root_beside(thm1__root, defined, nonzero_along(near, step("y tends to x_0", tends), _at_centre()))
    distance = sp.Dummy("distance", real=True)
    term, (index, first, _) = thm1__factor.of(F(x)).args
    slope = sp.powsimp(term.subs(index, first + 1)) / X
    if slope.has(x) or turn != equation.lhs or sp.cancel(x_0 + turn * X - y(x)) != 0:
        raise DerivationError(f"{slope} is not the slope of F at x_0, or {limit} is about something else")
    in_order = {F(x): near.value + slope * distance, F(y(x)): near.value + slope * limit.rhs * distance}
    ratio_of = equation.rhs.xreplace(in_order)
    step("Theorem 1 is the first order", Eq(limit.lhs, ratio_of.subs(distance, 0)))
    second = sp.simplify(sp.diff(ratio_of, distance).subs(distance, 0))
    whole = sp.cancel(equation.lhs - limit.rhs) / X
    return Eq(Limit(sp.factor(whole), x, x_0, "-"), second, evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
