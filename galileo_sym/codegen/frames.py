"""The primitives that take more than a look-up, in C: a function a range, and the choice among them."""

from math import isinf

from galileo_sym.codegen.kernels import bank_text, c_number, lines_text, table_text
from galileo_sym.primitives.frames import Frame
from galileo_sym.primitives.kernels import BANKED, KERNELS
from galileo_sym.primitives.lines import alone

_HEAD = """\
/* A function a range, of one operation a line, from x to r and *lo; gs_NAME_value chooses. The operations are those of
 * galileo_vector.h: add sub mul div sqrt min abs fma fnma; rest sum_rest product_rest; at_least less select flip;
 * piece low_index pick power exponent mantissa; and an approximation's gs_BANK_near(x, &lo) and
 * gs_BANK_near_pair(x, x_lo, &lo).
 */
"""


def _range_functions(frame):
    out = []
    for index, served in enumerate(frame.ranges):
        out.append(
            f"/* x in [{served.begin!r}, {served.end!r}{']' if isinf(served.end) else ')'} */\n"
            f"static inline gs_v gs_{frame.name}_range{index}(gs_v x, gs_v *lo)\n{{\n"
            f"{lines_text(frame.name, alone(served.lines))}    return r;\n}}\n\n"
        )
    return "".join(out)


def _mask(served):
    """Which lanes a range serves; one without end holds infinity."""
    begin, end = c_number(served.begin), c_number(served.end)
    return f"gs_at_least(m, {begin})" if isinf(served.end) else f"gs_within(m, {begin}, {end})"


# parity: (what the ranges are of, what the value, and the rest, are of those found there)
_PARITIES = {"": ("x", "{}"), "even": ("gs_abs(x)", "{}"), "odd": ("gs_abs(x)", "gs_flip({}, x)")}


def _chosen(frame):
    """Return the text of `_outside` and `_value`: the typical range alone, if it serves all lanes."""
    name, (typical, *others) = frame.name, frame.ranges
    argument, signed = _PARITIES[frame.parity]
    out = [
        f"static GS_RARE gs_v gs_{name}_outside(gs_v x, gs_v r, gs_v *lo)\n{{\n",
        f"    const gs_v m = {argument};\n    gs_v tail, rest;\n    gs_mask here;\n" if others else "",
    ]
    for index, served in enumerate(others, 1):
        harmless = c_number(served.harmless)
        out += [
            f"    here = {_mask(served)};\n",
            f"    tail = gs_{name}_range{index}(gs_select(here, m, {harmless}), &rest);\n",
            f"    r = gs_select(here, {signed.format('tail')}, r);\n",
            f"    *lo = gs_select(here, {signed.format('rest')}, *lo);\n",
        ]
    lower, upper = map(c_number, frame.domain)
    out += [
        f"    return gs_refuse_beyond(x, {lower}, {upper}, r, lo);\n}}\n\n",
        f"/* {frame.doc}: the nearest double but for a little, and the rest. */\n",
        f"static inline gs_v gs_{name}_value(gs_v x, gs_v *lo)\n{{\n",
        f"    const gs_v m = {argument};\n    const gs_mask here = {_mask(typical)};\n    gs_v rest;\n",
        f"    const gs_v r = gs_{name}_range0(gs_select(here, m, {c_number(typical.harmless)}), &rest);\n",
        f"    *lo = {signed.format('rest')};\n",
        f"    return gs_all(here) ? {signed.format('r')} : gs_{name}_outside(x, {signed.format('r')}, lo);\n}}\n",
    ]
    return "".join(out)


def frames_header():
    """Return the C header of all frames, with the approximations that no other primitive brings."""
    known = {bank for kernel in BANKED.values() for bank in kernel.banks}
    out = [_HEAD, "#ifndef GALILEO_FRAMES_H\n#define GALILEO_FRAMES_H\n\n", '#include "galileo_kernels.h"\n\n']
    for frame in (kernel for kernel in KERNELS.values() if isinstance(kernel, Frame)):
        fresh = [bank for bank in frame.banks if bank not in known]
        known.update(fresh)
        out += [bank_text(bank) for bank in fresh]
        out += [table_text(frame.name, column, values) for column, values in frame.tables.items()]
        out += [_range_functions(frame), _chosen(frame), "\n"]
    return "".join([*out, "#endif\n"])
