"""The ranges of the primitives' arguments one by one, in C: for arrays whose numbers lie in several of them."""

from dataclasses import dataclass
from math import inf, isinf, nextafter

from galileo_sym.codegen.kernels import c_number
from galileo_sym.primitives.frames import Frame
from galileo_sym.primitives.kernels import KERNELS


@dataclass(frozen=True)
class Kind:
    """The numbers that one form serves: the test of m for them, the form's call of m, an argument it takes."""

    test: str
    call: str
    harmless: float


# parity: (what the ranges are of, the value found there with the sign that is due)
_PARITIES = {"": ("x", "{}"), "even": ("gs_abs(x)", "{}"), "odd": ("gs_abs(x)", "gs_flip({}, x)")}


def _call(kernel, index):
    if isinstance(kernel, Frame):
        return f"gs_{kernel.name}_range{index}(m, &lo)"
    if index < len(kernel.banks):
        return f"gs_{kernel.banks[index]}_near(m, &lo)"
    return f"gs_{kernel.name}_far(m)"


def kinds(kernel):
    """Return the kinds of a primitive's numbers, the typical ones first; a range of one number makes none."""
    served = kernel.ranges if isinstance(kernel, Frame) else kernel.ranges[: len(kernel.banks) + 1]
    singles = {each.begin for each in served if each.begin == each.end or nextafter(each.begin, inf) == each.end}
    out = []
    for index, each in enumerate(served):
        if each.begin in singles:
            continue
        begin, end = c_number(each.begin), c_number(each.end)
        open_end = isinf(each.end) and inf not in singles
        test = f"gs_at_least(m, {begin})" if open_end else f"gs_within(m, {begin}, {end})"
        out.append(Kind(test, _call(kernel, index), each.harmless))
    return out


def _functions(kernel, index, kind):
    name = f"gs_{kernel.name}"
    argument, signed = _PARITIES[kernel.parity]
    rest = "    gs_v lo;\n" if "&lo" in kind.call else ""
    return (
        f"static inline gs_mask {name}_is_kind{index}(gs_v x)\n{{\n    const gs_v m = {argument};\n"
        f"    return {kind.test};\n}}\n"
        f"static inline gs_v {name}_kind{index}(gs_v x)\n{{\n{rest}    const gs_v m = {argument};\n"
        f"    const gs_v r = {kind.call};\n    return {signed.format('r')};\n}}\n"
    )


def _mixed(kernel, others):
    """A block: its numbers by kind; all else, and the typical ones, go the general way."""
    name, indices = f"gs_{kernel.name}", range(1, len(others) + 1)
    every = (0, *indices)
    either = "in1"
    for i in indices[1:]:
        either = f"gs_either({either}, in{i})"
    masks = [f"const gs_mask in{i} = {name}_is_kind{i}(v);" for i in indices]
    masks += [f"const gs_mask in0 = gs_not({either});"]
    lines = [
        f"static inline gs_v {name}_any(gs_v x)",
        "{",
        "    gs_v lo;",
        f"    return {name}_value(x, &lo);",
        "}",
        f"static GS_RARE void {name}_mixed(size_t n, const double *x, double *value)",
        "{",
        f"    double {', '.join(f'part{i}[GS_BLOCK + GS_LANES]' for i in every)};",
        f"    size_t {', '.join(f'length{i} = 0' for i in every)}, {', '.join(f'taken{i} = 0' for i in every)};",
        "    for (size_t i = 0; i < n; i += GS_LANES) {",
        "        const gs_v v = gs_v_load(x + i);",
        *(f"        {mask}" for mask in masks),
        *(f"        length{i} = gs_append(part{i}, length{i}, in{i}, v);" for i in every),
        "    }",
        f"    GS_SERVE({name}_any, {c_number(kernel.ranges[0].harmless)}, part0, length0);",
        *(
            f"    GS_SERVE({name}_kind{i}, {c_number(kind.harmless)}, part{i}, length{i});"
            for i, kind in zip(indices, others, strict=True)
        ),
        "    for (size_t i = 0; i < n; i += GS_LANES) {",
        "        const gs_v v = gs_v_load(x + i);",
        *(f"        {mask}" for mask in masks),
        "        gs_v r = v;",
        *(f"        r = gs_take(part{i}, &taken{i}, in{i}, r);" for i in every),
        "        gs_v_store(value + i, r);",
        "    }",
        "}",
    ]
    return "\n".join(lines) + "\n"


def loops():
    """Return what ends the name of the array loop that serves a primitive best, by primitive."""
    return {name: "_blocks" if len(kinds(kernel)) > 1 else "_n" for name, kernel in KERNELS.items()}


def blocks_header(template):
    """Return the C header of all array loops in binary64."""
    out = []
    for name, kernel in KERNELS.items():
        found = kinds(kernel)
        out.append(f"GS_LOOPS({name})\n")
        if len(found) > 1:
            out += [_functions(kernel, index, kind) for index, kind in enumerate(found)]
            out += [_mixed(kernel, found[1:]), f"GS_BLOCKS({name})\n\n"]
    return template.replace("@KINDS@\n", "".join(out))
