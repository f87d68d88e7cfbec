"""A limit theorem for inverse functions and its application: the corollary, and the range as resistance goes to 0."""

import sympy as sp
from sympy import And, Derivative, Eq, Ge, Implies, Interval, LambertW, Limit, cos, sin

from galileo_sym.derivations.projectile import analytic_notation as theorem
from galileo_sym.derivations.projectile.notation import (
    BEYOND,
    HALF_TURN,
    RISING,
    SHOT,
    SLOPE,
    TRIAL,
    R,
    T,
    U,
    W_u,
    Y,
    g,
    k,
    notation,
    q,
    s,
    theta,
    u,
    v,
    w,
)  # fmt: skip
from galileo_sym.ledger import (
    ONE,
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    ForAll,
    StrictlyDecreasing,
    StrictlyIncreasing,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    entire_series,
    everywhere,
    extremum_between,
    isolate,
    limit_along,
    limit_by_parameter,
    limit_with_part,
    modus_ponens,
    said_of,
    sign_on,
    trig_box,
    undo,
)  # fmt: skip

letters = notation.extended()
index = letters.symbol("i", ONE, "index of a power series", integer=True, nonnegative=True)
chapter = Chapter("projectile.small_resistance", letters, "A limit theorem for inverse functions and its application")

TURN = (W_u + 1) / (u + 1)
INNER = (W_u - u) / (u * (u + 1))
INNER_LIMIT = Limit(INNER, u, -1, "-")
COROLLARY = Eq(Limit(TURN, u, -1, "-"), -1)
NO_RESISTANCE = Limit(R(k, theta), k, 0, "+")
LAUNCH = Domain({**SHOT, theta: RISING}, where=TRIAL)
LEVEL = Domain({**SHOT, theta: sp.FiniteSet(0), u: sp.FiniteSet(-1)}, where=TRIAL)
SPEEDS = {g: POSITIVE, v: POSITIVE}


NEAR_MINUS_1 = {w: Interval.Ropen(-sp.Rational(3, 2), -1), index: sp.FiniteSet(0, 1, 2, 5)}


@chapter.derive("projectile.thm1.cor", COROLLARY, Domain(NEAR_MINUS_1))
def corollary(thm1, def__T, claim__T_monotone, def__W):
    """Theorem 1 for T about -1, where it has an extremum: there N = 2. W undoes T up to -1/2, where T < 0."""
    body = def__T.of(T(w))
    parts = {type(claim): claim for claim in claim__T_monotone.parts}
    extremum = step("an extremum", extremum_between(parts[StrictlyDecreasing], parts[StrictlyIncreasing]))
    place = extremum.args[2]
    entire = step("an entire function", entire_series(body, w, place, index))
    coefficient = entire.args[3]
    order = next(n for n in range(1, 9) if coefficient.subs(index, n) != 0)
    values = next(e for e in def__W.parts if isinstance(e, Ge))
    functions = {
        theorem.f(w): body,
        theorem.a(index): coefficient,
        theorem.g(q): values.lhs,
        theorem.y(w): values.lhs.subs(q, body),
    }
    numbers = {theorem.x_0: place, theorem.N: sp.Integer(order), theorem.h: sp.S.Half}
    of_t = said_of(thm1.statement, functions, {theorem.x: w, **numbers})
    told = next(e for e in def__W.parts if isinstance(e, Eq) and e.lhs == T(values.lhs))
    round_trip = said_of(told, {T(w): body}, {})
    right, both = Interval(place, place + sp.S.Half), Interval(place - sp.S.Half, place + sp.S.Half)
    known = (
        step("its Taylor series", everywhere(entire, w, both)),
        step("W undoes T", everywhere(undo(parts[StrictlyIncreasing], round_trip, values, w), w, right)),
        extremum,
    )
    limit = next(e for e in modus_ponens(of_t, _with_facts(of_t, known)).args if e.has(Limit))
    return Eq(limit.lhs.xreplace({w: u}), limit.rhs)


def _with_facts(applied, known):
    """What is known, with those hypotheses about numbers and identities that are true by themselves."""
    return (*known, *(e for e in sp.And.make_args(applied.args[0]) if _plain(e)))


def _plain(hypothesis):
    if isinstance(hypothesis, theorem.AllZero):
        term, index, first, last = hypothesis.args
        return all(term.subs(index, n) == 0 for n in range(first, last + 1))
    if isinstance(hypothesis, sp.Ne):
        return bool((hypothesis.lhs - hypothesis.rhs).is_nonzero)
    if isinstance(hypothesis, ForAll):
        return _plain(hypothesis.args[0])
    return isinstance(hypothesis, Eq) and hypothesis.lhs == hypothesis.rhs


@chapter.derive("beyond.thm1.cor-by-parameter", COROLLARY, Domain({}))
def corollary_by_parameter(support__s_param):
    """Without Theorem 1: with u = u(s), W = u + s, the limit is one of elementary functions."""
    u_of_s = support__s_param.of(u)
    in_s = TURN.subs(W_u, support__s_param.of(W_u)).subs(u, u_of_s)
    found = limit_by_parameter(in_s, u, -1, "-", s, u_of_s, 0)
    step("in the parameter", Eq(Limit(in_s, s, 0, "+"), found, evaluate=False))
    return Eq(Limit(TURN, u, -1, "-"), found, evaluate=False)


INVERSE_K = Eq(1 / k, -v * sin(theta) / (g * (u + 1)))
REWRITTEN = And(
    Eq(R(k, theta), -(v**2) * sin(theta) * cos(theta) / (g * (1 + u)) * (1 - W_u / u)),
    Eq(R(k, theta), v**2 / g * sin(theta) * cos(theta) * INNER),
)
NOT_LEVEL = "not at theta = 0, where u = -1 for every k and this is 0/0; the range is 0 there"


@chapter.derive("projectile.limit.inv-k", INVERSE_K, LAUNCH, erratum=Erratum(("S5",), NOT_LEVEL, INVERSE_K, LEVEL))
def inverse_of_k(def__u):
    """Solve the definition of u for k."""
    return Eq(1 / k, 1 / isolate(def__u.equation, k).rhs)


@chapter.derive(
    "projectile.limit.range-rewrite", REWRITTEN, LAUNCH, erratum=Erratum(("S5",), NOT_LEVEL, REWRITTEN, LEVEL)
)
def range_without_k(range__u, limit__inv_k):
    """Put 1/k in, then bring 1 - W/u to one denominator."""
    put = range__u.rhs.subs(1 / k, limit__inv_k.of(1 / k))
    top, bottom = sp.fraction(sp.together(put))
    lead = sp.expand(top).coeff(W_u)
    return And(Eq(R(k, theta), put), Eq(R(k, theta), sp.cancel(top / lead) * sp.factor(lead / bottom)))


@chapter.derive(
    "projectile.limit.statement",
    Eq(NO_RESISTANCE, v**2 / g * sin(theta) * cos(theta) * INNER_LIMIT),
    Domain({**SPEEDS, theta: RISING}, where=TRIAL),
    erratum=Erratum(("S5",), "u approaches -1 from below if sin(theta) > 0; at theta = 0 both sides are 0"),
)
def limit_in_u(limit__range_rewrite, def__u):
    """As k goes to 0 from above, u goes to -1 from below, since the sine is positive; the rest does not have k."""
    sine = sp.Dummy("sine", positive=True)
    if sign_on(sin(theta), trig_box(sin(theta), theta, RISING)) < 0:
        raise DerivationError("the sine is not positive")
    form = next(e.rhs for e in limit__range_rewrite.parts if not e.rhs.has(W_u / u))
    constant, inner = form.as_independent(u, as_Add=False)
    limit = Limit(inner, u, -1, "-")
    named = Eq(limit, limit, evaluate=False)
    along = limit_along(named, k, def__u.of(u).subs(sin(theta), sine), 0)
    if constant.has(k):
        raise DerivationError(f"{constant} depends on k")
    return Eq(NO_RESISTANCE, constant * along, evaluate=False)


@chapter.derive("projectile.limit.rewrite", Eq(INNER, ((W_u + 1) / (u + 1) - 1) / u), Domain({u: BEYOND}))
def in_terms_of_turn(limit__statement):
    """Write W as rho (u + 1) - 1."""
    rho, value = sp.Dummy("rho", real=True), sp.Dummy("value", real=True)
    (limit,) = limit__statement.rhs.atoms(Limit)
    inner = limit.args[0]
    of_rho = isolate(Eq(rho, TURN.subs(W_u, value), evaluate=False), value).rhs
    form = sp.cancel(inner.subs(W_u, of_rho))
    if form.free_symbols != {rho, u} or form.has(LambertW):
        raise DerivationError(f"{inner} is not a function of u and {TURN} alone")
    return Eq(inner, form.subs(rho, TURN), evaluate=False)


@chapter.derive("projectile.limit.value2", Eq(INNER_LIMIT, 2), Domain({}))
def value_2(limit__rewrite, thm1__cor):
    """The corollary gives the limit of the inner ratio, and u goes to -1."""
    rho = sp.Dummy("rho", real=True)
    ratio, *place = thm1__cor.lhs.args
    value = limit_with_part(limit__rewrite.rhs.subs(ratio, rho), rho, thm1__cor.rhs, *place[:2], str(place[2]))
    return Eq(Limit(limit__rewrite.lhs, *place), value)


@chapter.derive(
    "projectile.limit.nodrag",
    Eq(NO_RESISTANCE, 2 * v**2 / g * sin(theta) * cos(theta)),
    Domain({**SHOT, theta: HALF_TURN}, where=TRIAL),
)
def no_resistance(limit__statement, limit__value2, nodrag__range, range__u, def__u):
    """Put the 2 in: the range without resistance. At theta = 0, which was left out, both ranges are 0."""
    found = limit__statement.rhs.subs(limit__value2.lhs, limit__value2.rhs)
    if is_zero(found - nodrag__range.of(R(theta))) is None:
        raise DerivationError(f"{found} is not the range without resistance")
    level = range__u.rhs.subs(u, def__u.of(u)).subs(theta, 0)
    step("at theta = 0", Implies(Eq(theta, 0), Eq(R(k, theta), level)))
    if level != found.subs(theta, 0):
        raise DerivationError(f"at theta = 0 the range is {level} for every k")
    return Eq(limit__statement.lhs, found)


@chapter.derive("projectile.mathematica.limit", Eq(INNER_LIMIT, 2), Domain({}))
def mathematica_limit(limit__value2, support__s_param):
    """What the command asks for, from below, by s = k t in the place of W; it agrees with the value by Theorem 1."""
    asked, *place = limit__value2.lhs.args
    u_of_s = support__s_param.of(u)
    in_s = sp.simplify(asked.subs(W_u, support__s_param.of(W_u)).subs(u, u_of_s))
    found = limit_by_parameter(in_s, u, place[1], str(place[2]), s, u_of_s, 0)
    step("in the parameter", Eq(Limit(in_s, s, 0, "+"), found, evaluate=False))
    if found != limit__value2.rhs:
        raise DerivationError(f"by the parameter it is {found}, by Theorem 1 {limit__value2.rhs}")
    return Eq(limit__value2.lhs, found)


@chapter.derive(
    "projectile.support.slope-at-0",
    Eq(Limit(Derivative(R(k, theta), theta), theta, 0, "+"), 2 * v**2 / g),
    Domain(SHOT, where=TRIAL),
)
def slope_at_ground(lemma__f, lemma__c__slope_limit, limit__value2, def__uyR):
    """In Lemma (f) 1 - y/u is -(u + 1) times what tends to 2, and dy/du tends to -1, as u does."""
    shortfall, rho, slope = 1 - Y / u, sp.Dummy("rho", real=True), sp.Dummy("slope", real=True)
    ratio = limit__value2.lhs.args[0].subs(W_u, Y)
    height = isolate(Eq(rho, ratio.subs(Y, slope), evaluate=False), slope).rhs
    rest = sp.cancel(lemma__f.rhs.subs(SLOPE, slope) / shortfall * sp.cancel(1 - height / u) / rho)
    if rest.has(Y) or rest.has(rho):
        raise DerivationError(f"{lemma__f.rhs} is not a multiple of {shortfall}")
    path = def__uyR.of(U(k, theta))
    known = next(e for e in lemma__c__slope_limit.parts if not e.rhs.has(Limit))
    steep, first = (limit_along(e, theta, path, 0) for e in (known, limit__value2.equation))
    other = limit_with_part(sp.simplify(rest.subs(u, path)), slope, steep, theta, 0)
    return Eq(Limit(lemma__f.lhs, theta, 0, "+"), sp.simplify(first * other))


if __name__ == "__main__":
    tell_chapter(chapter.name)
