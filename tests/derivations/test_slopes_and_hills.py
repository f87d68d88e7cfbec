"""Slopes, hills and pure numbers, against the laws of motion integrated step by step."""

import mpmath
import pytest
import sympy as sp
from mpmath import mp

from galileo_sym.ledger import Kind, Ledger, tell

pytestmark = pytest.mark.xdist_group("projectile")

CHAPTERS = ["beyond.slopes", "beyond.hills", "beyond.pure_flight", "beyond.pure_descent"]
IDS = [e.id for e in Ledger.load().select(CHAPTERS)]


@pytest.mark.parametrize("identifier", IDS)
def test_entry_is_proved(ledger, identifier):
    assert ledger[identifier].verdict.kind is Kind.PROVED, tell(ledger[identifier])


def _flight(v, g, k, theta):
    """Place as a function of time, from the laws alone."""
    start = [0, 0, v * mpmath.cos(theta), v * mpmath.sin(theta)]
    return mpmath.odefun(lambda _, s: [s[2], s[3], -k * s[2], -g - k * s[3]], 0, start)


def _lands(place, line, near):
    """When the flight meets a line, height(x, y) = 0, after the launch."""
    return mpmath.findroot(lambda t: line(*place(t)[:2]), (near * 0.9, near * 1.1), solver="anderson", tol=1e-16)


def _value(ledger, identifier, name, **numbers):
    """What an entry says of a quantity, its names put in until numbers are left."""
    parts = _parts(ledger[identifier].result)
    told = next(e.rhs for e in parts if isinstance(e, sp.Eq) and str(e.lhs) == name)
    return mp.mpf(sp.N(told.subs({s: numbers[s.name] for s in told.free_symbols}), 20))


def _parts(statement):
    return statement.args if isinstance(statement, sp.And) else (statement,)


@pytest.mark.parametrize(
    ("v", "g", "k", "theta", "beta"), [(20, 9.8, 0.4, 0.9, 0.3), (50, 9.8, 0.1, 0.4, -0.6), (5, 3, 2, 1.2, 1.1)]
)
def test_slope(ledger, v, g, k, theta, beta):
    lift = _value(ledger, "beyond.slopes.u", "lift", theta=theta, beta=beta)
    u = _value(ledger, "beyond.slopes.u", "u", g=g, v=v, k=k, lift=lift)
    time = _value(ledger, "beyond.slopes.time", "time", u=u, k=k)
    length = _value(ledger, "beyond.slopes.range", "reach", u=u, k=k, v=v, theta=theta, beta=beta)
    with mp.workdps(20):
        place = _flight(v, g, k, theta)
        hit = _lands(place, lambda x, y: y - x * mpmath.tan(beta), time)
        across, up = place(hit)[:2]
    assert abs(hit - time) < 1e-10 * time
    assert abs(mpmath.hypot(across, up) - length) < 1e-10 * length


def test_slope_without_resistance_is_the_known_formula(ledger):
    v, g, theta, beta = 12, 9.8, 0.8, 0.35
    known = 2 * v**2 * mpmath.cos(theta) * mpmath.sin(theta - beta) / (g * mpmath.cos(beta) ** 2)
    assert abs(_value(ledger, "beyond.slopes.free", "reach", v=v, g=g, theta=theta, beta=beta) - known) < 1e-10


@pytest.mark.parametrize(
    ("v", "g", "k", "theta", "h"), [(20, 9.8, 0.4, 0.9, 30), (50, 9.8, 0.1, 0, 2), (5, 3, 2, 1.2, 100)]
)
def test_hill(ledger, v, g, k, theta, h):
    u = -1 - k * v / g * mpmath.sin(theta)
    eta = _value(ledger, "beyond.hills.height", "eta", k=k, g=g, h=h)
    time = _value(ledger, "beyond.hills.time", "time", u=u, eta=eta, k=k)
    length = _value(ledger, "beyond.hills.range", "reach", u=u, eta=eta, k=k, v=v, theta=theta)
    with mp.workdps(20):
        place = _flight(v, g, k, theta)
        hit = _lands(place, lambda _, y: y + h, time)
        across = place(hit)[0]
    assert abs(hit - time) < 1e-10 * time
    assert abs(across - length) < 1e-10 * length


def test_the_other_root_of_a_hill_is_a_throw_from_the_ground(ledger):
    """Thrown from the ground at the other root, under the same law, the projectile passes the hill at t = 0."""
    v, g, k, theta, h = 20, 9.8, 0.4, 0.9, 30
    u, eta = -1 - k * v / g * mpmath.sin(theta), k**2 * h / g
    before = next(e.lhs for e in ledger["beyond.hills.roots"].result.args if isinstance(e, sp.Lt))
    start = mp.mpf(sp.N(before.subs({s: {"u": u, "eta": eta, "k": k}[s.name] for s in before.free_symbols}), 20))
    rise = (v * mpmath.sin(theta) + g / k) * mpmath.exp(-k * start) - g / k
    with mp.workdps(20):
        height, speed = mpmath.odefun(lambda _, s: [s[1], -g - k * s[1]], start, [-h, rise])(0)
    assert start < 0
    assert abs(height) < 1e-9
    assert abs(speed - v * mpmath.sin(theta)) < 1e-9


def test_flight_in_pure_numbers(ledger):
    """Two flights with the same alpha and angle: the ratios are one number, that of the ledger."""
    alpha, theta = 1.7, 0.6
    u = -1 - alpha * mpmath.sin(theta)
    z = _value(ledger, "beyond.pure-flight.time", "z", alpha=alpha, u=u)
    rho = _value(ledger, "beyond.pure-flight.range", "rho", alpha=alpha, u=u, theta=theta)
    for v, g in ((30, 9.8), (2, 1.6)):
        with mp.workdps(20):
            place = _flight(v, g, alpha * g / v, theta)
            hit = _lands(place, lambda _, y: y, z * v / g)
        assert abs(hit * g / v - z) < 1e-10
        assert abs(place(hit)[0] * g / v**2 - rho) < 1e-10


def test_descent_in_pure_numbers(ledger):
    """A bead with friction and drag, integrated in SI units, arrives when the pure number says."""
    size, g, gamma, mu, theta = 2.5, 9.8, 1.3, 0.2, 0.5
    unit = mpmath.sqrt(2 * size / g)
    n = 1 - mu * mpmath.tan(theta)
    tau = _value(ledger, "beyond.pure-descent.time", "tau_AB", p=gamma * unit, n=n)
    pull = g * (mpmath.cos(theta) - mu * mpmath.sin(theta))
    with mp.workdps(20):
        motion = mpmath.odefun(lambda _, s: [s[1], pull - gamma * s[1]], 0, [0, 0])
        place = motion(tau * unit)[0]
    assert abs(place - size * mpmath.cos(theta)) < 1e-10


def test_a_wrong_root_of_the_hill_is_refuted(ledger):
    entry = ledger["beyond.hills.time"]
    (root,) = entry.result.atoms(sp.LambertW)
    assert entry.compare(entry.result.xreplace({root: sp.LambertW(root.args[0], -1)})).kind is Kind.REFUTED
