"""The best angle as a function of alpha: against a search for the longest range, which knows no formula for either."""

import functools

import mpmath as mp
import pytest
import sympy as sp

from galileo_sym.derivations.projectile.notation import H, StationaryAngle, Theta, alpha, alpha_0, n, w
from galileo_sym.ledger import Continuous, Kind, PowerSeries, StrictlyDecreasing

pytestmark = pytest.mark.xdist_group("projectile")


@functools.lru_cache
def longest(a):
    """Elevation of the longest range for g = v = 1 and k = a: by cutting an interval in three."""

    def reach(angle):
        s, c = mp.sin(angle), mp.cos(angle)
        height = lambda t: (-a * t + 1 + a * s - mp.exp(-a * t) * (1 + a * s)) / a**2  # noqa: E731
        impact = mp.findroot(height, (s, 2 * s), solver="anderson", tol=mp.mpf(10) ** -60)
        return c * (1 - mp.exp(-a * impact)) / a

    with mp.workdps(40):
        low, high = mp.mpf(0), mp.pi / 4
        for _ in range(50):
            third = (high - low) / 3
            low, high = (low + third, high) if reach(low + third) < reach(high - third) else (low, high - third)
        return (low + high) / 2


ALPHAS = ("0.02", "0.7", "1", "1.3", "40")


@pytest.mark.parametrize("a", ALPHAS)
def test_the_angle_is_that_of_the_longest_range(ledger, a):
    formula = ledger["projectile.cont.claim"].result
    angle = next(e.rhs for e in formula.args if isinstance(e, sp.Eq) and e.lhs == Theta(alpha_0))
    assert abs(sp.N(angle.subs(alpha_0, sp.Rational(a)), 20) - longest(mp.mpf(a))) < 1e-7


def test_it_is_said_to_be_continuous_and_to_fall_from_0_on(ledger):
    whole = sp.Interval(0, sp.oo)
    assert Continuous(Theta(alpha_0), alpha_0, whole) in ledger["projectile.cont.claim"].result.args
    assert ledger["projectile.mono.theta"].result == StrictlyDecreasing(Theta(alpha_0), alpha_0, whole)
    angles = [mp.pi / 4, *(longest(mp.mpf(a)) for a in ALPHAS)]
    assert angles == sorted(angles, reverse=True)


@pytest.mark.parametrize("a", ["0.3", "1", "5"])
def test_the_slope_of_the_reciprocal_sine(ledger, a):
    slope = ledger["projectile.mono.deriv2"].result.rhs
    with mp.workdps(40):
        found = mp.diff(lambda x: 1 / mp.sin(StationaryAngle.mp_value(x)), mp.mpf(a))
        assert abs(sp.N(slope.subs(alpha, sp.Rational(a)), 30) - found) < 1e-15
    if a == "1":
        assert sp.simplify(slope.subs(alpha, 1) - (3 - sp.E)) == 0


def test_the_series_by_hand(ledger):
    """w e^w = e^(-1) (-1 + h^2/2 + h^3/3 + h^4/8 + h^5/30 + ...), h = w + 1."""
    series = next(e for e in ledger["projectile.cont.series"].result.args if isinstance(e, PowerSeries))
    by_hand = [-1, 0, sp.Rational(1, 2), sp.Rational(1, 3), sp.Rational(1, 8), sp.Rational(1, 30)]
    assert [sp.simplify(sp.E * series.args[3].subs(n, i)) for i in range(6)] == by_hand
    quotient = ledger["projectile.cont.H"]
    assert sp.Eq(H(-1), sp.Rational(1, 2)) in quotient.result.args
    entire = next(e for e in quotient.result.args if isinstance(e, PowerSeries))
    assert entire.args[3].subs(n, 0) == sp.Rational(1, 2)
    assert abs(entire.args[0].subs(w, 2) - sp.Float("4.574563")) < 1e-6  # (1 + 2 e^3)/9


@pytest.mark.parametrize(
    ("identifier", "statement"),
    [
        ("projectile.cont.sin0", "Eq(Limit(sin(Theta(alpha)), alpha, 0), 0)"),  # what SymPy's limit says
        ("projectile.cont.pi4", "Eq(Limit(Theta(alpha), alpha, 0), pi/6)"),
        ("projectile.mono.theta", "StrictlyIncreasing(Theta(alpha_0), alpha_0, Interval(0, oo))"),
        ("projectile.mono.alpha2", "Eq(alpha**2, 1 + W((alpha**2 - 1)/E)*exp(W((alpha**2 - 1)/E)))"),
        ("projectile.claim.asymmetry", "Lt(2*theta_max, pi/4)"),
        ("projectile.claim.nondimensional", "Independent(R(alpha*g/v, theta), g)"),
    ],
)
def test_a_false_variant_is_refuted(ledger, identifier, statement):
    assert ledger[identifier].compare(statement).kind is Kind.REFUTED


def test_the_range_is_not_symmetric_about_its_maximum():
    """Ranges 0.1 rad beside the best angle for k = v = g = 1, from the height equation alone."""
    best = longest(mp.mpf(1))

    def reach(angle):
        s = mp.sin(angle)
        impact = mp.findroot(lambda t: -t + 1 + s - mp.exp(-t) * (1 + s), (s, 2 * s), solver="anderson")
        return mp.cos(angle) * (1 - mp.exp(-impact))

    assert abs(reach(best - mp.mpf("0.1")) - reach(best + mp.mpf("0.1"))) > 1e-5
