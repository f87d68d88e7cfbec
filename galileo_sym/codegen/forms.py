"""The text of the papers' formulas on vectors: on pairs of doubles, and for binary32 in plain double arithmetic.

For arguments of ordinary size; other lanes are handed to the scaled form, which comes from the same schedule. Each form
is emitted twice: with an array for every argument, and with one value for each keyword argument, where what depends on
those alone is computed once. It goes over blocks of vectors, in one loop for each stage.
"""

from galileo_sym.codegen.arithmetic import SINGLE, call_text, is_rate, size_of
from galileo_sym.codegen.hoisting import hoisted, names_in
from galileo_sym.codegen.lane_steps import lane_schedule, told_name
from galileo_sym.codegen.printing import ROUTINE_TEXT, operations_text, sources_text
from galileo_sym.codegen.signatures import ARRAYS, is_single, letter, name_of, parameters, scaled_name, widened_name
from galileo_sym.codegen.stages import divided, operations_in

_ALONE = {"sine": "sine_of", "cosine": "cosine_of"}
_AT_REST = {0.0: "gs_v_of(0.0)", float("inf"): "gs_v_of(INFINITY)"}


def _of_one_angle(steps):
    """Steps without the angle if all that is needed is one sine or one cosine, which then is made alone."""
    users = [node for _, node in steps if "a" in node[1:]]
    if len(users) != 1 or users[0][0] not in _ALONE:
        return steps
    return [
        (name, (_ALONE[node[0]], "theta_used") if node in users else node) for name, node in steps if node[0] != "angle"
    ]


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
        self.kept = ["good", *(["held"] if self.held else [])]

    def head(self):
        """The comment, and the signature."""
        given = parameters(self.function, self.force_set, self.shape, self.arithmetic.kind)
        names = ["count", *(f"{a.name}_in" for a in self.arguments), *(f"{o}_out" for o in self.outputs)]
        signature = ", ".join(f"{kind}{name}" for (kind, _), name in zip(given, names, strict=True))
        return [
            f"/* {sources_text(self.function, self.force_set)}.",
            f" * {ROUTINE_TEXT if self.function.routine else operations_text(self.plan)} */",
            f"void {self.name}({signature})",
        ]

    @property
    def name(self):
        """The form's name in a version."""
        name = f"{name_of(self.function, self.force_set)}_{self.shape}{letter(self.arithmetic.kind)}"
        return f"GS_JOIN({name}, GS_SUFFIX)"

    def masks(self, name, start, arguments):
        """Lines that make a mask of lanes that are of ordinary size."""
        tests = [*start, *map(self._test, arguments)]
        return [f"gs_mask {name} = {tests[0]};"] + [f"{name} = gs_both({name}, {test});" for test in tests[1:]]

    def _test(self, argument):
        return self.arithmetic.ordinary[size_of(argument, self.turned)].format(f"{argument.name}_here")

    def loads(self, arguments, mask, names):
        """Lines that take those arguments that are named as numbers: 1 in lanes that are not served."""
        lines = []
        for a in (a for a in arguments if self.told(a) in names):
            taken = self.arithmetic.rate if is_rate(a) else "{}"
            lines.append(f"const gs_v {self.told(a)} = {taken.format(f'gs_select({mask}, {a.name}_here, one)')};")
        return lines + ["const gs_v theta_used = gs_select(good, theta_here, one);"] * ("theta_used" in names)

    def told(self, argument):
        """The name of an argument as it is taken."""
        return told_name(self.function, argument.symbol)

    def hoisted(self):
        """The operations, divided; an angle is that of the lanes that are served."""
        steps = [
            (name, ("angle", "theta_used") if node[0] == "angle" else node)
            for name, node in _of_one_angle(self.plan.steps)
        ]
        varying = {self.told(a) for a in self.arrays if a.symbol in self.plan.loads} | {"theta_used"}
        return hoisted(steps, self.plan.results, varying)

    def assignments(self, steps, good):
        """Lines that give nodes their names."""
        kinds = self.arithmetic.types
        return [
            f"const {kinds.get(node[0], self.arithmetic.number)} {name} = {self._text(node, good)};"
            for name, node in steps
        ]

    def _text(self, node, good):
        plain = {self.told(a) for a in self.arguments} if self.arithmetic.of_kinds else ()
        return call_text(node, self.arithmetic, good, plain)

    def _result(self, node):
        """A lane's result; a power of two is the last factor, so that it takes one multiplication."""
        if node[0] == "scale":
            return f"gs_mul({self._result(node[1])}, gs_v_of({float(2) ** node[2]!r}))"
        return self.arithmetic.value.format(self._text(node, "good"))

    def results(self, nodes):
        """Lines that name the outputs."""
        results = list(map(self._result, nodes))
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
        lanes = [f"{a.name}_in" + "[at + j]" * (a in self.arrays) for a in self.arguments]
        call = f"{scaled_name(self.function, self.force_set)}({', '.join(self._widened(lanes))}"
        single = f"{self.outputs[0]}_each[j] = {call});"
        several = f"{call}, {', '.join(f'{name}_each + j' for name in self.outputs)});"
        return [
            "if (!gs_all(good)) {",
            f"    double {', '.join(f'{name}_each[GS_LANES]' for name in self.outputs)};",
            *(f"    gs_v_store({name}_each, {name}_here);" for name in self.outputs),
            "    for (size_t j = 0; j < GS_LANES; j++)",
            "        if (!(gs_bits_of(good) >> j & 1))",
            f"            {single if is_single(self.function) else several}",
            *(f"    {name}_here = gs_v_load({name}_each);" for name in self.outputs),
            "}",
        ]

    def begun(self, names, known):
        """The first loop's lines before its operations: which lanes are served, and their arguments."""
        return [
            "const size_t at = i * GS_LANES;",
            *(f"const gs_v {a.name}_here = {self.arithmetic.load}({a.name}_in + at);" for a in self.arrays),
            *self.masks("good", known, self.arrays),
            *self.loads(self.arrays, "good", names),
            *["gs_mask held;"] * self.held,
        ]

    def resumed(self, stage, names, last):
        """The same of a later loop: what the others have left, and the arguments that it needs."""
        needed = [a for a in self.arrays if self.told(a) in names]
        kept = self.kept if last else ["good"] if needed or self.may_fail(stage) else []
        return [
            *["const size_t at = i * GS_LANES;"] * (last or bool(needed)),
            *(f"{'gs_mask' if mask == 'good' else 'const gs_mask'} {mask} = {mask}_kept[i];" for mask in kept),
            *(f"const gs_v {a.name}_here = {self.arithmetic.load}({a.name}_in + at);" for a in needed),
            *self.loads(needed, "good", names),
            *(f"const {self.arithmetic.number} {name} = {name}_kept[i];" for name in stage.taken),
        ]

    def finished(self, nodes):
        """The last loop's lines after its operations: results, and where they go."""
        store = self.arithmetic.store
        return [
            *self.results(nodes),
            *self.handed_on(),
            *(f"{store}({name}_out + at, {name}_here);" for name in self.outputs),
        ]

    def may_fail(self, stage):
        """Whether lanes may turn out not to be served."""
        return not operations_in(*(node for _, node in stage.steps)).isdisjoint(self.arithmetic.failing)

    def loop(self, stages, place, results, known):
        """One loop over the vectors of a block."""
        stage, first, last = stages[place], place == 0, place == len(stages) - 1
        names = names_in(*(node for _, node in stage.steps), *(results if last else ()))
        left = [*(self.kept if first else ["good"] if self.may_fail(stage) else []), *stage.left]
        return [
            "for (size_t i = 0; i < block; i++) {",
            *_indented(1, self.begun(names, known) if first else self.resumed(stage, names, last)),
            *_indented(1, self.assignments(stage.steps, "good")),
            *_indented(1, self.finished(results) if last else [f"{name}_kept[i] = {name};" for name in left]),
            "}",
            *(
                f"{self.arithmetic.prefix}{factor}_each(block, {x}_kept, {name}_kept);"
                for name, factor, x in stage.calls
            ),
        ]

    def keepers(self, stages):
        """Lines that make room for what one loop leaves to another."""
        if len(stages) == 1:
            return []
        numbers = [name for stage in stages for name in (*stage.left, *(call[0] for call in stage.calls))]
        lines = [f"gs_mask {', '.join(f'{mask}_kept[GS_GROUP]' for mask in self.kept)};"]
        if numbers:
            lines.append(f"{self.arithmetic.number} {', '.join(f'{name}_kept[GS_GROUP]' for name in numbers)};")
        return lines

    def advance(self):
        """The line that goes on to the next block."""
        moved = [*(f"{a.name}_in" for a in self.arrays), *(f"{name}_out" for name in self.outputs)]
        return f"vectors -= block, {', '.join(f'{name} += block * GS_LANES' for name in moved)};"

    def rest(self):
        """Lines that compute the last lanes, fewer than a vector, in one that holds copies of the last."""
        kind, padded, given = self.arithmetic.kind, self.arithmetic.padded, []
        for a in self.arguments:
            place = self.arrays.index(a) if a in self.arrays else None
            given.append(f"{a.name}_in" if place is None else f"{padded}(pad[{place}], {a.name}_in, rest)")
        pads = {name: f"pad[{i}]" for i, name in enumerate(self.outputs, len(self.arrays))}
        return [
            "const size_t rest = count % GS_LANES;",
            "if (rest > 0) {",
            f"    {kind} pad[{len(self.arrays) + len(pads)}][GS_LANES];",
            f"    {self.name}(GS_LANES, {', '.join([*given, *pads.values()])});",
            *(f"    memcpy({name}_out, {pad}, rest * sizeof *{name}_out);" for name, pad in pads.items()),
            "}",
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
    arithmetic : galileo_sym.codegen.arithmetic.Arithmetic
        ``DOUBLE`` or ``SINGLE``.
    """
    form = _Form(function, force_set, shape, arithmetic)
    parts = form.hoisted()
    stages, results = divided(parts.each, parts.results)
    known = ["known"] if form.values else []
    everywhere = {form.told(a) for a in form.values if a.symbol in form.plan.loads}
    lines = [
        *form.head(),
        "{",
        "    const gs_v one = gs_v_of(1.0);",
        *_indented(1, [f"const gs_v {a.name}_here = gs_v_of({a.name}_in);" for a in form.values]),
        *_indented(1, form.masks("known", [], form.values) if form.values else []),
        *_indented(1, form.loads(form.values, "known", everywhere)),
        *_indented(1, form.assignments(parts.before, "known")),
        *_indented(1, form.keepers(stages)),
        "    for (size_t vectors = count / GS_LANES; vectors > 0;) {",
        "        const size_t block = vectors < GS_GROUP ? vectors : GS_GROUP;",
        *(line for i in range(len(stages)) for line in _indented(2, form.loop(stages, i, results, known))),
        f"        {form.advance()}",
        "    }",
        *_indented(1, form.rest()),
        "}",
    ]
    return "\n".join(lines) + "\n"
