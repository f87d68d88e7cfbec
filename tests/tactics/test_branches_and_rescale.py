"""Solutions by branch, and change of variables: what they give, and what they refuse."""

import pytest
import sympy as sp
from sympy import Eq, Ge, Interval, LambertW, Le, Lt, Or, exp, oo

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing
from galileo_sym.tactics import all_preimages, rescale

w, q = sp.symbols("w q", real=True)
t, z, k, L, T = sp.symbols("t z k L T", positive=True)
s, S = sp.Function("s", real=True), sp.Function("S", real=True)
P = w * exp(w)
LOW, HIGH = Interval(-oo, -1), Interval(-1, oo)


def _inverse(branch):
    return Eq(branch * exp(branch), q, evaluate=False)


UPPER = (StrictlyIncreasing(P, w, HIGH), _inverse(LambertW(q)), Ge(LambertW(q), -1))
LOWER = (StrictlyDecreasing(P, w, LOW), _inverse(LambertW(q, -1)), Le(LambertW(q, -1), -1))


def test_both_branches_are_all_solutions():
    found = all_preimages([UPPER, LOWER], w)
    assert Or(Eq(w, LambertW(q)), Eq(w, LambertW(q, -1))) in found.args
    assert Eq(P, q) in found.args


def test_a_half_without_solutions_needs_no_branch():
    found = all_preimages([UPPER], w, never=[(Interval.open(-oo, -1), Lt(P, q))])
    assert Eq(w, LambertW(q)) in found.args


@pytest.mark.parametrize(
    ("inverses", "never"),
    [
        ([UPPER], []),  # what about w < -1?
        ([UPPER], [(Interval.open(-oo, -2), Lt(P, q))]),  # a gap
        ([UPPER], [(Interval.open(-oo, -1), Le(P, q))]),  # it may be equal
        ([UPPER], [(Interval.open(-oo, -1), Lt(2 * P, q))]),  # of another function
        ([UPPER, (StrictlyDecreasing(P, w, LOW), _inverse(LambertW(q)), Ge(LambertW(q), -1))], []),  # wrong branch
        ([UPPER, (LOWER[0], Eq(LambertW(q, -1) * exp(LambertW(q, -1)), 2 * q), LOWER[2])], []),  # not the inverse
        ([(UPPER[0], Eq(UPPER[1].lhs, 2 * q), UPPER[2]), (LOWER[0], Eq(LOWER[1].lhs, 2 * q), LOWER[2])], []),
    ],
)
def test_missing_or_wrong_branches_are_refused(inverses, never):
    with pytest.raises(DerivationError):
        all_preimages(inverses, w, never=never)


LAW = Eq(s(t).diff(t, 2), -k * s(t).diff(t) - s(t) + t, evaluate=False)


def test_units_follow_the_chain_rule():
    changed = rescale(LAW, s(t), S(z), length=L, time=T)
    expected = Eq(L / T**2 * S(z).diff(z, 2), -k * L / T * S(z).diff(z) - L * S(z) + T * z, evaluate=False)
    assert sp.expand(changed.lhs - expected.lhs) == 0
    assert sp.expand(changed.rhs - expected.rhs) == 0


def test_a_solution_stays_a_solution():
    """s = sin(t) solves s'' = -s; in other units S(z) = sin(T z)/L must solve the changed law."""
    changed = rescale(Eq(s(t).diff(t, 2), -s(t)), s(t), S(z), length=L, time=T)
    residual = (changed.lhs - changed.rhs).subs(S(z), sp.sin(T * z) / L).doit()
    assert sp.simplify(residual) == 0


def test_time_backwards_turns_the_first_derivative():
    changed = rescale(Eq(s(t).diff(t, 2), -k * s(t).diff(t)), s(t), S(z), time=-1)
    assert changed == Eq(S(z).diff(z, 2), k * S(z).diff(z))


def test_initial_values():
    place = rescale(Eq(s(0), 3 * L), s(t), S(z), length=L, time=T)
    speed = rescale(Eq(s(t).diff(t).subs(t, 0), k), s(t), S(z), length=L, time=T)
    assert place == Eq(L * S(0), 3 * L, evaluate=False)
    assert speed == Eq(L / T * S(z).diff(z).subs(z, 0), k, evaluate=False)


def test_a_unit_that_depends_on_the_time_is_refused():
    with pytest.raises(DerivationError, match="depend on the time"):
        rescale(LAW, s(t), S(z), time=t * T)


@pytest.mark.parametrize("other", [sp.Derivative(t * s(t), t), sp.Integral(s(t), (t, 0, k)), sp.Derivative(s(k), k)])
def test_what_is_no_derivative_of_the_function_is_refused(other):
    with pytest.raises(DerivationError, match="not a derivative"):
        rescale(Eq(other, 1, evaluate=False), s(t), S(z), time=T)
