"""Every real root of a t + b + c e^(d t), and the second root of the descent, against root searches and integration."""

from itertools import pairwise

import mpmath
import pytest
import sympy as sp
from mpmath import mp

from galileo_sym.derivations.beyond.chord_notation import t_minus
from galileo_sym.ledger import Domain, Kind, Ledger, tell
from galileo_sym.ledger.check import counterexample

pytestmark = pytest.mark.xdist_group("projectile")

IDS = [e.id for e in Ledger.load().select(["beyond.real_roots", "beyond.second_root"])]


@pytest.mark.parametrize("identifier", IDS)
def test_entry_is_proved(ledger, identifier):
    assert ledger[identifier].verdict.kind is Kind.PROVED, tell(ledger[identifier])


def test_every_case_is_there():
    cases = {"none", "double", "two", "one", "order", "impact"}
    assert {f"beyond.real-roots.{case}" for case in cases} <= set(IDS)


def _found(a, b, c, d):
    """Real roots by a scan for changes of sign, refined: no Lambert W."""

    def f(t):
        return a * t + b + c * mpmath.exp(d * t)

    grid = [mpmath.mpf(n) / 16 + 0.013 for n in range(-640, 641)]
    return [mpmath.findroot(f, pair, solver="anderson") for pair in pairwise(grid) if f(pair[0]) * f(pair[1]) < 0]


@pytest.mark.parametrize(
    ("case", "coefficients"),
    [
        ("two", (1, 2, -1, 1)),  # errata S2: -1.8414 and 1.1462
        ("two", (3, -10, 5, -0.25)),
        ("two", (-1, 1.5, -1.5, -1)),  # the impact equation at u = -3/2: 0 and 0.87
        ("one", (2, -7, 3, 0.5)),
        ("one", (-2, 1, 3, -0.5)),
        ("none", (1, 1, 2, -3)),
        ("none", (-1, 0, 3, 1)),
    ],
)
def test_roots_and_their_number(ledger, case, coefficients):
    a, b, c, d = coefficients
    q = c * d * mpmath.exp(-b * d / a) / a
    belongs = {"one": q >= 0, "two": -mpmath.exp(-1) < q < 0, "none": q < -mpmath.exp(-1)}
    assert belongs[case]
    told = ledger[f"beyond.real-roots.{case}"].result
    values = dict(zip("abcdq", (*coefficients, q), strict=True))
    put = {s: values[s.name] for s in told.free_symbols if s.name in values}
    times = [] if case == "none" else [e for e in told.atoms(sp.Eq) if e.lhs.is_Symbol]
    roots = sorted(mp.mpf(sp.N(e.rhs.subs(put), 20)) for e in times)
    expected = _found(*coefficients)
    assert len(roots) == len(expected)
    assert all(abs(x - y) < 1e-10 for x, y in zip(roots, expected, strict=True))


def _value(expr, **numbers):
    return mp.mpf(sp.N(expr.subs({s: numbers[s.name] for s in expr.free_symbols}), 25))


def _pair(ledger, **numbers):
    """The times of (30): before the release and after it."""
    told = ledger["beyond.second-root.time"].result.args
    before = next(e.rhs for e in told if isinstance(e, sp.Eq) and e.lhs == t_minus)
    return _value(before, **numbers), _value(ledger["chord.eq36"].result.rhs, **numbers)


def test_the_roots_of_the_errata(ledger):
    before, after = _pair(ledger, D=1, g=1, gamma=1)
    assert (round(before, 4), round(after, 4)) == (-1.1462, 1.8414)


@pytest.mark.parametrize(("size", "pull", "drag"), [(1, 9.8, 0.1), (3, 2, 4), (0.2, 1, 30)])
def test_a_bead_thrown_up_from_b_stops_in_a(ledger, size, pull, drag):
    """Integrate the law from B at t_minus: at t = 0 the bead is in A, at rest, and at t_AB it is back in B."""
    before, after = _pair(ledger, D=size, g=pull, gamma=drag)
    slope = mpmath.cos(0.7)
    start = [size * slope, pull * slope * before - drag * size * slope]
    with mp.workdps(20):
        motion = mpmath.odefun(lambda t, s: [s[1], pull * slope - drag * s[1]], before, start)
        place, speed = motion(0)
        back = motion(after)[0]
    assert abs(place) < 1e-12 * size
    assert abs(speed) < 1e-12
    assert abs(back - size * slope) < 1e-12 * size
    assert -before < after


def test_negative_drag_exchanges_the_branches(ledger):
    """Errata C7: D = g = 1, gamma = -1/2 gives -1.60 by W and 1.265 by W_(-1)."""
    told = ledger["beyond.second-root.push"].result
    values = {type(e): _value(e.lhs, D=1, g=1, push=sp.Rational(1, 2)) for e in told.args if e.is_Relational}
    assert round(values[sp.Gt], 3) == 1.265
    assert round(values[sp.Lt], 2) == -1.60


def test_the_mean_of_the_roots_for_little_drag(ledger):
    """Their sum is gamma times 2 D/(3 g) in the limit."""
    before, after = _pair(ledger, D=2, g=3, gamma=sp.Rational(1, 10**6))
    limits = ledger["beyond.second-root.limits"].result.args
    told = next(e.rhs for e in limits if not e.rhs.has(sp.sqrt(2)))
    assert abs((before + after) * 10**6 - _value(told, D=2, g=3)) < 1e-5


def test_a_root_on_the_wrong_branch_is_refuted(ledger):
    entry = ledger["beyond.real-roots.one"]
    (root,) = entry.result.atoms(sp.LambertW)
    assert entry.compare(entry.result.xreplace({root: sp.LambertW(root.args[0], -1)})).kind is Kind.REFUTED


def test_no_root_can_be_refuted(ledger):
    """The left side keeps its sign for q < -1/e, and no further: a statement that two numbers differ hardly fails."""
    entry = ledger["beyond.real-roots.none"]
    assert entry.compare("a*d*(a*t + b + c*exp(d*t)) > 0").kind is Kind.REFUTED
    (q,) = (s for s in entry.declaration.domain.ranges if s.name == "q")
    ranges = {**entry.declaration.domain.ranges, q: sp.Interval.open(-sp.exp(-1), 0)}
    wider = Domain(ranges, where=entry.declaration.domain.where)
    assert counterexample(entry.declaration.printed, wider, dict(wider.where), entry.id)
