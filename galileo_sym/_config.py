"""What this installation runs: back end, vector code, compiler, and whether it is built of the C that is here."""

import hashlib
from importlib.metadata import version
from pathlib import Path

import numpy as np

_HOLDS_THE_DIGEST = "extension/tables.c"


def sources_digest(files):
    """Return one hash of the C that the extension is built of; it is compiled in.

    Parameters
    ----------
    files : dict of str to bytes
        Emitted files by path; what is not of the extension is passed over.
    """
    ours = [name for name in files if name.startswith(("c/", "extension/")) and name.endswith((".c", ".h"))]
    hashes = [hashlib.sha256(files[name]).hexdigest() for name in sorted(ours) if name != _HOLDS_THE_DIGEST]
    return hashlib.sha256("".join(hashes).encode()).hexdigest()


def emitted_digest():
    """Return the hash of the C that is here."""
    import galileo_sym.generated  # noqa: PLC0415 (it is looked for where it is asked for)

    folder = Path(galileo_sym.generated.__file__).parent
    paths = [path for part in ("c", "extension") for path in (folder / part).rglob("*.[ch]")]
    return sources_digest({path.relative_to(folder).as_posix(): path.read_bytes() for path in paths})


def configuration():
    """Return what this installation runs, in words.

    Returns
    -------
    dict of str to str
        ``version``, ``back end`` (c or numpy), ``vectors`` (avx512, avx2 or plain, as chosen on this machine),
        ``compiler``, ``extension`` (whether it is built of the emitted C that is here), ``numpy``.
    """
    from galileo_sym import _backend  # noqa: PLC0415 (choosing fails where the environment asks for what is not there)

    extension = _backend.EXTENSION
    told = {"version": version("galileo-sym"), "back end": _backend.NAME}
    if extension is None:
        told |= {"vectors": "those of NumPy", "compiler": "none", "extension": "not in use"}
    else:
        current = emitted_digest() == extension.SOURCES
        state = "built of the emitted C that is here" if current else "STALE: built of other C; run `make install`"
        told |= {"vectors": extension.VECTORS, "compiler": extension.COMPILER, "extension": state}
    return told | {"numpy": np.__version__}


def show_config():
    """Print what this installation runs, and return it as `configuration` does."""
    told = configuration()
    for name, value in told.items():
        print(f"{name + ':':<11} {value}")
    return told
