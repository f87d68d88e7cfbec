"""The points of a grid in C: one multiplication of two factors, or what its result says; the odd ones over again."""

from __future__ import annotations

from galileo_sym.scenes.c_nests import element, index, nested, odd_name, used
from galileo_sym.scenes.c_steps import admitted, literal, rests, statements
from galileo_sym.scenes.plan import ROUNDINGS


def grid_lines(nests):
    """Return the lines of the loops over all points; none if every output is written where it is made."""
    plan = nests.plan
    body = [line for result in plan.results if not nests.is_direct(result) for line in _point(nests, result)]
    if not body:
        return []
    values = {axis: f"{axis}[i_{axis}]" for axis in plan.over}
    heads = {axis: used(admitted(axis, value, plan), body) for axis, value in values.items()}
    lines = nested(plan.over, [f"const size_t cell = {index(plan.over)};", *body], heads=heads)
    return _without_underflow(lines) if any(result.operation == "sum" for result in plan.results) else lines


def _without_underflow(lines):
    """Lines that leave no flag of an underflow: products of rests may be that small, a sum never is."""
    before = "    const int too_small = fetestexcept(FE_UNDERFLOW);"
    return [before, *lines, "    if (!too_small)", "        feclearexcept(FE_UNDERFLOW);"]


def _point(nests, result):
    """Lines that write an output at a point."""
    plan = nests.plan
    value = _VALUES[result.operation](nests, result)
    lacking = [axis for axis in plan.over if axis in result.arguments and axis not in result.axes]
    end = nests.ending.get(result.output)
    lines = []
    if end:
        value, lines = _ended(nests, result.output, end, value)
    if lacking:
        value = f"{nests.ok(lacking)} ? {value} : NAN"
    return [*lines, f"{result.output}[cell] = {value};"]


def _ended(nests, output, end, value):
    """An output that ends, and the lines before it."""
    arrival = _value(nests, nests.plan.arrival)
    constants = dict(nests.plan.constants)
    time = "t[i_t]" if "t" in nests.plan.over else literal(constants["t"])
    lines = [f"const double {output}_at = {value};"]
    if end.floor:
        return f"isless({output}_at, 0.0) ? 0.0 : {output}_at", lines
    if end.limit is None:
        still = f"isless({time}, 0.0) || isgreater({time}, {arrival})"
        return f"!isnan({output}_at) && ({still}) ? 0.0 : {output}_at", lines
    limit = _value(nests, end.limit)
    return f"gs_between({output}_at, isinf({arrival}) ? 0.0 : {limit})", lines


def _value(nests, result):
    """A result of a nest or a number, at a point."""
    if result.operation == "number":
        return literal(result.operands[0])
    return element(nests.array_of(result), result.axes)


def _product(nests, result):
    one, other = (nests.steps[name] for name in result.operands)
    return f"{element(one.name, one.axes)} * {element(other.name, other.axes)}"


def _sum(nests, result):
    """Leading parts, whose products are exact, and what is left of them."""
    high = low = ""
    for sign, *names in result.operands:
        parts = [[element(f"{n}_{part}", nests.steps[n].axes) for part in ("high", "low")] for n in names]
        leading, rest = _ADDENDS[len(parts)](*parts)
        operation = {1: " + ", -1: " - "}[sign] if high else ""
        high, low = f"{high}{operation}{leading}", f"{low}{operation}{rest}"
    return f"({high}) + ({low})"


_ADDENDS = {
    1: tuple,
    2: lambda one, other: (f"{one[0]} * {other[0]}", f"({one[0]} * {other[1]} + {one[1]} * ({other[0]} + {other[1]}))"),
}
_VALUES = {"number": _value, "copy": _value, "product": _product, "sum": _sum}


def _separated(plan):
    return [result for result in plan.results if result.operation in ("product", "sum")]


def point_function(nests, name):
    """Return the lines of a function for one point, in pairs to the end: any exponents; none if nothing needs it."""
    results = _separated(nests.plan)
    if not results:
        return []
    factors = {factor for result in results for factor in _names(result)}
    wanted = {operand for factor in factors for operand in nests.steps[factor].operands if operand in nests.steps}
    for step in reversed(nests.plan.steps):
        if step.name in wanted and step.operation not in ROUNDINGS:
            wanted.update(operand for operand in step.operands if operand in nests.steps)
    body = [
        line for step in nests.plan.steps if step.name in wanted and step.operation not in ROUNDINGS
        for line in statements(step)
    ]  # fmt: skip
    body += [f"*{result.output} = {_at_a_point(nests, result)};" for result in results]
    axes = [axis for axis in nests.plan.over if any(f"{axis}_at" in line for line in body)]
    given = ", ".join([*(f"double {axis}_at" for axis in axes), *(f"double *{result.output}" for result in results)])
    head = ["/* At one point, whatever the exponents. */", f"static void {name}_at_point({given})", "{"]
    return [*head, *(f"    {line}" for line in body), "}", ""]


def _names(result):
    return [name for operand in result.operands for name in ([operand] if isinstance(operand, str) else operand[1:])]


def _at_a_point(nests, result):
    if result.operation == "product":
        factors = [nests.steps[name].operands for name in result.operands]
        forces = [force for operands in factors for force in operands[2:]]
        at_rest = next((operands[1] for operands in factors if operands[2:]), None)
        stored = f"gs_store(gs_mul({factors[0][0]}, {factors[1][0]}))"
        return f"{rests(forces)} ? {literal(at_rest)} : {stored}" if forces else stored
    total = ""
    for sign, *names in result.operands:
        pairs = [nests.steps[name].operands[0] for name in names]
        addend = pairs[0] if len(pairs) == 1 else f"gs_mul({', '.join(pairs)})"
        total = f"gs_{'add' if sign > 0 else 'sub'}({total}, {addend})" if total else addend
    return f"gs_store({total})"


def odd_lines(nests, name):
    """Return the lines that do the points over again where a factor is out of range."""
    results = _separated(nests.plan)
    if not results:
        return []
    sets = dict.fromkeys(step.axes for step in nests.factors)
    condition = " || ".join(element(odd_name(axes), axes) for axes in sets)
    call = point_function(nests, name)
    axes = [axis for axis in nests.plan.over if f"double {axis}_at" in call[1]]
    given = ", ".join([*(f"{axis}_at" for axis in axes), *(f"&{result.output}_odd" for result in results)])
    body = [
        f"if ({condition}) {{",
        f"    double {', '.join(f'{result.output}_odd' for result in results)};",
        f"    const size_t cell = {index(nests.plan.over)};",
        f"    {name}_at_point({given});",
    ]
    for result in results:
        end = nests.ending.get(result.output)
        value, lines = (f"{result.output}_odd", [])
        if end:
            value, lines = _ended(nests, result.output, end, value)
        body += [
            f"    {line}"
            for line in [*lines, f"if (!isnan({result.output}[cell]))", f"    {result.output}[cell] = {value};"]
        ]
    body += ["}"]
    values = {axis: f"{axis}[i_{axis}]" for axis in nests.plan.over}
    heads = {axis: used(admitted(axis, value, nests.plan), body) for axis, value in values.items()}
    return ["    if (any_odd) {", *nested(nests.plan.over, body, 2, heads), "    }"]
