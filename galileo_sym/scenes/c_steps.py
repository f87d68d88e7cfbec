"""Steps of a plan as statements of C, in one nest of loops or at one point."""

from __future__ import annotations

from galileo_sym.generated._kernel import DOMAINS


def literal(value):
    """Return a double as C writes it, exactly."""
    return "INFINITY" if value == float("inf") else value.hex()


def type_of(step):
    """Return the type of what a step makes."""
    return "gs_direction" if step.operation == "angle" else "gs_scaled"


def statements(step):
    """Return the lines of C that make a step: a constant of its name; of a driving force whether it holds the bead."""
    name, operands = step.name, step.operands
    if step.operation == "driving":
        return [f"gs_scaled {name} = gs_driving({', '.join(operands)}); /* {step.text} */", *resting(name)]
    if step.operation == "constant":
        hi, lo, e = operands
        return [f"const gs_scaled {name} = {{{literal(hi)}, {literal(lo)}, {e}}}; /* {step.text} */"]
    if step.operation in ("load", "angle"):
        (operand,) = operands
        operand = f"{operand}_at" if isinstance(operand, str) else literal(operand)
        return [f"const {type_of(step)} {name} = gs_{step.operation}({operand});"]
    return [f"const gs_scaled {name} = gs_{step.operation}({', '.join(map(str, operands))}); /* {step.text} */"]


def resting(name):
    """Return the lines that say whether a driving force holds the bead, and then put 1 in its place."""
    return [f"const int {name}_rests = {name}.hi <= 0.0;", f"if ({name}_rests)", f"    {name} = gs_constant(1.0);"]


def rests(forces):
    """Return the condition that one of some driving forces holds the bead."""
    return " || ".join(f"{force}_rests" for force in forces)


def admitted(axis, value, plan):
    """Return the lines that make of an axis whether it is in its domain, and a harmless value where it is not."""
    domain = dict(plan.domains)[axis]
    if axis == "t" and plan.arrival is not None:  # before the start nothing has moved
        return [f"const int t_ok = !isnan({value});", f"const double t_at = t_ok && {value} > 0.0 ? {value} : 0.0;"]
    inside = f"gs_{domain.replace(' ', '_')}({value})"
    return [
        f"const int {axis}_ok = !isnan({value}) && ({inside} || gs_refused());",
        f"const double {axis}_at = {axis}_ok ? {value} : {DOMAINS[domain][1]};",
    ]
