"""Section 3, end: the rescaled synchronous curve, equations (25) to (27), and figure 4."""

import sympy as sp
from sympy import And, Eq, Ge, Interval, Le, Limit, Or, Tuple, atan, cos, sin, sqrt

from galileo_sym.derivations.chord.notation import (
    apart,
    g,
    mu,
    notation,
    rho_l,
    rho_r,
    s,
    t,
    theta,
    x,
    xt,
    xt_l,
    xt_r,
    y,
    yt,
    yt_l,
    yt_r,
)
from galileo_sym.derivations.chord.shared import (
    ARC,
    LAST_FROM_0,
    LEFT_POINT,
    RIGHT_POINT,
    WITH_OR_WITHOUT,
    K,
    require_without_friction,
)
from galileo_sym.ledger import (
    POSITIVE,
    REAL,
    Chapter,
    DerivationError,
    Domain,
    Independent,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import equivalent
from galileo_sym.tactics import (
    elementary_limit,
    isolate,
    not_negative,
    read_circle,
)

chapter = Chapter("chord.rescaled", notation, "3. Sliding friction")

PLANE = Domain({mu: POSITIVE, xt: REAL, yt: REAL})
FROM_0 = {**ARC.ranges, **WITH_OR_WITHOUT}
LEFT_FROM_0 = {**FROM_0, theta: Interval(-LAST_FROM_0, 0)}
RIGHT = (xt + mu) ** 2 + (yt - 1) ** 2
LEFT = (xt - mu) ** 2 + (yt - 1) ** 2

chapter.given(
    "chord.eq25",
    And(Eq(xt, x / (g * t**2 / 4)), Eq(yt, y / (g * t**2 / 4))),
    Domain({g: POSITIVE, t: POSITIVE, x: REAL, y: REAL}),
)

EQ26 = Eq((xt + mu) ** 2 + (yt - 1) ** 2, 1 + mu**2)
EQ27 = Eq((xt - mu) ** 2 + (yt - 1) ** 2, 1 + mu**2)


def rescale(circle_equation, definition):
    """Put x = K xt and y = K yt in, and divide by K^2."""
    put = {c: isolate(Eq(name, definition.of(name), evaluate=False), c).rhs for c, name in ((x, xt), (y, yt))}
    left, right = (sp.expand(side.subs(put) / K**2) for side in circle_equation.args)
    return Eq(left, right, evaluate=False)


@chapter.derive("chord.eq26", EQ26, Domain(FROM_0, where={x: RIGHT_POINT[0], y: RIGHT_POINT[1]}))
def rescaled_right(eq21, eq25, eq9):
    """Rescale (21), which is (9) for mu = 0."""
    require_without_friction(eq21.equation, eq9.equation)
    return rescale(eq21.equation, eq25)


@chapter.derive("chord.eq27", EQ27, Domain(LEFT_FROM_0, where={x: LEFT_POINT[0], y: LEFT_POINT[1]}))
def rescaled_left(eq24, eq25, eq9):
    """Rescale (24), which is (9) for mu = 0."""
    require_without_friction(eq24.equation, eq9.equation)
    return rescale(eq24.equation, eq25)


@chapter.derive(
    "chord.claim.rescaled-time-independent",
    And(Independent(RIGHT - (1 + mu**2), t), Independent(LEFT - (1 + mu**2), t)),
    PLANE,
)
def time_independent(eq26, eq27):
    """The time is in neither equation."""
    facts = []
    for equation in (eq26, eq27):
        if equation.statement.has(t):
            raise DerivationError(f"{equation.id} depends on t")
        facts.append(Independent(equation.lhs - equation.rhs, t))
    return And(*facts)


RIGHT_CENTRE, LEFT_CENTRE = Tuple(xt_r, yt_r), Tuple(xt_l, yt_l)


@chapter.derive(
    "chord.claim.centres-radius",
    And(
        Eq(RIGHT_CENTRE, Tuple(-mu, 1)),
        Eq(LEFT_CENTRE, Tuple(mu, 1)),
        Eq(Tuple(rho_r, rho_l), Tuple(sqrt(1 + mu**2), sqrt(1 + mu**2))),
    ),
    PLANE,
)
def centres(eq26, eq27):
    """Read centres and radii off (26) and (27); (26) has the minus sign."""
    right, left = (read_circle(e.equation, xt, yt) for e in (eq26, eq27))
    return And(
        Eq(RIGHT_CENTRE, Tuple(*right.centre)),
        Eq(LEFT_CENTRE, Tuple(*left.centre)),
        Eq(Tuple(rho_r, rho_l), Tuple(right.radius, left.radius)),
    )


@chapter.derive("chord.claim.displaced-2mu", Eq(apart, 2 * mu), PLANE)
def displaced(claim__centres_radius):
    """The distance of the centres."""
    across, down = (claim__centres_radius.of(a) - claim__centres_radius.of(b) for a, b in ((xt_r, xt_l), (yt_r, yt_l)))
    return Eq(apart, sqrt(sp.expand(across**2 + down**2)))


@chapter.derive(
    "chord.claim.circles-cross",
    And(
        sp.Equivalent(And(Eq(RIGHT, 1 + mu**2), Eq(LEFT, 1 + mu**2)), And(Eq(xt, 0), Or(Eq(yt, 0), Eq(yt, 2)))),
        Ge((1 + cos(2 * theta)) - mu * sin(2 * theta), 0),
        Le((1 + cos(2 * theta)) - mu * sin(2 * theta), 2),
    ),
    Domain(
        {
            mu: POSITIVE,
            xt: sp.Union(sp.FiniteSet(0), REAL, evaluate=False),  # so that the crossing points are tried, too
            yt: sp.Union(sp.FiniteSet(0, 2), REAL, evaluate=False),
            theta: Interval(0, atan(1 / mu)),
            g: POSITIVE,
            t: POSITIVE,
        }
    ),
)
def crossing(eq26, eq27, eq20, claim__slides_iff):
    """Subtract: 4 mu xt = 0, then yt (yt - 2) = 0. On the arc both yt and 2 - yt are products of positive things."""
    difference = sp.factor((eq26.lhs - eq26.rhs) - (eq27.lhs - eq27.rhs))
    if sp.solve(difference, xt) != [0]:
        raise DerivationError(f"{difference} = 0 does not say xt = 0")
    roots = sp.solve((eq26.lhs - eq26.rhs).subs(xt, 0), yt)
    level = sp.expand(next(e for e in eq20.parts if not e.rhs.has(s)).rhs / (g * t**2 / 4))
    driving = claim__slides_iff.statement.atoms(sp.StrictGreaterThan).pop().lhs.subs(sp.Abs(theta), theta)
    sine, cosine = sp.symbols("sine cosine", nonnegative=True)
    plain = {sin(theta): sine, cos(theta): cosine}
    opened = sp.expand(sp.expand_trig(level).subs(plain))
    not_negative(opened, {driving.subs(plain): Ge(driving.subs(plain), 0)})
    not_negative(sp.rem(2 - opened, cosine**2 + sine**2 - 1, cosine), {})
    return And(
        sp.Equivalent(And(eq26.equation, eq27.equation), And(Eq(xt, 0), Or(*(Eq(yt, r) for r in roots)))),
        Ge(level, 0, evaluate=False),
        Le(level, 2, evaluate=False),
    )


@chapter.derive(
    "chord.claim.zero-friction-limit",
    And(
        Eq(Limit(RIGHT - (1 + mu**2), mu, 0, "+"), xt**2 + (yt - 1) ** 2 - 1),
        Eq(Limit(LEFT - (1 + mu**2), mu, 0, "+"), xt**2 + (yt - 1) ** 2 - 1),
    ),
    PLANE,
)
def zero_friction(eq26, eq27, eq9, eq25):
    """The limits of (26) and (27); they are (9) rescaled, put on one side."""
    galileo = rescale(eq9.equation, eq25)
    limits = []
    for equation in (eq26, eq27):
        left = equation.lhs - equation.rhs
        value = elementary_limit(left, mu, 0)
        if equivalent(Eq(value, 0, evaluate=False), galileo) is None:
            raise DerivationError(f"{left} becomes {value}, which is not that of {galileo}")
        limits.append(Eq(Limit(left, mu, 0, "+"), value, evaluate=False))
    return And(*limits)


if __name__ == "__main__":
    tell_chapter(chapter.name)
