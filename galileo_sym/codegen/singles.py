"""The primitives in binary32, in C: plain double arithmetic where that settles the rounding, else pairs."""

from galileo_sym.codegen.blocks import PARITIES, SINGLES, kinds, mixed
from galileo_sym.codegen.kernels import c_number
from galileo_sym.primitives.kernels import KERNELS


def single_kinds(kernel):
    """Return the kinds of a primitive's numbers that floats can be of, the typical ones first."""
    return [kind for kind in kinds(kernel) if kind.single]


def _quick(kernel, kind):
    """The function of a vector of one kind of numbers, in plain arithmetic."""
    argument, signed = PARITIES[kernel.parity]
    call = signed.format(f"gs_{kernel.name}_range{kind.index}_lean({argument})")
    return f"static inline gs_v gs_{kernel.name}_quick{kind.index}(gs_v x)\n{{\n    return {call};\n}}\n"


def _kind(kernel, kind):
    name = f"gs_{kernel.name}"
    return (
        f"static inline gs_v {name}_kind{kind.index}_single(gs_v x)\n{{\n"
        f"    const gs_v r = {name}_quick{kind.index}(x);\n"
        f"    return gs_all(gs_rounds_one_way(r)) ? r : {name}_settled(x);\n}}\n"
    )


def _any(kernel):
    name, harmless = f"gs_{kernel.name}", c_number(kernel.ranges[0].harmless)
    return (
        f"static GS_RARE gs_v {name}_settled(gs_v wide)\n{{\n    gs_v lo;\n"
        f"    const gs_v hi = {name}_value(wide, &lo);\n    return gs_to_odd(hi, lo);\n}}\n"
        f"static inline gs_v {name}_any_single(gs_v x)\n{{\n"
        f"    const gs_mask typical = {name}_is_kind0(x);\n"
        f"    const gs_v r = {name}_quick0(gs_select(typical, x, {harmless}));\n"
        f"    return gs_all(gs_both(typical, gs_rounds_one_way(r))) ? r : {name}_settled(x);\n}}\n"
    )


def _mixed(kernel, others):
    if others:
        return "".join(_kind(kernel, kind) for kind in others) + mixed(kernel, others, SINGLES)
    name = f"gs_{kernel.name}"
    return (
        f"static GS_RARE void {name}_mixed_single(size_t n, const float *x, float *value)\n{{\n"
        "    for (size_t i = 0; i < n; i += GS_LANES)\n"
        f"        gs_v_narrow(value + i, {name}_any_single(gs_v_widen(x + i)));\n}}\n"
    )


def singles_header(template):
    """Return the C header of the primitives in binary32, correctly rounded, for a source that has set GS_SUFFIX."""
    out = []
    for name, kernel in KERNELS.items():
        found = single_kinds(kernel)
        out += [*(_quick(kernel, kind) for kind in found), _any(kernel), _mixed(kernel, found[1:])]
        out.append(f"GS_SINGLES({name})\n\n")
    return template.replace("@SINGLES@\n", "".join(out))
