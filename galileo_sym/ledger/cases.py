"""Equivalence for all values of a variable: for each of the few it takes, or for multiples of them."""

from __future__ import annotations

from itertools import product

import sympy as sp

from .environment import resolve
from .equivalence import equivalent

CASES = 4  # of finite sets of values, at most, to be put in one by one


def case_by_case(derived, other, domain) -> str | None:
    """Equivalence for each of the few values that a variable takes, such as a sign."""
    spoken = derived.free_symbols | other.free_symbols
    few = {s: tuple(v) for s, v in domain.ranges.items() if s in spoken and isinstance(v, sp.FiniteSet)}
    cases = list(product(*few.values()))
    if not few or len(cases) > CASES or any(v.free_symbols for case in cases for v in case):
        return None
    for case in cases:
        put = dict(zip(few, case, strict=True))
        if equivalent(resolve(derived, put), resolve(other, put)) is None:
            return None
    return f"case by case ({', '.join(map(str, few))})"


def for_multiples(derived, other, domain, known, same=equivalent) -> str | None:
    """What holds for every value of an independent variable holds for those multiples of it that are values, too."""
    if any(derived.has(k) for k in known):
        return None
    for variable in sorted(derived.free_symbols & set(domain.ranges), key=str):
        for factor in (2, -1):
            if _into_itself(domain.ranges[variable], factor):
                name = sp.Dummy(variable.name, real=True)
                multiplied = resolve(resolve(derived, {variable: name}), {name: factor * variable})
                if same(multiplied, other):
                    return f"true for every {variable}, so for {factor * variable}"
    return None


def _into_itself(values, factor):
    """Whether the multiples of all values are values."""
    whole = sp.Union(*values.args) if isinstance(values, sp.Union) else values
    if whole.free_symbols or not isinstance(whole, sp.Interval):
        return False
    low, high = sorted((factor * whole.start, factor * whole.end))
    image = sp.Interval(low, high, *((whole.left_open, whole.right_open)[:: 1 if factor > 0 else -1]))
    return image.is_subset(whole) is True
