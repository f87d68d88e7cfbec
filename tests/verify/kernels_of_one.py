"""The emitted kernels of one primitive alone, as text: quick to parse, and easy to spoil in one place."""

import re
from pathlib import Path

EMITTED = Path(__file__).parents[2] / "generated" / "c"
KERNELS = (EMITTED / "galileo_kernels.h").read_bytes().decode()
FRAMES = (EMITTED / "galileo_frames.h").read_bytes().decode()


def kernels_of(name):
    """The part of galileo_kernels.h from the first table of a primitive to its last function."""
    begin = KERNELS.index(f"GS_TABLE(gs_{name}_centre)")
    end = re.compile(rf"\w gs_{name}_value\(.*?\n}}\n", re.DOTALL).search(KERNELS, begin).end()
    return KERNELS[begin:end]


def frame_of(name, *banks):
    """The part of galileo_frames.h that is one primitive's: the approximations it looks up, its tables and ranges."""
    parts = []
    for bank in banks:
        begin = FRAMES.index(f"GS_TABLE(gs_{bank}_centre)")
        end = re.compile(rf"\w gs_{bank}_near_pair\(.*?\n}}\n", re.DOTALL).search(FRAMES, begin).end()
        parts.append(FRAMES[begin:end])
    others = re.findall(rf"GS_TABLE\(gs_{name}_\w+\) = \{{.*?\}};\n", FRAMES, re.DOTALL)
    parts += [text for text in others if not re.search(r"_(centre|c\d+(_lo)?)\)", text)]
    parts += re.findall(rf"static \w+ gs_v gs_{name}_(?:range\d+|outside|value)\(.*?\n}}\n", FRAMES, re.DOTALL)
    return "\n".join(parts)


def spoiled(text, old, new):
    """The text with every occurrence of a part changed, which must be there."""
    assert old in text, f"the emitted C has no {old!r} to spoil"
    return text.replace(old, new)
