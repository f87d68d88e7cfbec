"""The extension, for tests of its ufuncs."""

import pytest
from both_back_ends import public_modules


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
