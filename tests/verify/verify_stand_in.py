"""Back ends for tests of the harness: the exact result rounded to nearest, and weakened versions of it."""

import math

import numpy as np

from galileo_sym.verify.enclosure import nearest_float
from galileo_sym.verify.reference import reference


class Rounded:
    """Gives the reference itself, rounded; so the harness must find at most half an ulp."""

    def __init__(self, name="rounded"):
        self.name = name

    def evaluate(self, function, force_set, arguments):
        absent = dict.fromkeys(function.absent_forces(force_set), 0.0)
        names = list(arguments)
        rows = []
        for values in zip(*(arguments[name].tolist() for name in names), strict=True):
            results = reference(function.full_name, dict(zip(names, values, strict=True)) | absent)
            rows.append([nearest_float(one) for one in results])
        return tuple(np.array(column) for column in zip(*rows, strict=True))


class Weakened(Rounded):
    """Errs by so many ulps more at points of one function that satisfy a condition.

    Parameters
    ----------
    ulps : int
        How far the first output is moved.
    where : callable
        Takes the force set and one point as a dict.
    """

    def __init__(self, ulps, where, name="weakened"):
        super().__init__(name)
        self.ulps = ulps
        self.where = where

    def evaluate(self, function, force_set, arguments):
        first, *others = super().evaluate(function, force_set, arguments)
        points = [
            dict(zip(arguments, values, strict=True))
            for values in zip(*(array.tolist() for array in arguments.values()), strict=True)
        ]
        for index, point in enumerate(points):
            if self.where(force_set, point):
                for _ in range(self.ulps):
                    first[index] = math.nextafter(first[index], math.inf)
        return (first, *others)
