"""The classical errors put into the ledger: a wrong start, a wrong branch, a wrong side. Nothing comes out proved."""

import pytest
import sympy as sp
from mutants import noticed
from sympy import And, Eq, LambertW, sin

from galileo_sym.derivations.projectile.notation import g, k, output, t, theta, u, v, x
from galileo_sym.ledger import Kind

pytestmark = pytest.mark.xdist_group("wrong moves")

LAUNCH = "projectile.setup"
BY_SOLVER_AND_SERIES = ("projectile.drag.{}", "beyond.taylor.projectile.drag.{}")


def _start(ledger, wanted, value):
    """The initial values with one of them replaced."""
    parts = ledger[LAUNCH].printed.args
    assert sum(map(wanted, parts)) == 1
    return And(*(Eq(e.lhs, value, evaluate=False) if wanted(e) else e for e in parts), evaluate=False)


@pytest.mark.parametrize("identifier", BY_SOLVER_AND_SERIES)
def test_the_right_start_is_not_noticed(ledger, identifier):
    assert not noticed(ledger, identifier.format("vy"), LAUNCH, ledger[LAUNCH].printed)


@pytest.mark.parametrize("identifier", BY_SOLVER_AND_SERIES)
def test_a_wrong_speed_at_the_start(ledger, identifier):
    slow = _start(ledger, lambda e: e.rhs.has(sin), v * sin(theta) / 2)
    assert noticed(ledger, identifier.format("vy"), LAUNCH, slow)


def test_a_wrong_place_at_the_start(ledger):
    """x(0) = v^2/g, so that dimensions agree."""
    moved = _start(ledger, lambda e: e.lhs == x(0), v**2 / g)
    assert noticed(ledger, "beyond.taylor.projectile.drag.x", LAUNCH, moved)
    assert noticed(ledger, "projectile.nodrag.x", LAUNCH, moved)


@pytest.mark.parametrize("identifier", ["projectile.impact.time", "chord.eq36", "chord.eq43"])
def test_a_root_on_the_wrong_branch(ledger, identifier):
    entry = ledger[identifier]
    swapped = entry.result.replace(lambda e: isinstance(e, LambertW), lambda e: LambertW(e.args[0], -1))
    assert swapped != entry.result
    verdict = entry.compare(swapped)
    assert verdict.kind is Kind.REFUTED
    assert verdict.counterexample


def test_a_limit_from_the_wrong_side(ledger):
    """W(u e^u) is u above -1, so that the quotient goes to +1 there."""
    entry = ledger["projectile.thm1.cor"]
    ratio, variable, point, direction = entry.result.lhs.args
    assert str(direction) == "-"
    other = Eq(sp.Limit(ratio, variable, point, "+"), entry.result.rhs, evaluate=False)
    assert entry.compare(other).kind is Kind.REFUTED


class TestInterlude:
    """What the commands of the Mathematica interlude put out, with SymPy in their place."""

    def test_solving_the_impact_equation(self, ledger):
        """Solve[y[t] == 0, t] with u in the coefficients: the printed time, by ProductLog."""
        equation = ledger["projectile.impact.eq-u"].result
        found = sp.solve(equation.lhs - equation.rhs, t)
        printed = ledger["projectile.impact.time"].result.rhs
        assert any(sp.simplify(root - printed) == 0 for root in found)

    def test_the_printed_output_is_the_velocity_at_impact(self, ledger):
        """By numbers: the output is x'(t) at impact, not the range; v cos(theta) - output, over k, is the range."""
        told = ledger["projectile.mathematica.range"].printed
        numbers = {v: 50, g: sp.Rational(322, 10), k: sp.Rational(1, 2), theta: sp.Rational(3, 5)}
        put_out = next(e.rhs for e in told.args if e.lhs == output).subs(numbers)
        at_impact = ledger["projectile.def.u"].printed.rhs.subs(numbers)
        time = ledger["projectile.impact.time"].printed.rhs.subs(u, at_impact).subs(numbers)
        speed = ledger["projectile.drag.vx"].printed.rhs.subs(t, time).subs(numbers)
        height = ledger["projectile.drag.y"].printed.rhs.subs(t, time).subs(numbers)
        place = ledger["projectile.drag.x"].printed.rhs.subs(t, time).subs(numbers)
        assert abs(sp.N(height, 30)) < 1e-25
        assert abs(sp.N(put_out) - 18.9715) < 5e-5
        assert abs(sp.N(put_out - speed, 30)) < 1e-25
        assert abs(sp.N((numbers[v] * sp.cos(numbers[theta]) - put_out) / numbers[k] - place, 30)) < 1e-25
        assert abs(sp.N(place) - 44.5906) < 5e-5

    def test_the_erratum_is_recorded(self, ledger):
        entry = ledger["projectile.mathematica.range"]
        assert entry.erratum.ids == ("S3",)
        assert entry.erratum_verdict.kind is Kind.REFUTED
