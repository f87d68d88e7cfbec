"""The C99 back end: one source a paper, and the public header."""

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen import lanes
from galileo_sym.codegen.printing import (
    PRIMITIVE_TEXT,
    ROUTINE_TEXT,
    call_text,
    operations_text,
    sources_text,
    undecided_text,
)
from galileo_sym.codegen.schedule import balance_name, schedule
from galileo_sym.codegen.signatures import (
    ARRAYS,
    VALUES,
    array_signature,
    fullest,
    is_single,
    letter,
    name_of,
    scalar_signature,
    scaled_name,
    variants,
    widened_signature,
)
from galileo_sym.solvers import SOLVERS

_DOMAIN_TESTS = {
    "positive": "gs_positive",
    "nonnegative": "gs_nonnegative",
    "chord angle": "gs_chord_angle",
    "elevation": "gs_elevation",
}
_DECIDED = "0"
_TYPES = {"angle": "gs_direction", "decay": "gs_decay_values", "launch": "gs_angles"}
_AT_REST = {0.0: "0.0", float("inf"): "INFINITY"}


def _scalar_signature(function, suffix, force_set, kind):
    return scalar_signature(function, force_set, kind, name_of(function, suffix, letter(kind)))


def _array_signature(function, suffix, force_set, kind):
    return array_signature(function, force_set, ARRAYS, kind, public=suffix)


def _signatures(function, suffix, force_set):
    for kind in ("double", "float"):
        yield _scalar_signature(function, suffix, force_set, kind)
        yield _array_signature(function, suffix, force_set, kind)
        if lanes.takes_values(function):
            yield array_signature(function, force_set, VALUES, kind, public=suffix)


def _guard(function, condition, value):
    """Lines that give every output the same value and return, under a condition."""
    if is_single(function):
        return [f"    if ({condition})", f"        return {value};"]
    targets = " = ".join(f"*{o.name}_out" for o in function.outputs)
    return [f"    if ({condition}) {{", f"        {targets} = {value};", "        return;", "    }"]


def _any(conditions):
    conditions = list(conditions)
    return conditions[0] if len(conditions) == 1 else f"({' || '.join(conditions)})"


def _result(function, force_set, output, node):
    value = call_text(node, "gs_")
    undecided = undecided_text(function, force_set, output, _clash, "({0}_in == 0.0 ? {1} : {2})".format)
    return f"gs_store({value})" if undecided == _DECIDED else f"gs_settle({value}, {undecided})"


def _clash(pairs):
    """Condition under which arguments of both groups of a pair are infinite."""
    seen = [[_any(f"isinf({n}_in)" for n in group) for group in pair] for pair in pairs]
    return _any(f"({one} && {other})" for one, other in seen) if pairs else _DECIDED


def _routine_kernel(function, force_set):
    """A kernel that hands over to a function of the templates."""
    passed = [a.name for a in function.arguments(force_set)]
    passed += [] if is_single(function) else [o.name for o in function.outputs]
    name = f"gs_{function.routine.split('.')[1]}"
    return (
        f"/* {sources_text(function, force_set)}.\n * {ROUTINE_TEXT} */\n"
        f"{scalar_signature(function, force_set, 'double', scaled_name(function, force_set))}\n{{\n"
        f"    {'return ' * is_single(function)}{name}({', '.join(passed)});\n}}\n"
    )


def _primitive_kernels(function):
    """All four functions of one that is a primitive."""
    (force_set,) = function.variants
    (argument,), (output,) = function.arguments(force_set), function.outputs
    head = f"/* {sources_text(function, force_set)}.\n * {PRIMITIVE_TEXT.format(function.primitive)} */\n"
    called = f"gs_special_{function.primitive}"
    return head + "".join(
        f"{signature}\n{{\n    {call}\n}}\n"
        for kind in ("double", "float")
        for signature, call in (
            (_scalar_signature(function, "", force_set, kind), f"return {called}{letter(kind)}({argument.name});"),
            (
                _array_signature(function, "", force_set, kind),
                f"{called}_n{letter(kind)}(n, {argument.name}, {output.name});",
            ),
        )
    )


def _assignment(name, node):
    return f"    const {_TYPES.get(node[0], 'gs_scaled')} {name} = {call_text(node, 'gs_')};"


def _balance(name, plan, unknown):
    """Definition of what a solver evaluates in each of its steps."""
    parameters = ", ".join(f"gs_scaled {symbol}" for symbol in unknown)
    values = "".join(f"        {call_text(node, 'gs_')},\n" for node in plan.results)
    lines = [
        f"/* The {', '.join(plan.names)} of the equation that is solved.",
        f" * {operations_text(plan)} */",
        f"static gs_balance {name}({parameters})",
        "{",
        *(_assignment(*step) for step in plan.steps),
        f"    const gs_balance at = {{\n{values}    }};",
        "    return at;",
        "}",
    ]
    return "\n".join(lines) + "\n\n"


def _most_name(function, force_set, kind):
    return f"gs_most_of_{function.name}_{force_set}{letter(kind)}"


def _others(function, force_set):
    """Names of the arguments but for the one that has a largest value."""
    return [a.name for a in function.arguments(force_set) if a.name != function.ceiling.argument]


def _most(function, force_set):
    """Definitions of the largest value of an argument, of both types, as the public function gives it."""
    others, public = _others(function, force_set), FUNCTIONS[f"{function.paper}.{function.ceiling.most}"]
    taken = {kind: ", ".join(f"{kind} {name}" for name in others) for kind in ("double", "float")}
    return "/* The largest value that is told, without flags: it is only compared with. */\n" + "".join(
        f"static inline {kind} {_most_name(function, force_set, kind)}({taken[kind]})\n{{\n"
        f"    fenv_t flags;\n    feholdexcept(&flags);\n"
        f"    const volatile {kind} most = {name_of(public, force_set, letter(kind))}({', '.join(others)});\n"
        f"    fesetenv(&flags);\n    return most;\n}}\n"
        for kind in taken
    )


def _limit(function, force_set, limit):
    """Lines that return where the argument is beyond its largest value, or at it."""
    raw = f"{function.ceiling.argument}_in"
    passed = ", ".join(f"{name}_in" for name in _others(function, force_set))
    return [
        f"    const double most = {_most_name(function, force_set, 'double')}({passed});",
        *_guard(function, f"isinf({raw}) || {raw} > most", "gs_invalid()"),
        *_guard(function, f"{raw} == most && {raw} > 0.0", f"gs_store({call_text(limit.there, 'gs_')})"),
    ]


def kernel(function, force_set):
    """Return the definition of one scalar kernel of doubles.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.
    """
    if function.routine:
        return _routine_kernel(function, force_set)
    if function.primitive:
        return _primitive_kernels(function)
    plan = schedule(function, force_set)
    arguments = function.arguments(force_set)
    symbols = {a.symbol: a.name for a in arguments}
    head = scalar_signature(function, force_set, "double", scaled_name(function, force_set), "{}_in", "{}_out")
    missing = " || ".join(f"isnan({a.name}_in)" for a in arguments)
    inside = " && ".join(f"{_DOMAIN_TESTS[a.domain]}({a.name}_in)" for a in arguments)
    lines = [
        f"/* {sources_text(function, force_set)}.",
        f" * {operations_text(plan)} */",
        head,
        "{",
        *_guard(function, missing, "NAN"),
        *_guard(function, f"!({inside})", "gs_invalid()"),
        *(f"    const gs_scaled {s} = gs_load({symbols[s]}_in);" for s in plan.loads),
    ]
    for index, (name, node) in enumerate(plan.steps):
        if plan.limit and index == plan.limit.after:
            lines += _limit(function, force_set, plan.limit)
        lines.append(_assignment(name, ("angle", f"{symbols[node[1]]}_in") if node[0] == "angle" else node))
        if node[0] == "driving":
            lines += _guard(function, f"{name}.hi <= 0.0", _AT_REST[function.outputs[0].at_rest])
    results = [_result(function, force_set, o, r) for o, r in zip(function.outputs, plan.results, strict=True)]
    if is_single(function):
        lines.append(f"    return {results[0]};")
    else:
        lines += [f"    *{o.name}_out = {r};" for o, r in zip(function.outputs, results, strict=True)]
    text = "\n".join(lines) + "\n}\n"
    if function.ceiling:
        text = f"{_most(function, force_set)}\n{_widened(function, force_set)}\n{text}"
    if plan.balance:
        unknown = SOLVERS[function.full_name, force_set].unknown
        return _balance(balance_name(function, force_set), plan.balance, unknown) + text
    return text


def _widened(function, force_set):
    """Definition of what makes a double of the float that has a largest value."""
    others = ", ".join(_others(function, force_set))
    single, double = (f"{_most_name(function, force_set, kind)}({others})" for kind in ("float", "double"))
    call = f"gs_widen_to({function.ceiling.argument}, {single}, {double})"
    return f"{widened_signature(function, force_set)}\n{{\n    return {call};\n}}\n"


def source(paper):
    """Return the C source of one paper."""
    parts = []
    for function in (f for f in FUNCTIONS.values() if f.paper == paper):
        parts += [kernel(function, force_set) for force_set in function.variants]
    return '#include "galileo.h"\n#include "galileo_scaled.h"\n#include "galileo_support.h"\n\n' + "\n".join(parts)


def _comment(function):
    arguments = "\n".join(f" *   {a.name} [{a.unit}]: {a.doc}" for a in function.arguments(fullest(function)))
    outputs = "\n".join(f" *   {o.name} [{o.unit}]: {o.doc}" for o in function.outputs)
    sources = "\n".join(f" *   {s or 'only form'}: {', '.join(function.sources(s))}" for s in function.variants)
    rest = {o.at_rest for o in function.outputs} - {None}
    accuracy = function.accuracy.replace("\n", "\n *   ")
    held = f" * Where friction holds the bead: {max(rest):g}, without a flag.\n" if rest else ""
    return (
        f"/* {function.doc}\n *\n * Arguments\n{arguments}\n * Result{'s' * (len(function.outputs) > 1)}\n{outputs}\n"
        f" * Measured: {accuracy}.\n{held} * Equations\n{sources}\n */\n"
    )


def declarations():
    """Return the prototypes of all functions, each group with its documentation."""
    out = []
    for function in FUNCTIONS.values():
        out.append(_comment(function))
        for suffix, force_set in variants(function):
            out += [f"{signature};\n" for signature in _signatures(function, suffix, force_set)]
        out.append("\n")
    return "".join(out)
