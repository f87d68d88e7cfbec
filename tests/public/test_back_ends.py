"""Which back end serves: chosen by the environment, said by show_config, built of the C that is here; its cost."""

import os
import subprocess
import sys

import pytest
from both_back_ends import require_extension

import galileo_sym

PUBLIC = ("galileo_sym", "galileo_sym.chord", "galileo_sym.projectile", "galileo_sym.lambert", "galileo_sym.special")
NOT_LOADED = {"sympy", "mpmath", "scipy"}


def run(code, back_end=None):
    environment = {name: value for name, value in os.environ.items() if name != "GALILEO_SYM_BACKEND"}
    environment |= {} if back_end is None else {"GALILEO_SYM_BACKEND": back_end}
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env=environment)


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
    """Beyond NumPy; the least of three, as the machine may be busy."""
    require_extension()
    code = (
        "import time, numpy; start = time.perf_counter(); import galileo_sym.chord, galileo_sym.projectile;"
        "print(time.perf_counter() - start)"
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


def test_the_extension_is_asked_for_but_absent():
    code = (
        "import sys; sys.modules['galileo_sym.generated._ufuncs'] = None\n"
        "from galileo_sym import chord; print(chord.descent_time(0.0, diameter=1.0, g=2.0))"
    )
    assert run(code).stdout.split() == ["1.0"]
    done = run(code, "c")
    assert done.returncode == 1
    assert "no compiled extension; install a C compiler" in done.stderr.splitlines()[-1]
    assert "make install" in done.stderr.splitlines()[-1]


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
