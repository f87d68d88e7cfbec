"""The C library as its users build it: by one `cc` line, in one file, by CMake and pkg-config."""

import ctypes
import os
import re
import shutil
import subprocess

import compiled
import numpy as np
import pytest
from samples import arguments

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.libraries import FLAGS, kept_library

pytestmark = pytest.mark.xdist_group("c library")
ONE_FILE = compiled.SOURCES / "amalgamated" / "galileo.c"
EXAMPLE = compiled.SOURCES / "examples" / "descent_time.c"
with_compiler = pytest.mark.parametrize("compiler", compiled.compilers() or [None])
EXTENSIONS = re.compile(r"immintrin|_mm\d|__m\d|__builtin|\btarget\b|__x86_64__|__asm|\btypeof\b")
# descent times at 10 and 80 degrees with diameter 1, g = 9.81, friction 0.1 and drag 0.5, from equations (4) and (17)
FREE = (2 / 9.81) ** 0.5
SLOW = [FREE * (np.cos(a) / (np.cos(a) - 0.1 * np.sin(a))) ** 0.5 for a in np.radians([10, 80])]


def _needs(program):
    if shutil.which(program) is None:
        pytest.skip(f"no {program} on PATH: what it builds is not tested")
    return program


def _done(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def _tells_descent_times(out):
    rows = [list(map(float, line.split())) for line in out.splitlines()[1:]]
    assert [row[0] for row in rows] == list(range(10, 90, 10))
    assert all(row[1] == pytest.approx(FREE, abs=1e-9) for row in rows)
    assert [rows[0][2], rows[-1][2]] == pytest.approx(SLOW, abs=1e-9)
    assert all(row[4] > max(row[2:4]) and row[3] > row[1] for row in rows)


@with_compiler
def test_one_file_gives_the_same_bits(compiler):
    whole = compiled.library()  # skips where there is no compiler
    flags = ["-O1" if flag == "-O2" else flag for flag in FLAGS]  # half the time of compiling
    single = ctypes.CDLL(str(kept_library([ONE_FILE], [compiler], flags)))
    names = re.findall(r"\b(gs_\w+_n)\(size_t n, ([^)]*)\)", (compiled.SOURCES / "galileo.h").read_text())
    assert len(names) > 60
    functions = {f"gs_{f.paper}_{f.name}": f for f in FUNCTIONS.values()}
    for name, parameters in names:
        inputs = re.findall(r"const double \*(\w+)", parameters)
        outputs = re.findall(r"(?<!const )double \*(\w+)", parameters)
        function = next((f for start, f in functions.items() if name.startswith(start + "_")), None)
        drawn = arguments(function, next(reversed(function.variants)), 300, 30, seed=1) if function else {}
        x = np.concatenate([np.linspace(-2, 40, 250), np.geomspace(1e-300, 1e300, 50)])
        values = [np.ascontiguousarray(drawn.get(each, x)) for each in inputs]
        results = []
        for library in (whole, single):
            found = [np.empty(300) for _ in outputs]
            routine = getattr(library, name)
            routine.restype = None
            routine(ctypes.c_size_t(300), *(ctypes.c_void_p(a.ctypes.data) for a in [*values, *found]))
            results.append([array.view(np.int64) for array in found])
        assert np.array_equal(*results), name


def test_one_file_is_plain_c99(tmp_path):
    """It has no word of an extension but attributes behind a condition, and compiles where these mean nothing."""
    text = re.sub(r"/\*.*?\*/", "", ONE_FILE.read_text(), flags=re.DOTALL)
    assert EXTENSIONS.findall(text) == []
    flags = [*FLAGS, "-O0", "-D__attribute__(x)="]
    _done(compiled.first_compiler(), *flags, "-c", ONE_FILE, "-o", tmp_path / "galileo.o")


def test_the_example_by_one_line(tmp_path):
    program = tmp_path / "descent_time"
    flags = ["-std=c99", f"-I{compiled.SOURCES}"]
    _done(compiled.first_compiler(), *flags, EXAMPLE, ONE_FILE, "-o", program, "-lm")
    _tells_descent_times(_done(program))


def test_cmake_builds_and_installs_and_pkg_config_finds(tmp_path):
    cmake, pkg_config, compiler = _needs("cmake"), _needs("pkg-config"), compiled.first_compiler()
    build, prefix = tmp_path / "build", tmp_path / "prefix"
    options = [f"-DCMAKE_INSTALL_PREFIX={prefix}", "-DCMAKE_BUILD_TYPE=Debug", "-DGALILEO_PORTABLE=ON"]
    _done(cmake, "-S", compiled.SOURCES, "-B", build, *options, "-DCMAKE_INSTALL_LIBDIR=lib")
    _done(cmake, "--build", build, "--parallel", "2")
    _tells_descent_times(_done(build / "descent_time"))
    _done(cmake, "--install", build)
    environment = {**os.environ, "PKG_CONFIG_PATH": str(prefix / "lib" / "pkgconfig")}
    flags = _done(pkg_config, "--cflags", "--libs", "--static", "galileo-sym", env=environment).split()
    program = tmp_path / "installed"
    _done(compiler, "-std=c99", EXAMPLE, "-o", program, *flags)
    _tells_descent_times(_done(program))
    consumer = tmp_path / "consumer"
    consumer.mkdir()
    (consumer / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.13)\nproject(consumer LANGUAGES C)\nfind_package(galileo-sym REQUIRED)\n"
        f"add_executable(consumer {EXAMPLE})\ntarget_link_libraries(consumer PRIVATE galileo-sym::galileo)\n"
    )
    _done(cmake, "-S", consumer, "-B", consumer / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    _done(cmake, "--build", consumer / "build")
    _tells_descent_times(_done(consumer / "build" / "consumer"))
