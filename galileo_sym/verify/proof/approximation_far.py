"""Far forms: a few powers of x in place of a primitive, and a proved bound of what they leave out from some x on.

Each omitted part is that of the primitive's definition: an exponential, relative to the primitive itself, that falls
with x, so its value at the beginning of the far form bounds it everywhere beyond.
"""

from dataclasses import dataclass
from fractions import Fraction

from galileo_sym.verify.proof.approximation_calculus import exact, float_above, precision

HALF = Fraction(1, 2)


@dataclass(frozen=True)
class FarForm:
    """What stands for a primitive far from 0.

    Attributes
    ----------
    terms : dict
        Coefficients by power of x.
    omitted : callable
        Takes x > 1; an upper bound of |far form/primitive - 1| that falls with x.
    """

    terms: dict
    omitted: object


def _over_complement(e):
    """The relative error of leaving out the e of 1 - e."""
    return e / (1 - e)


def _least_time(p):
    """tau = 1 + p^2/2 - exp(-tau) from below, as tau >= p^2/2."""
    return 1 + p * p / 2 - (-p * p / 2).exp()


def _least_flight(b):
    """T = (1 + b)(1 - exp(-T)) from below: 1 + b = T/(1 - exp(-T)) <= 1 + T, so T >= b."""
    return (1 + b) * (1 - (-b).exp())


def _flight(b):
    """What is left out is the exp(-T) of 1 - exp(-T) = T/(1 + b) = 2 b range_factor."""
    return _over_complement((-_least_flight(b)).exp())


FAR_FORMS = {
    "phi1m": FarForm({-1: Fraction(1)}, lambda x: _over_complement((-x).exp())),
    "phi2m": FarForm({-1: Fraction(1), -2: Fraction(-1)}, lambda x: (-x).exp() / (x - 1)),
    "descent_factor": FarForm({1: HALF, -1: Fraction(1)}, lambda x: (-_least_time(x)).exp() / _least_time(x)),
    "flight_factor": FarForm({0: HALF, -1: HALF}, _flight),
    "range_factor": FarForm({-1: HALF}, _flight),
    "rise_factor": FarForm({-1: Fraction(1)}, lambda x: _over_complement((-_least_time(x)).exp())),
}


def far_bound(name, end):
    """Bound what a far form leaves out.

    Parameters
    ----------
    name : str
        The primitive, one of `FAR_FORMS`.
    end : Fraction
        Where it begins, > 1.

    Returns
    -------
    float
        Upper bound of |far form/primitive - 1| for all x >= end, no operation being rounded.
    """
    if not end > 1:
        raise ValueError(f"the far forms are bounded from some x > 1 on, not from {end}")
    with precision():
        return float_above(FAR_FORMS[name].omitted(exact(end)))
