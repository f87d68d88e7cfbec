"""Elimination of one variable from two polynomials by their resultant."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic

from .eliminate import without_spurious


@tactic
def eliminate_one(one, other, variable, keep, spurious=None) -> sp.Eq:
    """The equation between the variables of `keep` that holds where two polynomials have a common root.

    Where the leading coefficients of both vanish the resultant is 0, too: such factors are spurious, and have to be
    named.

    Parameters
    ----------
    one, other : expressions
        Polynomial in `variable` and `keep`.
    variable : symbol
        To be eliminated.
    keep : sequence of symbols
    spurious : dict, optional
        Factors to be removed, each with the reason why it cannot vanish: {factor: reason}.

    Returns
    -------
    Eq
        Eq(polynomial, 0).

    Raises
    ------
    DerivationError
        There is no common root, or always one, or a factor is neither kept nor removed with a reason.
    """
    polynomials = [sp.numer(sp.together(p)) for p in (one, other)]
    found = sp.resultant(*polynomials, variable)
    if not found.has(*keep):
        raise DerivationError(f"{one} and {other} have a common root always or never: the resultant is {found}")
    return sp.Eq(without_spurious(found, keep, spurious or {}), 0, evaluate=False)
