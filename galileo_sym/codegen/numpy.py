"""The NumPy back end: one module a paper, importing NumPy alone."""

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen.printing import (
    PRIMITIVE_TEXT,
    ROUTINE_TEXT,
    call_text,
    counts_text,
    sources_text,
    undecided_text,
)
from galileo_sym.codegen.schedule import TABLE_CALLS, balance_name, schedule
from galileo_sym.solvers import SOLVERS

_SCALED = ("add", "constant", "div", "load", "mul", "scale", "sqrt", "sub")
_ANGLE = ("angle", "cosine", "driving", "sine")
_DECIDED = "False"
_KERNEL = ("admit", "at_most", "clash", "idle", "if_zero", "moving", "quiet", "settle", "within")
_MODULES = {
    "_angle": _ANGLE,
    "_decay": ("decay", "fading", "first", "second"),
    "_elevation": ("arctangent", "right_angle"),
    "_kernel": _KERNEL,
    "_launch": ("Balance", "launch"),
    "_primitives": TABLE_CALLS,
    "_scaled": _SCALED,
}


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
    """When arguments of both groups of a pair are infinite."""
    if not pairs:
        return _DECIDED
    pairs = [[f"({', '.join(group)}{',' * (len(group) == 1)})" for group in pair] for pair in pairs]
    return f"clash({', '.join(f'({one}, {other})' for one, other in pairs)})"


def _undecided(function, force_set):
    """Name for each distinct set of clashing arguments, and the outputs' names for theirs (None: always decided)."""
    choose = "if_zero({0}, {1}, {2})".format
    texts = [undecided_text(function, force_set, output, _clash_text, choose) for output in function.outputs]
    names = {}
    for output, text in zip(function.outputs, texts, strict=True):
        if text != _DECIDED:
            names.setdefault(text, f"undecided_{output.name}")
    return names, [names.get(text) for text in texts]


def _settle(output, undecided, held):
    options = [output.name, "void"] + ([undecided] if undecided else [])
    if held:
        options += ["rest=rest", f"at_rest={'inf' if output.at_rest == float('inf') else repr(output.at_rest)}"]
    return f"settle({', '.join(options)})"


def _routine_kernel(function, force_set):
    """A kernel that hands over to a function of the templates."""
    names = ", ".join(a.name for a in function.arguments(force_set))
    return (
        f"def {_kernel_name(function, force_set)}({names}):\n"
        f"{_docstring(function, force_set, ROUTINE_TEXT)}    return _{function.routine}({names})\n"
    )


def _primitive_kernel(function, force_set):
    """A kernel that is a primitive; its rest is dropped."""
    (argument,) = (a.name for a in function.arguments(force_set))
    doc = _docstring(function, force_set, PRIMITIVE_TEXT.format(function.primitive))
    return (
        f"def {_kernel_name(function, force_set)}({argument}):\n"
        f"{doc}    return special.{function.primitive}({argument})[0]\n"
    )


def _balance(name, plan, unknown):
    """Source of what a solver evaluates in each of its steps."""
    values = "".join(
        f"        {key}={call_text(node, '')},\n" for key, node in zip(plan.names, plan.results, strict=True)
    )
    steps = "".join(f"    {key} = {call_text(node, '')}\n" for key, node in plan.steps)
    return (
        f"def {name}({', '.join(unknown)}):\n"
        f'    """The {", ".join(plan.names)} of the equation that is solved.\n\n'
        f'    Operations: {counts_text(plan)}.\n    """\n{steps}    return Balance(\n{values}    )\n'
    )


def _limit(function, limit):
    """Lines that take out the lanes where the argument is beyond its largest value, or at it."""
    return [
        f"        most = {call_text(limit.most, '')}",
        f"    void, full = within({function.ceiling.argument}_in, most, void)",
        "    with quiet():",
        f"        there = {call_text(limit.there, '')}",
        "        rho = idle(void | full, rho)",
    ]


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
    if function.routine:
        return _routine_kernel(function, force_set)
    if function.primitive:
        return _primitive_kernel(function, force_set)
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
        *([f"    {function.ceiling.argument}_in = {function.ceiling.argument}"] if plan.limit else []),
        "    with quiet():",
        *(f"        {s} = load({symbols[s]})" for s in plan.loads),
    ]
    for index, (name, node) in enumerate(plan.steps):
        if plan.limit and index == plan.limit.after:
            lines += _limit(function, plan.limit)
        lines.append(f"        {name} = {call_text(node, '')}")
        if node[0] == "driving":
            lines.append(f"        {name}, rest = moving({name})")
    results = [call_text(node, "") for node in plan.results]
    if plan.limit:
        results = [f"at_most(full, there, {text})" for text in results]
    lines += [f"        {o.name} = {text}" for o, text in zip(function.outputs, results, strict=True)]
    settled = [_settle(o, u, held) for o, u in zip(function.outputs, undecided, strict=True)]
    if len(settled) == 1:
        lines.append(f"    return {settled[0]}")
    else:
        lines += ["    return (", *(f"        {s}," for s in settled), "    )"]
    text = "\n".join(lines) + "\n"
    if plan.balance:
        unknown = SOLVERS[function.full_name, force_set].unknown
        return _balance(balance_name(function, force_set), plan.balance, unknown) + "\n\n" + text
    return text


def _kernels(function, indent):
    """Rows of a table of kernels by force arguments."""
    return "".join(
        f"{indent}{names!r}: {_kernel_name(function, force_set)},\n"
        for force_set, (names, _) in function.variants.items()
    )


def _ceiling(function):
    """Row of the argument that has a largest value: its index, and the kernels of that value."""
    if function.ceiling is None:
        return ""
    names = [a.name for a in function.arguments(next(iter(function.variants)))]
    most = FUNCTIONS[f"{function.paper}.{function.ceiling.most}"]
    rows = _kernels(most, " " * 16)
    index = names.index(function.ceiling.argument)
    return f'        "ceiling": (\n            {index},\n            {{\n{rows}            }},\n        ),\n'


def _dispatch(function):
    """Table row: which kernel serves which force arguments, which argument is an angle, which has a largest value."""
    if function.primitive:
        return f'    "{function.name}": special.FUNCTIONS["{function.primitive}"],\n'
    angle = [a.unit == "rad" for a in function.arguments(next(iter(function.variants)))]
    index = angle.index(True) if True in angle else None
    return (
        f'    "{function.name}": {{\n        "outputs": {len(function.outputs)},\n        "angle": {index},\n'
        f"{_ceiling(function)}"
        f'        "kernels": {{\n{_kernels(function, " " * 12)}        }},\n    }},\n'
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
    sources = {f"_{f.routine.split('.')[0]}" for f in functions if f.routine}
    sources = sorted(sources | {"special" for f in functions if f.primitive})
    imports += f"from . import {', '.join(sources)}\n" if sources else ""
    infinity = "from math import inf\n\n" if "=inf" in text else ""
    table = "".join(_dispatch(f) for f in functions)
    return (
        f'"""Kernels of the {paper} formulas on float64 arrays."""\n\n{infinity}{imports}\n\n{text}\n\n'
        "# Number of outputs, index of the angle among the arguments, the kernel for each set of force arguments;\n"
        "# if an argument has a largest value, its index and the kernels of that value.\n"
        f"FUNCTIONS = {{\n{table}}}\n"
    )
