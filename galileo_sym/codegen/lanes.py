"""The papers' formulas on vectors, in C: which there are, their headers, and the choice of a version."""

from itertools import product

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen.arithmetic import DOUBLE, SINGLE
from galileo_sym.codegen.forms import definition
from galileo_sym.codegen.kernels import CONDITION, TARGETS, table_text
from galileo_sym.codegen.signatures import (
    ARRAYS,
    VALUES,
    array_signature,
    fullest,
    is_single,
    letter,
    name_of,
    parameters,
    scalar_signature,
    scaled_name,
    widened_signature,
)
from galileo_sym.primitives.tables import TURN_COUNT, TURN_STEP, constants, pair_rows, turn_rows

ARITHMETICS = (DOUBLE, SINGLE)
_SECOND_TERMS, _SECOND_PAIRS = 18, 4  # 2**-64 of the sum, for s below 3/4


def in_lanes(function):
    """Whether a function has forms on vectors: not one that is a primitive, which has its own."""
    return not function.primitive


def forms():
    """Return (function, force set) of every form on vectors."""
    return [(f, s) for f in FUNCTIONS.values() if in_lanes(f) for s in f.variants]


def shapes(function):
    """Return the shapes of a function's forms."""
    return (ARRAYS, VALUES) if function.positional and function.keywords else (ARRAYS,)


def takes_values(function):
    """Whether there are forms of one value for each keyword argument."""
    return in_lanes(function) and VALUES in shapes(function)


def _every(function):
    return product(shapes(function), ARITHMETICS)


def turn_tables():
    """Return the tables of sine and cosine at the multiples of a step, and pi/2 as a sum of doubles."""
    half = constants()["half_pi"]
    rows = turn_rows()
    columns = {"sine": 0, "sine_lo": 1, "cosine": 2, "cosine_lo": 3}
    tables = "".join(table_text("turn", name, tuple(row[i] for row in rows)) for name, i in columns.items())
    macros = "".join(f"#define GS_HALF_TURN_{i} {half[i].hex()}\n" for i in range(3))
    return (
        f"#define GS_QUARTER_TURN {(half[0] / 2).hex()}\n{macros}"
        f"#define GS_TURN_STEP {TURN_STEP.hex()}\n#define GS_TURNS_A_RADIAN {(1 / TURN_STEP).hex()}\n"
        f"/* Sine and cosine of 0 to {TURN_COUNT - 1} steps. */\n{tables}"
    )


def second_series():
    """Return the coefficients of phi2 at -s, the first as pairs, and their numbers."""
    rows = pair_rows("decay_series", _SECOND_TERMS)
    text = ",\n".join(f"    {{{hi.hex()}, {lo.hex()}}}" for hi, lo in rows)
    return (
        f"#define GS_SECOND_TERMS {_SECOND_TERMS}\n#define GS_SECOND_PAIRS {_SECOND_PAIRS}\n"
        f"static const double gs_second_series[GS_SECOND_TERMS][2] = {{\n{text},\n}};\n"
    )


def scaled_header():
    """Return the C header of the scaled forms."""
    out = [
        "#ifndef GALILEO_SCALED_H\n#define GALILEO_SCALED_H\n\n"
        "/* The formulas on scaled pairs: for single numbers of any size, where the forms on vectors do not serve. */\n"
    ]
    out += [f"{scalar_signature(f, s, 'double', scaled_name(f, s))};\n" for f, s in forms()]
    out.append("/* An argument that has a largest value: the float next to that counts as it. */\n")
    out += [f"{widened_signature(f, s)};\n" for f, s in forms() if f.ceiling]
    return "".join([*out, "\n#endif\n"])


def forms_header():
    """Return the C header that defines all forms for a source that has set GS_LANES and GS_SUFFIX."""
    definitions = "\n".join(definition(f, s, shape, arithmetic) for f, s in forms() for shape, arithmetic in _every(f))
    included = "".join(f'#include "galileo_{name}.h"\n' for name in ("loops", "launch", "roots", "scaled"))
    return f"#ifndef GALILEO_FORMS_H\n#define GALILEO_FORMS_H\n\n{included}\n{definitions}\n#endif\n"


def _declarations(suffix):
    """Declarations of one version of all forms."""
    return "".join(
        f"{array_signature(f, s, shape, arithmetic.kind, version=f'_{suffix}')};\n"
        for f, s in forms()
        for shape, arithmetic in _every(f)
    )


def _chooser(function, force_set, shape, kind, public):
    names = ", ".join(name for _, name in parameters(function, force_set, shape, kind))
    return (
        f"{array_signature(function, force_set, shape, kind, public)}\n{{\n"
        f"    GS_CHOOSE({name_of(function, force_set)}_{shape}{letter(kind)})({names});\n}}\n\n"
    )


def _scalar(function, force_set, kind, public):
    signature = scalar_signature(function, force_set, kind, name_of(function, public, letter(kind)))
    passed = [f"&{a.name}" for a in function.arguments(force_set)]
    call = f"GS_CHOOSE_SINGLE({name_of(function, force_set)}_{ARRAYS}{letter(kind)})"
    names = [o.name for o in function.outputs]
    if not is_single(function):
        return f"{signature}\n{{\n    {call}(1, {', '.join([*passed, *names])});\n}}\n\n"
    return (
        f"{signature}\n{{\n    {kind} {names[0]};\n    {call}(1, {', '.join(passed)}, &{names[0]});\n"
        f"    return {names[0]};\n}}\n\n"
    )


def public_source(template):
    """Return the source of the public functions, which choose a version."""
    out = []
    for function, force_set in forms():
        for public in dict.fromkeys([force_set, *([""] if force_set == fullest(function) else [])]):
            out += [_scalar(function, force_set, arithmetic.kind, public) for arithmetic in ARITHMETICS]
            out += [_chooser(function, force_set, shape, a.kind, public) for shape, a in _every(function)]
    declared = "".join(map(_declarations, TARGETS))
    words = {"@CONDITION@": CONDITION, "@DECLARED@\n": declared, "@PUBLIC@\n": "".join(out).rstrip("\n") + "\n"}
    for word, text in words.items():
        template = template.replace(word, text)
    return template
