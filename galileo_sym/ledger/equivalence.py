"""Symbolic proof that two statements say the same."""

from __future__ import annotations

import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean

from .arcs import as_arctangents
from .ideals import same_solutions
from .near_limits import same_limit
from .predicates import Claim
from .spot import nonzero_somewhere
from .unwrap import same_in_cases

_UNORDERED = (sp.And, sp.Or, sp.Equivalent)
ORDERED = (sp.StrictGreaterThan, sp.GreaterThan, sp.StrictLessThan, sp.LessThan)


def equivalent(one, other) -> str | None:
    """How `one` and `other` are shown equivalent, or None if no proof was found.

    None is not a refutation: whoever calls tries numbers.
    """
    if one == other:
        return "identical"
    if isinstance(one, Claim) and isinstance(other, Claim):
        return _claims(one, other)
    if isinstance(one, Relational) and isinstance(other, Relational):
        return _relations(one, other)
    if isinstance(one, _UNORDERED) and one.func == other.func:
        return _in_any_order(one, other) or (same_solutions(one, other) if isinstance(one, sp.And) else None)
    for whole, single in ((one, other), (other, one)):
        if isinstance(whole, sp.And) and not isinstance(single, sp.And):  # the same thing said twice
            return _strongest([equivalent(part, single) for part in whole.args])
    if isinstance(one, sp.Not | sp.Implies) and one.func == other.func:
        return _pairwise(one.args, other.args)
    return None


def _pairwise(ones, others):
    if len(ones) != len(others):
        return None
    ways = [_same_thing(a, b) for a, b in zip(ones, others, strict=True)]
    return _strongest(ways)


def _strongest(ways):
    if any(w is None for w in ways):
        return None
    named = [w for w in ways if w != "identical"]
    return named[-1] if named else "identical"


def _same_thing(a, b):
    if a == b:
        return "identical"
    if isinstance(a, Boolean):
        return equivalent(a, b)
    if isinstance(a, sp.Tuple) and isinstance(b, sp.Tuple):
        return _pairwise(a.args, b.args)
    if isinstance(a, sp.Interval) and isinstance(b, sp.Interval):
        ends = _pairwise((a.start, a.end), (b.start, b.end))
        return ends if (a.left_open, a.right_open) == (b.left_open, b.right_open) else None
    if isinstance(a, sp.Limit) and isinstance(b, sp.Limit):
        return _pairwise(a.args, b.args) or same_limit(a, b)
    if a.has(sp.Limit) or b.has(sp.Limit):
        return _pairwise(a.args, b.args) if a.func == b.func and a.args else None
    if isinstance(a, sp.Piecewise) != isinstance(b, sp.Piecewise):
        return same_in_cases(a, b, _same_thing)
    if isinstance(a, sp.Expr) and isinstance(b, sp.Expr):
        return is_zero(a - b) or _same_function(a, b)
    return "identical" if a == b else None


def _same_function(a, b):
    """f(A) = f(B) if A = B; the branches of a Piecewise one by one."""
    if isinstance(a, sp.Piecewise) and isinstance(b, sp.Piecewise):
        return _pairwise([part for pair in a.args for part in pair], [part for pair in b.args for part in pair])
    if isinstance(a, sp.Function) and a.func == b.func:
        return _pairwise(a.args, b.args)
    return None


def _claims(one, other):
    if one.func != other.func:
        return None
    return _pairwise(one.args, other.args)


def _in_any_order(one, other):
    left = [part for part in other.args if part not in one.args]
    ways = ["identical"]
    for part in (p for p in one.args if p not in other.args):
        for candidate in left:
            way = _same_thing(part, candidate)
            if way is not None:
                left.remove(candidate)
                ways.append(way)
                break
        else:
            return None
    return None if left else _strongest(ways)


def _relations(one, other):
    if isinstance(one, sp.Eq) and isinstance(other, sp.Eq):
        return _equations(one, other)
    if isinstance(one, sp.Ne) and isinstance(other, sp.Ne):
        return _equations(sp.Eq(*one.args, evaluate=False), sp.Eq(*other.args, evaluate=False))
    if isinstance(one, ORDERED) and isinstance(other, ORDERED):
        return _inequalities(one, other)
    return None


def _equations(one, other):
    for a, b in ((other.lhs, other.rhs), (other.rhs, other.lhs)):
        way = _same_thing(one.lhs, a)
        inner = way and _same_thing(one.rhs, b)
        if inner:
            return _strongest([way, inner])
    if isinstance(one.lhs, sp.Tuple) and isinstance(other.lhs, sp.Tuple):
        pair = [sp.And(*_componentwise(e), evaluate=False) for e in (one, other)]
        return _in_any_order(*pair) or same_solutions(*pair)
    if isinstance(one.lhs, sp.Tuple) or isinstance(other.lhs, sp.Tuple):
        return None
    if one.has(sp.Limit) or other.has(sp.Limit):
        return None
    return _proportional(one.lhs - one.rhs, other.lhs - other.rhs, lambda r: r.is_nonzero, "proportional")


def _componentwise(equation):
    """An equation between tuples as equations between their components."""
    return [sp.Eq(a, b, evaluate=False) for a, b in zip(equation.lhs, equation.rhs, strict=True)]


def _inequalities(one, other):
    strict = (sp.StrictGreaterThan, sp.StrictLessThan)
    if isinstance(one, strict) != isinstance(other, strict):
        return None
    between = sp.expand(_excess(one) - _excess(other))
    if between.is_number and between.is_nonzero:  # bounds a constant apart
        return None
    return _proportional(_excess(one), _excess(other), lambda r: r.is_positive, "positive multiple")


def _excess(relation):
    """The expression that an inequality says to be positive (or not negative)."""
    return relation.gts - relation.lts


def _proportional(f, h, allowed, name):
    way = is_zero(f - h)
    if way is not None:
        return way
    if h == 0:
        return None
    for tidy in (sp.cancel, sp.simplify):
        ratio = sp.factor(tidy(sp.together(f / h)))
        if allowed(ratio) and is_zero(f - ratio * h) is not None:
            return f"{name} ({ratio})"
    return None


def is_zero(expr) -> str | None:
    """The name of the first move that reduces an expression to 0, or None."""
    expr = sp.sympify(expr)
    if expr == 0:
        return "identical"
    if nonzero_somewhere(expr):  # at once, where the moves may take seconds
        return None
    for name, move in _MOVES:
        if move(expr) == 0:
            return name
    return None


def _rational(expr):
    return sp.cancel(sp.together(expr))


def _without_w(expr):
    """Write every W(q) as a symbol w, with e^w = q/w."""
    expr = expr.replace(lambda e: isinstance(e, sp.LambertW), lambda e: e.func(sp.expand(e.args[0]), *e.args[1:]))
    for w in sorted(expr.atoms(sp.LambertW), key=lambda e: (-sp.count_ops(e), str(e))):
        name = sp.Dummy("w", real=True)
        expr = expr.replace(lambda e: isinstance(e, sp.exp) and e.args[0].has(w), lambda e: _exp_of(e.args[0], w))  # noqa: B023
        expr = expr.xreplace({w: name})
    return expr


def _exp_of(exponent, w):
    """e^(n w + rest) as (q/w)^n e^rest, for a whole number n."""
    name = sp.Dummy("w", real=True)
    tidy = sp.cancel(sp.together(exponent.xreplace({w: name})))
    times = sp.cancel(sp.diff(tidy, name))
    rest = sp.cancel(tidy - times * name)
    if not times.is_Integer or rest.has(name):
        return sp.exp(exponent)
    return (w.args[0] / w) ** times * sp.exp(rest)


def _w_rational(expr):
    return _rational(sp.powsimp(sp.expand(_without_w(expr)))) if expr.has(sp.LambertW) else expr


def _trig_polynomial(expr):
    """Reduce a rational function of sines and cosines modulo s^2 + c^2 = 1."""
    if not expr.has(sp.sin, sp.cos, sp.tan, sp.cot):
        return expr
    expr = sp.expand_trig(expr.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)))
    expr = expr.replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))
    over = sp.numer(sp.together(expr))
    angles = sorted({a.args[0] for a in over.atoms(sp.sin, sp.cos)}, key=sp.default_sort_key)
    for angle in angles:
        s, c = sp.Dummy("s"), sp.Dummy("c")
        poly = sp.expand(over.xreplace({sp.sin(angle): s, sp.cos(angle): c}))
        if not poly.is_polynomial(c):
            continue
        over = sp.rem(poly, c**2 + s**2 - 1, c).xreplace({s: sp.sin(angle), c: sp.cos(angle)})
    return sp.expand(over)


def _radicals(expr):
    """P*A**e - Q*B**e with P, Q >= 0 and e = ±1/2: equal if the squares are, since the principal root is a function.

    A root of unknown sign may stand on a side once only, and with one exponent: sqrt(x)*sqrt(y) is not sqrt(x*y), nor
    1/sqrt(x) sqrt(1/x), for negative x and y.
    """
    terms = sp.Add.make_args(sp.expand(expr))
    if len(terms) != 2:
        return expr
    roots = [_loose_roots(term) for term in (terms[0], -terms[1])]
    if None in roots or roots[0] != roots[1]:
        return expr
    return sp.simplify(sp.expand(terms[0] ** 2) - sp.expand(terms[1] ** 2))


def _loose_roots(term):
    """Exponents of the roots of unknown sign in a product of things >= 0; None if it is no such product."""
    loose = []
    for factor in sp.Mul.make_args(term):
        if factor.is_nonnegative:
            continue
        exponent = factor.as_base_exp()[1]
        if exponent not in (sp.S.Half, -sp.S.Half):
            return None
        loose.append(exponent)
    return loose if len(loose) <= 1 else None


def _derivatives(expr):
    return sp.expand(expr.doit()) if expr.has(sp.Derivative) else expr


_MOVES = (
    ("expand", sp.expand),
    ("derivatives", _derivatives),
    ("powers of e together", lambda e: sp.expand(sp.powsimp(e, combine="exp", deep=True))),
    ("common denominator", _rational),
    ("W e^W = q", _w_rational),
    ("sin^2 + cos^2 = 1", _trig_polynomial),
    ("squares of roots", _radicals),
    ("arctangents", as_arctangents),
    ("simplify", sp.simplify),
    ("exponentials", lambda e: sp.simplify(sp.powsimp(sp.expand(e.rewrite(sp.exp))))),
)
