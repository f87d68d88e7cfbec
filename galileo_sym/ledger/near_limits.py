"""Two limits that are the same because the functions come together."""

from __future__ import annotations

import sympy as sp

_ELEMENTARY = (sp.exp, sp.log, sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan)  # of others SymPy's may be wrong


def same_limit(one, other) -> str | None:
    """The reason why two limits at one place are the same: the functions' difference, elementary, tends to 0."""
    if one.args[1:] != other.args[1:]:
        return None
    f, x, place, side = one.args
    difference = sp.expand((f - other.args[0]).doit())
    known = all(isinstance(e, _ELEMENTARY) for e in difference.atoms(sp.Function))
    if not known or difference.has(sp.Derivative, sp.Sum):
        return None
    away = sp.Dummy("away", positive=True)
    paths = {sp.oo: away, -sp.oo: -away}
    path = paths.get(place, place + away if str(side) == "+" else place - away)
    try:
        tends = sp.limit(difference.subs(x, path), away, sp.oo if place.is_infinite else 0, "+")
    except NotImplementedError:
        return None
    return "the difference tends to 0" if tends == 0 else None
