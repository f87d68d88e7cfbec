"""A plugin of pytest: the extension that $GALILEO_SYM_EXTENSION names takes the place of the installed one."""

import importlib.util
import os
import sys

_NAME = "galileo_sym.generated._ufuncs"
_SPEC = importlib.util.spec_from_file_location(_NAME, os.environ["GALILEO_SYM_EXTENSION"])
sys.modules[_NAME] = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(sys.modules[_NAME])


def pytest_report_header():
    """Say which one."""
    return f"extension: {sys.modules[_NAME].__file__}"
