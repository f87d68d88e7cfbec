"""Points to try: all inside the assumptions, every edge among them, the same ones every time."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from small_ledger import p, q, r
from sympy import FiniteSet, Interval, Rational, Union, atan, oo, pi

from galileo_sym.ledger import NONNEGATIVE, POSITIVE, REAL, Domain
from galileo_sym.ledger.domain import EmptyDomain

RANGES = {
    "positive": {p: POSITIVE},
    "not negative": {q: NONNEGATIVE},
    "real": {q: REAL},
    "negative": {q: Interval.open(-oo, 0)},
    "closed": {q: Interval(-pi / 2, pi / 2)},
    "open": {q: Interval.open(-1, 1)},
    "an end that depends": {p: POSITIVE, q: Interval(0, atan(1 / p))},
    "both ends depend": {p: POSITIVE, q: Interval.open(-p, p), r: Interval.Lopen(q, p)},
    "list": {q: FiniteSet(1, -1, Rational(1, 3))},
    "pieces": {q: Union(Interval.open(0, 1), Interval.open(1, oo), evaluate=False)},
    "shrunk to a number": {p: FiniteSet(2), q: Interval(2, p)},
}


@pytest.mark.parametrize("ranges", RANGES.values(), ids=RANGES)
def test_every_point_is_inside(ranges):
    for point in Domain(ranges).points(20, "seed"):
        assert set(point) == set(ranges)
        for symbol, values in ranges.items():
            assert values.subs(point).contains(point[symbol]) == sp.true


@pytest.mark.parametrize("ranges", RANGES.values(), ids=RANGES)
def test_every_point_satisfies_the_condition(ranges):
    domain = Domain(ranges)
    assert all(domain.condition.subs(point) == sp.true for point in domain.points(20, "seed"))


def test_the_condition_is_false_outside():
    condition = Domain({p: POSITIVE, q: Interval.Ropen(0, p)}).condition
    assert condition.subs({p: 2, q: 0}) == sp.true
    for outside in ({p: 2, q: 2}, {p: 2, q: -1}, {p: 2, q: 3}):
        assert condition.subs(outside) == sp.false


def _taken(ranges, symbol=q, count=5):
    return [point[symbol] for point in Domain(ranges).points(count, "seed")]


def test_closed_ends_are_tried_and_open_ones_are_not():
    assert {0, 1} <= set(_taken({q: Interval(0, 1)}))
    assert not {0, 1} & set(_taken({q: Interval.open(0, 1)}))
    half = set(_taken({q: Interval.Ropen(0, 1)}))
    assert 0 in half
    assert 1 not in half


def test_open_ends_are_approached_and_infinite_ones_are_far_away():
    finite = _taken({q: Interval.open(0, 1)})
    assert min(finite) <= Rational(1, 10**6)
    assert max(finite) >= 1 - Rational(1, 10**6)
    infinite = _taken({q: POSITIVE})
    assert 0 < min(infinite) <= Rational(1, 10**9)
    assert max(infinite) >= 10**6


def test_the_whole_line_has_both_signs():
    signs = {sp.sign(x) for x in _taken({q: REAL}, count=30)}
    assert {1, -1} <= signs


def test_an_end_that_depends_is_tried_where_the_other_variable_is():
    points = Domain({p: POSITIVE, q: Interval(0, atan(1 / p))}).points(5, "seed")
    assert any(point[q] == atan(1 / point[p]) for point in points)


def test_every_member_of_a_list_and_every_piece_is_tried():
    assert set(_taken({q: FiniteSet(1, -1, 7)}, count=1)) == {1, -1, 7}
    pieces = Union(Interval.open(0, 1), Interval.open(1, oo), evaluate=False)
    taken = _taken({q: pieces}, count=1)
    assert any(x < 1 for x in taken)
    assert any(x > 1 for x in taken)


def test_the_count_is_that_of_points_beside_the_edges():
    edges = len(_taken({q: Interval(0, 1)}, count=0))
    assert edges >= 4
    assert len(_taken({q: Interval(0, 1)}, count=7)) == edges + 7


def test_points_are_exact_and_repeat_with_the_seed():
    domain = Domain({p: POSITIVE, q: Interval(0, p)})
    assert domain.points(10, "one") == domain.points(10, "one")
    assert domain.points(10, "one") != domain.points(10, "two")
    assert not any(v.has(sp.Float) for point in domain.points(10, "one") for v in point.values())


@pytest.mark.parametrize(
    "ranges", [{q: sp.S.EmptySet}, {p: POSITIVE, q: Interval.open(p, p)}, {p: FiniteSet(3), q: Interval(p, 2)}]
)
def test_no_point_is_said_not_skipped(ranges):
    with pytest.raises(EmptyDomain, match="q"):
        Domain(ranges).points(3, "seed")


def test_a_domain_cannot_be_changed():
    ranges = {p: POSITIVE}
    domain = Domain(ranges)
    ranges[q] = REAL
    assert set(domain.ranges) == {p}
    with pytest.raises(TypeError):
        domain.ranges[q] = REAL


@settings(max_examples=60, deadline=None)
@given(low=st.fractions(-5, 5), width=st.fractions(Rational(1, 100), 9), opens=st.tuples(st.booleans(), st.booleans()))
def test_any_interval_has_its_ends_if_they_are_closed(low, width, opens):
    start, end = Rational(low), Rational(low) + Rational(width)
    taken = set(_taken({q: Interval(start, end, *opens)}, count=3))
    assert (start in taken, end in taken) == (not opens[0], not opens[1])
    assert all(start <= x <= end for x in taken)
