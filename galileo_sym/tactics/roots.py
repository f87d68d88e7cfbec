"""Existence and uniqueness from strict monotony: one root, one maximum, bounds by the value at an end."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import (
    Continuous,
    DerivationError,
    ExactlyOneRoot,
    StrictlyDecreasing,
    StrictlyIncreasing,
    UniqueMaximum,
    tactic,
)
from galileo_sym.ledger.equivalence import is_zero

from .boxes import sign_by_ladder, sign_on
from .breaks import require_no_break
from .places import direction
from .signs import monotone


@tactic
def monotone_on_half_line(function, variable, interval):
    """Strict monotony on an interval with one finite end, from the sign of the slope (derivative ladder).

    Returns
    -------
    StrictlyIncreasing or StrictlyDecreasing
    """
    away = sp.Dummy("h", positive=True)
    upwards = interval.end is sp.oo
    place = interval.start + away if upwards else interval.end - away
    slope = sp.diff(function, variable).subs(variable, place)
    return monotone(function, variable, interval, sign_by_ladder(slope, away))


@tactic
def least_value(falling: StrictlyDecreasing, rising: StrictlyIncreasing) -> sp.Ge:
    """A continuous function that falls up to a place and rises from there on is least there.

    Returns
    -------
    Ge
        Ge(f, f(place)).
    """
    f, x, before = falling.args
    g, z, after = rising.args
    _require(isinstance(falling, StrictlyDecreasing) and isinstance(rising, StrictlyIncreasing), falling, rising)
    meet = before.end == after.start and before.end in before and after.start in after
    _require((f, x) == (g, z) and meet, falling, rising)
    return sp.Ge(f, f.subs(x, before.end), evaluate=False)


@tactic
def unique_maximum(rising: StrictlyIncreasing, falling: StrictlyDecreasing) -> UniqueMaximum:
    """A continuous function that rises up to a place and falls from there on is largest there, and only there."""
    f, x, before = rising.args
    g, z, after = falling.args
    _require(isinstance(rising, StrictlyIncreasing) and isinstance(falling, StrictlyDecreasing), rising, falling)
    meet = before.end == after.start and not before.right_open and not after.left_open
    _require((f, x) == (g, z) and meet, rising, falling)
    whole = sp.Interval(before.start, after.end, before.left_open, after.right_open)
    return UniqueMaximum(f, x, whole, before.end)


def _require(fits, *claims):
    if not fits:
        raise DerivationError(f"the two claims do not meet: {claims}")


@tactic
def bound_by_end(claim, place, inside) -> sp.Basic:
    """Compare the value at a place with that at the finite end of a half-line on which a function is monotone.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
        On (-oo, end] or [end, oo).
    place : expression
    inside : relation
        Says that `place` is beyond the end, strictly.

    Returns
    -------
    Gt or Lt
        f(place) against f(end).
    """
    rises = direction(claim) > 0
    f, x, interval = claim.args
    below = interval.start is sp.S.NegativeInfinity
    end = interval.end if below else interval.start
    wanted = sp.Lt(place, end, evaluate=False) if below else sp.Gt(place, end, evaluate=False)
    if inside != wanted or end not in interval:
        raise DerivationError(f"{claim} compares only places with {wanted}, not {inside}")
    larger = below != rises
    return (sp.Gt if larger else sp.Lt)(f.subs(x, place), f.subs(x, end), evaluate=False)


@tactic
def one_root(claim, level, *, ends=(None, None), assuming=()) -> ExactlyOneRoot:
    """A strictly monotone continuous function takes every value between its end values exactly once.

    Parameters
    ----------
    claim : StrictlyIncreasing or StrictlyDecreasing
        Of f on an interval.
    level : expression
        The value that is taken.
    ends : pair of Eq or None
        What f is, or tends to, at the two ends: Eq(Limit(f, x, end), value) or Eq(f(end), value); None at a closed
        end where the value can be put in.
    assuming : sequence of relations
        Such as Lt(r, M), for the comparison of `level` with the end values.

    Returns
    -------
    ExactlyOneRoot
        Of f - level.

    Raises
    ------
    DerivationError
        The level is not shown to lie between the end values; it may equal them at closed ends only. Or the claim is
        of another kind, f is seen to jump, or what it tends to at an open end is missing.
    """
    rising = direction(claim) > 0
    f, x, interval = claim.args
    require_no_break(f, x, interval)
    if sp.sympify(level).has(x):
        raise DerivationError(f"the level {level} changes with {x}")
    sides = ((interval.start, interval.left_open, "+"), (interval.end, interval.right_open, "-"))
    first, last = (_end_value(f, x, *side, told) for side, told in zip(sides, ends, strict=True))
    low, high = (first, last) if rising else (last, first)
    open_low, open_high = interval.left_open, interval.right_open
    if not rising:
        open_low, open_high = open_high, open_low
    if not (_below(low, level, open_low, assuming) and _below(level, high, open_high, assuming)):
        raise DerivationError(f"{level} is not shown to lie between {low} and {high}, the end values of {f}")
    return ExactlyOneRoot(f - level, x, interval)


@tactic
def above_limit(falls: sp.Lt, limit: sp.Eq, slope: sp.Eq | None = None) -> sp.Gt:
    """A function that falls all the way up to a point lies above its limit there.

    Parameters
    ----------
    falls : Lt
        Lt(slope, 0), proved for every x below the point.
    limit : Eq
        Eq(Limit(f, x, point, "-"), value).
    slope : Eq, optional
        Eq(Derivative(f, x), slope), unless `falls` speaks of the derivative by that name.

    Returns
    -------
    Gt
        Gt(f, value).
    """
    f, x, _, direction = limit.lhs.args
    named = sp.Derivative(f, x)
    fits = falls.lhs == named if slope is None else slope.lhs == named and is_zero(falls.lhs - slope.rhs)
    if not (fits and str(direction) == "-" and isinstance(falls, sp.StrictLessThan) and falls.rhs == 0):
        raise DerivationError(f"{falls} does not say that {f} falls towards {limit}")
    return sp.Gt(f, limit.rhs, evaluate=False)


@tactic
def sides_of_root(
    slope: sp.Eq, continuous: Continuous, place, root: ExactlyOneRoot, factor: StrictlyIncreasing, box: dict
):
    """Monotony of a function on both sides of the root of a factor of its slope.

    Parameters
    ----------
    slope : Eq
        Eq(Derivative(f, x), factor times something of one sign), proved inside an interval.
    continuous : Continuous
        Of f, on the closed interval.
    place : Symbol
        Names the root.
    root : ExactlyOneRoot
        Of the factor, inside the interval.
    factor : StrictlyIncreasing
    box : dict
        Where the parts of the slope lie, inside the interval: what `sign_on` needs for its sign without the factor.

    Returns
    -------
    pair of StrictlyIncreasing or StrictlyDecreasing
        On the left and on the right of `place`.
    """
    if root.args != factor.args or (type(root), type(factor)) != (ExactlyOneRoot, StrictlyIncreasing):
        raise DerivationError(f"{root} and {factor} are not about one function")
    if not isinstance(continuous, Continuous):
        raise DerivationError(f"{continuous} does not say that a function is continuous")
    function, variable, whole = continuous.args
    if root.args[2] != sp.Interval.open(whole.start, whole.end):
        raise DerivationError(f"{root} does not speak of the inside of {whole}, where {continuous}")
    if slope.lhs != sp.Derivative(function, variable) or variable != factor.args[1]:
        raise DerivationError(f"{slope} is not the slope of {function} against {variable}")
    sign = sign_on(sp.cancel(slope.rhs / factor.args[0]), box)
    left, right = sp.Interval(whole.start, place), sp.Interval(place, whole.end)
    return monotone(function, variable, left, -sign), monotone(function, variable, right, sign)


def _end_value(f, x, end, is_open, side, told):
    """The value of f at an end, or its limit from inside; `told` says it, unless f can be computed there."""
    if told is None:
        if is_open:
            raise DerivationError(f"what {f} tends to at the open end {x} = {end} is not given")
        return f.subs(x, end)
    if isinstance(told.lhs, sp.Limit):
        about, *place, way = told.lhs.args
        from_inside = end.is_infinite or str(way) == side
        fits = place == [x, end] and from_inside and is_zero(about - f) is not None
    else:
        fits = is_zero(told.lhs - f.subs(x, end)) is not None
    if not fits:
        raise DerivationError(f"{told} is not about {f} at {end}")
    return told.rhs


def _below(small, large, strict, assuming):
    if large is sp.oo or small is sp.S.NegativeInfinity:
        return True
    gap = large - small
    if gap.is_positive or (gap.is_nonnegative and not strict):
        return True
    for relation in assuming:
        if is_zero(relation.gts - relation.lts - gap) is not None:
            return not strict or isinstance(relation, sp.StrictLessThan | sp.StrictGreaterThan)
    return False
