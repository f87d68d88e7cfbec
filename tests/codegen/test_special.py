"""The emitted primitives: the same bits from every version, values against independent references, edges and flags."""

import ctypes
import subprocess

import compiled
import numpy as np
import pytest
from mpmath import mpf
from special_points import ITSELF, LIMITS, ODD_OR_EVEN, points, reference

from galileo_sym.codegen.blocks import loops
from galileo_sym.codegen.kernels import runnable
from galileo_sym.primitives.kernels import KERNELS

SPECIAL = [np.nan, -np.nan, np.inf, 0.0, -0.0, 5e-324, 2.3e-308, np.finfo(float).max, -1.0, -np.inf, -5e-324]


VERSIONS = runnable()


def run(name, x, suffix, dtype=np.float64, loop="_n"):
    """Call one version of an array loop."""
    x = np.ascontiguousarray(x, dtype=dtype)
    value = np.empty_like(x)
    function = getattr(compiled.library(), f"gs_{name}{loop}{'f' * (dtype is np.float32)}_{suffix}")
    function.restype = None
    function(ctypes.c_size_t(x.size), ctypes.c_void_p(x.ctypes.data), ctypes.c_void_p(value.ctypes.data))
    return value


@pytest.mark.parametrize("name", KERNELS)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_every_version_gives_the_same_bits(name, dtype):
    """Whatever the vectors, and whatever the length of the array's end."""
    with np.errstate(all="ignore"):
        x = np.concatenate([points(name, 4000), SPECIAL]).astype(dtype)
    bits = np.int64 if dtype is np.float64 else np.int32
    plain = run(name, x, "plain", dtype)
    for suffix in VERSIONS[1:]:
        assert np.array_equal(plain.view(bits), run(name, x, suffix, dtype).view(bits)), suffix
        for length in range(1, 20):
            assert np.array_equal(plain[:length].view(bits), run(name, x[:length], suffix, dtype).view(bits))


@pytest.mark.parametrize("name", [name for name, loop in loops().items() if loop == "_blocks"])
def test_blocks_give_the_same_bits(name):
    """However numbers of several ranges are mixed, and what is no argument among them; in place, too."""
    with np.errstate(all="ignore"):
        every = np.concatenate([points(name, 4000), SPECIAL])
    plain = run(name, every, "plain").view(np.int64)
    order = np.random.default_rng(5).permutation(every.size)
    for suffix in VERSIONS:
        for begin, length in ((0, every.size), (7, 600), (3, 33), (900, 256), (50, 17), (11, 5)):
            places = order[begin : begin + length]
            value = run(name, every[places], suffix, loop="_blocks").view(np.int64)
            assert np.array_equal(plain[places], value), (suffix, length)
    x = every[order]
    getattr(compiled.library(), f"gs_special_{name}_n")(
        ctypes.c_size_t(x.size), ctypes.c_void_p(x.ctypes.data), ctypes.c_void_p(x.ctypes.data)
    )
    assert np.array_equal(x.view(np.int64), plain[order])


@pytest.mark.parametrize("name", KERNELS)
def test_values(name):
    """Within 0.55 ulp of the closed form."""
    x = points(name, 250)
    for a, value in zip(x, run(name, x, "plain"), strict=True):
        assert abs(mpf(float(value)) - reference(name, a)) <= mpf(float(np.spacing(abs(value)))) * mpf("0.55"), a


@pytest.mark.parametrize("name", KERNELS)
def test_binary32_is_correctly_rounded(name):
    """The nearest float, at every point tried; `make exhaustive` tries all there are."""
    x = points(name, 250, seed=2)
    x = x[(abs(x) > 1e-44) & (abs(x) < 3e38)].astype(np.float32)
    x = x[(x >= np.float64(KERNELS[name].domain[0])) & (x <= np.float64(KERNELS[name].domain[1]))]
    for a, value in zip(x, run(name, x, "plain", np.float32), strict=True):
        exact = reference(name, a)
        neighbours = [np.nextafter(value, np.float32(side)) for side in (-np.inf, np.inf)]
        missed = abs(mpf(float(value)) - exact)
        assert all(missed <= abs(mpf(float(n)) - exact) for n in neighbours), a


@pytest.mark.parametrize("name", KERNELS)
def test_edges(name):
    """Limits at 0 and infinity; NaN for what is no argument."""
    at_zero, at_infinity = LIMITS[name]
    lower, upper = KERNELS[name].domain
    x = np.array([0.0, -0.0, np.inf, *(v for v in SPECIAL if not lower <= v <= upper)])
    zeros = x[:2] if at_zero is ITSELF else np.array([at_zero, at_zero])
    for suffix in VERSIONS:
        value = run(name, x, suffix)
        assert np.array_equal(value[:2].view(np.int64), zeros.view(np.int64))
        assert np.array_equal(value[2], at_infinity, equal_nan=True)
        assert np.isnan(value[3:]).all()
        assert not np.isnan(run(name, [v for v in SPECIAL if lower <= v <= upper], suffix)).any()
        beyond = [np.nextafter(v, side) for v, side in ((lower, -np.inf), (upper, np.inf)) if np.isfinite(v)]
        assert np.isnan(run(name, beyond, suffix)).all()


@pytest.mark.parametrize("name", ODD_OR_EVEN)
def test_symmetry(name):
    """Odd or even to the bit."""
    x = points(name, 1000)
    assert np.array_equal(run(name, -x, "plain"), ODD_OR_EVEN[name] * run(name, x, "plain"))


FLAGS_PROGRAM = """#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include "galileo.h"
@DECLARED@
static int failures;
typedef void (*tried_function)(size_t n, const double *x, double *value);
static void tried(const char *name, tried_function f, double step, double odd, int seen, int wanted)
{
    for (size_t n = 1; n < 40; n += 3)
        for (size_t place = 0; place < n; place++) {
            double x[40], value[40];
            for (size_t j = 0; j < n; j++)
                x[j] = j == place ? odd : step * (double)(j + 1);
            feclearexcept(FE_ALL_EXCEPT);
            f(n, x, value);
            const int raised = fetestexcept(seen);
            if (raised != wanted) {
                printf("%s(%a) at %zu of %zu: exceptions %d instead of %d\\n", name, odd, place, n, raised, wanted);
                failures++;
                return;
            }
        }
}
static const struct {
    const char *name;
    tried_function f;
    double step, odd;
    int seen, wanted;
} all[] = {
@TRIED@};
int main(void)
{
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        tried(all[i].name, all[i].f, all[i].step, all[i].odd, all[i].seen, all[i].wanted);
    return failures != 0;
}
"""
NUMBERS = [0.0, 5e-324, 1e-300, 1e-60, 0.2, 0.3, 0.35, float.fromhex("0x1.78b56362cef37p-2"), 0.5, 3.8, 9.375, 15.0]
NUMBERS += [45.0, 64.0, 100.0, 300.0, 650.0, 712.0, 745.2, 1e80, 1e250, 1e308, np.inf]
ERRORS = "FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW"
# the approximations of the others multiply tiny arguments
UNDERFLOWS = {"exp_minus": lambda x: 708.4 < x < np.inf} | dict.fromkeys(["sin", "cos", "arctan"], lambda x: False)


def _flags_due(name, public):
    """Arguments, the flags looked at, and those due, as C."""
    lower, upper = KERNELS[name].domain
    for x in [*NUMBERS, *(-x for x in NUMBERS), np.nan]:
        tiny_result = 0 < abs(x) < 1e-307 or 1e307 < abs(x) < np.inf  # there it may be due, exact or not
        seen = ERRORS + " | FE_UNDERFLOW" * (name in UNDERFLOWS or (public and not tiny_result))
        due = "FE_UNDERFLOW" if name in UNDERFLOWS and UNDERFLOWS[name](x) else "0"
        due = due if np.isnan(x) or lower <= x <= upper else "FE_INVALID"
        due = "FE_DIVBYZERO" if public and x == KERNELS[name].pole else due
        yield (
            "NAN" if np.isnan(x) else "-INFINITY" if x == -np.inf else "INFINITY" if x == np.inf else x.hex(),
            seen,
            due,
        )


@pytest.mark.parametrize(
    ("compiler", "level"), [*((compiler, "-O2") for compiler in compiled.compilers()), (None, "-O3")]
)
def test_vector_versions_raise_only_what_is_due(compiler, level, tmp_path):
    """Invalid for arguments beyond the domain, nothing for others, in every lane and at every length."""
    compiler = compiler or compiled.first_compiler()  # which builds the extension, or a skip
    declared, tried = "", ""
    for name, kernel in KERNELS.items():
        step = min(0.37, kernel.domain[1] / 41) if kernel.domain[1] > 0 else kernel.domain[0] / 41
        for function in (f"gs_special_{name}_n", *(f"gs_{name}{loops()[name]}_{suffix}" for suffix in VERSIONS)):
            declared += f"void {function}(size_t n, const double *x, double *value);\n"
            for x, seen, due in _flags_due(name, function.startswith("gs_special")):
                tried += f'    {{"{function}", {function}, {step!r}, {x}, {seen}, {due}}},\n'
    source, target = tmp_path / "flags.c", tmp_path / "flags"
    source.write_text(FLAGS_PROGRAM.replace("@DECLARED@", declared).replace("@TRIED@", tried), encoding="utf-8")
    library = compiled.place(compiler) if level == "-O2" else compiled.place(compiler, level, "special*.c")
    command = [compiler, "-std=c99", "-O2", "-ffp-contract=off", f"-I{compiled.SOURCES}", str(source), str(library)]
    subprocess.run([*command, "-o", str(target), "-lm"], check=True)
    done = subprocess.run([str(target)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_without_extensions_of_the_compiler(tmp_path):
    """GS_PORTABLE leaves plain C99 alone, with the same bits."""
    target = tmp_path / "libspecial.so"
    sources = map(str, sorted(compiled.SOURCES.glob("special*.c")))
    command = [
        compiled.first_compiler(),
        *compiled.FLAGS,
        "-DGS_PORTABLE",
        "-shared",
        *sources,
        "-o",
        str(target),
        "-lm",
    ]
    subprocess.run(command, check=True)
    library = ctypes.CDLL(str(target))
    assert not hasattr(library, "gs_phi1m_n_avx2")
    x = points("phi1m", 500)
    value = np.empty_like(x)
    library.gs_special_phi1m_n(
        ctypes.c_size_t(x.size), ctypes.c_void_p(x.ctypes.data), ctypes.c_void_p(value.ctypes.data)
    )
    assert np.array_equal(value, run("phi1m", x, "plain"))
