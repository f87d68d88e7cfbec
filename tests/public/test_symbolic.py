"""The symbolic faces: each stable form agrees in numbers with the numeric function it was emitted from."""

import numpy as np
import pytest
from sympy import Basic, Rational

import galileo_sym
from galileo_sym import symbolic
from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.solvers import SOLVERS

VALUES = {"t": 0.75, "theta": 0.5, "diameter": 1.5, "g": 9.81, "mu": 0.25, "gamma": 0.625, "v": 3.5, "k": 0.375}
VALUES |= {"alpha": 1.25, "r": 0.5, "x": -0.25, "a": 1.0, "b": 2.0, "c": -1.0, "d": 1.0}
KERNELS = [(name, force_set) for name, function in FUNCTIONS.items() for force_set in function.variants]


def _symbolic(name):
    paper, function = name.split(".")
    return getattr(getattr(symbolic, paper), function)


@pytest.mark.parametrize(("name", "force_set"), [kernel for kernel in KERNELS if kernel not in SOLVERS])
def test_stable_form_in_numbers(name, force_set):
    function = FUNCTIONS[name]
    forms = _symbolic(name).stable[force_set]
    forms = forms if isinstance(forms, tuple) else (forms,)
    point = {a.symbol: VALUES[a.name] for a in function.arguments(force_set)}
    numeric = getattr(getattr(galileo_sym, function.paper), function.name)
    names = [a.name for a in function.arguments(force_set)]
    positional = [VALUES[n] for n in function.positional]
    results = numeric(*positional, **{n: VALUES[n] for n in names if n not in function.positional})
    for form, result in zip(forms, np.atleast_1d(results), strict=True):
        exact = form.subs({s: Rational(point[s.name]) for s in form.free_symbols}).evalf(30)
        assert abs(float(exact) - result) <= np.spacing(abs(result))


def test_an_equation_to_solve_holds_at_both_angles():
    equations = symbolic.projectile.launch_angles.stable["drag"]
    shot = {"v": VALUES["v"], "g": VALUES["g"], "k": VALUES["k"]}
    for theta in galileo_sym.projectile.launch_angles(VALUES["r"], **shot):
        numbers = {
            "theta": theta,
            "alpha": shot["k"] * shot["v"] / shot["g"],
            "rho": VALUES["r"] * shot["g"] / shot["v"] ** 2,
            "z": galileo_sym.projectile.flight_time(theta, **shot) * shot["g"] / shot["v"],
        }
        point = {s: Rational(float(numbers[s.name])) for s in equations.free_symbols}
        for equation in equations.args:
            left, right = (side.subs(point).evalf(30) for side in equation.args)
            assert float(left) == pytest.approx(float(right), rel=1e-13)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_printed_equations_come_from_the_ledger(name):
    function = _symbolic(name)
    assert function.force_sets == tuple(FUNCTIONS[name].variants)
    for statements in function.printed.values():
        assert statements
        assert all(isinstance(statement, Basic) for statement in statements)


def test_the_name_and_forces_are_shown():
    assert repr(symbolic.chord.descent_time) == (
        "<SymbolicFunction chord.descent_time, force sets free, friction, drag, friction_drag>"
    )
