"""Docstrings of the ufuncs: arguments with units and domains, what the certificates claim, the equations behind."""

import json
from functools import cache
from importlib import resources

from galileo_sym.catalogue.special import SPECIAL

_DOMAINS = {
    "positive": "> 0",
    "nonnegative": ">= 0",
    "chord angle": "``|theta| <= pi/2``",
    "elevation": "``0 <= theta <= pi/2``",
    "real": "any real number",
    "branch": "``x >= -1/e``",
    "lower branch": "``-1/e <= x <= 0``",
}
_OUTSIDE = (
    "Arguments broadcast; integers and bool become float64. Outside the domain: NaN and the 'invalid' floating-point\n"
    "error state. NaN gives NaN without it. An infinite argument gives the limit, or NaN and 'invalid' where there is\n"
    "none.\n"
)


@cache
def _certificate(name):
    path = resources.files("galileo_sym.generated") / "certificates" / f"{name}.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None


def _accuracy(function, force_set):
    """The claimed bound of each unit in which errors are told, from the certificate."""
    certificate = _certificate(function.full_name)
    if certificate is None:
        return "Accuracy, for float64: not certified.\n"
    records = certificate["force_sets"][force_set or "all"].values()
    lines = []
    for unit in dict.fromkeys(certificate["unit"].values()):
        told = [name for name, its in certificate["unit"].items() if its == unit]
        bound = max(record["bound"] for record in records)
        lines.append(f"Accuracy of {', '.join(told)} in float64: claimed bound {bound:g}, measured, in\n{unit}.\n")
    return "".join(lines)


def form_doc(function, force_set, sources):
    """Return the docstring of the ufuncs of a function with one set of forces.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.
    sources : str
        The ledger entry and the printed equations.
    """
    lines = [function.doc, "", "Parameters", "----------"]
    for argument in function.arguments(force_set):
        domain = _DOMAINS[argument.domain]
        lines += [f"{argument.name} : array_like", f"    {argument.doc}, in {argument.unit}; {domain}."]
    lines += ["", "Returns", "-------"]
    for output in function.outputs:
        lines += [f"{output.name} : ndarray or scalar", f"    {output.doc}, in {output.unit}."]
    lines += ["", "Notes", "-----", f"{sources}.", *_OUTSIDE.splitlines(), *_accuracy(function, force_set).splitlines()]
    return "\n".join(lines)


def special_doc(name):
    """Return the docstring of a one-variable function."""
    row = SPECIAL[name]
    return "\n".join(
        (
            *(row.summary, "", "Parameters", "----------", "x : array_like", f"    Dimensionless; {row.domain}.", ""),
            *("Returns", "-------", "ndarray or scalar", f"    {row.returned}", "", "Raises", "------", "TypeError"),
            *("    For complex, extended-precision or object arguments.", "", "Notes", "-----"),
            f"{row.source}. Claimed bound: 2 ulp (0.55 at every point sampled).",
        )
    )
