"""From one side of an extremum to the other: the place where a function takes the same value again."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, ForAll, tactic
from galileo_sym.ledger.local import HoldsBeside, MonotoneBeside

from .beside import NearValue
from .leading_terms import value_at_centre


@tactic
def reflected_beside(right: MonotoneBeside, left: MonotoneBeside, series: ForAll, inverse: ForAll):
    """To the left of an extremum f takes values that it takes to the right, too, where g undoes it.

    Be m <= h so small that f is monotone up to place + m, and k so small that it is from place - k on, and that
    |f(place - k) - f(place)| <= |f(place + m) - f(place)|, f being continuous. For x in [place - k, place], f(x) lies
    between f(place) and f(place + m), on whose side f is left and right. By the intermediate value theorem
    f(x) = f(z) with z in [place, place + m], so that g(f(x)) = g(f(z)) = z. With m, z - place is as small as wanted.

    Parameters
    ----------
    right, left : MonotoneBeside
        Of f(x), on the two sides of the place, in opposite directions.
    series : ForAll
        Of Eq(f(x), Sum(...)), a power series about the place, for every x within h of it: f is continuous there.
    inverse : ForAll
        Of Eq(g(f(x)), x), for every x in [place, place + h].

    Returns
    -------
    pair of HoldsBeside and Eq
        To the left, place <= z <= place + h and f(z) = f(x) for z = g(f(x)); and Eq(Limit(z, x, place, "-"), place).

    Raises
    ------
    DerivationError
        f does not return to its values, is not known to be continuous, or g is not known to undo it.
    """
    if not (isinstance(right, MonotoneBeside) and isinstance(left, MonotoneBeside)):
        raise DerivationError(f"{right} and {left} do not say that a function is monotone beside a place")
    f, x, place, side, way = right.args
    opposite = left.args[:4] == (f, x, place, -side) and side == 1 and left.args[4] + way == 0
    if not opposite:
        raise DerivationError(f"f does not return on the left to the values on its right: {left}, {right}")
    (told, _, known), (undone, z, half) = _read(series, x), _read(inverse, x)
    value_at_centre(told.rhs, x, place)
    reach = half.end - place
    inside = (
        half == sp.Interval(place, half.end) and reach.is_positive and known == sp.Interval(place - reach, half.end)
    )
    if told.lhs != f or not inside:
        raise DerivationError(f"{series} does not say that {f} is continuous on {half}, and as far on the other side")
    reflected = undone.lhs
    if undone.rhs != z or f not in reflected.args or reflected.subs(f, z).has(f):
        raise DerivationError(f"{inverse} does not undo {f}")
    same = sp.Eq(f.subs(x, reflected), f, evaluate=False)
    there = sp.And(sp.Ge(reflected, place), sp.Le(reflected, half.end), same, evaluate=False)
    tends = sp.Eq(sp.Limit(reflected, x, place, "-"), place, evaluate=False)
    return HoldsBeside(there, x, place, -side), tends


def _read(claim, x):
    """The parts of what is said of every x."""
    if not (isinstance(claim, ForAll) and isinstance(claim.args[0], sp.Eq) and claim.args[1] == x):
        raise DerivationError(f"{claim} is not an equation for every {x}")
    return claim.args


@tactic
def nonzero_along(near: NearValue, tends: sp.Eq, at_end: sp.Eq) -> HoldsBeside:
    """F(y) is not 0 when y is near to where F, continuous, has a value that is not 0.

    Parameters
    ----------
    near : NearValue
        Of F, near a place.
    tends : Eq
        Eq(Limit(y(x), x, end, "-"), place).
    at_end : Eq
        Eq(y(end), place).
    """
    y, x, end, side = tends.lhs.args
    if tends.rhs != near.place or str(side) != "-" or at_end != sp.Eq(y.subs(x, end), near.place):
        raise DerivationError(f"{near.function} is not known where {tends} and {at_end}")
    return HoldsBeside(sp.Ne(near.function(y), 0), x, end, -1)
