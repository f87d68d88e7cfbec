"""A function near a point where its value is known and not 0: signs on both sides, with unknown functions and order."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing, tactic
from galileo_sym.ledger.local import LocalExtremum, MonotoneBeside

from .leading_terms import value_at_centre

AWAY = sp.Dummy("away", positive=True)


@dataclass(frozen=True)
class NearValue:
    """F(x) for x near `place`: a positive multiple of `value`, which is not 0."""

    function: type
    place: sp.Expr
    value: sp.Expr
    name: sp.Dummy  # stands for `value`

    def put(self, expr, away):
        """The expression with each F(...) as a positive multiple of the value, and the value by name.

        Each F must be taken at a place that is near as the distance `away` is small.
        """
        far = [f for f in expr.atoms(self.function) if f.args[0].subs(away, 0) != self.place]
        if far:
            raise DerivationError(f"the sign of {far} is not known near {self.place}")
        positive = {f: self.name * sp.Dummy("share", positive=True) for f in expr.atoms(self.function)}
        return expr.xreplace(positive).xreplace({self.value: self.name})


@tactic
def value_near(series: sp.Eq, at_place: sp.Eq, nonzero: sp.Ne) -> NearValue:
    """A power series is continuous: near its centre it has the sign of its value there.

    Parameters
    ----------
    series : Eq
        Eq(F(x), Sum(...)), a power series about a place.
    at_place : Eq
        Eq(Subs(F(x), x, place), value).
    nonzero : Ne
        Ne(value, 0).

    Raises
    ------
    DerivationError
        The three do not fit: the series has another value at the place, or the value may be 0.
    """
    (x,), (place,) = at_place.lhs.variables, at_place.lhs.point
    value = value_at_centre(series.rhs, x, place)
    if at_place.lhs.expr != series.lhs or at_place.rhs != value or nonzero != sp.Ne(value, 0):
        raise DerivationError(f"{at_place} and {nonzero} do not say that {series} is not 0 at {place}")
    return NearValue(series.lhs.func, place, value, sp.Dummy("value", real=True, nonzero=True))


@tactic
def even_at_extremum(deviation, x, order, near: NearValue, away) -> sp.Implies:
    """The order of a zero is even where f has an extremum: if it were odd, f - f(place) would change sign there.

    Parameters
    ----------
    deviation : expression in x
        f(x) - f(place), with symbolic order and the unknown function F of `near`.
    order : Symbol
        A positive whole number.
    away : Symbol
        Names a small positive distance.

    Returns
    -------
    Implies
        Implies(order odd, f - f(place) has values of both signs: their product, at equal distances, is negative).
    """
    half = sp.Dummy("half", integer=True, nonnegative=True)
    sides = [deviation.subs(x, near.place + side * away) for side in (1, -1)]
    product = sp.Mul(*(near.put(side, away).subs(order, 2 * half + 1) for side in sides))
    if not sp.powsimp(product).is_negative:
        raise DerivationError(f"{deviation} does not change sign at {near.place} for odd {order}")
    return sp.Implies(sp.Eq(sp.Mod(order, 2), 1), sp.Lt(sp.Mul(*sides), 0))


@tactic
def monotone_beside(factored: sp.Eq, x, order, near: NearValue):
    """Strict monotony of f on both sides of a place from its slope (x - place)^(order - 1) G(x), G(place) not 0.

    By the mean value theorem: the slope has one sign on each side.

    Parameters
    ----------
    factored : Eq
        Eq(f(x), constant + (x - place)^order F(x)), with the unknown function F of `near`, a power series.
    x : Symbol
    order : Symbol
        A positive whole number.

    Returns
    -------
    pair of MonotoneBeside
        To the right, in the direction of the value of F, and to the left.
    """
    f, slope = factored.lhs, sp.diff(factored.rhs, x)
    power = (x - near.place) ** (order - 1)
    growth = sp.expand(sp.powsimp(sp.expand(slope / power)))
    unknown = growth.atoms(near.function, sp.Derivative)
    if not growth.xreplace({e: sp.Dummy("unknown") for e in unknown}).is_polynomial(x):
        raise DerivationError(f"{growth} may be infinite at {near.place}")
    at_place = sp.simplify(_at_place(growth, x, near))
    if not at_place.xreplace({near.value: near.name}).is_nonzero:
        raise DerivationError(f"{growth} may vanish at {near.place}")
    claims = []
    for side in (1, -1):
        beside = sp.expand_power_base((side * AWAY) ** (order - 1))
        direction = sp.expand_power_base(sp.Integer(side) ** (order - 1)) * near.value
        steep = sp.powsimp((beside * at_place / direction).xreplace({near.value: near.name}))
        if not sp.simplify(steep).is_positive:
            raise DerivationError(f"the slope of {f} has not the sign of {direction} on the side {side}")
        claims.append(MonotoneBeside(f, x, near.place, side, direction))
    return tuple(claims)


def _at_place(expr, x, near):
    """The value at the place, derivatives of the unknown function being finite there."""
    finite = {d: sp.Dummy("finite", real=True) for d in expr.atoms(sp.Derivative)}
    return expr.xreplace(finite).xreplace({near.function(x): near.value}).subs(x, near.place)


@tactic
def negative_root(equation: sp.Eq, order, even: sp.Eq, sign: sp.Le) -> sp.Eq:
    """From base^order = Q with an even order and base <= 0: base = -Q^(1/order).

    Parameters
    ----------
    equation : Eq
        Its left side is base^order, with the base of `sign`, a quotient or not.
    even : Eq
        Eq(Mod(order, 2), 0), proved.
    sign : Le
        Le(base, 0), proved.
    """
    base = sign.lhs
    size, half = sp.Dummy("size", nonnegative=True), sp.Dummy("half", integer=True, positive=True)
    if even != sp.Eq(sp.Mod(order, 2), 0) or not isinstance(sign, sp.LessThan) or sign.rhs != 0:
        raise DerivationError(f"{even} and {sign} do not say that {order} is even and {base} not positive")
    if sp.powsimp(sp.expand_power_base(base**order) / equation.lhs) != 1:
        raise DerivationError(f"the left side of {equation} is not {base} to the power {order}")
    if ((-size) ** (2 * half)) ** (1 / (2 * half)) != size:
        raise DerivationError(f"the root of {equation} is not the size of {base}")
    return sp.Eq(base, -(equation.rhs ** (1 / order)), evaluate=False)


@tactic
def extremum_between(falling, rising) -> LocalExtremum:
    """A function that is strictly monotone, in opposite ways, up to a place and from there on has an extremum there."""
    f, x, before = falling.args
    g, z, after = rising.args
    meet = before.end == after.start and before.end in before and after.start in after
    if {type(falling), type(rising)} != {StrictlyIncreasing, StrictlyDecreasing} or (f, x) != (g, z) or not meet:
        raise DerivationError(f"{falling} and {rising} do not meet in an extremum")
    return LocalExtremum(f, x, before.end)
