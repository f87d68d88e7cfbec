"""Stable forms as sums of terms: a rational coefficient times powers of symbols, roots and primitives.

A base is ("symbol", argument), ("number", Fraction), ("sum", terms) or ("call", primitive, terms, ...), where terms are
tuples of `Term`; all of it hashable, equal where the forms are equal as written.
"""

from fractions import Fraction
from typing import NamedTuple


class Term(NamedTuple):
    """A coefficient times powers: ``factors`` are (base, exponent), each base once, in the order first met."""

    coefficient: Fraction
    factors: tuple


def _joined(factors):
    powers = {}
    for base, exponent in factors:
        powers[base] = powers.get(base, Fraction(0)) + exponent
    return tuple((base, exponent) for base, exponent in powers.items() if exponent)


def _number(numerator, denominator):
    return (Term(Fraction(numerator, denominator), ()),)


def _symbol(name):
    return (Term(Fraction(1), ((("symbol", name), Fraction(1)),)),)


def _sum(*forms):
    return tuple(term for form in forms for term in terms_of(form))


def _product(*forms):
    coefficient, factors = Fraction(1), []
    for form in forms:
        terms = terms_of(form)
        if len(terms) == 1:
            coefficient *= terms[0].coefficient
            factors += terms[0].factors
        else:
            factors.append((("sum", terms), Fraction(1)))
    return (Term(coefficient, _joined(factors)),)


def _power(form, numerator, denominator):
    terms, exponent = terms_of(form), Fraction(numerator, denominator)
    if len(terms) > 1:
        return (Term(Fraction(1), ((("sum", terms), exponent),)),)
    coefficient, factors = terms[0]
    raised = [(base, power * exponent) for base, power in factors]
    if exponent.denominator == 1 or coefficient == 1:
        return (Term(coefficient**exponent.numerator, _joined(raised)),)
    return (Term(Fraction(1), _joined([(("number", coefficient), exponent), *raised])),)


def _call(name, *forms):
    return (Term(Fraction(1), ((("call", name, *map(terms_of, forms)), Fraction(1)),)),)


_TERMS = {"number": _number, "symbol": _symbol, "sum": _sum, "product": _product, "power": _power, "call": _call}


def terms_of(form):
    """Return the terms of a form of ``generated._graphs``: a tuple of `Term`."""
    return _TERMS[form[0]](*form[1:])


def symbols_of(terms):
    """Return the names of the arguments in terms: a set."""
    return {name for term in terms for base, _ in term.factors for name in symbols_of_base(base)}


def symbols_of_base(base):
    """Return the names of the arguments in a base: a set."""
    if base[0] == "symbol":
        return {base[1]}
    return {name for terms in base[1:] if isinstance(terms, tuple) for name in symbols_of(terms)}


def calls_of(terms):
    """Return the calls in terms, those inside others too: a set of bases."""
    bases = [base for term in terms for base, _ in term.factors]
    inside = [terms for base in bases for terms in base[1:] if isinstance(terms, tuple)]
    return {base for base in bases if base[0] == "call"}.union(*map(calls_of, inside))
