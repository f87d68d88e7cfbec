"""A symbolic solution for the range: impact time, range, and the parameter that removes W."""

import sympy as sp
from sympy import And, Eq, Equivalent, Interval, LambertW, Le, Limit, Lt, cos, exp, sin

from galileo_sym.derivations.projectile.notation import (
    HALF_TURN,
    RISING,
    U_OF_THETA,
    R,
    T,
    W_u,
    a,
    b,
    c,
    d,
    g,
    k,
    notation,
    output,
    q,
    s,
    t,
    theta,
    u,
    v,
    w,
    x,
    y,
)  # fmt: skip
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    Erratum,
    StrictlyDecreasing,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.tactics import (
    elementary_limit,
    isolate,
    monotone_on_half_line,
    other_branch,
    read_coefficients,
    sign_on,
    solve_linear_exponential,
    trig_box,
    undo,
)  # fmt: skip

chapter = Chapter("projectile.range", notation, "A symbolic solution for the range")

SHOT = {g: POSITIVE, v: POSITIVE, k: POSITIVE}
LAUNCH = Domain({**SHOT, theta: HALF_TURN}, where={u: U_OF_THETA})
U_OF_S = -s / (1 - exp(-s))
# impact times that are known without W: choose s = k t, and the u and g that belong to it
IMPACT = Domain({k: POSITIVE, s: POSITIVE}, where={t: s / k, u: U_OF_S})
LANDING = Domain(
    {v: POSITIVE, k: POSITIVE, theta: RISING, s: POSITIVE},
    where={t: s / k, g: k * v * sin(theta) / (-1 - U_OF_S)},
)
ALPHA_SIN = k * v / g * sin(theta)
UP_TO_MINUS_1 = Interval(-sp.oo, -1)


@chapter.derive(
    "projectile.impact.eq",
    Eq(-k * t + 1 + k * v / g * sin(theta) - exp(-k * t) * (1 + k * v / g * sin(theta)), 0),
    LANDING,
)
def impact_equation(drag__y):
    """The height is 0; multiply by k^2/g."""
    return Eq(sp.expand(drag__y.of(y(t)) * k**2 / g), 0, evaluate=False)


chapter.given("projectile.def.u", Eq(u, -1 - k * v / g * sin(theta)), Domain({**SHOT, theta: HALF_TURN}))


@chapter.derive("projectile.impact.eq-u", Eq(-k * t - u + exp(-k * t) * u, 0), IMPACT)
def impact_equation_in_u(impact__eq, def__u):
    """Substitute u for the sine."""
    sine = isolate(def__u.equation, sin(theta)).rhs
    return Eq(sp.expand(impact__eq.lhs.subs(sin(theta), sine)), impact__eq.rhs, evaluate=False)


@chapter.derive("projectile.impact.time", Eq(t, (-u + LambertW(u * exp(u))) / k), IMPACT)
def impact_time(impact__eq_u, res3, claim__domain_W):
    """Result (3) with a = -k, b = -u, c = u, d = -k."""
    for name, value in read_coefficients(impact__eq_u.equation, t).items():
        step(f"coefficient {name}", Eq(notation.symbols[name], value))
    exists = step("the argument of W is in its domain", claim__domain_W.subs(w, u))
    return solve_linear_exponential(res3.equation, (t, a, b, c, d), impact__eq_u.equation, t, exists)


@chapter.derive(
    "projectile.claim.u-le-minus1",
    And(Le(u, -1), Equivalent(Eq(u, -1), Eq(sin(theta), 0))),
    Domain({**SHOT, theta: HALF_TURN}),
)
def u_below_minus_1(def__u):
    """u falls with the sine, which is not negative."""
    sine = sp.Dummy("sine", nonnegative=True)
    top = def__u.rhs.subs(sin(theta), 0)
    fall = sp.diff(def__u.rhs.subs(sin(theta), sine), sine)
    inside = sign_on(sin(theta), trig_box(sin(theta), theta, HALF_TURN.interior))
    if not (fall.is_negative and inside > 0 and all(sin(end) >= 0 for end in HALF_TURN.boundary)):
        raise DerivationError(f"{def__u.rhs} does not fall as the sine grows from 0")
    step("u falls with the sine", Lt(fall, 0))
    return And(Le(u, top), Equivalent(Eq(u, top), Eq(sin(theta), 0)))


@chapter.derive(
    "projectile.claim.trivial-root",
    And(Eq(LambertW(u * exp(u), -1), u, evaluate=False), Eq((-u + LambertW(u * exp(u), -1)) / k, 0, evaluate=False)),
    Domain({k: POSITIVE, u: UP_TO_MINUS_1}),
)
def trivial_root(impact__time, claim__u_le_minus1, def__W, def__T, claim__T_monotone):
    """The other branch of W undoes T where u <= -1, and gives the launch itself."""
    round_trip = next(e for e in def__W.parts if isinstance(e, Eq) and e.lhs == T(LambertW(q, -1)))
    round_trip = Eq(def__T.of(T(w)).subs(w, round_trip.lhs.args[0]), round_trip.rhs, evaluate=False)
    values = next(e for e in def__W.parts if isinstance(e, Le) and e.lhs == LambertW(q, -1))
    falling = next(e for e in claim__T_monotone.parts if isinstance(e, StrictlyDecreasing))
    same = step("where W_{-1} undoes T", undo(falling, round_trip, values, u))
    below, identity = same.args if isinstance(same.args[0], Le) else same.args[::-1]
    if below not in claim__u_le_minus1.parts:
        raise DerivationError(f"{claim__u_le_minus1.statement} does not say that {below}")
    other = other_branch(impact__time.rhs)
    return And(identity, Eq(other, other.subs(identity.lhs, identity.rhs), evaluate=False))


@chapter.derive("projectile.range.exp", Eq(R(k, theta), v * cos(theta) * (1 - exp(u - W_u)) / k), LAUNCH)
def range_with_exponential(drag__x, impact__time):
    """Put the impact time into x(t)."""
    return Eq(R(k, theta), drag__x.of(x(t)).subs(t, impact__time.of(t)), evaluate=False)


@chapter.derive("projectile.range.expW", Eq(exp(-W_u), W_u / (u * exp(u))), Domain({u: UP_TO_MINUS_1}))
def exponential_of_w(res1):
    """(1) at x = u e^u, solved for the power of e."""
    power = sp.Dummy("power", positive=True)
    at_u = step("(1) at u e^u", res1.subs(q, u * exp(u)))
    (inverse,) = at_u.atoms(LambertW)
    return Eq(exp(-inverse), 1 / isolate(at_u.subs(exp(inverse), power), power).rhs, evaluate=False)


@chapter.derive("projectile.range.u", Eq(R(k, theta), v * cos(theta) * (1 - W_u / u) / k), LAUNCH)
def range_in_u(range__exp, range__expW):
    """Replace the power of e."""
    apart = sp.expand(range__exp.rhs)
    return Eq(R(k, theta), sp.expand(apart.subs(range__expW.lhs, range__expW.rhs)), evaluate=False)


@chapter.derive(
    "projectile.range.full",
    Eq(R(k, theta), v * cos(theta) / k * (1 + LambertW((-1 - ALPHA_SIN) * exp(-1 - ALPHA_SIN)) / (1 + ALPHA_SIN))),
    Domain({**SHOT, theta: HALF_TURN}),
)
def full_range(range__u, def__u):
    """Substitute for u."""
    return Eq(R(k, theta), range__u.rhs.subs(u, def__u.of(u)), evaluate=False)


OUTPUT = v * cos(theta) * exp(
    -(
        g
        + g * LambertW(-exp(-1 - k * v * sin(theta) / g) * (g + k * v * sin(theta)) / g)
        + k * v * sin(theta)
    )
    / g
)  # fmt: skip


@chapter.derive(
    "projectile.mathematica.range",
    And(Eq(output, OUTPUT), Eq(R(k, theta), (v * cos(theta) - output) / k)),
    Domain({**SHOT, theta: HALF_TURN}),
    erratum=Erratum(
        ("S3",),
        "x[t_] must be v Cos[theta] (1 - E^(-k t))/k: what is printed is the velocity x'(t), so that the output is "
        "x' at impact, and R = (v cos(theta) - output)/k",
        Eq(R(k, theta), OUTPUT),
    ),
)
def mathematica_output(drag__vx, drag__x, impact__time, def__u):
    """The commands as printed put the impact time into the velocity; x(t) is (v cos(theta) - x'(t))/k."""
    put_out = drag__vx.rhs.subs(t, impact__time.of(t)).subs(u, def__u.of(u))
    place = isolate(drag__vx.equation.subs(drag__vx.lhs, output), exp(-k * t)).rhs
    return And(Eq(output, put_out), Eq(R(k, theta), sp.expand(drag__x.of(x(t)).subs(exp(-k * t), place))))


@chapter.derive(
    "projectile.support.s-param",
    And(
        Eq(s, k * t),
        Eq(u, -s / (1 - exp(-s))),
        Eq(W_u, u + s),
        Eq(W_u, -s / (exp(s) - 1)),
        Eq(sp.Derivative(W_u, u), -(s - 1 + exp(-s)) / (exp(s) - 1 - s)),
    ),
    IMPACT,
)
def parameter(impact__time, range__expW):
    """With s = k t the impact time reads W = u + s, and then W/u = e^(u - W) = e^(-s) gives u."""
    inverse = sp.Dummy("inverse", real=True)
    named = step("name k t", Eq(s, k * t, evaluate=False))
    linear = Eq(s, (named.rhs.subs(t, impact__time.of(t))).expand().subs(W_u, inverse), evaluate=False)
    w_of_u = isolate(linear, inverse).rhs
    power = sp.Dummy("power", positive=True)
    product = isolate(range__expW.equation.subs(W_u, inverse).subs(exp(-inverse), power), inverse).rhs
    condition = Eq(w_of_u, product.subs(power, exp(-w_of_u)), evaluate=False)
    step("(1) in u and s", condition)
    u_of_s = isolate(condition, u).rhs
    w_of_s = sp.simplify(w_of_u.subs(u, u_of_s))
    slope = sp.simplify(sp.diff(w_of_s, s) / sp.diff(u_of_s, s))
    return And(named, Eq(u, u_of_s), Eq(W_u, w_of_u), Eq(W_u, w_of_s), Eq(sp.Derivative(W_u, u), slope))


@chapter.derive(
    "projectile.support.u-bijection",
    And(
        StrictlyDecreasing(-s / (1 - exp(-s)), s, Interval.open(0, sp.oo)),
        Eq(Limit(-s / (1 - exp(-s)), s, 0, "+"), -1),
        Eq(Limit(-s / (1 - exp(-s)), s, sp.oo), -sp.oo),
    ),
    Domain({}),
)
def bijection(support__s_param):
    """u falls from -1 to -oo as s grows from 0."""
    u_of_s = support__s_param.of(u)
    falling = monotone_on_half_line(u_of_s, s, Interval.open(0, sp.oo))
    ends = [(0, Limit(u_of_s, s, 0, "+")), (sp.oo, Limit(u_of_s, s, sp.oo))]
    return And(falling, *(Eq(limit, elementary_limit(u_of_s, s, end)) for end, limit in ends))


if __name__ == "__main__":
    tell_chapter(chapter.name)
