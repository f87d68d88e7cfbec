"""galileo-sym: two papers on motion with resistance, from law to derived equation to emitted code to checked number."""

from importlib import import_module

__version__ = "0.1.0"

_SUBMODULES = frozenset({"chord", "lambert", "projectile", "scenes", "special", "symbolic"})
_MEMBERS = {"Scene": "scenes", "show_config": "_config"}


def __getattr__(name):
    """Load a public module on first use, so that the numeric ones never pull in SymPy."""
    if name in _SUBMODULES:
        return import_module(f"{__name__}.{name}")
    if name in _MEMBERS:
        return getattr(import_module(f"{__name__}.{_MEMBERS[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *_SUBMODULES, *_MEMBERS})
