"""The papers' formulas on vectors, in C: which there are, their headers, and the choice of a version."""

from itertools import product

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen.forms import ARRAYS, DOUBLE, SINGLE, VALUES, definition, name_of, parameters, scaled_name
from galileo_sym.codegen.kernels import CONDITION, TARGETS, table_text
from galileo_sym.codegen.pairs import IN_LANES
from galileo_sym.primitives.tables import TURN_COUNT, TURN_STEP, constants, turn_rows

ARITHMETICS = (DOUBLE, SINGLE)


def in_lanes(function):
    """Whether a function has forms on vectors: not one that solves, has cases, or is a primitive."""
    return not (function.routine or function.primitive or function.ceiling)


def forms():
    """Return (function, force set) of every form on vectors."""
    return [(f, s) for f in FUNCTIONS.values() if in_lanes(f) for s in f.variants]


def shapes(function):
    """Return the shapes of a function's forms."""
    return (ARRAYS, VALUES) if function.positional and function.keywords else (ARRAYS,)


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


def factors():
    """Return the calls of the primitives that formulas use, on vectors of pairs."""
    return "".join(
        f"static inline gs_vp gs_vp_{name}(gs_vp x)\n{{\n    gs_vp r;\n"
        f"    r.hi = gs_{name}_lanes(x.hi, x.lo, &r.lo);\n    return r;\n}}\n\n"
        for name in IN_LANES
    )


def scaled_header():
    """Return the C header of the scaled forms."""
    out = [
        "#ifndef GALILEO_SCALED_H\n#define GALILEO_SCALED_H\n\n"
        "/* The formulas on scaled pairs: for single numbers of any size, where the forms on vectors do not serve. */\n"
    ]
    for function, force_set in forms():
        given = [f"double {a.name}" for a in function.arguments(force_set)]
        given += [] if len(function.outputs) == 1 else [f"double *{o.name}" for o in function.outputs]
        kind = "double" if len(function.outputs) == 1 else "void"
        out.append(f"{kind} {scaled_name(function, force_set)}({', '.join(given)});\n")
    return "".join([*out, "\n#endif\n"])


def forms_header():
    """Return the C header that defines all forms for a source that has set GS_LANES and GS_SUFFIX."""
    definitions = "\n".join(definition(f, s, shape, arithmetic) for f, s in forms() for shape, arithmetic in _every(f))
    return (
        "#ifndef GALILEO_FORMS_H\n#define GALILEO_FORMS_H\n\n"
        f'#include "galileo_loops.h"\n#include "galileo_scaled.h"\n#include "galileo_single.h"\n\n{definitions}\n#endif\n'
    )


def signature(function, force_set, shape, arithmetic, ending="", public=None):
    """Return the C signature of a form; ``public`` is the force set in its name, if that is another."""
    given = ", ".join("".join(pair) for pair in parameters(function, force_set, shape, arithmetic.kind))
    name = name_of(function, force_set if public is None else public)
    return f"void {name}_{shape}{arithmetic.ending}{ending}({given})"


def _declarations(suffix):
    """Declarations of one version of all forms."""
    return "".join(
        f"{signature(f, s, shape, arithmetic, f'_{suffix}')};\n" for f, s in forms() for shape, arithmetic in _every(f)
    )


def _chooser(function, force_set, shape, arithmetic, public):
    names = ", ".join(name for _, name in parameters(function, force_set, shape, arithmetic.kind))
    return (
        f"{signature(function, force_set, shape, arithmetic, public=public)}\n{{\n"
        f"    GS_CHOOSE({name_of(function, force_set)}_{shape}{arithmetic.ending})({names});\n}}\n\n"
    )


def _scalar(function, force_set, arithmetic, public):
    kind = arithmetic.kind
    given = [f"{kind} {a.name}" for a in function.arguments(force_set)]
    passed = [f"&{a.name}" for a in function.arguments(force_set)]
    call = f"GS_CHOOSE_SINGLE({name_of(function, force_set)}_{ARRAYS}{arithmetic.ending})"
    name = f"{name_of(function, public)}{arithmetic.ending}"
    if len(function.outputs) == 1:
        (output,) = function.outputs
        return (
            f"{kind} {name}({', '.join(given)})\n{{\n    {kind} {output.name};\n"
            f"    {call}(1, {', '.join([*passed, f'&{output.name}'])});\n    return {output.name};\n}}\n\n"
        )
    outputs = [o.name for o in function.outputs]
    given += [f"{kind} *{o}" for o in outputs]
    return f"void {name}({', '.join(given)})\n{{\n    {call}(1, {', '.join([*passed, *outputs])});\n}}\n\n"


def public_source(template):
    """Return the source of the public functions, which choose a version."""
    out = []
    for function, force_set in forms():
        fullest = max(function.variants, key=lambda s: len(function.variants[s][0]))
        for public in dict.fromkeys([force_set, *([""] if force_set == fullest else [])]):
            out += [_scalar(function, force_set, arithmetic, public) for arithmetic in ARITHMETICS]
            out += [_chooser(function, force_set, *each, public) for each in _every(function)]
    declared = "".join(map(_declarations, TARGETS))
    words = {"@CONDITION@": CONDITION, "@DECLARED@\n": declared, "@PUBLIC@\n": "".join(out).rstrip("\n") + "\n"}
    for word, text in words.items():
        template = template.replace(word, text)
    return template
