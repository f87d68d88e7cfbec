"""The primitives' kernels in C: one operation a line, over the vectors of galileo_vector.h."""

from math import isinf

from galileo_sym import processor
from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.kernels import BANKED, KERNELS
from galileo_sym.primitives.lines import columns, near_lines

_TYPES = {"at_least": "gs_mask", "both": "gs_mask", "less": "gs_mask", "low_index": "gs_index", "piece": "gs_index"}


def c_number(value):
    """Return a double as a vector of C."""
    return f"gs_v_of({'-' * (value < 0)}INFINITY)" if isinf(value) else f"gs_v_of({float(value).hex()})"


def _operand(owner, operand):
    if isinstance(operand, tuple):
        _, column, index = operand if len(operand) == 3 else (*operand, "i")
        return f"gs_pick(gs_{owner}_{column}, {index})"
    return c_number(operand) if isinstance(operand, float) else str(operand)


def lines_text(owner, lines):
    """Return the C statements of lines whose tables are those of a bank or a frame; `r` and `lo` are the results."""
    out = []
    for line in lines:
        if line.operation in ("near", "near_pair"):
            bank, *arguments = line.operands
            call = f"gs_{bank}_{line.operation}({', '.join(arguments)}, &{line.name}_lo)"
            out.append(f"    gs_v {line.name}_lo;\n    const gs_v {line.name} = {call};\n")
            continue
        operands = ", ".join(_operand(owner, o) for o in line.operands)
        value = operands if line.operation in ("copy", "pick") else f"gs_{line.operation}({operands})"
        target = "*lo" if line.name == "lo" else f"const {_TYPES.get(line.operation, 'gs_v')} {line.name}"
        out.append(f"    {target} = {value};\n")
    return "".join(out)


def table_text(owner, column, values):
    """Return the C table of a column."""
    rows = [values[i : i + 4] for i in range(0, len(values), 4)]
    text = ",\n".join("    " + ", ".join(v.hex() for v in row) for row in rows)
    return f"GS_TABLE(gs_{owner}_{column}) = {{\n{text}\n}};\n"


def bank_text(bank):
    """Return the C tables of an approximation, and the functions that evaluate it."""
    approximation = APPROXIMATIONS[bank]
    partition = approximation.partition
    tables = "".join(table_text(bank, column, values) for column, values in columns(bank).items())
    where = f"[{partition.begin!r}, {partition.end!r})"
    return (
        f"/* {approximation.doc}, on {where}: degree {approximation.degree} on each of 16 pieces. */\n"
        f"{tables}\n"
        f"static inline gs_v gs_{bank}_near(gs_v x, gs_v *lo)\n{{\n{lines_text(bank, near_lines(bank, False))}"
        f"    return r;\n}}\n\n"
        f"/* The same at x + x_lo, |x_lo| no more than half an ulp of x. */\n"
        f"static inline gs_v gs_{bank}_near_pair(gs_v x, gs_v x_lo, gs_v *lo)\n{{\n"
        f"{lines_text(bank, near_lines(bank, True))}    return r;\n}}\n\n"
    )


def _outside(kernel):
    """What serves the lanes that the first bank does not: the other banks, the far form, and what is no argument."""
    out = [
        f"/* x >= {kernel.end!r} */\nstatic inline gs_v gs_{kernel.name}_far(gs_v x)\n{{\n",
        lines_text("", kernel.far),
        "    return r;\n}\n\n",
        f"static GS_RARE gs_v gs_{kernel.name}_outside(gs_v x, gs_v r, gs_v *lo)\n{{\n    gs_v tail, rest;\n",
    ]
    for bank in kernel.banks[1:]:
        begin, end = (c_number(v) for v in (APPROXIMATIONS[bank].partition.begin, APPROXIMATIONS[bank].partition.end))
        out += [
            f"    const gs_mask here = gs_within(x, {begin}, {end});\n",
            f"    tail = gs_{bank}_near(gs_select(here, x, {begin}), &rest);\n",
            "    r = gs_select(here, tail, r);\n",
            "    *lo = gs_select(here, rest, *lo);\n",
        ]
    out += [
        f"    const gs_mask beyond = gs_at_least(x, {c_number(kernel.end)});\n",
        f"    tail = gs_{kernel.name}_far(gs_select(beyond, x, {c_number(kernel.end)}));\n",
        "    rest = gs_v_of(0.0);\n",
        "    *lo = gs_select(beyond, rest, *lo);\n",
        "    return gs_refuse_negative(x, gs_select(beyond, tail, r), lo);\n}\n\n",
    ]
    return "".join(out)


def _kernel(kernel):
    begin = APPROXIMATIONS[kernel.banks[0]].partition.begin
    end = APPROXIMATIONS[kernel.banks[0]].partition.end
    return (
        "".join(bank_text(bank) for bank in kernel.banks)
        + _outside(kernel)
        + f"/* {kernel.doc}: the nearest double but for a little, and the rest. */\n"
        f"static inline gs_v gs_{kernel.name}_value(gs_v x, gs_v *lo)\n{{\n"
        f"    const gs_mask here = gs_within(x, {c_number(begin)}, {c_number(end)});\n"
        f"    const gs_v r = gs_{kernel.name}_near(gs_select(here, x, {c_number(begin)}), lo);\n"
        f"    return gs_all(here) ? r : gs_{kernel.name}_outside(x, r, lo);\n}}\n"
    )


def kernels_header():
    """Return the C header of the kernels that need nothing but look-ups."""
    return (
        "#ifndef GALILEO_KERNELS_H\n#define GALILEO_KERNELS_H\n\n"
        '#include "galileo_vector.h"\n\n' + "\n".join(_kernel(kernel) for kernel in BANKED.values()) + "\n#endif\n"
    )


# suffix: (what the machine has, its features for the compiler, doubles in a vector)
TARGETS = {
    "avx512": ("machines with AVX-512", "avx512f,avx512bw,avx512dq,avx512vl,avx2,fma", 8),
    "avx2": ("machines with AVX2 and FMA", "avx2,fma", 4),
    "fma": ("single numbers on machines with FMA", "fma", 1),
}
CONDITION = "defined(__x86_64__) && defined(__GNUC__) && !defined(GS_PORTABLE)"


_VANISHING = ("exp_minus",)  # 0 is what a number too small for binary64 is rounded to
_LOOK_FOR = {None: "GS_NO_POLE", 0.0: "GS_POLE_AT_0"}


def runnable():
    """Return the suffixes of the versions that this machine can run, the plain one first."""
    found = processor.features()
    return ("plain", *(s for s, (_, needed, _) in TARGETS.items() if found.issuperset(needed.split(","))))


# source: (what it holds, the header that defines it, for which machines)
VERSIONED = {
    "c/special": ("The primitives", "galileo_singles.h", tuple(TARGETS)),
    "c/lanes": ("The formulas of the papers", "galileo_forms.h", tuple(TARGETS)),
    "extension/steps": ("Steps of scenes", "steps.h", ("fma",)),
    "extension/sums": ("Sums of scenes", "sums.h", ("avx512", "avx2")),
}


def target_sources(template, folder):
    """Return the text of each version of the sources of `VERSIONED` in a folder, by path."""
    found = {}
    for name, (what, header, suffixes) in VERSIONED.items():
        for suffix in suffixes if name.startswith(f"{folder}/") else ():
            machine, features, lanes = TARGETS[suffix]
            words = {"MACHINE": machine, "FEATURES": features, "LANES": str(lanes), "SUFFIX": suffix, "WHAT": what}
            text = template
            for word, meant in (words | {"HEADER": header, "CONDITION": CONDITION}).items():
                text = text.replace(f"@{word}@", meant)
            found[f"{name}_{suffix}.c"] = text
    return found


def public_source(template, loops):
    """Return the source of the public functions, which choose a version; ``loops`` ends the names of array loops."""
    public = "".join(
        f"GS_PUBLIC({name}, {loop}, {_LOOK_FOR[KERNELS[name].pole]}, {int(name in _VANISHING)})\n"
        for name, loop in loops.items()
    )
    return template.replace("@CONDITION@", CONDITION).replace("@PUBLIC@\n", public)


def prototypes():
    """Return the declarations of the public functions, with what each computes."""
    out = ["/* One-variable functions, dimensionless, of x in the domain given. Beyond it: NaN and FE_INVALID. */\n"]
    for name, kernel in KERNELS.items():
        out.append(
            f"\n/* {kernel.doc}, x in [{kernel.domain[0]!r}, {kernel.domain[1]!r}] */\n"
            f"double gs_special_{name}(double x);\n"
            f"void gs_special_{name}_n(size_t n, const double *x, double *value);\n"
            f"float gs_special_{name}f(float x);\n"
            f"void gs_special_{name}_nf(size_t n, const float *x, float *value);\n"
        )
    return "".join(out)
