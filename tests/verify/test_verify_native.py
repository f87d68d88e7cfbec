"""The compiled back end: finding a compiler, compiling with warnings as errors, calling array functions."""

import os

import numpy as np
import pytest

from galileo_sym.libraries import CompilationError, NoCompilerError, find_compiler
from galileo_sym.verify import back_ends
from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.native import NativeLibrary, c_symbol
from galileo_sym.verify.run import run

CIRCLE = """
#include <stddef.h>
void gs_chord_synchronous_circle_friction_n(size_t n, const double *t, const double *g, const double *mu,
                                            double *X, double *Y, double *R);
void gs_chord_synchronous_circle_friction_n(size_t n, const double *t, const double *g, const double *mu,
                                            double *X, double *Y, double *R)
{
    for (size_t i = 0; i < n; i++) {
        X[i] = t[i];
        Y[i] = g[i];
        R[i] = mu[i] + 1.0;
    }
}
"""

try:
    COMPILER, REASON = find_compiler(), ""
except NoCompilerError as cause:
    COMPILER, REASON = None, f"no C compiler: {cause}"
needs_compiler = pytest.mark.skipif(COMPILER is None, reason=REASON)


@pytest.mark.parametrize(
    ("name", "force_set", "symbol"),
    [
        ("chord.descent_time", "free", "gs_chord_descent_time_free_n"),
        ("chord.position", "friction_drag", "gs_chord_position_friction_drag_n"),
        ("projectile.flight_time", "drag", "gs_projectile_flight_time_drag_n"),
        ("projectile.best_angle", "all", "gs_projectile_best_angle_n"),
    ],
)
def test_symbols(name, force_set, symbol):
    assert c_symbol(FUNCTIONS[name], force_set) == symbol


def test_no_compiler_says_where_it_looked(tmp_path):
    with pytest.raises(NoCompilerError, match="none of cc, gcc, clang is on PATH"):
        find_compiler({"PATH": str(tmp_path)})
    with pytest.raises(NoCompilerError, match="CC names 'kcc'"):
        find_compiler({"PATH": str(tmp_path), "CC": "kcc -m64"})


def test_cc_goes_before_the_others(tmp_path):
    for name in ("mycc", "cc", "gcc"):
        (tmp_path / name).write_text("#!/bin/sh\n")
        (tmp_path / name).chmod(0o755)
    assert find_compiler({"PATH": str(tmp_path), "CC": "mycc -m64"}) == ["mycc", "-m64"]
    assert find_compiler({"PATH": str(tmp_path)}) == ["cc"]
    (tmp_path / "cc").unlink()
    assert find_compiler({"PATH": str(tmp_path)}) == ["gcc"]


@needs_compiler
def test_array_functions_take_arguments_in_order(tmp_path):
    (tmp_path / "chord.c").write_text(CIRCLE)
    library = NativeLibrary(tmp_path)
    arguments = {"t": np.array([1.0, 2.0]), "g": np.array([3.0, 4.0]), "mu": np.array([5.0, 6.0])}
    results = library.evaluate(FUNCTIONS["chord.synchronous_circle"], "friction", arguments)
    assert [array.tolist() for array in results] == [[1.0, 2.0], [3.0, 4.0], [6.0, 7.0]]
    with pytest.raises(CompilationError, match="no function gs_chord_synchronous_circle_drag_n"):
        library.evaluate(FUNCTIONS["chord.synchronous_circle"], "drag", {**arguments, "gamma": arguments["mu"]})


@needs_compiler
@pytest.mark.parametrize("flaw", ["int unused(void) { int x; return 0; }", "this is not C"])
def test_warnings_and_errors_are_failures(tmp_path, flaw):
    (tmp_path / "chord.c").write_text(flaw)
    with pytest.raises(CompilationError, match="exits with"):
        NativeLibrary(tmp_path)


@needs_compiler
def test_a_library_that_does_not_load_is_a_failure(tmp_path):
    (tmp_path / "chord.c").write_text(
        "extern const double gs_lost_table[];\ndouble f(void);\ndouble f(void)\n{\n    return gs_lost_table[0];\n}\n"
    )
    with pytest.raises(CompilationError, match=r"gs_lost_table.*run `galileo-sym emit`"):
        NativeLibrary(tmp_path)


def test_no_sources(tmp_path):
    with pytest.raises(CompilationError, match="no C sources"):
        NativeLibrary(tmp_path, compiler=["cc"])


def test_without_a_compiler_numpy_alone_is_verified_and_the_report_says_so(monkeypatch, tmp_path, capsys):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False)
    said = []
    assert [one.name for one in back_ends.available_back_ends(said.append)] == ["numpy"]
    assert "No C compiler" in said[0]
    assert run(["projectile.best_angle"], points=2, strata=["typical"], processes=1) == 0
    assert "Only the NumPy back end is verified" in capsys.readouterr().out


def test_c_that_does_not_compile_fails_the_run(monkeypatch, tmp_path, capsys):
    (tmp_path / "cc").write_text("#!/bin/sh\necho 'chord.c:1: error: broken' >&2\nexit 3\n")
    (tmp_path / "cc").chmod(0o755)
    (tmp_path / "c").mkdir()
    (tmp_path / "c" / "chord.c").write_text("broken")
    monkeypatch.setenv("CC", "cc")
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    certificates = back_ends.generated_folder() / "certificates"
    monkeypatch.setattr(back_ends, "generated_folder", lambda: tmp_path)
    code = run(["projectile.best_angle"], points=2, strata=["typical"], processes=1, certificates=certificates)
    text = capsys.readouterr().out
    assert code == 1
    assert "chord.c:1: error: broken" in text
    assert "1 strata, 2 points: 0 failed, 1 problems" in text
