"""Ufuncs of the NumPy back end: what callers and arrays of other libraries ask of a ufunc, over emitted kernels."""

from functools import cache
from importlib import import_module

import numpy as np

from galileo_sym._types import DOUBLE, PYTHON_NUMBERS, SINGLE, as_operand, asked_dtype, common_dtype, is_foreign
from galileo_sym.generated._chunks import CHUNK
from galileo_sym.generated._functions import FUNCTIONS, SPECIAL
from galileo_sym.generated._lines import to_odd
from galileo_sym.generated._tables import HALF_PI


def _widen(array, is_angle):
    """An argument as float64; the float32 next to pi/2, which lies above it, counts as pi/2."""
    wide = array.astype(DOUBLE, copy=False)
    if array.dtype == SINGLE and is_angle:
        return np.where(np.abs(array) == np.float32(HALF_PI[0]), np.copysign(HALF_PI[0], wide), wide)
    return wide


def _as_tuple(results):
    return results if isinstance(results, tuple) else (results,)


class StandIn:
    """A ufunc made of an emitted kernel; its attributes are those of NumPy's, of whose methods it has the call alone.

    Parameters
    ----------
    name, doc : str
    row : dict
        The function's row of ``FUNCTIONS`` in its generated module: ``outputs``, ``angle`` (an index), ``kernels``;
        ``ceiling``, if an argument has a largest value: its index and the kernels of that value; ``rest``, if the
        kernels return the only output with its rest, so that float32 results are rounded once.
    acting : tuple of str
        The forces that act: a key of ``row["kernels"]``.
    inputs : int
        Number of operands.
    output : int, optional
        Which output is given; all by default.
    """

    signature = identity = None

    def __init__(self, name, doc, row, acting, inputs, output=None):
        self.__name__ = self.__qualname__ = name
        self.__doc__ = doc
        self._row, self._acting, self._output = row, acting, output
        self.nin, self.nout = inputs, row["outputs"] if output is None else 1
        self.nargs = self.nin + self.nout
        self.types = [f"{letter * self.nin}->{letter * self.nout}" for letter in "fd"]
        self.ntypes = len(self.types)

    def __repr__(self):
        return f"<ufunc {self.__name__!r} of the NumPy back end>"

    def __reduce__(self):
        return stand_in, (self.__name__,)

    def __call__(self, *inputs, out=None, where=True, dtype=None, casting="same_kind", order="K", subok=True):
        """Evaluate, as a ufunc is called."""
        if len(inputs) != self.nin:
            raise TypeError(f"{self.__name__}() takes {self.nin} operands, {len(inputs)} given")
        targets = (None,) * self.nout if out is None else _as_tuple(out)
        options = {"where": where, "dtype": dtype, "casting": casting, "order": order, "subok": subok}
        if any(map(is_foreign, (*inputs, *targets))):
            return self._handed_over(inputs, targets, options)
        operands = [as_operand(value) for value in inputs]
        served = common_dtype(operands)
        wanted = asked_dtype(dtype) or served
        arrays = [np.asanyarray(x, dtype=wanted if type(x) in PYTHON_NUMBERS else None) for x in operands]
        self._check_casts(operands, arrays, targets, wanted, casting)
        results = self._evaluate(arrays, targets, where, wanted, order, casting)
        return self._wrapped(operands, targets, results, subok)

    def _handed_over(self, inputs, targets, options):
        """What the operands' own ``__array_ufunc__`` make of the call, subclasses first, then from left to right."""
        defaults = {"where": True, "dtype": None, "casting": "same_kind", "order": "K", "subok": True}
        passed = {name: value for name, value in options.items() if value is not defaults[name]}
        if any(target is not None for target in targets):
            passed["out"] = targets
        asked = []
        for one in filter(is_foreign, (*inputs, *targets)):
            if type(one) not in map(type, asked):
                place = next((i for i, other in enumerate(asked) if issubclass(type(one), type(other))), len(asked))
                asked.insert(place, one)
        for one in asked:
            if type(one).__array_ufunc__ is None:
                raise TypeError(f"operand {type(one).__name__!r} does not support ufuncs (__array_ufunc__=None)")
            result = one.__array_ufunc__(self, "__call__", *inputs, **passed)
            if result is not NotImplemented:
                return result
        told = ", ".join(type(one).__name__ for one in asked)
        raise TypeError(f"operand type(s) all returned NotImplemented from __array_ufunc__({self!r}): {told}")

    def _check_casts(self, operands, arrays, targets, dtype, casting):
        for place, (operand, array) in enumerate(zip(operands, arrays, strict=True)):
            if type(operand) not in PYTHON_NUMBERS and not np.can_cast(array.dtype, dtype, casting):
                self._refuse_cast(f"input {place}", array.dtype, dtype, casting)
        for target in targets:
            if target is not None and not np.can_cast(dtype, target.dtype, casting):
                self._refuse_cast("output", dtype, target.dtype, casting)

    def _refuse_cast(self, which, given, wanted, casting):
        raise TypeError(
            f"Cannot cast ufunc {self.__name__!r} {which} from {given!r} to {wanted!r} with casting rule {casting!r}"
        )

    def _evaluate(self, arrays, targets, where, dtype, order, casting):
        """Run over all elements, a chunk at a time."""
        masked = where is not True
        operands = [*arrays, *targets, *([np.asarray(where)] if masked else [])]
        written = ["writeonly", "allocate", "no_broadcast", "no_subtype", *(["writemasked"] if masked else [])]
        flags = [["readonly"]] * self.nin + [written] * self.nout
        dtypes = [dtype] * self.nargs
        if masked:
            flags, dtypes = [*flags, ["readonly", "arraymask"]], [*dtypes, np.dtype(bool)]
        iterator = np.nditer(
            operands,
            ["external_loop", "buffered", "zerosize_ok", "copy_if_overlap", "grow_inner"],
            flags,
            dtypes,
            order=order,
            casting=casting,
            buffersize=CHUNK,
        )
        with iterator:
            for chunk in iterator:
                chosen = chunk[self.nargs] if masked else slice(None)
                self._fill(chunk[: self.nin], chunk[self.nin : self.nargs], chosen)
            return iterator.operands[self.nin : self.nargs]

    def _fill(self, arrays, targets, chosen):
        """Evaluate one chunk; what does not vary in it is passed as one number."""
        if not isinstance(chosen, slice) and not chosen.any():
            return
        few = [array[:1] if array.strides == (0,) else array[chosen] for array in arrays]
        for target, result in zip(targets, self._results(few), strict=True):
            target[chosen] = result

    def _results(self, arrays):
        row = self._row
        wide = [_widen(array, i == row["angle"]) for i, array in enumerate(arrays)]
        if arrays[0].dtype == SINGLE and "ceiling" in row:
            self._widen_to_most(arrays, wide)
        results = _as_tuple(row["kernels"][self._acting](*wide))
        if row.get("rest"):
            return (results[0] if arrays[0].dtype == DOUBLE else to_odd(*results),)
        return results if self._output is None else (results[self._output],)

    def _widen_to_most(self, arrays, wide):
        """The float32 next to the largest value of an argument counts as that."""
        index, kernels = self._row["ceiling"]
        with np.errstate(all="ignore"):
            most = kernels[self._acting](*wide[:index], *wide[index + 1 :])
            wide[index] = np.where(arrays[index] == most.astype(SINGLE), most, wide[index])

    def _wrapped(self, operands, targets, results, subok):
        """What is returned: given arrays themselves, scalars for arrays of no dimension, what operands make of it."""
        wrappers = [x for x in operands if subok and hasattr(x, "__array_wrap__") and not isinstance(x, np.generic)]
        wrapper = max(wrappers, key=lambda x: getattr(x, "__array_priority__", 0.0), default=None)
        given = []
        for place, (target, result) in enumerate(zip(targets, results, strict=True)):
            if target is not None:
                given.append(target)
            elif wrapper is None or type(wrapper) is np.ndarray:
                given.append(result[()])
            else:
                given.append(wrapper.__array_wrap__(result, (self, tuple(operands), place), result.ndim == 0))
        return tuple(given) if self.nout > 1 else given[0]


@cache
def _known():
    """Arguments of the stand-ins of the papers, by name."""
    found = {}
    for full_name, row in FUNCTIONS.items():
        paper, name = full_name.split(".")
        for acting, names in row["ufuncs"].items():
            inputs = len(row["operands"]) - len(row["forces"]) + len(acting)
            for place, one in enumerate(names):
                found[one] = paper, name, acting, inputs, place - 1 if place else None
    return found


@cache
def stand_in(name):
    """Return the stand-in for the ufunc of a name, always the same one."""
    if name in SPECIAL:
        return StandIn(name, SPECIAL[name], _row("special", name), (), 1)
    paper, function, acting, inputs, output = _known()[name]
    return StandIn(name, f"{paper}.{function}", _row(paper, function), acting, inputs, output)


def _row(module, name):
    return import_module(f"galileo_sym.generated.{module}").FUNCTIONS[name]
