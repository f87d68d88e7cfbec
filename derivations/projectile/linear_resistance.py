"""Finding the range with resistance proportional to the velocity: the motion."""

import sympy as sp
from sympy import Eq, cos, exp, sin

from galileo_sym.derivations.projectile.notation import HALF_TURN, g, k, notation, t, theta, v, v_x, v_y, x, y
from galileo_sym.ledger import NONNEGATIVE, POSITIVE, Chapter, Domain, step, tell_chapter
from galileo_sym.tactics import integrate_from_zero, solve_motion

chapter = Chapter("projectile.linear_resistance", notation, "Finding the range with resistance")

FLIGHT = Domain({g: POSITIVE, v: POSITIVE, k: POSITIVE, t: NONNEGATIVE, theta: HALF_TURN})

chapter.given(
    "projectile.law.drag.x",
    Eq(x(t).diff(t, 2), -k * x(t).diff(t)),
    FLIGHT,
    premises=("projectile.setup",),
)

chapter.given(
    "projectile.law.drag.y",
    Eq(y(t).diff(t, 2), -g - k * y(t).diff(t)),
    FLIGHT,
    premises=("projectile.setup",),
)


def _velocity(law, place, velocity, setup):
    """Integrate a law once: name the velocity, and solve the first-order equation for it."""
    named = step("name the velocity", Eq(velocity, sp.Derivative(place, t)))
    first_order = step("of first order", law.equation.subs(named.rhs, velocity))
    start = {velocity.subs(t, 0): setup.of(place.diff(t).subs(t, 0))}
    return Eq(named.rhs, solve_motion(first_order, velocity, start).rhs, evaluate=False)


def _integrate(slope, place, setup):
    """Integrate a velocity from the launch on."""
    gained = integrate_from_zero(slope.equation, place)
    return Eq(place, setup.of(place.subs(t, 0)) + gained.rhs, evaluate=False)


@chapter.derive("projectile.drag.vx", Eq(x(t).diff(t), v * cos(theta) * exp(-k * t)), FLIGHT)
def horizontal_velocity(law__drag__x, setup):
    """One integration: set v_x = x'."""
    return _velocity(law__drag__x, x(t), v_x(t), setup)


@chapter.derive(
    "projectile.drag.vy",
    Eq(y(t).diff(t), (-g + (g + k * v * sin(theta)) * exp(-k * t)) / k),
    FLIGHT,
)
def vertical_velocity(law__drag__y, setup):
    """One integration: set v_y = y'."""
    return _velocity(law__drag__y, y(t), v_y(t), setup)


@chapter.derive("projectile.drag.x", Eq(x(t), v * cos(theta) * (1 - exp(-k * t)) / k), FLIGHT)
def abscissa(drag__vx, setup):
    """Integrate again."""
    return _integrate(drag__vx, x(t), setup)


@chapter.derive(
    "projectile.drag.y",
    Eq(y(t), (-k * t * g + g + k * v * sin(theta) - exp(-k * t) * (g + k * v * sin(theta))) / k**2),
    FLIGHT,
)
def height(drag__vy, setup):
    """Integrate again."""
    return _integrate(drag__vy, y(t), setup)


if __name__ == "__main__":
    tell_chapter(chapter.name)
