"""The NumPy back end: two modules a paper, of its functions and of their scaled kernels, importing NumPy alone."""

import re

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen.numpy_forms import docstring, form, kernel_name, on_pairs, scaled_module_name
from galileo_sym.codegen.printing import PRIMITIVE_TEXT, ROUTINE_TEXT, call_text, operations_text, undecided_text
from galileo_sym.codegen.schedule import TABLE_CALLS, balance_name, schedule
from galileo_sym.solvers import SOLVERS

_SCALED = ("add", "constant", "div", "load", "mul", "scale", "sqrt", "sub")
_ANGLE = ("angle", "cosine", "driving", "sine")
_DECIDED = "False"
_KERNEL = ("admit", "at_most", "clash", "idle", "if_zero", "moving", "quiet", "settle", "within")
_FORM_MODULES = {
    "_chunks": ("in_chunks",),
    "_factors": (*TABLE_CALLS, "phi0m", "range_balance"),
    "_forms": ("Form", "serve"),
    "_kernel": ("quiet",),
    "_pairs": (*_SCALED, "rate"),
    "_turn": _ANGLE,
}
_MODULES = {
    "_angle": _ANGLE,
    "_decay": ("decay", "fading", "first", "second"),
    "_elevation": ("arctangent", "right_angle"),
    "_kernel": _KERNEL,
    "_launch": ("Balance", "launch"),
    "_primitives": TABLE_CALLS,
    "_scaled": _SCALED,
}


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
    return _chunked(function, force_set, ROUTINE_TEXT, f"_{function.routine}")


def _chunked(function, force_set, operations, evaluate):
    """A kernel that hands over to another function, chunk by chunk; with the largest value that is told, if any."""
    names = [a.name for a in function.arguments(force_set)]
    most = ""
    if function.ceiling:
        others = ", ".join(name for name in names if name != function.ceiling.argument)
        told = kernel_name(FUNCTIONS[f"{function.paper}.{function.ceiling.most}"], force_set)
        most = f"    with quiet():\n        most = {told}({others})\n"
    passed = [*names, *(["most"] if most else [])]
    return (
        f"def {kernel_name(function, force_set)}({', '.join(names)}):\n{docstring(function, force_set, operations)}"
        f"{most}    return in_chunks({evaluate}, ({', '.join(passed)}), {len(function.outputs)})\n"
    )


def _primitive_kernel(function, force_set):
    """A kernel that is a primitive; its rest is dropped."""
    (argument,) = (a.name for a in function.arguments(force_set))
    doc = docstring(function, force_set, PRIMITIVE_TEXT.format(function.primitive))
    return (
        f"def {kernel_name(function, force_set)}({argument}):\n"
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
        f'    {operations_text(plan)}\n    """\n{steps}    return Balance(\n{values}    )\n'
    )


def _limit(function, limit):
    """Lines that take out the lanes where the argument is beyond its largest value, which is given, or at it."""
    return [
        f"    void, full = within({function.ceiling.argument}_in, most, void)",
        "    with quiet():",
        f"        there = {call_text(limit.there, '')}",
        "        rho = idle(void | full, rho)",
    ]


def kernel(function, force_set):
    """Return the source of one kernel on scaled pairs.

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
    clashes, undecided = _undecided(function, force_set)
    lines = [
        f"def {kernel_name(function, force_set)}({', '.join([*names, *(['most'] if plan.limit else [])])}):",
        docstring(function, force_set, operations_text(plan)).rstrip("\n"),
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
        f"{indent}{names!r}: {kernel_name(function, force_set)},\n"
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


def _imports(modules, text):
    """Import lines for the names that a text uses."""
    return "".join(
        f"from .{source} import {', '.join(used)}\n"
        for source, names in sorted(modules.items())
        if (used := [name for name in sorted(names) if f"{name}(" in text])
    )


def _infinity(text):
    return "from math import inf\n\n" if re.search(r"\binf\b", text) else ""


def scaled_module(paper):
    """Return the source of one paper's kernels on scaled pairs; "" if it has none."""
    functions = [f for f in FUNCTIONS.values() if f.paper == paper and not (f.routine or f.primitive)]
    text = "\n\n".join(kernel(f, force_set) for f in functions for force_set in f.variants)
    head = f'"""Kernels of the {paper} formulas on scaled pairs, for numbers of any size."""\n\n{_infinity(text)}'
    return f"{head}{_imports(_MODULES, text)}\n\n{text}" if text else ""


def _public_kernel(function, force_set):
    """The kernel of the table: what it is made of depends on the function."""
    if function.routine:
        return _routine_kernel(function, force_set)
    if function.primitive:
        return _primitive_kernel(function, force_set)
    if on_pairs(function):
        return form(function, force_set)
    evaluate = f"{scaled_module_name(function.paper)}.{kernel_name(function, force_set)}"
    return _chunked(function, force_set, operations_text(schedule(function, force_set)), evaluate)


def module(paper):
    """Return the source of one paper's module."""
    functions = [f for f in FUNCTIONS.values() if f.paper == paper]
    text = "\n\n".join(_public_kernel(f, force_set) for f in functions for force_set in f.variants)
    sources = {f"_{f.routine.split('.')[0]}" for f in functions if f.routine}
    sources |= {"special" for f in functions if f.primitive} | {
        scaled_module_name(paper) for f in functions if not (f.routine or f.primitive)
    }
    imports = _imports(_FORM_MODULES, text) + f"from . import {', '.join(sorted(sources))}\n"
    table = "".join(_dispatch(f) for f in functions)
    return (
        f'"""Kernels of the {paper} formulas on float64 arrays."""\n\n{_infinity(text)}{imports}\n\n{text}\n\n'
        "# Number of outputs, index of the angle among the arguments, the kernel for each set of force arguments;\n"
        "# if an argument has a largest value, its index and the kernels of that value.\n"
        f"FUNCTIONS = {{\n{table}}}\n"
    )
