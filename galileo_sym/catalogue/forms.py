"""The stable forms that are emitted, by function and forces, in the symbols they are emitted in."""

from functools import cache

from sympy import And, Symbol, Tuple, cos, exp, sin, sqrt

from galileo_sym.ledger import Ledger
from galileo_sym.primitives import driving, phi1

from .functions import ARGUMENTS

_OF_EITHER_SIGN = {"theta", *(argument.symbol for argument in ARGUMENTS["lambert"].values())}


def _symbol(name):
    return Symbol(name, real=True) if name in _OF_EITHER_SIGN else Symbol(name, positive=True)


_D, _g, _t, _v, _k, _r, _mu, _theta = (_symbol(s) for s in ("D", "g", "t", "v", "k", "r", "mu", "theta"))

# Intermediate results that emitted code names: factored out of any product that contains them, the first that fits.
NAMED = {
    "lambert": {},
    "chord": {
        "t0": (sqrt(_D * cos(_theta) / (_g * driving(_theta, _mu))), sqrt(_D / _g)),
        "fall": (_g * _t**2,),
    },
    "projectile": {
        "rise": (_v * sin(_theta) / _g,),
        "reach": (_v * _t * phi1(-_k * _t), _v * _t),
        "fall": (_g * _t**2,),
        "fade": (exp(-_k * _t),),
    },
}


# Pure numbers that functions with a ceiling are computed from; alpha is 0 where k is absent.
PURE = {"rho": _g * _r / _v**2, "alpha": _k * _v / _g}


class NotDerived(ValueError):
    """A stable form has no derivation that reaches it."""


@cache
def ledger():
    """Return the ledger, loaded once in a process; its entries are derived only where asked for."""
    return Ledger.load()


def stable(function, force_set):
    """Return the stable form of one variant.

    Parameters
    ----------
    function : Function
    force_set : str
        A key of ``function.variants``.

    Returns
    -------
    tuple of sympy.Expr
        One for each output, in symbols of the ledger's names; or the statement itself, if it is an equation to solve.

    Raises
    ------
    KeyError
        If the ledger has no such entry.
    NotDerived
        If its derivation failed: what is emitted is what was derived.
    """
    entry = ledger()[function.ledger_id(force_set)]
    statement = entry.result
    if statement is None:
        raise NotDerived(f"{entry.id} could not be derived: run `galileo-sym derive {entry.id}` to see why")
    if isinstance(statement, And):
        return (in_catalogue_symbols(statement),)
    forms = statement.rhs if isinstance(statement.rhs, Tuple) else (statement.rhs,)
    return tuple(map(in_catalogue_symbols, forms))


def in_catalogue_symbols(form):
    """Return an expression of the ledger in the symbols that are emitted: of the same names, angles real."""
    return form.xreplace({s: _symbol(s.name) for s in form.free_symbols})
