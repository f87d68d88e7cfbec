"""A closed form for the maximum range angle: it is a continuous function of alpha, down to alpha = 0."""

import sympy as sp
from sympy import And, Derivative, Eq, Ge, Gt, Limit, Lt, Ne, Or, Piecewise, asin, pi, sin, sqrt

from galileo_sym.derivations.projectile.notation import (
    H,
    Theta,
    alpha,
    alpha_0,
    n,
    notation,
    q,
    theta_max,
    w,
)  # fmt: skip
from galileo_sym.derivations.projectile.shared import (
    BEST,
    BEST_FROM_0,
    CASE_2,
    E1,
    W_a,
    continuous_w,
)
from galileo_sym.ledger import (
    NONNEGATIVE,
    Chapter,
    Continuous,
    DerivationError,
    Domain,
    Erratum,
    PowerSeries,
    UniqueMaximum,
    step,
    tell_chapter,
)  # fmt: skip
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    continuous_on,
    elementary_limit,
    filled_in,
    isolate,
    limit_along,
    limit_inside,
    limit_of_parts,
    limit_of_ratio,
    sign_by_ladder,
    zeros_from_0_on,
)  # fmt: skip

chapter = Chapter("projectile.continuity", notation, "A closed form for the maximum range angle: continuity")

AT_0 = Domain({}, where={Theta(alpha): BEST, w: W_a})
HEIGHT = W_a + 1
SINE = alpha * W_a / (alpha**2 - 1 - W_a)
DIVIDED = alpha / ((alpha**2 - 1) / W_a - 1)
SIDES = ("+", "-")
HEIGHT_NAME = sp.Dummy("h", real=True)  # stands for W + 1
OFF_0_AND_1 = sp.Union(sp.Interval.open(0, 1), sp.Interval.open(1, sp.oo), evaluate=False)


def from_above(expr):
    """The limit as alpha goes to 0."""
    return Limit(expr, alpha, 0, "+")


@chapter.derive(
    "projectile.cont.ratio",
    And(
        Eq(from_above((HEIGHT / alpha) ** 2), from_above(1 / H(W_a))),
        Eq(from_above((HEIGHT / alpha) ** 2), 2),
    ),
    AT_0,
)
def ratio_at_0(cont__H, def__W, def__T, claim__T_monotone):
    """The square is 1/H(W); W tends to -1, and H is continuous there, as the sum of a power series."""
    square = next(e for e in cont__H.parts if isinstance(e, Eq) and e.lhs == alpha**2)
    entire, at_foot = next(e for e in cont__H.parts if isinstance(e, PowerSeries)), cont__H.of(H(-1))
    if entire.args[2] != -1 or is_zero(entire.args[3].subs(n, 0) - at_foot) is None:
        raise DerivationError(f"{entire} does not tend to {at_foot}")
    foot = step("W tends to -1", limit_inside(continuous_w(def__W, def__T, claim__T_monotone), W_a, alpha, 0))
    reciprocal = HEIGHT**2 / square.rhs
    if foot.rhs != entire.args[2]:
        raise DerivationError(f"W tends to {foot.rhs}, where H is not known")
    known = limit_of_parts(reciprocal, {H(W_a): at_foot})
    whole = from_above((HEIGHT / alpha) ** 2)
    return And(Eq(whole, from_above(reciprocal), evaluate=False), Eq(whole, known, evaluate=False))


def _sine(theorem):
    """Theorem 3's sine for alpha != 1, and that for alpha = 1."""
    (general, when), (special, _) = theorem.of(theta_max).args
    if when != Ne(alpha, 1):
        raise DerivationError(f"{theorem.id} has other cases: {when}")
    return sin(general), sin(special)


@chapter.derive(
    "projectile.cont.sin0",
    And(
        Eq(from_above(sin(Theta(alpha))), from_above(W_a / (alpha - (1 + W_a) / alpha))),
        Eq(from_above(sin(Theta(alpha))), 1 / sqrt(2)),
    ),
    AT_0,
)
def sine_at_0(thm3, cont__ratio, def__W, def__T, claim__T_monotone):
    """Divide by alpha. (1 + W)/alpha tends to the positive root of 2, since W is never below -1."""
    top, bottom = sp.fraction(_sine(thm3)[0])
    rho = sp.Dummy("rho", real=True)
    below = sp.expand(sp.cancel(bottom.subs(W_a, rho * alpha - 1) / alpha))
    divided = (top / alpha) / below
    foot = step("W tends to -1", limit_inside(continuous_w(def__W, def__T, claim__T_monotone), W_a, alpha, 0))
    square = next(e for e in cont__ratio.parts if not e.rhs.has(Limit))
    least = next(e for e in def__W.parts if isinstance(e, sp.Ge) and e.lhs == sp.LambertW(q)).subs(q, W_a.args[0])
    if least.lhs - least.rhs != HEIGHT or is_zero(square.lhs.args[0] - (HEIGHT / alpha) ** 2) is None:
        raise DerivationError(f"{square} and {least} are not about (W + 1)/alpha")
    root = step("so that", Eq(from_above(HEIGHT / alpha), sqrt(square.rhs), evaluate=False))
    found = limit_of_parts(divided, {rho: root.rhs, W_a: foot.rhs, alpha: sp.S.Zero})
    whole = from_above(sin(Theta(alpha)))
    written = from_above(divided.subs(rho, HEIGHT / alpha))
    return And(Eq(whole, written, evaluate=False), Eq(whole, found, evaluate=False))


@chapter.derive("projectile.cont.pi4", Eq(from_above(Theta(alpha)), pi / 4), AT_0)
def angle_at_0(thm3, cont__sin0):
    """theta_max is the arcsine, a continuous function, of the sine."""
    sine, _ = _sine(thm3)
    angle = thm3.of(theta_max).args[0][0]
    limit = next(e for e in cont__sin0.parts if not e.rhs.has(Limit))
    if limit.lhs != from_above(sin(Theta(alpha))) or not abs(limit.rhs) <= 1:
        raise DerivationError(f"{limit} is not the limit of a sine")
    return Eq(from_above(Theta(alpha)), limit_of_parts(angle.subs(sine, w), {w: limit.rhs}), evaluate=False)


@chapter.derive("projectile.cont.rewrite", Eq(SINE, DIVIDED), CASE_2)
def divide_by_w(thm3):
    """Divide by W, which is 0 only if alpha is 1."""
    sine, _ = _sine(thm3)
    top, bottom = sp.fraction(sine.subs(W_a, w))
    step("W is not 0", Ne(W_a, 0))
    divided = sp.cancel(top / w) / sum(c * p / w for p, c in sp.collect(bottom, w, evaluate=False).items())
    return Eq(sine, divided.subs(w, W_a), evaluate=False)


def around_1(expr):
    """The limits as alpha goes to 1, from both sides."""
    return [Limit(expr, alpha, 1, side) for side in SIDES]


ARGUMENT = W_a.args[0]
SLOPE_OF_W = W_a / (ARGUMENT * (1 + W_a))
W_q = sp.LambertW(q)


@chapter.derive(
    "projectile.cont.lhopital",
    And(
        *(Eq(Limit(Derivative(sp.LambertW(q), q), q, 0, side), 1) for side in SIDES),
        *(
            Eq(
                Limit((alpha**2 - 1) / W_a, alpha, 1, side),
                Limit(2 * alpha / (SLOPE_OF_W * 2 * alpha / E1), alpha, 1, side),
            )
            for side in SIDES
        ),
        *(Eq(Limit((alpha**2 - 1) / W_a, alpha, 1, side), E1) for side in SIDES),
    ),
    Domain({}),
    erratum=Erratum(("S1",), "result (2) is for x != 0: at 0, W' = e^(-W)/(1 + W) has the limit 1, which is meant"),
)
def ratio_at_1(res2, res1, def__W, def__T, claim__T_monotone):
    """Both sides tend to 0, and their slopes to 2 and to 2/e: W/x is e^(-W) by (1), so that W' tends to 1."""
    continuous = continuous_w(def__W, def__T, claim__T_monotone)
    slope = res2.of(Derivative(W_q, q))
    bounded = sp.cancel(slope.subs(W_q, w).subs(q, res1.rhs.subs(W_q, w)))
    at_0 = [limit_inside(continuous, W_q, q, 0, side) for side in SIDES]
    slopes_at_0 = [Eq(Limit(Derivative(W_q, q), *e.lhs.args[1:]), limit_of_parts(bounded, {w: e.rhs})) for e in at_0]
    over = alpha**2 - 1
    slopes = sp.diff(over, alpha), slope.subs(q, ARGUMENT) * sp.diff(ARGUMENT, alpha)
    found = [_ratio_from(side, over, slopes, known, continuous) for side, known in zip(SIDES, slopes_at_0, strict=True)]
    ratios = [Eq(e.lhs, Limit(slopes[0] / slopes[1], *e.lhs.args[1:]), evaluate=False) for e in found]
    return And(*slopes_at_0, *ratios, *found)


def _ratio_from(side, over, slopes, slope_at_0, continuous):
    """L'Hôpital's rule from one side of alpha = 1."""
    vanishes = Eq(Limit(over, alpha, 1, side), elementary_limit(over, alpha, 1, side), evaluate=False)
    ends = vanishes, limit_inside(continuous, W_a, alpha, 1, side)
    along = limit_along(slope_at_0, alpha, ARGUMENT, 1, side)
    inner = elementary_limit(sp.diff(ARGUMENT, alpha), alpha, 1, side)
    values = elementary_limit(slopes[0], alpha, 1, side), along * inner
    limits = [Eq(Limit(f, alpha, 1, side), value, evaluate=False) for f, value in zip(slopes, values, strict=True)]
    for told in (*ends, *limits):
        step(f"as alpha goes to 1 from the side {side}", told)
    return limit_of_ratio(ends, slopes, limits)


@chapter.derive("projectile.cont.alpha1", And(*(Eq(limit, 1 / (E1 - 1)) for limit in around_1(SINE))), Domain({}))
def sine_at_1(cont__rewrite, cont__lhopital):
    """Put the limit of (alpha^2 - 1)/W in."""
    found = []
    for limit in around_1(cont__rewrite.lhs):
        ratio = next(
            e
            for e in cont__lhopital.parts
            if e.lhs == Limit((alpha**2 - 1) / W_a, *limit.args[1:]) and not e.rhs.has(Limit)
        )
        found.append(Eq(limit, limit_of_parts(cont__rewrite.rhs, {ratio.lhs.args[0]: ratio.rhs, alpha: sp.S.One})))
    return And(*found)


def _as_height(sine, product):
    """alpha^2, the sine over alpha, and the denominator of the sine, in terms of the height h = W + 1."""
    square = sp.Dummy("square", positive=True)
    told = product.subs(W_a, w).subs(alpha, sqrt(square)).subs(w, HEIGHT_NAME - 1)
    in_h = isolate(told, square).rhs
    parts = [part.subs(W_a, HEIGHT_NAME - 1).subs(alpha**2, in_h) for part in (sine / alpha, sp.denom(sine))]
    return in_h, *map(sp.factor, parts)


@chapter.derive(
    "projectile.cont.claim",
    And(
        Eq(
            Theta(alpha_0),
            Piecewise(
                (pi / 4, Eq(alpha_0, 0)),
                (asin(1 / (E1 - 1)), Eq(alpha_0, 1)),
                (asin(SINE.subs(alpha, alpha_0)), True),
            ),
        ),
        Continuous(Theta(alpha_0), alpha_0, NONNEGATIVE),
        Eq(Theta(0), pi / 4),
    ),
    Domain(  # a piece of its own, so that 1 is tried
        {alpha_0: sp.Union(sp.FiniteSet(1), NONNEGATIVE, evaluate=False)}, where={Theta(alpha_0): BEST_FROM_0}
    ),
    erratum=Erratum(
        ("S14",), "it is the maximum range angle, not the maximum range, that is continuous and decreasing"
    ),
)
def continuous(thm3, nodrag__claim__max_pi4, cont__pi4, cont__alpha1, cont__WeW, def__W, def__T, claim__T_monotone):
    """The arcsine of a quotient that is defined and below 1 in size but at 0 and 1; there it has limits."""
    general, special = _sine(thm3)
    square, share, below = _as_height(general, cont__WeW.equation)
    flat = next(e for e in nodrag__claim__max_pi4.parts if isinstance(e, UniqueMaximum))
    values = {sp.S.Zero: flat.args[3], sp.S.One: asin(special)}
    least = next(e for e in def__W.parts if isinstance(e, Ge) and e.lhs == W_q)
    step("W + 1 is not negative", Ge(W_a - least.rhs, 0, evaluate=False).subs(alpha, alpha_0))
    if least.rhs != -1:
        raise DerivationError(f"{least} does not say that W + 1 is not negative")
    undefined = {sqrt(square.subs(HEIGHT_NAME, root)) for root in zeros_from_0_on(below, HEIGHT_NAME)}
    if undefined != set(values) or sign_by_ladder(1 - square * share**2, HEIGHT_NAME) < 0:
        raise DerivationError(
            f"{general} is not between -1 and 1, or it is undefined at {undefined}, not {set(values)}"
        )
    facts = [Ne(sp.denom(general), 0), Lt(general, 1, evaluate=False), Gt(general, -1, evaluate=False)]
    for fact in (facts := [e.subs(alpha, alpha_0) for e in facts]):
        step("unless alpha is 0 or 1", Or(Eq(alpha_0, 0), Eq(alpha_0, 1), fact))
    known = continuous_w(def__W, def__T, claim__T_monotone)
    angle = asin(general.subs(alpha, alpha_0))
    pieces = continuous_on(angle, alpha_0, OFF_0_AND_1, known=[known], facts=facts)
    if cont__pi4.lhs != from_above(Theta(alpha)):
        raise DerivationError(f"{cont__pi4.statement} is not about theta_max")
    limits = [Eq(Limit(angle, alpha_0, 0, "+"), cont__pi4.rhs, evaluate=False)]
    for told in cont__alpha1.parts:
        _require_limit_of(general, told)
        at_1 = limit_of_parts(asin(w), {w: told.rhs})
        limits.append(Eq(Limit(angle, alpha_0, *told.lhs.args[2:]), at_1, evaluate=False))
    whole = filled_in(pieces, values, limits)
    name = Theta(alpha_0)
    return And(
        Eq(name, whole.args[0]), Continuous(name, *whole.args[1:]), Eq(Theta(0), values[sp.S.Zero], evaluate=False)
    )


def _require_limit_of(expr, told):
    if is_zero(told.lhs.args[0] - expr) is None:
        raise DerivationError(f"{told} is not about {expr}")


if __name__ == "__main__":
    tell_chapter(chapter.name)
