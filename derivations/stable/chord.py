"""Stable forms of the chord formulas: the drag-free value times a factor of one dimensionless number."""

import sympy as sp
from sympy import Abs, Eq, Interval, Tuple, acot, atan, cos, exp, pi, sin, sqrt

from galileo_sym.derivations.chord.notation import (
    D,
    R,
    X,
    Y,
    g,
    gamma,
    mu,
    n,
    notation,
    s,
    t,
    t_AB,
    theta,
    theta_max,
    x,
    y,
)
from galileo_sym.ledger import NONNEGATIVE, POSITIVE, Chapter, DerivationError, Domain, step, tell_chapter
from galileo_sym.primitives import descent_factor, driving, phi1, phi2
from galileo_sym.tactics import at_rest, introduce, read_circle, solve_motion

chapter = Chapter("stable.chord", notation, "stable forms (not printed)")

SLIDE = driving(theta, mu)
DRAG = 2 * phi2(-gamma * t)
FALL = g * t**2 / 2
TIME = sqrt(2 * D / g)
SLOW_TIME = sqrt(2 * D * cos(theta) / (g * SLIDE))
CIRCLE = Tuple(X(t), Y(t), R(t))
OBLIQUE = sqrt(1 + mu**2)

ANGLES = {"": Interval.open(-pi / 2, pi / 2), "friction": Interval.open(-atan(1 / mu), atan(1 / mu))}
MU, GAMMA = {mu: POSITIVE}, {gamma: POSITIVE}
DROP = {g: POSITIVE, D: POSITIVE}
PATH = {g: POSITIVE, t: NONNEGATIVE}
EVERY, SLIDING = {theta: ANGLES[""]}, {theta: ANGLES["friction"]}


def both_sides(right, left):
    """One expression for both signs of theta, from those for theta >= 0 and for theta < 0, mirror images."""
    if sp.simplify(right - left.subs(theta, -theta)) != 0:
        raise DerivationError(f"{right} and {left} are not mirror images")
    return right.subs(theta, Abs(theta)).subs(cos(Abs(theta)), cos(theta))


def in_driving(expr):
    """Write an expression that is proportional to cos(theta) - mu*sin|theta| with `driving`."""
    rest = sp.simplify(expr / SLIDE.rewrite(cos))
    if rest.has(theta):
        raise DerivationError(f"{expr} is not proportional to {SLIDE.rewrite(cos)}")
    return rest * SLIDE


def coordinates(distance):
    """x and y of a bead at a distance along its chord."""
    return Tuple(distance * sin(theta), distance * cos(theta))


@chapter.derive("stable.chord.descent_time.free", Eq(t_AB, TIME), Domain({**DROP, **EVERY}))
def time_free(eq4):
    """Nothing cancels in (4): it is its own twin."""
    return Eq(t_AB, eq4.of(t_AB))


@chapter.derive("stable.chord.descent_time.friction", Eq(t_AB, SLOW_TIME), Domain({**DROP, **MU, **SLIDING}))
def time_friction(eq17, eq18):
    """1 - mu tan|theta| is driving/cos(theta): no tangent is formed."""
    slow = sp.simplify(both_sides(eq17.rhs, eq18.rhs).subs(sp.tan(Abs(theta)), (1 - n) / mu))
    return Eq(t_AB, in_driving_share(slow))


def in_driving_share(expr):
    """Put n = 1 - mu*tan|theta| = driving/cos(theta) in: no tangent is formed."""
    step("driving", Eq(SLIDE, SLIDE.rewrite(cos), evaluate=False))
    step("n", Eq(n, SLIDE / cos(theta), evaluate=False))
    inverse = sp.Dummy("inverse", positive=True)
    return expr.subs(n, 1 / inverse).subs(inverse, cos(theta) / SLIDE)


@chapter.derive(
    "stable.chord.descent_time.drag",
    Eq(t_AB, TIME * descent_factor(gamma * TIME)),
    Domain({**DROP, **GAMMA}),
    elsewhere=("chord.eq4",),
)
def time_drag(eq36, eq4):
    """W is taken out of (36) by the factor at gamma t0, t0 the time (4) without drag."""
    return Eq(t_AB, introduce(eq36.rhs, descent_factor(gamma * eq4.rhs)))


@chapter.derive(
    "stable.chord.descent_time.friction_drag",
    Eq(t_AB, SLOW_TIME * descent_factor(gamma * SLOW_TIME)),
    Domain({**DROP, **MU, **GAMMA, **SLIDING}),
    elsewhere=("chord.eq17", "chord.eq18"),
)
def time_friction_drag(eq43, eq17, eq18):
    """The same in (43), t0 the time (17), (18) without drag."""
    put = {sp.tan(Abs(theta)): (1 - n) / mu}
    slow = sp.simplify(both_sides(eq17.rhs, eq18.rhs).subs(put))
    factored = introduce(eq43.rhs.subs(put), descent_factor(gamma * slow))
    return Eq(t_AB, in_driving_share(factored))


PATHS = {
    "free": (FALL * cos(theta), Domain({**PATH, **EVERY})),
    "friction": (FALL * SLIDE, Domain({**PATH, **MU, **SLIDING})),
    "drag": (FALL * cos(theta) * DRAG, Domain({**PATH, **GAMMA, **EVERY})),
    "friction_drag": (FALL * SLIDE * DRAG, Domain({**PATH, **MU, **GAMMA, **SLIDING})),
}


@chapter.derive("stable.chord.distance.free", Eq(s(t), PATHS["free"][0]), PATHS["free"][1])
def distance_free(law__frictionless):
    """Nothing cancels: the law solved from rest."""
    return solve_motion(law__frictionless.equation, s(t), at_rest(s(t)))


@chapter.derive("stable.chord.distance.friction", Eq(s(t), PATHS["friction"][0]), PATHS["friction"][1])
def distance_friction(eq15, eq14):
    """(15), and its mirror image for theta < 0, with `driving`."""
    left = solve_motion(eq14.equation, s(t), at_rest(s(t)))
    step("driving", Eq(SLIDE, SLIDE.rewrite(cos), evaluate=False))
    return Eq(s(t), in_driving(both_sides(eq15.rhs, left.rhs)))


@chapter.derive("stable.chord.distance.drag", Eq(s(t), PATHS["drag"][0]), PATHS["drag"][1])
def distance_drag(eq29):
    """The exponential is taken out of (29) by phi2."""
    return Eq(s(t), introduce(eq29.rhs, phi2(-gamma * t), closed=exp))


@chapter.derive("stable.chord.distance.friction_drag", Eq(s(t), PATHS["friction_drag"][0]), PATHS["friction_drag"][1])
def distance_friction_drag(eq41, claim__negative_theta_sign):
    """The exponential is taken out of (41) by phi2, for both signs of theta with `driving`."""
    both = both_sides(eq41.rhs, claim__negative_theta_sign.of(s(t)))
    step("driving", Eq(SLIDE, SLIDE.rewrite(cos), evaluate=False))
    return Eq(s(t), in_driving(introduce(both, phi2(-gamma * t), closed=exp)))


SLOW = phi1(-gamma * t)
SPEEDS = {
    "free": g * t * cos(theta),
    "friction": g * t * SLIDE,
    "drag": g * t * cos(theta) * SLOW,
    "friction_drag": g * t * SLIDE * SLOW,
}


def speed(path):
    """The speed is the slope of the distance; phi2 leaves phi1, and nothing cancels."""
    return Eq(s(t).diff(t), sp.simplify(sp.diff(path.of(s(t)), t)), evaluate=False)


for _forces, _speed in SPEEDS.items():
    chapter.derive(
        f"stable.chord.speed.{_forces}",
        Eq(s(t).diff(t), _speed),
        PATHS[_forces][1],
        premises=(f"stable.chord.distance.{_forces}",),
    )(speed)


def place(path, setup):
    """The coordinates of a bead from its distance along the chord."""
    put = {s(t): path.of(s(t))}
    return Eq(Tuple(x, y), Tuple(setup.of(x).subs(put), setup.of(y).subs(put)))


for _forces, (_path, _domain) in PATHS.items():
    chapter.derive(
        f"stable.chord.position.{_forces}",
        Eq(Tuple(x, y), coordinates(_path)),
        _domain,
        premises=(f"stable.chord.distance.{_forces}", "chord.setup"),
    )(place)


def circle_domain(*forces):
    """The assumptions of a synchronous circle."""
    return Domain({**PATH, **dict.fromkeys(forces, POSITIVE)})


@chapter.derive("stable.chord.synchronous_circle.free", Eq(CIRCLE, Tuple(0, FALL / 2, FALL / 2)), circle_domain())
def circle_free(claim__centre_accel, eq10):
    """Nothing cancels: the centre of (9) and the radius (10)."""
    centre = next(e.rhs for e in claim__centre_accel.parts if isinstance(e.rhs, Tuple))
    return Eq(CIRCLE, Tuple(*centre, eq10.rhs))


@chapter.derive(
    "stable.chord.synchronous_circle.friction",
    Eq(CIRCLE, Tuple(mu * FALL / 2, FALL / 2, OBLIQUE * FALL / 2)),
    circle_domain(mu),
)
def circle_friction(claim__centre_off_axis, eq22):
    """Nothing cancels: the centre (-X, Y) of (21) and the radius (22)."""
    across, down = next(e.rhs for e in claim__centre_off_axis.parts if isinstance(e.rhs, Tuple))
    return Eq(CIRCLE, Tuple(-across, down, eq22.rhs))


@chapter.derive(
    "stable.chord.synchronous_circle.drag",
    Eq(CIRCLE, Tuple(0, FALL * DRAG / 2, FALL * DRAG / 2)),
    circle_domain(gamma),
)
def circle_drag(eq31, eq32):
    """The circle (31) has its centre at (0, R); the exponential is taken out of (32) by phi2."""
    seen = read_circle(eq31.equation, x, y)
    form = introduce(eq32.rhs, phi2(-gamma * t), closed=exp)
    return Eq(CIRCLE, Tuple(*(e.subs(R(t), form) for e in (*seen.centre, seen.radius))))


@chapter.derive(
    "stable.chord.synchronous_circle.friction_drag",
    Eq(CIRCLE, Tuple(mu * FALL * DRAG / 2, FALL * DRAG / 2, OBLIQUE * FALL * DRAG / 2)),
    circle_domain(mu, gamma),
)
def circle_friction_drag(eq45, eq46, eq47):
    """The exponential is taken out of (45) by phi2; (46) and (47) follow."""
    depth = introduce(eq45.rhs, phi2(-gamma * t), closed=exp)
    return Eq(CIRCLE, Tuple(*(e.subs(Y(t), depth) for e in (eq46.rhs, Y(t), eq47.rhs))))


@chapter.derive("stable.chord.max_angle", Eq(theta_max, acot(mu)), Domain({mu: POSITIVE}))
def greatest_angle(eq13):
    """The arctangent of 1/mu is the arccotangent of mu, smooth at mu = 0, where it is pi/2."""
    return Eq(theta_max, eq13.of(theta_max).rewrite(acot))


if __name__ == "__main__":
    tell_chapter(chapter.name)
