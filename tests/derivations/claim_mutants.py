"""Claims about a function as a whole, each made false: another order, place, interval, curve or region."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import predicates


def claims(claim):
    """Pairs (operator, changed claim)."""
    for operator, place, change in _CHANGES.get(type(claim), ()):
        for other in change(claim.args[place], claim):
            yield operator, claim.func(*claim.args[:place], other, *claim.args[place + 1 :])
    if type(claim) in _OPPOSITE:
        yield "order reversed", _OPPOSITE[type(claim)](*claim.args)


def _negated(f, claim):
    yield -f


def _with_another_root(f, claim):
    """A factor that vanishes inside the interval, too."""
    _, x, interval = claim.args
    low, high = interval.start, interval.end
    inside = (low + high) / 2 if (high - low).is_finite else low + 1 if low.is_finite else high - 1
    yield f * (x - inside)


def _shifted(place, claim):
    yield place + sp.Rational(1, 10)


def _without_root(f, claim):
    yield f**2 + 1


def _with_the_variable(f, claim):
    yield f + claim.args[1]


def _other_variable(x, claim):
    yield from sorted(claim.args[0].free_symbols - {x}, key=str)


def _other_side(region, claim):
    if region != sp.true:
        yield _REVERSED[region.func](*region.args, evaluate=False)


def _other_curve(curve, claim):
    yield sp.Eq(curve.lhs, 2 * curve.rhs, evaluate=False)


def _other_point(point, claim):
    x, y = point
    yield sp.Tuple(y, x)
    yield sp.Tuple(-x, y)
    yield sp.Tuple(x, 2 * y)


def _half(interval, claim):
    middle = (interval.start + interval.end) / 2
    yield sp.Interval(interval.start, middle, interval.left_open, False)
    yield sp.Interval(
        interval.start, interval.end + (interval.end - interval.start), interval.left_open, interval.right_open
    )


_REVERSED = {
    sp.StrictGreaterThan: sp.StrictLessThan,
    sp.StrictLessThan: sp.StrictGreaterThan,
    sp.GreaterThan: sp.LessThan,
    sp.LessThan: sp.GreaterThan,
}

_OPPOSITE = {
    predicates.StrictlyIncreasing: predicates.StrictlyDecreasing,
    predicates.StrictlyDecreasing: predicates.StrictlyIncreasing,
}

_CHANGES = {
    predicates.StrictlyIncreasing: [("function negated", 0, _negated)],
    predicates.StrictlyDecreasing: [("function negated", 0, _negated)],
    predicates.ExactlyOneRoot: [("no root", 0, _without_root), ("another root", 0, _with_another_root)],
    predicates.UniqueMaximum: [("function negated", 0, _negated), ("place shifted", 3, _shifted)],
    predicates.Independent: [("made dependent", 0, _with_the_variable), ("of another variable", 1, _other_variable)],
    predicates.TracesOnce: [
        ("other point", 0, _other_point),
        ("other interval", 2, _half),
        ("other curve", 3, _other_curve),
        ("region reversed", 4, _other_side),
        ("inverse negated", 6, _negated),
    ],
}
