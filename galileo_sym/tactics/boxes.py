"""Signs of expressions: parts known to lie in intervals, and factors that the ladder knows."""

from __future__ import annotations

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from galileo_sym.ledger import DerivationError, tactic
from galileo_sym.ledger.equivalence import is_zero

from .signs import ladder

PLUS = sp.Interval.open(0, sp.oo)
MINUS = sp.Interval.open(-sp.oo, 0)

# where each function keeps one sign: the open interval of its argument, and the set of its values
_QUADRANTS = (
    (sp.cos, -sp.pi / 2, sp.pi / 2, PLUS),
    (sp.sin, 0, sp.pi, PLUS),
    (sp.tan, 0, sp.pi / 2, PLUS),
    (sp.cos, sp.pi / 2, 3 * sp.pi / 2, MINUS),
)


def box_of(*statements) -> dict:
    """Open intervals from proved inequalities: And(Gt(y(u), -1), Lt(y(u), 0)) gives {y(u): (-1, 0)}."""
    box: dict = {}
    for statement in statements:
        for part in statement.args if isinstance(statement, sp.And) else (statement,):
            if isinstance(part, sp.StrictGreaterThan | sp.StrictLessThan):
                _narrow(box, part)
    return box


def _narrow(box, relation: Relational):
    small, large = relation.lts, relation.gts
    for quantity, values in ((small, sp.Interval.open(-sp.oo, large)), (large, sp.Interval.open(small, sp.oo))):
        other = large if quantity is small else small
        if isinstance(quantity, sp.Symbol | AppliedUndef | sp.Derivative) and other.is_number:
            box[quantity] = box.get(quantity, sp.S.Reals) & values


def trig_box(expr, variable, interval) -> dict:
    """The signs of the sines, cosines and tangents in an expression while `variable` runs through an interval.

    A function that vanishes, or has its pole, at a closed end has no sign: give the interior, or an open end. Only
    arguments that are linear in the variable are looked at, since those run from one end to the other.
    """
    box = {}
    for applied in sorted(expr.atoms(sp.sin, sp.cos, sp.tan), key=str):
        if sp.diff(applied.args[0], variable).has(variable):
            continue
        ends = [(applied.args[0].subs(variable, e), is_open) for e, is_open in _ends(interval)]
        (first, first_open), (last, last_open) = sorted(ends, key=lambda end: end[0])
        for function, low, high, values in _QUADRANTS:
            after = low < first or (low == first and (first_open or _keeps_sign(function, low)))
            before = last < high or (last == high and (last_open or _keeps_sign(function, high)))
            if applied.func == function and after and before:
                box[applied] = values
    return box


def _ends(interval):
    return (interval.start, interval.left_open), (interval.end, interval.right_open)


def _keeps_sign(function, place):
    """Whether a function is neither 0 nor infinite at the edge of its quadrant."""
    return function(place).is_zero is False and function(place).is_finite is True


@tactic
def sign_on(expr, box: dict) -> int:
    """The sign of an expression, rational in parts that range independently through open intervals.

    Each part is written as a rational function of its own positive parameter, which maps (0, oo) onto the interval;
    then every factor must have coefficients of one sign.

    Parameters
    ----------
    expr : expression
    box : dict
        {part: open Interval}; symbols that are not in it must carry their sign.

    Returns
    -------
    int
        +1 or -1.

    Raises
    ------
    DerivationError
        The sign is not the same everywhere, or could not be proved.
    """
    names = {part: sp.Dummy(f"p{i}", real=True) for i, part in enumerate(box)}
    onto = {names[part]: _parametrised(values, sp.Dummy("p", positive=True)) for part, values in box.items()}
    hidden = sp.together(expr.xreplace(names).subs(onto))
    sign = 1
    for polynomial in sp.fraction(hidden):
        for factor in sp.Mul.make_args(sp.factor(polynomial)):
            known = sp.expand(factor)
            if not (known.is_positive or known.is_negative):
                raise DerivationError(f"the sign of {expr} does not follow from {box}: that of {factor} is open")
            sign *= 1 if known.is_positive else -1
    return sign


def _parametrised(values, p):
    """A rational map of p > 0 onto an open interval."""
    low, high = values.start, values.end
    if low.is_finite and high.is_finite:
        return low + (high - low) / (1 + p)
    if low.is_finite:
        return low + p
    if high.is_finite:
        return high - p
    raise DerivationError(f"{values} says nothing of a sign")


@tactic
def sign_by_ladder(expr, variable) -> int:
    """The sign of a product or quotient for every variable > 0: that of each factor by the derivative ladder."""
    sign = 1
    for part in sp.fraction(sp.together(sp.simplify(expr))):
        for factor in sp.Mul.make_args(sp.factor(part)):
            base, power = factor.as_base_exp() if factor.is_Pow else (factor, sp.S.One)
            sign *= _either(base, variable) ** power
    return int(sign)


def _either(expr, variable):
    for sign in (1, -1):
        try:
            ladder(sign * expr, variable)
        except DerivationError:
            continue
        return sign
    raise DerivationError(f"{expr} has no sign that the ladder proves for {variable} > 0")


@tactic
def zeros_from_0_on(expr, variable) -> set:
    """All places where a product or quotient vanishes, for variable >= 0.

    Each factor above is linear, or has a sign for every variable > 0 by the ladder, so that it may vanish at 0 only.
    """
    places = set()
    for factor in sp.Mul.make_args(sp.factor(sp.numer(sp.together(expr)))):
        base = factor.as_base_exp()[0] if factor.is_Pow else factor
        if base.is_polynomial(variable) and sp.degree(base, variable) == 1:
            place = -sp.expand(base).coeff(variable, 0) / sp.expand(base).coeff(variable, 1)
        else:
            sign_by_ladder(base, variable)
            place = sp.S.Zero if is_zero(base.subs(variable, 0)) else sp.S.NegativeInfinity
        if place.is_nonnegative is None:
            raise DerivationError(f"whether {place}, where {base} vanishes, is negative is not known")
        if place.is_nonnegative:
            places.add(place)
    return places


@tactic
def compare_on(left, right, box: dict):
    """Gt(left, right) or Lt(left, right), by the sign of the difference on a box."""
    return (sp.Gt if sign_on(left - right, box) > 0 else sp.Lt)(left, right, evaluate=False)
