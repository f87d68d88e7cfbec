"""The public modules of each back end, loaded beside each other."""

import importlib
import sys
from functools import cache

import pytest

from galileo_sym.libraries import NoCompilerError, find_compiler

PUBLIC = ("chord", "projectile", "lambert", "special")
OF_A_BACK_END = ("_backend", "_front", *PUBLIC)


@cache
def public_modules(back_end):
    """The public modules as an installation has them that chooses a back end, by name."""
    if back_end == "c":
        require_extension()
    names = [f"galileo_sym.{name}" for name in OF_A_BACK_END]
    package = importlib.import_module("galileo_sym")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("GALILEO_SYM_BACKEND", back_end)
        for name in names:
            patch.delitem(sys.modules, name, raising=False)
            patch.delattr(package, name.rpartition(".")[2], raising=False)
        found = {name: importlib.import_module(f"galileo_sym.{name}") for name in PUBLIC}
        for name in names:  # so that undoing the patch brings the former ones back, where there were any
            del sys.modules[name]
    return found


def require_extension():
    """Skip a test of the extension where it cannot be: without a compiler."""
    try:
        find_compiler()
    except NoCompilerError as cause:
        pytest.skip(f"the C back end is not tested: {cause}")
