"""Comparisons and rounding errors relative to a monomial, where atoms range over many binades."""

from fractions import Fraction

from .binary64 import DIGITS, SMALLEST, Overflow, power, rounding_error
from .expansion import Expansion, over

_OTHERS = 4  # times a term, what all terms together may be
_SMALL = -30  # binades below the main term: what is no longer told apart
_MORE = 4  # binades that a bound may lose by being held to the main term
_NORMAL = power(-1022)
_UNIT = power(-DIGITS)  # abs(RN(v) - v) <= abs(v) 2^-53 for normal v
_OVERFLOW = power(1024) - power(970)


def dominant(symbols, expansion):
    """Return the monomial of the term that may be largest; of those free of symbols, if there are any."""
    terms = expansion.ideal().terms or expansion.terms

    return max(terms, key=lambda key: symbols.size(key, terms[key]))[0] if terms else ()


def scale(symbols, expansion):
    """Return the monomial to which errors of an expansion are held: the dominant one, if it ranges over binades."""
    monomial = dominant(symbols, expansion)
    low, high = symbols.range_of(monomial)
    if low < 0:
        low, high = -high, -low
    return monomial if 0 < 2 * low < high else ()


def ratio(symbols, part, whole):
    """Bound of abs(part/whole); None if the whole may be 0."""
    found = []
    for monomial in {(), dominant(symbols, whole)}:
        low, high = symbols.range_of(monomial)
        if low <= 0 <= high:
            continue
        least = symbols.least(whole.over(monomial))
        if least:
            found.append(symbols.largest(part.over(monomial)) / least)
    return min(found, default=None)


def no_less(symbols, a, b):
    """Whether abs a >= abs b is proved."""
    known = ratio(symbols, b, a)
    return known is not None and known <= 1


def error_of(symbols, exact):
    """Return the rounding error of an exact result, as a new symbol times what it is relative to.

    Raises
    ------
    Overflow
        If the result may round to infinity.
    """
    monomial = scale(symbols, exact)
    if not monomial:
        return symbols.fresh(rounding_error(symbols.largest(exact)))
    if symbols.largest(exact) >= _OVERFLOW:
        raise Overflow("an operation may overflow")
    relative, least = exact.over(monomial), min(map(abs, symbols.range_of(monomial)))
    largest = symbols.largest(relative)
    bound = largest * _UNIT
    if symbols.least(relative) * least < _NORMAL:
        bound = max(bound, SMALLEST / 2 / least)
    alone = Expansion({key: c for key, c in exact.terms.items() if key[0] == monomial})
    if largest > _OTHERS * symbols.largest(alone.over(monomial)):  # another term matters where the monomial is small
        return symbols.fresh(rounding_error(symbols.largest(exact)))
    return symbols.fresh(min(bound, largest)) * Expansion({(monomial, ()): Fraction(1)})


def folded(symbols, expansion):
    """Return an expansion whose products of symbols, and small terms of one, are one symbol times the main term."""
    sizes = {key: symbols.size(key, c) for key, c in expansion.terms.items() if key[1]}
    least = max(sizes.values(), default=0) + _SMALL
    small = {key: found for key, found in sizes.items() if len(key[1]) > 1 or found < least}
    if not small:
        return expansion
    main, bounds = dominant(symbols, expansion), {}
    low, high = symbols.range_of(main)
    away, whole = low > 0 or high < 0, symbols.size((main, ()), 1)
    for (monomial, errors), found in small.items():
        coefficient = expansion.terms[monomial, errors]
        relative = symbols.size((over(monomial, main), errors), coefficient) if away else None
        if away and relative + whole <= found + _MORE:
            bounds[main] = bounds.get(main, 0) + power(relative)
        else:
            bounds[monomial] = bounds.get(monomial, 0) + power(symbols.size(((), errors), coefficient))
    kept = {key: c for key, c in expansion.terms.items() if key not in small}
    for monomial, bound in bounds.items():
        kept |= {(monomial, errors): c for (_, errors), c in symbols.fresh(bound).terms.items()}
    return Expansion(kept)


def underflow_of(symbols, exact):
    """Return the error of a rounding to a multiple of the least subnormal: it is not more than the number itself."""
    monomial = dominant(symbols, exact)
    least = min(map(abs, symbols.range_of(monomial)))
    if not least:
        return symbols.fresh(SMALLEST / 2)
    bound = min(SMALLEST / 2 / least, symbols.largest(exact.over(monomial)))
    return symbols.fresh(bound) * Expansion({(monomial, ()): Fraction(1)})
