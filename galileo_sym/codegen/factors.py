"""The primitives that the papers' formulas call, over a group of vectors, in C: of pairs, and of doubles alone.

A vector that holds numbers of two ranges would cost as much as both: those that the typical range does not serve are
put aside, and served side by side when the group is done.
"""

from math import isinf

from galileo_sym.codegen.kernels import c_number
from galileo_sym.codegen.pairs import PAIRS

# of their arguments none is negative
FACTORS = (
    *("phi1m", "phi2m", "descent_factor", "flight_factor", "range_factor"),
    *("range_loss", "grown_balance", "max_range_factor", "acot"),
)

_OF_PAIRS = """\
static inline gs_vp gs_vp_{name}_served{index}(gs_mask here, gs_vp x)
{{
    const gs_v least = {harmless}, zero = gs_v_of(0.0);
    gs_vp r;
    r.hi = gs_{name}_range{index}_pair(gs_select(here, x.hi, least), gs_select(here, x.lo, zero), &r.lo);
    return r;
}}
"""
_OF_DOUBLES = """\
static inline gs_v gs_s_{name}_served{index}(gs_mask here, gs_v x)
{{
    return gs_{name}_range{index}_lean(gs_select(here, x, {harmless}));
}}
"""


def _which(served, kernel, x):
    """Which lanes a range serves; the first one also what comes before it."""
    begin, end = c_number(served.begin), c_number(served.end)
    if isinf(served.end):
        return f"gs_at_least({x}, {begin})"
    return f"gs_less({x}, {end})" if served.begin == kernel.domain[0] else f"gs_within({x}, {begin}, {end})"


def _aside(kernel, kind, prefix, head, select):
    """The function of what was put aside, a vector at a time."""
    out = [
        f"static GS_RARE void {prefix}{kernel.name}_aside(gs_aside *aside)\n{{\n",
        f"    const size_t filled = {prefix}filled(aside);\n",
        "    for (size_t i = 0; i < filled; i += GS_LANES) {\n",
        f"        const {kind} x = {prefix}aside(aside, i);\n        {kind} r = x;\n        gs_mask here;\n",
    ]
    for index, served in enumerate(kernel.ranges[1:], 1):
        out += [
            f"        here = {_which(served, kernel, head)};\n        if (gs_bits_of(here))\n",
            f"            r = {select}(here, {prefix}{kernel.name}_served{index}(here, x), r);\n",
        ]
    return "".join([*out, f"        {prefix}put(aside, i, r);\n    }}\n}}\n"])


def _each(kernel, kind, prefix, head):
    """The function of a group, and of one vector."""
    name = f"{prefix}{kernel.name}"
    return (
        f"/* {kernel.doc}, of numbers inside the domain. */\n"
        f"static inline void {name}_each(size_t block, const {kind} *x, {kind} *value)\n{{\n"
        "    gs_aside aside;\n    aside.count = 0;\n"
        "    for (size_t i = 0; i < block; i++) {\n"
        f"        const gs_mask here = {_which(kernel.ranges[0], kernel, head)};\n"
        f"        value[i] = {name}_served0(here, x[i]);\n"
        f"        if (!gs_all(here))\n            {prefix}put_aside(&aside, gs_not(here), i, x[i]);\n    }}\n"
        f"    if (aside.count > 0) {{\n        {name}_aside(&aside);\n"
        f"        {prefix}put_back(&aside, value);\n    }}\n}}\n"
        f"static inline {kind} {name}({kind} x)\n{{\n"
        f"    const gs_mask here = {_which(kernel.ranges[0], kernel, head.replace('[i]', ''))};\n"
        f"    {kind} value;\n    if (gs_all(here))\n        return {name}_served0(here, x);\n"
        f"    {name}_each(1, &x, &value);\n    return value;\n}}\n\n"
    )


def _text(template, kind, prefix, part, select):
    out = []
    for kernel in (PAIRS[name] for name in FACTORS):
        for index, served in enumerate(kernel.ranges):
            out.append(template.format(name=kernel.name, index=index, harmless=c_number(served.harmless)))
        out += [_aside(kernel, kind, prefix, f"x{part}", select), _each(kernel, kind, prefix, f"x[i]{part}")]
    return "".join(out)


def of_pairs():
    """Return the functions of pairs."""
    return _text(_OF_PAIRS, "gs_vp", "gs_vp_", ".hi", "gs_vp_select")


def of_doubles():
    """Return the functions of doubles, for results in binary32."""
    return _text(_OF_DOUBLES, "gs_v", "gs_s_", "", "gs_select")
