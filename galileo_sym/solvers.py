"""Functions whose stable form is an equation: which template solves it, and what it has to know of the equation."""

from dataclasses import dataclass

from sympy import Derivative, Symbol, tan

from galileo_sym.catalogue import NotDerived, in_catalogue_symbols, ledger
from galileo_sym.primitives import phi2


@dataclass(frozen=True)
class Solver:
    """How an equation is solved.

    ``template`` is the emitted routine; ``numbers`` the arguments it takes, by their names in ``catalogue.PURE``;
    ``balance`` gives what it evaluates in each step, by name, ``unknown`` the symbols this is a function of, and
    ``named`` the products in it that emitted code names.
    """

    template: str
    numbers: tuple
    unknown: tuple
    balance: object
    named: dict


def _result(identifier):
    entry = ledger()[identifier]
    if entry.result is None:
        raise NotDerived(f"{entry.id} could not be derived: run `galileo-sym derive {entry.id}` to see why")
    return entry.result


def _launch_balance():
    """The square of the range as a function of z, its slopes by z**2, and rise/range = tan(theta)."""
    equation = {e.lhs: e.rhs for e in _result("stable.projectile.launch_angles.drag").args}
    (square,) = (form for side, form in equation.items() if not side.has(tan))
    (rise,) = (form * Symbol("rho", real=True) for side, form in equation.items() if side.has(tan))
    slopes = {}
    for told in _result("stable.projectile.launch_angles.slopes").args:
        (derivative,) = told.lhs.atoms(Derivative)
        slopes[derivative.expr] = told.rhs
    slope = slopes[square]
    forms = {"square": square, "slope": slope, "bend": slopes[slope], "rise": rise, "lean": slopes[rise]}
    return {name: in_catalogue_symbols(form) for name, form in forms.items()}


_z, _alpha = Symbol("z"), Symbol("alpha")

SOLVERS = {
    ("projectile.launch_angles", "drag"): Solver(
        "launch",
        ("rho", "alpha"),
        ("z", "alpha"),
        _launch_balance,
        {"fall": _z**2 * phi2(-_alpha * _z), "Z": _z**2},
    ),
}
