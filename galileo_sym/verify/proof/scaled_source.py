"""The look-up of the scaled layer as data: its tables and its operations, parsed from the C that is compiled.

gs_lookup(table, x, x_lo) finds the piece of x, and evaluates its polynomial at x + x_lo as a pair. Its operations are
lowered to those of the vector header: a product or sum is one, gs_two_sum and gs_two_prod are a rounded operation and
its exact rest, the loop is written out.
"""

import re
from dataclasses import dataclass
from fractions import Fraction

from pycparser import CParser, c_ast, c_generator

from .binary64 import power, ulp
from .emitted import Call, Function, Name, RefusedSource
from .pieces import Piece

ROUNDED = {"+": "gs_add", "-": "gs_sub", "*": "gs_mul"}
PAIRS = {  # the rounded operation, and that of its rest
    "gs_two_sum": ("gs_add", "gs_sum_rest"),
    "gs_fast_two_sum": ("gs_add", "gs_rest"),
    "gs_two_prod": ("gs_mul", "gs_product_rest"),
}
# what the pair operations are in galileo_support.h, and how the piece is found
_BODIES = {
    "gs_two_sum": "const double s = a + b; const double t = s - a; "
    "const gs_pair r = {s, (a - (s - t)) + (b - t)}; return r;",
    "gs_fast_two_sum": "const double s = a + b; const gs_pair r = {s, b - (s - a)}; return r;",
    "gs_two_prod": "const double p = a * b; const gs_pair r = {p, fma(a, b, -p)}; return r;",
}
_SELECTION = (
    "int e;",
    "const double m = frexp(1.0 + x, &e);",
    "int i = ((e - 1) * GS_PER_BINADE) + ((int) floor((m - 0.5) * (2 * GS_PER_BINADE)));",
    "if (i < 0) i = 0;",
    "if (i > (table->count - 1)) i = table->count - 1;",
    "const double *row = table->rows[i];",
)
_TYPES = "typedef struct {double hi, lo;} gs_pair; typedef struct {double rows[1][1]; int count;} gs_table;\n"
_ROWS = re.compile(r"^static const double (\w+)_rows\[(\d+)\]\[GS_ROW\] = \{\n(.*?)\n\};$", re.DOTALL | re.MULTILINE)
_TABLE = re.compile(r"^const gs_table gs_(\w+)_table = \{(\w+)_rows, (\d+), ([^;]*)\};$", re.MULTILINE)
_DEFINE = re.compile(r"^#define (GS_\w+) (\d+)$", re.MULTILINE)
_LOOKUP = re.compile(r"^(?:static )?gs_pair gs_lookup\(.*?^\}$", re.DOTALL | re.MULTILINE)
_INLINE = re.compile(r"^static inline gs_pair (gs_\w+)\(double a, double b\)\n\{(.*?)^\}$", re.DOTALL | re.MULTILINE)


@dataclass(frozen=True)
class Far:
    """Beyond the table: 2^shift x^power (1 + correction x^-order); power 0 and correction 0 where there is none."""

    power: int
    shift: int
    correction: Fraction
    order: int


@dataclass(frozen=True)
class ScaledTable:
    """One table: its name, its pieces in order, where it ends, and what lies beyond."""

    name: str
    pieces: tuple
    end: Fraction
    far: Far


@dataclass(frozen=True)
class Scaled:
    """What the C of the scaled layer holds: tables by name, and gs_lookup lowered, its row's numbers as tables."""

    tables: dict
    lookup: Function


def _piece(index, row, per_binade):
    """Return a piece (all x with 1 + x rounded to its interval, and what x_lo may add to them), and its row."""
    lower, upper = (
        power(binade) * (1 + Fraction(step, per_binade)) - 1
        for binade, step in (divmod(i, per_binade) for i in (index, index + 1))
    )
    centre, c0, c0_lo, c1, c1_lo, *rest = row
    return Piece(
        index, lower - 2 * ulp(1 + lower), upper + 2 * ulp(1 + upper), centre, (c0 + c0_lo, c1 + c1_lo, *rest)
    ), tuple(row)


def _tables(text, sizes):
    """Return the tables by name, and the rows of each as they stand."""
    width, per_binade = sizes["GS_ROW"], sizes["GS_PER_BINADE"]
    rows = {}
    for name, count, body in _ROWS.findall(text):
        numbers = [Fraction(float(number)) for number in re.findall(r"[^\s,{}]+", body)]
        if len(numbers) != int(count) * width:
            raise RefusedSource(f"{name} has {len(numbers)} numbers, not {count} rows of {width}")
        rows[name] = [numbers[i : i + width] for i in range(0, len(numbers), width)]
    tables = {}
    for name, of, count, rest in _TABLE.findall(text):
        end, *far = (part.strip() for part in rest.split(","))
        if of != name or int(count) != len(rows[of]):
            raise RefusedSource(f"gs_{name}_table is not of its own {len(rows[of])} rows")
        made = tuple(_piece(i, row, per_binade) for i, row in enumerate(rows[of]))
        if made[-1][0].upper < Fraction(float(end)):
            raise RefusedSource(f"gs_{name}_table ends at {end}, beyond its last piece")
        shape = Far(int(far[0]), int(far[1]), Fraction(float(far[2])), int(far[3]))
        tables[name] = ScaledTable(name, made, Fraction(float(end)), shape)
    if not tables or set(tables) != set(rows):
        raise RefusedSource("a table has rows and no record, or a record and no rows")
    return tables


class _Lowering:
    """The statements of gs_lookup after the search of the piece, as operations of the vector header."""

    def __init__(self, sizes):
        self.sizes, self.statements, self.counters = sizes, [], {}

    def _stop(self, node):
        raise RefusedSource(f"gs_lookup: {c_generator.CGenerator().visit(node)} is outside the grammar")

    def _integer(self, node):
        if isinstance(node, c_ast.Constant) and node.type == "int":
            return int(node.value)
        if isinstance(node, c_ast.ID) and node.name in (known := self.sizes | self.counters):
            return known[node.name]
        if isinstance(node, c_ast.BinaryOp) and node.op in "+-":
            left, right = self._integer(node.left), self._integer(node.right)
            return left + right if node.op == "+" else left - right
        return self._stop(node)

    def expression(self, node):
        """Return the operations of one double."""
        if isinstance(node, c_ast.ID):
            return Name(node.name)
        if isinstance(node, c_ast.StructRef) and isinstance(node.name, c_ast.ID) and node.field.name in ("hi", "lo"):
            return Name(f"{node.name.name}.{node.field.name}")
        if isinstance(node, c_ast.ArrayRef) and isinstance(node.name, c_ast.ID) and node.name.name == "row":
            return Call("gs_pick", (Name(f"row{self._integer(node.subscript)}"), Name("i")))
        if isinstance(node, c_ast.BinaryOp) and node.op in ROUNDED:
            return Call(ROUNDED[node.op], (self.expression(node.left), self.expression(node.right)))
        return self._stop(node)

    def pair(self, name, node):
        """Write a pair: both operands by name, since their rest takes them once more."""
        if not isinstance(node, c_ast.FuncCall) or node.name.name not in PAIRS:
            self._stop(node)
        rounded, rest = PAIRS[node.name.name]
        operands = []
        for side, argument in zip("ab", node.args.exprs, strict=True):
            self.statements.append((f"{name}.{side}", self.expression(argument)))
            operands.append(Name(f"{name}.{side}"))
        self.statements.append((f"{name}.hi", Call(rounded, tuple(operands))))
        self.statements.append((f"{name}.lo", Call(rest, (*operands, Name(f"{name}.hi")))))

    def _repeat(self, node):
        (start,) = node.init.decls
        down = isinstance(node.next, c_ast.UnaryOp) and node.next.op == "p--"
        if not down or node.cond.op != ">=" or node.cond.left.name != start.name:
            self._stop(node)
        for value in range(self._integer(start.init), self._integer(node.cond.right) - 1, -1):
            self.counters[start.name] = value
            self.statement(node.stmt)

    def statement(self, node):
        """Lower one statement; a variable that is written again keeps its last value."""
        if isinstance(node, c_ast.Decl) and node.type.type.names == ["gs_pair"]:
            self.pair(node.name, node.init)
        elif isinstance(node, c_ast.Decl) and node.type.type.names == ["double"]:
            self.statements.append((node.name, self.expression(node.init)))
        elif isinstance(node, c_ast.Assignment) and node.op == "=" and isinstance(node.lvalue, c_ast.ID):
            self.statements.append((node.lvalue.name, self.expression(node.rvalue)))
        elif isinstance(node, c_ast.For):
            self._repeat(node)
        elif isinstance(node, c_ast.Return):
            self.pair("returned", node.expr)
        else:
            self._stop(node)


def _one_line(node):
    return " ".join(c_generator.CGenerator().visit(node).split()).rstrip(";") + ";"


def _lowered(text, sizes):
    """Return gs_lookup as a function of x and x_lo that stores lo and returns hi."""
    found = _LOOKUP.findall(text)
    if len(found) != 1:
        raise RefusedSource(f"{len(found)} functions gs_lookup")
    parsed = CParser().parse(_TYPES + found[0], "primitives.c").ext[-1]
    statements = parsed.body.block_items
    search, rest = statements[: len(_SELECTION)], statements[len(_SELECTION) :]
    if tuple(map(_one_line, search)) != _SELECTION:
        raise RefusedSource(f"gs_lookup finds its piece in another way: {' '.join(map(_one_line, search))}")
    lowering = _Lowering(sizes)
    for node in rest:
        lowering.statement(node)
    body = (*lowering.statements, ("lo", Name("returned.lo")))
    return Function("gs_lookup", ("x", "x_lo"), ("lo",), body, Name("returned.hi"))


def read(tables, support, primitives):
    """Parse the C of the scaled layer.

    Parameters
    ----------
    tables, support, primitives : str
        The texts of tables.c, galileo_support.h and primitives.c.

    Returns
    -------
    Scaled

    Raises
    ------
    RefusedSource
        If anything that the proof stands on is written in another way.
    """
    sizes = {name: int(value) for name, value in _DEFINE.findall(support)}
    bodies = {name: " ".join(body.split()) for name, body in _INLINE.findall(support)}
    for name, body in _BODIES.items():
        if bodies.get(name) != body:
            raise RefusedSource(f"galileo_support.h: {name} is {bodies.get(name)!r}")
    return Scaled(_tables(tables, sizes), _lowered(primitives, sizes))
