"""Which back end serves the public functions: the compiled extension, or the NumPy modules where there is none."""

import os
from importlib import import_module

VARIABLE = "GALILEO_SYM_BACKEND"
NAMES = ("numpy", "c")


class BackendError(RuntimeError):
    """The back end that the environment asks for is not known, or is not there."""


def _extension():
    """The compiled module, or None where the installation has none."""
    try:
        return import_module("galileo_sym.generated._ufuncs")
    except ModuleNotFoundError:
        return None


def _chosen():
    """The name of the back end, and the extension if that is it."""
    asked = os.environ.get(VARIABLE, "")
    if asked not in ("", *NAMES):
        raise BackendError(f"{VARIABLE}={asked}: there is no such back end; set it to numpy or c, or unset it")
    extension = None if asked == "numpy" else _extension()
    if asked == "c" and extension is None:
        raise BackendError(
            f"{VARIABLE}=c: this installation has no compiled extension; install a C compiler, then galileo-sym again "
            f"(`make install`, or `pip install --force-reinstall .`), or unset {VARIABLE}"
        )
    return ("numpy" if extension is None else "c"), extension


NAME, EXTENSION = _chosen()


def ufunc(name):
    """Return the ufunc of a name: NumPy's own kind from the extension, or the stand-in for it.

    Parameters
    ----------
    name : str
        Such as ``chord_descent_time_drag``, ``chord_position_free_x``, or a one-variable function's.
    """
    if EXTENSION is not None:
        return getattr(EXTENSION, name)
    from galileo_sym._stand_in import stand_in  # noqa: PLC0415 (it loads the tables of the NumPy kernels)

    return stand_in(name)
