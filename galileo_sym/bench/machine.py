"""What a measurement depends on besides the code: day, machine, versions."""

import datetime
import os
import platform
import subprocess
from importlib.metadata import PackageNotFoundError, version

from galileo_sym import processor
from galileo_sym._config import configuration
from galileo_sym.libraries import NoCompilerError, find_compiler

_PACKAGES = ("numpy", "scipy", "sympy", "python-flint", "dask")


def compiler():
    """The first line of what the C compiler says of itself; "none" without one."""
    try:
        command = find_compiler()
    except NoCompilerError:
        return "none"
    told = subprocess.run([*command, "--version"], capture_output=True, text=True, check=False).stdout
    return told.splitlines()[0] if told else command[0]


def _version(package):
    try:
        return version(package)
    except PackageNotFoundError:
        return None


def stamp():
    """Day, machine and versions, as a dict that JSON can hold."""
    found = {name: _version(name) for name in _PACKAGES}
    return {
        "date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
        "machine": f"{processor.name()}, {os.cpu_count()} processors",
        "load": round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None,
        "python": platform.python_version(),
        "compiler": compiler(),
        "vectors": configuration()["vectors"],
        **{name: text for name, text in found.items() if text},
    }
