"""What the chapters on the synchronous curve with friction share: its arcs, circles and coordinates."""

import sympy as sp
from sympy import Eq, FiniteSet, Ge, Implies, Interval, Rational, Tuple, atan, cos, pi, sin

from galileo_sym.derivations.chord.notation import (
    g,
    mu,
    s,
    t,
    theta,
    x,
    x_c,
    y,
    y_c,
)
from galileo_sym.ledger import (
    NONNEGATIVE,
    POSITIVE,
    DerivationError,
    Domain,
    Erratum,
    step,
)
from galileo_sym.ledger.equivalence import equivalent
from galileo_sym.tactics import (
    read_circle,
)

LAST = atan(1 / mu)
LAST_FROM_0 = pi / 2 - atan(mu)  # the same, and without friction, too
K = g * t**2 / 4
RIGHT = Interval(0, LAST)
LEFT = Interval(-LAST, 0)
ARC = Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE, theta: RIGHT})
LEFT_ARC = Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE, theta: LEFT})
CENTRE = Tuple(x_c(t), y_c(t))
WITH_OR_WITHOUT = {mu: NONNEGATIVE, theta: Interval(0, LAST_FROM_0)}
MOVING = Domain({g: POSITIVE, mu: POSITIVE, t: POSITIVE})
EQ21 = Eq((x + mu * g * t**2 / 4) ** 2 + (y - g * t**2 / 4) ** 2, (g * t**2 / 4) ** 2 * (1 + mu**2))
EQ24 = Eq((x - mu * g * t**2 / 4) ** 2 + (y - g * t**2 / 4) ** 2, (g * t**2 / 4) ** 2 * (1 + mu**2))
ONE_ARC = (
    "elimination gives the whole circle; only the arc x >= 0 is traced, completely and once, by 0 <= theta <= theta_max"
)
RIGHT_POINT = Tuple(K * (sin(2 * theta) - mu * (1 - cos(2 * theta))), K * (1 + cos(2 * theta) - mu * sin(2 * theta)))
LEFT_POINT = Tuple(K * (sin(2 * theta) + mu * (1 - cos(2 * theta))), K * (1 + cos(2 * theta) + mu * sin(2 * theta)))
WHOLE_CIRCLE = Erratum(
    ("C5",),
    ONE_ARC + "; beyond theta_max (19) and (20) go on along the circle to x < 0, where no bead is",
    Implies(EQ21, Ge(x, 0)),
    Domain(
        {g: POSITIVE, mu: FiniteSet(Rational(1, 2)), t: POSITIVE, theta: FiniteSet(Rational(13, 10))},
        where={x: RIGHT_POINT[0], y: RIGHT_POINT[1]},
    ),
)


def require_without_friction(circle, known):
    """Refuse a circle with friction that is not the known one where mu is 0: so it holds for mu >= 0."""
    if equivalent(circle.subs(mu, 0), known) is None:
        raise DerivationError(f"{circle} without friction is not {known}")
    step("without friction", Implies(Eq(mu, 0, evaluate=False), known, evaluate=False))


def without_s(premise, coordinate):
    """The equation of a coordinate that does not mention s(t)."""
    return next(e for e in premise.parts if e.lhs == coordinate and not e.rhs.has(s))


def centred(found):
    """The equation of a circle, with its centre and radius in sight."""
    seen = read_circle(found, x, y)
    (a, b), rho = seen.centre, seen.radius
    return Eq((x - a) ** 2 + (y - b) ** 2, rho**2, evaluate=False)


def doubled_coordinates(path, setup, double_sine, double_cosine):
    """x and y of a bead at distance `path`, with sines and cosines of 2 theta."""
    put = {sin(theta) * cos(theta): double_sine / 2}
    across = sp.expand(setup.of(x).subs(s(t), path)).subs(put).subs(sin(theta) ** 2, 1 - double_cosine / 2)
    down = sp.expand(setup.of(y).subs(s(t), path)).subs(put).subs(cos(theta) ** 2, double_cosine / 2)
    return across, down


def slope_at_vertical(arc):
    """dy/dx of an arc at theta = 0."""
    across, down = arc.args[0]
    return sp.simplify((sp.diff(down, theta) / sp.diff(across, theta)).subs(theta, 0))
