"""Compile the peers, each kept by content; what is missing is told with what to install."""

import ctypes
import hashlib
import os
import platform
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from galileo_sym.libraries import forget_old
from galileo_sym.store import cache_folder

from ..contestants import Contestant
from ..printed import printed
from .source import source, symbol_of

HERE = Path(__file__).resolve().parent
_FLAGS = ("-O3", "-march=native", "-fPIC", "-shared")
_LIBRARIES = (".so", ".dylib", ".dll")
_SHOWN_LINES = 6


class MissingPeer(Exception):
    """A peer cannot be built on this machine; the message says what to install."""


@dataclass(frozen=True)
class Peer:
    """A library with a Lambert W.

    Attributes
    ----------
    name : str
    template : str
        The source with its W, in this folder.
    tool : tuple of str
        The command that builds it; the sources and the target are added for a compiler.
    links : tuple of str
        Libraries.
    remedy : str
        What to install.
    """

    name: str
    template: str
    tool: tuple
    links: tuple
    remedy: str


PEERS = (
    Peer(
        "C, Boost's W", "boost.cpp", ("c++", *_FLAGS), (), "install a C++ compiler and Boost (Debian: g++ libboost-dev)"
    ),
    Peer(
        "C, GSL's W",
        "gsl.c",
        ("cc", *_FLAGS),
        ("-lgsl", "-lgslcblas", "-lm"),
        "install a C compiler and GSL (Debian: gcc libgsl-dev)",
    ),
    Peer(
        "Rust, lambert_w",
        "lambert_w.rs",
        ("cargo", "build", "--release", "--quiet"),
        (),
        "install Rust with cargo; the crate is fetched once",
    ),
)


class Compiled(Contestant):
    """A peer that was built."""

    def __init__(self, peer, path, kernels):
        self.name = peer.name
        self._library = ctypes.CDLL(str(path))
        self._has = {(case.full_name, case.force_set) for case in kernels}

    def serves(self, case):
        return (case.full_name, case.force_set) in self._has

    def takes_numbers(self, case):
        return False

    def prepare(self, case, arguments):
        given = [np.ascontiguousarray(arguments[name], dtype=float) for name in case.arguments]
        out = tuple(np.empty(given[0].shape) for _ in case.outputs)
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in (*given, *out)]
        routine = self._library[symbol_of(case)]
        routine.restype = None
        call = partial(routine, ctypes.c_size_t(given[0].size), *pointers)

        def run():
            call()
            return out

        run.kept = given  # the library holds their addresses only
        return run


def _run(command, peer, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode:
        messages = " / ".join(line.strip() for line in done.stderr.splitlines()[:_SHOWN_LINES])
        raise MissingPeer(f"{peer.name}: {peer.tool[0]} exits with {done.returncode} ({messages}); {peer.remedy}")


def with_compiler(peer, text, folder):
    file, made = folder / peer.template, folder / "peer.so"
    file.write_text(text, encoding="utf-8")
    _run([*peer.tool, str(file), "-o", str(made), *peer.links], peer)
    return made


def with_cargo(peer, text, folder):
    (folder / "lambert_w.rs").write_text(text, encoding="utf-8")
    shutil.copy(HERE / "Cargo.toml", folder)
    _run(list(peer.tool), peer, cwd=folder, env={**os.environ, "RUSTFLAGS": "-C target-cpu=native"})
    return next(path for path in (folder / "target" / "release").glob("*peer.*") if path.suffix in _LIBRARIES)


def _built(peer, kernels):
    """The library of a peer, made now unless an earlier run has."""
    if shutil.which(peer.tool[0]) is None:
        raise MissingPeer(f"{peer.name}: there is no {peer.tool[0]} on PATH; {peer.remedy}")
    text = source(HERE / peer.template, kernels)
    key = hashlib.sha256(repr((peer, text, platform.machine())).encode()).hexdigest()[:32]
    kept = cache_folder() / "peers" / f"{key}.so"
    if not kept.exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        forget_old(kept.parent)
        with tempfile.TemporaryDirectory(dir=kept.parent) as folder:
            made = (with_cargo if peer.tool[0] == "cargo" else with_compiler)(peer, text, Path(folder))
            os.replace(made, kept)
    os.utime(kept)
    return kept


def kernels_of(chosen):
    """Of cases, those whose kernels a peer can have, each kernel once."""
    kernels = {(case.full_name, case.force_set): case for case in chosen}
    return [case for place, case in kernels.items() if printed(*place)]


def peers(chosen, tell):
    """The peers that can be built here, for the functions of cases.

    Parameters
    ----------
    chosen : iterable of Case
    tell : callable
        Called with a sentence for each peer that is missing.

    Returns
    -------
    list of Compiled
    """
    found, kernels = [], kernels_of(chosen)
    for peer in PEERS:
        try:
            found.append(Compiled(peer, _built(peer, kernels), kernels))
        except MissingPeer as cause:
            tell(str(cause))
    return found
