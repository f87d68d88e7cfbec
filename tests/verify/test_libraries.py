"""Compiled C is kept by content: made once, made anew when anything it depends on changes, whole at every time."""

import ctypes
import os
import subprocess
import sys
import time

import pytest

from galileo_sym.libraries import CompilationError, NoCompilerError, find_compiler, kept_library
from galileo_sym.store import FOLDER, FORGET

try:
    COMPILER = find_compiler()
except NoCompilerError as cause:
    pytest.skip(f"no C compiler: {cause}", allow_module_level=True)


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv(FOLDER, str(tmp_path / "cache"))
    return tmp_path / "cache" / "libraries"


@pytest.fixture
def source(tmp_path):
    (tmp_path / "one.h").write_text("int one(void);\n#define ONE 1\n")
    (tmp_path / "one.c").write_text('#include "one.h"\nint one(void)\n{\n    return ONE;\n}\n')
    return tmp_path / "one.c"


def _kept(cache):
    return sorted(path.name for path in cache.glob("*.so"))


def test_made_once(source, cache):
    first = kept_library([source], COMPILER)
    made = first.stat().st_ino
    assert kept_library([source], COMPILER) == first
    assert first.stat().st_ino == made
    assert ctypes.CDLL(str(first)).one() == 1
    assert _kept(cache) == [first.name]


@pytest.mark.parametrize("change", ["source", "header", "flags", "compiler"])
def test_made_anew_when_anything_changes(source, change):
    first = kept_library([source], COMPILER)
    if change == "source":
        source.write_text(source.read_text() + "/* */\n")
    if change == "header":
        header = source.with_suffix(".h")
        header.write_text(header.read_text().replace("ONE 1", "ONE 2"))
    compiler = [*COMPILER, "-DNDEBUG"] if change == "compiler" else COMPILER
    second = kept_library([source], compiler, *([("-O0", "-fPIC")] if change == "flags" else []))
    assert second != first
    assert ctypes.CDLL(str(second)).one() == (2 if change == "header" else 1)


def test_what_does_not_compile_leaves_nothing(source, cache):
    source.write_text("this is not C\n")
    with pytest.raises(CompilationError, match="exits with"):
        kept_library([source], COMPILER)
    assert _kept(cache) == []
    assert [path for path in cache.iterdir() if path.is_dir()] == []


def test_processes_that_ask_at_once_compile_it_once(source, tmp_path):
    """The compiler of this test counts how often it is called to make an object."""
    counter, compiler = tmp_path / "calls", tmp_path / "counting"
    compiler.write_text(
        f'#!/bin/sh\ncase "$*" in *" -c "*) echo >> {counter}; sleep 0.5;; esac\nexec {COMPILER[0]} "$@"\n'
    )
    compiler.chmod(0o755)
    code = (
        "import sys, pathlib; from galileo_sym.libraries import kept_library;"
        "print(kept_library([pathlib.Path(sys.argv[1])], [sys.argv[2]]))"
    )
    command = [sys.executable, "-c", code, str(source), str(compiler)]
    running = [subprocess.Popen(command, stdout=subprocess.PIPE, text=True) for _ in range(3)]
    places = {process.communicate(timeout=60)[0] for process in running}
    assert len(places) == 1
    assert counter.read_text() == "\n"


def test_a_cache_that_cannot_be_used_is_told_and_done_without(source, tmp_path, capsys):
    (tmp_path / "cache").write_text("a file in the way")
    library = kept_library([source], COMPILER)
    assert ctypes.CDLL(str(library)).one() == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "compiled C is not kept in" in said
    assert FOLDER in said


def test_what_nobody_asked_for_goes(source, cache):
    first = kept_library([source], COMPILER)
    old = time.time() - FORGET - 60
    os.utime(first, (old, old))
    source.write_text(source.read_text() + "/* */\n")
    assert _kept(cache) == [first.name]
    second = kept_library([source], COMPILER)
    assert _kept(cache) == [second.name]
