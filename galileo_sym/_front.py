"""What the public functions share: dtypes, broadcasting, out=, where=; the kernels themselves are emitted."""

import numpy as np

from galileo_sym.generated._lines import to_odd
from galileo_sym.generated._tables import HALF_PI

_DOUBLE, _SINGLE = np.dtype(np.float64), np.dtype(np.float32)
_PYTHON_NUMBERS = (bool, int, float, complex)
_CASTINGS = ("no", "equiv", "safe", "same_kind", "unsafe")


def _refuse_mask(value):
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(
            "masked arrays are not supported, their mask would be lost: pass a.filled(numpy.nan), or a.data with "
            "where=~numpy.ma.getmaskarray(a)"
        )


def _operand(value):
    """A Python number as it is (NEP 50: it takes the dtype of the others), anything else as an array."""
    if type(value) is int:
        return float(value)  # it may be beyond every integer dtype
    _refuse_mask(value)
    return value if type(value) in _PYTHON_NUMBERS else np.asarray(value)


def _serve_dtype(found):
    """Return the dtype that serves another one: float64 for bool and integers, float32 for half precision."""
    if found.kind in "biu":
        return _DOUBLE
    if found.kind == "f" and found.itemsize <= _DOUBLE.itemsize:
        return max(found.newbyteorder("="), _SINGLE, key=lambda d: d.itemsize)
    raise TypeError(f"arguments of type {found} are not supported: convert them to float64 or float32")


def _common_dtype(operands, dtype, casting):
    if casting not in _CASTINGS:
        raise ValueError(f"casting must be one of {', '.join(map(repr, _CASTINGS))}, not {casting!r}")
    for operand in operands:
        _serve_dtype(np.result_type(operand))
    if dtype is None:
        return _serve_dtype(np.result_type(*operands))
    wanted = np.dtype(dtype)
    if wanted not in (_DOUBLE, _SINGLE):
        raise TypeError(f"dtype={wanted} is not supported: ask for float64 or float32")
    for operand in operands:
        if not isinstance(operand, _PYTHON_NUMBERS) and not np.can_cast(operand.dtype, wanted, casting):
            raise TypeError(f"cannot cast an argument from {operand.dtype} to {wanted} with casting={casting!r}")
    return wanted


def _widen(array, is_angle):
    """An argument as float64; the float32 next to pi/2, which lies above it, counts as pi/2."""
    wide = array.astype(_DOUBLE, copy=False)
    if array.dtype == _SINGLE and is_angle:
        return np.where(np.abs(array) == np.float32(HALF_PI[0]), np.copysign(HALF_PI[0], wide), wide)
    return wide


def _widen_to_most(arrays, wide, ceiling, forces):
    """The float32 next to the largest value of an argument counts as that."""
    index, kernels = ceiling
    with np.errstate(all="ignore"):
        most = kernels[forces](*wide[:index], *wide[index + 1 :])
        wide[index] = np.where(arrays[index] == most.astype(_SINGLE), most, wide[index])


def _targets(out, count, dtype, casting):
    """Return the output arrays as a tuple, None for each one to be made."""
    if out is None:
        return (None,) * count
    targets = out if isinstance(out, tuple) else (out,)
    if len(targets) != count:
        raise ValueError(f"out must hold {count} array{'s' * (count > 1)}, not {len(targets)}")
    for target in targets:
        _refuse_mask(target)
        if target is not None and not isinstance(target, np.ndarray):
            raise TypeError("out must be an array, or a tuple of arrays and None")
        if target is not None and not np.can_cast(dtype, target.dtype, casting):
            raise TypeError(f"cannot cast the result from {dtype} to {target.dtype} with casting={casting!r}")
    return targets


def _masked(kernel, arrays, mask):
    """Evaluate the chosen lanes only; NaN elsewhere."""
    *arrays, mask = np.broadcast_arrays(*arrays, mask)
    results = _as_tuple(kernel(*(array[mask] for array in arrays)))
    placed = []
    for result in results:
        full = np.full(mask.shape, np.nan)
        full[mask] = result
        placed.append(full)
    return tuple(placed)


def _as_tuple(results):
    return results if isinstance(results, tuple) else (results,)


def serve(row, arguments, forces, out=None, where=True, casting="same_kind", dtype=None):
    """Evaluate an emitted function.

    Parameters
    ----------
    row : dict
        The function's row of ``FUNCTIONS`` in its generated module: ``outputs``, ``angle`` (an index), ``kernels``;
        ``ceiling``, if an argument has a largest value: its index and the kernels of that value; ``rest``, if the
        kernels return the only output with its rest, so that float32 results are rounded once.
    arguments : tuple of array_like
        All arguments but the forces, in order.
    forces : dict of str to array_like
        Force arguments by name; those that are the scalar 0 select the kernel without that force.
    out, where, casting, dtype
        As for a NumPy ufunc. Results not computed because of `where` are NaN, or left as they are in `out`.

    Returns
    -------
    scalar, ndarray or tuple of these
        One for each output; scalars if all arguments are, and no output was given.

    Raises
    ------
    TypeError
        For complex, extended-precision, object and other non-real arguments, for masked arrays, and for casts that
        `casting` forbids.
    ValueError
        If the arguments do not broadcast, `out` does not fit, or `casting` is no casting rule of NumPy.
    OverflowError
        For a Python integer beyond the range of float64.
    """
    operands = [_operand(value) for value in (*arguments, *forces.values())]
    dtype = _common_dtype(operands, dtype, casting)
    targets = _targets(out, row["outputs"], dtype, casting)
    arrays = [np.asarray(operand, dtype=dtype) for operand in operands]
    count = len(arguments)
    present = [(name, a) for name, a in zip(forces, arrays[count:], strict=True) if a.ndim or a != 0]
    acting = tuple(name for name, _ in present)
    kernel = row["kernels"][acting]
    wide = [_widen(a, i == row["angle"]) for i, a in enumerate([*arrays[:count], *(a for _, a in present)])]
    if dtype == _SINGLE and "ceiling" in row:
        _widen_to_most(arrays, wide, row["ceiling"], acting)
    if where is True:
        results, mask = _as_tuple(kernel(*wide)), True
    else:
        _refuse_mask(where)
        mask = np.asarray(where)
        if mask.dtype != np.bool_:
            raise TypeError(f"where must be boolean, not {mask.dtype}")
        results = _masked(kernel, wide, mask)
    if row.get("rest"):
        results = (results[0] if dtype == _DOUBLE else to_odd(*results),)
    given = []
    for result, target in zip(results, targets, strict=True):
        narrow = np.asarray(result).astype(dtype, copy=False)
        if target is None:
            given.append(narrow[()])
        else:
            np.copyto(target, narrow, casting=casting, where=mask)
            given.append(target)
    return tuple(given) if row["outputs"] > 1 else given[0]
