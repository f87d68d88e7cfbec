"""The formulas that other contestants evaluate: as printed, or what follows from print by one step of calculus.

Speeds, velocities and slopes are derivatives of the printed distance, position and range; the largest range is the
range at the printed best angle. Special functions take the closed form by Lambert W that defines them.
"""

from functools import cache

from sympy import LambertW, Symbol, asin, atan, cos, diff, exp, pi, sin

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.primitives import FUNCTIONS as PRIMITIVES
from galileo_sym.typed_in import TypedIn, formulas

from .cases import SPECIAL

_a, _b, _c, _d, _g, _k, _mu, _r, _t, _theta, _v, _x = map(
    Symbol, ["a", "b", "c", "d", "g", "k", "mu", "r", "t", "theta", "v", "q"]
)
_X = _c * _d / _a * exp(-_b * _d / _a)
_SHALLOW = asin(_g * _r / _v**2) / 2


def _given(name, force_set):
    """The printed formulas of one variant, in plain symbols."""
    forms = formulas(FUNCTIONS[name], force_set)
    return tuple(form.subs({s: Symbol(s.name) for s in form.free_symbols}) for form in forms)


def _derivative(name, symbol):
    return lambda force_set: tuple(diff(form, symbol) for form in _given(name, force_set))


def _range_slope_k(force_set):
    """Without resistance there is a limit only."""
    return _derivative("projectile.horizontal_range", _k)(force_set) if force_set == "drag" else ()


def _max_range(force_set):
    if force_set == "free":
        return (_v**2 / _g,)
    (best,), (reach,) = _given("projectile.best_angle", ""), _given("projectile.horizontal_range", force_set)
    return (reach.subs(_theta, best.subs(Symbol("alpha"), _k * _v / _g)),)


def _launch_angles(force_set):
    """With resistance the papers give no closed form."""
    return (_SHALLOW, pi / 2 - _SHALLOW) if force_set == "free" else ()


_BEYOND = {
    "chord.speed": _derivative("chord.distance", _t),
    "chord.max_angle": lambda force_set: (atan(1 / _mu),),
    "projectile.velocity": _derivative("projectile.position", _t),
    "projectile.range_slope_theta": _derivative("projectile.horizontal_range", _theta),
    "projectile.range_slope_k": _range_slope_k,
    "projectile.max_range": _max_range,
    "projectile.launch_angles": _launch_angles,
    "lambert.w0": lambda force_set: (LambertW(_x),),
    "lambert.wm1": lambda force_set: (LambertW(_x, -1),),
    "lambert.linear_exponential_roots": lambda force_set: tuple(
        -_b / _a - LambertW(_X, branch) / _d for branch in (0, -1)
    ),
}
_SPECIAL = {
    "phi1m": (1 - exp(-_x)) / _x,
    "phi2m": (_x - 1 + exp(-_x)) / _x**2,
    "w0": LambertW(_x),
    "wm1": LambertW(_x, -1),
    "exp_minus": exp(-_x),
    "sin": sin(_x),
    "cos": cos(_x),
    "arctan": atan(_x),
}


def _special(name):
    """The closed form of a special function in q."""
    return _SPECIAL[name] if name in _SPECIAL else PRIMITIVES[name](_x).rewrite(LambertW)


@cache
def printed(full_name, force_set):
    """Formulas of one kernel.

    Parameters
    ----------
    full_name : str
        Such as ``chord.descent_time`` or ``special.phi1m``.
    force_set : str
        Key of the kernel in the function's variants; empty where there is one kernel.

    Returns
    -------
    tuple of sympy.Expr
        One for each output, in plain symbols of the catalogue's names; none where the papers lead to none.
    """
    paper, name = full_name.split(".")
    if paper == SPECIAL:
        return (_special(name),)
    if TypedIn().serves(full_name):
        return _given(full_name, force_set)
    return _BEYOND[full_name](force_set)


def symbols(case):
    """Names of the symbols that stand for the arguments of a case, in order."""
    if case.paper == SPECIAL:
        return (_x.name,)
    return tuple(argument.symbol for argument in FUNCTIONS[case.full_name].arguments(case.force_set))
