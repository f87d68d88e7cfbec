"""Build the extension with AddressSanitizer and UndefinedBehaviorSanitizer and run its tests: `make sanitize`.

Compiles the emitted C into build/sanitizers/ and runs the tests of the public functions with that extension, both
sanitizers made to end the run at the first finding. What was run goes to docs/sanitizers.md, with the date.
"""

import os
import platform
import re
import subprocess
import sys
import sysconfig
import time
from datetime import date
from pathlib import Path

import numpy as np

from galileo_sym._config import emitted_digest
from galileo_sym.libraries import CompilationError, NoCompilerError, compile_library, find_compiler

ROOT = Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs" / "sanitizers.md"
FLAGS = ("-std=c99", "-O1", "-g", "-ffp-contract=off", "-fPIC", "-fno-omit-frame-pointer", "-Wall", "-Wextra")
SANITIZE = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
OPTIONS = {
    # Python itself keeps memory; a stack made to detect its use after return is not aligned for vectors of AVX-512
    "ASAN_OPTIONS": "detect_leaks=0:halt_on_error=1:detect_stack_use_after_return=0",
    "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1",
}
TESTS = (
    "test_ufuncs.py",
    "test_ufunc_overrides.py",
    "test_other_arrays.py",
    "test_public_front.py",
    "test_public_values.py",
    "test_special_functions.py",
    "test_zero_forces.py",
    "test_lambert_values.py",
    "test_launch_angles.py",
)


def build(compiler):
    """Compile the extension with both sanitizers; returns its path."""
    target = ROOT / "build" / "sanitizers" / f"_ufuncs{sysconfig.get_config_var('EXT_SUFFIX')}"
    target.parent.mkdir(parents=True, exist_ok=True)
    includes = [f"-I{folder}" for folder in (sysconfig.get_path("include"), np.get_include())]
    sources = sorted(path for part in ("c", "extension") for path in (ROOT / "generated" / part).glob("*.c"))
    compile_library(sources, target, compiler, (*FLAGS, *SANITIZE, *includes))
    return target


def runtime(compiler):
    """Paths of the sanitizers' libraries, which must be loaded before Python is."""
    names = ("libasan.so", "libubsan.so")
    return " ".join(said([*compiler, f"-print-file-name={name}"]).strip() for name in names)


def said(command):
    """What a command prints."""
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def run_tests(compiler, extension):
    """Run the tests of the C back end with an extension; returns what pytest said."""
    environment = {
        **os.environ,
        **OPTIONS,
        "LD_PRELOAD": runtime(compiler),
        "GALILEO_SYM_EXTENSION": str(extension),
        "PYTHONPATH": str(Path(__file__).parent),
    }
    paths = [str(ROOT / "tests" / "public" / name) for name in TESTS]
    command = [sys.executable, "-m", "pytest", "-p", "sanitized_extension", "-k", "not numpy", *paths]
    return subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)


def page(compiler, summary, seconds):
    """The page that says what was run."""
    version = said([*compiler, "--version"]).splitlines()[0]
    tests = ", ".join(f"`{name}`" for name in TESTS)
    return (
        "# Sanitizers\n\n"
        "Written by `make sanitize`: the extension built with AddressSanitizer and UndefinedBehaviorSanitizer, which\n"
        "end the run at the first finding, and the tests of the public functions run with it, those of the C back end\n"
        "alone. Leaks are not looked for: the interpreter keeps memory of its own.\n\n"
        f"- {date.today().isoformat()}, {platform.system()} {platform.machine()}, {version}, NumPy {np.__version__}\n"
        f"- options: `{' '.join((*FLAGS, *SANITIZE))}`\n"
        f"- tests: {tests}\n"
        f"- {summary}, in {seconds:.0f} s; nothing found\n"
        f"- of the emitted C with the digest {emitted_digest()[:16]}\n"
    )


def main() -> int:
    """Build, run, write; 1 if anything was found or a test failed, 2 without a compiler."""
    try:
        compiler = find_compiler()
        extension = build(compiler)
    except (NoCompilerError, CompilationError) as problem:
        print(problem)
        return 2
    start = time.perf_counter()
    done = run_tests(compiler, extension)
    found = re.search(r"(\d+) passed.*", done.stdout)
    if done.returncode or not found:
        print(done.stdout[-6000:], done.stderr[-6000:], sep="\n")
        return 1
    text = page(compiler, f"{found.group(1)} tests passed", time.perf_counter() - start)
    PAGE.write_text(text, encoding="utf-8")
    print(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
