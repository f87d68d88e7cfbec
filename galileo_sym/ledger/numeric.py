"""Statements tried in numbers: 50 digits at least, more until the answer is certain."""

from __future__ import annotations

import functools

import mpmath
import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFunction

from .predicates import Claim, OneSignChange

DIGITS = (80, 200, 500, 1200)  # tried in turn
AGREE = 50  # digits in which two sides must agree
MOST_TERMS = 4000  # of an infinite series


class Untestable(ValueError):
    """The statement has a symbol without a value, or a value that cannot be computed."""


def value(expr, point, digits):
    """The value of an expression at a point, as an mpmath number computed with `digits` digits."""
    expr, point = _plug_limits(sp.sympify(expr), point, digits)
    expr, point = _plug_sums(expr, point, digits)
    symbols, unknown, function = _compiled(expr)
    missing = [*(s for s in symbols if s not in point), *unknown]
    if missing:
        raise Untestable(f"no value for {', '.join(map(str, missing))} in {expr}")
    with mp.workdps(digits):
        # + makes a number of a constant, such as e, which else would be taken to the precision of whoever asks
        return +mp.mpmathify(function(*(_number(point[s], digits) for s in symbols)))


@functools.lru_cache(maxsize=4096, typed=True)  # 1 and the complex 1 are equal, and not the same number
def _number(exact, digits):
    if isinstance(exact, mpmath.mpf | mpmath.mpc):
        return exact
    return mp.mpmathify(sp.N(exact, digits + 5))


@functools.lru_cache(maxsize=4096)
def _compiled(expr):
    """The symbols of an expression, its unknown functions, and a function of the symbols' values."""
    symbols = tuple(sorted(expr.free_symbols, key=lambda s: s.name))
    unknown = tuple(expr.atoms(AppliedUndef))
    # common parts are computed once, but not those of a branch that is not taken
    together = not expr.has(sp.Piecewise)
    return symbols, unknown, sp.lambdify(symbols, expr, modules=[_extra_functions(expr), "mpmath"], cse=together)


def _extra_functions(expr):
    """SymPy functions of ours that mpmath does not know carry their own `mp_value`."""
    return {f.func.__name__: f.func.mp_value for f in expr.atoms(sp.Function) if hasattr(f.func, "mp_value")}


@functools.lru_cache(maxsize=8192)
def _parts(expr, kind):
    """The atoms of one kind, looked for once: an expression is tried at many points."""
    return expr.atoms(kind)


def _plug_limits(expr, point, digits):
    """Name every Limit, and add its value to the point: that of the function very near the place."""
    limits = _parts(expr, sp.Limit)
    if not limits:
        return expr, point
    values = {_name(e): _near(*e.args[:3], str(e.args[3]), point, digits) for e in limits}
    return expr.xreplace({e: _name(e) for e in limits}), {**point, **values}


def _plug_sums(expr, point, digits):
    """Name every infinite Sum, and add its value to the point."""
    sums = _parts(expr, sp.Sum)
    if not sums:
        return expr, point
    values = {_name(e): _total(e, point, digits) for e in sums}
    return expr.xreplace({e: _name(e) for e in sums}), {**point, **values}


def _total(series, point, digits):
    """Terms are added until several in a row are nothing beside the largest."""
    term, (n, first, last) = series.args
    if last is not sp.oo:
        raise Untestable(f"not an infinite series: {series}")
    hidden, constants = _varying(term, n)
    point = {**point, **{name: value(part, point, digits) for part, name in constants.items()}}
    total = largest = mp.mpf(0)
    idle = 0
    with mp.workdps(digits):
        start = int(value(first, point, digits))
        for i in range(start, start + MOST_TERMS):
            more = value(hidden, {**point, n: sp.Integer(i)}, digits)
            total, largest = total + more, max(largest, abs(more))
            idle = idle + 1 if abs(more) <= largest * mp.mpf(10) ** -(digits + 5) else 0
            if idle == 6:
                return total
    raise Untestable(f"{series} does not converge in {MOST_TERMS} terms at {point}")


@functools.lru_cache(maxsize=256)
def _varying(term, n):
    """A term with names for what does not depend on its number, which is computed once, and those names."""
    constants = {}

    def hide(expr):
        if expr.is_Number or expr == n:
            return expr
        if n not in expr.free_symbols:
            return constants.setdefault(expr, sp.Dummy("constant", real=True))
        return expr.func(*map(hide, expr.args))

    return hide(term), constants


@functools.lru_cache(maxsize=256)
def _name(infinite):
    return sp.Dummy(type(infinite).__name__.lower(), real=True)


def _near(f, x, at, direction, point, digits):
    h = sp.Integer(10) ** (-(digits - 10) // 1)
    at = at.xreplace({s: point[s] for s in at.free_symbols})
    if at in (sp.oo, -sp.oo):
        place = sp.sign(at) / h
    else:
        place = at + h if direction == "+" else at - h
    return value(f, {**point, x: place}, 8 * digits)


def holds(statement, point) -> bool:
    """Whether a statement is true at a point (a mapping of symbols to exact numbers)."""
    if statement in (sp.true, True):
        return True
    if statement in (sp.false, False):
        return False
    return _closed(statement) if _is_closed(statement) else _holds(statement, point)


@functools.lru_cache(maxsize=8192)
def _is_closed(statement):
    """Whether a statement is about no point, looked up once."""
    return not statement.free_symbols


@functools.lru_cache(maxsize=256)
def _closed(statement):
    """The truth of a statement that is about no point: found once, and not at every point."""
    return _holds(statement, {})


def _holds(statement, point):
    if isinstance(statement, OneSignChange):
        return statement.signs_of(
            lambda f, x, at: sign(f, _bind(point, {x: at})),
            lambda f, x, at: abs(value(f, _bind(point, {x: at}), DIGITS[0])),
        )
    if isinstance(statement, Claim):
        return all(holds(part, _bind(point, values)) for part, values in _trials(statement))
    if isinstance(statement, Relational):
        return _relation(statement, point)
    if isinstance(statement, sp.Not):
        return not holds(statement.args[0], point)
    if isinstance(statement, sp.Or):  # equations last: to find two numbers different takes every precision
        return any(holds(a, point) for a in sorted(statement.args, key=lambda a: isinstance(a, sp.Eq)))
    if isinstance(statement, BooleanFunction):
        parts = [holds(a, point) for a in statement.args]
        return bool(statement.func(*map(sp.sympify, parts)))
    raise Untestable(f"not a statement: {statement!r}")


@functools.lru_cache(maxsize=64)
def _trials(claim):
    """The trials of a claim, made once for all points."""
    return claim.trials()


def _bind(point, values):
    """The point with the variables of a claim added; their values may depend on the point."""
    return {**point, **{x: sp.sympify(v).xreplace(point) for x, v in values.items()}}


def sign(expr, point) -> int:
    """The sign of a real expression at a point: 0 if it vanishes to 50 digits of its terms at every precision."""
    before = None
    for digits in DIGITS:
        size, scale = _size(expr, point, digits)
        if _shrinks(abs(size), before, digits):
            return 0
        clear = before is not None or abs(size) > mp.mpf(10) ** (-digits // 2)
        if clear and abs(size) > scale * mp.mpf(10) ** (-(digits * 2) // 3):
            return 1 if size > 0 else -1
        before = (abs(size), digits)
    return 0


def _size(expr, point, digits):
    """The value of a real expression and the size of its largest term."""
    total = value(expr, point, digits)
    if abs(mp.im(total)) > abs(mp.re(total)) * mp.mpf(10) ** (-AGREE) + mp.mpf(10) ** (-digits // 2):
        raise Untestable(f"{expr} is not real at {point}")
    terms = sp.Add.make_args(expr)
    scale = max((abs(value(t, point, digits)) for t in terms), default=abs(total)) if len(terms) > 1 else abs(total)
    return mp.re(total), scale


_SIGN_RULES = {
    sp.StrictGreaterThan: lambda s: s > 0,
    sp.GreaterThan: lambda s: s >= 0,
    sp.StrictLessThan: lambda s: s < 0,
    sp.LessThan: lambda s: s <= 0,
}


def _relation(relation, point):
    if isinstance(relation, sp.Eq | sp.Ne):
        same = _equal(relation.lhs, relation.rhs, point)
        return same if isinstance(relation, sp.Eq) else not same
    try:
        return _SIGN_RULES[type(relation)](sign(relation.lhs - relation.rhs, point))
    except ZeroDivisionError:  # what has no value here is neither larger nor smaller
        return False
    except Untestable as problem:
        if "not real" in str(problem):
            return False
        raise


def _equal(left, right, point):
    if isinstance(left, sp.Tuple | tuple) or isinstance(right, sp.Tuple | tuple):
        return all(_equal(a, b, point) for a, b in zip(left, right, strict=True))
    for infinite, other in ((left, right), (right, left)):
        if infinite in (sp.oo, -sp.oo) and other.has(sp.Limit):
            return _diverges(other * sp.sign(infinite), point)
    before = unreal = None
    for digits in DIGITS:
        try:
            a, b = value(left, point, digits), value(right, point, digits)
            scale = max(abs(a), abs(b), *(abs(value(t, point, digits)) for t in _terms(left, right)))
        except Untestable:
            raise
        except (ZeroDivisionError, ValueError, TypeError):  # a side that has no value here equals nothing
            return False
        if not (mp.isfinite(a) and mp.isfinite(b)):
            return a == b
        gap = abs(a - b)
        off = abs(mp.im(a)) + abs(mp.im(b))
        if off > scale * mp.mpf(10) ** (-digits // 4) and not _shrinks(off, unreal, digits):
            gap, before, unreal = scale, None, (off, digits)  # what is not real, but for rounding, equals nothing here
            continue
        if gap <= scale * mp.mpf(10) ** -AGREE or _shrinks(gap, before, digits):
            return True
        before = (gap, digits)
    return gap <= mp.mpf(10) ** (-9 * digits // 10)  # less than all digits tried can tell from 0; other points decide


def _diverges(limit, point):
    """A limit is +oo if values taken ever nearer to it grow with the digits."""
    near, nearer = (mp.re(value(limit, point, digits)) for digits in DIGITS[:2])
    return 0 < near * 10 < nearer


def _shrinks(gap, before, digits):
    """A gap that goes with the precision is rounding: both sides are 0 there."""
    return before is not None and gap <= before[0] * mp.mpf(10) ** (-(digits - before[1]) // 3)


def _terms(*sides):
    """Terms whose size says how much a side may cancel; limits stand for themselves."""
    return [t for side in sides for t in sp.Add.make_args(sp.sympify(side)) if not side.has(sp.Limit)]
