"""What the operating system tells of the processor: its name, and the sets of instructions it has."""

import platform
from functools import cache
from pathlib import Path


@cache
def _told():
    """What /proc/cpuinfo says of the first processor, by key; nothing on systems without it."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").split("\n\n")[0].splitlines() if info.exists() else []
    return {key.strip(): value.strip() for key, _, value in (line.partition(":") for line in lines)}


def name():
    """Return the processor's name, or that of its architecture where no more is known."""
    return _told().get("model name", platform.machine())


def features():
    """Return the names of its sets of instructions, as Linux and compilers call them; none where that is not told."""
    return frozenset(_told().get("flags", "").split())
