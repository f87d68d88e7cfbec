"""Assumptions as data: which values the variables may take, and points to try among them."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import sympy as sp

POSITIVE = sp.Interval.open(0, sp.oo)
NONNEGATIVE = sp.Interval(0, sp.oo)
REAL = sp.Interval.open(-sp.oo, sp.oo)

_INNER = [sp.Rational(*pair) for pair in ((1, 3), (1, 1), (7, 5), (1, 40), (29, 2), (3, 1), (640, 7), (1, 900))]
_FAR = [sp.Integer(10) ** -9, sp.Integer(10) ** 6]
_NEAR_END = [sp.Rational(1, 10**6), 1 - sp.Rational(1, 10**6)]


class EmptyDomain(ValueError):
    """The assumptions leave no point."""


@dataclass(frozen=True)
class Domain:
    """Independent variables with the sets they run through.

    Attributes
    ----------
    ranges : mapping of Symbol to Interval, FiniteSet, or Union of those
        In order; an end may depend on variables named before. A union keeps its pieces apart
        (``Union(..., evaluate=False)``): points are tried in, and at the edges of, every piece.
    where : mapping of Symbol or undefined function to expression
        What dependent variables stand for.
    supposing : tuple of statements
        Hypotheses beside the ranges, such as Galileo's paradox. They must hold of what `where` puts in. What is
        derived from a statement supposes the same, or says so: Implies(hypotheses, conclusion).
    """

    ranges: Mapping[sp.Symbol, sp.Set]
    where: Mapping[object, sp.Expr] = field(default_factory=dict)
    supposing: tuple[sp.Basic, ...] = ()

    def __post_init__(self):
        object.__setattr__(self, "ranges", MappingProxyType(dict(self.ranges)))
        object.__setattr__(self, "where", MappingProxyType(dict(self.where)))

    @property
    def condition(self) -> sp.Basic:
        """The assumptions as one Boolean."""
        return sp.And(self.inside, *self.supposing)

    @property
    def inside(self) -> sp.Basic:
        """The ranges as one Boolean."""
        return sp.And(*(_as_condition(s, r) for s, r in self.ranges.items()))

    def points(self, count: int, seed: str) -> list[dict[sp.Symbol, sp.Expr]]:
        """`count` or more exact points, edge cases of every range among them; the one there is without variables.

        Raises `EmptyDomain` when a range has no point.
        """
        rng = random.Random(seed)
        plans = [dict.fromkeys(self.ranges, None) for _ in range(count if self.ranges else 1)]
        for symbol, values in self.ranges.items():
            for piece in _pieces(values):
                _require_points(symbol, piece, values)
                plans += [dict.fromkeys(self.ranges, None) | {symbol: (piece, edge)} for edge in _edges(piece)]
        return [self._draw(plan, rng) for plan in plans]

    def _draw(self, plan, rng):
        point = {}
        for symbol, values in self.ranges.items():
            piece, edge = plan[symbol] or (rng.choice(_pieces(values)), None)
            now = piece.subs(point)
            _require_points(symbol, now, values)
            point[symbol] = _pick(now, edge, rng)
        return point


def _require_points(symbol, now, values):
    if now.is_empty:
        raise EmptyDomain(f"the assumptions leave no {symbol} in {values}: correct its range")


def _pieces(values):
    """The parts of a union, which `subs` on the whole would merge again."""
    return values.args if isinstance(values, sp.Union) else (values,)


def _as_condition(symbol, values):
    if isinstance(values, sp.Union):
        return sp.Or(*(_as_condition(symbol, piece) for piece in values.args))
    if values is sp.S.EmptySet:
        return sp.false
    if isinstance(values, sp.FiniteSet):
        return sp.Or(*(sp.Eq(symbol, v, evaluate=False) for v in values))
    parts = []
    if values.start is not sp.S.NegativeInfinity:
        parts.append((sp.Gt if values.left_open else sp.Ge)(symbol, values.start, evaluate=False))
    if values.end is not sp.S.Infinity:
        parts.append((sp.Lt if values.right_open else sp.Le)(symbol, values.end, evaluate=False))
    return sp.And(*parts)


def _edges(values):
    """The edge cases of a range: ('end', 0 or 1), ('fraction', f) or ('far', distance)."""
    if isinstance(values, sp.FiniteSet):
        return [("element", i) for i in range(len(values))]
    edges = []
    if values.start is not sp.S.NegativeInfinity and not values.left_open:
        edges.append(("end", 0))
    if values.end is not sp.S.Infinity and not values.right_open:
        edges.append(("end", 1))
    if values.end is sp.S.Infinity or values.start is sp.S.NegativeInfinity:
        return edges + [("far", f) for f in _FAR]
    return edges + [("fraction", f) for f in _NEAR_END]


def _pick(values, edge, rng):
    if isinstance(values, sp.FiniteSet):
        members = sorted(values, key=sp.default_sort_key)
        return members[edge[1]] if edge and edge[0] == "element" else rng.choice(members)
    low, high = values.start, values.end
    if edge and edge[0] == "end":
        return low if edge[1] == 0 else high
    if low.is_finite and high.is_finite:
        fraction = edge[1] if edge else sp.Rational(rng.randint(1, 9999), 10000)
        return low + (high - low) * fraction
    step = edge[1] if edge else rng.choice(_INNER) * sp.Rational(rng.randint(500, 2000), 1000)
    if low.is_finite:
        return low + step
    if high.is_finite:
        return high - step
    return step * rng.choice((1, -1))
