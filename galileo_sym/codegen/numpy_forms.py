"""The papers' formulas on NumPy's pairs, for arguments of ordinary size; other lanes are handed to the scaled kernels.

As in C each form is emitted twice: with an array for every argument, and with one value for each keyword argument,
where what depends on those alone is computed once.
"""

from galileo_sym.codegen import lanes
from galileo_sym.codegen.arithmetic import is_rate, size_of
from galileo_sym.codegen.hoisting import hoisted
from galileo_sym.codegen.printing import call_text, operations_text, sources_text
from galileo_sym.codegen.schedule import schedule

_WITH_LANES = ("driving", "phi0m", "range_balance")  # not good, or at rest, in some lanes
_SCALED_MODULE = "_scaled_{}"


def on_pairs(function):
    """Whether a function is computed on plain pairs here: of those on vectors in C, not one that solves an equation."""
    return lanes.in_lanes(function) and not (function.ceiling or function.routine)


def kernel_name(function, force_set):
    """Return the name of a kernel."""
    return f"{function.name}_{force_set}" if force_set else function.name


def docstring(function, force_set, operations):
    """Return the indented docstring of a kernel."""
    arguments = "\n".join(f"    {a.name} [{a.unit}]: {a.doc}" for a in function.arguments(force_set))
    results = "\n".join(f"    {o.name} [{o.unit}]: {o.doc}" for o in function.outputs)
    return (
        f'    """{function.doc}\n\n{arguments}\n\n    Returns\n{results}\n\n'
        f"    From {sources_text(function, force_set)}.\n"
        f'    {operations}\n    """\n'
    )


def scaled_module_name(paper):
    """Return the name of the module of a paper's scaled kernels."""
    return _SCALED_MODULE.format(paper)


def _told(node):
    """A node with the lanes among the operands of what tells them."""
    if not isinstance(node, tuple):
        return node
    node = (node[0], *(_told(operand) for operand in node[1:]))
    return (*node, "lanes") if node[0] in _WITH_LANES else node


def _assignments(steps, indent):
    return [f"{indent}{name} = {call_text(_told(node), '')}" for name, node in steps]


def _loads(arguments, plan, indent):
    loaded = [a for a in arguments if a.symbol in plan.loads]
    return [f"{indent}{a.symbol} = {'rate' if is_rate(a) else 'load'}({a.name})" for a in loaded]


def _results(function, plan, nodes, indent):
    """The line that returns the outputs."""
    held = any(node[0] == "driving" for _, node in plan.steps)
    texts = [f"{call_text(_told(node), '')}.x" for node in nodes]
    if held:
        rests = ["inf" if o.at_rest == float("inf") else repr(o.at_rest) for o in function.outputs]
        texts = [f"lanes.rested({text}, {rest})" for text, rest in zip(texts, rests, strict=True)]
    return f"{indent}return ({', '.join(texts)},)"


def _body(function, force_set, varying):
    """Lines for the values, and for the arrays, of one form."""
    plan = schedule(function, force_set)
    arguments = function.arguments(force_set)
    arrays = [a for a in arguments if a.name in varying]
    values = [a for a in arguments if a.name not in varying]
    names = {a.symbol for a in arrays if a.symbol in plan.loads} | {a.name for a in arrays if a.unit == "rad"}
    parts = hoisted(plan.steps, plan.results, names)
    indent = "        " if values else "    "
    each = [*_loads(arrays, plan, indent), *_assignments(parts.each, indent)]
    each.append(_results(function, plan, parts.results, indent))
    return [*_loads(values, plan, "    "), *_assignments(parts.before, "    ")], each


def _of_arrays(function, force_set, name):
    """The function of arrays for all arguments."""
    names = [a.name for a in function.arguments(force_set)]
    _, lines = _body(function, force_set, names)
    return [f"def {name}({', '.join(names)}, lanes):", *lines, "", ""]


def _of_values(function, force_set, name):
    """The function of values for the keyword arguments, which gives that of arrays for the others."""
    values = [a.name for a in function.arguments(force_set) if a.name not in function.positional]
    before, lines = _body(function, force_set, function.positional)
    return [
        f"def {name}({', '.join(values)}):",
        *before,
        *([""] if before else []),
        f"    def each({', '.join(function.positional)}, lanes):",
        *lines,
        "",
        "    return each",
        "",
        "",
    ]


def form(function, force_set):
    """Return the source of a form and of its kernel.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.
    """
    plan = schedule(function, force_set)
    arguments = function.arguments(force_set)
    name = kernel_name(function, force_set)
    arrays, values, row = f"_{name}_arrays", f"_{name}_values", f"_{name.upper()}"
    turned = any(node[0] == "angle" for _, node in plan.steps)
    sizes = "".join(f'"{size_of(a, turned)}", ' for a in arguments).rstrip()
    names = "".join(f"{a.name}, " for a in arguments).rstrip()
    if len(arguments) > 1:
        sizes, names = sizes.rstrip(","), names.rstrip(",")
    by_values = lanes.takes_values(function)
    text = [
        *_of_arrays(function, force_set, arrays),
        *(_of_values(function, force_set, values) if by_values else []),
        f"{row} = Form(",
        f"    sizes=({sizes}),",
        f"    outputs={len(function.outputs)},",
        f"    positional={len(function.positional)},",
        f"    arrays={arrays},",
        f"    values={values if by_values else None},",
        f"    scaled={scaled_module_name(function.paper)}.{name},",
        ")",
        "",
        "",
        f"def {name}({names.rstrip(',')}):",
        docstring(function, force_set, operations_text(plan)).rstrip("\n"),
        f"    return serve({row}, ({names}))",
    ]
    return "\n".join(text) + "\n"
