"""Nodes of the parsed C: constants, types and parameters; and the functions that choose, as text in one form."""

from fractions import Fraction

from pycparser import c_ast


class RefusedSource(Exception):
    """The emitted C is outside the grammar that the proof understands; the message says where."""


def refuse(node, why):
    line = getattr(node, "coord", None)
    raise RefusedSource(f"{line or 'emitted C'}: {why}")


def exact_number(node):
    """Return the exact value of a constant, or None; doubles are written in hexadecimal, so nothing is rounded."""
    if isinstance(node, c_ast.UnaryOp) and node.op == "-":
        inner = exact_number(node.expr)
        return None if inner is None else -inner
    if not isinstance(node, c_ast.Constant):
        return None
    if node.type == "int":
        return Fraction(int(node.value, 0))
    if node.type != "double" or not node.value.lower().startswith("0x"):
        refuse(node, f"{node.value} is no hexadecimal double")
    mantissa, power = node.value.lower().split("p")
    whole, _, digits = mantissa.removeprefix("0x").partition(".")
    exact = Fraction(int((whole or "0") + digits, 16)) * Fraction(2) ** (int(power) - 4 * len(digits))
    if Fraction(float.fromhex(node.value)) != exact:
        refuse(node, f"{node.value} is not a double")
    return exact


def type_name(node):
    """Return the name of a plain or pointer type, with a star for the latter."""
    if isinstance(node, c_ast.PtrDecl):
        return type_name(node.type) + "*"
    if isinstance(node, c_ast.TypeDecl) and isinstance(node.type, c_ast.IdentifierType):
        return " ".join(node.type.names)
    return type(node).__name__


def parameters_of(node):
    """Return the names of the value parameters and of the pointers."""
    kinds = {"gs_v": [], "gs_v*": []}
    for parameter in node.decl.type.args.params:
        kind = type_name(parameter.type)
        if kind not in kinds:
            refuse(parameter, f"a parameter of type {kind}")
        kinds[kind].append(parameter.name)
    return tuple(kinds["gs_v"]), tuple(kinds["gs_v*"])


_SHOWN = {
    c_ast.ID: lambda node: node.name,
    c_ast.Constant: lambda node: node.value,
    c_ast.FuncCall: lambda node: f"{node.name.name}({', '.join(map(_shown, node.args.exprs))})",
    c_ast.UnaryOp: lambda node: f"{node.op}{_shown(node.expr)}",
    c_ast.TernaryOp: lambda node: f"{_shown(node.cond)} ? {_shown(node.iftrue)} : {_shown(node.iffalse)}",
    c_ast.Assignment: lambda node: f"{_shown(node.lvalue)} {node.op} {_shown(node.rvalue)};",
    c_ast.Decl: lambda node: f"{type_name(node.type)} {node.name}{_shown_start(node.init)};",
    c_ast.Return: lambda node: f"return {_shown(node.expr)};",
}


def _shown_start(init):
    return f" = {_shown(init)}" if init else ""


def _shown(node):
    """Return a node as text in one form, whatever its layout in the source."""
    if type(node) not in _SHOWN:
        refuse(node, f"{type(node).__name__} in a function that chooses")
    return _SHOWN[type(node)](node)


def choice(node):
    """Return the text of a function that chooses, its parameters first."""
    values, pointers = parameters_of(node)
    parameters = ", ".join([*values, *(f"*{name}" for name in pointers)])
    return " ".join([f"{parameters}:", *map(_shown, node.body.block_items)])
