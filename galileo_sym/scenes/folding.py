"""Constants of a scene, folded: at 200 bits from the exact doubles, rounded once as a pair of doubles."""

from mpmath import mp, mpf

from galileo_sym.multiprecision import mp_value
from galileo_sym.scenes.forms import symbols_of_base

_BITS = 200
_OF_SIGN = {"phi0m": "exp", "phi1m": "phi1", "phi2m": "phi2"}  # primitives of -x


def _call(name, arguments):
    if name == "sine":
        return mp.sin(arguments[0])
    if name == "cosine":
        return mp.cos(arguments[0])
    if name == "driving":
        return mp.cos(arguments[0]) - arguments[1] * mp.sin(abs(arguments[0]))
    if name in _OF_SIGN:
        return mp_value(_OF_SIGN[name], -arguments[0])
    return mp_value(name, arguments[0])


def _base(base, values):
    kind, *rest = base
    if kind == "symbol":
        return mpf(values[rest[0]])
    if kind == "number":
        return mpf(rest[0].numerator) / rest[0].denominator
    if kind == "sum":
        return _sum(rest[0], values)
    return _call(rest[0], [_sum(terms, values) for terms in rest[1:]])


def _term(term, values):
    product = mpf(term.coefficient.numerator) / term.coefficient.denominator
    for base, exponent in term.factors:
        value = _base(base, values)
        root = mp.sqrt(value) if exponent.denominator == 2 else value
        product *= root**exponent.numerator
    return product


def _sum(terms, values):
    return mp.fsum(_term(term, values) for term in terms)


def fold(terms, values):
    """Return the value of terms at constants, as an mpmath number of 200 bits.

    Parameters
    ----------
    terms : tuple of Term
    values : dict of str to float
        Of every symbol in them.
    """
    with mp.workprec(_BITS):
        return _sum(terms, values)


def as_pair(value):
    """Return hi, lo and e with (hi + lo) 2**e the value rounded once to a pair of doubles, 1/2 <= |hi| <= 1 or 0."""
    with mp.workprec(_BITS):
        m, e = mp.frexp(value)
        hi = float(m)
        return hi, float(m - mpf(hi)), int(e)


def power_of_two(value):
    """Return the exponent of a positive power of two; None for another number."""
    hi, lo, e = as_pair(value)
    return e - 1 if (hi, lo) == (0.5, 0.0) else None


def held(calls, values):
    """Whether friction holds the bead, by the exact sign of a driving force of constants among calls."""
    forces = [call for call in calls if call[1] == "driving" and symbols_of_base(call) <= set(values)]
    with mp.workprec(_BITS):
        return any(_base(call, values) <= 0 for call in forces)
