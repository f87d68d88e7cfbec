"""Small drag, both roots and the cases between: the ledger's results against root finding and integration alone."""

import pytest
import sympy as sp
from mpmath import mp

from galileo_sym.derivations.chord.notation import (
    D,
    F,
    Y,
    c,
    g,
    gamma,
    mu,
    q,
    sigma,
    slope_right,
    t,
    theta,
    w,
    x,
    y,
    zeta,
)
from galileo_sym.ledger import ExactlyOneRoot, Kind, TracesOnce, UniqueMaximum
from galileo_sym.ledger.numeric import holds

pytestmark = pytest.mark.xdist_group("chord")

SETTING = {mu: mp.mpf("0.36"), gamma: mp.mpf("0.7"), g: mp.mpf("9.8"), t: mp.mpf("1.3")}


@pytest.mark.parametrize("value", ["-0.35", "-1e-9", "1e-9", "2.5", "1e30"])
def test_w_where_each_branch_is_real(ledger, value):
    """The roots of w e^w = q, found by bisection, and no others, are those that (35) names: two for q < 0 only."""
    named = ledger["chord.eq35"].result.args[1]
    brackets = [(-1, 80)] if float(value) >= 0 else [(-1, 0), (-60, -1)]
    with mp.workdps(100):
        level = mp.mpf(value)
        for bracket in brackets:
            root = mp.findroot(lambda z: z * mp.exp(z) - level, bracket, solver="bisect", maxsteps=500)
            assert holds(named, {w: root, q: level})
            assert not holds(named, {w: root - mp.mpf("1e-40"), q: level})


def test_the_circle_goes_on_where_no_bead_is(ledger):
    """Errata C5: mu = 0.5 and theta = 1.3 in (19), (20) give x/K = -0.413, y/K = -0.115."""
    verdict = ledger["chord.eq21"].erratum_verdict
    assert verdict.kind is Kind.REFUTED
    gravity, time, across, down = (float(verdict.counterexample[name]) for name in ("g", "t", "x", "y"))
    unit = gravity * time**2 / 4
    assert (across / unit, down / unit) == pytest.approx((-0.413, -0.115), abs=5e-4)
    for identifier in ("chord.claim.arc-x-positive", "chord.eq44"):
        assert ledger[identifier].erratum_verdict.kind is Kind.REFUTED


def test_a_negative_drag_takes_the_other_branch(ledger):
    """Errata C7: the positive root, here by bisection, for D = g = 1, gamma = -1/2 is not that by W_0."""
    root = mp.findroot(lambda time: fallen(time, mp.mpf(-1) / 2, 1) - 1, (1, 2), solver="bisect")
    for identifier in ("chord.eq36", "chord.claim.principal-branch"):
        verdict = ledger[identifier].erratum_verdict
        assert verdict.kind is Kind.REFUTED
        assert float(verdict.counterexample["t_AB"]) == pytest.approx(float(root), rel=1e-11)


@pytest.mark.parametrize("number", ["eq26", "eq27", "eq43", "eq49", "law.friction"])
def test_no_friction_is_among_the_values(ledger, number):
    entry = ledger[f"chord.{number}"]
    assert entry.declaration.domain.ranges[mu].contains(0) == sp.true


def test_the_descent_with_friction_and_drag_when_there_is_no_friction(ledger):
    """(43) at mu = 0, on a chord at 1.2, against bisection of the fall along the vertical."""
    time = ledger["chord.eq43"].result.rhs.subs({mu: 0, theta: 1.2, D: 2, g: 9.8, gamma: 0.7})
    root = mp.findroot(lambda time: fallen(time, 0.7, 9.8) - 2, (0.1, 3), solver="bisect")
    assert float(time) == pytest.approx(float(root), rel=1e-12)


def fallen(time, drag, gravity):
    """g (gamma t - 1 + e^(-gamma t))/gamma^2."""
    return gravity * (drag * time - 1 + mp.exp(-drag * time)) / drag**2


def walk(slope, friction, drag, gravity, until, steps=400):
    """Distance and speed of a bead on a chord at a positive angle, by Runge and Kutta."""
    pull = gravity * (mp.cos(slope) - friction * mp.sin(slope))
    place, speed, dt = mp.mpf(0), mp.mpf(0), mp.mpf(until) / steps
    for _ in range(steps):
        k1 = pull - drag * speed
        k2 = pull - drag * (speed + dt / 2 * k1)
        k3 = pull - drag * (speed + dt / 2 * k2)
        k4 = pull - drag * (speed + dt * k3)
        place += dt * (speed + dt / 6 * (k1 + k2 + k3))
        speed += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return place, speed


@pytest.mark.parametrize(("identifier", "branch"), [("chord.eq38", 0), ("chord.eq39", -1)])
def test_the_branches_near_minus_1_over_e(ledger, identifier, branch):
    """Both limits told are approached like the root: ten digits nearer, five digits closer."""
    with mp.workdps(80):
        for part in ledger[identifier].result.args:
            limit, value = part.args
            ratio = limit.args[0].replace(lambda e: str(e.func) in ("W_0", "W_1"), lambda e: sp.Symbol("W"))
            gaps = []
            for nearer in (20, 30):
                place = -mp.exp(-1) + mp.mpf(10) ** -nearer
                known = sp.lambdify((q, sp.Symbol("W")), ratio, "mpmath")(place, mp.lambertw(place, branch).real)
                gaps.append(abs(known - mp.mpmathify(sp.N(value, 80))))
            assert gaps[1] < gaps[0] * mp.mpf(10) ** -4.9 < mp.mpf(10) ** -13


def test_the_remainder_of_the_parabola(ledger):
    with mp.workdps(60):
        for part in ledger["chord.eq37"].result.args:
            limit, value = part.args
            away = mp.mpf(10) ** -15 * (1 if str(limit.args[3]) == "+" else -1)
            ratio = sp.lambdify(w, limit.args[0].subs(F(w), w * sp.exp(w)), "mpmath")
            assert abs(ratio(-1 + away) - mp.mpf(str(sp.N(value, 50)))) < 1e-14


def test_both_times_at_small_drag_by_root_finding(ledger):
    told = [part.rhs.subs({D: 3, g: sp.Rational(49, 5)}) for part in ledger["chord.claim.gamma-limit-pm"].result.args]
    with mp.workdps(50):
        for value in told:
            root = mp.findroot(lambda time: fallen(time, mp.mpf(10) ** -12, mp.mpf("9.8")) - 3, float(value) * 1.01)
            assert abs(root - mp.mpf(str(sp.N(value, 40)))) < 1e-11
    assert sorted(value.is_positive for value in told) == [False, True]


@pytest.mark.parametrize(("low", "high", "root"), [(1, 3, 1.8414), (-3, -1, -1.1462)])
def test_both_roots_where_the_list_of_errata_has_them(ledger, low, high, root):
    """D = g = gamma = 1, that is c = 1."""
    claims = [part for part in ledger["chord.support.root-unique"].result.args if isinstance(part, ExactlyOneRoot)]
    (claim,) = (part for part in claims if root in part.args[2])
    height = sp.lambdify(zeta, claim.args[0].subs(c, 1), "mpmath")
    assert abs(mp.findroot(height, (low, high), solver="bisect") - root) < 5e-5


@pytest.mark.parametrize("slope", [0.1, 0.6, 1.1])
def test_integrated_beads_are_on_the_arcs_of_the_spindle(ledger, slope):
    depth = fallen(SETTING[t], SETTING[gamma], SETTING[g]) / 2
    distance, _ = walk(slope, *(SETTING[name] for name in (mu, gamma, g, t)))
    for arc in (part for part in ledger["chord.claim.spindle-drag"].result.args if isinstance(part, TracesOnce)):
        side = 1 if arc.args[4] == sp.Ge(x, 0) else -1
        place = sp.lambdify((theta, mu, Y(t)), list(arc.args[0]), "mpmath")(side * slope, SETTING[mu], depth)
        bead = (side * distance * mp.sin(slope), distance * mp.cos(slope))
        assert [float(p) for p in place] == pytest.approx([float(b) for b in bead], rel=1e-9)


def test_the_widest_integrated_bead(ledger):
    widest = next(part for part in ledger["chord.claim.spindle-drag"].result.args if isinstance(part, UniqueMaximum))
    place = float(widest.args[3].subs(mu, sp.Rational(9, 25)))
    here = [SETTING[name] for name in (mu, gamma, g, t)]
    widths = [walk(s, *here, 60)[0] * mp.sin(s) for s in (place - 0.01, place, place + 0.01)]
    assert max(widths) == widths[1]


def test_the_corner_between_integrated_beads(ledger):
    """A bead next to the vertical one is lower or higher by the slope told."""
    here = [SETTING[name] for name in (mu, gamma, g, t)]
    corner = ledger["chord.claim.both-sync-not-circle"].result
    told = next(e.rhs for e in corner.atoms(sp.Eq) if e.lhs == slope_right)
    (bottom, _), (beside, _) = walk(0, *here), walk(1e-6, *here)
    slope = (beside * mp.cos(1e-6) - bottom) / (beside * mp.sin(1e-6))
    assert float(slope) == pytest.approx(float(told.subs(mu, sp.Rational(9, 25))), abs=1e-5)


def test_the_last_speed(ledger):
    told = next(part.rhs for part in ledger["chord.support.terminal"].result.args if part.lhs.has(sp.Limit))
    _, speed = walk(0.6, 0.36, 2, 9.8, 30, 1500)
    assert float(speed) == pytest.approx(float(told.subs({g: 9.8, mu: 0.36, gamma: 2, theta: 0.6})), rel=1e-12)


def test_the_cases_between_are_the_motions_without_the_force(ledger):
    """Descent times are put into the integrated motion or the fall, places are compared with it."""
    point = {g: 9.8, D: 2, t: 0.9, theta: 0.4, mu: 0.25, gamma: 0.5, sigma: 1}
    alone, _ = walk(0.4, 0, 0, 9.8, 0.9, 20)
    slow, _ = walk(0.4, 0.25, 0, 9.8, 0.9, 20)
    bead = {x: slow * mp.sin(0.4), y: slow * mp.cos(0.4)}
    seen = []
    for part in ledger["chord.support.limits-between-cases"].result.args:
        force, value = part.lhs.args[1], float(part.rhs.subs(point).subs(bead))
        if force == mu:
            reached, wanted = fallen(value, 0.5, 9.8), 2
        elif part.lhs.has(sp.LambertW):
            reached, wanted = walk(0.4, 0.25, 0, 9.8, value, 20)[0], 2 * mp.cos(0.4)
        elif part.lhs.has(x):
            reached, wanted = value + 1, 1
        else:
            reached, wanted = value, alone if part.lhs.has(theta) else alone / mp.cos(0.4) / 2
        seen.append(float(reached) == pytest.approx(float(wanted), rel=1e-12))
    assert seen == [True] * 5
