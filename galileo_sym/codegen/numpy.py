"""The NumPy back end: one module a paper, importing NumPy alone."""

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen.printing import call_text, clash_groups, counts_text, sources_text
from galileo_sym.codegen.schedule import TABLE_CALLS, schedule

_SCALED = ("add", "constant", "div", "load", "mul", "scale", "sqrt", "sub")
_ANGLE = ("angle", "cosine", "driving", "sine")
_KERNEL = ("admit", "clash", "moving", "quiet", "settle")
_MODULES = {"_angle": _ANGLE, "_kernel": _KERNEL, "_primitives": TABLE_CALLS, "_scaled": _SCALED}


def _kernel_name(function, force_set):
    return f"{function.name}_{force_set}" if force_set else function.name


def _docstring(function, force_set, plan):
    arguments = "\n".join(f"    {a.name} [{a.unit}]: {a.doc}" for a in function.arguments(force_set))
    results = "\n".join(f"    {o.name} [{o.unit}]: {o.doc}" for o in function.outputs)
    return (
        f'    """{function.doc}\n\n{arguments}\n\n    Returns\n{results}\n\n'
        f"    From {sources_text(function, force_set)}.\n"
        f'    Operations: {counts_text(plan)}.\n    """\n'
    )


def _settle(function, force_set, output, node, held):
    options = []
    groups = clash_groups(function, force_set, output)
    if groups:
        options.append(f"clash({', '.join('(' + ''.join(n + ', ' for n in g).rstrip() + ')' for g in groups)})")
    if held:
        limit = "inf" if output.at_rest == float("inf") else repr(output.at_rest)
        options += ["rest=rest", f"at_rest={limit}"]
    return f"settle({', '.join([output.name + '_', 'void', *options])})"


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
    plan = schedule(function, force_set)
    held = any(node[0] == "driving" for _, node in plan.steps)
    arguments = function.arguments(force_set)
    names = [a.name for a in arguments]
    symbols = {a.symbol: a.name for a in arguments}
    lines = [
        f"def {_kernel_name(function, force_set)}({', '.join(names)}):",
        _docstring(function, force_set, plan).rstrip("\n"),
        "    arguments, void = admit(",
        *(f'        ({a.name}, "{a.domain}"),' for a in arguments),
        "    )",
        f"    {', '.join(names)}{',' * (len(names) == 1)} = arguments",
        "    with quiet():",
    ]
    body = [f"{s}_ = load({symbols[s]})" for s in plan.loads]
    lines += [f"        {line}" for line in body]
    rename = {s: f"{s}_" for s in plan.loads}
    for name, node in plan.steps:
        lines.append(f"        {name} = {call_text(_renamed(node, rename), '')}")
        if node[0] == "driving":
            lines.append(f"        {name}, rest = moving({name})")
    for output, node in zip(function.outputs, plan.results, strict=True):
        lines.append(f"        {output.name}_ = {call_text(_renamed(node, rename), '')}")
    settled = [_settle(function, force_set, o, n, held) for o, n in zip(function.outputs, plan.results, strict=True)]
    if len(settled) == 1:
        lines.append(f"    return {settled[0]}")
    else:
        lines += ["    return (", *(f"        {s}," for s in settled), "    )"]
    return "\n".join(lines) + "\n"


def _renamed(node, names):
    if isinstance(node, tuple):
        return (node[0], *(_renamed(operand, names) for operand in node[1:]))
    return names.get(node, node)


def _dispatch(function):
    """Table row: which kernel serves which force arguments, and which argument is an angle."""
    angle = [a.name.endswith("theta") for a in function.arguments(next(iter(function.variants)))]
    rows = ", ".join(
        f"{names!r}: {_kernel_name(function, force_set)}" for force_set, (names, _) in function.variants.items()
    )
    index = angle.index(True) if True in angle else None
    return f'    "{function.name}": {{"outputs": {len(function.outputs)}, "angle": {index}, "kernels": {{{rows}}}}},\n'


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
    infinity = "from math import inf\n\n" if "=inf" in text else ""
    table = "".join(_dispatch(f) for f in functions)
    return (
        f'"""Kernels of the {paper} formulas on float64 arrays."""\n\n{infinity}{imports}\n\n{text}\n\n'
        "# Number of outputs, index of the angle among the arguments, and the kernel for each set of force arguments.\n"
        f"FUNCTIONS = {{\n{table}}}\n"
    )
