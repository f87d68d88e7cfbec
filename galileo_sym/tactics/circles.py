"""Circles: centre and radius read off an equation, and arcs shown to be traced once and completely."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from galileo_sym.ledger import DerivationError, TracesOnce, step, tactic
from galileo_sym.ledger.equivalence import is_zero

from .places import ordered, require_inside
from .signs import sign_by_factors


@dataclass(frozen=True)
class Circle:
    """Centre (a, b) and radius of a circle."""

    centre: tuple
    radius: sp.Expr


@tactic
def read_circle(equation: sp.Eq, x, y) -> Circle:
    """Complete the squares in a quadratic equation between x and y.

    Raises
    ------
    DerivationError
        The equation is not that of a circle.
    """
    polynomial = sp.Poly(sp.expand(equation.lhs - equation.rhs), x, y)
    lead = polynomial.coeff_monomial(x**2)
    odd = [monomial for monomial in polynomial.monoms() if sum(monomial) > 2 or monomial == (1, 1)]
    if odd or lead == 0 or is_zero(lead - polynomial.coeff_monomial(y**2)) is None:
        raise DerivationError(f"{equation} is not a circle in {x} and {y}")
    a = sp.simplify(-polynomial.coeff_monomial(x) / (2 * lead))
    b = sp.simplify(-polynomial.coeff_monomial(y) / (2 * lead))
    square = sp.factor(a**2 + b**2 - polynomial.coeff_monomial(1) / lead)
    if square.is_negative:
        raise DerivationError(f"no point satisfies {equation}: the square of the radius is {square}")
    return Circle((a, b), sp.sqrt(square).replace(sp.Abs, lambda r: r if r.is_nonnegative else sp.Abs(r)))


@tactic
def trace_circle(
    point, parameter, interval, equation, region, coordinates, inverse, offset=sp.S.Zero, using=None, facts=None
):
    """Show that a moving point traces exactly the part of a circle in a region, once.

    The point, seen from the centre, is rho*(sin(phi), cos(phi)) with phi = 2*parameter + offset. It runs through the
    whole circle if phi gains 2*pi, and through the part on one side of the vertical if it starts and ends there, at
    equal heights above and below the centre (phi and pi - phi). Without the ends, where phi is -pi and pi, the whole
    circle lacks the one point that is on the x-axis, if the centre is a radius beside it.

    Parameters
    ----------
    point : pair of expressions in `parameter`
    interval : Interval
        Of the parameter.
    equation : Eq
        The circle.
    region : Boolean
        True for the whole circle, or x >= 0, or x <= 0, or y > 0.
    coordinates : pair of symbols (x, y)
    inverse : expression
        The parameter as a function of x and y: atan(x/y), the parameter being the angle at the origin.
    offset : expression
        Of the angle phi.
    using : dict, optional
        Known relations to be put in when the ends of the arc are compared.
    facts : dict, optional
        {part: Gt(part, 0)}, proved, of parts of the radius that SymPy does not know to be positive: a circle of no
        radius is not traced once.

    Returns
    -------
    TracesOnce
    """
    x, y = coordinates
    circle = read_circle(equation, x, y)
    if sign_by_factors(circle.radius, facts or {}) != 1:
        raise DerivationError(f"the radius {circle.radius} is not positive")
    phi = 2 * parameter + offset
    ways = (sp.sin(phi), sp.cos(phi))
    for place, middle, way in zip(point, circle.centre, ways, strict=True):
        left = place - middle - circle.radius * way
        if is_zero(sp.simplify(sp.expand_trig(sp.expand(left)))) is None:
            raise DerivationError(f"{place} is not {middle} + {circle.radius}*{way}")
        step("seen from the centre", sp.Eq(place - middle, circle.radius * way, evaluate=False))
    if inverse != sp.atan(x / y) or is_zero(sp.cos(parameter) * point[0] - sp.sin(parameter) * point[1]) is None:
        raise DerivationError(f"{inverse} is not shown to give {parameter}: x/y is not its tangent")
    for end in (interval.start, interval.end):
        require_inside(end, sp.Interval(-sp.pi / 2, sp.pi / 2))
    first, last = (phi.subs(parameter, end) for end in (interval.start, interval.end))
    if region == sp.Gt(y, 0):
        _all_but_one(first, last, interval, circle)
    else:
        _covers(first, last, region, x, circle, using or {})
    return TracesOnce(sp.Tuple(*point), parameter, interval, equation, region, sp.Tuple(x, y), inverse)


def _covers(first, last, region, x, circle, using):
    turn = sp.simplify(last - first)
    if region == sp.true:
        if turn != 2 * sp.pi:
            raise DerivationError(f"the angle gains {turn}, not 2*pi: the circle is not traced once")
        return
    side = {sp.Ge(x, 0): 1, sp.Le(x, 0): -1}.get(region)
    if side is None:
        raise DerivationError(f"the region must be a side of the vertical, not {region}")
    place = {1: first, -1: last}[side]
    start = sp.simplify(circle.centre[0] + circle.radius * sp.sin(place))
    middle = sp.simplify((first + last).subs(using))
    if start != 0 or middle != side * sp.pi:
        raise DerivationError(f"the arc from {first} to {last} does not begin and end on the vertical")
    if not ordered(last, first + 2 * sp.pi, strict=True):
        raise DerivationError(f"the arc from {first} to {last} is not shown to be less than a turn")


def _all_but_one(first, last, interval, circle):
    """Refuse what is not a whole circle above the x-axis, touching it where the open interval ends."""
    if not (interval.left_open and interval.right_open) or (first, last) != (-sp.pi, sp.pi):
        raise DerivationError(f"the angle from {first} to {last} does not leave out just the highest or lowest point")
    if sp.simplify(circle.centre[1] - circle.radius) != 0:
        raise DerivationError(f"a circle with the centre {circle.centre} and radius {circle.radius} is not above y = 0")


@tactic
def sine_maximum(wave, parameter, offset, ends, within):
    """Where amplitude*sin(2*parameter + offset) is largest on an interval, if the quarter turn is inside.

    Parameters
    ----------
    wave : expression
        amplitude*sin(2*parameter + offset) with a positive amplitude.
    ends : pair
        Of the interval of the parameter; the phase must run from `offset` to pi - `offset`.
    within : Interval
        In which the offset lies: inside a quarter turn, so that the phase passes pi/2 once, and -3*pi/2 never.
    """
    if within.is_subset(sp.Interval(-sp.pi / 2, sp.pi / 2)) is not True:
        raise DerivationError(f"an offset in {within} may make the phase pass a maximum several times")
    phase = 2 * parameter + offset
    amplitude = sp.simplify(wave / sp.sin(phase))
    if not amplitude.is_positive or amplitude.has(parameter):
        raise DerivationError(f"{wave} is not a positive multiple of sin({phase})")
    first, last = (sp.simplify(phase.subs(parameter, e)) for e in ends)
    if first != offset or sp.simplify(first + last - sp.pi) != 0:
        raise DerivationError(f"the phase runs from {first} to {last}, not symmetrically about pi/2")
    return sp.solve(phase - sp.pi / 2, parameter)[0]
