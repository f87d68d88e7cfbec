"""Which part of the emitted C a result is about: what a primitive uses, so that nothing else makes it stale."""

import hashlib
import re
from pathlib import Path

from galileo_sym.verify.back_ends import generated_folder

HEADERS = (
    "galileo_vector.h",
    "galileo_kernels.h",
    "galileo_frames.h",
)  # each primitive uses some of what they define
LOOPS = "galileo_loops.h"
QUICK = ("galileo_lean.h", "galileo_blocks.h", "galileo_singles.h")
_QUICK_MACRO = re.compile(r"^#define GS_(?:SERVE|SINGLES)\(.*?[^\\]\n", re.MULTILINE | re.DOTALL)
_HEAD = r"^(?:GS_TABLE\((\w+)\)|static\b[^\n(]*?\b(gs_\w+)\()"
_DEFINITION = re.compile(_HEAD + r"(?:[^\n]*\}\n|.*?^\}[^\n]*\n)", re.MULTILINE | re.DOTALL)  # in a line, or in many
_GUARD = re.compile(r"#ifndef (\w+)\n#define \1\n((?:#include \"galileo\w*\.h\"\n)*)(.*)#endif\s*", re.DOTALL)
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_CALLED_BY_LOOPS = ("gs_v_load", "gs_v_store", "gs_v_widen", "gs_v_narrow", "gs_to_odd")
_NAME = re.compile(r"\bgs_\w+")


def c_folder():
    """Return where the emitted C is."""
    return generated_folder() / "c"


def used_by(name, text, form="value"):
    """Return the definitions that `gs_NAME_value` and the loops around it need, in the order of the text.

    Parameters
    ----------
    name : str
        A primitive.
    text : str
        Definitions, without comments; one name may have several, for vectors of different widths.
    form : str
        Another end of the function's name.

    Raises
    ------
    KeyError
        If there is no such function.
    """
    found = [(m.group(1) or m.group(2), m.group()) for m in _DEFINITION.finditer(text)]
    bodies = {}
    for key, body in found:
        bodies[key] = bodies.get(key, "") + body
    if f"gs_{name}_{form}" not in bodies:
        raise KeyError(f"the emitted kernels define no gs_{name}_{form}")
    needed, waiting = set(), [f"gs_{name}_{form}", *_CALLED_BY_LOOPS]
    while waiting:
        here = waiting.pop()
        if here in bodies and here not in needed:
            needed.add(here)
            waiting += _NAME.findall(bodies[here])
    return [body for key, body in found if key in needed]


def _bare(path):
    """Return a header without comments and without what keeps it from being read twice."""
    text = _COMMENT.sub("", path.read_text(encoding="utf-8")).lstrip() + "\n"
    return _GUARD.fullmatch(re.sub(r"\n\s*\n+", "\n", text)).group(3)


def digest(name, folder=None):
    """Return the SHA-256 of what the binary32 function of a primitive is compiled from, comments apart.

    Parameters
    ----------
    name : str
        A primitive.
    folder : Path, optional
        Where the C is; the emitted one by default.
    """
    folder = Path(folder or c_folder())
    text = "".join(_bare(folder / file) for file in HEADERS if (folder / file).exists())
    between = _DEFINITION.sub("", text)
    parts = [*used_by(name, text), between, _bare(folder / LOOPS)]
    return hashlib.sha256("\n".join(" ".join(part.split()) for part in parts).encode()).hexdigest()


def singles_digest(name, folder=None):
    """Return the SHA-256 of what the quick binary32 function of a primitive, and that by pairs, are compiled from."""
    folder = Path(folder or c_folder())
    text = "".join(_bare(folder / file) for file in (*HEADERS, *QUICK))
    of_it = [*used_by(name, text, "any_single"), *used_by(name, text, "mixed_single")]
    parts = [digest(name, folder), *of_it, *_QUICK_MACRO.findall(text)]
    return hashlib.sha256("\n".join(" ".join(part.split()) for part in parts).encode()).hexdigest()
