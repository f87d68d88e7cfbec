"""A statement changed in one place at a time, by the slips that printed formulas have."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations, islice

import sympy as sp
from claim_mutants import claims
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.functions.elementary.piecewise import ExprCondPair

from galileo_sym.ledger.predicates import Claim

MOST = 6  # mutants of one kind that are made of one equation

_ORDERS = (sp.StrictGreaterThan, sp.GreaterThan, sp.StrictLessThan, sp.LessThan)
_REVERSED = dict(zip(_ORDERS, (sp.StrictLessThan, sp.LessThan, sp.StrictGreaterThan, sp.GreaterThan), strict=True))
_STRICT = {sp.GreaterThan: sp.StrictGreaterThan, sp.LessThan: sp.StrictLessThan}
_COFUNCTION = {
    sp.sin: sp.cos, sp.cos: sp.sin, sp.tan: sp.cot, sp.cot: sp.tan,
    sp.asin: sp.acos, sp.acos: sp.asin, sp.atan: sp.acot, sp.acot: sp.atan,
}  # fmt: skip
_FIRST_OPEN = (sp.Derivative, sp.Limit, ExprCondPair, ExprWithLimits)  # what stands behind says where
_UNDECIDED = (AppliedUndef, sp.LambertW, sp.Abs)
_HARMLESS = {  # -1 solves w e^(-w-1) = -1, too; beyond its bound an alternative such as w = W_(-1)(q) has no value
    sp.Equivalent: ("sign of an exponent",),
    sp.Or: ("bound off by 1", "bound not attained"),
}
_SHUT = (AppliedUndef, sp.Subs, sp.Lambda, sp.Order)  # unknown functions and what binds variables: not looked into


@dataclass(frozen=True)
class Mutant:
    """A changed statement, and by which operator it was changed."""

    operator: str
    statement: sp.Basic


def mutants(statement, dimensions=None) -> list[Mutant]:
    """The mutants of a statement, each different from it and from the others.

    Parameters
    ----------
    dimensions : mapping, optional
        Dimensions of symbols and functions: quantities of the same dimension are swapped.
    """
    found = {}
    for operator, other in _statement(statement, dimensions or {}):
        if other != statement and not other.has(sp.nan, sp.zoo):
            found.setdefault(other, Mutant(operator, other))
    return list(found.values())


def _statement(statement, dimensions) -> Iterator[tuple[str, sp.Basic]]:
    if isinstance(statement, sp.And | sp.Or | sp.Equivalent):
        yield from _parts(statement, range(len(statement.args)), dimensions)
    elif isinstance(statement, sp.Implies | sp.Not):
        yield from _parts(statement, [len(statement.args) - 1], dimensions)
    elif isinstance(statement, Claim):
        yield from claims(statement)
    elif isinstance(statement, Relational):
        yield from _RELATIONS[type(statement)](statement, dimensions)
    if not isinstance(statement, sp.Not):
        yield "denied", sp.Not(statement, evaluate=False)


def _parts(whole, places, dimensions):
    for place in places:
        for operator, part in _statement(whole.args[place], dimensions):
            dropped = part in whole.args  # not wrong, but said twice
            if not dropped and operator not in _HARMLESS.get(type(whole), ()):
                yield operator, _with_arg(whole, place, part)


def _with_arg(expr, place, arg):
    return _made(expr, [*expr.args[:place], arg, *expr.args[place + 1 :]])


def _made(expr, args):
    plain = isinstance(expr, Relational | sp.logic.boolalg.BooleanFunction) and not isinstance(expr, Claim)
    return expr.func(*args, evaluate=False) if plain else expr.func(*args)


def _equation(equation, dimensions):
    for operator, change in _SIDES.items():
        yield operator, sp.Eq(equation.lhs, _each(change, equation.rhs), evaluate=False)
    if isinstance(equation.lhs, sp.Limit):
        for function in _other_functions(equation):
            yield "limit of another function", sp.Eq(function, equation.rhs, evaluate=False)
    yield "equality denied", sp.Ne(*equation.args, evaluate=False)
    yield from _inside(equation, dimensions)


def _each(change, side):
    return sp.Tuple(*(_each(change, part) for part in side)) if isinstance(side, sp.Tuple) else change(side)


_SIDES = {
    "side negated": lambda side: -side,
    "factor 2": lambda side: -side if side.is_infinite else 2 * side if side != 0 else sp.S.One,
    "factor 1 + 1e-20": lambda side: side * (1 + sp.Rational(1, 10**20)),
    "shifted by 1": lambda side: -side if side.is_infinite else side + 1,
}


def _other_functions(equation):
    """Limits of functions changed so that the value is another: twice what tends to 0 does, too."""
    f, *where, side = equation.lhs.args
    value = equation.rhs
    changed = (f + 1,) if value == 0 else (-f,) if value.is_infinite else (-f, 2 * f, f + 1)
    return [sp.Limit(other, *where, str(side)) for other in changed]


def _inequality(relation, dimensions):
    yield "order reversed", _REVERSED[relation.func](*relation.args, evaluate=False)
    if relation.func in _STRICT:
        yield "bound not attained", _STRICT[relation.func](*relation.args, evaluate=False)
    for amount in (1, -1):
        yield "bound off by 1", relation.func(relation.lhs, relation.rhs + amount, evaluate=False)


def _unequal(relation, dimensions):
    yield "inequality denied", sp.Eq(*relation.args, evaluate=False)


_RELATIONS = {sp.Eq: _equation, sp.Ne: _unequal, **dict.fromkeys(_ORDERS, _inequality)}


def _inside(equation, dimensions):
    """Changes of one node of an equation, and of one symbol in all its places."""
    for operator, rule in _NODES.items():
        for other in islice(_one_place_at_a_time(equation, rule), MOST):
            yield operator, other
    named = {equation.lhs} if isinstance(equation.lhs, sp.Symbol) else set()
    for symbol in sorted(_coefficients(equation) - named, key=str)[:MOST]:
        yield "sign of a symbol", _put_in(equation, {symbol: -symbol})
        yield "symbol doubled", _put_in(equation, {symbol: 2 * symbol})
    pairs = (p for p in _alike(equation, dimensions) if not named & set(p))  # z = W/alpha says that alpha = W/z
    for one, other in islice(pairs, MOST):
        yield "quantities swapped", _put(equation, {one: other, other: one})


def _one_place_at_a_time(expr, rule):
    if not isinstance(expr, Relational | sp.Tuple):
        yield from rule(expr)
    for place in _open_places(expr):
        for arg in _one_place_at_a_time(expr.args[place], rule):
            yield _with_arg(expr, place, arg)


def _open_places(expr):
    """Which arguments are changed; not those of a limit that no rule decides, where what vanishes leaves it true."""
    if isinstance(expr, _SHUT) or (isinstance(expr, sp.Limit) and expr.has(*_UNDECIDED)):
        return ()
    if isinstance(expr, sp.Derivative) and isinstance(expr.expr, AppliedUndef):
        return ()
    if isinstance(expr, _FIRST_OPEN):
        return (0,)
    return range(len(expr.args))


def _terms(change):
    def rule(node):
        if isinstance(node, sp.Add):
            for place, term in enumerate(node.args):
                yield sp.Add(*node.args[:place], *change(term), *node.args[place + 1 :])

    return rule


def _exponent(node):
    if isinstance(node, sp.Pow) and node.exp.is_Number:
        yield node.base ** (node.exp + 1 if node.exp != -1 else -2)


def _branch(node):
    if isinstance(node, sp.LambertW):
        yield sp.LambertW(node.args[0], *([] if len(node.args) == 2 else [-1]))


def _cofunction(node):
    if node.func in _COFUNCTION:
        yield _COFUNCTION[node.func](*node.args)


def _sign_of_exponent(node):
    if isinstance(node, sp.exp):
        yield sp.exp(-node.args[0])


def _other_derivative(node):
    if isinstance(node, sp.Derivative):
        (variable, times), *rest = node.variable_count
        yield sp.Derivative(node.expr, (variable, times + 1 if times == 1 else times - 1), *rest)


def _other_limit(node):
    if isinstance(node, sp.Limit):
        inner, variable, place, side = node.args
        aside = sp.S.Half if str(side) == "+" else -sp.S.Half
        yield sp.Limit(inner, variable, place + aside if place.is_finite else sp.S.One, str(side))


_NODES = {
    "sign of a term": _terms(lambda term: (-term,)),
    "term dropped": _terms(lambda term: ()),
    "exponent + 1": _exponent,
    "other branch of W": _branch,
    "sine for cosine": _cofunction,
    "sign of an exponent": _sign_of_exponent,
    "other derivative": _other_derivative,
    "limit elsewhere": _other_limit,
}


def _put_in(equation, values):
    """An equation with symbols exchanged; a limit stays as it is, and its value is changed."""
    if equation.lhs.has(sp.Limit):
        return sp.Eq(equation.lhs, _put(equation.rhs, values), evaluate=False)
    return _put(equation, values)


def _put(expr, values):
    """Symbols exchanged everywhere but in the arguments of unknown functions and where they are bound."""
    if expr in values:
        return values[expr]
    places = _open_places(expr)
    args = [_put(arg, values) if place in places else arg for place, arg in enumerate(expr.args)]
    return expr if tuple(args) == expr.args else _made(expr, args)


def _coefficients(expr):
    """Symbols that `_put` reaches, without those that a derivative, limit or sum is taken in."""
    if isinstance(expr, sp.Symbol):
        return {expr}
    inside = set().union(*(_coefficients(expr.args[place]) for place in _open_places(expr)))
    bound = expr.args[1:] if isinstance(expr, _FIRST_OPEN) else ()
    return inside - {s for a in bound for s in a.free_symbols}


def _alike(equation, dimensions):
    """Pairs of quantities of one dimension."""
    names = {q for q in sp.preorder_traversal(equation) if isinstance(q, sp.Symbol | AppliedUndef)}
    numbers = {s for total in equation.atoms(ExprWithLimits) for s in total.bound_symbols}
    numbers |= {limit.args[1] for limit in equation.atoms(sp.Limit)}
    names = {q for q in names if isinstance(q, AppliedUndef) or q in _coefficients(equation)}
    names = {q for q in names if not q.free_symbols & numbers}
    for one, other in combinations(sorted(names, key=str), 2):
        sizes = [dimensions.get(q if isinstance(q, sp.Symbol) else q.func) for q in (one, other)]
        if sizes[0] is not None and sizes[0] == sizes[1] and not one.has(other) and not other.has(one):
            yield one, other
