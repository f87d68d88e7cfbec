"""The primitives' kernels in C: one operation a line, over the vectors of galileo_vector.h."""

from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.kernels import KERNELS, columns, near_lines

_TYPES = {"piece": "gs_index"}


def _number(value):
    return f"gs_v_of({float(value).hex()})"


def _operand(bank, operand):
    if isinstance(operand, tuple):
        return f"gs_pick(gs_{bank}_{operand[1]}, i)"
    return _number(operand) if isinstance(operand, float) else str(operand)


def _lines(bank, lines):
    """C statements; `r` and `lo` are the results."""
    out = []
    for line in lines:
        operands = ", ".join(_operand(bank, o) for o in line.operands)
        value = operands if line.operation == "pick" else f"gs_{line.operation}({operands})"
        target = "*lo" if line.name == "lo" else f"const {_TYPES.get(line.operation, 'gs_v')} {line.name}"
        out.append(f"    {target} = {value};\n")
    return "".join(out)


def _table(bank):
    out = []
    for column, values in columns(bank).items():
        rows = [values[i : i + 4] for i in range(0, len(values), 4)]
        text = ",\n".join("    " + ", ".join(v.hex() for v in row) for row in rows)
        out.append(f"GS_TABLE(gs_{bank}_{column}) = {{\n{text}\n}};\n")
    return "".join(out)


def _bank(bank):
    approximation = APPROXIMATIONS[bank]
    partition = approximation.partition
    where = f"[{partition.begin!r}, {partition.end!r})"
    return (
        f"/* {approximation.doc}, on {where}: degree {approximation.degree} on each of 16 pieces. */\n"
        f"{_table(bank)}\n"
        f"static inline gs_v gs_{bank}_near(gs_v x, gs_v *lo)\n{{\n{_lines(bank, near_lines(bank, False))}"
        f"    return r;\n}}\n\n"
        f"/* The same at x + x_lo, |x_lo| no more than half an ulp of x. */\n"
        f"static inline gs_v gs_{bank}_near_pair(gs_v x, gs_v x_lo, gs_v *lo)\n{{\n"
        f"{_lines(bank, near_lines(bank, True))}    return r;\n}}\n\n"
    )


def _outside(kernel):
    """What serves the lanes that the first bank does not: the other banks, the far form, and what is no argument."""
    out = [
        f"/* x >= {kernel.end!r} */\nstatic inline gs_v gs_{kernel.name}_far(gs_v x)\n{{\n",
        _lines("", kernel.far),
        "    return r;\n}\n\n",
        f"static GS_RARE gs_v gs_{kernel.name}_outside(gs_v x, gs_v r, gs_v *lo)\n{{\n    gs_v tail, rest;\n",
    ]
    for bank in kernel.banks[1:]:
        begin, end = (_number(v) for v in (APPROXIMATIONS[bank].partition.begin, APPROXIMATIONS[bank].partition.end))
        out += [
            f"    const gs_mask here = gs_within(x, {begin}, {end});\n",
            f"    tail = gs_{bank}_near(gs_select(here, x, {begin}), &rest);\n",
            "    r = gs_select(here, tail, r);\n",
            "    *lo = gs_select(here, rest, *lo);\n",
        ]
    out += [
        f"    const gs_mask beyond = gs_at_least(x, {_number(kernel.end)});\n",
        f"    tail = gs_{kernel.name}_far(gs_select(beyond, x, {_number(kernel.end)}));\n",
        "    rest = gs_v_of(0.0);\n",
        "    *lo = gs_select(beyond, rest, *lo);\n",
        "    return gs_refuse_negative(x, gs_select(beyond, tail, r), lo);\n}\n\n",
    ]
    return "".join(out)


def _kernel(kernel):
    begin = APPROXIMATIONS[kernel.banks[0]].partition.begin
    end = APPROXIMATIONS[kernel.banks[0]].partition.end
    return (
        "".join(_bank(bank) for bank in kernel.banks)
        + _outside(kernel)
        + f"/* {kernel.doc}: the nearest double but for a little, and the rest. */\n"
        f"static inline gs_v gs_{kernel.name}_value(gs_v x, gs_v *lo)\n{{\n"
        f"    const gs_mask here = gs_within(x, {_number(begin)}, {_number(end)});\n"
        f"    const gs_v r = gs_{kernel.name}_near(gs_select(here, x, {_number(begin)}), lo);\n"
        f"    return gs_all(here) ? r : gs_{kernel.name}_outside(x, r, lo);\n}}\n"
    )


def kernels_header():
    """Return the C header of all kernels."""
    return (
        "#ifndef GALILEO_KERNELS_H\n#define GALILEO_KERNELS_H\n\n"
        '#include "galileo_vector.h"\n\n' + "\n".join(_kernel(kernel) for kernel in KERNELS.values()) + "\n#endif\n"
    )


# suffix: (what the machine has, its features for the compiler, doubles in a vector)
TARGETS = {
    "avx512": ("machines with AVX-512", "avx512f,avx512bw,avx512dq,avx512vl,avx2,fma", 8),
    "avx2": ("machines with AVX2 and FMA", "avx2,fma", 4),
    "fma": ("single numbers on machines with FMA", "fma", 1),
}
CONDITION = "defined(__x86_64__) && defined(__GNUC__) && !defined(GS_PORTABLE)"


def _each(macro):
    return "".join(f"{macro}({name})\n" for name in KERNELS)


def target_source(template, suffix):
    """Return the source of one version of all primitives."""
    machine, features, lanes = TARGETS[suffix]
    words = {"MACHINE": machine, "FEATURES": features, "LANES": str(lanes), "SUFFIX": suffix, "CONDITION": CONDITION}
    for word, text in (words | {"LOOPS": _each("GS_LOOPS")}).items():
        template = template.replace(f"@{word}@", text)
    return template


def public_source(template):
    """Return the source of the public functions, which choose a version."""
    return template.replace("@CONDITION@", CONDITION).replace("@PUBLIC@\n", _each("GS_PUBLIC"))


def prototypes():
    """Return the declarations of the public functions, with what each computes."""
    out = ["/* One-variable functions of x >= 0, dimensionless. Beyond the domain: NaN and FE_INVALID. */\n"]
    for name, kernel in KERNELS.items():
        out.append(
            f"\n/* {kernel.doc} */\n"
            f"double gs_special_{name}(double x);\n"
            f"void gs_special_{name}_n(size_t n, const double *x, double *value);\n"
            f"float gs_special_{name}f(float x);\n"
            f"void gs_special_{name}_nf(size_t n, const float *x, float *value);\n"
        )
    return "".join(out)
