"""Sums of a sine and a cosine as one wave, arctangents undone, equations solved for an angle."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic
from galileo_sym.ledger.equivalence import is_zero


@dataclass(frozen=True)
class Wave:
    """level + amplitude*turn(angle + offset), with turn the sine or the cosine."""

    level: sp.Expr
    amplitude: sp.Expr
    turn: type
    offset: sp.Expr


@tactic
def as_wave(expr, angle, turn) -> Wave:
    """Write level + a*sin(angle) + b*cos(angle) as one sine or cosine with an offset between -pi/2 and pi/2.

    Parameters
    ----------
    expr : expression
    angle : expression
    turn : sin or cos
        Its own coefficient must be positive; the other one decides the offset.

    Raises
    ------
    DerivationError
        The expression is no such sum, or the coefficient is not known to be positive.
    """
    sine, cosine = sp.symbols("sine cosine", real=True)
    opened = sp.expand(expr).subs({sp.sin(angle): sine, sp.cos(angle): cosine})
    polynomial = sp.Poly(opened, sine, cosine)
    a, b, level = (polynomial.coeff_monomial(m) for m in (sine, cosine, 1))
    if set(polynomial.monoms()) - {(1, 0), (0, 1), (0, 0)} or any(e.has(*angle.free_symbols) for e in (a, b, level)):
        raise DerivationError(f"{expr} is not a sum of a sine and a cosine of {angle}")
    # A sin(z + d) = A cos(d) sin(z) + A sin(d) cos(z); A cos(z + d) = A cos(d) cos(z) - A sin(d) sin(z)
    own, other = {sp.sin: (a, b), sp.cos: (b, -a)}[turn]
    if not own.is_positive:
        raise DerivationError(f"the coefficient {own} of {turn.__name__}({angle}) is not known to be positive")
    return Wave(level, sp.sqrt(sp.expand(own**2 + other**2)), turn, sp.atan(sp.cancel(other / own)))


# y for which the tangent is what stands in the arctangent
_TANGENTS = (
    lambda x: (sp.tan(x), x),
    lambda x: (sp.cot(x), sp.pi / 2 - x),
)


@tactic
def undo_arctangent(expr, angle, interval):
    """Put x for atan(tan(x)), and pi/2 - x for atan(cot(x)), where that lies between -pi/2 and pi/2.

    Parameters
    ----------
    expr : expression
        With one arctangent of a tangent or cotangent of `angle`.
    interval : Interval
        In which `angle` lies.
    """
    arcs = [e for e in expr.atoms(sp.atan) if e.has(angle)]
    if len(arcs) != 1:
        raise DerivationError(f"{expr} has {len(arcs)} arctangents with {angle}")
    for rule in _TANGENTS:
        tangent, value = rule(angle)
        ends = sorted(value.subs(angle, e) for e in (interval.start, interval.end))
        within = sp.Interval.open(-sp.pi / 2, sp.pi / 2).is_superset(sp.Interval.open(*ends))
        if within and is_zero(arcs[0].args[0] - tangent) is not None:
            return expr.subs(arcs[0], value)
    raise DerivationError(f"{arcs[0]} is not undone by the tangent of an angle in {interval}")


@tactic
def solve_angle(equation: sp.Eq, angle, interval) -> sp.Eq:
    """Solve for an angle in a quarter turn: divided by its cosine the equation is one for the tangent, one-to-one.

    Parameters
    ----------
    equation : Eq
        Every term with one and the same number of sines and cosines of the angle, taken together.
    interval : Interval
        In which the angle lies, inside (-pi/2, pi/2); if inside (0, pi/2), only positive tangents count.

    Returns
    -------
    Eq
        Eq(angle, atan(...)).
    """
    if interval.is_subset(sp.Interval.open(-sp.pi / 2, sp.pi / 2)) is not True:
        raise DerivationError(f"the tangent does not tell the angles in {interval} apart")
    sine, cosine = sp.symbols("sine cosine", positive=True)
    names = {sp.tan(angle): sine / cosine, sp.sin(angle): sine, sp.cos(angle): cosine}
    flat = sp.numer(sp.together((equation.lhs - equation.rhs).subs(names)))
    polynomial = sp.Poly(flat, sine, cosine)
    if flat.has(angle) or not polynomial.is_homogeneous:
        raise DerivationError(f"{equation} is not one for the tangent of {angle}")
    acute = interval.is_subset(sp.Interval.open(0, sp.pi / 2)) is True
    tangent = sp.Dummy("tangent", **({"positive": True} if acute else {"real": True}))
    roots = sp.solve(polynomial.as_expr().subs({sine: tangent, cosine: 1}), tangent)
    if len(roots) != 1:
        raise DerivationError(f"{equation} has the roots {roots} for the tangent of {angle}")
    return sp.Eq(angle, sp.atan(roots[0]), evaluate=False)
