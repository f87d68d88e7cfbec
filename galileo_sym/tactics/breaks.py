"""Where a function breaks: jumps and poles, which no tactic on monotony may pass over."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError

JUMPING = (sp.Piecewise, sp.floor, sp.ceiling, sp.sign, sp.Heaviside, sp.frac, sp.Mod)


def require_no_break(function, variable, interval):
    """Raise if a function is seen to jump, or to have a pole, in an interval.

    Unknown functions, and poles whose place depends on other quantities, are for the derivation to see to.
    """
    for part in sp.preorder_traversal(function):
        if not part.has(variable):
            continue
        if isinstance(part, JUMPING):
            raise DerivationError(f"{part} may jump in {interval}")
        pole = next((place for place in _poles(part, variable, interval) if interval.contains(place) == sp.true), None)
        if pole is not None:
            raise DerivationError(f"{part} has a pole at {variable} = {pole}, in {interval}")


def _poles(part, variable, interval):
    """Places where a power or a tangent is infinite, as far as they are numbers that are easily found."""
    if isinstance(part, sp.Pow) and part.exp.is_negative and part.base.is_polynomial(variable):
        polynomial = sp.Poly(part.base, variable)
        return polynomial.real_roots() if polynomial.domain.is_Exact and not polynomial.free_symbols_in_domain else ()
    if isinstance(part, sp.tan | sp.cot):
        return _poles_of_tangent(part, variable, interval)
    return ()


def _poles_of_tangent(part, variable, interval):
    slope, first = sp.diff(part.args[0], variable), part.args[0].subs(variable, 0)
    ends = [part.args[0].subs(variable, end) for end in (interval.start, interval.end)]
    if not slope.is_number or any(not end.is_number for end in ends):
        return
    shift = sp.pi / 2 if isinstance(part, sp.tan) else sp.S.Zero
    if any(end.is_infinite for end in ends):
        yield from (((sp.pi * n + shift - first) / slope) for n in (-1, 0, 1, 2))
        return
    low, high = sorted((end - shift) / sp.pi for end in ends)
    yield from ((sp.pi * n + shift - first) / slope for n in range(int(sp.ceiling(low)), int(sp.floor(high)) + 1))
