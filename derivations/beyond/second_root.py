"""The other root of (30), by W_(-1): the bead followed backwards in time, or thrown up from B to come to rest in A."""

import sympy as sp
from sympy import And, Eq, Equivalent, Gt, Interval, LambertW, Limit, Lt, Or, cos, exp, pi, sqrt

from galileo_sym.derivations.beyond.chord_notation import ago, instant, j, notation, push, s_back, t_minus
from galileo_sym.derivations.chord.notation import D, c, g, gamma, s, s_AB, t, t_AB, theta
from galileo_sym.derivations.projectile import notation as flight
from galileo_sym.ledger import (
    POSITIVE,
    REAL,
    Chapter,
    DerivationError,
    Domain,
    ExactlyOneRoot,
    StrictlyIncreasing,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import is_zero
from galileo_sym.tactics import (
    at_rest,
    elementary_limit,
    ladder,
    limit_by_parameter,
    monotone_on_half_line,
    one_root,
    read_coefficients,
    rescale,
    same_order,
    solve_motion,
)

chapter = Chapter("beyond.second_root", notation, "What the papers leave open: the second root, by W_(-1)")

DROP = {g: POSITIVE, D: POSITIVE, gamma: POSITIVE}
FALLEN = g / gamma * t - g / gamma**2 * (1 - exp(-gamma * t))
RISEN = g / gamma**2 * (exp(gamma * ago) - 1 - gamma * ago)  # fallen backwards in time, for theta = 0
ARGUMENT = -exp(-1 - gamma**2 * D / g)
BY_W = 1 / gamma + gamma * D / g + LambertW(ARGUMENT) / gamma
BY_OTHER = 1 / gamma + gamma * D / g + LambertW(ARGUMENT, -1) / gamma


def either(one, other):
    """The instant is one of two. SymPy, wrongly, takes W_(-1) here for not real: it must not evaluate."""
    return Or(Eq(instant, one, evaluate=False), Eq(instant, other, evaluate=False))


@chapter.derive(
    "beyond.second-root.backwards",
    And(
        Eq(s_back(ago).diff(ago, 2) - gamma * s_back(ago).diff(ago), g * cos(theta)),
        Eq(s_back(ago), sp.expand(RISEN * cos(theta))),
    ),
    Domain({g: POSITIVE, gamma: POSITIVE, ago: POSITIVE, theta: Interval(-pi / 2, pi / 2)}),
)
def backwards(eq28, eq29):
    """Time reversed in (28): the drag pushes. Solved from rest at A it is (29), continued to times before 0."""
    law = rescale(eq28.equation, s(t), s_back(ago), time=-1)
    motion = solve_motion(law, s_back(ago), at_rest(s_back(ago)))
    if is_zero(motion.rhs - eq29.rhs.subs(t, -ago)) is None:
        raise DerivationError(f"{motion} does not continue {eq29.statement}")
    drag = law.rhs.coeff(s_back(ago).diff(ago)) * s_back(ago).diff(ago)
    return And(Eq(law.lhs - drag, sp.expand(law.rhs - drag), evaluate=False), motion)


def _risen(motion):
    """How far the bead falls from A along the vertical, backwards in time."""
    return sp.expand(motion.of(s_back(ago)) / cos(theta))


def _arrival(motion, length):
    """s_AB = s_back, divided by the cosine."""
    return Eq(sp.cancel(length.of(s_AB) / cos(theta)), _risen(motion), evaluate=False)


@chapter.derive(
    "beyond.second-root.once",
    And(StrictlyIncreasing(RISEN, ago, POSITIVE), ExactlyOneRoot(RISEN - D, ago, POSITIVE)),
    Domain(DROP),
)
def once(beyond__second_root__backwards, eq3):
    """Backwards in time the bead goes down from A for good, so that it was at the distance s_AB exactly once."""
    arrival = _arrival(beyond__second_root__backwards, eq3)
    rising = monotone_on_half_line(arrival.rhs, ago, POSITIVE)
    ends = [
        Eq(Limit(arrival.rhs, ago, end, side), elementary_limit(arrival.rhs, ago, end, side), evaluate=False)
        for end, side in ((0, "+"), (sp.oo, "-"))
    ]
    return And(rising, one_root(rising, arrival.lhs, ends=ends))


@chapter.derive(
    "beyond.second-root.roots",
    Equivalent(Eq(D, FALLEN.subs(t, instant)), either(BY_W, BY_OTHER)),
    Domain({**DROP, instant: sp.Union(REAL, sp.FiniteSet(BY_W, BY_OTHER), evaluate=False)}),
)
def roots(eq30, beyond__second_root__backwards, eq3, beyond__real_roots__two):
    """(30) holds before the release, too: a t + b + c e^(d t) = 0 with W's argument between -1/e and 0."""
    before = _arrival(beyond__second_root__backwards, eq3)
    after = eq30.equation.subs(t_AB, instant)
    if any(is_zero(x - y.subs(ago, -instant)) is None for x, y in zip(after.args, before.args, strict=True)):
        raise DerivationError(f"{before} is not {after} at times before the release")
    scaled = Eq(sp.expand((after.rhs - after.lhs) * gamma**2 / g), 0, evaluate=False)
    step("times gamma^2/g", Equivalent(after, scaled))
    told = dict(read_coefficients(scaled, instant).items())
    argument = sp.powsimp(told["c"] * told["d"] / told["a"] * exp(-told["b"] * told["d"] / told["a"]))
    in_c = argument.subs(D, c * g / gamma**2)
    least, most = ladder(in_c + exp(-1), c).rhs - exp(-1), -ladder(-in_c, c).rhs
    step("not below -1/e", Gt(argument, least, evaluate=False))
    step("not from 0 on", Lt(argument, most, evaluate=False))
    put = {**{flight.notation.symbols[n]: value for n, value in told.items()}, flight.q: argument}
    found = next(e for e in beyond__real_roots__two.statement.args if isinstance(e, Or))
    times = [Eq(instant, sp.expand(e.rhs.subs(put, simultaneous=True)), evaluate=False) for e in found.args]
    return Equivalent(after, Or(*times))


def _roots_by_branch(told):
    """The roots of (30) by W and by W_(-1)."""
    found = [e.rhs for e in next(e for e in told.statement.args if isinstance(e, Or)).args]
    return sorted(found, key=lambda e: len(next(iter(e.atoms(LambertW))).args))


def _signs(told, principal):
    """The relations Gt(root by W, 0) and Lt(root by W_(-1), 0), from what is proved of gamma times them."""
    pair = []
    for root in _roots_by_branch(told):
        for fact in principal.parts:
            apart = fact.lhs if fact.rhs == 0 else fact.lhs - fact.rhs
            if is_zero(apart.subs(c, gamma**2 * D / g) - gamma * root) is not None:
                pair.append(fact.func(root, 0, evaluate=False))
    if [type(fact) for fact in pair] != [Gt, Lt]:
        raise DerivationError(f"the signs of the roots are {pair}")
    return pair


@chapter.derive(
    "beyond.second-root.time",
    And(Eq(t_minus, BY_OTHER, evaluate=False), Lt(t_minus, 0), Eq(s_back(-t_minus), D * cos(theta))),
    Domain({**DROP, theta: Interval.open(-pi / 2, pi / 2)}, where={s_back(ago): RISEN * cos(theta)}),
)
def time(beyond__second_root__roots, eq36, claim__principal_branch, beyond__second_root__backwards, eq3):
    """The root that is not (36) is negative: the bead was in B before the release, on its way up to A."""
    after, before = _signs(beyond__second_root__roots, claim__principal_branch)
    if is_zero(after.lhs - eq36.of(t_AB)) is None:
        raise DerivationError(f"{eq36.statement} is not the positive root")
    place = beyond__second_root__backwards.of(s_back(ago)).subs(ago, -before.lhs)
    if is_zero(place - eq3.of(s_AB)) is None:
        raise DerivationError(f"at {before.lhs} the bead was not in B")
    was_there = Eq(s_back(-t_minus), eq3.of(s_AB), evaluate=False)
    return And(Eq(t_minus, before.lhs, evaluate=False), Lt(t_minus, 0, evaluate=False), was_there)


@chapter.derive(
    "beyond.second-root.shorter",
    Lt(-t_minus, t_AB),
    Domain(DROP, where={t_minus: BY_OTHER, t_AB: BY_W}),
)
def shorter(eq30, beyond__second_root__backwards, beyond__second_root__time, eq3):
    """Up is quicker than down: with z = gamma t the ways differ by 2 sinh z - 2 z > 0, and both are c at B."""
    z = sp.Symbol("z", positive=True)
    down = sp.expand(eq30.rhs.subs(t_AB, z / gamma) * gamma**2 / g)
    up = sp.expand(_risen(beyond__second_root__backwards).subs(ago, z / gamma) * gamma**2 / g)
    gap = ladder(up - down, z)
    rising = monotone_on_half_line(down, z, Interval(0, sp.oo))
    told = beyond__second_root__time
    before = next(e for e in told.parts if isinstance(e, Lt))
    up_time, down_time = gamma * -t_minus, gamma * t_AB
    if before.lts != t_minus or before.gts != 0:
        raise DerivationError(f"{before} does not say that t_minus is negative")
    drop = gamma**2 / g * sp.cancel(eq3.of(s_AB) / cos(theta))
    there = up.subs(z, up_time).subs(t_minus, told.of(t_minus))
    if is_zero(there - drop) is None or is_zero(sp.cancel(eq30.lhs / D) * drop - gamma**2 / g * eq30.lhs) is None:
        raise DerivationError(f"backwards the bead is at {there}, not at {drop}")
    step("at the time of the way up", Gt(gap.lhs.subs(z, up_time), 0, evaluate=False))
    step("both ways are c", Eq(up.subs(z, up_time), down.subs(z, down_time), evaluate=False))
    order = same_order(rising, up_time, down_time, inside={up_time: POSITIVE})
    less = next(e for e in order.args if not e.has(exp))
    return Lt(sp.cancel(less.lts / gamma), sp.cancel(less.gts / gamma), evaluate=False)


@chapter.derive(
    "beyond.second-root.limits",
    And(
        Eq(Limit(BY_W, gamma, 0, "+"), sqrt(2 * D / g)),
        Eq(Limit(BY_OTHER, gamma, 0, "+"), -sqrt(2 * D / g)),
        Eq(Limit((BY_W + BY_OTHER) / gamma, gamma, 0, "+"), 2 * D / (3 * g)),
    ),
    Domain({g: POSITIVE, D: POSITIVE}),
)
def limits(beyond__second_root__roots, claim__principal_branch):
    """Through j = gamma t: (30) gives gamma sqrt(D/g) = |j| sqrt(share(j)), and a root is j/gamma, j > 0 or j < 0."""
    equation = next(e for e in beyond__second_root__roots.statement.args if isinstance(e, Eq))
    height = sp.expand(equation.rhs.subs(instant, j / gamma) * gamma**2 / g * sp.cancel(D / equation.lhs))
    number, size = sp.symbols("number size", positive=True)  # gamma*unit and |j|
    unit, roots_told, spread = sqrt(D / g), [], 0
    for fact, side in zip(_signs(beyond__second_root__roots, claim__principal_branch), (1, -1), strict=True):
        share = height.subs(j, side * size) / size**2
        time_over_unit = side / sqrt(share)
        first = limit_by_parameter(time_over_unit, number, 0, "+", size, size * sqrt(share), 0)
        squares = elementary_limit((1 - first**2 * share) / size, size, 0)
        spread += squares / (2 * first / sqrt(first**2) ** 3)  # share tends to 1/first^2
        roots_told.append(Eq(Limit(fact.lhs, gamma, 0, "+"), first * unit, evaluate=False))
    total = sum(told.lhs.args[0] for told in roots_told) / gamma
    return And(*roots_told, Eq(Limit(total, gamma, 0, "+"), spread * unit**2, evaluate=False))


PUSHED = [root.subs(gamma, -push) for root in (BY_W, BY_OTHER)]


@chapter.derive(
    "beyond.second-root.push",
    And(
        Equivalent(Eq(D, FALLEN.subs({t: instant, gamma: -push})), either(*PUSHED)),
        Gt(PUSHED[1], 0, evaluate=False),
        Lt(PUSHED[0], 0, evaluate=False),
    ),
    Domain({g: POSITIVE, D: POSITIVE, push: POSITIVE, instant: sp.Union(REAL, sp.FiniteSet(*PUSHED), evaluate=False)}),
)
def pushed(beyond__second_root__roots, beyond__second_root__backwards, eq3, claim__principal_branch):
    """A drag that pushes is time reversed: the positive root of (30) for gamma = -push is that by W_(-1)."""
    arrival = _arrival(beyond__second_root__backwards, eq3)
    ahead = Eq(arrival.lhs, arrival.rhs.subs({ago: instant, gamma: push}, simultaneous=True), evaluate=False)
    condition, found = sorted(beyond__second_root__roots.statement.args, key=lambda e: isinstance(e, Or))
    mirrored = condition.subs({gamma: push, instant: -instant}, simultaneous=True)
    if any(is_zero(x - y) is None for x, y in zip(ahead.args, mirrored.args, strict=True)):
        raise DerivationError(f"{ahead} is not {mirrored}")
    times = [Eq(instant, -e.rhs.subs(gamma, push), evaluate=False) for e in found.args]
    facts = _signs(beyond__second_root__roots, claim__principal_branch)
    signs = [fact.reversedsign.func(-fact.lhs.subs(gamma, push), 0, evaluate=False) for fact in facts]
    return And(Equivalent(ahead, Or(*times)), *signs)


if __name__ == "__main__":
    tell_chapter(chapter.name)
