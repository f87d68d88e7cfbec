"""A target on a slope y = x tan(beta) through the launch point: the impact equation again, with another u."""

import sympy as sp
from sympy import And, Eq, Equivalent, Gt, Interval, Limit, Lt, Or, cos, exp, pi, sin, tan
from sympy.simplify.fu import TR10i

from galileo_sym.derivations.beyond.notation import beta, lift, notation, reach, time
from galileo_sym.derivations.projectile.notation import (
    BEYOND,
    HALF_TURN,
    RISING,
    R,
    W_u,
    a,
    b,
    c,
    d,
    g,
    k,
    s,
    t,
    theta,
    u,
    v,
    w,
    x,
    y,
)
from galileo_sym.ledger import NONNEGATIVE, POSITIVE, Chapter, DerivationError, Domain, step, tell_chapter
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    isolate,
    limit_by_parameter,
    read_coefficients,
    sign_on,
    solve_linear_exponential,
    trig_box,
)

chapter = Chapter("beyond.slopes", notation, "What the papers leave open: a target on a slope")

FREE = {g: POSITIVE, v: POSITIVE, theta: HALF_TURN, beta: Interval.open(-pi / 2, theta)}  # launched above the slope
SHOT = {k: POSITIVE, **FREE}
LIFT = sin(theta - beta) / cos(beta)
TIME = (-u + W_u) / k
REACH = v * cos(theta) / (k * cos(beta)) * (1 - W_u / u)
U_OF_LIFT = -1 - k * v / g * lift
PUT = {u: U_OF_LIFT, lift: LIFT}
LANDED = TIME.subs(u, U_OF_LIFT.subs(lift, LIFT))
ABOVE = g / k**2 * (-k * t - u + u * exp(-k * t))


@chapter.derive(
    "beyond.slopes.height",
    And(Eq(u, -1 - k * v / g * (sin(theta) - cos(theta) * tan(beta))), Eq(y(t), x(t) * tan(beta) + ABOVE)),
    Domain({**SHOT, t: NONNEGATIVE}),
)
def height(drag__x, drag__y):
    """The height above the slope; u names the coefficient of the exponential, times k^2/g."""
    above = sp.expand((drag__y.of(y(t)) - drag__x.of(x(t)) * tan(beta)) * k**2 / g)
    power = exp(-k * t)
    value = above.coeff(power)
    sine = isolate(Eq(u, value, evaluate=False), sin(theta)).rhs
    rest = sp.expand((above - value * power).subs(sin(theta), sine))
    found = x(t) * tan(beta) + g / k**2 * (rest + u * power)
    return And(Eq(u, value), Eq(y(t), found, evaluate=False))


def _turned(climb):
    """sin(theta) - cos(theta) tan(beta), or a multiple, with the difference of the angles: top and bottom."""
    top, bottom = sp.fraction(sp.together(sp.expand(climb).subs(tan(beta), sin(beta) / cos(beta))))
    scale, angles = sp.factor(top).as_independent(theta, beta, as_Add=False)
    return scale * TR10i(sp.expand(angles)), bottom


@chapter.derive("beyond.slopes.u", And(Eq(lift, LIFT), Eq(u, U_OF_LIFT), Lt(u, -1)), Domain(SHOT, where={lift: LIFT}))
def below_minus_1(beyond__slopes__height):
    """sin(theta) - cos(theta) tan(beta) is sin(theta - beta)/cos(beta), and 0 < theta - beta < pi."""
    value = beyond__slopes__height.of(u)
    turned, bottom = _turned((-1 - value) * g / (k * v))
    angle = sp.Dummy("angle", real=True)
    positive = sign_on(sin(angle), trig_box(sin(angle), angle, Interval.open(0, pi)))
    upright = sign_on(bottom, trig_box(bottom, beta, Interval.open(-pi / 2, pi / 2)))
    if turned != sin(theta - beta) or (positive, upright) != (1, 1):
        raise DerivationError(f"the sign of {turned}/{bottom} is open")
    step("above the slope", Gt(turned, 0, evaluate=False))
    named = sp.expand(-1 - k * v / g * lift)
    beyond = named - sp.expand(named.subs(lift, 0))
    if not beyond.is_negative or is_zero(value - named.subs(lift, turned / bottom)) is None:
        raise DerivationError(f"u is {value}")
    return And(Eq(lift, turned / bottom), Eq(u, named), Lt(u, named.subs(lift, 0)))


@chapter.derive("beyond.slopes.time", Eq(time, TIME), Domain(SHOT, where={**PUT, t: LANDED, time: LANDED}))
def landing(beyond__slopes__height, res3, claim__domain_W):
    """On the slope the height above it is 0: result (3) with a = -k, b = -u, c = u, d = -k."""
    above = beyond__slopes__height.of(y(t)) - x(t) * tan(beta)
    equation = step("the slope is hit", Eq(sp.expand(above * k**2 / g), 0, evaluate=False))
    for name, value in read_coefficients(equation, t).items():
        step(f"coefficient {name}", Eq(notation.symbols[name], value))
    exists = step("the argument of W is in its domain", claim__domain_W.subs(w, u))
    found = solve_linear_exponential(res3.equation, (t, a, b, c, d), equation, t, exists)
    return Eq(time, found.rhs, evaluate=False)


@chapter.derive(
    "beyond.slopes.roots",
    And(Equivalent(Eq(ABOVE, 0), Or(Eq(t, 0), Eq(t, TIME))), Gt(TIME, 0)),
    Domain({g: POSITIVE, k: POSITIVE, u: BEYOND, t: sp.Union(NONNEGATIVE, sp.FiniteSet(TIME), evaluate=False)}),
)
def branch(beyond__slopes__height, beyond__slopes__u, beyond__slopes__time, beyond__real_roots__impact):
    """u < -1: the root by W_{-1} is the launch, that by W is positive, and there is no other."""
    if Lt(u, -1) not in beyond__slopes__u.parts:
        raise DerivationError(f"{beyond__slopes__u.statement} does not say that u < -1")
    above = beyond__slopes__height.of(y(t)) - x(t) * tan(beta)
    same, after = sorted(beyond__real_roots__impact.parts, key=lambda e: isinstance(e, Gt))
    zero, roots = sorted(same.args, key=lambda e: isinstance(e, Or))
    factor = sp.simplify(above / zero.lhs)
    if not (isinstance(zero, Eq) and factor.is_positive) or is_zero(factor * zero.lhs - above) is None:
        raise DerivationError(f"{above} is not a multiple of {zero}")
    if is_zero(after.lhs - beyond__slopes__time.of(time)) is None:
        raise DerivationError(f"{after} is not about {beyond__slopes__time.statement}")
    return And(Equivalent(Eq(above, zero.rhs, evaluate=False), roots), after)


@chapter.derive(
    "beyond.slopes.range",
    Eq(reach, REACH),
    Domain(SHOT, where={**PUT, reach: v * cos(theta) * (1 - exp(-k * LANDED)) / (k * cos(beta))}),
)
def along(drag__x, beyond__slopes__time, range__expW):
    """x where the slope is hit, over cos(beta)."""
    across = sp.expand(drag__x.of(x(t)).subs(t, beyond__slopes__time.of(time)))
    if not across.has(range__expW.lhs):
        raise DerivationError(f"{across} has no {range__expW.lhs}")
    return Eq(reach, sp.expand(across.subs(range__expW.lhs, range__expW.rhs) / cos(beta)), evaluate=False)


@chapter.derive(
    "beyond.slopes.level",
    And(Eq(u, -1 - k * v / g * sin(theta)), Eq(time, TIME), Eq(reach, v * cos(theta) * (1 - W_u / u) / k)),
    Domain({g: POSITIVE, v: POSITIVE, k: POSITIVE, theta: RISING}, where={beta: sp.S.Zero}),
)
def level(beyond__slopes__u, beyond__slopes__time, beyond__slopes__range, def__u, impact__time, range__u):
    """On a level slope, beta = 0, the formulas are the paper's."""
    at_0 = beyond__slopes__u.of(u).subs(lift, beyond__slopes__u.of(lift)).subs(beta, 0)
    flat = [(at_0, def__u.of(u))]
    flat += [(beyond__slopes__time.of(time).subs(beta, 0), impact__time.of(t))]
    flat += [(beyond__slopes__range.of(reach).subs(beta, 0), range__u.of(R(k, theta)))]
    for found, printed in flat:
        if is_zero(found - printed) is None:
            raise DerivationError(f"{found} is not the paper's {printed}")
    return And(*(Eq(name, found, evaluate=False) for name, (found, _) in zip((u, time, reach), flat, strict=True)))


@chapter.derive(
    "beyond.slopes.free",
    And(Eq(time, 2 * v * LIFT / g), Eq(reach, 2 * v**2 * cos(theta) * sin(theta - beta) / (g * cos(beta) ** 2))),
    Domain(FREE, where={t: 2 * v * LIFT / g, time: t, reach: v * cos(theta) * t / cos(beta)}),
)
def free(nodrag__x, nodrag__y):
    """Without resistance: y = x tan(beta), the launch left out."""
    hit = Eq(sp.expand(nodrag__y.of(y(t)) - nodrag__x.of(x(t)) * tan(beta)), 0, evaluate=False)
    found = isolate(hit, t, drop={sp.S.Zero: "the launch itself"})
    step("the slope is hit when", hit)
    top, bottom = _turned(found.rhs)
    length = nodrag__x.of(x(t)).subs(t, top / bottom) / cos(beta)
    return And(Eq(time, top / bottom, evaluate=False), Eq(reach, length, evaluate=False))


@chapter.derive(
    "beyond.slopes.limit",
    And(
        Eq(Limit(TIME.subs(u, U_OF_LIFT), k, 0, "+"), 2 * v * LIFT / g),
        Eq(
            Limit(REACH.subs(u, U_OF_LIFT), k, 0, "+"),
            2 * v**2 * cos(theta) * sin(theta - beta) / (g * cos(beta) ** 2),
        ),
    ),
    Domain(FREE, where={lift: LIFT}),
)
def little_resistance(
    beyond__slopes__time, beyond__slopes__range, beyond__slopes__u, beyond__slopes__free, support__s_param
):
    """Through s = k t: W = u + s and u = -s/(1 - e^(-s)), so that k is a function of s."""
    u_of_k, u_of_s = beyond__slopes__u.of(u), support__s_param.of(u)
    w_of_s = next(e.rhs for e in support__s_param.parts if e.lhs == W_u and e.has(u + s))
    number, path = sp.Symbol("number", positive=True), sp.expand(-1 - u_of_s)  # -1 - u, a multiple of k
    k_of_number = isolate(Eq(number, sp.expand(-1 - u_of_k), evaluate=False), k).rhs
    found = []
    for name, told in ((time, beyond__slopes__time), (reach, beyond__slopes__range)):
        form = told.of(name)
        in_s = sp.cancel(form.subs(W_u, w_of_s)).subs(u, u_of_s).subs(k, k_of_number)
        scale, pure = in_s.as_independent(s, number, as_Add=False)
        near = scale * limit_by_parameter(pure.subs(number, path), number, 0, "+", s, path, 0)
        limit = near.subs(lift, beyond__slopes__u.of(lift))
        if is_zero(limit - beyond__slopes__free.of(name)) is None:
            raise DerivationError(f"{limit} is not {beyond__slopes__free.of(name)}, that without resistance")
        found.append(Eq(Limit(form.subs(u, u_of_k), k, 0, "+"), limit, evaluate=False))
    return And(*found)


if __name__ == "__main__":
    tell_chapter(chapter.name)
