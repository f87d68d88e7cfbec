"""The plan of a kernel: named steps, nothing twice, operation counts; what cannot be emitted is refused."""

import pytest
from sympy import Function, Rational, Symbol, gamma

from galileo_sym.catalogue import FUNCTIONS, stable
from galileo_sym.codegen import schedule as scheduling
from galileo_sym.codegen.printing import call_text
from galileo_sym.codegen.schedule import schedule

PLANNED = [name for name, function in FUNCTIONS.items() if not (function.routine or function.primitive)]
KERNELS = [(name, s) for name in PLANNED for s in FUNCTIONS[name].variants]


def _plan(name, force_set):
    plan = schedule(FUNCTIONS[name], force_set)
    return [f"{step} = {call_text(node, '')}" for step, node in plan.steps], [call_text(r, "") for r in plan.results]


def test_descent_time_reads_like_the_formula():
    steps, results = _plan("chord.descent_time", "friction_drag")
    assert steps == [
        "a = angle(theta)",
        "C = cosine(a)",
        "n = driving(a, mu)",
        "t0 = sqrt(scale(div(mul(D, C), mul(g, n)), 1))",
        "p = mul(gamma, t0)",
    ]
    assert results == ["mul(t0, descent_factor(p))"]


def test_outputs_share_their_common_factor():
    steps, results = _plan("chord.position", "drag")
    assert steps[-2:] == ["shared = mul(mul(fall, C), phi2m(z))", "S = sine(a)"]
    assert results == ["mul(shared, S)", "mul(shared, C)"]


@pytest.mark.parametrize(("name", "force_set"), KERNELS)
def test_no_name_is_given_twice_and_every_name_is_used(name, force_set):
    plan = schedule(FUNCTIONS[name], force_set)
    names = [step for step, _ in plan.steps]
    assert len(set(names)) == len(names)
    text = str(plan.nodes)
    assert all(f"'{step}'" in text or f"'{step}." in text for step in [*names, *plan.loads])


@pytest.mark.parametrize(("name", "force_set"), [(n, f) for n, f in KERNELS if FUNCTIONS[n].ceiling is None])
def test_a_primitive_is_evaluated_once_for_each_argument(name, force_set):
    plan = schedule(FUNCTIONS[name], force_set)
    calls = {call for form in stable(FUNCTIONS[name], force_set) for call in form.atoms(Function)}
    tables = {call for call in calls if call.func.__name__ in scheduling.OF_NUMBER}
    assert plan.counts["table"] == len(tables)


@pytest.mark.parametrize("force_set", ["free", "drag"])
def test_the_ceiling_of_an_argument_is_the_function_it_names(force_set):
    plan = schedule(FUNCTIONS["projectile.launch_angles"], force_set)
    (most,) = schedule(FUNCTIONS["projectile.max_range"], force_set).results
    assert call_text(plan.limit.most, "") == call_text(most, "")
    alpha = "alpha" if force_set == "drag" else "constant(0.0)"
    assert call_text(plan.limit.there, "") == f"best_elevation({alpha})"


def test_what_a_solver_evaluates_comes_from_the_ledger():
    plan = schedule(FUNCTIONS["projectile.launch_angles"], "drag")
    assert plan.names == ("low", "high")
    assert plan.balance.names == ("square", "slope", "bend", "rise", "lean")
    assert ("d", ("decay", "s")) in plan.balance.steps
    assert call_text(plan.balance.results[3], "") == "fall"


def test_counts():
    counts = schedule(FUNCTIONS["chord.descent_time"], "friction_drag").counts
    assert counts == {"sine and cosine": 1, "driving force": 1, "sqrt": 1, "div": 1, "mul": 4, "table": 1}


@pytest.mark.parametrize("form", [gamma(Symbol("g", positive=True)), Symbol("g", positive=True) + Rational(1, 3)])
def test_what_has_no_scaled_operation_is_refused(monkeypatch, form):
    monkeypatch.setattr(scheduling, "stable", lambda function, force_set: (form,))
    with pytest.raises(TypeError, match=r"no emitted function|not a double"):
        schedule(FUNCTIONS["chord.descent_time"], "free")


def test_rational_coefficients(monkeypatch):
    g = Symbol("g", positive=True)
    monkeypatch.setattr(scheduling, "stable", lambda function, force_set: (Rational(6, 5) * g,))
    plan = schedule(FUNCTIONS["chord.descent_time"], "free")
    assert call_text(plan.results[0], "") == "scale(div(mul(constant(3.0), g), constant(5.0)), 1)"
