"""An independent check of the bead's motion: each closed form again, as the sum of the law's Taylor series."""

import sympy as sp
from sympy import Eq, Interval, atan, cos, exp, pi, sin

from galileo_sym.derivations.beyond.chord_notation import notation, order
from galileo_sym.derivations.chord.notation import g, gamma, mu, s, t, theta
from galileo_sym.ledger import NONNEGATIVE, POSITIVE, Chapter, Domain, tell_chapter
from galileo_sym.tactics import start_of, sum_of_series, taylor_of_motion

chapter = Chapter("beyond.chord_motion_by_taylor", notation, "The motion by Taylor series (not printed)")

LAST = atan(1 / mu)
FALL = {g: POSITIVE, t: NONNEGATIVE, theta: Interval(-pi / 2, pi / 2)}
RIGHT = {g: POSITIVE, mu: POSITIVE, t: NONNEGATIVE, theta: Interval(0, LAST)}
LEFT = {**RIGHT, theta: Interval.Ropen(-LAST, 0)}
DRAG = {gamma: POSITIVE, order: sp.FiniteSet(2, 3, 10, 41)}
FREE_FALL = g * t**2 / 2
FALLEN = g / gamma * t - g / gamma**2 * (1 - exp(-gamma * t))
PULL, PULL_LEFT = cos(theta) - mu * sin(theta), cos(theta) + mu * sin(theta)

MOTIONS = (
    ("eq1", "chord.law.frictionless", FREE_FALL * cos(theta), FALL),
    ("eq15", "chord.eq12", FREE_FALL * PULL, {**RIGHT, theta: Interval.Ropen(0, LAST)}),
    ("eq15.left", "chord.eq14", FREE_FALL * PULL_LEFT, {**LEFT, theta: Interval.open(-LAST, 0)}),
    ("eq29", "chord.eq28", FALLEN * cos(theta), {**FALL, **DRAG}),
    ("eq41", "chord.eq40", FALLEN * PULL, {**RIGHT, **DRAG}),
    ("eq41.left", "chord.claim.negative-theta-sign", FALLEN * PULL_LEFT, {**LEFT, **DRAG}),
)


def by_series(law, setup):
    """The law gives each derivative at the release from the one before; the series is that of the exponential."""
    equation = next(e for e in law.parts if e.has(s(t).diff(t, 2)))
    series = taylor_of_motion(equation, s(t), start_of(setup.parts, s(t)), order)
    return Eq(s(t), sum_of_series(series), evaluate=False)


for name, law, path, ranges in MOTIONS:
    printed, premises = Eq(s(t), path), (law, "chord.setup")
    chapter.derive(f"beyond.taylor.chord.{name}", printed, Domain(ranges), premises=premises)(by_series)


if __name__ == "__main__":
    tell_chapter(chapter.name)
