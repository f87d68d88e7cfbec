"""Floating-point exceptions of the C functions: none that is not due, and the header for C and C++."""

import shutil
import subprocess

import compiled
import pytest

# Expression, result class, exceptions other than FE_INEXACT.
CASES = [
    ("gs_chord_descent_time(0.3, 1.0, 9.81, 0.2, 0.5)", "isfinite", "0"),
    ("gs_chord_descent_time(1.4, 1.0, 9.81, 0.5, 0.5)", "isinf", "0"),
    ("gs_chord_descent_time(1.1071487177940904, 1.0, 9.81, 0.5, 1.0)", "isfinite", "0"),
    ("gs_chord_descent_time(1e-300, 1.0, 9.81, 0.9999999e300, 1.0)", "isfinite", "0"),
    ("gs_chord_descent_time(1e-308, 1e-300, 1e300, 1e308, 1e-300)", "isfinite", "0"),
    ("gs_chord_descent_time(0.3, INFINITY, 9.81, 0.2, 0.5)", "isinf", "0"),
    ("gs_chord_descent_time(0.3, INFINITY, INFINITY, 0.2, 0.5)", "isnan", "FE_INVALID"),
    ("gs_chord_descent_time(0.3, 1.0, INFINITY, 0.2, 0.5)", "is_zero", "0"),
    ("gs_chord_descent_time(NAN, -1.0, 9.81, 0.2, 0.5)", "isnan", "0"),
    ("gs_chord_descent_time(0.3, -1.0, 9.81, 0.2, 0.5)", "isnan", "FE_INVALID"),
    ("gs_chord_descent_time(2.0, 1.0, 9.81, 0.2, 0.5)", "isnan", "FE_INVALID"),
    ("gs_chord_distance(1e250, 0.3, 1e-300, 0.2, 1e250)", "isfinite", "0"),
    ("gs_chord_distance(1e-200, 0.3, 1e-200, 0.2, 1.0)", "is_zero", "FE_UNDERFLOW"),
    ("gs_chord_distance(1e200, 0.3, 1.0, 0.2, 0.0)", "isinf", "FE_OVERFLOW"),
    ("gs_chord_distance(1e200, 1.5, 1.0, 0.2, 0.0)", "is_zero", "0"),
    ("gs_chord_distance(INFINITY, 0.3, 1.0, 0.2, INFINITY)", "isnan", "FE_INVALID"),
    ("gs_projectile_flight_time(0.5, 10.0, 9.81, 1e-300)", "isfinite", "0"),
    ("gs_projectile_flight_time(1e-310, 10.0, 9.81, 1.0)", "isfinite", "FE_UNDERFLOW"),
    ("gs_projectile_horizontal_range(0.5, 1e200, 9.81, 1e200)", "isfinite", "0"),
    ("gs_projectile_horizontal_range(-0.1, 1.0, 9.81, 1.0)", "isnan", "FE_INVALID"),
    ("gs_projectile_best_angle(0.0)", "isfinite", "0"),
    ("gs_projectile_best_angle(1e-320)", "isfinite", "0"),
    ("gs_projectile_best_angle(1e300)", "isfinite", "0"),
    ("gs_projectile_best_angle(INFINITY)", "is_zero", "0"),
    ("gs_projectile_best_angle(-1.0)", "isnan", "FE_INVALID"),
    ("gs_lambert_w0(-0x1.78b56362cef37p-2)", "isfinite", "0"),
    ("gs_lambert_w0(-0x1.78b56362cef38p-2)", "isnan", "FE_INVALID"),
    ("gs_lambert_w0(5e-324)", "isfinite", "0"),
    ("gs_lambert_w0(-1e-300)", "isfinite", "0"),
    ("gs_lambert_w0(DBL_MAX)", "isfinite", "0"),
    ("gs_lambert_w0(INFINITY)", "isinf", "0"),
    ("gs_lambert_w0(NAN)", "isnan", "0"),
    ("gs_lambert_wm1(-0x1.78b56362cef37p-2)", "isfinite", "0"),
    ("gs_lambert_wm1(-0x1.78b56362cef38p-2)", "isnan", "FE_INVALID"),
    ("gs_lambert_wm1(-5e-324)", "isfinite", "0"),
    ("gs_lambert_wm1(0.0)", "isinf", "FE_DIVBYZERO"),
    ("gs_lambert_wm1(1.0)", "isnan", "FE_INVALID"),
    ("gs_lambert_wm1(NAN)", "isnan", "0"),
    *(
        (f"root({branch}, {equation})", kind, flags)
        for equation, kinds, flags in (
            ("1.0, 2.0, -1.0, 1.0", ("isfinite", "isfinite"), "0"),
            ("1.0, 2.0, 1.0, 1.0", ("isfinite", "isnan"), "0"),
            ("1.0, 1.0, -1.0, 1.0", ("is_zero", "is_zero"), "0"),
            ("1.0, 1.0 + DBL_EPSILON, -1.0 - DBL_EPSILON, 1.0", ("isfinite", "is_zero"), "0"),
            ("1.0, 1.0, -1.0 - DBL_EPSILON, 1.0", ("isnan", "isnan"), "0"),
            ("1.0, 1e300, -3.0, 1.0", ("isfinite", "isfinite"), "0"),
            ("1.0, -1e300, 3.0, 1.0", ("isfinite", "isnan"), "0"),
            ("1e250, 1.0, -1e-300, 1e250", ("isfinite", "isfinite"), "0"),
            ("1.0, 1e-300, -3e-300, 1.0", ("isfinite", "isfinite"), "0"),
            ("INFINITY, 1.0, -2.0, 1.0", ("is_zero", "isinf"), "0"),
            ("1.0, 2.0, -3.0, INFINITY", ("isfinite", "is_zero"), "0"),
            ("1.0, 1.0, -2.0, INFINITY", ("isfinite", "is_zero"), "0"),
            ("-0x1p-130, -0x1p960, 0x1p920, 0x1p-140", ("isinf", "isfinite"), "FE_OVERFLOW"),
            ("INFINITY, INFINITY, -2.0, 1.0", ("isnan", "isnan"), "FE_INVALID"),
            ("0.0, 1.0, 0.0, 1.0", ("isnan", "isnan"), "FE_INVALID"),
            ("0.0, 1.0, 1.0, 1.0", ("isnan", "isnan"), "0"),
            ("NAN, INFINITY, INFINITY, 1.0", ("isnan", "isnan"), "0"),
            ("1e308, 1.0, 1.0, 1e-308", ("isfinite", "isnan"), "FE_UNDERFLOW"),
        )
        for branch, kind in enumerate(kinds)
    ),
]

# The low angle; the call's high one goes to a variable.
ANGLES = [
    ("8.0, 10.0, 9.81, 0.1", "isfinite", "0"),
    ("0.0, 10.0, 9.81, 0.1", "is_zero", "0"),
    ("1e-300, 10.0, 9.81, 1e-310", "isfinite", "0"),
    ("1.0, 1e250, 1e-250, 1e-100", "is_zero", "FE_UNDERFLOW"),  # the largest range overflows
    ("1e-320, 1e-160, 1.0, 1.0", "isfinite", "0"),
    ("1e-30, 1e-200, 1.0, 1.0", "isnan", "FE_INVALID"),  # the largest range underflows
    ("1.0, INFINITY, 9.81, 0.1", "is_zero", "0"),
    ("1.0, INFINITY, INFINITY, 0.1", "isnan", "FE_INVALID"),
    ("1e9, 10.0, 9.81, 0.1", "isnan", "FE_INVALID"),
    ("INFINITY, 1e250, 1e-250, 0.0", "isnan", "FE_INVALID"),
    ("NAN, 10.0, -1.0, 0.1", "isnan", "0"),
]
CASES += [(f"(gs_projectile_launch_angles({a}, &low, &high), low)", kind, flags) for a, kind, flags in ANGLES]

DRIVER = """#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include "galileo.h"
#define is_zero(x) ((x) == 0.0)
static int failures;
static double root(int branch, double a, double b, double c, double d)
{{
    double t[2];
    gs_lambert_linear_exponential_roots(a, b, c, d, t, t + 1);
    return t[branch];
}}
static double low, high;
#define CASE(expression, kind, flags) do {{ \\
    feclearexcept(FE_ALL_EXCEPT); \\
    volatile double value = expression; \\
    const int raised = fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW); \\
    const double x = value; \\
    if (!(kind(x)) || raised != (flags)) {{ \\
        printf("%s: %a, exceptions %d instead of %d\\n", #expression, x, raised, (int)(flags)); \\
        failures++; \\
    }} }} while (0)
int main(void)
{{
{cases}
    return failures != 0;
}}
"""


def test_exceptions(tmp_path):
    compiler = compiled.first_compiler()
    cases = "\n".join(f"    CASE({expression}, {kind}, {flags});" for expression, kind, flags in CASES)
    driver = tmp_path / "flags.c"
    driver.write_text(DRIVER.format(cases=cases))
    program = tmp_path / "flags"
    command = [compiler, "-std=c99", "-O2", "-ffp-contract=off", "-I", str(compiled.SOURCES), str(driver)]
    subprocess.run([*command, str(compiled.place(compiler)), "-o", str(program), "-lm"], check=True)
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("compiler", compiled.compilers() or [None])
def test_compiles_clean_with_every_compiler_there_is(compiler):
    assert compiled.library(compiler).gs_chord_descent_time_n


def test_header_is_usable_from_cpp(tmp_path):
    compiler = shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        pytest.skip("no C++ compiler on PATH: the header is not tested with C++")
    user = tmp_path / "user.cpp"
    user.write_text('#include "galileo.h"\ndouble f() { return gs_projectile_best_angle(1.0); }\n')
    flags = ["-std=c++98", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only"]
    subprocess.run([compiler, *flags, "-I", str(compiled.SOURCES), str(user)], check=True)


def test_sources_need_no_heap_and_no_errno():
    text = "\n".join(path.read_text() for path in sorted(compiled.SOURCES.rglob("*.[ch]")))
    for word in ("malloc", "calloc", "errno.h", "stdlib.h", "static double "):
        assert word not in text
