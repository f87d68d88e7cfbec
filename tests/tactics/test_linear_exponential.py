"""The equation a t + b + c e^(d t) = 0: coefficients and roots, and the equations that are refused."""

import pytest
import sympy as sp
from sympy import Eq, Ge, LambertW, exp

from galileo_sym.ledger import DerivationError
from galileo_sym.tactics import (
    check_root,
    other_branch,
    read_coefficients,
    require_real,
    root_of_product,
    solve_linear_exponential,
)

t, q, z = sp.symbols("t q z", real=True)
a, b, c, d = sp.symbols("a b c d", real=True, nonzero=True)
RESULT = Eq(t, -b / a - LambertW(c * d * exp(-b * d / a) / a) / d, evaluate=False)
NAMES = (t, a, b, c, d)


def test_coefficients_are_read_with_the_shift_of_the_exponent():
    found = read_coefficients(Eq(2 * z - 3 + 5 * exp(7 * z - 1), 4), z)
    assert dict(found.items()) == {"a": 2, "b": -7, "c": 5 * exp(-1), "d": 7}


@pytest.mark.parametrize(
    "left",
    [
        z + 1,
        z**2 + exp(z),
        exp(z) + exp(2 * z) + z,
        1 + exp(z),
        z * exp(z) - 1,
        z + exp(z**2),
    ],
)
def test_other_equations_are_refused(left):
    with pytest.raises(DerivationError):
        read_coefficients(Eq(left, 0, evaluate=False), z)


def test_root_by_result_3_solves_the_equation():
    equation = Eq(z + 2 - exp(z), 0, evaluate=False)
    root = solve_linear_exponential(RESULT, NAMES, equation, z, Ge(-exp(-2), -exp(-1), evaluate=False))
    assert root.rhs == -2 - LambertW(-exp(-2))
    assert abs(sp.N(equation.lhs.subs(z, root.rhs), 30)) < 1e-25
    other = other_branch(root.rhs)
    assert abs(sp.N(equation.lhs.subs(z, other), 30)) < 1e-25
    assert sp.N(other) > 1


def test_wrong_result_or_condition_is_refused():
    equation = Eq(z + 2 - exp(z), 0, evaluate=False)
    real = Ge(-exp(-2), -exp(-1), evaluate=False)
    wrong = Eq(t, -b / a + LambertW(c * d * exp(-b * d / a) / a) / d, evaluate=False)
    with pytest.raises(DerivationError, match="does not solve"):
        solve_linear_exponential(wrong, NAMES, equation, z, real)
    with pytest.raises(DerivationError, match="condition"):
        solve_linear_exponential(RESULT, NAMES, equation, z, Ge(q, -exp(-1)))


def test_check_root_refuses_a_number_that_is_none():
    with pytest.raises(DerivationError, match="does not solve"):
        check_root(Eq(z + 2 - exp(z), 0, evaluate=False), z, sp.S.One)


def test_require_real_asks_for_the_branch_point():
    require_real(LambertW(q), Ge(q, -exp(-1)))
    for told in (Ge(q, -1), Ge(z, -exp(-1)), sp.Gt(q, 0)):
        with pytest.raises(DerivationError):
            require_real(LambertW(q), told)


def test_root_of_product_asks_for_the_form_and_for_result_1():
    product = Eq((z - 1) * exp(z - 1), 3, evaluate=False)
    result_1 = Eq(q, LambertW(q) * exp(LambertW(q)), evaluate=False)
    assert root_of_product(product, result_1, q) == Eq(z - 1, LambertW(3), evaluate=False)
    with pytest.raises(DerivationError):
        root_of_product(Eq(z * exp(z - 1), 3, evaluate=False), result_1, q)
    with pytest.raises(DerivationError):
        root_of_product(product, Eq(q, LambertW(q) * exp(2 * LambertW(q)), evaluate=False), q)
