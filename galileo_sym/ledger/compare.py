"""Hold any statement against a derived one: equivalence under the entry's assumptions."""

from __future__ import annotations

import random
import time

import mpmath
import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import BooleanAtom

from . import numeric
from .check import POINTS, counterexample, digits, ready_to_try
from .domain import EmptyDomain
from .environment import definitions, resolve
from .equivalence import equivalent, is_zero
from .verdict import Kind, Verdict

STARTS = 6  # starting values for the search of a root of the other statement


def compare(statement, derived, declaration, given) -> Verdict:
    """Whether `statement` says the same as `derived` inside the declaration's assumptions.

    Returns
    -------
    Verdict
        proved, refuted (with a counterexample), or checked (no difference found, and no proof either).
    """
    start = time.perf_counter()
    kind, method, example = _compare(declaration.notation.adopt(statement, derived), derived, declaration, given)
    return Verdict(kind, method, time.perf_counter() - start, example)


def _compare(other, derived, declaration, given):
    if derived == other:
        return Kind.PROVED, "identical", None
    own = definitions(derived)
    known = {**given, **{k: v for k, v in own.items() if k not in declaration.domain.ranges}}
    tautology = isinstance(other, BooleanAtom) and bool(other)
    try:
        failure = None if tautology else counterexample(other, declaration.domain, known, declaration.id)
        if failure is not None:
            return Kind.REFUTED, "the derived statement holds here, the other does not", failure
        how = equivalent(derived, other) or _with_definitions(derived, other, declaration.domain, known, own)
        if how:
            return Kind.PROVED, how, None
        failure = _other_way(other, derived, declaration, known)
    except EmptyDomain as problem:
        return Kind.VACUOUS, str(problem), None
    except Exception as problem:  # what SymPy cannot do with a user's statement is said, not raised
        return Kind.ERROR, f"cannot be compared: {problem}", None
    if failure is not None:
        return Kind.REFUTED, "the other statement holds here, the derived one does not", failure
    return Kind.CHECKED, "equal in numbers only", None


def _with_definitions(derived, other, domain, known, own):
    """Equivalence once both are written with the same quantities: s(t) in one, its formula in the other.

    What both speak of stays: with it put in, any two true statements become 0 = 0.
    """
    put = {k: v for k, v in known.items() if k not in own and derived.has(k) != other.has(k)}
    pair = [resolve(e, put, frozenset(domain.ranges)) for e in (derived, other)]
    return None if any(map(_says_nothing, pair)) else equivalent(*pair)


def _says_nothing(statement):
    """Whether a statement, or a part of it, has become an identity."""
    if isinstance(statement, sp.And):
        return any(map(_says_nothing, statement.args))
    if isinstance(statement, sp.Eq):
        return all(is_zero(a - b) is not None for a, b in _sides(statement))
    return isinstance(statement, BooleanAtom)


def _sides(equation):
    tuples = all(isinstance(side, sp.Tuple) for side in equation.args)
    return zip(*equation.args, strict=True) if tuples else [equation.args]


def _other_way(other, derived, declaration, given):
    """A point where `other` holds and `derived` fails, looked for by moving one dependent quantity."""
    for quantity in sorted(_dependent(derived, declaration.domain, given), key=str):
        found = _move(quantity, other, derived, declaration, given)
        if found is not None:
            return found
    return None


def _dependent(derived, domain, given):
    """Symbols, f(t) and derivatives that a derived statement speaks of, and that are not independent variables."""
    kinds = sp.Symbol | AppliedUndef | sp.Derivative
    spoken = (e for e in sp.preorder_traversal(derived) if isinstance(e, kinds))
    return {e for e in spoken if e in given and e not in domain.ranges}


def _move(quantity, other, derived, declaration, given):
    domain, seed = declaration.domain, declaration.id
    within = declaration.notation.ranges.get(quantity, sp.S.Reals)
    symbol = _as_symbol(quantity)
    statements = [statement.xreplace({quantity: symbol}) for statement in (other, derived)]
    if any(_speaks_of(quantity, statement) for statement in statements):
        return None  # f(t) does not move without its derivatives
    known = {k: v for k, v in given.items() if k != quantity}
    loose_other, _ = ready_to_try(statements[0], domain, known)
    loose_derived, ranges = ready_to_try(statements[1], domain, known)
    if symbol not in loose_derived.free_symbols:
        return None
    place, _ = ready_to_try(sp.Eq(symbol, given[quantity], evaluate=False), domain, known)
    rng = random.Random(seed)
    for point in type(domain)(ranges).points(POINTS // 2, seed):
        try:
            here = numeric.value(place.rhs, point, 60)
        except ZeroDivisionError:
            continue
        for guess in _roots(loose_other, symbol, point, here, rng):
            if not _allowed(symbol, guess, within):
                continue
            moved = {**point, symbol: guess}
            if numeric.holds(loose_other, moved) and not numeric.holds(loose_derived, moved):
                return {str(quantity if s == symbol else s): digits(v) for s, v in moved.items()}
    return None


def _as_symbol(quantity):
    """A symbol of the same sign, to be moved in the place of f(t) or a derivative."""
    if isinstance(quantity, sp.Symbol):
        return quantity
    signs = {name: True for name in ("positive", "nonnegative") if getattr(quantity, f"is_{name}")}
    return sp.Dummy("moved", real=True, **signs)


def _speaks_of(quantity, statement):
    """Whether the unknown function of a quantity is left in a statement."""
    functions = {f.func for f in quantity.atoms(AppliedUndef)}
    return any(f.func in functions for f in statement.atoms(AppliedUndef))


def _roots(statement, symbol, point, near, rng):
    """Values of `symbol` that may satisfy a statement: roots of an equation near and far, for others any beside."""
    plain = isinstance(statement, sp.Eq) and not isinstance(statement.lhs, sp.Tuple)
    if symbol not in statement.free_symbols or not plain:
        beside = (near + mpmath.mpf(1) / 3, 2 * near, near / 2, near - mpmath.mpf(1) / 3, -near)
        return list(beside)
    found = []
    for _ in range(STARTS):
        start = near * mpmath.mpf(rng.uniform(-3, 3)) + mpmath.mpf(rng.uniform(-1, 1))
        root = _newton(statement.lhs - statement.rhs, symbol, point, start)
        if root is not None:
            found.append(root)
    return found


def _newton(expr, symbol, point, start):
    def f(x):
        return numeric.value(expr, {**point, symbol: x}, 260)

    try:
        with mp.workdps(260):
            root = mp.findroot(f, start, tol=mp.mpf(10) ** -480, maxsteps=60, verify=False)
            good = mp.isfinite(root) and abs(mp.im(root)) == 0 and abs(f(root)) < mp.mpf(10) ** -200
            return mp.re(root) if good else None
    except (ValueError, ZeroDivisionError, TypeError, numeric.Untestable):
        return None


def _allowed(symbol, value, within):
    """Whether a value is one that the quantity can have: of its sign, and in its range in the notation."""
    if (symbol.is_positive and value <= 0) or (symbol.is_nonnegative and value < 0):
        return False
    return within is sp.S.Reals or float(within.start) < value < float(within.end)
