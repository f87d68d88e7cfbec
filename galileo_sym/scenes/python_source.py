"""A plan as a self-contained module of NumPy: what its steps reach of the emitted modules, and one function."""

from __future__ import annotations

import galileo_sym
from galileo_sym.scenes.explain import headline
from galileo_sym.scenes.plan import ROUNDINGS
from galileo_sym.scenes.python_closure import closure

_HEAD = '''"""{title}

`{name}` returns the outputs over the outer grid of its axes, each a vector. Arguments outside their domains give NaN
and raise NumPy's 'invalid' error state. Made by galileo-sym {version}.
"""

from typing import NamedTuple

import numpy as np

'''
_MADE_BY = {
    "round": "rounded_factor",
    "store": "stored_factor",
    "halves": "halved_factor",
    "parts": "parted_factor",
}


def source(plan, name):
    """Return the text of a module that computes a scene, and nothing else.

    Parameters
    ----------
    plan : Plan
        With steps of its own for every output.
    name : str
        Of the function.
    """
    writer = _Writer(plan)
    own = "\n\n\n".join(["\n".join(writer.pairs()), "\n".join(writer.function(name))])
    title = headline(plan, None).replace("\n", "\n\n", 1)
    head = _HEAD.format(title=title, name=name, version=galileo_sym.__version__)
    return f"{head}{closure(own)}\n\n\n{own}\n"


class _Writer:
    def __init__(self, plan):
        self.plan = plan
        self.steps = {step.name: step for step in plan.steps}
        self.last = [step for step in plan.steps if step.operation in ROUNDINGS]
        self.separated = [result for result in plan.results if result.operation in ("product", "sum")]
        self.ends = {end.output: end for end in plan.ends}

    def _pair(self, name):
        """The pair of a step."""
        return f"{name}.force" if self.steps[name].operation == "driving" else name

    def _made(self, step):
        """The expression of a step."""
        if step.operation == "constant":
            hi, lo, e = step.operands
            return f"Scaled(np.float64({hi!r}), np.float64({lo!r}), np.int32({e}))"
        if step.operation in ("load", "angle"):
            (operand,) = step.operands
            return f"{step.operation}({operand if isinstance(operand, str) else f'np.float64({operand!r})'})"
        operands = [self._pair(x) if x in self.steps else repr(x) for x in step.operands]
        if step.operation in ROUNDINGS:
            value, *rest = step.operands
            rest = [repr(None if x is None else float(x)) if x not in self.steps else x for x in rest]
            rest = ["np.inf" if x == "inf" else x for x in rest]
            return f"{_MADE_BY[step.operation]}({', '.join([self._pair(value), *rest])})"
        text = f"{step.operation}({', '.join(operands)})"
        return f"sliding({text})" if step.operation == "driving" else text

    def _given(self):
        """What the function of the pairs returns: what is rounded, and the driving forces that decide on rest."""
        names = [x for step in self.last for x in step.operands if x in self.steps]
        return list(dict.fromkeys(names))

    def pairs(self):
        """Lines of the function that makes all pairs."""
        used = [axis for axis in self.plan.over if any(axis in step.axes for step in self.plan.steps)]
        lines = [f"def _pairs({', '.join(used)}):", '    """What is rounded, in pairs."""']
        for step in self.plan.steps:
            if step.operation not in ROUNDINGS:
                lines.append(f"    {step.name} = {self._made(step)}  # {step.text}")
        return [*lines, f"    return {self._tuple(self._given())}"]

    @staticmethod
    def _tuple(names):
        return f"({', '.join(names)},)" if names else "()"

    def function(self, name):
        """Lines of the function of the scene."""
        plan = self.plan
        used = [axis for axis in plan.over if any(axis in step.axes for step in plan.steps)]
        lines = [f"def {name}({', '.join(plan.over)}):", '    """Return the outputs over the grid of the axes."""']
        for place, axis in enumerate(plan.over):
            shape = ", ".join("-1" if place == other else "1" for other in range(len(plan.over)))
            domain = "real" if axis == "t" and plan.arrival else dict(plan.domains)[axis]
            lines.append(f"    ({axis},), {axis}_void = admit((np.reshape({axis}, ({shape},)), {domain!r}))")
        if plan.arrival:
            time = "t" if "t" in plan.over else repr(dict(plan.constants)["t"])
            lines.append(f"    time = np.asarray({time})")
            lines += ["    t = np.maximum(t, 0.0)"] if "t" in plan.over else []
        lines.append(f"    shape = np.broadcast_shapes({', '.join(f'{axis}.shape' for axis in plan.over)})")
        if self.steps:
            lines += ["    with quiet():", f"        {self._tuple(self._given())} = _pairs({', '.join(used)})"]
            lines += [f"        {step.name} = {self._made(step)}" for step in self.last]
        for result in plan.results:
            lines += self._output(result, used)
        return [*lines, f"    return {', '.join(result.output for result in plan.results)}"]

    def _output(self, result, used):
        lines = [f"    {result.output} = np.array(np.broadcast_to({self._value(result)}, shape))"]
        if result.operation == "sum":  # products of rests may underflow
            lines = ["    with quiet():", *(f"    {line}" for line in lines)]
        if result in self.separated:
            lines += self._redone(result, used)
        if result.output in self.ends:
            lines += self._ended(result, self.ends[result.output])
        for axis in self.plan.over:
            if axis in result.arguments:
                lines.append(f"    np.copyto({result.output}, np.nan, where={axis}_void)")
        return lines

    def _value(self, result):
        if result.operation == "number":
            return "np.inf" if result.operands[0] == float("inf") else repr(result.operands[0])
        if result.operation == "copy":
            return f"{result.operands[0]}.parts[0]"
        if result.operation == "product":
            return " * ".join(f"{name}.parts[0]" for name in result.operands)
        high = low = ""
        for sign, *names in result.operands:
            parts = [[f"{name}.parts[{i}]" for i in (0, 1)] for name in names]
            operation = {1: " + ", -1: " - "}[sign] if high else ""
            leading, rest = parts[0]
            if len(parts) == 2:
                (one, one_rest), (other, other_rest) = parts
                leading, rest = f"{one} * {other}", f"({one} * {other_rest} + {one_rest} * ({other} + {other_rest}))"
            high, low = f"{high}{operation}{leading}", f"{low}{operation}{rest}"
        return f"({high}) + ({low})"

    def _redone(self, result, used):
        """Lines that compute in pairs to the end where a factor is out of range."""
        names = [x for operand in result.operands for x in ([operand] if isinstance(operand, str) else operand[1:])]
        factors = ", ".join(f"{name}.odd" for name in names)
        lanes = ", ".join(f"np.broadcast_to({axis}, shape)[odd]" for axis in used)
        at_rest = next((self.steps[name].operands[1] for name in names if self.steps[name].operands[2:]), None)
        stored = "stored_factor({}).parts[0]".format(
            ", ".join(["whole", *([repr(at_rest)] if self._forces(names) else ["None"]), *self._forces(names)])
        ).replace("inf", "np.inf")
        return [
            "    odd = np.zeros(shape, dtype=bool)",
            f"    for mask in ({factors},):",
            "        odd |= False if mask is None else mask",
            "    if odd.any():",
            "        with quiet():",
            f"            {self._tuple(self._given())} = _pairs({lanes})",
            f"            whole = {self._whole(result)}",
            f"        {result.output}[odd] = {stored}",  # with the flags of its rounding
        ]

    def _forces(self, names):
        return list(dict.fromkeys(force for name in names for force in self.steps[name].operands[2:]))

    def _whole(self, result):
        """An output in pairs."""
        if result.operation == "product":
            return f"mul({', '.join(self._pair(self.steps[name].operands[0]) for name in result.operands)})"
        total = ""
        for sign, *names in result.operands:
            pairs = [self._pair(self.steps[name].operands[0]) for name in names]
            addend = pairs[0] if len(pairs) == 1 else f"mul({', '.join(pairs)})"
            total = f"{'add' if sign > 0 else 'sub'}({total}, {addend})" if total else addend
        return total

    def _ended(self, result, end):
        name, arrival = result.output, self._value(self.plan.arrival)
        if end.floor:
            return [f"    np.maximum({name}, 0.0, out={name})"]
        if end.limit is None:
            return [f"    np.copyto({name}, 0.0, where=(time < 0.0) | (time > {arrival}))"]
        limit = f"np.where(np.isinf({arrival}), 0.0, {self._value(end.limit)})"
        return [f"    end = {limit}", f"    np.clip({name}, np.minimum(end, 0.0), np.maximum(end, 0.0), out={name})"]
