"""Which back end serves: chosen by the environment, said by show_config, built of the C that is here; its cost."""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
from both_back_ends import require_extension

import galileo_sym
import galileo_sym.generated

PUBLIC = ("galileo_sym", "galileo_sym.chord", "galileo_sym.projectile", "galileo_sym.lambert", "galileo_sym.special")
NOT_LOADED = {"sympy", "mpmath", "scipy"}


def run(code, back_end=None, *options, folder=None, **variables):
    """Run a script in an interpreter of its own, with a back end asked for or none."""
    environment = {name: value for name, value in os.environ.items() if name != "GALILEO_SYM_BACKEND"} | variables
    environment |= {} if back_end is None else {"GALILEO_SYM_BACKEND": back_end}
    command = [sys.executable, *options, "-c", code]
    return subprocess.run(command, capture_output=True, text=True, check=False, env=environment, cwd=folder)


@pytest.mark.parametrize("back_end", [None, "numpy"])
def test_import_loads_numpy_alone(back_end):
    done = run(f"import sys, {', '.join(PUBLIC)}; print(*sorted(m for m in sys.modules))", back_end)
    assert done.returncode == 0, done.stderr
    loaded = set(done.stdout.split())
    assert not NOT_LOADED & {name.partition(".")[0] for name in loaded}
    if back_end is None:
        require_extension()
        assert "galileo_sym.generated._ufuncs" in loaded
        assert not {"galileo_sym.generated._tables", "galileo_sym._stand_in"} & loaded


def test_importing_costs_little():
    """Beyond NumPy: processor time, the least of three, as the machine may be busy."""
    require_extension()
    code = (
        "import time, numpy; start = time.process_time(); import galileo_sym.chord, galileo_sym.projectile;"
        "print(time.process_time() - start)"
    )
    assert min(float(run(code).stdout) for _ in range(3)) < 0.02


def test_the_environment_chooses():
    code = "from galileo_sym import _backend; print(_backend.NAME)"
    assert run(code, "numpy").stdout.split() == ["numpy"]
    require_extension()
    assert run(code).stdout.split() == run(code, "").stdout.split() == run(code, "c").stdout.split() == ["c"]


def test_an_unknown_back_end_is_refused():
    done = run("import galileo_sym; import galileo_sym.chord", "fortran")
    assert done.returncode == 1
    assert "GALILEO_SYM_BACKEND=fortran: there is no such back end; set it to numpy or c" in done.stderr


def test_an_installation_without_the_extension(tmp_path):
    """As a build without a compiler leaves it: a copy of the Python sources, seen by an interpreter without `site`."""
    ignored = shutil.ignore_patterns("__pycache__", "c", "extension", "_ufuncs*")
    shutil.copytree(Path(galileo_sym.__file__).parent, tmp_path / "galileo_sym", ignore=ignored)
    shutil.copytree(Path(galileo_sym.generated.__file__).parent, tmp_path / "galileo_sym" / "generated", ignore=ignored)
    paths = os.pathsep.join([str(tmp_path), sysconfig.get_path("purelib"), sysconfig.get_path("platlib")])
    code = "from galileo_sym import chord, show_config as show; show(); print(chord.descent_time(0, diameter=1, g=2))"
    for asked in (None, "numpy"):
        done = run(code, asked, "-S", folder=tmp_path, PYTHONPATH=paths)
        assert done.returncode == 0, done.stderr
        assert done.stdout.splitlines()[-1] == "1.0"
        assert re.search("back end: +numpy", done.stdout)
    done = run(code, "c", "-S", folder=tmp_path, PYTHONPATH=paths)
    assert done.returncode == 1
    last = done.stderr.splitlines()[-1]
    assert "no compiled extension; install a C compiler" in last
    assert "make install" in last


def test_show_config(capsys):
    told = galileo_sym.show_config()
    printed = capsys.readouterr().out
    assert all(f"{name}:" in printed and value in printed for name, value in told.items())
    assert told["back end"] in ("c", "numpy")
    require_extension()
    assert told["vectors"] in ("avx512", "avx2", "plain")


def test_the_extension_is_built_of_the_emitted_c_that_is_here():
    require_extension()
    assert galileo_sym.show_config()["extension"] == "built of the emitted C that is here", "run `make install`"
