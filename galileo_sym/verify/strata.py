"""Strata: the regions of the inputs in which errors are sampled apart, as one table for each paper.

A stratum draws one value for each variable of its paper; a function keeps those it takes. Strata that need a
variable the kernel does not have are left out of its list.
"""

from . import chord_strata, lambert_strata, launch_strata, projectile_strata
from .fixed_points import KNOWN_HARD, SCENES
from .stratum import Stratum

__all__ = ["Stratum", "fixed_strata", "random_strata", "strata_names"]

# For a paper, or for a function that has its own.
TABLES = {**chord_strata.TABLES, **lambert_strata.TABLES, **launch_strata.TABLES, **projectile_strata.TABLES}


def random_strata(function, force_set):
    """The strata drawn at random for one kernel, in the order of the tables."""
    table = TABLES.get(function.full_name) or TABLES[function.paper]
    has = set(function.arguments(force_set))
    return [stratum for stratum in table if has.issuperset(stratum.needs)]


def fixed_strata(function, force_set):
    """Names and points of the strata that are lists."""
    lists = {
        "scenes": SCENES.get((function.full_name, force_set)) or SCENES[function.paper, force_set],
        "known-hard": KNOWN_HARD.get((function.full_name, force_set), []),
    }
    return {name: points for name, points in lists.items() if points}


def strata_names(function, force_set):
    """All strata of one kernel, in order."""
    return [*(stratum.name for stratum in random_strata(function, force_set)), *fixed_strata(function, force_set)]
