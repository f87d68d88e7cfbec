"""Systems of polynomial equations with the same solutions."""

from __future__ import annotations

import sympy as sp

MOST = 8  # symbols, beyond which a Groebner basis may take too long


def same_solutions(one, other) -> str | None:
    """Name the reason why two conjunctions of polynomial equations are equivalent, or None.

    Each equation of either must lie in the ideal of the other, once symbols that are not 0 can be divided by.
    """
    symbols = sorted(one.free_symbols | other.free_symbols, key=str)
    systems = [_polynomials(conjunction, symbols) for conjunction in (one, other)]
    if None in systems or len(symbols) > MOST:
        return None
    nonzero = [s for s in symbols if s.is_nonzero]
    inverse = sp.Dummy("inverse")
    invertible = [1 - inverse * sp.Mul(*nonzero)] if nonzero else []
    for mine, theirs in (systems, systems[::-1]):
        basis = sp.groebner([*mine, *invertible], inverse, *symbols, order="grevlex")
        if not all(basis.contains(p) for p in theirs):
            return None
    return "the same ideal"


def _polynomials(conjunction, symbols):
    """The polynomials over Q that vanish where a conjunction of equations holds; None if it is something else."""
    found = []
    for part in conjunction.args:
        if not isinstance(part, sp.Eq) or isinstance(part.lhs, sp.Tuple):
            return None
        try:
            found.append(sp.Poly(part.lhs - part.rhs, *symbols, domain="QQ").as_expr())
        except (sp.PolynomialError, sp.CoercionFailed):
            return None
    return found
