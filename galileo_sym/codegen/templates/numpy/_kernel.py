"""What every emitted function does around its formula: admit the arguments, settle the result."""

import numpy as np

from ._scaled import ZERO, Scaled, select, store
from ._tables import HALF_PI

# Test of the domain, and a harmless member of it that stands in for whatever fails the test.
DOMAINS = {
    "positive": (lambda x: x > 0.0, 1.0),
    "nonnegative": (lambda x: x >= 0.0, 1.0),
    "chord angle": (lambda x: np.abs(x) <= HALF_PI[0], 0.25),
    "elevation": (lambda x: (x >= 0.0) & (x <= HALF_PI[0]), 0.25),
    "real": (lambda x: ~np.isnan(x), 1.0),
}


def quiet():
    """Silence the floating-point flags of intermediate results; those of the result are raised when it is stored."""
    return np.errstate(all="ignore")


def raise_invalid():
    """Raise NumPy's 'invalid' floating-point error state."""
    np.subtract(np.inf, np.inf)


def raise_divide():
    """Raise NumPy's 'divide by zero' error state."""
    np.divide(1.0, np.zeros(1))


def admit(*arguments):
    """Check arguments given as (array, domain) pairs.

    Returns the arrays with harmless values where the result will be NaN, and the mask of these lanes. Raises 'invalid'
    for arguments outside their domain, not for NaN.
    """
    arrays = [np.asarray(x, dtype=np.float64) for x, _ in arguments]
    missing = False
    for x in arrays:
        missing = missing | np.isnan(x)
    outside = False
    with quiet():
        for x, (_, domain) in zip(arrays, arguments, strict=True):
            outside = outside | ~DOMAINS[domain][0](x)
    void = missing | outside
    if not np.any(void):
        return arrays, void
    if np.any(void & ~missing):
        raise_invalid()
    return [np.where(void, DOMAINS[domain][1], x) for x, (_, domain) in zip(arrays, arguments, strict=True)], void


def within(value, most, void):
    """Lanes where an argument is infinite or above the most that has a result, as told, turn void: 'invalid'.

    Also returns the mask of the lanes where it is that most, and not 0.
    """
    beyond = ~void & ((value > most) | np.isinf(value))
    if np.any(beyond):
        raise_invalid()
    return void | beyond, (value == most) & (value != 0.0) & ~beyond


def at_most(full, there, number):
    """The number there in the lanes where an argument is the most that has a result."""
    return select(full, there, number)


def idle(mask, number):
    """0 in place of a number where no result is computed from it."""
    return select(mask, ZERO, number)


def moving(driving):
    """Return the driving force with 1 in place of what is not positive, and the mask of those lanes: at rest."""
    rest = driving.hi <= 0.0
    if not np.any(rest):
        return driving, rest
    return Scaled(np.where(rest, 1.0, driving.hi), np.where(rest, 0.0, driving.lo), np.where(rest, 0, driving.e)), rest


def _any_infinite(group):
    return np.logical_or.reduce(np.broadcast_arrays(*(np.isinf(x) for x in group)))


def clash(*pairs):
    """Lanes where, of a pair of groups, an argument of each is infinite: the limit depends on which goes first."""
    both = False
    for one, other in pairs:
        both = both | (_any_infinite(one) & _any_infinite(other))
    return both


def if_zero(force, absent, present):
    """Lanes that are undecided: where a force is 0, those that are so without it."""
    return np.where(force == 0.0, absent, present)


def settle(value, void, undecided=False, rest=False, at_rest=0.0):
    """Round a result to doubles: at_rest in the lanes at rest, NaN where void or undecided.

    An exact 0 is 0 however infinite the other factors are.
    """
    undecided = undecided & ~np.asarray(rest) & (value.hi != 0.0)
    if np.any(undecided):
        raise_invalid()
    void = void | undecided
    result = store(Scaled(np.where(void | rest, 0.0, value.hi), value.lo, value.e))
    return np.where(void, np.nan, np.where(rest, at_rest, result))
