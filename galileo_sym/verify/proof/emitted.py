"""The emitted kernels as data: tables of coefficients and lists of operations, parsed from the C that is compiled.

The grammar is what the emitter writes, and no more: `GS_TABLE(name) = {...};` and `static inline` functions of constant
declarations, look-ups in approximations, stores through a pointer parameter and one final return. Functions that choose
between these are kept as text, for `dispatch`. The rest is refused.
"""

import hashlib
import math
import re
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from pycparser import CParser, c_ast
from pycparser.c_parser import ParseError

from .emitted_nodes import RefusedSource, choice, exact_number, parameters_of, refuse, type_name

ARITY = {
    "gs_add": 2,
    "gs_sub": 2,
    "gs_mul": 2,
    "gs_div": 2,
    "gs_fma": 3,
    "gs_fms": 3,
    "gs_fnma": 3,
    "gs_min": 2,
    "gs_sqrt": 1,
    "gs_abs": 1,
    "gs_flip": 2,
    "gs_at_least": 2,
    "gs_less": 2,
    "gs_select": 3,
    "gs_exponent": 1,
    "gs_mantissa": 1,
    "gs_low_index": 1,
    "gs_power": 1,
    "gs_rest": 3,
    "gs_sum_rest": 3,
    "gs_product_rest": 3,
    "gs_v_of": 1,
    "gs_pick": 2,
    "gs_piece": 3,
}
LOOK_UPS = ("_near", "_near_pair")
CHOOSING = ("_value", "_outside")
_TYPES = "typedef double gs_v; typedef int gs_index; typedef int gs_mask;\n"
_TABLE = re.compile(r"\bGS_TABLE\((\w+)\)")  # what galileo_vector.h makes of it, but for the alignment
_RARE = re.compile(r"\bGS_RARE\b")
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_CONSTANTS = ("gs_v", "gs_index", "gs_mask")
_HARMLESS = re.compile(r"#\s*(include\b.*|ifndef\s+\w+|define\s+\w+_H|endif)$")


@dataclass(frozen=True)
class Number:
    """A constant: a double's exact value, or an integer; infinity as a float."""

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
class LookUp:
    """A call of an approximation's function, which defines a second variable: the rest."""

    function: str
    arguments: tuple
    rest: str


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


def _table(node):
    if not isinstance(node.init, c_ast.InitList):
        refuse(node, f"{node.name} has no list of values")
    values = tuple(map(exact_number, node.init.exprs))
    if None in values or len(values) != exact_number(node.type.dim):
        refuse(node, f"{node.name} is no full list of constants")
    return values


def _expression(node, known):
    value = exact_number(node)
    if value is not None:
        return Number(value)
    if isinstance(node, c_ast.ID) and node.name == "INFINITY":
        return Number(math.inf)
    if isinstance(node, c_ast.ID):
        if node.name not in known:
            refuse(node, f"{node.name} is used before it is defined")
        return Name(node.name)
    if not isinstance(node, c_ast.FuncCall) or not isinstance(node.name, c_ast.ID):
        refuse(node, f"{type(node).__name__} is no operation of the vector header")
    operation, arguments = node.name.name, node.args.exprs if node.args else []
    if ARITY.get(operation) != len(arguments):
        refuse(node, f"{operation} of {len(arguments)} arguments is no operation of the grammar")
    return Call(operation, tuple(_expression(argument, known) for argument in arguments))


def _look_up(node, known, functions, declared):
    """Return the call of an approximation, or None if it is no such call."""
    if not (isinstance(node, c_ast.FuncCall) and node.name.name.endswith(LOOK_UPS)):
        return None
    *arguments, last = node.args.exprs
    called = functions.get(node.name.name)
    written = isinstance(last, c_ast.UnaryOp) and last.op == "&" and isinstance(last.expr, c_ast.ID)
    if called is None or len(called.parameters) != len(arguments) or len(called.pointers) != 1:
        refuse(node, f"{node.name.name} is no function of these arguments that was defined before")
    if not written or last.expr.name not in declared:
        refuse(node, f"{node.name.name} does not write its rest to a variable declared for it")
    declared.remove(last.expr.name)
    return LookUp(node.name.name, tuple(_expression(a, known) for a in arguments), last.expr.name)


def _statement(node, known, pointers, functions, declared):
    """Return the name that a statement defines and its expression."""
    if isinstance(node, c_ast.Decl) and "const" in node.quals and type_name(node.type) in _CONSTANTS:
        if node.name in known or node.name in pointers or node.init is None:
            refuse(node, f"{node.name} is defined twice or not at all")
        return node.name, _look_up(node.init, known, functions, declared) or _expression(node.init, known)
    if isinstance(node, c_ast.Assignment) and node.op == "=" and isinstance(node.lvalue, c_ast.UnaryOp):
        target = node.lvalue
        if target.op == "*" and isinstance(target.expr, c_ast.ID) and target.expr.name in pointers:
            return target.expr.name, _expression(node.rvalue, known)
    return refuse(node, "neither a constant declaration nor a store through a pointer parameter")


def _is_declaration(node):
    """Return whether a statement declares a variable for the rest of a look-up."""
    plain = isinstance(node, c_ast.Decl) and node.init is None and not node.quals
    return plain and type_name(node.type) == "gs_v"


def _function(node, tables, functions):
    parameters, pointers = parameters_of(node)
    known = {*tables, *parameters}
    *body, last = node.body.block_items
    statements, declared = [], []
    for item in body:
        if _is_declaration(item):
            if item.name in known:
                refuse(item, f"{item.name} is defined twice")
            declared.append(item.name)
            continue
        name, expression = _statement(item, known, pointers, functions, declared)
        if name in [earlier for earlier, _ in statements]:
            refuse(item, f"{name} is written twice")
        statements.append((name, expression))
        if isinstance(expression, LookUp):
            known.add(expression.rest)
        if name not in pointers:
            known.add(name)
    if not isinstance(last, c_ast.Return):
        refuse(last, "the last statement is no return")
    unwritten = set(pointers) - {name for name, _ in statements}
    if unwritten:
        refuse(node, f"{', '.join(sorted(unwritten))} is never written")
    return Function(node.decl.name, parameters, pointers, tuple(statements), _expression(last.expr, known))


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
            known, name, made = choosing, node.decl.name, choice(node)
        elif isinstance(node, c_ast.FuncDef):
            known, name, made = functions, node.decl.name, _function(node, tables, functions)
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.ArrayDecl) and "const" in node.quals:
            known, name, made = tables, node.name, _table(node)
        else:
            refuse(node, f"{type(node).__name__} is neither a constant table nor a function")
        if name in tables or name in functions or name in choosing:
            refuse(node, f"{name} is defined twice")
        known[name] = made
    return Emitted(hashlib.sha256(text.encode()).hexdigest(), tables, functions, choosing)


def read(path):
    """Parse a C file of kernels; as `parse`."""
    return parse(Path(path).read_bytes().decode())
