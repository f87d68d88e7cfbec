"""The primitives of an argument that is a pair, in C: of vectors, and of single numbers with a look at the domain.

One list of lines serves both: those for x are what `lines.alone` leaves of those for x + x_lo.
"""

from math import isinf

from galileo_sym.codegen.kernels import bank_text, c_number, lines_text, table_text
from galileo_sym.primitives.auxiliary_frames import FRAMES
from galileo_sym.primitives.kernels import KERNELS
from galileo_sym.primitives.lines import used

_HEAD = """\
/* The primitives of a pair, for the forms that compute with hi + lo: gs_NAME_rangeN_pair(x, x_lo, &lo) for vectors in
 * the Nth range, gs_NAME_pair(x, x_lo, &lo) for single numbers, NaN beyond the domain.
 *
 * The result r + lo is the value at x + x_lo, |x_lo| <= ulp(x)/2 (0 where x is infinite), to 2^-57 of it; r is the
 * nearest double but for a little (0.55 ulp), |lo| <= ulp(r)/2. But: where |r| < 2^-922, and for exp_minus from 640 on,
 * there is no room for lo, and r alone holds; where x < 2^-900 the offsets of W have |lo| <= 3/4 ulp(r).
 * exp(-x - x_lo) = (r + lo) 2^-m for x <= 2^15, r + lo by exp_mantissa and m by exp_exponent; r = 0 beyond.
 * Domains are those of x, up to and with its ends as pairs: -1/e for W, pi/2 for sine and cosine.
 */
#ifndef GALILEO_PAIRS_H
#define GALILEO_PAIRS_H

#include "galileo_frames.h"

#if GS_LANES == 1
/* x + x_lo below y + y_lo */
static inline gs_mask gs_before(gs_v x, gs_v x_lo, gs_v y, gs_v y_lo)
{
    return isless(x, y) || (x == y && isless(x_lo, y_lo));
}
#endif

"""

PAIRS = KERNELS | {frame.name: frame for frame in FRAMES}
_PARITIES = {"": ("x", "x_lo"), "even": ("gs_abs(x)", "gs_flip(x_lo, x)"), "odd": ("gs_abs(x)", "gs_flip(x_lo, x)")}


def _functions(kernel):
    out = [table_text(kernel.name, column, values) for column, values in kernel.tables.items() if kernel in FRAMES]
    for index, served in enumerate(kernel.ranges):
        lines = used(served.lines)
        out.append(
            f"/* x in [{served.begin!r}, {served.end!r}{']' if isinf(served.end) else ')'} */\n"
            f"static inline gs_v gs_{kernel.name}_range{index}_pair(gs_v x, gs_v x_lo, gs_v *lo)\n{{\n"
            f"{_unused(lines)}{lines_text(kernel.name, lines)}    return r;\n}}\n\n"
        )
    return "".join(out)


def _unused(lines):
    operands = {operand for line in lines for operand in line.operands}
    return "".join(f"    (void){name};\n" for name in ("x", "x_lo") if name not in operands)


def _choice(kernel):
    """The ranges from the last, which wins where two overlap, to the typical one, which is not looked for."""
    (lower, lower_lo), (upper, upper_lo) = (tuple(map(c_number, end)) for end in kernel.ends)
    argument, rest = _PARITIES[kernel.parity]
    out = [
        f"/* {kernel.doc}, at x + x_lo, |x_lo| no more than half an ulp of x: the nearest double but for a little, and"
        " the rest. */\n#if GS_LANES == 1\n"
        f"static inline gs_v gs_{kernel.name}_pair(gs_v x, gs_v x_lo, gs_v *lo)\n{{\n",
        f"    const gs_v m = {argument};\n    const gs_v m_lo = {rest};\n    gs_v r;\n",
        f"    if (isnan(x) || gs_before(x, x_lo, {lower}, {lower_lo}) || gs_before({upper}, {upper_lo}, x, x_lo)) {{\n",
        "        *lo = gs_v_of(0.0);\n"
        "        return gs_refuse_beyond(x, gs_v_of(INFINITY), gs_v_of(-INFINITY), x, lo);\n    }\n",
    ]
    typical, otherwise = f"r = gs_{kernel.name}_range0_pair(m, m_lo, lo);\n", ""
    for index, served in reversed(list(enumerate(kernel.ranges))[1:]):
        begin, end = c_number(served.begin), c_number(served.end)
        here = f"gs_at_least(m, {begin})" if isinf(served.end) else f"gs_within(m, {begin}, {end})"
        here = f"gs_less(m, {end})" if served.begin == kernel.domain[0] else here  # a pair may begin a little before
        out.append(f"    {otherwise}if ({here})\n        r = gs_{kernel.name}_range{index}_pair(m, m_lo, lo);\n")
        otherwise = "else "
    out.append(f"    else\n        {typical}" if otherwise else f"    {typical}")
    if kernel.parity == "odd":
        out.append("    *lo = gs_flip(*lo, x);\n    r = gs_flip(r, x);\n")
    return "".join([*out, "    return r;\n}\n#endif\n\n"])


def pairs_header():
    """Return the C header of all primitives of a pair."""
    known = {bank for kernel in KERNELS.values() for bank in kernel.banks}
    fresh = dict.fromkeys(bank for frame in FRAMES for bank in frame.banks if bank not in known)
    own = "".join(_functions(k) + _choice(k) for k in PAIRS.values())
    return "".join([_HEAD, *map(bank_text, fresh), own, "#endif\n"])
