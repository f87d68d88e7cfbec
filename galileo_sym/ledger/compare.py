"""Hold any statement against a derived one: equivalence under the entry's assumptions."""

from __future__ import annotations

import operator
import time
from dataclasses import replace

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import BooleanAtom

from .cases import case_by_case, for_multiples
from .check import counterexample
from .domain import POSITIVE, REAL, EmptyDomain
from .environment import definitions, equations, resolve
from .equivalence import equivalent, is_zero
from .moves import moved_apart
from .parts import part_by_part
from .sides import where_a_side_holds
from .unwrap import unwrapped
from .verdict import Kind, Verdict


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
    known = {**_initial_values(derived), **given}
    try:
        declaration = _with_free_symbols(declaration, derived, known)
        fresh = _beside(derived, other)
        failure = None if fresh == sp.true else counterexample(fresh, declaration.domain, known, declaration.id)
        if failure is not None:
            return Kind.REFUTED, "the derived statement holds here, the other does not", failure
        how = _shown_equal(derived, other, declaration, known, own)
        if how:
            return Kind.PROVED, how, None
        failure = moved_apart(other, derived, declaration, known)
        if failure is not None:
            return Kind.REFUTED, "the other statement holds here, the derived one does not", failure
        failure = where_a_side_holds(fresh, derived, declaration, known)
        if failure is not None:
            return Kind.REFUTED, "the derived statement holds here, one side only of the other's equivalence", failure
        return part_by_part(derived, other, declaration, known) or (Kind.CHECKED, "equal in numbers only", None)
    except EmptyDomain as problem:
        return Kind.VACUOUS, str(problem), None
    except Exception as problem:  # what SymPy cannot do with a user's statement is said, not raised
        return Kind.ERROR, f"cannot be compared: {problem}", None


def _beside(derived, other):
    """What a statement says beside the parts that the derived one has, too, and that hold where it does."""
    if not isinstance(derived, sp.And):
        return other
    parts = [p for p in (other.args if isinstance(other, sp.And) else (other,)) if p not in derived.args]
    return sp.And(*parts, evaluate=False) if len(parts) > 1 else parts[0] if parts else sp.true


def _initial_values(derived):
    """What a statement says of f(0) and f'(0)."""
    kinds = AppliedUndef | sp.Subs
    return {a: b for a, b in equations(derived) if isinstance(a, kinds) and not sp.sympify(b).has(a)}


def _with_free_symbols(declaration, derived, known):
    """The declaration with every symbol of a definition that nothing gives a value, among the variables."""
    domain = declaration.domain
    loose = resolve(derived, known, frozenset(domain.ranges)).free_symbols - set(domain.ranges)
    free = {s: POSITIVE if s.is_positive else REAL for s in sorted(loose, key=str)}
    return replace(declaration, domain=replace(domain, ranges={**domain.ranges, **free})) if free else declaration


def _shown_equal(derived, other, declaration, known, own):
    domain = declaration.domain
    how = for_multiples(derived, other, domain, known, same=operator.eq)  # at once, where the rest takes long
    how = how or _solved(derived, other, declaration) or equivalent(derived, other)
    how = how or _with_definitions(derived, other, domain, known, own)
    return how or case_by_case(derived, other, domain) or for_multiples(derived, other, domain, known)


def _solved(derived, other, declaration):
    """Equivalence once both are solved for a quantity that stands in a one-to-one function, such as its square."""
    ranges, independent = declaration.notation.ranges, declaration.domain.ranges
    pair = [unwrapped(e, derived, ranges, independent) for e in (derived, other)]
    how = equivalent(*pair) if pair != [derived, other] else None
    return how and f"solved, {how}"


def _with_definitions(derived, other, domain, known, own):
    """Equivalence once both are written with the same quantities: s(t) in one, its formula in the other.

    What both speak of stays, unless it is another name: with it put in, any two true statements become 0 = 0.
    """
    theirs = {k: v for k, v in known.items() if k not in own}
    put = {k: v for k, v in theirs.items() if derived.has(k) != other.has(k)}
    keep = frozenset(domain.ranges)
    pair = [resolve(e, {**put, **_other_names(theirs)}, keep) for e in (derived, other)]
    return None if any(map(_says_nothing, pair)) else equivalent(*pair)


def _other_names(known):
    """Symbols that stand for the same as f(t) does: u for U(k, theta)."""
    functions = {v: f for f, v in known.items() if isinstance(f, AppliedUndef)}
    return {k: functions[v] for k, v in known.items() if isinstance(k, sp.Symbol) and v in functions}


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
