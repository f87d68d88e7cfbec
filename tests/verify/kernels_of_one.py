"""The emitted kernels of one primitive alone, as text: quick to parse, and easy to spoil in one place."""

import re
from pathlib import Path

EMITTED = Path(__file__).parents[2] / "generated" / "c"
KERNELS = (EMITTED / "galileo_kernels.h").read_bytes().decode()


def kernels_of(name):
    """The part of galileo_kernels.h from the first table of a primitive to its last function."""
    begin = KERNELS.index(f"GS_TABLE(gs_{name}_centre)")
    end = re.compile(rf"\w gs_{name}_value\(.*?\n}}\n", re.DOTALL).search(KERNELS, begin).end()
    return KERNELS[begin:end]


def spoiled(text, old, new):
    """The text with every occurrence of a part changed, which must be there."""
    assert old in text, f"the emitted C has no {old!r} to spoil"
    return text.replace(old, new)
