"""What a user gets by typing the printed formulas in: `sympy.lambdify` with NumPy and SciPy, as a contender.

Only equations of the papers are used, put into one another until nothing but arguments is left. Where a paper states
friction for theta > 0 alone, the formula is taken at |theta|; where it states a circle by its equation, centre and
radius are read off it.
"""

import warnings
from functools import cache

import numpy as np
from sympy import Abs, Eq, Symbol, lambdify, sign, sqrt

from galileo_sym.catalogue import FUNCTIONS, ledger

# Left sides of the equations that give the outputs, and entries beside the function's own sources.
_OUTPUTS = {
    "chord.descent_time": (("t_AB",), ()),
    "chord.distance": (("s(t)",), ()),
    "chord.position": (("x", "y"), ()),
    "chord.synchronous_circle": (("X(t)", "Y(t)", "R(t)"), ()),
    "projectile.flight_time": (("t",), ("projectile.def.uyR",)),
    "projectile.horizontal_range": (("R(theta)", "R(k, theta)"), ("projectile.def.uyR",)),
    "projectile.position": (("x(t)", "y(t)"), ()),
    "projectile.best_angle": (("theta_max",), ()),
}
_READ_OFF = {  # from (9), (21) and (31)
    "free": {"X(t)": lambda R, mu: 0 * R, "Y(t)": lambda R, mu: R},
    "friction": {"X(t)": lambda R, mu: mu * R / sqrt(1 + mu**2), "Y(t)": lambda R, mu: R / sqrt(1 + mu**2)},
    "drag": {"X(t)": lambda R, mu: 0 * R, "Y(t)": lambda R, mu: R},
}


class NoFormula(ValueError):
    """No printed equations give the function in closed form."""


def _equations(ids):
    """Left and right sides by the text of the left one; of an entry's equations for a quantity, the longest."""
    found = {}
    for identifier in ids:
        here = {}
        for equation in sorted(ledger()[identifier].printed.atoms(Eq), key=lambda e: len(str(e))):
            here[str(equation.lhs)] = (equation.lhs, equation.rhs)
        found = here | found
    return found


def _explicit(left, equations):
    _, expression = equations[left]
    for _ in equations:
        expression = expression.subs([pair for name, pair in equations.items() if name != left])
    return expression


def formulas(function, force_set):
    """Return the printed formula of each output of one variant, in the papers' symbols.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.

    Raises
    ------
    NoFormula
        If the papers give none.
    """
    if function.full_name not in _OUTPUTS:
        raise NoFormula(f"the papers print no closed form of {function.full_name}")
    lefts, beside = _OUTPUTS[function.full_name]
    forces = function.variants[force_set][0]
    equations = _equations((*function.sources(force_set), *(beside if forces else ())))
    read = _READ_OFF.get(force_set, {}) if function.name == "synchronous_circle" else {}
    out = []
    for left in lefts:
        if left in read:
            mu = next((s for s in equations["R(t)"][1].free_symbols if s.name == "mu"), 0)
            out.append(read[left](_explicit("R(t)", equations), mu))
        elif left in equations:
            out.append(_explicit(left, equations))
    if "mu" in forces:
        angle = {s: Abs(s) for e in out for s in e.free_symbols if s.name == "theta"}
        out = [e.subs(angle) * (sign(*angle) if left == "x" else 1) for left, e in zip(lefts, out, strict=True)]
    return tuple(out)


@cache
def compiled_formula(full_name, force_set):
    """Return the printed formulas of a variant as a function of its arguments, in order."""
    function = FUNCTIONS[full_name]
    names = [argument.symbol for argument in function.arguments(force_set)]
    symbols = [Symbol(name) for name in names]
    forms = [e.subs({s: Symbol(s.name) for s in e.free_symbols}) for e in formulas(function, force_set)]
    return lambdify(symbols, forms, modules=["scipy", "numpy"])


class TypedIn:
    """The printed formulas as a back end for verification."""

    name = "typed in"

    def serves(self, full_name):
        """Whether the papers print a closed form of the function."""
        return full_name in _OUTPUTS

    def evaluate(self, function, force_set, arguments):
        """Results of one variant: real parts, since SciPy's Lambert W is complex.

        Parameters and returns as in `galileo_sym.verify.native.NativeLibrary.evaluate`.

        Raises
        ------
        NoFormula
            If the papers print no closed form.
        """
        row = FUNCTIONS[function.full_name]
        force_set = force_set if force_set in row.variants else ""
        values = [np.asarray(arguments[a.name], dtype=float) for a in row.arguments(force_set)]
        with np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            results = compiled_formula(function.full_name, force_set)(*values)
        return tuple(np.array(np.broadcast_to(np.real(r), values[0].shape), dtype=float) for r in results)
