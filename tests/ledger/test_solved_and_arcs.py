"""Comparison solves for what stands in a one-to-one function, goes through cases, and writes arcs in one form."""

import pytest
import sympy as sp
from sympy import Eq, Interval, Ne, Piecewise, acos, acot, asin, atan, cos, pi, sin, sqrt, tan

from galileo_sym.ledger import Kind
from galileo_sym.ledger.arcs import as_arctangents
from galileo_sym.ledger.equivalence import equivalent
from galileo_sym.ledger.unwrap import same_in_cases, unwrapped

pytestmark = pytest.mark.xdist_group("compare")

p, q, angle, time = sp.symbols("p q angle time", positive=True)
x, y = sp.symbols("x y", real=True)
RANGES = {angle: Interval.open(0, pi / 2)}
W = "W((alpha**2 - 1)/E)"

RIGHT = {
    "time squared": ("chord.eq4", "Eq(t_AB**2, 2*D/g)"),
    "time squared, multiplied out": ("chord.eq4", "Eq(g*t_AB**2, 2*D)"),
    "time cubed": ("chord.eq4", "Eq(t_AB**3, (2*D/g)**Rational(3, 2))"),
    "time squared, times a divisor": ("chord.eq17", "Eq(g*(1 - mu*tan(theta))*t_AB**2, 2*D)"),
    "complement of an arctangent": ("chord.eq13", "Eq(theta_max, pi/2 - atan(mu))"),
    "arccotangent": ("chord.eq13", "Eq(theta_max, acot(mu))"),
    "arcsine": ("chord.eq13", "Eq(theta_max, asin(1/sqrt(1 + mu**2)))"),
    "tangent": ("chord.eq13", "Eq(mu*tan(theta_max), 1)"),
    "Theorem 3 without cases": ("projectile.thm3", f"Eq(theta_max, asin(alpha/(exp(1 + {W}) - 1)))"),
    "sine without cases": ("projectile.thm3", f"Eq(sin(theta_max), alpha/(exp(1 + {W}) - 1))"),
}
WRONG = {
    "time squared, halved": ("chord.eq4", "Eq(t_AB**2, D/g)"),
    "square of the square": ("chord.eq4", "Eq(t_AB**4, 2*D/g)"),
    "a square times what may vanish": ("chord.eq17", "Eq(g*(1 - mu*tan(theta))*tan(theta)*t_AB**2, 2*D*tan(theta))"),
    "sign of mu": ("chord.eq17", "Eq(g*(1 + mu*tan(theta))*t_AB**2, 2*D)"),
    "the arctangent itself": ("chord.eq13", "Eq(theta_max, atan(mu))"),
    "complement of the reciprocal": ("chord.eq13", "Eq(theta_max, pi/2 - atan(1/mu))"),
    "a full quarter more": ("chord.eq13", "Eq(theta_max, pi/2 + atan(mu))"),
    "cosine for sine": ("projectile.thm3", f"Eq(cos(theta_max), alpha/(exp(1 + {W}) - 1))"),
    "without the 1": ("projectile.thm3", f"Eq(sin(theta_max), alpha/(exp({W}) - 1))"),
    "the other angle": ("projectile.thm3", f"Eq(theta_max, pi - asin(alpha/(exp(1 + {W}) - 1)))"),
}  # fmt: skip


@pytest.mark.parametrize(("identifier", "statement"), RIGHT.values(), ids=RIGHT)
def test_a_restatement_is_proved(ledger, identifier, statement):
    assert ledger[identifier].compare(statement).kind is Kind.PROVED


@pytest.mark.parametrize(("identifier", "statement"), WRONG.values(), ids=WRONG)
def test_its_wrong_sibling_is_refuted(ledger, identifier, statement):
    assert ledger[identifier].compare(statement).kind is Kind.REFUTED


def test_theorem_3_and_its_unified_form_say_the_same(ledger):
    cases, single = ledger["projectile.thm3"], ledger["projectile.support.unified-thm3"]
    assert cases.compare(single.result).kind is Kind.PROVED
    assert single.compare(cases.result).kind is Kind.PROVED
    wrong_at_1 = cases.result.subs(asin(1 / (sp.E - 1)), asin(1 / sp.E))
    assert single.compare(wrong_at_1).kind is Kind.REFUTED


SOLVED = {
    "a positive quantity": (Eq(time**2, q), Eq(time, sqrt(q))),
    "an angle in its range": (Eq(sin(angle), x), Eq(angle, asin(x))),
    "a factor that is not 0": (Eq(p * tan(angle), 1), Eq(angle, atan(1 / p))),
}
UNSOLVED = {
    "of unknown sign": Eq(x**2, q),
    "in two powers": Eq(time**2 + time, q),
    "an angle without a range": Eq(sin(p), x),
    "in two functions": Eq(cos(angle), x * sin(angle)),
    "a factor that may vanish": Eq(x * time**2, q),
    "on both sides": Eq(time**2, sin(time)),
    "an inequality": sp.Lt(time**2, q),
}


@pytest.mark.parametrize(("equation", "solution"), SOLVED.values(), ids=SOLVED)
def test_what_is_solved(equation, solution):
    assert unwrapped(equation, equation, RANGES, (x, q, p)) == solution


@pytest.mark.parametrize("statement", UNSOLVED.values(), ids=UNSOLVED)
def test_what_is_left_alone(statement):
    assert unwrapped(statement, statement, RANGES, (x, q)) == statement


def test_a_cosine_is_not_undone_across_its_top():
    both = Eq(cos(angle), x)
    assert unwrapped(both, both, {angle: Interval(-pi / 2, pi / 2)}, (x,)) == both


ARCS = {
    "reciprocals": (atan(1 / p), pi / 2 - atan(p)),
    "negative reciprocals": (atan(-1 / p), atan(p) - pi / 2),
    "arccotangent": (acot(p), atan(1 / p)),
    "arcsine": (asin(p / sqrt(1 + p**2)), atan(p)),
    "arccosine": (acos(1 / sqrt(1 + p**2)), atan(p)),
}
NO_ARCS = {
    "of unknown sign": (atan(1 / x), pi / 2 - atan(x)),
    "not reciprocal": (atan(1 / p), pi / 2 - atan(2 * p)),
    "a sign": (atan(1 / p), atan(p) - pi / 2),
    "arcsine of unknown size": (asin(x), atan(x / sqrt(1 - x**2))),
}


@pytest.mark.parametrize(("one", "other"), ARCS.values(), ids=ARCS)
def test_equal_arcs(one, other):
    assert as_arctangents(one - other) == 0


@pytest.mark.parametrize(("one", "other"), NO_ARCS.values(), ids=NO_ARCS)
def test_arcs_that_are_not_shown_equal(one, other):
    assert as_arctangents(one - other) != 0


def test_cases_are_compared_where_they_hold():
    def same(a, b):
        return "same" if sp.simplify(a - b) == 0 else None

    assert same_in_cases(Piecewise((x**2, Ne(x, 2)), (4, True)), x**2, same)
    assert same_in_cases(x**2, Piecewise((4, Eq(x, 2)), (x**2, True)), same)
    assert same_in_cases(Piecewise((x**2, Ne(x, 2)), (5, True)), x**2, same) is None
    assert same_in_cases(Piecewise((x**2, x < 2), (4, True)), x**2, same) is None
    assert equivalent(Eq(y, Piecewise((x**2, Ne(x, 2)), (4, True))), Eq(y, x**2)) is not None
    assert equivalent(Eq(y, Piecewise((x**2, Ne(x, 2)), (5, True))), Eq(y, x**2)) is None
