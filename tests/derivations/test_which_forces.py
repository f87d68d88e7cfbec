"""Section 6 of the chord paper, held against motions integrated step by step."""

import math

import pytest
import sympy as sp

from galileo_sym.derivations.chord.notation import (
    AB,
    D,
    R,
    T,
    b,
    f,
    g,
    gamma,
    s,
    s_AB,
    t,
    t_0,
    theta,
    v,
    v_sup,
    x_c,
    xt,
    y,
    yt,
)
from galileo_sym.ledger import Domain, Independent, Kind, TracesOnce
from galileo_sym.ledger.check import counterexample
from galileo_sym.ledger.inventory import inventory

pytestmark = pytest.mark.xdist_group("chord")

GRAVITY, DIAMETER = 9.8, 3.0
ANGLES = (0.0, 0.5, 1.0, 1.4)
STEP = 2e-3


def descent_time(force, angle):
    """The time from A to B by Runge-Kutta steps of fourth order, the last one shortened to end at B."""
    pull, length = GRAVITY * math.cos(angle), DIAMETER * math.cos(angle)

    def after(place, speed, h):
        k1 = pull - force(speed)
        k2 = pull - force(speed + h / 2 * k1)
        k3 = pull - force(speed + h / 2 * k2)
        k4 = pull - force(speed + h * k3)
        return place + h * speed + h * h / 6 * (k1 + k2 + k3), speed + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

    time, place, speed = 0.0, 0.0, 0.0
    while True:
        there, then = after(place, speed, STEP)
        if there >= length:
            break
        time, place, speed = time + STEP, there, then
    h = (length - place) / speed
    for _ in range(20):
        there, then = after(place, speed, h)
        h -= (there - length) / then
    return time + h


def test_section_6_is_complete(ledger):
    wanted = {i.id for i in inventory().values() if i.paper == "chord" and i.section.startswith("6.")}
    assert {"chord.eq50", "chord.eq53", "chord.claim.only-linear"} <= wanted
    assert not {i for i in wanted if inventory()[i].kind != "figure"} - set(ledger)


def test_a_force_that_is_not_linear_keeps_the_paradox_if_no_bead_is_so_fast(ledger):
    """The counterexample to the print: with the very force that refutes it, the descent times agree."""
    entry = ledger["chord.claim.only-linear"]
    body = entry.erratum.domain.where[f(v)]
    force = sp.lambdify(v, body, "math")
    assert (force(4.0), force(6.0)) == pytest.approx((8.0, 20.47))
    for angle in ANGLES:
        assert descent_time(force, angle) == pytest.approx(1.0511583694, abs=1e-10)
    assert entry.erratum_verdict.kind is Kind.REFUTED


def test_a_quadratic_force_breaks_it():
    times = [descent_time(lambda speed: 0.5 * speed**2, angle) for angle in ANGLES]
    assert times == pytest.approx([0.985, 0.960, 0.891, 0.816], abs=5e-4)


def test_the_hypothesis_is_false_for_a_quadratic_force(ledger):
    """The exact motions with f = b v^2, for b per unit length: all but the paradox holds of them."""
    never_back, paradox = ledger["chord.eq53"].declaration.domain.supposing
    drag = sp.Symbol("drag", positive=True)

    def fall(pull):
        return sp.log(sp.cosh(sp.sqrt(drag * pull) * t)) / drag

    motions = {
        s(t): fall(g * sp.cos(theta)),
        R(t): fall(g) / 2,
        T(D): sp.acosh(sp.exp(drag * D)) / sp.sqrt(drag * g),
        AB(D): D * sp.cos(theta),
    }
    some = sp.FiniteSet(1)
    assert counterexample(never_back, Domain({g: some, drag: some}), motions, "quadratic") is None
    domain = Domain({g: some, drag: some, t_0: sp.FiniteSet(2), theta: sp.FiniteSet(1)})
    assert counterexample(paradox, domain, motions, "quadratic") is not None
    on_ac = Domain({**domain.ranges, theta: sp.FiniteSet(0)})
    assert counterexample(paradox, on_ac, motions, "quadratic") is None


def test_the_curve_is_the_whole_circle_but_for_a(ledger):
    """Any point of the circle above the axis is where a bead is, at the angle that its direction from A gives."""
    conclusion = ledger["chord.claim.paradox-implies-circles"].result.args[1]
    traced = next(e for e in conclusion.args if isinstance(e, TracesOnce))
    assert traced.args[2] == sp.Interval.open(-sp.pi / 2, sp.pi / 2)
    assert traced.args[4] == sp.Gt(y, 0)
    place = sp.lambdify((R(t), theta), tuple(traced.args[0]), "math")
    for turn in range(1, 12):
        across, down = 1.5 * math.sin(turn * math.pi / 6), 1.5 - 1.5 * math.cos(turn * math.pi / 6)
        assert place(1.5, math.atan2(across, down)) == pytest.approx((across, down))


@pytest.mark.parametrize(
    ("identifier", "quantity", "other"),
    [
        ("chord.claim.rhs-independent", s(t), g * t**2 * sp.cos(theta) ** 2),
        ("chord.claim.paradox-persists-linear-drag", s_AB, D),
        ("chord.claim.rescaled-time-independent", xt, t * yt),
        ("chord.claim.centre-line-angle", x_c(t), g * t),
    ],
)
def test_another_motion_is_not_independent(ledger, identifier, quantity, other):
    """The trials of independence fail where it is not so."""
    domain = ledger[identifier].declaration.domain
    claims = [e for e in ledger[identifier].result.args if isinstance(e, Independent)]
    assert claims
    for claim in claims:
        assert counterexample(claim, domain, dict(domain.where), identifier) is None
        moved = Domain({name: values for name, values in domain.ranges.items() if name != quantity}, domain.where)
        assert counterexample(claim, moved, {**domain.where, quantity: other}, identifier) is not None


def test_the_theorem_speaks_of_the_speeds_reached_alone(ledger):
    hypotheses, conclusion = ledger["chord.claim.only-linear"].result.args
    general = next(e for e in conclusion.args if hasattr(e, "bound_symbols"))
    assert general.args[2] == sp.Interval.open(0, v_sup)
    assert not conclusion.has(b)
    assert len(hypotheses.args) == 4


@pytest.mark.parametrize(
    "wrong",
    ["Eq(s, R(t)*cos(theta))", "Eq(s, 2*R(t)*sin(theta))", "Eq(s, -2*R(t)*cos(theta))", "Eq(s, 2*R(t))"],
)
def test_other_paths_are_refuted(ledger, wrong):
    assert ledger["chord.eq52"].compare("Eq(s, 2*R(t)*cos(theta))").kind is Kind.PROVED
    assert ledger["chord.eq52"].compare(wrong).kind is Kind.REFUTED


def test_the_root_that_is_dropped_refutes_the_print(ledger):
    assert ledger["chord.eq52"].erratum_verdict.kind is Kind.REFUTED


def test_linear_drag_reaches_the_end_of_each_chord_at_one_time(ledger):
    """2 R(t) cos(theta) with the R of (32), at the time found by integration, is the length of each chord."""
    half = ledger["chord.eq32"].result.rhs
    for angle in ANGLES:
        time = descent_time(lambda speed: 2 * speed, angle)
        assert 2 * half.subs({g: GRAVITY, gamma: 2, t: time}) == pytest.approx(DIAMETER, abs=1e-9)
