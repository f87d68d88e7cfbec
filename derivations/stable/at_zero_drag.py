"""Each stable form where the drag vanishes: the limit of the printed form, in value and in first derivative."""

import sympy as sp
from sympy import Interval, LambertW, Tuple, atan, cos, exp, pi, sin, sqrt

from galileo_sym.derivations.chord.notation import D, g, gamma, mu, n, notation, t, theta
from galileo_sym.ledger import POSITIVE, Chapter, Domain, tell_chapter
from galileo_sym.primitives import descent_factor, driving, phi1, phi2
from galileo_sym.tactics import limits_at_zero, twin_at_zero

chapter = Chapter("stable.at_zero_drag", notation, "stable forms (not printed)")

SLIDING = Interval.open(-atan(1 / mu), atan(1 / mu))
SLIDE = cos(theta) - mu * sin(sp.Abs(theta))


def descent(length):
    """(36) with a length for D, as in (43)."""
    c = gamma**2 * length / g
    return 1 / gamma + gamma * length / g + LambertW(-exp(-1 - c)) / gamma


FALLEN = g / gamma * t - g / gamma**2 * (1 - exp(-gamma * t))
DROP = {g: POSITIVE, D: POSITIVE}
PATH = {g: POSITIVE, t: POSITIVE}
ALL_ANGLES = {**PATH, theta: Interval.open(-pi / 2, pi / 2)}
SLIDING_PATH = {**PATH, mu: POSITIVE, theta: SLIDING}

FALL = g * t**2 / 2
SPED = g / gamma * (1 - exp(-gamma * t))
CLOSED = {descent_factor: LambertW, phi1: exp, phi2: exp}

# Stable form, its output and primitive; the printed form, its value and its slope in gamma at 0; the assumptions.
ROWS = (
    ("descent_time.drag", 0, descent_factor, descent(D), sqrt(2 * D / g), D / (3 * g), DROP),
    (
        "descent_time.friction_drag",
        0,
        descent_factor,
        descent(D / n),
        sqrt(2 * D / (g * n)),
        D / (3 * g * n),
        {**DROP, n: POSITIVE},
    ),
    ("distance.drag", 0, phi2, FALLEN * cos(theta), FALL * cos(theta), -(t**3) * g / 6 * cos(theta), ALL_ANGLES),
    ("distance.friction_drag", 0, phi2, FALLEN * SLIDE, FALL * SLIDE, -(t**3) * g / 6 * SLIDE, SLIDING_PATH),
    ("speed.drag", 0, phi1, SPED * cos(theta), g * t * cos(theta), -(t**2) * g / 2 * cos(theta), ALL_ANGLES),
    ("speed.friction_drag", 0, phi1, SPED * SLIDE, g * t * SLIDE, -(t**2) * g / 2 * SLIDE, SLIDING_PATH),
    (
        "position.drag",
        0,
        phi2,
        FALLEN * cos(theta) * sin(theta),
        FALL * cos(theta) * sin(theta),
        -(t**3) * g / 6 * cos(theta) * sin(theta),
        ALL_ANGLES,
    ),
    (
        "position.friction_drag",
        1,
        phi2,
        FALLEN * SLIDE * cos(theta),
        FALL * SLIDE * cos(theta),
        -(t**3) * g / 6 * SLIDE * cos(theta),
        SLIDING_PATH,
    ),
    ("synchronous_circle.drag", 2, phi2, FALLEN / 2, FALL / 2, -(t**3) * g / 12, PATH),
    (
        "synchronous_circle.friction_drag",
        2,
        phi2,
        sqrt(1 + mu**2) * FALLEN / 2,
        sqrt(1 + mu**2) * FALL / 2,
        -(t**3) * g / 12 * sqrt(1 + mu**2),
        {**PATH, mu: POSITIVE},
    ),
)


def from_twin(output, primitive):
    """The derivation of a row: expand the primitive of the stable form to first order."""

    def at_zero(twin, at_zero_of_primitive):
        """Expand the primitive to first order at 0, where its slope is proved, and write the rest as printed."""
        forms = twin.rhs if isinstance(twin.rhs, Tuple) else (twin.rhs,)
        slide = n * cos(theta) if primitive is descent_factor else SLIDE  # n = driving/cos(theta), as in (43)
        expr = sp.simplify(forms[output].subs(driving(theta, mu), slide))
        return twin_at_zero(expr, gamma, {primitive: at_zero_of_primitive.statement}, CLOSED[primitive])

    return at_zero


for _twin, _output, _primitive, _form, _value, _slope, _ranges in ROWS:
    chapter.derive(
        f"stable.chord.{_twin}.at-zero",
        limits_at_zero(_form, gamma, _value, _slope),
        Domain({**_ranges, gamma: POSITIVE}),
        premises=(f"stable.chord.{_twin}", f"stable.at-zero.{_primitive.__name__}"),
    )(from_twin(_output, _primitive))


if __name__ == "__main__":
    tell_chapter(chapter.name)
