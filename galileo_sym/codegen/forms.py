"""The text of the papers' formulas on vectors: on pairs of doubles, and for binary32 in plain double arithmetic.

For arguments of ordinary size; other lanes are handed to the scaled form, which comes from the same schedule. Each form
is emitted twice: with an array for every argument, and with one value for each keyword argument, where what depends on
those alone is computed once.
"""

from dataclasses import dataclass

from galileo_sym.codegen.hoisting import hoisted, operands_of
from galileo_sym.codegen.lane_steps import lane_schedule, told_name
from galileo_sym.codegen.printing import counts_text, sources_text
from galileo_sym.codegen.signatures import ARRAYS, is_single, letter, name_of, parameters, scaled_name, widened_name

_AT_REST = {0.0: "gs_v_of(0.0)", float("inf"): "gs_v_of(INFINITY)"}
_FAILING = {"driving": ("good", "held")} | dict.fromkeys(("below", "arctangent", "shot", "launch"), ("good",))


@dataclass(frozen=True)
class Arithmetic:
    """How a form computes: C types, what its operations begin with, and which of them may fail in a lane.

    ``kind`` is the type of arguments and results; ``number`` the type of values, ``types`` those of what certain nodes
    give. ``load``, ``store``, ``padded`` name what moves vectors; ``taken`` makes a number of a lane's argument,
    ``rate`` of one that is a rate, ``value`` a lane's result of a number; ``widened`` makes a double of an argument for
    the scaled form. ``ordinary`` tests arguments by domain; ``failing`` gives the masks that an operation changes.
    """

    kind: str
    prefix: str
    number: str
    types: dict
    load: str
    store: str
    padded: str
    taken: str
    rate: str
    value: str
    widened: dict
    ordinary: dict
    failing: dict


DOUBLE = Arithmetic(
    kind="double",
    prefix="gs_vp_",
    number="gs_vp",
    types={"angle": "gs_turn", "shot": "gs_vp_best", "launch": "gs_vp_angles"},
    load="gs_v_load",
    store="gs_v_store",
    padded="gs_padded",
    taken="gs_vp_load({})",
    rate="gs_vp_load(gs_felt({}))",
    value="gs_vp_value({})",
    widened={},
    ordinary={  # no term of a formula over- or underflows, nor what a product leaves
        "positive": "gs_between({}, 0x1p-100, 0x1p+100)",
        "nonnegative": "gs_between_or_0({}, 0x1p-100, 0x1p+100)",
        "rate": "gs_between({}, 0.0, 0x1p+100)",
        "chord angle": "gs_between_or_0(gs_abs({}), 0x1p-100, GS_HALF_TURN_0)",
        "elevation": "gs_between_or_0({}, 0x1p-100, GS_HALF_TURN_0)",
        "chord angle, idle": "gs_at_least(gs_v_of(GS_HALF_TURN_0), gs_abs({}))",
    },
    failing=_FAILING | {"phi0m": ("good",), "range_balance": ("good",)},
)
SINGLE = Arithmetic(
    kind="float",
    prefix="gs_s_",
    number="gs_v",
    types={"angle": "gs_turn_single", "shot": "gs_best", "launch": "gs_s_angles"},
    load="gs_v_widen",
    store="gs_v_narrow",
    padded="gs_padded_single",
    taken="{}",
    rate="{}",
    value="{}",
    widened={"chord angle": "gs_wide_angle({})", "elevation": "gs_wide_angle({})"},
    ordinary={
        "positive": "gs_between({}, 0x1p-149, 0x1p+128)",
        "nonnegative": "gs_between({}, 0.0, 0x1p+128)",
        "rate": "gs_between({}, 0.0, 0x1p+128)",
        "chord angle": "gs_between(gs_abs({}), 0.0, GS_HALF_TURN_SINGLE)",
        "elevation": "gs_between({}, 0.0, GS_HALF_TURN_SINGLE)",
        "chord angle, idle": "gs_between(gs_abs({}), 0.0, GS_HALF_TURN_SINGLE)",
    },
    failing=_FAILING | {"add": ("good",), "sub": ("good",)},
)


def is_rate(argument):
    """Whether an argument enters by factors that are 1 where it is small, so that 0 stands for the smallest."""
    return argument.name in ("gamma", "k")


def size_of(argument, turned):
    """Return which test tells whether an argument is of ordinary size: a key of ``Arithmetic.ordinary``.

    ``turned`` says whether the form has a sine or cosine; if not, an angle needs only be one.
    """
    return "rate" if is_rate(argument) else argument.domain + ", idle" * (argument.unit == "rad" and not turned)


def _call_text(node, arithmetic, good):
    """A node as nested calls; good is the mask of lanes that its operations may change."""
    if isinstance(node, str):
        return node
    prefix = arithmetic.prefix
    if node[0] == "constant":
        return f"{prefix}constant({node[1]!r})"
    operands = [_call_text(operand, arithmetic, good) for operand in operands_of(node)]
    if node[0] == "scale":
        return f"{prefix}scaled({operands[0]}, {float(2) ** node[2]!r})"
    masks = [f"&{good if mask == 'good' else mask}" for mask in arithmetic.failing.get(node[0], ())]
    return f"{prefix}{node[0]}({', '.join([*operands, *masks])})"


class _Form:
    """What the parts of a form's text need to know."""

    def __init__(self, function, force_set, shape, arithmetic):
        self.function, self.force_set, self.shape, self.arithmetic = function, force_set, shape, arithmetic
        self.plan = lane_schedule(function, force_set)
        self.arguments = function.arguments(force_set)
        self.arrays = [a for a in self.arguments if shape == ARRAYS or a.name in function.positional]
        self.values = [a for a in self.arguments if a not in self.arrays]
        self.outputs = [o.name for o in function.outputs]
        made = {node[0] for _, node in self.plan.steps}
        self.turned, self.held = "angle" in made, "driving" in made

    def head(self):
        """The comment, and the signature."""
        given = parameters(self.function, self.force_set, self.shape, self.arithmetic.kind)
        names = ["count", *(f"{a.name}_in" for a in self.arguments), *(f"{o}_out" for o in self.outputs)]
        signature = ", ".join(f"{kind}{name}" for (kind, _), name in zip(given, names, strict=True))
        name = f"{name_of(self.function, self.force_set)}_{self.shape}{letter(self.arithmetic.kind)}"
        return [
            f"/* {sources_text(self.function, self.force_set)}.",
            f" * Operations: {counts_text(self.plan)}. */",
            f"void GS_JOIN({name}, GS_SUFFIX)({signature})",
        ]

    def masks(self, name, start, arguments):
        """Lines that make a mask of lanes that are of ordinary size."""
        tests = [*start, *map(self._test, arguments)]
        return [f"gs_mask {name} = {tests[0]};"] + [f"{name} = gs_both({name}, {test});" for test in tests[1:]]

    def _test(self, argument):
        return self.arithmetic.ordinary[size_of(argument, self.turned)].format(f"{argument.name}_here")

    def loads(self, arguments, mask):
        """Lines that take arguments as numbers: 1 in lanes that are not served."""
        lines = []
        for a in (a for a in arguments if a.symbol in self.plan.loads):
            taken = self.arithmetic.rate if is_rate(a) else self.arithmetic.taken
            number = taken.format(f"gs_select({mask}, {a.name}_here, one)")
            lines.append(f"const {self.arithmetic.number} {told_name(self.function, a.symbol)} = {number};")
        turned = self.turned and any(a.name == "theta" for a in arguments)
        return lines + ["const gs_v theta_used = gs_select(good, theta_here, one);"] * turned

    def hoisted(self):
        """The operations, divided; an angle is that of the lanes that are served."""
        steps = [(name, ("angle", "theta_used") if node[0] == "angle" else node) for name, node in self.plan.steps]
        loaded = [a.symbol for a in self.arrays if a.symbol in self.plan.loads]
        varying = {told_name(self.function, symbol) for symbol in loaded} | {"theta_used"}
        return hoisted(steps, self.plan.results, varying)

    def assignments(self, steps, good):
        """Lines that give nodes their names."""
        kinds = self.arithmetic.types
        return [
            f"const {kinds.get(node[0], self.arithmetic.number)} {name} = {_call_text(node, self.arithmetic, good)};"
            for name, node in steps
        ]

    def results(self, nodes):
        """Lines that name the outputs."""
        results = [self.arithmetic.value.format(_call_text(node, self.arithmetic, "good")) for node in nodes]
        if self.held:
            rests = [_AT_REST[o.at_rest] for o in self.function.outputs]
            results = [f"gs_select(held, {rest}, {r})" for rest, r in zip(rests, results, strict=True)]
        return [f"gs_v {name}_here = {r};" for name, r in zip(self.outputs, results, strict=True)]

    def _widened(self, lanes):
        """The arguments of a lane in double; the float next to a largest value counts as that."""
        ceiling = self.function.ceiling
        for a, lane in zip(self.arguments, lanes, strict=True):
            if self.arithmetic is SINGLE and ceiling and ceiling.argument == a.name:
                yield f"{widened_name(self.function, self.force_set)}({', '.join(lanes)})"
            else:
                yield self.arithmetic.widened.get(a.domain, "{}").format(lane)

    def handed_on(self):
        """Lines that compute the lanes that are not served by the scaled form."""
        lanes = [f"{a.name}_in" + "[j]" * (a in self.arrays) for a in self.arguments]
        call = f"{scaled_name(self.function, self.force_set)}({', '.join(self._widened(lanes))}"
        single = f"{self.outputs[0]}_each[j] = {call});"
        several = f"{call}, {', '.join(f'{name}_each + j' for name in self.outputs)});"
        return [
            "if (!gs_all(good)) {",
            f"    double {', '.join(f'{name}_each[GS_LANES]' for name in self.outputs)};",
            *(f"    gs_v_store({name}_each, {name}_here);" for name in self.outputs),
            "    for (size_t j = 0; j < here; j++)",
            "        if (!(gs_bits_of(good) >> j & 1))",
            f"            {single if is_single(self.function) else several}",
            *(f"    {name}_here = gs_v_load({name}_each);" for name in self.outputs),
            "}",
        ]

    def pads(self):
        """Lines that take the last lanes, fewer than a vector, from copies."""
        moves = [
            f"{a.name}_in = {self.arithmetic.padded}(pad[{i}], {a.name}_in, here);" for i, a in enumerate(self.arrays)
        ]
        return ["if (here < GS_LANES) {", *(f"    {move}" for move in moves), "}"]

    def stores(self):
        """Lines that write the results, and go on."""
        store, ends = self.arithmetic.store, []
        for i, name in enumerate(self.outputs, len(self.arrays)):
            ends.append(f"    {store}(pad[{i}], {name}_here);")
            ends.append(f"    memcpy({name}_out, pad[{i}], here * sizeof *{name}_out);")
        moved = [*(f"{a.name}_in" for a in self.arrays), *(f"{name}_out" for name in self.outputs)]
        return [
            "if (here < GS_LANES) {",
            *ends,
            "    return;",
            "}",
            *(f"{store}({name}_out, {name}_here);" for name in self.outputs),
            f"count -= GS_LANES, {', '.join(f'{name} += GS_LANES' for name in moved)};",
        ]


def _indented(depth, lines):
    return ["    " * depth + line for line in lines]


def definition(function, force_set, shape, arithmetic):
    """Return the C definition of a form, its name ending in GS_SUFFIX.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.
    shape : str
        ``ARRAYS`` or ``VALUES``.
    arithmetic : Arithmetic
        ``DOUBLE`` or ``SINGLE``.
    """
    form = _Form(function, force_set, shape, arithmetic)
    parts = form.hoisted()
    known = ["known"] if form.values else []
    lines = [
        *form.head(),
        "{",
        f"    {arithmetic.kind} pad[{len(form.arrays) + len(form.outputs)}][GS_LANES];",
        "    const gs_v one = gs_v_of(1.0);",
        *_indented(1, [f"const gs_v {a.name}_here = gs_v_of({a.name}_in);" for a in form.values]),
        *_indented(1, form.masks("known", [], form.values) if form.values else []),
        *_indented(1, form.loads(form.values, "known")),
        *_indented(1, form.assignments(parts.before, "known")),
        "    while (count > 0) {",
        "        const size_t here = count < GS_LANES ? count : GS_LANES;",
        *_indented(2, form.pads()),
        *_indented(2, [f"const gs_v {a.name}_here = {arithmetic.load}({a.name}_in);" for a in form.arrays]),
        *_indented(2, form.masks("good", known, form.arrays)),
        *_indented(2, form.loads(form.arrays, "good")),
        *_indented(2, ["gs_mask held;"] * form.held),
        *_indented(2, form.assignments(parts.each, "good")),
        *_indented(2, form.results(parts.results)),
        *_indented(2, form.handed_on()),
        *_indented(2, form.stores()),
        "    }",
        "}",
    ]
    return "\n".join(lines) + "\n"
