"""Printed formulas as array functions in C, C++ and Rust, put into a peer's template."""

from sympy import Symbol
from sympy.printing.c import C99CodePrinter

from ..printed import printed, symbols

MARK = "/* FUNCTIONS */"


def symbol_of(case):
    """Name of the array function of a case's kernel."""
    return "_".join(["peer", case.paper, case.name, *([case.force_set] if case.force_set else [])])


class _Printer(C99CodePrinter):
    """Prints W by the names of the templates, and integers as doubles."""

    def _print_LambertW(self, expression):
        branch = expression.args[1] if len(expression.args) > 1 else 0
        return f"{'Wm1' if branch == -1 else 'W0'}({self._print(expression.args[0])})"

    def _print_Integer(self, expression):
        return f"{expression}.0"


class _RustPrinter(_Printer):
    """The few forms of C that Rust writes otherwise; functions and constants are in the template."""

    def _print_Piecewise(self, expression):
        *first, (last, _) = [(self._print(value), self._print(condition)) for value, condition in expression.args]
        tests = " else ".join(f"if {condition} {{ {value} }}" for value, condition in first)
        return f"({tests} else {{ {last} }})"

    def _print_sign(self, expression):
        return f"({self._print(expression.args[0])}).signum()"


def _c_function(name, arguments, forms):
    """A loop in C or C++; no output overlaps an input."""
    inputs = "".join(f"const double *in_{a}, " for a in arguments)
    outputs = ", ".join(f"double *__restrict__ out_{place}" for place in range(len(forms)))
    reads = "".join(f"        const double {a} = in_{a}[j];\n" for a in arguments)
    writes = "".join(f"        out_{place}[j] = {_Printer().doprint(form)};\n" for place, form in enumerate(forms))
    head = f"void {name}(size_t n, {inputs}{outputs})"
    return f"{head};\n{head}\n{{\n    for (size_t j = 0; j < n; j++) {{\n{reads}{writes}    }}\n}}\n"


def _rust_function(name, arguments, forms):
    """The same in Rust, on slices."""
    inputs = "".join(f"in_{a}: *const f64, " for a in arguments)
    outputs = ", ".join(f"out_{place}: *mut f64" for place in range(len(forms)))
    slices = "".join(f"    let in_{a} = std::slice::from_raw_parts(in_{a}, n);\n" for a in arguments)
    slices += "".join(
        f"    let out_{place} = std::slice::from_raw_parts_mut(out_{place}, n);\n" for place in range(len(forms))
    )
    reads = "".join(f"        let {a} = in_{a}[j];\n" for a in arguments)
    writes = "".join(f"        out_{place}[j] = {_RustPrinter().doprint(form)};\n" for place, form in enumerate(forms))
    head = f'#[no_mangle]\npub unsafe extern "C" fn {name}(n: usize, {inputs}{outputs})'
    return f"{head} {{\n{slices}    for j in 0..n {{\n{reads}{writes}    }}\n}}\n"


_FUNCTION = {".c": _c_function, ".cpp": _c_function, ".rs": _rust_function}


def source(template, kernels):
    """A peer's source.

    Parameters
    ----------
    template : Path
        A file with the line `MARK`, whose suffix tells the language.
    kernels : iterable of Case
        One for each function to be written; of those that have printed formulas.

    Returns
    -------
    str
    """
    write = _FUNCTION[template.suffix]
    texts = []
    for case in kernels:
        names = [f"x_{name}" for name in symbols(case)]
        rename = {Symbol(name): Symbol(new) for name, new in zip(symbols(case), names, strict=True)}
        forms = [form.subs(rename, simultaneous=True) for form in printed(case.full_name, case.force_set)]
        texts.append(write(symbol_of(case), names, forms))
    return template.read_text(encoding="utf-8").replace(MARK, "\n".join(texts))
