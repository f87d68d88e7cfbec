"""Power series with symbolic order: leading terms split off, powers taken out, the value at the centre."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic
from galileo_sym.ledger.local import AllZero


@tactic
def split_series(series: sp.Sum, gap: AllZero):
    """A power series without the terms that vanish: its first term, and the series that is left.

    Parameters
    ----------
    series : Sum
        Of coefficient(i) times a power of one quantity, from i = 0 to infinity.
    gap : AllZero
        Of coefficient(i), from i = 1 to some index.

    Returns
    -------
    pair
        The term with i = 0, and the Sum from the index behind the gap.
    """
    term, (i, first, last) = series.args
    coefficient, index, after, end = gap.args
    fits = isinstance(gap, AllZero) and index == i and after == 1 and (first, last) == (0, sp.oo)
    if not fits or term.subs(coefficient, 0) != 0:
        raise DerivationError(f"{gap} does not make terms of {series} vanish")
    return term.subs(i, first), sp.Sum(term, (i, end + 1, last))


@tactic
def take_out(series: sp.Sum, power) -> sp.Sum:
    """The series whose product with a power of the quantity is `series`: every exponent is lowered.

    Raises
    ------
    DerivationError
        The first exponent does not become 0: too much or too little is taken out.
    """
    term, (i, first, last) = series.args
    lowered = sp.powsimp(term / power)
    base = power.as_base_exp()[0]
    if sp.simplify(_exponent(lowered, base).subs(i, first)) != 0:
        raise DerivationError(f"{power} is not the lowest power in {series}")
    return sp.Sum(lowered, (i, first, last))


def _exponent(term, base):
    """The exponent of a base in a product."""
    return sum((p.as_base_exp()[1] for p in sp.Mul.make_args(term) if p.as_base_exp()[0] == base), sp.S.Zero)


@tactic
def value_at_centre(series: sp.Sum, variable, centre):
    """The value of a power series at its centre: the first term, since a positive power of 0 is in all others.

    Raises
    ------
    DerivationError
        The terms behind the first do not vanish there, or the first is infinite.
    """
    term, (i, first, last) = series.args
    behind = sp.Dummy("behind", integer=True, positive=True)
    rest = sp.powsimp(term.subs(i, first + behind)).subs(variable, centre)
    value = term.subs(i, first).subs(variable, centre)
    if last is not sp.oo or rest != 0 or value.has(sp.zoo, sp.nan):
        raise DerivationError(f"{series} is not a power series about {variable} = {centre}")
    return value
