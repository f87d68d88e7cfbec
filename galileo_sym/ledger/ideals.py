"""Systems of polynomial equations with the same solutions."""

from __future__ import annotations

import sympy as sp
from sympy.core.function import AppliedUndef

from .environment import equations

MOST = 8  # quantities, beyond which a Groebner basis may take too long


def same_solutions(one, other) -> str | None:
    """Name the reason why two conjunctions of equations are equivalent, or None.

    They must be polynomial in symbols, f(t) and roots. Each equation of either must lie in the ideal of the other, once
    symbols that are not 0 can be divided by.
    """
    systems = [_differences(conjunction) for conjunction in (one, other)]
    if None in systems:
        return None
    hidden = {e: sp.Dummy(str(e)) for e in _opaque(sp.Tuple(*systems[0], *systems[1]))}
    systems = [[e.xreplace(hidden) for e in system] for system in systems]
    symbols = sorted(set().union(*(e.free_symbols for system in systems for e in system)), key=str)
    if len(symbols) > MOST:
        return None
    try:
        systems = [[sp.Poly(e, *symbols, domain="QQ").as_expr() for e in system] for system in systems]
    except (sp.PolynomialError, sp.CoercionFailed):
        return None
    nonzero = [s for s in symbols if s.is_nonzero]
    inverse = sp.Dummy("inverse")
    invertible = [1 - inverse * sp.Mul(*nonzero)] if nonzero else []
    for mine, theirs in (systems, systems[::-1]):
        basis = sp.groebner([*mine, *invertible], inverse, *symbols, order="grevlex")
        if not all(basis.contains(p) for p in theirs):
            return None
    return "the same ideal"


def _differences(conjunction):
    """What vanishes where a conjunction of equations holds, tuples by component; None if it says anything else."""
    if not all(isinstance(part, sp.Eq) for part in conjunction.args):
        return None
    return [left - right for left, right in equations(conjunction)]


def _opaque(expressions):
    """Unknown functions and roots: what counts as one quantity more."""
    roots = {e for e in expressions.atoms(sp.Pow) if e.exp.is_Rational and not e.exp.is_Integer}
    return expressions.atoms(AppliedUndef) | roots
