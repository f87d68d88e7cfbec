"""One equation solved for one quantity, with the roots that are dropped named."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic
from galileo_sym.ledger.equivalence import is_zero


@tactic
def isolate(equation: sp.Eq, unknown, *, drop=None, hide=()) -> sp.Eq:
    """Solve an equation for `unknown`.

    Parameters
    ----------
    equation : Eq
    unknown : Symbol
        Its assumptions (positive, ...) say which roots count.
    drop : dict, optional
        Roots to be left out, each with the reason: {0: "the bead at A"}.
    hide : dict, optional
        Sub-expressions to be replaced by symbols that carry their sign while solving: {cos(theta): Symbol(positive)}.

    Returns
    -------
    Eq
        Eq(unknown, root), the only root left.
    """
    hide = dict(hide)
    ready = equation.subs(hide) if hide else equation
    roots = sp.solve(ready.lhs - ready.rhs, unknown)
    _require_all_roots(ready, unknown, roots, drop)
    back = {v: k for k, v in hide.items()}
    left = [unhide(r, back) for r in roots]
    for root in drop or {}:
        gone = [r for r in left if is_zero(r - root)]
        if len(gone) != 1:
            raise DerivationError(f"the root {root} to be dropped is not among {left}")
        left.remove(gone[0])
    if len(left) != 1:
        raise DerivationError(f"{equation} has the roots {left} for {unknown}: say which to drop")
    return sp.Eq(unknown, left[0], evaluate=False)


def unhide(root, back: dict):
    """Put expressions back for the positive symbols that stood for them.

    A positive root is rebuilt from its square: 1/sqrt(c) with c > 0 for cos(theta) becomes sqrt(1/cos(theta)), the form
    that SymPy keeps for a cosine whose sign it does not know.
    """
    if root.is_positive and any(p.exp.is_Rational and p.exp.q == 2 for p in root.atoms(sp.Pow)):
        return sp.sqrt((root**2).subs(back))
    return root.subs(back)


def _require_all_roots(equation, unknown, roots, drop):
    """Refuse where SymPy gives one of several roots: W on its principal branch, an angle in one turn."""
    if any(r.has(sp.LambertW) for r in roots) and not equation.has(sp.LambertW):
        raise DerivationError(f"{equation} has a root on each branch of W: {roots} may not be all")
    periodic = [e for e in equation.atoms(sp.sin, sp.cos, sp.tan, sp.cot) if e.args[0].has(unknown)]
    if periodic and not drop:
        raise DerivationError(f"{equation} has a root in every turn of {unknown}: use solve_angle, or drop some")


@tactic
def substitute(equation: sp.Eq, table: dict, tidy=sp.simplify) -> sp.Eq:
    """Put values in on both sides of an equation, and tidy the right one."""
    return sp.Eq(equation.lhs.subs(table), tidy(equation.rhs.subs(table)), evaluate=False)
