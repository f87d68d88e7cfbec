"""From what a statement speaks of to numbers: dependent variables and unknown functions are put in."""

from __future__ import annotations

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from .predicates import Claim

DEEPEST = 200  # no chain of definitions, nor any expression here, is deeper


def definitions(statement) -> dict:
    """What an explicit statement defines: Eq(symbol, expr), Eq(f(t), expr), or conjunctions and tuples of them."""
    return {a: b for a, b in equations(statement) if _definable(a, b)}


def equations(statement):
    """The sides of every equation in a statement: conjunctions and tuples are taken apart."""
    if isinstance(statement, sp.And):
        for part in statement.args:
            yield from equations(part)
    elif isinstance(statement, sp.Eq):
        left, right = statement.args
        tuples = isinstance(left, sp.Tuple) and isinstance(right, sp.Tuple)
        yield from zip(left, right, strict=True) if tuples else ((left, right),)


def _definable(left, right):
    of_unknown = isinstance(left, sp.Derivative) and left.has(AppliedUndef)
    named = isinstance(left, sp.Symbol) or of_unknown or _general(left)
    return named and not sp.sympify(right).has(left)


def _general(left):
    """f(t), not f(0)."""
    return isinstance(left, AppliedUndef) and all(isinstance(a, sp.Symbol) for a in left.args)


def resolve(expr, given: dict, keep=frozenset(), depth=0):
    """Put in everything that `given` defines, except for the symbols of `keep`, and carry out derivatives.

    `given` maps symbols, undefined functions applied to symbols, or derivatives of those, to expressions. Variables
    of differentiation, of limits and of claims are kept inside: dy/du is taken before u is put in.
    """
    if depth > DEEPEST:
        raise RecursionError(f"definitions that go round in a circle: {sorted(map(str, given))}")

    def again(e, more=frozenset()):
        return resolve(e, given, keep | more, depth + 1)

    if expr in given and expr not in keep:
        return again(given[expr])
    if isinstance(expr, sp.Derivative):
        return _derivative(expr, again, given)
    if isinstance(expr, sp.Subs):
        inner = again(expr.expr, frozenset(expr.variables))
        return sp.Subs(inner, expr.variables, [again(p) for p in expr.point]).doit()
    if isinstance(expr, AppliedUndef):
        body = _body_of(expr.func, given)
        if body is not None:
            return again(body(*expr.args))
    if not expr.args or isinstance(expr, sp.Lambda):
        return expr
    return _rebuild(expr, again)


def _body_of(function, given):
    for applied, expr in given.items():
        if _general(applied) and applied.func == function:
            return sp.Lambda(applied.args, expr)
    return None


def _derivative(expr, again, given):
    variables = frozenset(expr.variables)
    inner = again(expr.expr, variables)
    if inner.has(AppliedUndef):
        return sp.Derivative(inner, *expr.variable_count)
    done = sp.Derivative(inner, *expr.variable_count).doit()
    return again(done) if variables & set(given) else done


def _rebuild(expr, again):
    bound = _bound(expr)
    args = [a if a in bound else again(a, bound) for a in expr.args]
    if all(a is b for a, b in zip(args, expr.args, strict=True)):
        return expr
    return expr.func(*args, evaluate=False) if isinstance(expr, Relational) else expr.func(*args)


def _bound(expr):
    if isinstance(expr, sp.Limit):
        return frozenset({expr.args[1]})
    if isinstance(expr, Claim):
        return frozenset(expr.bound_symbols)
    return frozenset()


def opaque(statement) -> set:
    """Unknown functions and their derivatives that are left: what a differential equation speaks of."""
    found = set()
    for e in sp.preorder_traversal(statement):
        if isinstance(e, sp.Derivative | AppliedUndef):
            found.add(e)
    return found


def as_algebra(statement):
    """A differential equation as an equation between independent quantities s, s', s'' …; with the symbols made."""
    names = {e: sp.Dummy(str(e), real=True) for e in opaque(statement) if isinstance(e, sp.Derivative)}
    statement = statement.xreplace(names)
    rest = {e: sp.Dummy(str(e), real=True) for e in opaque(statement)}
    return statement.xreplace(rest), {**names, **rest}
