"""The papers' formulas on vectors of pairs: for arguments of ordinary size; other lanes are handed to the scaled form.

Both come from one schedule. Each form is emitted twice: with an array for every argument, and with one value for each
keyword argument, where what depends on those alone is computed once.
"""

from dataclasses import dataclass, field

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen.kernels import CONDITION, TARGETS, table_text
from galileo_sym.codegen.pairs import IN_LANES
from galileo_sym.codegen.printing import counts_text, sources_text
from galileo_sym.codegen.schedule import schedule
from galileo_sym.primitives.tables import TURN_COUNT, TURN_STEP, constants, turn_rows

# Sizes at which no term of a formula over- or underflows, nor what a product leaves.
_ORDINARY = {
    "positive": "gs_between({}, 0x1p-100, 0x1p+100)",
    "nonnegative": "gs_between_or_0({}, 0x1p-100, 0x1p+100)",
    "rate": "gs_between_or_0({}, 0x1p-700, 0x1p+100)",
    "chord angle": "gs_between_or_0(gs_abs({}), 0x1p-100, GS_HALF_TURN_0)",
    "elevation": "gs_between_or_0({}, 0x1p-100, GS_HALF_TURN_0)",
    "chord angle, idle": "gs_at_least(gs_v_of(GS_HALF_TURN_0), gs_abs({}))",
}
_RATES = ("gamma", "k")  # they enter by factors that are 1 where they are small
_FAILING = {"driving": ("good", "held"), "phi0m": ("good",), "range_balance": ("good",)}
_AT_REST = {0.0: "gs_v_of(0.0)", float("inf"): "gs_v_of(INFINITY)"}
ARRAYS, VALUES = "n", "nu"  # the shapes: all arguments arrays; the keyword arguments one value each


def in_lanes(function):
    """Whether a function has forms on vectors: not one that solves, has cases, or is a primitive."""
    return not (function.routine or function.primitive or function.ceiling)


def forms():
    """Return (function, force set) of every form on vectors."""
    return [(f, s) for f in FUNCTIONS.values() if in_lanes(f) for s in f.variants]


def shapes(function):
    """Return the shapes of a function's forms."""
    return (ARRAYS, VALUES) if function.positional and function.keywords else (ARRAYS,)


def scaled_name(function, force_set):
    """Return the C name of the scaled form, for single numbers of any size."""
    return f"gs_scaled_{function.paper}_{function.name}" + (f"_{force_set}" if force_set else "")


def parameters(function, force_set, shape, kind="double"):
    """Return (type, name) of the C parameters of a form."""
    arrays = function.positional if shape == VALUES else [a.name for a in function.arguments(force_set)]
    given = [(f"const {kind} *" if a.name in arrays else f"{kind} ", a.name) for a in function.arguments(force_set)]
    return [("size_t ", "n"), *given, *((f"{kind} *", o.name) for o in function.outputs)]


@dataclass
class _Body:
    """Lines that come before the loop, and those in it; the names of what varies."""

    varying: set
    once: list = field(default_factory=list)
    each: list = field(default_factory=list)
    named: dict = field(default_factory=dict)

    def varies(self, node):
        """Whether a node depends on an array."""
        return node in self.varying if isinstance(node, str) else any(self.varies(o) for o in _operands(node))

    def text(self, node):
        """A node as nested calls; what in it does not vary gets a name before the loop."""
        if isinstance(node, str):
            return node
        if not self.varies(node) and node[0] != "constant":
            return self.before(node)
        return _call(node, [self.text(o) for o in _operands(node)])

    def before(self, node):
        """The name, given once, of what does not vary."""
        if node not in self.named:
            self.named[node] = f"once{len(self.named) + 1}"
            self.once.append(f"    const gs_vp {self.named[node]} = {_nested(node)};")
        return self.named[node]

    def assign(self, name, node):
        """Add an assignment where it belongs."""
        if self.varies(node):
            kind = "gs_turn" if node[0] == "angle" else "gs_vp"
            self.each.append(f"        const {kind} {name} = {self.text(node)};")
            self.varying.add(name)
        else:
            self.once.append(f"    const gs_vp {name} = {_nested(node)};")


def _operands(node):
    """The operands of a node that are nodes."""
    return () if isinstance(node, str) else tuple(o for o in node[1:] if isinstance(o, str | tuple))


def _nested(node):
    return node if isinstance(node, str) else _call(node, [_nested(o) for o in _operands(node)])


def _call(node, operands):
    if node[0] == "scale":
        return f"gs_vp_scaled({operands[0]}, {float(2) ** node[2]!r})"
    if node[0] == "constant":
        return f"gs_vp_constant({node[1]!r})"
    return f"gs_vp_{node[0]}({', '.join([*operands, *(f'&{mask}' for mask in _FAILING.get(node[0], ()))])})"


def _test(argument, plan, angles):
    """Whether an argument is of ordinary size."""
    domain = "rate" if argument.name in _RATES else argument.domain
    idle = argument.name in angles and not any(node[0] == "angle" for _, node in plan.steps)
    return _ORDINARY[domain + ", idle" * idle].format(f"{argument.name}_here")


def _masks(name, start, arguments, plan):
    """Lines that make a mask of lanes that are of ordinary size."""
    tests = [_test(a, plan, ("theta",)) for a in arguments]
    tests = ([start] if start else []) + tests
    lines = [f"gs_mask {name} = {tests[0]};"]
    return lines + [f"{name} = gs_both({name}, {test});" for test in tests[1:]]


def _loads(arguments, plan, mask):
    """Lines that take arguments as pairs: 1 in lanes that are not served."""
    used = [a for a in arguments if a.symbol in plan.loads]
    return [f"const gs_vp {a.symbol} = gs_vp_load(gs_select({mask}, {a.name}_here, one));" for a in used]


def _indented(depth, lines):
    return ["    " * depth + line for line in lines]


def _handed_on(function, force_set, arrays):
    """Lines that compute the lanes that are not served by the scaled form."""
    arguments = [f"{a.name}_in{'[j]' * (a.name in arrays)}" for a in function.arguments(force_set)]
    names = [o.name for o in function.outputs]
    call = f"{scaled_name(function, force_set)}({', '.join(arguments)}"
    single = f"{names[0]}_each[j] = {call});"
    several = f"{call}, {', '.join(f'{name}_each + j' for name in names)});"
    return [
        "if (!gs_all(good)) {",
        f"    double {', '.join(f'{name}_each[GS_LANES]' for name in names)};",
        *(f"    gs_v_store({name}_each, {name}_here);" for name in names),
        "    for (size_t j = 0; j < here; j++)",
        "        if (!(gs_bits_of(good) >> j & 1))",
        f"            {single if len(names) == 1 else several}",
        *(f"    {name}_here = gs_v_load({name}_each);" for name in names),
        "}",
    ]


def form(function, force_set, shape):
    """Return the C definition of a form, its name ending in GS_SUFFIX.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.
    shape : str
        One of `shapes`.
    """
    plan = schedule(function, force_set)
    arguments = function.arguments(force_set)
    arrays = [a for a in arguments if shape == ARRAYS or a.name in function.positional]
    values = [a for a in arguments if a not in arrays]
    outputs = [o.name for o in function.outputs]
    kinds = [kind for kind, _ in parameters(function, force_set, shape)]
    names = ["count", *(f"{a.name}_in" for a in arguments), *(f"{o}_out" for o in outputs)]
    held = any(node[0] == "driving" for _, node in plan.steps)
    body = _Body({a.symbol for a in arrays if a.symbol in plan.loads} | {"theta_used"})
    for name, node in plan.steps:
        body.assign(name, ("angle", "theta_used") if node[0] == "angle" else node)
    results = [f"({body.text(node)}).hi" for node in plan.results]
    if held:
        results = [
            f"gs_select(held, {_AT_REST[o.at_rest]}, {r})" for o, r in zip(function.outputs, results, strict=True)
        ]
    turned = any(node[0] == "angle" for _, node in plan.steps)
    count = len(arrays) + len(outputs)
    lines = [
        f"void GS_JOIN({name_of(function, force_set)}_{shape}, GS_SUFFIX)("
        + ", ".join(f"{kind}{name}" for kind, name in zip(kinds, names, strict=True))
        + ")",
        "{",
        f"    double pad[{count}][GS_LANES];",
        "    const gs_v one = gs_v_of(1.0);",
        *_indented(1, [f"const gs_v {a.name}_here = gs_v_of({a.name}_in);" for a in values]),
        *_indented(1, _masks("known", "", values, plan) if values else []),
        *_indented(1, _loads(values, plan, "known")),
        *body.once,
        "    while (count > 0) {",
        "        const size_t here = count < GS_LANES ? count : GS_LANES;",
        "        if (here < GS_LANES) {",
        *_indented(3, [f"{a.name}_in = gs_padded(pad[{i}], {a.name}_in, here);" for i, a in enumerate(arrays)]),
        "        }",
        *_indented(2, [f"const gs_v {a.name}_here = gs_v_load({a.name}_in);" for a in arrays]),
        *_indented(2, _masks("good", "known" if values else "", arrays, plan)),
        *_indented(2, _loads(arrays, plan, "good")),
        *_indented(2, ["const gs_v theta_used = gs_select(good, theta_here, one);"] * turned),
        *_indented(2, ["gs_mask held;"] * held),
        *body.each,
        *_indented(2, [f"gs_v {name}_here = {r};" for name, r in zip(outputs, results, strict=True)]),
        *_indented(2, _handed_on(function, force_set, [a.name for a in arrays])),
        "        if (here < GS_LANES) {",
    ]
    for i, name in enumerate(outputs, len(arrays)):
        lines.append(f"            gs_v_store(pad[{i}], {name}_here);")
        lines.append(f"            memcpy({name}_out, pad[{i}], here * sizeof *{name}_out);")
    advanced = ", ".join(
        f"{name} += GS_LANES" for name in [*(f"{a.name}_in" for a in arrays), *names[len(arguments) + 1 :]]
    )
    lines += [
        "            return;",
        "        }",
        *_indented(2, [f"gs_v_store({name}_out, {name}_here);" for name in outputs]),
        f"        count -= GS_LANES, {advanced};",
        "    }",
        "}",
    ]
    head = f"/* {sources_text(function, force_set)}.\n * Operations: {counts_text(plan)}. */\n"
    return head + "\n".join(line for line in lines) + "\n"


def name_of(function, force_set):
    """Return the C name of a form without its ending; an empty force set gives the unsuffixed one."""
    return f"gs_{function.paper}_{function.name}" + (f"_{force_set}" if force_set else "")


def turn_tables():
    """Return the tables of sine and cosine at the multiples of a step, and pi/2 as a sum of doubles."""
    half = constants()["half_pi"]
    rows = turn_rows()
    columns = {"sine": 0, "sine_lo": 1, "cosine": 2, "cosine_lo": 3}
    tables = "".join(table_text("turn", name, tuple(row[i] for row in rows)) for name, i in columns.items())
    macros = "".join(f"#define GS_HALF_TURN_{i} {half[i].hex()}\n" for i in range(3))
    return (
        f"#define GS_QUARTER_TURN {(half[0] / 2).hex()}\n{macros}"
        f"#define GS_TURN_STEP {TURN_STEP.hex()}\n#define GS_TURNS_A_RADIAN {(1 / TURN_STEP).hex()}\n"
        f"/* Sine and cosine of 0 to {TURN_COUNT - 1} steps. */\n{tables}"
    )


def factors():
    """Return the calls of the primitives that formulas use, on vectors of pairs."""
    return "".join(
        f"static inline gs_vp gs_vp_{name}(gs_vp x)\n{{\n    gs_vp r;\n"
        f"    r.hi = gs_{name}_lanes(x.hi, x.lo, &r.lo);\n    return r;\n}}\n\n"
        for name in IN_LANES
    )


def scaled_header():
    """Return the C header of the scaled forms."""
    out = [
        "#ifndef GALILEO_SCALED_H\n#define GALILEO_SCALED_H\n\n"
        "/* The formulas on scaled pairs: for single numbers of any size, where the forms on vectors do not serve. */\n"
    ]
    for function, force_set in forms():
        given = [f"double {a.name}" for a in function.arguments(force_set)]
        given += [] if len(function.outputs) == 1 else [f"double *{o.name}" for o in function.outputs]
        kind = "double" if len(function.outputs) == 1 else "void"
        out.append(f"{kind} {scaled_name(function, force_set)}({', '.join(given)});\n")
    return "".join([*out, "\n#endif\n"])


def forms_header():
    """Return the C header that defines all forms for a source that has set GS_LANES and GS_SUFFIX."""
    definitions = "\n".join(form(f, s, shape) for f, s in forms() for shape in shapes(f))
    return (
        "#ifndef GALILEO_FORMS_H\n#define GALILEO_FORMS_H\n\n"
        f'#include "galileo_lanes.h"\n#include "galileo_scaled.h"\n\n{definitions}\n#endif\n'
    )


def declarations(suffix):
    """Return the declarations of one version of all forms."""
    return "".join(signature(f, s, shape, f"_{suffix}") + ";\n" for f, s in forms() for shape in shapes(f))


def signature(function, force_set, shape, ending="", public=None):
    """Return the C signature of a form; ``public`` is the force set in its name, if that is another."""
    given = ", ".join("".join(pair) for pair in parameters(function, force_set, shape))
    name = name_of(function, force_set if public is None else public)
    return f"void {name}_{shape}{ending}({given})"


def _chooser(function, force_set, shape, public):
    names = ", ".join(name for _, name in parameters(function, force_set, shape))
    return (
        f"{signature(function, force_set, shape, public=public)}\n{{\n"
        f"    GS_CHOOSE({name_of(function, force_set)}_{shape})({names});\n}}\n\n"
    )


def _scalar(function, force_set, public):
    given = [f"double {a.name}" for a in function.arguments(force_set)]
    passed = [f"&{a.name}" for a in function.arguments(force_set)]
    call = f"GS_CHOOSE_SINGLE({name_of(function, force_set)}_{ARRAYS})"
    name = name_of(function, public)
    if len(function.outputs) == 1:
        (output,) = function.outputs
        return (
            f"double {name}({', '.join(given)})\n{{\n    double {output.name};\n"
            f"    {call}(1, {', '.join([*passed, f'&{output.name}'])});\n    return {output.name};\n}}\n\n"
        )
    outputs = [o.name for o in function.outputs]
    given += [f"double *{o}" for o in outputs]
    return f"void {name}({', '.join(given)})\n{{\n    {call}(1, {', '.join([*passed, *outputs])});\n}}\n\n"


def public_source(template):
    """Return the source of the public functions, which choose a version."""
    out = []
    for function, force_set in forms():
        fullest = max(function.variants, key=lambda s: len(function.variants[s][0]))
        for public in dict.fromkeys([force_set, *([""] if force_set == fullest else [])]):
            out.append(_scalar(function, force_set, public))
            out += [_chooser(function, force_set, shape, public) for shape in shapes(function)]
    declared = "".join(map(declarations, TARGETS))
    words = {"@CONDITION@": CONDITION, "@DECLARED@\n": declared, "@PUBLIC@\n": "".join(out).rstrip("\n") + "\n"}
    for word, text in words.items():
        template = template.replace(word, text)
    return template
