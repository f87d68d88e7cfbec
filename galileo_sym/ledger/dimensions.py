"""Physical dimensions: every equation must be homogeneous."""

from __future__ import annotations

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean, BooleanAtom

from .predicates import Claim

ONE = sp.S.One
ANY = None  # the dimension of 0 and of infinities: agrees with every other

_SAME_AS_ARGUMENT = (sp.Abs, sp.Max, sp.Min)


class Inhomogeneous(ValueError):
    """Terms of different dimension were added, compared, or put into a transcendental function."""


def check(statement, table) -> None:
    """Raise `Inhomogeneous` unless `statement` is dimensionally consistent.

    Parameters
    ----------
    statement : sympy Boolean, or Claim
    table : mapping of Symbol or undefined function class to a monomial in mass, length, time
    """
    if isinstance(statement, BooleanAtom):
        return
    if isinstance(statement, Claim):
        statement.check_dimensions(lambda *e: _agree([dimension(x, table) for x in e], statement))
        for part in statement.args:
            if isinstance(part, Boolean):
                check(part, table)
    elif isinstance(statement, Relational):
        _relation(statement, table)
    elif isinstance(statement, Boolean):
        for part in statement.args:
            check(part, table)
    else:
        raise TypeError(f"not a statement: {statement!r}")


def _relation(relation, table):
    left, right = relation.lhs, relation.rhs
    if isinstance(left, sp.Tuple) or isinstance(right, sp.Tuple):
        for a, b in zip(left, right, strict=True):
            _agree([dimension(a, table), dimension(b, table)], relation)
    else:
        _agree([dimension(left, table), dimension(right, table)], relation)


def dimension(expr, table):
    """The dimension of an expression, `ANY` for 0; raises `Inhomogeneous`."""
    expr = sp.sympify(expr)
    if expr.is_Number or expr.is_NumberSymbol:
        return ANY if expr.is_zero or expr.is_infinite else ONE
    if expr in table:
        return table[expr]
    if isinstance(expr, AppliedUndef):
        if expr.func in table:
            return table[expr.func]
        raise Inhomogeneous(f"the dimension of {expr} is not declared: add {expr.func.__name__} to the notation")
    for kind, rule in _RULES:
        if isinstance(expr, kind):
            return rule(expr, table)
    if isinstance(expr, sp.Symbol):
        raise Inhomogeneous(f"the dimension of {expr} is not declared: add it to the notation")
    if isinstance(expr, sp.Function):  # transcendental: pure numbers in, a pure number out
        _agree([ONE, *(dimension(a, table) for a in expr.args)], expr)
        return ONE
    raise Inhomogeneous(f"no rule for the dimension of {expr!r}")


def _agree(dimensions, where):
    known = [d for d in dimensions if d is not ANY]
    for other in known[1:]:
        if sp.powsimp(other / known[0]) != 1:
            raise Inhomogeneous(f"{known[0]} against {other} in {where}")
    return known[0] if known else ANY


def _product(expr, table):
    parts = [dimension(a, table) for a in expr.args]
    return ANY if any(p is ANY for p in parts) else sp.powsimp(sp.Mul(*parts))


def _power(expr, table):
    base, exponent = expr.as_base_exp()
    _agree([ONE, dimension(exponent, table)], expr)
    inner = dimension(base, table)
    if inner is ANY or inner == 1:
        return inner
    if not exponent.is_number:
        raise Inhomogeneous(f"{base} has dimension {inner} and a variable exponent in {expr}")
    return sp.powsimp(sp.expand_power_base(inner**exponent, force=True))


def _derivative(expr, table):
    result = dimension(expr.expr, table)
    for symbol, times in expr.variable_count:
        result = ANY if result is ANY else result / dimension(symbol, table) ** times
    return result


def _limit(expr, table):
    inner, symbol, point = expr.args[:3]
    _agree([dimension(symbol, table), dimension(point, table)], expr)
    return dimension(inner, table)


def _piecewise(expr, table):
    for _, condition in expr.args:
        check(condition, table)
    return _agree([dimension(value, table) for value, _ in expr.args], expr)


def _order(expr, table):
    return dimension(expr.expr, table)


_RULES = (
    (sp.Add, lambda e, table: _agree([dimension(a, table) for a in e.args], e)),
    (sp.Mul, _product),
    (sp.exp, lambda e, table: _agree([ONE, dimension(e.args[0], table)], e)),
    (sp.Pow, _power),
    (sp.Derivative, _derivative),
    (sp.Subs, lambda e, table: dimension(e.expr, table)),
    (sp.Limit, _limit),
    (sp.Sum, lambda e, table: dimension(e.args[0], table)),
    (sp.Piecewise, _piecewise),
    (sp.Order, _order),
    (_SAME_AS_ARGUMENT, lambda e, table: _agree([dimension(a, table) for a in e.args], e)),
    (sp.sign, lambda e, table: (dimension(e.args[0], table), ONE)[1]),
    (sp.atan2, lambda e, table: (_agree([dimension(a, table) for a in e.args], e), ONE)[1]),
)
