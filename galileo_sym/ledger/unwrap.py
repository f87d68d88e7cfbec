"""Equations solved for what stands in a one-to-one function: t^2 = r is t = sqrt(r) for t > 0."""

from __future__ import annotations

import sympy as sp

_QUARTER = sp.pi / 2

# functions of a quantity, where they are one-to-one, and their inverses there
_ONE_TO_ONE = (
    (sp.sin, sp.Interval(-_QUARTER, _QUARTER), sp.asin),
    (sp.cos, sp.Interval(0, sp.pi), sp.acos),
    (sp.tan, sp.Interval.open(-_QUARTER, _QUARTER), sp.atan),
)


def unwrapped(statement, derived, ranges, independent=()):
    """The statement with every equation that has a quantity in one function alone solved for the quantity.

    A value of the function that no real quantity has makes both equations false, so that they say the same.

    Parameters
    ----------
    statement : Boolean
    derived : Boolean
        A true statement: what it divides by is not 0.
    ranges : mapping of Symbol to Interval
        Where quantities lie, beside what their assumptions say.
    independent : collection of Symbol
        Not to be solved for.

    Returns
    -------
    Boolean
        The statement itself where nothing can be solved.
    """
    if isinstance(statement, sp.And):
        return sp.And(*(unwrapped(part, derived, ranges, independent) for part in statement.args), evaluate=False)
    if not isinstance(statement, sp.Eq) or isinstance(statement.lhs, sp.Tuple) or statement.has(sp.Limit):
        return statement
    difference = statement.lhs - statement.rhs
    bases = (e.base for e in derived.atoms(sp.Pow) if e.exp.is_negative)
    divisors = {part for base in bases for part in sp.Mul.make_args(sp.factor(base))}
    for quantity in sorted(difference.free_symbols - set(independent), key=str):
        for wrapped, inverse in _wrappings(quantity, difference, ranges):
            value = _linear_root(difference, wrapped, quantity, divisors)
            if value is not None:
                return sp.Eq(quantity, inverse(value), evaluate=False)
    return statement


def _wrappings(quantity, expr, ranges):
    """What a quantity may stand in, and how to undo it."""
    powers = {e.exp for e in expr.atoms(sp.Pow) if e.base == quantity and e.exp.is_Integer and e.exp > 1}
    if quantity.is_nonnegative and len(powers) == 1:
        (power,) = powers
        yield quantity**power, lambda value: sp.root(value, power)
    for function, one_to_one, inverse in _ONE_TO_ONE:
        if expr.has(function(quantity)) and quantity in ranges and ranges[quantity].is_subset(one_to_one):
            yield function(quantity), inverse


def _linear_root(difference, wrapped, quantity, divisors):
    """The value of `wrapped` in an equation linear in it that has the quantity nowhere else; its factor is not 0."""
    name = sp.Dummy("wrapped", real=True)
    linear = sp.expand(difference.subs(wrapped, name))
    if quantity in linear.free_symbols or not linear.is_polynomial(name) or sp.degree(linear, name) != 1:
        return None
    factor = sp.factor(linear.coeff(name, 1))
    known = all(e.is_nonzero or any(sp.expand(e**2 - d**2) == 0 for d in divisors) for e in sp.Mul.make_args(factor))
    return sp.factor_terms(-linear.coeff(name, 0) / factor) if known else None


def same_in_cases(one, other, same):
    """How an expression equals a Piecewise, shown branch by branch; None if a branch is not shown.

    Parameters
    ----------
    one, other : expressions
        One of them a Piecewise.
    same : callable
        Says how two expressions are equal.
    """
    cases, whole = (one, other) if isinstance(one, sp.Piecewise) else (other, one)
    ways, left_out = [], {}
    for value, condition in cases.args:
        put = _only_place(condition) or (left_out if condition == sp.true else {})
        ways.append(same(value.subs(put), whole.subs(put)))
        left_out = _only_place(sp.Not(condition))
    return "case by case" if ways and all(ways) else None


def _only_place(condition):
    """{x: place} for the condition x = place."""
    if not isinstance(condition, sp.Eq):
        return {}
    x, place = condition.args if isinstance(condition.lhs, sp.Symbol) else condition.args[::-1]
    return {x: place} if isinstance(x, sp.Symbol) and place.is_number else {}
