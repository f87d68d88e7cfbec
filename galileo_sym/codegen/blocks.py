"""The ranges of the primitives' arguments one by one, in C: for arrays whose numbers lie in several of them."""

from dataclasses import dataclass
from math import inf, isinf, nextafter

from galileo_sym.codegen.kernels import c_number
from galileo_sym.primitives.frames import Frame
from galileo_sym.primitives.kernels import KERNELS

_LEAST_SINGLE, _BEYOND_SINGLES = 2.0**-149, 2.0**128


@dataclass(frozen=True)
class Kind:
    """The numbers that one range of a primitive serves: its index, the test of m, its call of m, a harmless argument.

    ``single`` tells whether floats are among them.
    """

    index: int
    test: str
    call: str
    harmless: float
    single: bool


@dataclass(frozen=True)
class Loop:
    """An array loop: the type of its arrays, how vectors are moved, and what ends the names of its functions."""

    real: str
    load: str
    store: str
    end: str


DOUBLES = Loop("double", "gs_v_load", "gs_v_store", "")
SINGLES = Loop("float", "gs_v_widen", "gs_v_narrow", "_single")

# parity: (what the ranges are of, the value found there with the sign that is due)
PARITIES = {"": ("x", "{}"), "even": ("gs_abs(x)", "{}"), "odd": ("gs_abs(x)", "gs_flip({}, x)")}


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
        least, greatest = sorted((abs(each.begin), abs(each.end)))
        single = least < _BEYOND_SINGLES and greatest > _LEAST_SINGLE
        out.append(Kind(index, test, _call(kernel, index), each.harmless, single))
    return out


def _test(kernel, kind):
    argument, _ = PARITIES[kernel.parity]
    return (
        f"static inline gs_mask gs_{kernel.name}_is_kind{kind.index}(gs_v x)\n{{\n    const gs_v m = {argument};\n"
        f"    return {kind.test};\n}}\n"
    )


def _value(kernel, kind):
    argument, signed = PARITIES[kernel.parity]
    rest = "    gs_v lo;\n" if "&lo" in kind.call else ""
    return (
        f"static inline gs_v gs_{kernel.name}_kind{kind.index}(gs_v x)\n{{\n{rest}    const gs_v m = {argument};\n"
        f"    const gs_v r = {kind.call};\n    return {signed.format('r')};\n}}\n"
    )


def mixed(kernel, others, loop):
    """Return the C function for a block: other kinds of numbers apart; all else, and the typical, the general way."""
    name, indices = f"gs_{kernel.name}", [kind.index for kind in others]
    every = (0, *indices)
    elsewhere = f"in{indices[0]}"
    for i in indices[1:]:
        elsewhere = f"gs_either({elsewhere}, in{i})"
    masks = [f"const gs_mask in{i} = {name}_is_kind{i}(v);" for i in indices]
    masks += [f"const gs_mask in0 = gs_not({elsewhere});"]
    lines = [
        f"static GS_RARE void {name}_mixed{loop.end}(size_t n, const {loop.real} *x, {loop.real} *value)",
        "{",
        f"    double {', '.join(f'part{i}[GS_BLOCK + GS_LANES]' for i in every)};",
        f"    size_t {', '.join(f'length{i} = 0' for i in every)}, {', '.join(f'taken{i} = 0' for i in every)};",
        "    for (size_t i = 0; i < n; i += GS_LANES) {",
        f"        const gs_v v = {loop.load}(x + i);",
        *(f"        {mask}" for mask in masks),
        *(f"        length{i} = gs_append(part{i}, length{i}, in{i}, v);" for i in every),
        "    }",
        f"    GS_SERVE({name}_any{loop.end}, {c_number(kernel.ranges[0].harmless)}, part0, length0);",
        *(
            f"    GS_SERVE({name}_kind{k.index}{loop.end}, {c_number(k.harmless)}, part{k.index}, length{k.index});"
            for k in others
        ),
        "    for (size_t i = 0; i < n; i += GS_LANES) {",
        f"        const gs_v v = {loop.load}(x + i);",
        *(f"        {mask}" for mask in masks),
        "        gs_v r = v;",
        *(f"        r = gs_take(part{i}, &taken{i}, in{i}, r);" for i in every),
        f"        {loop.store}(value + i, r);",
        "    }",
        "}",
    ]
    return "\n".join(lines) + "\n"


def _any(kernel):
    name = f"gs_{kernel.name}"
    return f"static inline gs_v {name}_any(gs_v x)\n{{\n    gs_v lo;\n    return {name}_value(x, &lo);\n}}\n"


def loops():
    """Return what ends the name of the array loop that serves a primitive best, by primitive."""
    return {name: "_blocks" if len(kinds(kernel)) > 1 else "_n" for name, kernel in KERNELS.items()}


def blocks_header(template):
    """Return the C header of all array loops in binary64."""
    out = []
    for name, kernel in KERNELS.items():
        found = kinds(kernel)
        out += [f"GS_LOOPS({name})\n", *(_test(kernel, kind) for kind in found)]
        if len(found) > 1:
            out += [
                *(_value(kernel, kind) for kind in found),
                _any(kernel),
                mixed(kernel, found[1:], DOUBLES),
                f"GS_BLOCKS({name})\n",
            ]
        out.append("\n")
    return template.replace("@KINDS@\n", "".join(out))
