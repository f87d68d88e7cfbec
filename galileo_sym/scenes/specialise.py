"""Steps of a plan out of terms: constants folded, each factor on the axes it depends on, once."""

from __future__ import annotations

from galileo_sym.scenes import folding
from galileo_sym.scenes.forms import Term, symbols_of_base
from galileo_sym.scenes.plan import Step

_OF_ANGLE = ("sine", "cosine", "driving")


class Specialiser:
    """Makes the steps of a plan; equal steps are made once.

    Parameters
    ----------
    over : tuple of str
        The axes.
    constants : dict of str to float
        All other arguments.
    """

    def __init__(self, over, constants):
        self.over, self.constants = over, constants
        self.made, self._known = {}, {}

    def step(self, operation, operands, text, axes=None):
        """Return the name of a step, made now if there is no equal one."""
        key = operation, operands
        if key not in self._known:
            if axes is None:
                axes = self.union(*(self.made[name].axes for name in operands if name in self.made))
            name = self._known[key] = f"v{len(self.made)}"
            self.made[name] = Step(name, axes, operation, operands, text)
        return self._known[key]

    def text(self, name):
        """Return what a step gives, in words."""
        return self.made[name].text

    def union(self, *sets):
        """Return the axes in any of some sets, in order."""
        found = {axis for axes in sets for axis in axes}
        return tuple(axis for axis in self.over if axis in found)

    def axes_of(self, names):
        """Return the axes among names, in order."""
        return tuple(axis for axis in self.over if axis in names)

    def _constant(self, value):
        hi, lo, e = folding.as_pair(value)
        return self.step("constant", (hi, lo, e), f"{float(value):.6g}", ())

    def base(self, base):
        """Return the step of a base that depends on an axis."""
        kind, *rest = base
        if kind == "symbol":
            return self.step("load", (rest[0],), rest[0], (rest[0],))
        if kind == "sum":
            return self.sum(rest[0])
        name, *arguments = rest
        if name in _OF_ANGLE:
            return self._of_angle(name, *arguments)
        argument = self.sum(arguments[0])
        return self.step(name, (argument,), f"{name}({self.text(argument)})")

    def _of_angle(self, name, angle, mu=None):
        ((_, ((symbol, _),)),) = angle
        axis = symbol[1] if symbol[1] in self.over else self.constants[symbol[1]]
        turned = self.step("angle", (axis,), f"angle {axis}", self.axes_of({axis}))
        if mu is None:
            return self.step(name, (turned,), f"{name[:3]}({axis})")
        friction = self.sum(mu)
        return self.step(name, (turned, friction), f"(cos {axis} - {self.text(friction)} sin |{axis}|)")

    def sum(self, terms):
        """Return the step of a sum of terms, in pairs."""
        positive = sorted(terms, key=lambda term: term.coefficient < 0)
        first, *rest = (self.term(Term(abs(t.coefficient), t.factors)) for t in positive)
        for term, node in zip(positive[1:], rest, strict=True):
            sign = "-" if term.coefficient < 0 else "+"
            operation = "sub" if term.coefficient < 0 else "add"
            first = self.step(operation, (first, node), f"({self.text(first)} {sign} {self.text(node)})")
        return first

    def term(self, term):
        """Return the step of a whole term, in pairs."""
        groups = self.groups(term)
        if not groups:
            return self._constant(folding.fold((term,), self.constants))
        return self.joined([node for _, node in groups])

    def joined(self, nodes):
        """Return the step of the product of some steps."""
        product, *rest = nodes
        for node in rest:
            product = self.step("mul", (product, node), f"{self.text(product)} {self.text(node)}")
        return product

    def groups(self, term):
        """Return a term's factors by the axes they depend on: (axes, step), fewest first, constants in the first."""
        by_axes, folded = {}, []
        for factor in term.factors:
            axes = self.axes_of(symbols_of_base(factor[0]))
            (by_axes.setdefault(axes, []) if axes else folded).append(factor)
        ordered = sorted(by_axes, key=lambda axes: (len(axes), [self.over.index(axis) for axis in axes]))
        groups = [(axes, self._powers(by_axes[axes])) for axes in ordered]
        value = folding.fold((Term(term.coefficient, tuple(folded)),), self.constants)
        if groups:
            groups[0] = (groups[0][0], self._times(groups[0][1], value))
        return groups

    def _times(self, node, value):
        twos = folding.power_of_two(value)
        if twos == 0:
            return node
        if twos is not None:
            return self.step("scale", (node, twos), f"{float(value):.6g} {self.text(node)}")
        return self.joined([self._constant(value), node])

    def _powers(self, factors):
        whole = [(base, int(power)) for base, power in factors if power.denominator == 1]
        half = [(base, int(2 * power)) for base, power in factors if power.denominator == 2]
        nodes = [self._quotient(whole)] if whole else []
        if half:
            inside = self._quotient(half)
            nodes.insert(0, self.step("sqrt", (inside,), f"sqrt({self.text(inside)})"))
        return self.joined(nodes)

    def _quotient(self, powers):
        ordered = sorted(powers, key=lambda factor: (factor[0][0] != "symbol", repr(factor[0])))
        above = [node for base, power in ordered if power > 0 for node in [self.base(base)] * power]
        below = [node for base, power in ordered if power < 0 for node in [self.base(base)] * -power]
        top = self.joined(above) if above else self.step("constant", (0.5, 0.0, 1), "1", ())
        if not below:
            return top
        bottom = self.joined(below)
        return self.step("div", (top, bottom), f"{self.text(top)}/{self.text(bottom)}")

    def driving(self, node):
        """Return the steps of driving forces that a step depends on, in order."""
        step = self.made[node]
        below = [name for operand in step.operands if operand in self.made for name in self.driving(operand)]
        return tuple(dict.fromkeys([*below, *([node] if step.operation == "driving" else [])]))

    def separated(self, groups):
        """Return two factors of a term, neither on all of its axes, as steps; None if there are no two.

        The factor that depends on the last axis is one, all that is left is the other.
        """
        merged = dict(groups)
        for axes, _ in groups:
            larger = next((other for other in merged if set(axes) < set(other)), None)
            if larger:
                merged[larger] = self.joined([merged.pop(axes), merged[larger]])
        axes = self.union(*merged)
        inner = [found for found in merged if axes[-1] in found]
        outer = [found for found in merged if axes[-1] not in found]
        if not outer or self.union(*inner) == axes:
            return None
        return tuple(self.joined([merged[found] for found in part]) for part in (outer, inner))
