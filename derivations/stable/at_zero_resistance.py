"""Each stable form of a projectile without resistance: the limit of the printed form, value and first derivative."""

from sympy import Interval, LambertW, Tuple, cos, exp, pi, sin, sqrt

from galileo_sym.derivations.projectile.notation import g, k, notation, t, theta, v
from galileo_sym.ledger import POSITIVE, Chapter, Domain, tell_chapter
from galileo_sym.primitives import (
    flight_factor,
    max_range_factor,
    phi1,
    phi2,
    range_balance,
    range_factor,
    range_loss,
)
from galileo_sym.tactics import limits_at_zero, twin_at_zero

chapter = Chapter("stable.at_zero_resistance", notation, "stable forms (not printed)")

SHOT = {g: POSITIVE, v: POSITIVE, theta: Interval.Lopen(0, pi / 2)}
FLIGHT = {**SHOT, t: POSITIVE}
RISE = v * sin(theta) / g
W = LambertW((-1 - k * RISE) * exp(-1 - k * RISE))
REACH = 2 * v**2 * sin(theta) * cos(theta) / g
HEIGHT = (-k * t * g + g + k * v * sin(theta) - exp(-k * t) * (g + k * v * sin(theta))) / k**2
DOWN = -1 - k * RISE  # u of the Lemma
TOUCH = W / DOWN
BEND = (DOWN + 1) * W / ((W + 1) * DOWN)  # dy/du
STRAIGHT = 2 * v**2 / g * (cos(theta) ** 2 - sin(theta) ** 2)
W_BEST = LambertW(((k * v / g) ** 2 - 1) * exp(-1))
UPWARD = (-g + (g + k * v * sin(theta)) * exp(-k * t)) / k

# Stable form, its output and primitives; the printed form, its value and its slope in k at 0; the assumptions.
ROWS = (
    ("flight_time", 0, (flight_factor,), (1 + k * RISE + W) / k, 2 * RISE, -2 * RISE**2 / 3, SHOT),
    (
        "horizontal_range",
        0,
        (range_factor,),
        v * cos(theta) / k * (1 + W / (1 + k * RISE)),
        REACH,
        -4 * REACH * RISE / 3,
        SHOT,
    ),
    (
        "position",
        1,
        (phi1, phi2),
        HEIGHT,
        v * t * sin(theta) - g * t**2 / 2,
        g * t**3 / 6 - v * t**2 * sin(theta) / 2,
        FLIGHT,
    ),
    ("velocity", 1, (phi1,), UPWARD, v * sin(theta) - g * t, g * t**2 / 2 - v * t * sin(theta), FLIGHT),
    (
        "range_slope_theta",
        0,
        (range_balance, range_factor),
        -v * sin(theta) / k * (1 - TOUCH) * (1 + BEND * cos(theta) ** 2 / sin(theta) ** 2),
        STRAIGHT,
        -4 * RISE / 3 * (STRAIGHT + 2 * v**2 / g * cos(theta) ** 2),
        SHOT,
    ),
    (
        "range_slope_k",
        0,
        (range_loss,),
        -v * cos(theta) * (1 - TOUCH) * (1 + BEND) / k**2,
        -4 * REACH * RISE / 3,
        28 * REACH * RISE**2 / 9,
        SHOT,
    ),
    (
        "max_range",
        0,
        (max_range_factor,),
        v / k * sqrt(1 - (2 + W_BEST) * exp(-1 - W_BEST)),
        v**2 / g,
        -2 * sqrt(2) * v**3 / (3 * g**2),
        {g: POSITIVE, v: POSITIVE},
    ),
)


def from_twin(output, primitives):
    """The derivation of a row: expand the primitives of the stable form to first order."""
    closed = exp if phi1 in primitives else LambertW

    def at_zero(twin, *at_zero_of_primitives):
        """Expand the primitives to first order at 0, where their slopes are proved, and write the rest as printed."""
        forms = twin.rhs if isinstance(twin.rhs, Tuple) else (twin.rhs,)
        facts = {p: told.statement for p, told in zip(primitives, at_zero_of_primitives, strict=True)}
        return twin_at_zero(forms[output], k, facts, closed)

    return at_zero


for _twin, _output, _primitives, _form, _value, _slope, _ranges in ROWS:
    chapter.derive(
        f"stable.projectile.{_twin}.drag.at-zero",
        limits_at_zero(_form, k, _value, _slope),
        Domain({**_ranges, k: POSITIVE}),
        premises=(f"stable.projectile.{_twin}.drag", *(f"stable.at-zero.{p.__name__}" for p in _primitives)),
    )(from_twin(_output, _primitives))


if __name__ == "__main__":
    tell_chapter(chapter.name)
