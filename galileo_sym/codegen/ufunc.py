"""The Python extension: a table of ufuncs over the array functions of C, and of the public functions made of them."""

from dataclasses import dataclass

from galileo_sym.catalogue import FUNCTIONS, stable
from galileo_sym.catalogue.special import SPECIAL
from galileo_sym.codegen import lanes
from galileo_sym.codegen.printing import sources_text
from galileo_sym.codegen.signatures import name_of
from galileo_sym.codegen.ufunc_docs import form_doc, special_doc
from galileo_sym.solvers import SOLVERS

# least of either type, greatest
_INTERVALS = {
    "positive": ("{DBL_TRUE_MIN, FLT_TRUE_MIN}", "INFINITY"),
    "nonnegative": ("{0.0, 0.0}", "INFINITY"),
    "chord angle": ("{-GS_HALF_PI, -GS_HALF_PI}", "GS_HALF_PI"),
    "elevation": ("{0.0, 0.0}", "GS_HALF_PI"),
    "real": ("{-INFINITY, -INFINITY}", "INFINITY"),
}
# type: how array functions, those with keyword arguments by value, and those of numbers end
_ENDINGS = {"double": ("_n", "_nu", ""), "float": ("_nf", "_nuf", "f")}
_HEAD = """#include "extension.h"

#include <float.h>
#include <math.h>

#include "galileo.h"

#ifndef DBL_TRUE_MIN
#define DBL_TRUE_MIN 0x1p-1074
#define FLT_TRUE_MIN 0x1p-149
#endif
#define GS_HALF_PI 0x1.921fb54442d18p+0
#define GS_IN(type, i) ((const type *)in[i])
#define GS_OUT(type, i) ((type *)out[i])
#define GS_VALUE(type, i) (*(const type *)in[i])
#define GS_X(type, i) (((const type *)in)[i])
#define GS_Y(type, i) (((type *)out)[i])
"""


@dataclass(frozen=True)
class Form:
    """A function of C on arrays.

    Its name there, arguments, how many of them are positional (None: no keyword arguments by value), outputs, and by
    output which arguments matter to it.
    """

    name: str
    called: str
    domains: tuple
    positional: int | None
    outputs: tuple
    matters: tuple
    doc: str


def _matters(function, force_set):
    """Whether each output depends on each argument: a tuple of tuples of bool."""
    arguments = function.arguments(force_set)
    if function.routine or function.primitive or (function.full_name, force_set) in SOLVERS:
        return tuple((True,) * len(arguments) for _ in function.outputs)
    names = [{symbol.name for symbol in form.free_symbols} for form in stable(function, force_set)]
    return tuple(tuple(argument.symbol in found for argument in arguments) for found in names)


def _form(function, force_set):
    name = f"{function.paper}_{function.name}" + (f"_{force_set}" if force_set else "")
    return Form(
        name,
        name_of(function, force_set),
        tuple(a.domain if a.domain in _INTERVALS else "real" for a in function.arguments(force_set)),
        len(function.positional) if lanes.takes_values(function) else None,
        tuple(output.name for output in function.outputs),
        _matters(function, force_set),
        form_doc(function, force_set, sources_text(function, force_set)),
    )


def _forms():
    made = {(f.full_name, s): _form(f, s) for f in FUNCTIONS.values() for s in f.variants}
    for name in SPECIAL:
        made[f"special.{name}", ""] = Form(
            name, f"gs_special_{name}", ("real",), None, ("value",), ((True,),), special_doc(name)
        )
    return made


def _ufuncs(form):
    """(name, index of the output or None for every one) of each ufunc of a form."""
    if len(form.outputs) == 1:
        return [(form.name, None)]
    return [(form.name, None), *((f"{form.name}_{output}", i) for i, output in enumerate(form.outputs))]


def _arrays_call(form, part, kind, ending, positional):
    """The adapter of an array function; arguments that are not positional go by value."""
    passed = [f"GS_{'IN' if i < positional else 'VALUE'}({kind}, {i})" for i in range(len(form.domains))]
    passed += [f"GS_OUT({kind}, {i})" for i in range(len(form.outputs))]
    return (
        f"static void {form.name}_{part}_{kind}(size_t n, const void *const *in, void *const *out)\n{{\n"
        f"    {form.called}{ending}(n, {', '.join(passed)});\n}}\n"
    )


def _numbers_call(form, kind, ending):
    """The adapter of a function of numbers."""
    passed = [f"GS_X({kind}, {i})" for i in range(len(form.domains))]
    single = len(form.outputs) == 1
    passed += [] if single else [f"&GS_Y({kind}, {i})" for i in range(len(form.outputs))]
    return (
        f"static void {form.name}_numbers_{kind}(const void *in, void *out)\n{{\n"
        f"    {f'GS_Y({kind}, 0) = ' if single else ''}{form.called}{ending}({', '.join(passed)});\n}}\n"
    )


def _calls(form):
    """The adapters of a form: for arrays, with keyword arguments by value, for numbers; of both types."""
    out = []
    for kind, (arrays, values, numbers) in _ENDINGS.items():
        out.append(_arrays_call(form, "arrays", kind, arrays, len(form.domains)))
        if form.positional is not None:
            out.append(_arrays_call(form, "values", kind, values, form.positional))
        out.append(_numbers_call(form, kind, numbers))
    return "".join(out)


def _interval_name(domain):
    return f"gs_{domain.replace(' ', '_')}"


def _form_table(form):
    """The definition of a form's row."""
    masks = ", ".join(f"0x{sum(1 << i for i, matters in enumerate(row) if matters):x}" for row in form.matters)
    domains = ", ".join(f"&{_interval_name(domain)}" for domain in form.domains)
    keywords = len(form.domains) if form.positional is None else form.positional
    parts = ["arrays", "values" if form.positional is not None else None, "numbers"]
    rows = [[f"{form.name}_{part}_{kind}" if part else "NULL" for kind in _ENDINGS] for part in parts]
    pairs = "".join(f"    {{{', '.join(row)}}},\n" for row in rows)
    return (
        f"static const gs_form {form.name}_form = {{\n    {len(form.domains)}, {len(form.outputs)}, {keywords},\n"
        f"    {{{masks}}},\n    {{{domains}}},\n{pairs}}};\n"
    )


def _c_text(text):
    """A string literal, a line of source for each line."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    octal = "".join(c if c.isascii() else "".join(f"\\{byte:03o}" for byte in c.encode()) for c in escaped)
    return "\n".join(f'    "{line}\\n"' for line in octal.splitlines())


def _acting(function, bits):
    """The force set of the forces at the bits that are set."""
    chosen = {name for i, name in enumerate(function.forces) if bits >> i & 1}
    return next(s for s, (names, _) in function.variants.items() if set(names) == chosen)


def _function_row(function, forms, places):
    found = [forms[function.full_name, _acting(function, bits)] for bits in range(1 << len(function.forces))]
    pointers = ", ".join(f"&{form.name}_form" for form in found)
    indices = ", ".join(str(places[form.name]) for form in found)
    operands = len(function.positional) + len(function.keywords) + len(function.forces)
    return f'    {{"{function.full_name}", {operands}, {len(function.forces)}, {{{pointers}}}, {{{indices}}}}},\n'


def sizes():
    """Return the C constants that the tables need."""
    forms = _forms().values()
    rows = {
        "GS_MOST_INPUTS": max(len(form.domains) for form in forms),
        "GS_MOST_OUTPUTS": max(len(form.outputs) for form in forms),
        "GS_MOST_FORCES": max(len(function.forces) for function in FUNCTIONS.values()),
        "GS_UFUNCS": sum(len(_ufuncs(form)) for form in forms),
        "GS_FUNCTIONS": len(FUNCTIONS),
    }
    return "enum { " + ", ".join(f"{name} = {value}" for name, value in rows.items()) + " };\n"


def tables(digest):
    """Return the C source of all tables.

    Parameters
    ----------
    digest : str
        Of the sources that the extension is built of: compiled in, so that a stale one is known.
    """
    forms = _forms()
    ufuncs = [(name, form, output) for form in forms.values() for name, output in _ufuncs(form)]
    places = {name: place for place, (name, _, _) in enumerate(ufuncs)}
    intervals = [f"static const gs_interval {_interval_name(d)} = {{{a}, {b}}};\n" for d, (a, b) in _INTERVALS.items()]
    rows = [
        f'    {{"{name}", {form.name}_doc, &{form.name}_form, {"GS_EVERY" if output is None else output}}},\n'
        for name, form, output in ufuncs
    ]
    return (
        f'{_HEAD}\nconst char gs_sources[] = "{digest}";\n\n{"".join(intervals)}\n'
        + "\n".join(
            f"{_calls(form)}{_form_table(form)}static const char {form.name}_doc[] =\n{_c_text(form.doc)};\n"
            for form in forms.values()
        )
        + f"\nconst gs_ufunc gs_ufuncs[GS_UFUNCS] = {{\n{''.join(rows)}}};\n"
        + "\nconst gs_function gs_functions[GS_FUNCTIONS] = {\n"
        + "".join(_function_row(function, forms, places) for function in FUNCTIONS.values())
        + "};\n"
    )


def ufunc_names():
    """Return the names of all ufuncs, in their order."""
    return [name for form in _forms().values() for name, _ in _ufuncs(form)]


def _variants(function, forms):
    for force_set, (acting, _) in function.variants.items():
        names = [name for name, _ in _ufuncs(forms[function.full_name, force_set])]
        yield f"            {acting!r}: {tuple(names)!r},\n"


def python_table():
    """Return the Python module that names the ufuncs of each public function, and documents the one-variable ones."""
    forms = _forms()
    out = ['"""Public functions: operands, forces, outputs, and by the forces that act the ufuncs that serve."""\n\n']
    out.append(
        "# The first ufunc gives all outputs; where there are several, the others give one each.\nFUNCTIONS = {\n"
    )
    for function in FUNCTIONS.values():
        operands = (*function.positional, *function.keywords, *function.forces)
        out.append(f'    "{function.full_name}": {{\n        "operands": {operands!r},\n')
        out.append(f'        "forces": {tuple(function.forces)!r},\n        "outputs": {len(function.outputs)},\n')
        out.append(f'        "ufuncs": {{\n{"".join(_variants(function, forms))}        }},\n    }},\n')
    out.append("}\n\nSPECIAL = {\n")
    out += [f'    "{name}": """{special_doc(name)}""",\n' for name in SPECIAL]
    return "".join(out) + "}\n"
