"""Section 5: with drag the synchronous curve with friction is the same, of another moment; it has corners too."""

import sympy as sp
from sympy import And, Eq, Gt, Interval, Le, Ne, Tuple, atan, cos, exp, sin, sqrt

from galileo_sym.derivations.chord.notation import (
    R,
    X,
    Y,
    g,
    gamma,
    mu,
    notation,
    s,
    sigma,
    slope_left,
    slope_right,
    t,
    theta,
    x,
    y,
)
from galileo_sym.derivations.chord.shared import slope_at_vertical
from galileo_sym.ledger import (
    POSITIVE,
    Chapter,
    DerivationError,
    Domain,
    ForAll,
    TracesOnce,
    UniqueMaximum,
    step,
    tell_chapter,
)
from galileo_sym.ledger.equivalence import equivalent, is_zero
from galileo_sym.tactics import ladder, read_circle

chapter = Chapter(
    "chord.spindle_with_drag",
    notation,
    "5. Motion under sliding friction and resistive force proportional to velocity",
)

LAST = atan(1 / mu)
MOMENT = {g: POSITIVE, gamma: POSITIVE, mu: POSITIVE, t: POSITIVE}
FALLEN = g / gamma * t - g / gamma**2 * (1 - exp(-gamma * t))
SLIDE = cos(theta) - mu * sin(theta)
z = sp.Symbol("z", positive=True)  # gamma*t
BOTH_SIDES = ((1, Interval(0, LAST), sp.Ge(x, 0)), (-1, Interval(-LAST, 0), sp.Le(x, 0)))


def bead(side):
    """x and y on the chords of one side (1: theta >= 0)."""
    return Tuple(
        Y(t) * (sin(2 * theta) - side * mu * (1 - cos(2 * theta))),
        Y(t) * (1 + cos(2 * theta) - side * mu * sin(2 * theta)),
    )


def circle(side):
    """(44) with (46) and (47)."""
    return Eq((x + side * mu * Y(t)) ** 2 + (y - Y(t)) ** 2, (1 + mu**2) * Y(t) ** 2)


def in_disc(side, angles):
    """The beads of one side are in the disc of the circle that those of the other are on."""
    across, down = bead(side)
    other = circle(-side)
    return ForAll(Le(other.lhs.subs({x: across, y: down}), other.rhs), theta, angles)


ARCS = [
    TracesOnce(bead(side), theta, angles, circle(side), region, Tuple(x, y), atan(x / y))
    for side, angles, region in BOTH_SIDES
]


@chapter.derive(
    "chord.claim.spindle-drag",
    And(
        *ARCS,
        UniqueMaximum(bead(1)[0], theta, Interval(0, LAST), LAST / 2),
        Eq(Tuple(x, y), Tuple(Y(t) * (sqrt(1 + mu**2) - mu), Y(t))),
        *(in_disc(side, angles) for side, angles, _ in BOTH_SIDES),
    ),
    Domain(
        {**MOMENT, theta: sp.FiniteSet(LAST / 2)},
        where={Y(t): FALLEN / 2, s(t): FALLEN * SLIDE, x: bead(1)[0], y: bead(1)[1]},
    ),
    elsewhere=("chord.claim.spindle", "chord.claim.union-of-arcs"),
)
def another_moment(
    eq41, claim__negative_theta_sign, setup, eq44, eq45, eq46, eq47, claim__union_of_arcs, claim__spindle
):
    """The beads are where they are without drag at sqrt(4 Y/g), g t^2/4 = Y: what is said of that moment holds."""
    ladder(sp.expand(eq45.rhs.subs(t, z / gamma) * 2 * gamma**2 / g), z)
    step("the moment is after the release", Gt(Y(t), 0))
    without = {t: 2 * sqrt(Y(t) / g)}
    arcs = [part.xreplace(without) for part in claim__union_of_arcs.parts]
    for (side, _, region), path in zip(BOTH_SIDES, (eq41.rhs, claim__negative_theta_sign.of(s(t))), strict=True):
        point, _, _, curve, _, _, _ = next(arc for arc in arcs if arc.args[4] == region).args
        along = 2 * Y(t) * sp.simplify(path / (2 * eq45.rhs))
        for coordinate, without_drag in zip((x, y), point, strict=True):
            if is_zero(setup.of(coordinate).subs(s(t), along) - without_drag) is None:
                raise DerivationError(f"the beads of side {side} are not at {point}")
        with_drag = eq44.subs(sigma, side).subs({X(t): eq46.rhs, R(t): eq47.rhs})
        same = equivalent(step("on this side", with_drag) if side > 0 else with_drag, curve)
        if same is None or is_zero(read_circle(curve, x, y).radius - eq47.rhs) is None:
            raise DerivationError(f"(44) is {with_drag}, not {curve}")
    return And(*arcs, *(part.xreplace(without) for part in claim__spindle.parts))


@chapter.derive(
    "chord.claim.both-sync-not-circle",
    And(Eq(slope_right, -mu), Eq(slope_left, mu), Ne(slope_right, slope_left)),
    Domain(MOMENT, where={Y(t): FALLEN / 2}),
)
def not_a_circle(claim__spindle_drag):
    """At the vertical bead the two arcs meet at an angle, and no circle has a corner."""
    arcs = [part for part in claim__spindle_drag.parts if isinstance(part, TracesOnce)]
    right, left = (slope_at_vertical(next(a for a in arcs if a.args[4] == region)) for _, _, region in BOTH_SIDES)
    if not (left - right).is_positive:
        raise DerivationError("the slopes are equal")
    return And(Eq(slope_right, right), Eq(slope_left, left), Ne(slope_right, slope_left))


if __name__ == "__main__":
    tell_chapter(chapter.name)
