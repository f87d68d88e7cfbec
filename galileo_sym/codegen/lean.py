"""The primitives in plain double arithmetic, in C: for formulas in binary32, and for those primitives themselves."""

from galileo_sym.codegen.factors import FACTORS
from galileo_sym.codegen.kernels import lines_text, table_text
from galileo_sym.codegen.pairs import PAIRS
from galileo_sym.codegen.singles import single_kinds
from galileo_sym.primitives.kernels import KERNELS
from galileo_sym.primitives.lean import TOLERANCE, banks, columns, near_lines, plain

_HEAD = f"""\
/* The primitives in plain double arithmetic, for results in binary32: their approximations within {TOLERANCE:.1g}. */
#ifndef GALILEO_LEAN_H
#define GALILEO_LEAN_H

#include "galileo_pairs.h"

"""


def _bank_text(bank):
    tables = "".join(table_text(bank, column, values) for column, values in columns(bank).items())
    return (
        f"{tables}\nstatic inline gs_v gs_{bank}_lean(gs_v x)\n{{\n"
        f"{lines_text(bank, near_lines(bank))}    return r;\n}}\n\n"
    )


def _range_text(kernel, index, lines):
    unused = "" if any("x" in line.operands for line in lines) else "    (void)x;\n"
    return (
        f"static inline gs_v gs_{kernel.name}_range{index}_lean(gs_v x)\n{{\n{unused}"
        f"{lines_text(kernel.name, lines)}    return r;\n}}\n\n"
    )


def lean_header():
    """Return the C header of all primitives in plain arithmetic, with the approximations they call."""
    others = [kernel for name, kernel in KERNELS.items() if name not in FACTORS]
    kernels = [PAIRS[name] for name in FACTORS]
    ranges = {kernel.name: dict(enumerate(plain(each) for each in kernel.ranges)) for kernel in kernels}
    for kernel in others:
        served = [kind.index for kind in single_kinds(kernel)]
        ranges[kernel.name] = {index: plain(kernel.ranges[index]) for index in served}
    needed = dict.fromkeys(bank for lines in ranges.values() for each in lines.values() for bank in banks(each))
    out = [_HEAD, *map(_bank_text, needed)]
    for kernel in (*kernels, *others):
        out += [_range_text(kernel, index, lines) for index, lines in ranges[kernel.name].items()]
    return "".join([*out, "#endif\n"])
