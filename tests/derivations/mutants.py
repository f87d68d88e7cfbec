"""Wrong versions of a true statement: what a derivation must not shrug off when it is given one as a premise."""

from __future__ import annotations

import sympy as sp
from sympy.core.relational import Relational

from galileo_sym.ledger import Kind, StrictlyDecreasing, StrictlyIncreasing, UniqueMaximum
from galileo_sym.ledger.check import counterexample, environment, judge, run
from galileo_sym.ledger.equivalence import equivalent
from galileo_sym.ledger.numeric import Untestable
from galileo_sym.ledger.predicates import Claim

_REVERSED = {
    sp.StrictGreaterThan: sp.StrictLessThan,
    sp.StrictLessThan: sp.StrictGreaterThan,
    sp.GreaterThan: sp.LessThan,
    sp.LessThan: sp.GreaterThan,
    StrictlyIncreasing: StrictlyDecreasing,
    StrictlyDecreasing: StrictlyIncreasing,
}


def wrong(statement):
    """The statement made false: equations doubled on the right, orders reversed, whatever else denied."""
    if isinstance(statement, sp.And):
        return sp.And(*(wrong(part) for part in statement.args), evaluate=False)
    if isinstance(statement, sp.Equivalent | sp.Implies):
        *conditions, last = statement.args
        return statement.func(*conditions, wrong(last), evaluate=False)
    if isinstance(statement, sp.Eq):
        return sp.Eq(statement.lhs, _doubled(statement.rhs), evaluate=False)
    if type(statement) in _REVERSED:
        other = _REVERSED[type(statement)]
        return other(*statement.args) if issubclass(other, Claim) else other(*statement.args, evaluate=False)
    return sp.Not(statement, evaluate=False)


def _doubled(side):
    if isinstance(side, sp.Tuple):
        return sp.Tuple(*map(_doubled, side))
    if side.is_infinite:
        return -side
    return sp.S.One if side == 0 else 2 * side


def sign_changed(statement):
    """The statement with signs changed: of right sides, of a term where 0 is on the right, of functions in claims.

    The statement itself comes back where there is no sign to change.
    """
    if isinstance(statement, sp.And):
        return sp.And(*(sign_changed(part) for part in statement.args), evaluate=False)
    if isinstance(statement, sp.Equivalent | sp.Implies):
        *conditions, last = statement.args
        return statement.func(*conditions, sign_changed(last), evaluate=False)
    if isinstance(statement, Relational):
        left, right = statement.args
        return statement.func(left if right != 0 else _first_term_negated(left), _negated(right), evaluate=False)
    if isinstance(statement, StrictlyIncreasing | StrictlyDecreasing | UniqueMaximum):
        return statement.func(-statement.args[0], *statement.args[1:])
    return statement


def _negated(side):
    return sp.Tuple(*map(_negated, side)) if isinstance(side, sp.Tuple) else -side


def _first_term_negated(side):
    first, *others = sp.Add.make_args(side)
    return sp.Add(-first, *others) if others else side


def scaled(statement, name):
    """The statement with a quantity doubled wherever it occurs."""
    symbol = next(a for a in statement.atoms(sp.Symbol) if a.name == name)
    return statement.xreplace({symbol: 2 * symbol})


def shifted(statement):
    """An equation between numbers with 1 added on the right."""
    return sp.Eq(statement.lhs, statement.rhs + 1, evaluate=False)


def opposite(statement):
    """An equation, or each of a conjunction, with the right side negated."""
    if isinstance(statement, sp.And):
        return sp.And(*map(opposite, statement.args), evaluate=False)
    return sp.Eq(statement.lhs, -statement.rhs, evaluate=False) if isinstance(statement, sp.Eq) else statement


def noticed(ledger, identifier: str, premise: str, mutant) -> bool:
    """Whether the derivation of an entry comes to nothing, or to something not proved, when one premise is wrong."""
    entry = ledger[identifier]
    truths = {i: ledger[i].result for i in entry.premises}
    domains = {i: ledger[i].declaration.domain for i in entry.premises}
    declaration = entry.declaration
    outcome = run(declaration, {**truths, premise: mutant})
    if outcome.problem or _false(outcome.result, entry, truths):
        return True
    if equivalent(outcome.result, declaration.printed) is None:
        return True
    return judge(declaration, outcome, truths, domains).kind is not Kind.PROVED


def _false(result, entry, truths):
    """Whether the result fails at a point, the symbols standing for what they truly do; limits take too long."""
    if result.has(sp.Limit):
        return False
    declaration = entry.declaration
    truth = environment(declaration, entry._outcome, truths)
    try:
        return counterexample(result, declaration.domain, truth, declaration.id) is not None
    except (Untestable, ZeroDivisionError, RecursionError):
        return False
