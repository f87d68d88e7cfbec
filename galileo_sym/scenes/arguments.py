"""What a scene is made of, checked: names, constants, lengths; errors tell cause and remedy."""

from __future__ import annotations

import difflib
from keyword import iskeyword
from math import isfinite
from numbers import Real

import numpy as np

from galileo_sym.generated._kernel import DOMAINS

ENDS = {"chord": "arrival", "projectile": "landing"}
_NEVER = "forever"
# fmt: off
_OF_C = frozenset({
    "auto", "case", "char", "const", "default", "do", "double", "enum", "extern", "float", "goto", "inline", "int",
    "long", "main", "register", "restrict", "short", "signed", "sizeof", "static", "struct", "switch", "typedef",
    "union", "unsigned", "void", "volatile",
})
# fmt: on
_WORDS = {
    "positive": "> 0",
    "nonnegative": ">= 0",
    "chord angle": "of size at most pi/2",
    "elevation": "from 0 to pi/2",
}


def known_name(name, names, kind, error):
    """Return a name that is among some; else raise an error that tells the nearest."""
    if name in names:
        return name
    near = difflib.get_close_matches(str(name), names, n=3, cutoff=0.4)
    raise error(f"{name!r} is no {kind}; {f'nearest: {near[0]}; ' if near else ''}there are {', '.join(names)}")


def checked_names(given, names, kind, system):
    """Names of axes or outputs as a tuple."""
    found = (given,) if isinstance(given, str) else tuple(given)
    for name in found:
        known_name(name, names, f"{kind} of {system} scenes", ValueError)
    twice = [name for name in found if found.count(name) > 1]
    if twice:
        raise ValueError(f"{kind} {twice[0]} is named twice: name each once")
    if not found:
        raise ValueError(f"a scene has at least one {kind}: name it")
    return found


def when_it_ends(given, system, known):
    """When the motion ends."""
    if given is None:
        return ENDS[system] if "diameter" in known else _NEVER
    known_name(given, (ENDS[system], _NEVER), f"end of {system} scenes", ValueError)
    if given == "arrival" and "diameter" not in known:
        raise ValueError("beads arrive at the end of a chord: give diameter=, or name it in over=")
    return given


def checked_constant(name, value, row):
    """A constant as a double."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, bool | np.bool_) or not isinstance(value, Real):
        raise TypeError(f"{name} is {value!r}, not a number: name it in over= if it varies")
    domain, unit = row["arguments"][name]
    if not (isfinite(value) and DOMAINS[domain][0](np.float64(value))):
        raise ValueError(f"{name} is {value!r} {unit}: it must be finite and {_WORDS[domain]}")
    return float(value)


def check_function_name(name):
    """Raise ValueError if functions of C and Python cannot have a name."""
    if not (name.isascii() and name.isidentifier()) or name in _OF_C or iskeyword(name) or name.startswith("gs_"):
        raise ValueError(f"{name!r} is no name of a function: name the file otherwise, with letters, digits and _")


def checked_lengths(over, lengths):
    """Lengths of all axes."""
    for name in lengths:
        known_name(name, over, "axis of this scene", TypeError)
    for name in over:
        if name not in lengths:
            raise TypeError(f"give the length of every axis: {name}= is missing")
    return lengths
