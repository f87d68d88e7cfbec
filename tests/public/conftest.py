"""Public functions of both back ends: a test that uses `back_end` runs with each of them. The extension's ufuncs."""

from types import ModuleType

import pytest
from both_back_ends import public_modules


@pytest.fixture(params=["c", "numpy"])
def back_end(request, monkeypatch):
    """The name of a back end; public modules and functions that the test's module imported are those of it."""
    modules = public_modules(request.param)
    for name, value in list(vars(request.module).items()):
        owner = value.__name__ if isinstance(value, ModuleType) else getattr(value, "__module__", None) or ""
        package, _, public = owner.rpartition(".")
        if package == "galileo_sym" and public in modules:
            module = modules[public]
            monkeypatch.setattr(
                request.module, name, module if isinstance(value, ModuleType) else getattr(module, value.__name__)
            )
    return request.param


@pytest.fixture(scope="module")
def lib():
    """The compiled module."""
    public_modules("c")
    from galileo_sym.generated import _ufuncs  # noqa: PLC0415 (not there without a compiler)

    return _ufuncs


@pytest.fixture
def drag(lib):
    """A ufunc of four inputs and one output."""
    return lambda theta, t=1.5, **options: lib.chord_distance_drag(t, theta, 9.81, 0.5, **options)
