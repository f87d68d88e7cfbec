"""Which dtype serves which operands, whatever the back end; Python's numbers take the dtype of the others (NEP 50)."""

from functools import lru_cache

import numpy as np

DOUBLE, SINGLE = np.dtype(np.float64), np.dtype(np.float32)
PYTHON_NUMBERS = (bool, int, float)


def is_foreign(value):
    """Whether a value has its own way with ufuncs, as arrays of other libraries have."""
    return getattr(type(value), "__array_ufunc__", np.ndarray.__array_ufunc__) is not np.ndarray.__array_ufunc__


def as_operand(value):
    """A Python number and what knows how to wrap an array as they are, anything else as an array."""
    if type(value) is int:
        return float(value)  # it may be beyond every integer dtype
    if type(value) in PYTHON_NUMBERS or is_foreign(value) or hasattr(value, "__array_wrap__"):
        return value
    return np.asarray(value)


def _serving(found):
    """Return the dtype that serves another one: float64 for bool and integers, float32 for half precision."""
    if found.kind in "biu":
        return DOUBLE
    if found.kind == "f" and found.itemsize <= DOUBLE.itemsize:
        return max(found.newbyteorder("="), SINGLE, key=lambda d: d.itemsize)
    raise TypeError(f"arguments of type {found.type.__name__} are not supported: convert them to float64 or float32")


def common_dtype(operands):
    """Return the dtype that serves all operands, as from `as_operand`, none of them foreign.

    Raises
    ------
    TypeError
        If one is complex, of extended precision, an object or otherwise no real number.
    """
    return _common(*(type(x)() if type(x) in PYTHON_NUMBERS else np.asarray(x).dtype for x in operands))


@lru_cache(maxsize=256, typed=True)
def _common(*known):
    """The same from dtypes and Python's numbers, whose values do not matter; NumPy takes long to tell."""
    for one in known:
        _serving(np.result_type(one))
    return _serving(np.result_type(*known))


def asked_dtype(dtype):
    """Return what ``dtype=`` asks for, or None.

    Raises
    ------
    TypeError
        If it is neither float64 nor float32.
    """
    if dtype is None:
        return None
    asked = np.dtype(dtype)
    if asked not in (DOUBLE, SINGLE):
        raise TypeError(f"dtype={asked} is not supported: ask for float64 or float32")
    return asked
