"""The primitives in plain double arithmetic, in C: for formulas in binary32, and for those primitives themselves."""

from galileo_sym.codegen.kernels import c_number, lines_text, table_text
from galileo_sym.codegen.pairs import IN_LANES, PAIRS, served_text
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


def _name(kernel):
    """A primitive may have the name of its approximation."""
    return f"gs_{kernel.name}_all"


def _choice(kernel):
    call = "gs_{}_range{}_lean(gs_select(here, x, {}))".format
    typical, *others = kernel.ranges
    out = [f"static GS_RARE gs_v gs_{kernel.name}_rarely_lean(gs_v x, gs_v r)\n{{\n    gs_mask here;\n"]
    for index, served in enumerate(others, 1):
        out += [
            f"    here = {served_text(served, kernel)};\n    if (gs_bits_of(here))\n",
            f"        r = gs_select(here, {call(kernel.name, index, c_number(served.harmless))}, r);\n",
        ]
    out += [
        "    return r;\n}\n\n",
        f"/* {kernel.doc}, of vectors inside the domain. */\nstatic inline gs_v {_name(kernel)}(gs_v x)\n{{\n",
        f"    const gs_mask here = {served_text(typical, kernel)};\n",
        f"    const gs_v r = {call(kernel.name, 0, c_number(typical.harmless))};\n",
        f"    return gs_all(here) ? r : gs_{kernel.name}_rarely_lean(x, r);\n}}\n\n",
    ]
    return "".join(out)


def lean_header():
    """Return the C header of all primitives in plain arithmetic, with the approximations they call."""
    others = [kernel for name, kernel in KERNELS.items() if name not in IN_LANES]
    kernels = [PAIRS[name] for name in IN_LANES]
    ranges = {kernel.name: dict(enumerate(plain(each) for each in kernel.ranges)) for kernel in kernels}
    for kernel in others:
        served = [kind.index for kind in single_kinds(kernel)]
        ranges[kernel.name] = {index: plain(kernel.ranges[index]) for index in served}
    needed = dict.fromkeys(bank for lines in ranges.values() for each in lines.values() for bank in banks(each))
    out = [_HEAD, *map(_bank_text, needed)]
    for kernel in (*kernels, *others):
        out += [_range_text(kernel, index, lines) for index, lines in ranges[kernel.name].items()]
        out.append(_choice(kernel) if kernel in kernels else "")
    return "".join([*out, "#endif\n"])


def calls():
    """Return the formulas' calls of these."""
    return "".join(
        f"static inline gs_v gs_s_{name}(gs_v x) {{ return {_name(PAIRS[name])}(x); }}\n" for name in IN_LANES
    )
