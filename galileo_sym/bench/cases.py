"""What is measured: every public function with each set of forces, and every special function, on drawn inputs."""

from dataclasses import dataclass
from functools import cache

import numpy as np
from flint import arb

from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.kernels import BANKED, KERNELS
from galileo_sym.verify.enclosure import Enclosure, with_bits
from galileo_sym.verify.functions import FUNCTIONS
from galileo_sym.verify.proof.references import reference as closed_form
from galileo_sym.verify.reference import reference
from galileo_sym.verify.sampling import Draw
from galileo_sym.verify.strata import random_strata

TYPICAL, TINY_DRAG = "typical", "tiny-drag"
SEED = 2004
SPECIAL = "special"
_LONGEST = 32.0  # typical arguments of a special function whose first range goes on go so far
_BITS = 200


@dataclass(frozen=True)
class Case:
    """A kernel on a kind of inputs.

    Attributes
    ----------
    paper, name : str
        The public module and the function in it.
    force_set : str
        Key of the kernel in the function's variants; empty where there is one kernel.
    stratum : str
        Kind of inputs, a stratum of `galileo_sym.verify`.
    positional, keywords, forces : tuple of str
        Arguments of the kernel, in order; of the forces those that act.
    outputs : tuple of str
    """

    paper: str
    name: str
    force_set: str
    stratum: str
    positional: tuple
    keywords: tuple
    forces: tuple
    outputs: tuple

    @property
    def full_name(self):
        """``paper.name``."""
        return f"{self.paper}.{self.name}"

    @property
    def key(self):
        """Name, forces and inputs in one, such as ``chord.descent_time drag tiny-drag``; what is usual is left out."""
        usual = ("", TYPICAL)
        return " ".join([self.full_name, *(word for word in (self.force_set, self.stratum) if word not in usual)])

    @property
    def arguments(self):
        """Names of all arguments, in order."""
        return (*self.positional, *self.keywords, *self.forces)

    def points(self, count, seed=SEED):
        """Inputs, drawn one after the other.

        Parameters
        ----------
        count : int
        seed : int

        Returns
        -------
        dict of str to ndarray
            Of float64, shape (count,), in the function's units.
        """
        if self.paper == SPECIAL:
            low, high = special_range(self.name)
            return {"x": np.random.default_rng(seed).uniform(low, high, count)}
        draw, row = Draw(f"{seed}:{self.key}"), FUNCTIONS[self.full_name]
        stratum = next(s for s in random_strata(row, self.force_set or "all") if s.name == self.stratum)
        drawn = [stratum.draw(draw, set(self.arguments)) for _ in range(count)]
        return {name: np.array([point[name] for point in drawn]) for name in self.arguments}

    def exact(self, point):
        """Certain enclosures of the results at one point, a dict of floats; one for each output."""
        if self.paper == SPECIAL:
            return (_enclosed(closed_form(self.name, point["x"])),)
        absent = FUNCTIONS[self.full_name].absent_forces(self.force_set or "all")
        return reference(self.full_name, {**dict.fromkeys(absent, 0.0), **point})

    def outside(self, point):
        """Whether a point, a dict of floats, lies outside the domain, or where a closed form is 0/0."""
        return point["x"] == 0 if self.paper == SPECIAL else bool(FUNCTIONS[self.full_name].outside(point))


@with_bits(_BITS)
def _enclosed(value):
    """A number of mpmath, good to 40 digits, as an enclosure of that width."""
    sign, mantissa, exponent, _ = value._mpf_
    middle = arb(int(-mantissa if sign else mantissa)) * arb(2) ** exponent
    return Enclosure(middle + arb(0, abs(middle) * arb(10) ** -40))


def special_range(name):
    """Ends of the arguments of a special function that take its typical path."""
    if name in BANKED:
        return 0.0, float(APPROXIMATIONS[BANKED[name].banks[0]].partition.end)
    first = KERNELS[name].ranges[0]
    return float(first.begin), min(float(first.end), _LONGEST)


def _of_function(row):
    for force_set, forces in row.force_sets.items():
        variant = "" if len(row.force_sets) == 1 else force_set
        known = [stratum.name for stratum in random_strata(row, force_set)]
        # tiny drag is where printed formulas fail; of other functions it is an ordinary number
        for stratum in (TYPICAL, TINY_DRAG) if forces and TINY_DRAG in known else (TYPICAL,):
            yield Case(row.paper, row.name, variant, stratum, row.positional, row.keywords, forces, row.outputs)


@cache
def cases():
    """All cases by key, in the order of the tables."""
    found = [case for row in FUNCTIONS.values() for case in _of_function(row)]
    found += [Case(SPECIAL, name, "", TYPICAL, ("x",), (), (), ("value",)) for name in KERNELS]
    return {case.key: case for case in found}
