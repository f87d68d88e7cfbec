"""From a declaration to a verdict: derive, hold against the print, try in numbers, check dimensions and premises."""

from __future__ import annotations

import time
from dataclasses import dataclass

import sympy as sp
from sympy.core.function import AppliedUndef

from . import dimensions, numeric
from .derivation import Premise, recording
from .domain import REAL, Domain, EmptyDomain
from .environment import as_algebra, definitions, opaque, resolve
from .equivalence import equivalent
from .statement import Declaration, Erratum
from .verdict import Kind, Verdict

POINTS = 10  # beside the edge cases of every range


@dataclass(frozen=True)
class Outcome:
    """The result of running a derivation: the statement reached, and the way there."""

    result: sp.Basic | None
    steps: tuple = ()
    tactics: tuple = ()
    problem: str = ""
    seconds: float = 0.0


def run(declaration: Declaration, premises: dict) -> Outcome:
    """Run a derivation on its premises (statements by id)."""
    if declaration.function is None:
        return Outcome(declaration.printed)
    given = [Premise(i, premises[i]) for i in declaration.premises]
    start = time.perf_counter()
    with recording() as record:
        try:
            result = declaration.function(*given)
            problem = _defect(result, given)
        except Exception as error:  # any failure of SymPy or of a tactic is this entry's verdict, not a crash
            result, problem = None, f"{type(error).__name__}: {error}"
    return Outcome(result, tuple(record.steps), tuple(record.tactics), problem, time.perf_counter() - start)


def _defect(result, given):
    idle = [p.id for p in given if not p.used]
    if idle:
        return f"premises never used: {', '.join(idle)}"
    if not isinstance(result, sp.logic.boolalg.Boolean):
        return f"the derivation returned {type(result).__name__}, not a statement"
    return ""


def environment(declaration: Declaration, outcome: Outcome, premises: dict) -> dict:
    """What the symbols stand for: as the assumptions say, else the result, else a premise, else a step.

    The result comes before its premises, since t_AB (say) is another time where another force acts.
    """
    given = {}
    for statement in (*(s.statement for s in outcome.steps), *premises.values(), outcome.result):
        given.update(definitions(statement))
    given.update(declaration.domain.where)
    return {k: v for k, v in given.items() if k not in declaration.domain.ranges}


def judge(declaration: Declaration, outcome: Outcome, premises: dict, domains: dict | None = None) -> Verdict:
    """The verdict of an entry, its premises taken as true.

    Parameters
    ----------
    premises, domains : dict
        Derived statements of the premises, and their assumptions (none if not given), by id.
    """
    start = time.perf_counter()
    kind, method, example = _judge(declaration, outcome, premises, domains)
    return Verdict(kind, method, outcome.seconds + time.perf_counter() - start, example)


def _judge(declaration, outcome, premises, domains):
    if outcome.problem:
        return Kind.ERROR, outcome.problem, None
    given = environment(declaration, outcome, premises)
    try:
        supposed = declaration.domain.supposing
        for statement in (declaration.printed, outcome.result, *supposed, *(s.statement for s in outcome.steps)):
            dimensions.check(statement, declaration.notation.dimensions)
        told = {i: (premises[i], (domains or {}).get(i, Domain({}))) for i in declaration.premises}
        for identifier, hypothesis in _unsupposed(declaration, outcome, told):
            return Kind.ERROR, f"the premise {identifier} supposes more: {hypothesis}", None
        for hypothesis in supposed:
            failure = counterexample(hypothesis, declaration.domain, given, declaration.id)
            if failure is not None:
                return Kind.VACUOUS, f"what is supposed does not hold of what is put in: {hypothesis}", failure
        if declaration.function is None:
            return _given(declaration)
        for statement, name in _trials(declaration, outcome).items():
            failure = counterexample(statement, declaration.domain, given, declaration.id)
            if failure is not None:
                return Kind.REFUTED, f"{name} fails", failure
        for identifier, failure in _failing_premises(declaration, outcome, told, given):
            return Kind.REFUTED, f"the result does not agree with its premise {identifier}", failure
        how = equivalent(outcome.result, declaration.printed)
    except EmptyDomain as problem:
        return Kind.VACUOUS, str(problem), None
    except Exception as problem:  # whatever SymPy cannot do is this entry's verdict, not a crash
        return Kind.ERROR, f"{type(problem).__name__}: {problem}", None
    method = ", ".join((*outcome.tactics, f"as printed: {how}" if how else "equal in numbers only"))
    return (Kind.PROVED if how else Kind.CHECKED), method, None


def _trials(declaration, outcome):
    """The statements to be tried, each once, with the name it is first given."""
    named = {declaration.printed: "printed"}
    named.setdefault(outcome.result, "result")
    for step in outcome.steps:
        named.setdefault(step.statement, f"step '{step.text}'")
    return named


def _unsupposed(declaration, outcome, premises):
    """Hypotheses of the premises that an entry neither supposes itself nor says to be the condition of its result."""
    result = outcome.result
    conditions = result.args[0] if isinstance(result, sp.Implies) else sp.true
    said = {conditions, *(conditions.args if isinstance(conditions, sp.And) else ())}
    for identifier, (_, domain) in premises.items():
        for hypothesis in domain.supposing:
            if hypothesis not in said | set(declaration.domain.supposing):
                yield identifier, hypothesis


def _failing_premises(declaration, outcome, premises, given):
    """Premises that fail with what the result says, each with a point where their own assumptions hold.

    A result that solves its premises must satisfy them: t_AB put back into the arrival, s(t) into the law with its
    initial values. Premises named `elsewhere` speak of another motion.
    """
    solved = {k for k in definitions(outcome.result) if k not in declaration.domain.ranges}
    functions = {k.func for k in solved if isinstance(k, AppliedUndef)}
    known = {k: v for k, v in given.items() if not (isinstance(k, sp.Derivative) and k.expr.func in functions)}
    for identifier, (statement, domain) in premises.items():
        if statement == outcome.result:
            failure = _outside(declaration, domain)
            if failure is not None:
                yield f"{identifier}, which is the same statement but assumes more", failure
        parts = statement.args if isinstance(statement, sp.And) else (statement,)
        for part in parts if identifier not in declaration.elsewhere else ():
            ready = resolve(part, known, frozenset(declaration.domain.ranges))
            if _speaks_of(part, solved, functions) and not opaque(ready):
                failure = _counterexample_inside(part, declaration, domain, known)
                if failure is not None:
                    yield identifier, failure


def _outside(declaration, domain):
    """A point of the entry's assumptions where a premise's do not hold."""
    for point in declaration.domain.points(POINTS, declaration.id):
        if not inside(domain.inside, point):
            return _show(sp.true, point, {})
    return None


def _speaks_of(part, solved, functions):
    """Whether a premise says something of what the result says."""
    return part.has(*solved, *functions) if solved else False


def _counterexample_inside(statement, declaration, domain, given):
    """A point of both the entry's and the premise's assumptions where the premise fails; None if it has no value."""
    try:
        ready, ranges = ready_to_try(statement, declaration.domain, given)
        condition = resolve(domain.inside, given, frozenset(ranges))
        for point in Domain(ranges).points(POINTS, declaration.id):
            if inside(condition, point) and not numeric.holds(ready, point):
                return _show(statement, point, given)
    except numeric.Untestable:  # it speaks of something else, too, that has no value here
        return None
    return None


def inside(condition, point):
    """Whether a premise's assumptions hold at a point; those about variables that have no value here are left out."""
    for part in condition.args if isinstance(condition, sp.And) else (condition,):
        if part.free_symbols <= set(point) and not numeric.holds(part, point):
            return False
    return True


def _given(declaration):
    """A law or a definition stands as given; what it says of known functions alone must be true all the same.

    Known are those that its assumptions put something in for, too.
    """
    known, given = frozenset(declaration.domain.ranges), dict(declaration.domain.where)
    parts = declaration.printed.args if isinstance(declaration.printed, sp.And) else (declaration.printed,)
    for part in parts:
        ready = resolve(part, given, known)
        if ready.free_symbols <= known and not opaque(ready):
            failure = counterexample(part, declaration.domain, given, declaration.id)
            if failure is not None:
                return Kind.REFUTED, "what is given is false", failure
    declaration.domain.points(1, declaration.id)
    return Kind(declaration.item.kind), "given", None


def counterexample(statement, domain: Domain, given: dict, seed: str) -> dict | None:
    """A point inside the assumptions where a statement fails, or None if it holds at every point tried.

    Where it has no value at a point, it may still fail at another.
    """
    ready, ranges = ready_to_try(statement, domain, given)
    problem = None
    for point in Domain(ranges).points(POINTS, seed):
        try:
            if not numeric.holds(ready, point):
                return _show(statement, point, given)
        except numeric.Untestable as no_value:
            if problem is not None:
                raise
            problem = no_value
    if problem is not None:
        raise problem
    return None


def ready_to_try(statement, domain, given):
    """The statement in independent variables alone; unknown functions that are left become variables."""
    keep = frozenset(domain.ranges)
    ready = resolve(statement, given, keep)
    ready, unknown = as_algebra(ready)
    return ready, {**domain.ranges, **dict.fromkeys(unknown.values(), REAL)}


def _show(statement, point, given):
    shown = {str(s): digits(v) for s, v in point.items()}
    for symbol in sorted(statement.free_symbols - set(point), key=str):
        if symbol in given:
            try:
                shown[str(symbol)] = digits(numeric.value(resolve(symbol, given, frozenset(point)), point, 30))
            except (numeric.Untestable, ZeroDivisionError):
                shown[str(symbol)] = "undefined"
    return shown


def digits(number):
    return str(sp.N(sp.sympify(number), 12))


def refutation(erratum: Erratum, declaration: Declaration, given: dict) -> Verdict | None:
    """The verdict of a statement as printed: refuted, or the erratum is wrong."""
    if erratum.printed is None:
        return None
    start = time.perf_counter()
    domain = erratum.domain or declaration.domain
    try:
        found = counterexample(erratum.printed, domain, {**given, **domain.where}, f"{declaration.id} as printed")
    except EmptyDomain as problem:
        return Verdict(Kind.VACUOUS, str(problem), time.perf_counter() - start)
    kind, method = (Kind.REFUTED, "as printed") if found else (Kind.CHECKED, "as printed: no counterexample found")
    return Verdict(kind, method, time.perf_counter() - start, found)
