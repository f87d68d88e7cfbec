"""The emitted kernels as data: tables of coefficients and lists of operations, parsed from the C that is compiled.

The grammar is what the emitter writes, and no more: `GS_TABLE(name) = {...};` and `static inline` functions of constant
declarations, stores through a pointer parameter and one final return. Functions that choose between these are kept as
text, for `dispatch`. The rest is refused.
"""

import hashlib
import re
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from pycparser import CParser, c_ast
from pycparser.c_parser import ParseError

ARITY = {
    "gs_add": 2,
    "gs_sub": 2,
    "gs_mul": 2,
    "gs_div": 2,
    "gs_fma": 3,
    "gs_fms": 3,
    "gs_fnma": 3,
    "gs_min": 2,
    "gs_rest": 3,
    "gs_product_rest": 3,
    "gs_v_of": 1,
    "gs_pick": 2,
    "gs_piece": 3,
}
CHOOSING = ("_value", "_outside")
_TYPES = "typedef double gs_v; typedef int gs_index; typedef int gs_mask;\n"
_TABLE = re.compile(r"\bGS_TABLE\((\w+)\)")  # what galileo_vector.h makes of it, but for the alignment
_RARE = re.compile(r"\bGS_RARE\b")
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_HARMLESS = re.compile(r"#\s*(include\b.*|ifndef\s+\w+|define\s+\w+_H|endif)$")


class RefusedSource(Exception):
    """The emitted C is outside the grammar that the proof understands; the message says where."""


@dataclass(frozen=True)
class Number:
    """A constant: a double's exact value, or an integer."""

    value: Fraction


@dataclass(frozen=True)
class Name:
    """A variable, parameter or table."""

    name: str


@dataclass(frozen=True)
class Call:
    """One operation of the vector header on its arguments."""

    operation: str
    arguments: tuple


@dataclass(frozen=True)
class Function:
    """A function: its value parameters, its pointer parameters, its statements in order, and what it returns.

    A statement is (name, expression); a store through a pointer has the name of the pointer.
    """

    name: str
    parameters: tuple
    pointers: tuple
    statements: tuple
    returned: object


@dataclass(frozen=True)
class Emitted:
    """What one C file holds, by name: tables, functions, functions that choose as text; the SHA-256 of its bytes."""

    sha256: str
    tables: dict
    functions: dict
    choosing: dict


def _refuse(node, why):
    line = getattr(node, "coord", None)
    raise RefusedSource(f"{line or 'emitted C'}: {why}")


def _number(node):
    """Return the exact value of a constant, or None; doubles are written in hexadecimal, so nothing is rounded."""
    if isinstance(node, c_ast.UnaryOp) and node.op == "-":
        inner = _number(node.expr)
        return None if inner is None else -inner
    if not isinstance(node, c_ast.Constant):
        return None
    if node.type == "int":
        return Fraction(int(node.value, 0))
    if node.type != "double" or not node.value.lower().startswith("0x"):
        _refuse(node, f"{node.value} is no hexadecimal double")
    mantissa, power = node.value.lower().split("p")
    whole, _, digits = mantissa.removeprefix("0x").partition(".")
    exact = Fraction(int((whole or "0") + digits, 16)) * Fraction(2) ** (int(power) - 4 * len(digits))
    if Fraction(float.fromhex(node.value)) != exact:
        _refuse(node, f"{node.value} is not a double")
    return exact


def _table(node):
    if not isinstance(node.init, c_ast.InitList):
        _refuse(node, f"{node.name} has no list of values")
    values = tuple(map(_number, node.init.exprs))
    if None in values or len(values) != _number(node.type.dim):
        _refuse(node, f"{node.name} is no full list of constants")
    return values


def _expression(node, known):
    value = _number(node)
    if value is not None:
        return Number(value)
    if isinstance(node, c_ast.ID):
        if node.name not in known:
            _refuse(node, f"{node.name} is used before it is defined")
        return Name(node.name)
    if not isinstance(node, c_ast.FuncCall) or not isinstance(node.name, c_ast.ID):
        _refuse(node, f"{type(node).__name__} is no operation of the vector header")
    operation, arguments = node.name.name, node.args.exprs if node.args else []
    if ARITY.get(operation) != len(arguments):
        _refuse(node, f"{operation} of {len(arguments)} arguments is no operation of the grammar")
    return Call(operation, tuple(_expression(argument, known) for argument in arguments))


def _type_name(node):
    """Return the name of a plain or pointer type, with a star for the latter."""
    if isinstance(node, c_ast.PtrDecl):
        return _type_name(node.type) + "*"
    if isinstance(node, c_ast.TypeDecl) and isinstance(node.type, c_ast.IdentifierType):
        return " ".join(node.type.names)
    return type(node).__name__


def _parameters(node):
    """Return the names of the value parameters and of the pointers."""
    kinds = {"gs_v": [], "gs_v*": []}
    for parameter in node.decl.type.args.params:
        kind = _type_name(parameter.type)
        if kind not in kinds:
            _refuse(parameter, f"a parameter of type {kind}")
        kinds[kind].append(parameter.name)
    return tuple(kinds["gs_v"]), tuple(kinds["gs_v*"])


def _statement(node, known, pointers):
    """Return the name that a statement defines and its expression."""
    if isinstance(node, c_ast.Decl) and "const" in node.quals and _type_name(node.type) in ("gs_v", "gs_index"):
        if node.name in known or node.name in pointers or node.init is None:
            _refuse(node, f"{node.name} is defined twice or not at all")
        return node.name, _expression(node.init, known)
    if isinstance(node, c_ast.Assignment) and node.op == "=" and isinstance(node.lvalue, c_ast.UnaryOp):
        target = node.lvalue
        if target.op == "*" and isinstance(target.expr, c_ast.ID) and target.expr.name in pointers:
            return target.expr.name, _expression(node.rvalue, known)
    return _refuse(node, "neither a constant declaration nor a store through a pointer parameter")


def _function(node, tables):
    parameters, pointers = _parameters(node)
    known = {*tables, *parameters}
    *body, last = node.body.block_items
    statements = []
    for item in body:
        name, expression = _statement(item, known, pointers)
        if name in [earlier for earlier, _ in statements]:
            _refuse(item, f"{name} is written twice")
        statements.append((name, expression))
        if name not in pointers:
            known.add(name)
    if not isinstance(last, c_ast.Return):
        _refuse(last, "the last statement is no return")
    unwritten = set(pointers) - {name for name, _ in statements}
    if unwritten:
        _refuse(node, f"{', '.join(sorted(unwritten))} is never written")
    return Function(node.decl.name, parameters, pointers, tuple(statements), _expression(last.expr, known))


_SHOWN = {
    c_ast.ID: lambda node: node.name,
    c_ast.Constant: lambda node: node.value,
    c_ast.FuncCall: lambda node: f"{node.name.name}({', '.join(map(_shown, node.args.exprs))})",
    c_ast.UnaryOp: lambda node: f"{node.op}{_shown(node.expr)}",
    c_ast.TernaryOp: lambda node: f"{_shown(node.cond)} ? {_shown(node.iftrue)} : {_shown(node.iffalse)}",
    c_ast.Assignment: lambda node: f"{_shown(node.lvalue)} {node.op} {_shown(node.rvalue)};",
    c_ast.Decl: lambda node: f"{_type_name(node.type)} {node.name}{_shown_start(node.init)};",
    c_ast.Return: lambda node: f"return {_shown(node.expr)};",
}


def _shown_start(init):
    return f" = {_shown(init)}" if init else ""


def _shown(node):
    """Return a node as text in one form, whatever its layout in the source."""
    if type(node) not in _SHOWN:
        _refuse(node, f"{type(node).__name__} in a function that chooses")
    return _SHOWN[type(node)](node)


def _choice(node):
    """Return the text of a function that chooses, its parameters first."""
    values, pointers = _parameters(node)
    parameters = ", ".join([*values, *(f"*{name}" for name in pointers)])
    return " ".join([f"{parameters}:", *map(_shown, node.body.block_items)])


def _without_directives(text):
    """Blank out comments and include guards, keeping line numbers; refuse every other directive."""
    text = _COMMENT.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        if line.lstrip().startswith("#"):
            if not _HARMLESS.match(line.strip()):
                raise RefusedSource(f"line {number}: the directive {line.strip()} could change what is compiled")
            lines[number - 1] = ""
    return "\n".join(lines)


def parse(text):
    """Parse the C text of the kernels.

    Parameters
    ----------
    text : str
        The emitted file, as it is compiled.

    Returns
    -------
    Emitted

    Raises
    ------
    RefusedSource
        If anything in it is outside the grammar.
    """
    source = _RARE.sub("", _TABLE.sub(r"static const double \1[16]", _without_directives(text)))
    try:
        tree = CParser().parse(f"{_TYPES}#line 1\n{source}", "emitted C")
    except ParseError as cause:
        raise RefusedSource(str(cause)) from None
    tables, functions, choosing = {}, {}, {}
    for node in tree.ext[_TYPES.count(";") :]:
        if isinstance(node, c_ast.FuncDef) and node.decl.name.endswith(CHOOSING):
            known, name, made = choosing, node.decl.name, _choice(node)
        elif isinstance(node, c_ast.FuncDef):
            known, name, made = functions, node.decl.name, _function(node, tables)
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.ArrayDecl) and "const" in node.quals:
            known, name, made = tables, node.name, _table(node)
        else:
            _refuse(node, f"{type(node).__name__} is neither a constant table nor a function")
        if name in tables or name in functions or name in choosing:
            _refuse(node, f"{name} is defined twice")
        known[name] = made
    return Emitted(hashlib.sha256(text.encode()).hexdigest(), tables, functions, choosing)


def read(path):
    """Parse a C file of kernels; as `parse`."""
    return parse(Path(path).read_bytes().decode())
