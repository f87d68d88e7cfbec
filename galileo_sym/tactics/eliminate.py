"""Elimination of variables from polynomial equations by a Gröbner basis."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic


@tactic
def eliminate(equations, variables, keep, spurious=None) -> sp.Eq:
    """The one equation between the variables of `keep` that follows from `equations`.

    Parameters
    ----------
    equations : sequence of Eq or expressions
        Polynomial in `variables` and `keep`; everything else counts as a coefficient.
    variables : sequence of symbols
        To be eliminated.
    keep : sequence of symbols
        Left in the result.
    spurious : dict, optional
        Factors to be removed, each with the reason why it cannot vanish: {factor: reason}.

    Returns
    -------
    Eq
        Eq(polynomial, 0).

    Raises
    ------
    DerivationError
        No equation or more than one is left, or it has a factor that is neither kept nor removed with a reason.
    """
    polynomials = [e.lhs - e.rhs if isinstance(e, sp.Eq) else e for e in equations]
    generators = (*variables, *keep)
    symbols = set().union(*(p.free_symbols for p in polynomials)) - set(generators)
    field = sp.QQ.frac_field(*sorted(symbols, key=str)) if symbols else sp.QQ
    basis = sp.groebner([sp.numer(sp.together(p)) for p in polynomials], *generators, order="lex", domain=field)
    left = [p for p in basis.exprs if not p.has(*variables)]
    if len(left) != 1:
        raise DerivationError(f"{len(left)} equations are left between {keep}: {left}")
    return sp.Eq(without_spurious(left[0], keep, spurious or {}), 0, evaluate=False)


def without_spurious(polynomial, keep, spurious):
    """The one factor of a polynomial in `keep` that is left when those named in `spurious` are removed."""
    _, factors = sp.factor_list(polynomial, *keep)
    unused = dict(spurious)
    kept = []
    for factor, power in factors:
        reason = next((f for f in unused if sp.expand(f - factor) == 0 or sp.expand(f + factor) == 0), None)
        if reason is None:
            kept.append(factor**power)
        else:
            unused.pop(reason)
    if unused:
        raise DerivationError(f"factors named as spurious do not occur: {list(unused)}")
    if len(kept) != 1:
        raise DerivationError(f"more than one factor is left, name the spurious ones: {kept}")
    return kept[0]


@tactic
def eliminate_angle(x_eq: sp.Eq, y_eq: sp.Eq, angle, keep) -> sp.Eq:
    """Eliminate an angle from two equations linear in its sine and cosine, by sin^2 + cos^2 = 1."""
    s, c = sp.symbols("s_angle c_angle", real=True)
    put = {sp.sin(angle): s, sp.cos(angle): c}
    equations = [e.lhs - e.rhs for e in (x_eq, y_eq)]
    return eliminate([e.subs(put) for e in equations] + [s**2 + c**2 - 1], (c, s), keep)
