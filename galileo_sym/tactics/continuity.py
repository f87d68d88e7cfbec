"""Continuity: of inverses and compositions, across single places, and the limits that follow from it."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import Continuous, DerivationError, StrictlyDecreasing, StrictlyIncreasing, tactic
from galileo_sym.ledger.equivalence import is_zero

from .limits import elementary_limit, require_approach
from .signs import monotone

_EVERYWHERE = (sp.Symbol, sp.Add, sp.Mul, sp.exp, sp.sin, sp.cos, sp.atan)


@tactic
def continuous_inverse(rising: StrictlyIncreasing, round_trip: sp.Eq, values: sp.Ge) -> Continuous:
    """The inverse of a continuous function that rises on [end, oo) without bound.

    Parameters
    ----------
    rising : StrictlyIncreasing
        Of f, on [end, oo).
    round_trip : Eq
        Eq(f(W(q)), q).
    values : Ge
        Ge(W(q), end).

    Returns
    -------
    Continuous
        Of W(q), for q from f(end) on.
    """
    f, x, interval = rising.args
    inverse, end = values.lhs, values.rhs
    (q,) = inverse.args
    fits = isinstance(rising, StrictlyIncreasing) and interval == sp.Interval(end, sp.oo)
    if not fits or round_trip.rhs != q or is_zero(round_trip.lhs - f.subs(x, inverse)) is None:
        raise DerivationError(f"{round_trip} and {values} do not make {inverse} the inverse of {rising}")
    continuous_on(f, x, interval)
    if elementary_limit(f, x, sp.oo) is not sp.oo:
        raise DerivationError(f"{f} does not rise without bound")
    return Continuous(inverse, q, sp.Interval(f.subs(x, end), sp.oo))


@tactic
def continuous_on(expr, variable, interval, *, known=(), facts=()) -> Continuous:
    """An expression made of continuous functions, where each is defined.

    Parameters
    ----------
    known : sequence of Continuous
        Of other functions, each on an interval [start, oo) or the reals.
    facts : sequence of Ne, Ge, Le, Gt, Lt
        Proved inside the interval: denominators are not 0, arguments lie where functions are continuous.

    Raises
    ------
    DerivationError
        A part is not known to be continuous, or not shown to be defined.
    """
    if expr.has(sp.zoo, sp.nan, sp.oo, -sp.oo):
        raise DerivationError(f"{expr} has no finite value")
    for part in sp.preorder_traversal(expr):
        if part.has(variable) and not _continuous(part, known, facts):
            raise DerivationError(f"{part} is not shown to be continuous in {variable} on {interval}")
    return Continuous(expr, variable, interval)


def _continuous(part, known, facts):
    if isinstance(part, _EVERYWHERE):
        return True
    if isinstance(part, sp.Pow):
        return part.exp.is_Integer and (part.exp > 0 or _not_zero(part.base, facts))
    if isinstance(part, sp.asin):
        return _told(sp.Ge, part.args[0], -1, facts) and _told(sp.Le, part.args[0], 1, facts)
    for claim in known:
        f, q, where = claim.args
        if part == f.subs(q, part.args[0]) and where.end is sp.oo:
            return where.start is sp.S.NegativeInfinity or _told(sp.Ge, part.args[0], where.start, facts)
    return False


def _not_zero(expr, facts):
    different = sp.Ne | sp.StrictGreaterThan | sp.StrictLessThan
    return expr.is_nonzero or any(isinstance(e, different) and is_zero(e.lhs - e.rhs - expr) for e in facts)


def _told(kind, expr, bound, facts):
    """Whether expr >= bound (or <= bound) is plain, or among the facts."""
    excess = sp.expand(expr - bound if kind is sp.Ge else bound - expr)
    if excess.is_nonnegative:
        return True
    strict = sp.StrictGreaterThan | sp.StrictLessThan | sp.GreaterThan | sp.LessThan
    return any(isinstance(e, strict) and is_zero(e.gts - e.lts - excess) for e in facts)


@tactic
def limit_inside(known: Continuous, applied, variable, point, direction="+") -> sp.Eq:
    """The limit of f(argument), f continuous: the value of f at the limit of the argument.

    At an end of the interval where f is continuous the argument must come from inside.
    """
    f, q, interval = known.args
    argument = applied.args[0]
    if not isinstance(known, Continuous) or applied != f.subs(q, argument):
        raise DerivationError(f"{known} is not about {applied}")
    inside = elementary_limit(argument, variable, point, direction)
    if interval.contains(inside) != sp.true:
        raise DerivationError(f"{argument} tends to {inside}, outside {interval}")
    for end, side in ((interval.start, "+"), (interval.end, "-")):
        if inside == end:
            require_approach(q, end, side, variable, argument, point, direction)
    return sp.Eq(sp.Limit(applied, variable, point, direction), f.subs(q, inside), evaluate=False)


@tactic
def limit_of_parts(expr, parts: dict):
    """The limit of an expression that is continuous in its parts, from the limits of those.

    Parameters
    ----------
    parts : dict
        {part: its limit}, each finite; larger parts before those that they contain.

    Raises
    ------
    DerivationError
        A part is left, or the expression is not continuous at the limits.
    """
    names = {part: sp.Dummy(f"part{i}", real=True) for i, part in enumerate(parts)}
    hidden = expr
    for part, name in names.items():
        hidden = hidden.subs(part, name)
    put = {name: parts[part] for part, name in names.items()}
    if any(sp.sympify(value).is_finite is False for value in put.values()):
        raise DerivationError(f"not every part of {expr} has a finite limit: {parts}")
    if hidden.free_symbols - set(put):
        raise DerivationError(f"the limit of {sorted(map(str, hidden.free_symbols - set(put)))} is not given")
    facts = [sp.Ne(e.base, 0) for e in hidden.atoms(sp.Pow) if e.base.xreplace(put).is_nonzero]
    facts += [kind(*e.args, end) for e in hidden.atoms(sp.asin) for kind, end in _around(e.args[0].xreplace(put))]
    for name in put:
        continuous_on(hidden, name, sp.S.Reals, facts=facts)
    return hidden.xreplace(put)


def _around(value):
    """What holds near a value that lies inside the domain of the arcsine."""
    return ((sp.Ge, -1), (sp.Le, 1)) if abs(value) < 1 else ()


@tactic
def filled_in(pieces: Continuous, values: dict, limits) -> Continuous:
    """A function that is continuous but at single places, given its limits as values there.

    Parameters
    ----------
    pieces : Continuous
        Of f on a union of open intervals.
    values : dict
        {place: value}, for every end of the pieces that is finite.
    limits : sequence of Eq
        Eq(Limit(f, x, place, side), value), for each side that f comes from.

    Returns
    -------
    Continuous
        Of Piecewise((value, x = place), ..., (f, else)), on the closed union.
    """
    f, x, parts = pieces.args
    if not isinstance(pieces, Continuous):
        raise DerivationError(f"{pieces} does not say that a function is continuous")
    told = {(e.lhs.args[2], str(e.lhs.args[3])): e.rhs for e in limits if e.lhs.args[:2] == (f, x)}
    intervals = parts.args if isinstance(parts, sp.Union) else (parts,)
    if set(values) != {end for part in intervals for end in (part.start, part.end) if end.is_finite}:
        raise DerivationError(f"values are given at {set(values)}, not at the finite ends of {parts}")
    for part in intervals:
        for place, side in ((part.start, "+"), (part.end, "-")):
            if place.is_finite and told.get((place, side)) != values[place]:
                raise DerivationError(f"{f} tends to {told.get((place, side))} at {place}{side}, not {values[place]}")
    branches = [(value, sp.Eq(x, place)) for place, value in values.items()]
    return Continuous(sp.Piecewise(*branches, (f, True)), x, parts.closure)


@tactic
def limit_of_ratio(ends, slopes, slope_limits) -> sp.Eq:
    """L'Hôpital's rule for 0/0, with its hypotheses.

    Parameters
    ----------
    ends : pair of Eq
        What numerator and denominator tend to: Eq(Limit(f, x, point, side), 0) and Eq(Limit(h, x, point, side), 0).
    slopes : pair of expressions
        Their derivatives.
    slope_limits : pair of Eq
        Eq(Limit(f', ...), a) and Eq(Limit(h', ...), b) with b not 0, so that h' is not 0 near the point either.

    Returns
    -------
    Eq
        Eq(Limit(f/h, ...), a/b).
    """
    (over, *where), (under, *_) = (e.lhs.args for e in ends)
    x = where[0]
    for part, end, slope, told in zip((over, under), ends, slopes, slope_limits, strict=True):
        if end.rhs != 0 or list(end.lhs.args[1:]) != where or list(told.lhs.args[1:]) != where:
            raise DerivationError(f"{end} and {told} do not say that {part} tends to 0 and its slope to a limit there")
        if is_zero(sp.diff(part, x) - slope) is None or is_zero(told.lhs.args[0] - slope) is None:
            raise DerivationError(f"{slope}, of which {told} speaks, is not the derivative of {part}")
    first, second = (told.rhs for told in slope_limits)
    if not (first.is_finite and second.is_finite and second.is_nonzero):
        raise DerivationError(f"the slopes tend to {first} and {second}: their quotient has no limit to be read off")
    return sp.Eq(sp.Limit(over / under, *where), sp.simplify(first / second), evaluate=False)


@tactic
def closed_at_end(claim, continuous: Continuous):
    """Strict monotony on an open interval holds on the closed one where the function is continuous there."""
    if not isinstance(claim, StrictlyIncreasing | StrictlyDecreasing) or not isinstance(continuous, Continuous):
        raise DerivationError(f"{claim} is no monotony, or {continuous} no continuity")
    f, x, inside = claim.args
    g, z, whole = continuous.args
    if f.subs(x, z) != g or whole.interior != inside.interior:
        raise DerivationError(f"{claim} and {continuous} are not about one function")
    return monotone(g, z, whole, 1 if isinstance(claim, StrictlyIncreasing) else -1)


@tactic
def slope_at_gap(slope: sp.Eq, function: Continuous, formula: Continuous, place) -> sp.Eq:
    """The formula of a slope holds at a place that was left out, if function and formula are continuous there.

    By the mean value theorem: difference quotients at the place are slopes near to it.

    Parameters
    ----------
    slope : Eq
        Eq(Derivative(f, x), formula), proved near the place.
    function, formula : Continuous
        Of f, and of the formula.
    """
    derivative = slope.lhs
    for claim, told in ((function, derivative.expr), (formula, slope.rhs)):
        f, x, interval = claim.args
        about = isinstance(claim, Continuous) and is_zero(f.subs(x, derivative.variables[0]) - told) is not None
        if not about or interval.interior.contains(place) != sp.true:
            raise DerivationError(f"{claim} does not say that {told} is continuous at {place}")
    return slope
