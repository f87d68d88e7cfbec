"""Names and signatures of the functions of the emitted C."""

ARRAYS, VALUES = "n", "nu"  # the shapes: all arguments arrays; the keyword arguments one value each


def name_of(function, force_set, ending=""):
    """Return the C name of a function; an empty force set gives the unsuffixed one."""
    return f"gs_{function.paper}_{function.name}" + (f"_{force_set}" if force_set else "") + ending


def fullest(function):
    """Return the force set of all forces."""
    return max(function.variants, key=lambda force_set: len(function.variants[force_set][0]))


def variants(function):
    """Return (suffix, force set) of every C function; the one without a suffix takes all arguments."""
    return [*((s, s) for s in function.variants if s), ("", fullest(function))]


def scaled_name(function, force_set):
    """Return the C name of the scaled form, for single numbers of any size."""
    return name_of(function, force_set).replace("gs_", "gs_scaled_", 1)


def widened_name(function, force_set):
    """Return the C name of what makes a double of the float that has a largest value."""
    return name_of(function, force_set).replace("gs_", "gs_widened_", 1)


def is_single(function):
    """Whether there is one output, which C functions of single numbers return."""
    return len(function.outputs) == 1


def letter(kind):
    """Return the last letter of names for ``double`` or ``float``."""
    return {"double": "", "float": "f"}[kind]


def parameters(function, force_set, shape, kind):
    """Return (type, name) of the C parameters of an array function."""
    arrays = function.positional if shape == VALUES else [a.name for a in function.arguments(force_set)]
    given = [(f"const {kind} *" if a.name in arrays else f"{kind} ", a.name) for a in function.arguments(force_set)]
    return [("size_t ", "n"), *given, *((f"{kind} *", o.name) for o in function.outputs)]


def array_signature(function, force_set, shape, kind, public=None, version=""):
    """Return the C signature of an array function.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.
    shape : str
        ``ARRAYS`` or ``VALUES``.
    kind : str
        ``double`` or ``float``.
    public : str, optional
        The force set in its name, if that is another.
    version : str, optional
        What is added to the name.
    """
    given = ", ".join("".join(pair) for pair in parameters(function, force_set, shape, kind))
    name = name_of(function, force_set if public is None else public)
    return f"void {name}_{shape}{letter(kind)}{version}({given})"


def widened_signature(function, force_set):
    """Return the C signature of what `widened_name` names."""
    given = ", ".join(f"float {a.name}" for a in function.arguments(force_set))
    return f"double {widened_name(function, force_set)}({given})"


def scalar_signature(function, force_set, kind, name, of_argument="{}", of_output="{}"):
    """Return the C signature of a function of single numbers; parameters may be renamed."""
    given = [f"{kind} {of_argument.format(a.name)}" for a in function.arguments(force_set)]
    given += [] if is_single(function) else [f"{kind} *{of_output.format(o.name)}" for o in function.outputs]
    return f"{kind if is_single(function) else 'void'} {name}({', '.join(given)})"
