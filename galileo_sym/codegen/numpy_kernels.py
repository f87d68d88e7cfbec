"""The primitives' kernels for NumPy: the lines that the C is printed from, a function a form."""

from math import inf, isinf

from galileo_sym.codegen.numpy_banks import bank_text
from galileo_sym.codegen.pairs import PAIRS
from galileo_sym.primitives.kernels import KERNELS
from galileo_sym.primitives.lines import Line, alone, used
from galileo_sym.primitives.pairs import result

_FORMS = {  # what has no function of its own
    "add": "{} + {}",
    "sub": "{} - {}",
    "mul": "{} * {}",
    "div": "{} / {}",
    "fma": "{} * {} + {}",
    "rest": "({0} - {2}) + {1}",
    "sqrt": "np.sqrt({})",
    "abs": "np.abs({})",
    "min": "np.minimum({}, {})",
    "max": "np.maximum({}, {})",
    "at_least": "{} >= {}",
    "less": "{} < {}",
    "both": "{} & {}",
    "select": "np.where({}, {}, {})",
    "copy": "{}",
    "pick": "{}",
}
# Ranges of which NumPy has its own form: nothing is due for the sake of flags, and a table may be longer than sixteen.
_FUNCTIONS = {("exp_minus", 0): "fading"}
_LINES = {
    ("sin", 0): (Line("f", "near_pair", ("sine", "x", "x_lo")), *result("f")),
    ("arctan", 0): (Line("f", "near_pair", ("arctangent", "x", "x_lo")), *result("f")),
}


def _number(value):
    return f"{'-' * (value < 0)}inf" if isinf(value) else repr(value)


def _operand(owner, operand):
    if isinstance(operand, tuple):
        _, column, index = operand if len(operand) == 3 else (*operand, "i")
        return f"{owner.upper()}_{column.upper()}[{index}]"
    if isinstance(operand, float):
        return f"({_number(operand)})" if operand < 0 else _number(operand)
    return str(operand)


def _statement(owner, line):
    if line.operation in ("near", "near_pair"):
        bank, *arguments = line.operands
        return f"    {line.name}, {line.name}_lo = {line.operation}({', '.join([bank.upper(), *arguments])})\n"
    operands = [_operand(owner, operand) for operand in line.operands]
    form = _FORMS.get(line.operation) or f"op.{line.operation}({', '.join('{}' for _ in operands)})"
    return f"    {line.name} = {form.format(*operands)}\n"


def _function(name, arguments, owner, lines, doc):
    body = "".join(_statement(owner, line) for line in lines)
    return f'def {name}({arguments}):\n    """{doc}"""\n{body}    return r, lo\n\n\n'


def _table(owner, column, values):
    rows = [" ".join(v.hex() for v in values[i : i + 4]) for i in range(0, len(values), 4)]
    text = "\n".join(f'    "{row} "' for row in rows)
    return f"{owner.upper()}_{column.upper()} = row(\n{text}\n)\n"


def _kernel(kernel):
    out, forms = [], []
    for number, served in enumerate(kernel.ranges):
        name = f"_{kernel.name}_{number}"
        where = f"for x in [{served.begin!r}, {served.end!r}{']' if isinf(served.end) else ')'}."
        lines = _LINES.get((kernel.name, number), served.lines)
        begin = -inf if served.begin == kernel.domain[0] else served.begin  # a pair may begin a little before it
        if names := _FUNCTIONS.get((kernel.name, number), ""):
            names = f"{names}, {names}"
        else:
            out.append(_function(name, "x", kernel.name, alone(lines), f"{kernel.doc}, {where}"))
            out.append(_function(f"{name}_pair", "x, x_lo", kernel.name, used(lines), "The same at x + x_lo."))
            names = f"{name}, {name}_pair"
        forms.append(f"        ({_number(begin)}, {_number(served.end)}, {names}),\n")
    domain, *ends = (", ".join(map(_number, pair)) for pair in (kernel.domain, *kernel.ends))
    return (
        f"{''.join(out)}_{kernel.name.upper()} = {{\n"
        f'    "domain": ({domain}),\n    "ends": (({ends[0]}), ({ends[1]})),\n    "parity": "{kernel.parity}",\n'
        f'    "pole": {kernel.pole!r},\n'
        f'    "forms": (\n{"".join(forms)}    ),\n}}\n\n\n'
        f'def {kernel.name}(x):\n    """{kernel.doc}: the nearest double but for a little, and the rest."""\n'
        f"    return op.single(_{kernel.name.upper()}, x)\n\n\n"
        f"def {kernel.name}_pair(x, x_lo):\n"
        f'    """The same of x + x_lo, abs(x_lo) no more than half an ulp of x."""\n'
        f"    return op.paired(_{kernel.name.upper()}, x, x_lo)\n\n\n"
    )


def _banks():
    return list(dict.fromkeys(bank for kernel in PAIRS.values() for bank in kernel.banks))


def _tables():
    """Return {name: text} of all tables; two frames may share one."""
    found = {bank.upper(): bank_text(bank) for bank in _banks()}
    for kernel in PAIRS.values():
        for column, values in kernel.tables.items():
            found[f"{kernel.name}_{column}".upper()] = _table(kernel.name, column, values)
    return found


def pieces():
    """Return the module of the tables that the primitives look up."""
    return (
        '"""Tables of the primitives: a row a coefficient, a place a piece."""\n\n'
        "from ._lines import row\nfrom ._near import Bank\n\n" + "".join(_tables().values())
    )


def special():
    """Return the module of the primitives."""
    body = "".join(map(_kernel, PAIRS.values()))
    rows = "".join(
        f'    "{n}": {{"outputs": 1, "angle": None, "kernels": {{(): {n}}}, "rest": True}},\n' for n in KERNELS
    )
    forms = "".join(f'    "{n}": _{n.upper()},\n' for n in PAIRS)
    body += f"# Forms by range, of all.\nPRIMITIVES = {{\n{forms}}}\n\n"
    body += f"# As for the papers' functions; the kernels return the value and its rest.\nFUNCTIONS = {{\n{rows}}}\n"
    return (
        '"""The primitives on float64 arrays, as pairs: the nearest double but for a little, and the rest.\n\n'
        "NAME_pair(x, x_lo) is the same at x + x_lo. The pair is good to 2^-57 of the value, with the exceptions and\n"
        'domains that c/galileo_pairs.h names.\n"""\n\n'
        "from math import inf\n\nimport numpy as np\n\n"
        "from . import _lines as op\nfrom ._fading import fading\nfrom ._near import near, near_pair\n"
        f"from ._pieces import (\n{''.join(f'    {name},{chr(10)}' for name in _tables())})\n\n\n{body}"
    ).rstrip("\n") + "\n"
