"""The primitives' kernels for NumPy: the lines that the C is printed from, a function a form."""

from math import inf, isinf

from galileo_sym.codegen.pairs import PAIRS
from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.kernels import KERNELS
from galileo_sym.primitives.lines import alone, columns, near_lines, used

_FORMS = {  # what has no function of its own; a product's rest is exact, so fnma is no worse than fused
    "add": "{} + {}",
    "sub": "{} - {}",
    "mul": "{} * {}",
    "div": "{} / {}",
    "fma": "{} * {} + {}",
    "fnma": "-op.product_rest({}, {}, {})",
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
        return f"    {line.name}, {line.name}_lo = {bank}_{line.operation}({', '.join(arguments)})\n"
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


def _bank(bank):
    return _function(
        f"{bank}_near", "x", bank, near_lines(bank, False), f"{APPROXIMATIONS[bank].doc}, on its pieces."
    ) + _function(f"{bank}_near_pair", "x, x_lo", bank, near_lines(bank, True), "The same at x + x_lo.")


def _kernel(kernel):
    out, forms = [], []
    for number, served in enumerate(kernel.ranges):
        name = f"_{kernel.name}_{number}"
        where = f"for x in [{served.begin!r}, {served.end!r}{']' if isinf(served.end) else ')'}."
        out.append(_function(name, "x", kernel.name, alone(served.lines), f"{kernel.doc}, {where}"))
        out.append(_function(f"{name}_pair", "x, x_lo", kernel.name, used(served.lines), "The same at x + x_lo."))
        begin = -inf if served.begin == kernel.domain[0] else served.begin  # a pair may begin a little before it
        forms.append(f"        ({_number(begin)}, {_number(served.end)}, {name}, {name}_pair),\n")
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
    found = {}
    owners = [(bank, columns(bank)) for bank in _banks()] + [(k.name, k.tables) for k in PAIRS.values()]
    for owner, table in owners:
        for column, values in table.items():
            found[f"{owner}_{column}".upper()] = _table(owner, column, values)
    return found


def pieces():
    """Return the module of the tables that the primitives look up."""
    return (
        '"""Tables of the primitives: a row a coefficient, a place a piece."""\n\nfrom ._lines import row\n\n'
        + "".join(_tables().values())
    )


def special():
    """Return the module of the primitives."""
    body = "".join(map(_bank, _banks())) + "".join(map(_kernel, PAIRS.values()))
    rows = "".join(
        f'    "{n}": {{"outputs": 1, "angle": None, "kernels": {{(): {n}}}, "rest": True}},\n' for n in KERNELS
    )
    body += f"# As for the papers' functions; the kernels return the value and its rest.\nFUNCTIONS = {{\n{rows}}}\n"
    return (
        '"""The primitives on float64 arrays, as pairs: the nearest double but for a little, and the rest.\n\n'
        "NAME_pair(x, x_lo) is the same at x + x_lo. The pair is good to 2^-57 of the value, with the exceptions and\n"
        'domains that c/galileo_pairs.h names.\n"""\n\n'
        "from math import inf\n\nimport numpy as np\n\n"
        "from . import _lines as op\n"
        f"from ._pieces import (\n{''.join(f'    {name},{chr(10)}' for name in _tables())})\n\n\n{body}"
    ).rstrip("\n") + "\n"
