"""The nests of loops that make what the points of a grid take: factors, ends, pairs for larger nests."""

from __future__ import annotations

import re
from typing import NamedTuple

from galileo_sym.scenes.c_steps import admitted, literal, resting, rests, statements, type_of
from galileo_sym.scenes.plan import ROUNDINGS


class Array(NamedTuple):
    """An array of the work space: its name, the type of its elements, the axes it is over."""

    name: str
    type: str
    axes: tuple


def index(axes):
    """Return the index of an element over some axes, row by row; 0 for a single one."""
    text = f"i_{axes[0]}" if axes else "0"
    for axis in axes[1:]:
        text = f"({text}) * n_{axis} + i_{axis}" if " " in text else f"{text} * n_{axis} + i_{axis}"
    return text


def element(name, axes):
    """Return an element of an array over some axes."""
    return f"{name}[{index(axes)}]"


def odd_name(axes):
    """Return the name of the array that says which factors over some axes are out of range."""
    return "_".join(["odd", *(axes or ["once"])])


def indented(lines, depth):
    """Return lines of C at a depth of nesting."""
    return [f"{'    ' * depth}{line}" for line in lines]


def nested(axes, body, depth=1, heads=None):
    """Return loops over some axes around lines; heads are the lines at the beginning of each loop."""
    lines = []
    for axis in axes:
        lines += indented([f"for (size_t i_{axis} = 0; i_{axis} < n_{axis}; i_{axis}++) {{"], depth)
        depth += 1
        lines += indented((heads or {}).get(axis, []), depth)
    lines += indented(body, depth)
    return lines + [f"{'    ' * d}}}" for d in range(depth - 1, depth - 1 - len(axes), -1)]


def used(lines, body):
    """Return the declarations among lines whose names occur in what follows them."""
    kept = []
    for line in reversed(lines):
        declared = re.match(r"const \w+ (\w+) =", line)
        if not declared or re.search(rf"\b{declared.group(1)}\b", "\n".join([*kept, *body])):
            kept.insert(0, line)
    return kept


class Nests:
    """What each set of axes has to make.

    Parameters
    ----------
    plan : Plan
        Made for C: every output has steps of its own.
    """

    def __init__(self, plan):
        self.plan = plan
        self.steps = {step.name: step for step in plan.steps}
        self.ending = {end.output: end for end in plan.ends}
        self.copies = [result for result in plan.all_results if result.operation == "copy"]
        self.factors = [self.steps[name] for name in self._factor_names()]
        self.kept = [step for step in plan.steps if step.axes and self._taken_by_larger(step)]

    def _factor_names(self):
        pointwise = [result for result in self.plan.results if result.operation in ("product", "sum")]
        names = [name for result in pointwise for name in _flat(result.operands)]
        return [step.name for step in self.plan.steps if step.name in names]

    def _taken_by_larger(self, step):
        if step.operation in ROUNDINGS:
            return False
        takers = [other for other in self.plan.steps if step.name in other.operands]
        return any(set(step.axes) < set(other.axes) for other in takers)

    def is_direct(self, result):
        """Whether an output is written where it is made, point by point."""
        here = result not in self.plan.bounds and result.output not in self.ending
        return here and result.operation == "copy" and result.axes == self.plan.over

    def array_of(self, result):
        """Return the name of the array of a result that is not written at once."""
        return result.output.replace(" ", "_") + "_made"

    def arrays(self):
        """Return the arrays of the work space: a list of `Array`, those of integers last."""
        found = []
        for step in self.factors:
            names = [step.name] if step.operation == "round" else [f"{step.name}_high", f"{step.name}_low"]
            found += [Array(name, "double", step.axes) for name in names]
        found += [Array(self.array_of(r), "double", r.axes) for r in self.copies if not self.is_direct(r)]
        found += [Array(f"{step.name}_kept", type_of(step), step.axes) for step in self.kept]
        odd = dict.fromkeys(step.axes for step in self.factors)
        return found + [Array(odd_name(axes), "int", axes) for axes in odd]

    def _sets(self):
        sets = [*(s.axes for s in self.factors), *(r.axes for r in self.copies), *(s.axes for s in self.kept)]
        return sorted(dict.fromkeys(sets), key=lambda axes: (len(axes), [self.plan.over.index(a) for a in axes]))

    def lines(self):
        """Return the lines of all nests, smaller ones first."""
        return [line for axes in self._sets() for line in self._nest(axes)]

    def _nest(self, axes):
        stores = [line for step in self.factors if step.axes == axes for line in self._store_factor(step)]
        stores += [self._store_copy(result) for result in self.copies if result.axes == axes]
        stores += [f"{element(f'{s.name}_kept', axes)} = {_raw(s)};" for s in self.kept if s.axes == axes]
        wanted = [s for s in self.kept if s.axes == axes] + [s for s in self.factors if s.axes == axes]
        wanted += [self.steps[result.operands[0]] for result in self.copies if result.axes == axes]
        body = self._made_of(wanted, axes)
        odd = any(step.axes == axes for step in self.factors)
        if odd:
            body = ["int odd = 0;", *body]
            stores += [f"{element(odd_name(axes), axes)} = odd;", "any_odd |= odd;"]
        body += stores
        heads = [line for axis in axes for line in admitted(axis, f"{axis}[i_{axis}]", self.plan)]
        return nested(axes, used(heads, body) + body) if axes else ["    {", *indented(body, 2), "    }"]

    def _made_of(self, wanted, axes):
        """Lines that make the pairs of some steps in the nest of their axes; smaller nests' pairs are fetched."""
        lines, seen = [], set()

        def make(step):
            if step.name in seen or not step.axes:
                return
            seen.add(step.name)
            if step.axes != axes:
                lines.extend(self._fetched(step))
                return
            for operand in step.operands:
                if operand in self.steps:
                    make(self.steps[operand])
            if step.operation not in ROUNDINGS:
                lines.extend(statements(step))

        for step in wanted:
            make(step)
        return lines

    def _fetched(self, step):
        value = element(f"{step.name}_kept", step.axes)
        if step.operation == "driving":
            return [f"gs_scaled {step.name} = {value};", *resting(step.name)]
        return [f"const {type_of(step)} {step.name} = {value};"]

    def ok(self, axes):
        """Return the condition that all of some axes are in their domains."""
        return " && ".join(f"{axis}_ok" for axis in axes) or "1"

    def _store_factor(self, step):
        ok = self.ok(step.axes)
        if step.operation == "round":
            value, at_rest, *forces = step.operands
            value = f"gs_factor({value}, &odd)"
            if forces:
                value = f"{rests(forces)} ? {literal(at_rest)} : {value}"
            return [f"{element(step.name, step.axes)} = !({ok}) ? NAN : {value};"]
        parts = f"{step.name}_parts"
        return [
            f"const gs_pair {parts} = gs_{step.operation}({step.operands[0]}, &odd);",
            f"{element(f'{step.name}_high', step.axes)} = {ok} ? {parts}.hi : NAN;",
            f"{element(f'{step.name}_low', step.axes)} = {ok} ? {parts}.lo : NAN;",
        ]

    def _store_copy(self, result):
        value, at_rest, *forces = self.steps[result.operands[0]].operands
        target = result.output if self.is_direct(result) else self.array_of(result)
        stored = f"gs_store({value})"
        if forces:
            stored = f"{rests(forces)} ? {literal(at_rest)} : {stored}"
        checked = [axis for axis in self.plan.over if axis in result.axes or axis in result.arguments]
        ok = self.ok(result.axes if not self.is_direct(result) else checked)
        return f"{element(target, result.axes)} = !({ok}) ? NAN : {stored};"


def _raw(step):
    """What a step made; of a driving force 0 where it holds the bead."""
    return f"{step.name}_rests ? gs_zero() : {step.name}" if step.operation == "driving" else step.name


def _flat(operands):
    """The names in nested operands."""
    if isinstance(operands, str):
        return [operands]
    return [name for operand in operands for name in _flat(operand)] if isinstance(operands, tuple) else []
