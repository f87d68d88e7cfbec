"""An independent check of the projectile's motion: each closed form again, as the sum of the law's Taylor series."""

import sympy as sp
from sympy import Eq, cos, exp, sin

from galileo_sym.derivations.beyond.notation import notation, order
from galileo_sym.derivations.projectile.notation import HALF_TURN, g, k, t, theta, v, x, y
from galileo_sym.ledger import NONNEGATIVE, POSITIVE, Chapter, Domain, tell_chapter
from galileo_sym.tactics import start_of, sum_of_series, taylor_of_motion

chapter = Chapter("beyond.motion_by_taylor", notation, "The motion by Taylor series (not printed)")

ORDERS = sp.FiniteSet(2, 3, 10, 41)
FREE = Domain({g: POSITIVE, v: POSITIVE, t: NONNEGATIVE, theta: HALF_TURN})
DRAG = Domain({**FREE.ranges, k: POSITIVE, order: ORDERS})
CLIMB = g + k * v * sin(theta)

POSITIONS = (
    ("nodrag.x", Eq(x(t), v * cos(theta) * t), FREE),
    ("nodrag.y", Eq(y(t), -g * t**2 / 2 + v * sin(theta) * t), FREE),
    ("drag.x", Eq(x(t), v * cos(theta) * (1 - exp(-k * t)) / k), DRAG),
    ("drag.y", Eq(y(t), (-k * t * g + g + k * v * sin(theta) - exp(-k * t) * CLIMB) / k**2), DRAG),
)
VELOCITIES = (
    ("drag.x", "drag.vx", Eq(x(t).diff(t), v * cos(theta) * exp(-k * t))),
    ("drag.y", "drag.vy", Eq(y(t).diff(t), (-g + CLIMB * exp(-k * t)) / k)),
)


def _series(law, setup, place):
    return taylor_of_motion(law.equation, place, start_of(setup.parts, place), order)


def _position(place):
    def by_series(law, setup):
        """The law gives each derivative at the launch from the one before; the series is that of the exponential."""
        return Eq(place, sum_of_series(_series(law, setup, place)), evaluate=False)

    return by_series


def _velocity(place):
    def by_series(law, setup):
        """The same series differentiated term by term."""
        return Eq(place.diff(t), sum_of_series(_series(law, setup, place).rate()), evaluate=False)

    return by_series


for name, printed, domain in POSITIONS:
    premises = (f"projectile.law.{name}", "projectile.setup")
    chapter.derive(f"beyond.taylor.projectile.{name}", printed, domain, premises=premises)(_position(printed.lhs))

for name, told, printed in VELOCITIES:
    premises = (f"projectile.law.{name}", "projectile.setup")
    chapter.derive(f"beyond.taylor.projectile.{told}", printed, DRAG, premises=premises)(_velocity(printed.lhs.expr))


if __name__ == "__main__":
    tell_chapter(chapter.name)
