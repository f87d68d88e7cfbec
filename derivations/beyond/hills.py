"""Launch from a height h above the ground: a t + b + c e^(d t) = 0 again, and the other root is before the launch."""

import sympy as sp
from sympy import And, Eq, Equivalent, Ge, Gt, Interval, LambertW, Le, Limit, Lt, Or, cos, exp, sin, sqrt

from galileo_sym.derivations.beyond.notation import eta, h, notation, reach, time
from galileo_sym.derivations.projectile.notation import (
    HALF_TURN,
    RISING,
    R,
    T,
    W_u,
    a,
    b,
    c,
    d,
    g,
    k,
    q,
    s,
    t,
    theta,
    u,
    v,
    w,
    x,
    y,
)
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    REAL,
    Chapter,
    DerivationError,
    Domain,
    StrictlyDecreasing,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    arguments_reversed,
    elementary_limit,
    isolate,
    read_coefficients,
    solve_linear_exponential,
)

chapter = Chapter("beyond.hills", notation, "What the papers leave open: launch from a height")

FREE = {g: POSITIVE, v: POSITIVE, theta: HALF_TURN}
SHOT = {k: POSITIVE, **FREE}
HIGH = {**SHOT, h: POSITIVE}
U, ETA = -1 - k * v / g * sin(theta), k**2 * h / g
NAMES = {u: U, eta: ETA}
ARGUMENT = u * exp(u - eta)
W_HILL, W_OTHER = LambertW(ARGUMENT), LambertW(ARGUMENT, -1)
TIME, BEFORE = (eta - u + W_HILL) / k, (eta - u + W_OTHER) / k
REACH = v * cos(theta) / k * (1 - W_HILL / u)
ABOVE = g / k**2 * (-k * t + eta - u + u * exp(-k * t))
LANDED = TIME.subs(NAMES)


@chapter.derive(
    "beyond.hills.height",
    And(Eq(eta, ETA), Eq(y(t), ABOVE - h)),
    Domain({**SHOT, h: NONNEGATIVE, t: NONNEGATIVE}, where=NAMES),
)
def height(drag__y, def__u):
    """The height above the ground, times k^2/g, with u for the sine and eta for k^2 h/g."""
    above = sp.expand((drag__y.of(y(t)) + h) * k**2 / g)
    number = above.coeff(h) * h
    sine = isolate(def__u.equation, sin(theta)).rhs
    found = sp.expand(above.subs(sin(theta), sine)).subs(h, sp.solve(number - eta, h)[0])
    return And(Eq(eta, number), Eq(y(t), g / k**2 * sp.expand(found) - h, evaluate=False))


def _above(told):
    """The height above the ground."""
    return told.of(y(t)) + h


def _landing(told):
    """The ground is hit: the height above it, times k^2/g, is 0."""
    return Eq(sp.expand(_above(told) * k**2 / g), 0, evaluate=False)


def _argument(told):
    """The argument of W that belongs to coefficients."""
    return sp.powsimp(sp.expand(told.c * told.d / told.a) * exp(-told.b * told.d / told.a))


@chapter.derive(
    "beyond.hills.argument",
    And(Ge(ARGUMENT, -exp(-1)), Lt(ARGUMENT, 0, evaluate=False)),
    Domain({**SHOT, h: NONNEGATIVE}, where=NAMES),
)
def argument(claim__domain_W, beyond__hills__height):
    """u e^(u - eta) is between u e^u, which is at least -1/e, and 0, as u < 0 and eta >= 0."""
    least = claim__domain_W.subs(w, u)
    value = _argument(read_coefficients(_landing(beyond__hills__height), t))
    shrunk = sp.simplify(value / least.lhs)
    more = sp.Dummy("more", nonnegative=True)
    fall = sp.diff(shrunk.subs(eta, more), more)
    if not (fall.is_negative and shrunk.subs(eta, 0) == 1 and least.lhs.is_negative and isinstance(least, Ge)):
        raise DerivationError(f"{value} is not between {least.lhs} and 0")
    step("a share of u e^u", And(Gt(shrunk, 0, evaluate=False), Le(shrunk, 1, evaluate=False)))
    return And(Ge(value, least.rhs, evaluate=False), Lt(value, 0, evaluate=False))


@chapter.derive(
    "beyond.hills.time", Eq(time, TIME), Domain({**SHOT, h: NONNEGATIVE}, where={**NAMES, t: LANDED, time: LANDED})
)
def landing(beyond__hills__height, res3, beyond__hills__argument):
    """On the ground the height is 0: result (3) with a = -k, b = eta - u, c = u, d = -k."""
    equation = step("the ground is hit", _landing(beyond__hills__height))
    for name, value in read_coefficients(equation, t).items():
        step(f"coefficient {name}", Eq(notation.symbols[name], value))
    exists = next(e for e in beyond__hills__argument.parts if isinstance(e, Ge))
    return Eq(time, solve_linear_exponential(res3.equation, (t, a, b, c, d), equation, t, exists).rhs, evaluate=False)


AFTERWARDS = Domain(
    {
        g: POSITIVE,
        k: POSITIVE,
        eta: POSITIVE,
        u: Interval(-sp.oo, -1),
        t: sp.Union(REAL, sp.FiniteSet(TIME, BEFORE), evaluate=False),
    }
)


@chapter.derive(
    "beyond.hills.roots",
    And(
        Equivalent(Eq(ABOVE, 0), Or(Eq(t, TIME, evaluate=False), Eq(t, BEFORE, evaluate=False))),
        Gt(TIME, 0, evaluate=False),
        Lt(BEFORE, 0, evaluate=False),
    ),
    AFTERWARDS,
)
def roots(
    beyond__hills__height,
    beyond__real_roots__two,
    claim__u_le_minus1,
    claim__domain_W,
    def__W,
    def__T,
    claim__T_monotone,
):
    """For h > 0: W >= -1 >= u gives k t >= eta > 0; T(u - eta) < u e^(u - eta), T falling, gives W_{-1} < u - eta."""
    above = _above(beyond__hills__height)
    told = read_coefficients(_landing(beyond__hills__height), t)
    value = _argument(told)
    high, below = sp.Dummy("high", positive=True), claim__u_le_minus1.parts
    least, bound = claim__domain_W.subs(w, u), next(e for e in below if isinstance(e, Le))
    grows = sp.diff(value, eta).is_positive and is_zero(value.subs(eta, 0) - least.lhs)
    if not (grows and value.is_negative and isinstance(least, Ge) and bound == Le(u, -1)):
        raise DerivationError(f"{value} is not shown to lie between {least.rhs} and 0")
    step("above -1/e", Gt(value, least.rhs, evaluate=False))
    put = {**{notation.symbols[name]: coefficient for name, coefficient in told.items()}, q: value}
    found = next(e for e in beyond__real_roots__two.statement.args if isinstance(e, Or))
    times = [sp.expand(e.rhs.subs(put, simultaneous=True), deep=False) for e in found.args]
    by_w, by_other = sorted(times, key=lambda e: e.has(LambertW(value, -1)))
    after = next(e for e in def__W.parts if isinstance(e, Ge) and e.lhs == LambertW(q))
    margin = sp.expand(k * by_w.subs(LambertW(value), after.rhs)).subs(u, bound.rhs)
    if not (margin.subs(eta, high).is_positive and sp.diff(by_w.subs(LambertW(value), w), w).is_positive):
        raise DerivationError(f"{by_w} is not shown to be after the launch")
    falling = next(e for e in claim__T_monotone.parts if isinstance(e, StrictlyDecreasing))
    trip = next(e for e in def__W.parts if isinstance(e, Eq) and e.lhs == T(LambertW(q, -1)))
    ends = next(e for e in def__W.parts if isinstance(e, Le) and e.lhs == LambertW(q, -1))
    low, root = u - eta, LambertW(value, -1)
    lower = step("a value below", Lt(def__T.of(T(w)).subs(w, low), value, evaluate=False))
    if not sp.factor(sp.expand(lower.lts - lower.gts)).subs(eta, high).is_negative:
        raise DerivationError(f"{lower} is not known")
    image = Eq(def__T.of(T(w)).subs(w, root), trip.rhs.subs(q, value), evaluate=False)
    inside = [Le(low, bound.rhs, evaluate=False), Le(root, ends.rhs, evaluate=False)]
    less = arguments_reversed(falling, lower, low, image, root, inside)
    if is_zero(by_other - (less.lts - less.gts) / k) is None:
        raise DerivationError(f"{less} does not tell the sign of {by_other}")
    pair = Or(*(Eq(t, root, evaluate=False) for root in (by_w, by_other)))
    signs = Gt(by_w, 0, evaluate=False), Lt(by_other, 0, evaluate=False)
    return And(Equivalent(Eq(above, 0, evaluate=False), pair), *signs)


@chapter.derive(
    "beyond.hills.range",
    Eq(reach, REACH),
    Domain({**SHOT, h: NONNEGATIVE}, where={**NAMES, reach: v * cos(theta) * (1 - exp(-k * LANDED)) / k}),
)
def distance(drag__x, beyond__hills__time, res1):
    """x where the ground is hit, with the power of e by result (1)."""
    (inverse,) = beyond__hills__time.of(time).atoms(LambertW)
    root, power = sp.Dummy("root", real=True), sp.Dummy("power", positive=True)
    product = res1.equation.subs(q, inverse.args[0]).subs(exp(inverse), power)
    growth = isolate(product, power).rhs.subs(inverse, root)
    there = drag__x.of(x(t)).subs(t, beyond__hills__time.of(time).subs(inverse, root))
    apart = sp.powsimp(sp.expand(sp.expand(there).subs(exp(-root), 1 / growth)))
    return Eq(reach, apart.subs(root, inverse), evaluate=False)


@chapter.derive(
    "beyond.hills.level",
    And(
        Eq(time, (-u + W_u) / k),
        Eq(reach, v * cos(theta) * (1 - W_u / u) / k),
        Eq((-u + LambertW(u * exp(u), -1)) / k, 0, evaluate=False),
    ),
    Domain({**SHOT, theta: RISING}, where={u: U, h: sp.S.Zero, eta: sp.S.Zero}),
    elsewhere=("beyond.hills.roots",),
)
def level(
    beyond__hills__time,
    beyond__hills__range,
    beyond__hills__roots,
    impact__time,
    range__u,
    claim__trivial_root,
):
    """From the ground itself, h = 0, the formulas are the paper's, and the other root is the launch."""
    flat = {eta: ETA.subs(h, 0)}
    found = [told.subs(flat) for told in (beyond__hills__time.of(time), beyond__hills__range.of(reach))]
    for mine, printed in zip(found, (impact__time.of(t), range__u.of(R(k, theta))), strict=True):
        if is_zero(mine - printed) is None:
            raise DerivationError(f"{mine} is not the paper's {printed}")
    other = next(e.lhs for e in beyond__hills__roots.parts if isinstance(e, Lt)).subs(flat)
    launch = next(e for e in claim__trivial_root.parts if e.rhs == u)
    started = Eq(other, sp.expand(other.subs(launch.lhs, launch.rhs)), evaluate=False)
    return And(Eq(time, found[0]), Eq(reach, found[1]), started)


FALL = sqrt(v**2 * sin(theta) ** 2 + 2 * g * h)


@chapter.derive(
    "beyond.hills.free",
    And(Eq(time, (v * sin(theta) + FALL) / g), Eq(reach, v * cos(theta) * (v * sin(theta) + FALL) / g)),
    Domain({**FREE, h: POSITIVE}, where={t: (v * sin(theta) + FALL) / g, time: t, reach: v * cos(theta) * t}),
)
def free(nodrag__x, nodrag__y):
    """Without resistance: y = -h, and the root before the launch is left out."""
    hit = step("the ground is hit", Eq(nodrag__y.of(y(t)) + h, 0, evaluate=False))
    found = isolate(hit, t, drop={(v * sin(theta) - FALL) / g: "before the launch, as h > 0"}).rhs
    return And(Eq(time, found), Eq(reach, nodrag__x.of(x(t)).subs(t, found), evaluate=False))


@chapter.derive(
    "beyond.hills.limit",
    And(
        Eq(Limit(TIME.subs(NAMES), k, 0, "+"), (v * sin(theta) + FALL) / g),
        Eq(Limit(REACH.subs(NAMES), k, 0, "+"), v * cos(theta) * (v * sin(theta) + FALL) / g),
    ),
    Domain({**FREE, h: POSITIVE}),
)
def little_resistance(
    beyond__hills__roots, beyond__hills__time, beyond__hills__range, beyond__hills__height, def__u, beyond__hills__free
):
    """Through s = k t, with e^(-s) = 1 - s + r s^2 and r -> 1/2: a quadratic equation for t with one positive root."""
    same = next(e for e in beyond__hills__roots.parts if isinstance(e, Equivalent))
    zero = next(e for e in same.args if isinstance(e, Eq))
    after = next(e.lhs for e in beyond__hills__roots.parts if isinstance(e, Gt))
    if zero.rhs != 0 or is_zero(after - beyond__hills__time.of(time)) is None:
        raise DerivationError(f"{after} is not the time of landing")
    names = {u: def__u.of(u), eta: beyond__hills__height.of(eta)}
    r, duration, high = sp.symbols("r duration high", positive=True)
    in_s = (
        sp.expand(zero.lhs * k**2 / g).subs(t, s / k).subs(exp(-s), 1 - s + r * s**2).subs(names).subs(k, s / duration)
    )
    square, linear, constant = sp.Poly(sp.expand(in_s * duration**2 / s**2), duration).all_coeffs()
    if not (square.is_negative and constant.subs(h, high).is_positive):
        raise DerivationError("the positive root is not the only one")
    root = (linear + sqrt(linear**2 - 4 * square * constant)) / (-2 * square)
    at_0 = {s: 0, r: elementary_limit((exp(-s) - 1 + s) / s**2, s, 0)}
    (inverse,) = beyond__hills__time.of(time).atoms(LambertW)
    w_of_s = isolate(Eq(s, sp.expand(k * beyond__hills__time.of(time).subs(inverse, w)), evaluate=False), w).rhs
    found = []
    for name, told in ((time, beyond__hills__time), (reach, beyond__hills__range)):
        form = told.of(name)
        near = sp.cancel(form.subs(inverse, w_of_s).subs(names).subs(k, s / duration))
        limit = near.subs(s, 0).subs(duration, root.subs(at_0))
        if is_zero(limit - beyond__hills__free.of(name)) is None:
            raise DerivationError(f"{limit} is not {beyond__hills__free.of(name)}, that without resistance")
        found.append(Eq(Limit(form.subs(names), k, 0, "+"), limit, evaluate=False))
    return And(*found)


if __name__ == "__main__":
    tell_chapter(chapter.name)
