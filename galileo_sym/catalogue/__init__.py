"""The functions worth emitting: arguments with units and domain, force sets, outputs, ledger ids."""

from .forms import NAMED, PURE, NotDerived, in_catalogue_symbols, ledger, stable
from .functions import ARGUMENTS, Argument, Ceiling, Function, Output
from .table import FUNCTIONS

__all__ = [
    "ARGUMENTS",
    "FUNCTIONS",
    "NAMED",
    "PURE",
    "Argument",
    "Ceiling",
    "Function",
    "NotDerived",
    "Output",
    "in_catalogue_symbols",
    "ledger",
    "stable",
]
