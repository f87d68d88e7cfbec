"""galileo-sym: two papers on motion with resistance, from law to derived equation to emitted code to checked number."""

from importlib import import_module

__version__ = "0.1.0"

_SUBMODULES = frozenset({"chord", "lambert", "projectile", "special", "symbolic"})


def __getattr__(name):
    """Load a public module on first use, so that the numeric ones never pull in SymPy."""
    if name in _SUBMODULES:
        return import_module(f"{__name__}.{name}")
    if name == "show_config":
        return import_module(f"{__name__}._config").show_config
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *_SUBMODULES, "show_config"})
