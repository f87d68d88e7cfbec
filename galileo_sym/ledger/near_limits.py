"""Two limits that are the same because the functions come together."""

from __future__ import annotations

import sympy as sp
from sympy.core.function import AppliedUndef

_BEYOND = (sp.LambertW, AppliedUndef, sp.Piecewise, sp.Sum, sp.Abs, sp.sign)  # SymPy's limits of these may be wrong


def same_limit(one, other) -> str | None:
    """The reason why two limits at one place are the same: the functions' difference, elementary, tends to 0."""
    if one.args[1:] != other.args[1:]:
        return None
    f, x, place, side = one.args
    difference = sp.expand((f - other.args[0]).doit())
    if difference.has(*_BEYOND) or difference.atoms(sp.Derivative):
        return None
    away = sp.Dummy("away", positive=True)
    if place.is_infinite:
        path = away if place > 0 else -away
        tends = sp.limit(difference.subs(x, path), away, sp.oo)
    else:
        path = place + away if str(side) == "+" else place - away
        tends = sp.limit(difference.subs(x, path), away, 0, "+")
    return "the difference tends to 0" if tends == 0 else None
