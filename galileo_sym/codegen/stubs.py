"""Types for type checkers: of the public modules, of the one-variable functions, of the compiled module."""

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.catalogue.special import SPECIAL
from galileo_sym.codegen.ufunc import ufunc_names

_HEAD = '''"""{doc}"""

from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

__all__ = [{names}]

_Casting = Literal["no", "equiv", "safe", "same_kind", "unsafe"]
'''
_OPTIONS = (
    ("out", "NDArray[Any] | tuple[NDArray[Any] | None, ...] | None", "None"),
    ("where", "ArrayLike", "True"),
    ("dtype", "DTypeLike | None", "None"),
    ("casting", "_Casting", '"same_kind"'),
)
# Public functions that are not emitted: they are made of what is.
_MADE = {
    "chord": {
        "synchronous_curve": "t: ArrayLike, n: int, *, g: ArrayLike, mu: ArrayLike = 0.0, gamma: ArrayLike = 0.0, "
        "{options}) -> tuple[NDArray[Any], NDArray[Any]]"
    }
}
_DOCS = {
    "chord": "Beads sliding from rest along chords from the top of a vertical circle.",
    "lambert": "Both real branches of the Lambert W function, and the real roots of a t + b + c exp(d t) = 0.",
    "projectile": "Projectiles under gravity and linear resistance.",
}


def _signature(function, kind, result, options):
    """One definition: all arguments of a kind, the forces with their defaults."""
    parts = [f"{name}: {kind}" for name in function.positional]
    keywords = [f"{name}: {kind}" for name in function.keywords] + [f"{name}: {kind} = 0.0" for name in function.forces]
    parts += ["*", *keywords] if keywords else []
    parts += [f"{name}: {of} = {default}" for name, of, default in options]
    return f"def {function.name}({', '.join(parts)}) -> {result}: ...\n"


def _overloads(function):
    """Numbers give numbers; of arrays the type depends on whose they are."""
    count = len(function.outputs)
    number = "np.float64" if count == 1 else f"tuple[{', '.join(['np.float64'] * count)}]"
    several = "Any" if count == 1 else f"tuple[{', '.join(['Any'] * count)}]"
    plain = (("out", "None", "None"), ("where", "Literal[True]", "True"), ("dtype", "None", "None"), _OPTIONS[3])
    rows = (("float", number, plain), ("ArrayLike", several, _OPTIONS))
    return "".join(f"@overload\n{_signature(function, *row)}" for row in rows)


def public_stub(paper):
    """Return the stub of a public module."""
    stubs = {f.name: _overloads(f) for f in FUNCTIONS.values() if f.paper == paper}
    options = ", ".join(f"{name}: {of} = {default}" for name, of, default in _OPTIONS)
    for name, rest in _MADE.get(paper, {}).items():
        stubs[name] = f"def {name}({rest.format(options=options)}: ...\n"
    names = ", ".join(f'"{name}"' for name in sorted(stubs))
    return _HEAD.format(doc=_DOCS[paper], names=names) + "\n" + "\n".join(stubs[name] for name in sorted(stubs))


def special_stub():
    """Return the stub of the one-variable functions."""
    names = "".join(f'    "{name}",\n' for name in SPECIAL)
    lines = "".join(f"{name}: np.ufunc\n" for name in SPECIAL)
    head = '"""The one-variable functions behind the two papers."""\n\nimport numpy as np\n\n'
    return f"{head}__all__ = [\n{names}]\n\n{lines}"


def extension_stub():
    """Return the stub of the compiled module."""
    lines = "".join(f"{name}: np.ufunc\n" for name in ufunc_names())
    return (
        '"""The emitted C as NumPy ufuncs, by function, forces and output."""\n\n'
        "from collections.abc import Callable\nfrom typing import Any\n\nimport numpy as np\n\n"
        "SOURCES: str\nCOMPILER: str\nVECTORS: str\n\n"
        "class Entry:\n    def __call__(self, *operands_and_options: Any) -> Any: ...\n\n"
        f"def entry(name: str, otherwise: Callable[..., Any], /) -> Entry: ...\n\n{lines}"
    )
