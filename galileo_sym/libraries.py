"""C sources compiled by the system's compiler into shared libraries, kept by content in the user's cache folder."""

import contextlib
import hashlib
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from galileo_sym.store import FOLDER, FORGET, cache_folder

try:
    from fcntl import LOCK_EX, flock
except ImportError:  # without it two processes may compile the same sources, and one library takes the other's place
    flock, LOCK_EX = (lambda file, operation: None), 0

COMPILERS = ("cc", "gcc", "clang")
FLAGS = ("-std=c99", "-O2", "-ffp-contract=off", "-fPIC", "-Wall", "-Wextra", "-Wpedantic", "-Werror")
_SHOWN_LINES = 20


class CompilationError(Exception):
    """The C does not compile or load, or lacks a function."""


class NoCompilerError(Exception):
    """There is no C compiler on this machine; the message says where it was looked for."""


def find_compiler(environment=None):
    """The command of the C compiler: $CC if set, else the first of cc, gcc, clang on PATH.

    Parameters
    ----------
    environment : mapping, optional
        Environment variables; those of the process by default.

    Returns
    -------
    list of str
        The compiler and its options.

    Raises
    ------
    NoCompilerError
        If $CC is set and is not there, or if it is not set and none of the three is.
    """
    environment = os.environ if environment is None else environment
    path = environment.get("PATH", os.defpath)
    chosen = shlex.split(environment.get("CC", ""))
    if chosen:
        if shutil.which(chosen[0], path=path) is None:
            raise NoCompilerError(f"CC names {chosen[0]!r}, which is not on PATH; unset CC or install that compiler")
        return chosen
    for name in COMPILERS:
        if shutil.which(name, path=path):
            return [name]
    raise NoCompilerError(f"none of {', '.join(COMPILERS)} is on PATH and CC is not set; install one or set CC")


def compile_library(sources, target, compiler, flags=FLAGS):
    """Compile C files into a shared library, as many at a time as there are processors.

    Parameters
    ----------
    sources : list of Path
        The C files; their own folders are on the include path.
    target : Path
        The library to write.
    compiler : list of str
        As from `find_compiler`.
    flags : sequence of str
        Options of the compiler.

    Raises
    ------
    CompilationError
        With the compiler's first messages; warnings are errors.
    """
    if not sources:
        raise CompilationError("there are no C sources to compile; run `galileo-sym emit`")
    includes = [f"-I{folder}" for folder in sorted({source.parent for source in sources})]
    with tempfile.TemporaryDirectory(prefix="galileo-sym-") as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = [f"{folder}/{place}.o" for place in range(len(sources))]
        commands = [
            [*compiler, *flags, *includes, "-c", str(source), "-o", made]
            for source, made in zip(sources, objects, strict=True)
        ]
        list(pool.map(_run, commands))
        _run([*compiler, *flags, "-shared", *objects, "-o", str(target), "-lm"])


def _run(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        messages = "\n".join((done.stderr or done.stdout).splitlines()[:_SHOWN_LINES])
        raise CompilationError(f"{command[0]} exits with {done.returncode}:\n{messages}")


def _key(sources, compiler, flags):
    """Return a hash of all that a compilation depends on: files, options, compiler, machine."""
    total = hashlib.sha256()
    version = subprocess.run([*compiler, "--version"], capture_output=True, text=True, check=False).stdout
    total.update(repr((compiler, version, tuple(flags), platform.machine())).encode())
    for folder in sorted({source.parent for source in sources}):
        for path in sorted(folder.glob("*.h")):
            total.update(f"{path.name} {path.stat().st_size} ".encode() + path.read_bytes())
    for path in sources:
        total.update(f"{path.name} {path.stat().st_size} ".encode() + path.read_bytes())
    return total.hexdigest()


def kept_library(sources, compiler, flags=FLAGS):
    """The shared library of C sources: the one kept from an earlier run, else compiled now and kept.

    Two processes may ask for the same one at once: one compiles, the other waits. A library that nobody asked for in 90
    days goes. Where the cache folder cannot be used the library is compiled into a folder of its own, and this is said.

    Parameters
    ----------
    sources, compiler, flags
        As for `compile_library`.

    Returns
    -------
    Path

    Raises
    ------
    CompilationError
        As from `compile_library`.
    """
    kept = cache_folder() / "libraries" / f"{_key(sources, compiler, flags)}.so"
    try:
        kept.parent.mkdir(parents=True, exist_ok=True)
        with open(kept.with_suffix(".lock"), "w", encoding="ascii") as lock:
            flock(lock, LOCK_EX)
            if not kept.exists():
                _compile_whole(sources, kept, compiler, flags)
            os.utime(kept)
            forget_old(kept.parent)
        return kept
    except OSError as problem:
        print(
            f"galileo-sym: compiled C is not kept in {kept.parent}: {problem}; name another folder in {FOLDER}",
            file=sys.stderr,
        )
        target = Path(tempfile.mkdtemp(prefix="galileo-sym-")) / "library.so"
        compile_library(sources, target, compiler, flags)
        return target


def _compile_whole(sources, kept, compiler, flags):
    """Compile beside the place, and move there in one step."""
    with tempfile.TemporaryDirectory(dir=kept.parent) as folder:
        made = Path(folder) / kept.name
        compile_library(sources, made, compiler, flags)
        os.replace(made, kept)


def forget_old(folder):
    """Remove the libraries in a folder that were not asked for in a long time."""
    for path in folder.glob("*.so"):
        with contextlib.suppress(OSError):  # another process removed it
            if path.stat().st_mtime < time.time() - FORGET:
                path.unlink()
                path.with_suffix(".lock").unlink()
