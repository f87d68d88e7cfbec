"""What the public functions share: numbers, forces that are 0, out=, where=, arrays of other libraries."""

import numpy as np

from galileo_sym import _backend
from galileo_sym._types import PYTHON_NUMBERS, as_operand, asked_dtype, common_dtype, is_foreign
from galileo_sym.generated._functions import FUNCTIONS

_CASTINGS = ("no", "equiv", "safe", "same_kind", "unsafe")


def _targets(out, count):
    """Return the output arrays as a tuple, None for each one to be made."""
    if out is None:
        return (None,) * count
    targets = out if isinstance(out, tuple) else (out,)
    if len(targets) != count:
        raise ValueError(f"out must hold {count} array{'s' * (count > 1)}, not {len(targets)}")
    for target in targets:
        if target is not None and not isinstance(target, np.ndarray) and not is_foreign(target):
            raise TypeError("out must be an array, or a tuple of arrays and None")
    return targets


def _mask(where):
    """The mask of what is to be computed."""
    if is_foreign(where):
        return where
    if isinstance(where, np.ma.MaskedArray):
        raise TypeError("where must not be a masked array, its mask would be lost: pass where.filled(False)")
    mask = np.asarray(where)
    if mask.dtype != np.bool_:
        raise TypeError(f"where must be boolean, not {mask.dtype}")
    return mask


def _filled(targets, operands, dtype):
    """Return the output arrays, those to be made with NaN for what is not computed."""
    shape = np.broadcast_shapes(*map(np.shape, (*operands, *(t for t in targets if t is not None))))
    return tuple(np.full(shape, np.nan, dtype) if target is None else target for target in targets)


class Served:
    """A public function: which of its ufuncs serves, and with what.

    Called with all operands, ``out``, ``where``, ``dtype``, ``casting``, by position; `ufunc` gives a ufunc by its
    name.
    """

    def __init__(self, name, ufunc=_backend.ufunc):
        row = FUNCTIONS[name]
        self._outputs = row["outputs"]
        self._forces = row["forces"]
        self._ufuncs = {acting: tuple(map(ufunc, names)) for acting, names in row["ufuncs"].items()}

    def _acting(self, operands, foreign):
        """Return the forces that act, and the operands without those that do not: numbers that are exactly 0.

        Beside arrays of other libraries a number with a dtype of its own stays, which may be that of the result.
        """
        count = len(operands) - len(self._forces)
        kept, acting = operands[:count], []
        for name, force in zip(self._forces, operands[count:], strict=True):
            number = type(force) in PYTHON_NUMBERS or (not foreign and np.ndim(force) == 0)
            if not number or force != 0:
                kept.append(force)
                acting.append(name)
        return tuple(acting), kept

    def __call__(self, *given):
        """Evaluate.

        Returns
        -------
        scalar, array or tuple of these
            One for each output; scalars if all operands are, and no output was given. What is not computed because of
            `where` is NaN, or left as it is in `out`; arrays of other libraries follow their own rules.

        Raises
        ------
        TypeError
            For complex, extended-precision, object and other non-real operands, and for casts that `casting` forbids.
        ValueError
            If the operands do not broadcast, `out` does not fit, or `casting` is no casting rule of NumPy.
        OverflowError
            For a Python integer beyond the range of float64.
        """
        *operands, out, where, dtype, casting = given
        operands = [as_operand(value) for value in operands]
        if casting not in _CASTINGS:
            raise ValueError(f"casting must be one of {', '.join(map(repr, _CASTINGS))}, not {casting!r}")
        targets = _targets(out, self._outputs)
        foreign = any(map(is_foreign, (*operands, *targets)))
        served = None if foreign else common_dtype(operands)
        wanted = asked_dtype(dtype) or served
        acting, kept = self._acting(operands, foreign)
        options = {} if wanted is None else {"dtype": wanted}
        if casting != "same_kind":  # other libraries do not take the word
            options["casting"] = casting
        ufunc, *parts = self._ufuncs[acting]
        if where is not True:
            options["where"] = _mask(where)
        if foreign:
            return self._of_parts(parts or [ufunc], kept, targets, options)
        if where is True:
            return ufunc(*kept, out=targets, **options)
        results = ufunc(*kept, out=_filled(targets, [*kept, options["where"]], wanted), **options)
        made = results if isinstance(results, tuple) else (results,)
        made = tuple(one[()] if target is None else one for one, target in zip(made, targets, strict=True))
        return made if self._outputs > 1 else made[0]

    def _of_parts(self, parts, operands, targets, options):
        """One output at a time: other libraries take no ufunc of several."""
        results = tuple(
            part(*operands, **({} if target is None else {"out": target}), **options)
            for part, target in zip(parts, targets, strict=True)
        )
        return results if self._outputs > 1 else results[0]


def public(name):
    """Return what serves a public function: called with all operands, out, where, dtype and casting, by position."""
    served = Served(name)
    return served if _backend.EXTENSION is None else _backend.EXTENSION.entry(name, served)
