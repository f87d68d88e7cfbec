"""Between the cases (not printed): one force goes to 0, and the motion after a long time."""

import sympy as sp
from sympy import Abs, And, Eq, Gt, Interval, LambertW, Limit, atan, cos, exp, oo, sin, sqrt, tan

from galileo_sym.derivations.chord.notation import (
    W_0,
    D,
    R,
    X,
    Y,
    c,
    g,
    gamma,
    mu,
    notation,
    q,
    s,
    sigma,
    t,
    theta,
    x,
    y,
    y_c,
)
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    REAL,
    Chapter,
    DerivationError,
    Domain,
    StrictlyIncreasing,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    elementary_limit,
    ladder,
    limit_of_inverse,
    limit_with_part,
    read_circle,
)

chapter = Chapter("chord.limiting_cases", notation, "support (not printed)")

LAST = atan(1 / mu)
SLIDING = {**dict.fromkeys((g, gamma, mu), POSITIVE), theta: Interval.open(-LAST, LAST)}
FALLEN = g / gamma * t - g / gamma**2 * (1 - exp(-gamma * t))
DEPTH = FALLEN / 2
K = g * t**2 / 4
SHARE = 1 - mu * tan(Abs(theta))


def by_w(length):
    """(36) with a length for D."""
    return LambertW(-exp(-1 - gamma**2 * length / g)) / gamma + 1 / gamma + gamma * length / g


def on_circle(depth):
    """What vanishes on the circles (44), (21) and (24), with the centre at a depth."""
    return (x + sigma * mu * depth) ** 2 + (y - depth) ** 2 - (1 + mu**2) * depth**2


def vanishing(force, expr, value):
    """The limit of an expression as a force vanishes."""
    return Eq(Limit(expr, force, 0, "+"), value, evaluate=False)


def towards(force, expr, value, *cases):
    """A limit that was computed; refused if it is not what the paper has without the force."""
    for known in cases:
        if is_zero(value - known) is None:
            raise DerivationError(f"{expr} goes to {value} as {force} vanishes, not to {known}")
    return vanishing(force, expr, value)


def without_friction(eq43, eq36, branches, monotony):
    """(43) as mu goes to 0: W is continuous above -1/e, being the inverse of the rising half of F."""
    (inverse,) = eq43.rhs.atoms(LambertW)
    argument = elementary_limit(inverse.args[0], mu, 0)
    rising = next(e for e in monotony.parts if isinstance(e, StrictlyIncreasing))
    values = next(e for e in branches.parts if isinstance(e, sp.Ge) and e.lhs == W_0(q))
    round_trip = next(e for e in branches.parts if isinstance(e, Eq) and e.lhs == W_0(q) * exp(W_0(q)))
    function, w, _ = rising.args
    above = step("inside", Gt(argument, function.subs(w, values.rhs), evaluate=False))
    ladder(sp.expand((above.lhs - above.rhs).subs(D, c * g / gamma**2)), c)
    known = limit_of_inverse(rising, round_trip, values, above)
    value = branches.of(W_0(q)).subs(q, known.args[0])
    part = sp.Dummy("W", real=True)
    return towards(mu, eq43.rhs, limit_with_part(eq43.rhs.subs(inverse, part), part, value, mu, 0), eq36.rhs)


def without_drag(eq43, eq36, small_drag, eq17, eq18):
    """(43) as gamma goes to 0: it is (36) with D/n for D, n = 1 - mu tan|theta|."""
    if is_zero(eq36.rhs.subs(D, D / SHARE) - eq43.rhs) is None:
        raise DerivationError("(43) is not (36) with D/n for D")
    known = next(e for e in small_drag.parts if is_zero(e.lhs.args[0] - eq36.rhs) is not None)
    value = known.rhs.subs(D, D / SHARE)
    cases = (eq17.rhs.subs(theta, Abs(theta)), eq18.rhs.subs(theta, -Abs(theta)))
    return towards(gamma, eq43.rhs, value, *cases)


def circles(eq44, eq45, eq46, eq47, eq21, eq24):
    """(44) as gamma goes to 0, a polynomial in Y(t)."""
    circle = (eq44.lhs - eq44.rhs).subs({X(t): eq46.rhs, R(t): eq47.rhs})
    depth = elementary_limit(eq45.rhs, gamma, 0)
    value = limit_with_part(circle, Y(t), depth, gamma, 0)
    for side, known in ((1, eq21), (-1, eq24)):
        towards(gamma, circle, value.subs(sigma, side), known.lhs - known.rhs)
    if not eq47.rhs.is_nonnegative:
        raise DerivationError(f"{eq47.rhs} is no radius")
    return vanishing(gamma, circle.subs(Y(t), eq45.rhs), value)


@chapter.derive(
    "chord.support.limits-between-cases",
    And(
        vanishing(mu, by_w(D / SHARE), by_w(D)),
        vanishing(gamma, by_w(D / SHARE), sqrt((2 * D / g) / SHARE)),
        vanishing(gamma, FALLEN * cos(theta), g * t**2 / 2 * cos(theta)),
        vanishing(gamma, DEPTH, K),
        vanishing(gamma, on_circle(DEPTH), on_circle(K)),
    ),
    Domain({**SLIDING, D: POSITIVE, t: POSITIVE, sigma: sp.FiniteSet(1, -1), x: REAL, y: REAL}),
)
def between_cases(
    eq43, eq36, eq17, eq18, eq29, eq1, eq32, eq45, eq10, eq44, eq46, eq47, eq21, eq24,
    claim__gamma_limit_pm, claim__W_branches, claim__F_monotone,
):  # fmt: skip
    """Elementary forms by their limits; (43) by the continuity of W, and by the small drag limit of (36)."""
    return And(
        without_friction(eq43, eq36, claim__W_branches, claim__F_monotone),
        without_drag(eq43, eq36, claim__gamma_limit_pm, eq17, eq18),
        towards(gamma, eq29.rhs, elementary_limit(eq29.rhs, gamma, 0), eq1.rhs),
        *(towards(gamma, half.rhs, elementary_limit(half.rhs, gamma, 0), eq10.rhs) for half in (eq32, eq45)),
        circles(eq44, eq45, eq46, eq47, eq21, eq24),
    )


@chapter.derive(
    "chord.support.terminal",
    And(
        Eq(Limit(s(t).diff(t), t, oo), g / gamma * (cos(theta) - mu * sin(theta))),
        Eq(y_c(t).diff(t, 2), g / 2 * exp(-gamma * t)),
    ),
    Domain({**SLIDING, t: NONNEGATIVE, theta: Interval(0, LAST)}, where={y_c(t): DEPTH}),
)
def terminal(eq41, eq31, eq32):
    """The speed tends to that at which drag balances the driving force; the centre of (31) is at the depth (32)."""
    speed = step("speed", Eq(s(t).diff(t), sp.expand(sp.diff(eq41.rhs, t))))
    last = Eq(Limit(speed.lhs, t, oo), elementary_limit(speed.rhs, t, oo, "-"), evaluate=False)
    seen = read_circle(eq31.equation, x, y)
    if is_zero(seen.radius - seen.centre[1]) is None:
        raise DerivationError(f"{eq31.statement} does not pass through A: its centre is not a radius below")
    depth = step("the centre", Eq(y_c(t), seen.centre[1].subs(R(t), eq32.rhs)))
    return And(last, Eq(y_c(t).diff(t, 2), sp.diff(depth.rhs, t, 2)))


if __name__ == "__main__":
    tell_chapter(chapter.name)
