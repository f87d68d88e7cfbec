"""Which functions and strata are meant by the names a user gives, with the nearest names where they are unknown."""

import difflib

from .functions import FUNCTIONS
from .strata import strata_names


class UnknownNameError(Exception):
    """A name is not known; the message gives the nearest ones."""


def _unknown(kind, name, known):
    near = difflib.get_close_matches(name, known, n=3, cutoff=0.5)
    advice = f"did you mean {' or '.join(near)}?" if near else f"known: {', '.join(known)}"
    return UnknownNameError(f"unknown {kind} {name!r}; {advice}")


def select_functions(names):
    """Full names of the functions meant, in the table's order.

    Parameters
    ----------
    names : sequence of str
        Full names (``chord.distance``), a paper (``chord``), or nothing for all.

    Raises
    ------
    UnknownNameError
        With the nearest names.
    """
    papers = sorted({function.paper for function in FUNCTIONS.values()})
    chosen = set()
    for name in names:
        if name in FUNCTIONS:
            chosen.add(name)
        elif name in papers:
            chosen.update(full for full, function in FUNCTIONS.items() if function.paper == name)
        else:
            # a bare function name is close to its full name only after the paper's prefix
            full = [known for known in FUNCTIONS if known.split(".")[1] == name.split(".")[-1]]
            if full:
                raise UnknownNameError(f"unknown function {name!r}; did you mean {' or '.join(full)}?")
            raise _unknown("function", name, [*FUNCTIONS, *papers])
    return [name for name in FUNCTIONS if name in chosen or not names]


def select_strata(functions, names):
    """Every (function, force set, stratum) that is meant, in the tables' order.

    Parameters
    ----------
    functions : sequence of str
        Full names, known.
    names : sequence of str
        Strata to keep, or nothing for all.

    Raises
    ------
    UnknownNameError
        For a stratum that none of the functions has, with the nearest names.
    """
    every = [
        (full_name, force_set, stratum)
        for full_name in functions
        for force_set in FUNCTIONS[full_name].force_sets
        for stratum in strata_names(FUNCTIONS[full_name], force_set)
    ]
    known = list(dict.fromkeys(stratum for _, _, stratum in every))
    for name in names:
        if name not in known:
            raise _unknown("stratum", name, known)
    return [row for row in every if row[2] in names or not names]
