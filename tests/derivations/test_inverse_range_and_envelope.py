"""The inverse range problem and the envelope of trajectories against flights that are followed number by number."""

import mpmath
import pytest
import sympy as sp
from mpmath import mp

from galileo_sym.derivations.beyond.notation import rho, x_e, y_e, z
from galileo_sym.derivations.projectile.notation import R, alpha, g, k, s, theta, v
from galileo_sym.ledger import Kind, StrictlyDecreasing, StrictlyIncreasing, UniqueMaximum, tell

pytestmark = pytest.mark.xdist_group("projectile")

SHOTS = {
    "moderate": (9.81, 50.0, 0.5),
    "alpha = 1": (10.0, 20.0, 0.5),
    "little resistance": (9.81, 10.0, 0.01),
    "much resistance": (2.0, 60.0, 3.0),
}
CHAPTERS = (
    "beyond.inverse_range",
    "beyond.landing_triangle",
    "beyond.envelope",
    "beyond.envelope_contact",
    "beyond.envelope_ends",
)


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_every_entry_is_proved(ledger, chapter):
    for entry in ledger.select([chapter]):
        assert entry.own_verdict.kind is Kind.PROVED, tell(entry)


class Flight:
    """A flight with numbers for g, v and k, from the solution of the law; the impact is found by bisection."""

    def __init__(self, name):
        self.g, self.v, self.k = map(mpmath.mpf, SHOTS[name])
        self.alpha = self.k * self.v / self.g

    def height(self, t, angle):
        g, k, up = self.g, self.k, self.v * mp.sin(angle)
        return (g / k + up) * -mp.expm1(-k * t) / k - g * t / k

    def distance(self, t, angle):
        return self.v * mp.cos(angle) * -mp.expm1(-self.k * t) / self.k

    def impact(self, angle):
        late = 2 * self.v * mp.sin(angle) / self.g  # without resistance it is later
        early = late / (1 + self.alpha) / 4
        return mp.findroot(lambda t: self.height(t, angle), (early, late), solver="anderson")

    def range(self, angle):
        return self.distance(self.impact(angle), angle)

    def height_above(self, x, angle):
        return self.height(-mp.log1p(-self.k * x / (self.v * mp.cos(angle))) / self.k, angle)

    def put(self, expression, **more):
        numbers = {"g": self.g, "v": self.v, "k": self.k, "alpha": self.alpha, **more}
        names = sorted(expression.free_symbols, key=str)
        return sp.lambdify(names, expression, "mpmath")(*(numbers[n.name] for n in names))


@pytest.fixture(params=SHOTS)
def flight(request):
    with mpmath.workdps(30):
        yield Flight(request.param)


def _largest(f, low, high):
    """Where a function with one maximum is largest, by golden section."""
    ratio = (mp.sqrt(5) - 1) / 2
    for _ in range(90):
        a, b = high - ratio * (high - low), low + ratio * (high - low)
        low, high = (a, high) if f(a) < f(b) else (low, b)
    return (low + high) / 2


def _claim(entry, kind):
    return next(e for e in entry.result.args if isinstance(e, kind))


def test_two_angles_for_a_range(ledger, flight):
    """The two roots s of the equation, and the angles they give, bring the projectile to r."""
    peak = ledger["beyond.inverse.peak"]
    square, _, low = _claim(peak, StrictlyIncreasing).args
    high = _claim(peak, StrictlyDecreasing).args[2]
    climb = ledger["beyond.inverse.bijection"].result.atoms(StrictlyIncreasing).pop().args[0]
    best = _largest(flight.range, mpmath.mpf(1) / 100, mp.pi / 2 - mpmath.mpf(1) / 100)
    angles = []
    for share in (0.2, 0.97):
        r = mpmath.mpf(share) * flight.range(best)
        for side in (low, high):
            ends = [flight.put(e) for e in (side.start, side.end)]
            level = (flight.k * r / flight.v) ** 2
            time = mp.findroot(lambda at: flight.put(square, s=at) - level, ends, solver="anderson", tol=1e-28)  # noqa: B023
            angles.append(mp.asin(flight.put(climb, s=time) / flight.alpha))
            assert mpmath.almosteq(flight.range(angles[-1]), r, rel_eps=1e-10)
    assert angles[0] < angles[2] < best < angles[3] < angles[1]


def test_the_largest_range_in_closed_form(ledger, flight):
    best = _largest(flight.range, mpmath.mpf(1) / 100, mp.pi / 2 - mpmath.mpf(1) / 100)
    square = flight.put(ledger["beyond.inverse.largest"].result.rhs)
    assert mpmath.almosteq(mp.sqrt(square) * flight.v / flight.k, flight.range(best), rel_eps=1e-12)


def test_the_landing_triangle(ledger, flight):
    square = next(e for e in ledger["beyond.landing.triangle"].result.args if e.lhs == rho**2).rhs
    for angle in (0.1, 0.9, 1.55):
        number = flight.g * flight.impact(angle) / flight.v
        length = flight.g * flight.range(angle) / flight.v**2
        assert mpmath.almosteq(_with_primitives(square, flight.alpha, number), length**2, rel_eps=1e-12)


def _with_primitives(expression, number, time):
    value = expression.subs({alpha: sp.Float(str(number), 30), z: sp.Float(str(time), 30)})
    return mpmath.mpf(sp.N(value, 25)._mpf_)


def test_the_envelope_is_as_high_as_any_trajectory_comes(ledger, flight):
    """At some abscissas the highest trajectory, found by search, against the closed form and its elevation."""
    highest = next(e for e in ledger["beyond.envelope.explicit"].result.args if e.lhs == y_e).rhs
    elevation = ledger["beyond.envelope.elevation"].result.rhs
    for share in (0.05, 0.5, 0.9):
        x = mpmath.mpf(share) * flight.v / flight.k
        top = mp.acos(flight.k * x / flight.v) * (1 - mpmath.mpf(10) ** -12)
        found = _largest(lambda angle: flight.height_above(x, angle), mpmath.mpf(0), top)  # noqa: B023
        assert mpmath.almosteq(flight.put(highest, x_e=x), flight.height_above(x, found), rel_eps=1e-15, abs_eps=1e-12)
        assert abs(mp.tan(found) - flight.put(elevation, x_e=x)) < 1e-9 * (1 + mp.tan(found))


def test_flight_and_launch_are_perpendicular_there(ledger, flight):
    highest = next(e for e in ledger["beyond.envelope.explicit"].result.args if e.lhs == y_e).rhs
    x = flight.v / flight.k / 3
    slope = mp.diff(lambda at: flight.put(highest, x_e=at), x)
    angle = mp.atan(flight.put(ledger["beyond.envelope.elevation"].result.rhs, x_e=x))
    assert mpmath.almosteq(mp.diff(lambda at: flight.height_above(at, angle), x), slope, rel_eps=1e-12)
    assert abs(slope * mp.tan(angle) + 1) < 1e-12


def test_the_envelope_ends_at_the_largest_range(ledger, flight):
    highest = next(e for e in ledger["beyond.envelope.explicit"].result.args if e.lhs == y_e).rhs
    best = _largest(flight.range, mpmath.mpf(1) / 100, mp.pi / 2 - mpmath.mpf(1) / 100)
    farthest = flight.range(best)
    assert abs(flight.put(highest, x_e=farthest)) < 1e-12 * flight.v**2 / flight.g
    assert flight.put(highest, x_e=farthest * mpmath.mpf("1.001")) < 0


W_BEST = "W((alpha**2 - 1)/E)"
FALSE = {
    "the square, sign of the fall": (
        "beyond.inverse.equation",
        "Eq((k*R(k, theta)/v)**2, (1 - exp(-s))**2 + (s - 1 + exp(-s))**2/alpha**2)",
    ),
    "largest range, without a 2": (
        "beyond.inverse.largest",
        f"Eq((k*R(k, theta_max)/v)**2, 1 - {W_BEST}*exp(-1 - {W_BEST}))",
    ),
    "conic, alpha instead of alpha^2": (
        "beyond.envelope.conic",
        "Eq((k**2*y_e/g + s)**2, alpha + (1 - alpha**2)*(k*x_e/v)**2)",
    ),
    "elevation, the line of sight": ("beyond.envelope.elevation", "Eq(tan(theta), k*x_e/(v*alpha))"),
    "safety, factor 2": ("beyond.envelope.safety", "Eq(y_e, v**2/(2*g) - g*x_e**2/v**2)"),
}


@pytest.mark.parametrize(("identifier", "statement"), FALSE.values(), ids=FALSE)
def test_false_variants_are_refuted(ledger, identifier, statement):
    verdict = ledger[identifier].compare(statement)
    assert verdict.kind is Kind.REFUTED
    assert verdict.counterexample


def test_the_peak_is_where_theorem_3_has_it(ledger, flight):
    place = _claim(ledger["beyond.inverse.peak"], UniqueMaximum).args[3]
    best = _largest(flight.range, mpmath.mpf(1) / 100, mp.pi / 2 - mpmath.mpf(1) / 100)
    assert mpmath.almosteq(flight.put(place), flight.k * flight.impact(best), rel_eps=1e-8)
    assert {g, v, k, theta, x_e, R, s} & set(place.free_symbols) == set()
