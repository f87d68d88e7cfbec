"""The stable forms of what a scene can show, as nested tuples of names and numbers: read without SymPy."""

from sympy import Add, Function, Mul, Pow, Rational, Symbol, cos, sin

from galileo_sym.catalogue import ARGUMENTS, FUNCTIONS, stable
from galileo_sym.codegen.schedule import OF_NUMBER
from galileo_sym.primitives import driving

# Outputs of scenes by system: name, function, index of the output there. Arguments by force.
_SHOWN = {
    "chord": (
        ("x", "position", 0),
        ("y", "position", 1),
        ("distance", "distance", 0),
        ("speed", "speed", 0),
        ("descent_time", "descent_time", 0),
        ("X", "synchronous_circle", 0),
        ("Y", "synchronous_circle", 1),
        ("R", "synchronous_circle", 2),
    ),
    "projectile": (
        ("x", "position", 0),
        ("y", "position", 1),
        ("vx", "velocity", 0),
        ("vy", "velocity", 1),
        ("flight_time", "flight_time", 0),
        ("range", "horizontal_range", 0),
    ),
}
_FORCES = {"chord": {"friction": "mu", "drag": "gamma"}, "projectile": {"drag": "k"}}
_OF_ANGLE = {sin: "sine", cos: "cosine", driving: "driving"}
_DOC = '''"""What scenes show: arguments, and by output and forces the stable forms, as nested tuples.

A form is ("number", numerator, denominator), ("symbol", argument), ("sum", form, ...), ("product", form, ...),
("power", form, numerator, denominator) or ("call", primitive, form, ...); primitives take arguments >= 0.
"""
'''


def _number(form, names):
    return ("number", int(form.p), int(form.q))


def _symbol(form, names):
    return ("symbol", names[form.name])


def _sum(form, names):
    return ("sum", *(nested(term, names) for term in form.as_ordered_terms()))


def _product(form, names):
    return ("product", *(nested(factor, names) for factor in form.as_ordered_factors()))


def _power(form, names):
    exponent = form.exp
    return ("power", nested(form.base, names), int(exponent.p), int(exponent.q))


def _call(form, names):
    if form.func in _OF_ANGLE:
        return ("call", _OF_ANGLE[form.func], *(nested(argument, names) for argument in form.args))
    call, _, sign = OF_NUMBER[form.func.__name__]
    return ("call", call, nested(sign * form.args[0], names))


_NESTING = {Rational: _number, Symbol: _symbol, Add: _sum, Mul: _product, Function: _call, Pow: _power}


def nested(form, names):
    """Return a stable form as a nested tuple.

    Parameters
    ----------
    form : sympy.Expr
        In symbols of the catalogue.
    names : dict of str to str
        Public names of the arguments by symbol.

    Raises
    ------
    TypeError
        If it holds something that a scene cannot compute.
    """
    for kind, method in _NESTING.items():
        if isinstance(form, kind):
            return method(form, names)
    raise TypeError(f"a scene cannot compute {form}")


def _output(function, index, names):
    output = function.outputs[index]
    return {
        "function": function.full_name,
        "index": index,
        "unit": output.unit,
        "at_rest": output.at_rest,
        "arguments": (*function.positional, *function.keywords),
        "forms": {force_set: nested(stable(function, force_set)[index], names) for force_set in function.variants},
    }


def _system(paper):
    shown = _SHOWN[paper]
    names = {argument.symbol: argument.name for argument in ARGUMENTS[paper].values()}
    outputs = {name: _output(FUNCTIONS[f"{paper}.{called}"], index, names) for name, called, index in shown}
    forces = _FORCES[paper]
    used = {*forces.values(), *(name for output in outputs.values() for name in output["arguments"])}
    arguments = {a.name: (a.domain, a.unit) for a in ARGUMENTS[paper].values() if a.name in used}
    return {"forces": forces, "arguments": arguments, "outputs": outputs}


def _lines(value, indent=""):
    """A dictionary with an item a line, and the dictionaries in it likewise."""
    if not isinstance(value, dict):
        return repr(value)
    inner = "".join(f"{indent}    {key!r}: {_lines(item, indent + '    ')},\n" for key, item in value.items())
    return f"{{\n{inner}{indent}}}"


def module():
    """Return the text of `generated/_graphs.py`."""
    return f"{_DOC}\nfrom math import inf\n\nSYSTEMS = {_lines({paper: _system(paper) for paper in _SHOWN})}\n"
