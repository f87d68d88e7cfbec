"""What a contestant is, and those of this package: the emitted code by each back end, and the certain references."""

import ctypes
from functools import cache, partial
from importlib import import_module

import numpy as np

from galileo_sym import _backend
from galileo_sym._stand_in import stand_in
from galileo_sym.generated._functions import FUNCTIONS
from galileo_sym.libraries import NoCompilerError, find_compiler, kept_library
from galileo_sym.verify.back_ends import generated_folder
from galileo_sym.verify.enclosure import nearest_float


class Contestant:
    """Something that evaluates cases.

    Attributes
    ----------
    name : str
        In tables and in JSON.
    single : bool
        Whether it computes in binary32.
    most : int or None
        Elements it is timed on at most, because it is slow.
    """

    name = ""
    single = False
    most = None

    def serves(self, case):
        """Whether it has the function of a case."""
        raise NotImplementedError

    def takes_numbers(self, case):
        """Whether the arguments after the positional ones may be numbers."""
        return True

    def prepare(self, case, arguments):
        """A call without arguments that evaluates a case, all else done before.

        Parameters
        ----------
        case : Case
        arguments : dict of str to (ndarray or float)
            Of float64, by name; arrays of one length.

        Returns
        -------
        callable
        """
        raise NotImplementedError

    def results(self, case, arguments):
        """Results as a tuple of arrays, one for each output; arguments as for `prepare`, arrays only."""
        with np.errstate(all="ignore"):
            found = self.prepare(case, arguments)()
        return found if isinstance(found, tuple) else (found,)


def _narrow(arguments, single):
    dtype = np.float32 if single else np.float64
    with np.errstate(all="ignore"):
        return {
            name: np.ascontiguousarray(x, dtype=dtype) if isinstance(x, np.ndarray) else float(x)
            for name, x in arguments.items()
        }


def _shape(arguments):
    return next((x.shape for x in arguments.values() if isinstance(x, np.ndarray)), ())


class _Ours(Contestant):
    """A back end with the public signature, into arrays made before."""

    def __init__(self, single=False):
        self.single = single
        self.name = f"{self.back_end}, float32" if single else self.back_end

    def serves(self, case):
        return True

    def prepare(self, case, arguments):
        given = _narrow(arguments, self.single)
        dtype = np.float32 if self.single else np.float64
        out = tuple(np.empty(_shape(given), dtype) for _ in case.outputs)
        return self._bound(case, given, out if len(out) > 1 else out[0])


def public_call(case, given, **options):
    """The public function of a case with its arguments, to be called without any."""
    function = getattr(import_module(f"galileo_sym.{case.paper}"), case.name)
    by_name = {name: given[name] for name in (*case.keywords, *case.forces)}
    return partial(function, *(given[name] for name in case.positional), **by_name, **options)


class PublicFunctions(_Ours):
    """The public functions as they are imported."""

    back_end = "C"
    way = "the compiled extension"

    def _bound(self, case, given, out):
        return public_call(case, given, out=out)


class NumpyKernels(_Ours):
    """The emitted NumPy code behind the public functions, whichever back end these have."""

    back_end = "NumPy"
    way = "NumPy"

    def _bound(self, case, given, out):
        name = case.name if case.paper == "special" else FUNCTIONS[case.full_name]["ufuncs"][tuple(case.forces)][0]
        return partial(stand_in(name), *(given[argument] for argument in case.arguments), out=out)


@cache
def _library():
    return ctypes.CDLL(str(kept_library(sorted((generated_folder() / "c").glob("*.c")), find_compiler())))


class ArrayFunctions(_Ours):
    """The array functions of the emitted C, called without the extension; compiled now if there is a compiler."""

    back_end = "C"
    way = "its array functions, by ctypes"

    def __init__(self, single=False):
        super().__init__(single)
        self._functions = _library()

    def takes_numbers(self, case):
        return hasattr(self._functions, self._symbol(case, "nu"))

    def _symbol(self, case, form):
        suffix = f"_{case.force_set}" if case.force_set else ""
        return f"gs_{case.paper}_{case.name}{suffix}_{form}{'f' * self.single}"

    def _bound(self, case, given, out):
        values = [given[name] for name in case.arguments]
        numbers = any(not isinstance(x, np.ndarray) for x in values)
        routine = self._functions[self._symbol(case, "nu" if numbers else "n")]
        routine.restype = None
        number = ctypes.c_float if self.single else ctypes.c_double
        arrays = [*values, *(out if isinstance(out, tuple) else (out,))]
        words = [ctypes.c_void_p(x.ctypes.data) if isinstance(x, np.ndarray) else number(x) for x in arrays]
        call = partial(routine, ctypes.c_size_t(arrays[-1].size), *words)

        def run():
            call()
            return out

        run.kept = arrays  # the library holds their addresses only
        return run


class References(Contestant):
    """The certain references that errors are measured against: ball arithmetic, for special functions mpmath."""

    name = "verify's references"
    most = 32

    def takes_numbers(self, case):
        return False

    def serves(self, case):
        return True

    def prepare(self, case, arguments):
        rows = list(zip(*(arguments[name].tolist() for name in case.arguments), strict=True))
        points = [dict(zip(case.arguments, row, strict=True)) for row in rows]

        def run():
            found = [[nearest_float(one) for one in case.exact(point)] for point in points]
            return tuple(np.array(found).T)

        return run


def _compiled(tell):
    """The class that calls the emitted C on this machine, or None."""
    if _backend.NAME == "c":
        return PublicFunctions
    try:
        _library()
    except NoCompilerError as cause:
        tell(f"C: {cause}")
        return None
    return ArrayFunctions


def ours(tell):
    """The contestants of this package.

    Parameters
    ----------
    tell : callable
        Called with a sentence for each that cannot take part.

    Returns
    -------
    list of Contestant

    Raises
    ------
    CompilationError
        If there is a compiler and the emitted C does not compile or load.
    """
    found = [NumpyKernels(), NumpyKernels(single=True), References()]
    compiled = _compiled(tell)
    return [compiled(), compiled(single=True), *found] if compiled else found
