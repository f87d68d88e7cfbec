"""A plan as a self-contained file of C99: what its steps reach of the emitted library, and a function for the grid."""

from __future__ import annotations

import galileo_sym
from galileo_sym.scenes.c_closure import closure
from galileo_sym.scenes.c_grid import grid_lines, odd_lines, point_function
from galileo_sym.scenes.c_nests import Nests
from galileo_sym.scenes.c_steps import statements
from galileo_sym.scenes.explain import headline
from galileo_sym.scenes.plan import ROUNDINGS

_HEAD = """/* {title}
 *
 * {name}(...) writes the outputs over the outer grid of the axes, row by row, the last axis fastest. work points to
 * {name}_work(...) bytes, as from malloc. Arguments outside their domains give NaN and raise FE_INVALID.
 * With other options than -std=c99 gcc needs -ffp-contract=off; no compiler may be told -ffast-math.
 * Made by galileo-sym {version}. */
#include <stddef.h>
"""


def source(plan, name):
    """Return the text of a file of C that computes a scene, and nothing else.

    Parameters
    ----------
    plan : Plan
        Made for C: every output has steps of its own.
    name : str
        Of the function; another one, of this name and ``_work``, tells how many bytes it works with.
    """
    nests = Nests(plan)
    own = "\n".join([*point_function(nests, name), *_work(nests, name), "", *_function(nests, name)])
    title = headline(plan, None).replace("\n", "\n *")
    head = _HEAD.format(title=title, name=name, version=galileo_sym.__version__)
    return f"{head}{closure(own)}\n{own}\n"


def _lengths(plan):
    return [f"size_t n_{axis}" for axis in plan.over]


def _size(axes):
    return " * ".join(f"n_{axis}" for axis in axes) or "1"


def _work(nests, name):
    """The function that tells the size of the work space."""
    arrays = nests.arrays()
    taken = {axis for array in arrays for axis in array.axes}
    given = ", ".join(_lengths(nests.plan))
    sizes = [f"{_size(array.axes)} * sizeof({array.type})" for array in arrays] or ["1"]
    unused = [f"    (void)n_{axis};" for axis in nests.plan.over if axis not in taken]
    total = "\n           + ".join(sizes)
    return [f"size_t {name}_work({given})", "{", *unused, f"    return {total};", "}"]


def _function(nests, name):
    plan = nests.plan
    arguments = [f"size_t n_{axis}, const double *restrict {axis}" for axis in plan.over]
    arguments += ["void *work", *(f"double *restrict {result.output}" for result in plan.results)]
    once = [step for step in plan.steps if not step.axes and step.operation not in ROUNDINGS]
    constants = [line for step in once for line in statements(step)]
    grid, odd = grid_lines(nests), odd_lines(nests, name)
    body = [*nests.lines(), *grid, *odd]
    text = "\n".join(body)
    places = ["    char *at = work;"] if nests.arrays() else ["    (void)work;"]
    for array in nests.arrays():
        places.append(f"    {array.type} *const {array.name} = (void *)at;")
        places.append(f"    at += {_size(array.axes)} * sizeof({array.type});")
    places = places[:-1] if nests.arrays() else places
    unused = [f"    (void){axis};" for axis in plan.over if f"{axis}[" not in text]
    flags = ["    int any_odd = 0;"] if odd else []
    lines = [f"    {line}" for line in constants]
    return [f"void {name}({', '.join(arguments)})", "{", *places, *unused, *lines, *flags, *body, "}"]
