"""The NumPy back end: one module a paper, importing NumPy alone."""

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen.printing import SOLVER_TEXT, call_text, clash_pairs, counts_text, sources_text
from galileo_sym.codegen.schedule import TABLE_CALLS, schedule

_SCALED = ("add", "constant", "div", "load", "mul", "scale", "sqrt", "sub")
_ANGLE = ("angle", "cosine", "driving", "sine")
_KERNEL = ("admit", "clash", "moving", "quiet", "settle")
_MODULES = {"_angle": _ANGLE, "_kernel": _KERNEL, "_primitives": TABLE_CALLS, "_scaled": _SCALED}


def _kernel_name(function, force_set):
    return f"{function.name}_{force_set}" if force_set else function.name


def _docstring(function, force_set, operations):
    arguments = "\n".join(f"    {a.name} [{a.unit}]: {a.doc}" for a in function.arguments(force_set))
    results = "\n".join(f"    {o.name} [{o.unit}]: {o.doc}" for o in function.outputs)
    return (
        f'    """{function.doc}\n\n{arguments}\n\n    Returns\n{results}\n\n'
        f"    From {sources_text(function, force_set)}.\n"
        f'    {operations}\n    """\n'
    )


def _clash_text(pairs):
    pairs = [[f"({', '.join(group)}{',' * (len(group) == 1)})" for group in pair] for pair in pairs]
    return f"clash({', '.join(f'({one}, {other})' for one, other in pairs)})"


def _undecided(function, force_set):
    """Name for each distinct set of clashing arguments, and the outputs' names for theirs (None: always decided)."""
    pairs = [clash_pairs(function, force_set, output) for output in function.outputs]
    texts = [_clash_text(p) if p else None for p in pairs]
    names = {}
    for output, text in zip(function.outputs, texts, strict=True):
        if text:
            names.setdefault(text, f"undecided_{output.name}")
    return names, [names.get(text) for text in texts]


def _settle(output, undecided, held):
    options = [output.name, "void"] + ([undecided] if undecided else [])
    if held:
        options += ["rest=rest", f"at_rest={'inf' if output.at_rest == float('inf') else repr(output.at_rest)}"]
    return f"settle({', '.join(options)})"


def _solver_kernel(function, force_set):
    """A kernel that hands over to a function of the templates."""
    names = ", ".join(a.name for a in function.arguments(force_set))
    return (
        f"def {_kernel_name(function, force_set)}({names}):\n"
        f"{_docstring(function, force_set, SOLVER_TEXT)}    return _{function.solver}({names})\n"
    )


def kernel(function, force_set):
    """Return the source of one kernel.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.

    Returns
    -------
    str
        A Python function of float64 arrays.
    """
    if function.solver:
        return _solver_kernel(function, force_set)
    plan = schedule(function, force_set)
    held = any(node[0] == "driving" for _, node in plan.steps)
    arguments = function.arguments(force_set)
    names = [a.name for a in arguments]
    symbols = {a.symbol: a.name for a in arguments}
    clashes, undecided = _undecided(function, force_set)
    lines = [
        f"def {_kernel_name(function, force_set)}({', '.join(names)}):",
        _docstring(function, force_set, f"Operations: {counts_text(plan)}.").rstrip("\n"),
        "    arguments, void = admit(",
        *(f'        ({a.name}, "{a.domain}"),' for a in arguments),
        "    )",
        f"    {', '.join(names)}{',' * (len(names) == 1)} = arguments",
        *(f"    {name} = {text}" for text, name in clashes.items()),
        "    with quiet():",
        *(f"        {s} = load({symbols[s]})" for s in plan.loads),
    ]
    for name, node in plan.steps:
        lines.append(f"        {name} = {call_text(node, '')}")
        if node[0] == "driving":
            lines.append(f"        {name}, rest = moving({name})")
    lines += [f"        {o.name} = {call_text(n, '')}" for o, n in zip(function.outputs, plan.results, strict=True)]
    settled = [_settle(o, u, held) for o, u in zip(function.outputs, undecided, strict=True)]
    if len(settled) == 1:
        lines.append(f"    return {settled[0]}")
    else:
        lines += ["    return (", *(f"        {s}," for s in settled), "    )"]
    return "\n".join(lines) + "\n"


def _dispatch(function):
    """Table row: which kernel serves which force arguments, and which argument is an angle."""
    angle = [a.unit == "rad" for a in function.arguments(next(iter(function.variants)))]
    rows = "".join(
        f"            {names!r}: {_kernel_name(function, force_set)},\n"
        for force_set, (names, _) in function.variants.items()
    )
    index = angle.index(True) if True in angle else None
    return (
        f'    "{function.name}": {{\n        "outputs": {len(function.outputs)},\n        "angle": {index},\n'
        f'        "kernels": {{\n{rows}        }},\n    }},\n'
    )


def module(paper):
    """Return the source of one paper's module."""
    functions = [f for f in FUNCTIONS.values() if f.paper == paper]
    kernels = [kernel(f, force_set) for f in functions for force_set in f.variants]
    text = "\n\n".join(kernels)
    imports = "".join(
        f"from .{source} import {', '.join(used)}\n"
        for source, names in _MODULES.items()
        if (used := [name for name in sorted(names) if f"{name}(" in text])
    )
    solvers = sorted({f"_{f.solver.split('.')[0]}" for f in functions if f.solver})
    imports += f"from . import {', '.join(solvers)}\n" if solvers else ""
    infinity = "from math import inf\n\n" if "=inf" in text else ""
    table = "".join(_dispatch(f) for f in functions)
    return (
        f'"""Kernels of the {paper} formulas on float64 arrays."""\n\n{infinity}{imports}\n\n{text}\n\n'
        "# Number of outputs, index of the angle among the arguments, and the kernel for each set of force arguments.\n"
        f"FUNCTIONS = {{\n{table}}}\n"
    )
