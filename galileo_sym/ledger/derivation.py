"""While a derivation runs: the premises it is given, the steps it tells, the tactics it calls."""

from __future__ import annotations

import functools
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field

import sympy as sp
from sympy.logic.boolalg import Boolean

from .environment import equations


class DerivationError(ValueError):
    """A derivation cannot be carried through; the message says why."""


@dataclass(frozen=True)
class Step:
    """One line of a derivation: what was done, and the statement reached."""

    text: str
    statement: sp.Basic


@dataclass
class Record:
    """What a running derivation leaves behind."""

    steps: list[Step] = field(default_factory=list)
    tactics: list[str] = field(default_factory=list)


_RUNNING: ContextVar[Record | None] = ContextVar("running", default=None)


@contextmanager
def recording():
    """Collect the steps and tactics of the derivation run inside."""
    record = Record()
    token = _RUNNING.set(record)
    try:
        yield record
    finally:
        _RUNNING.reset(token)


def step(text: str, statement):
    """Tell a step of a derivation; the statement is checked with the others, and returned."""
    record = _RUNNING.get()
    if not isinstance(statement, Boolean):
        raise DerivationError(f"the step {text!r} is not a statement but {type(statement).__name__}: {statement}")
    if record is not None:
        record.steps.append(Step(text, statement))
    return statement


def tactic(function):
    """Mark a function as a tactic: its name enters the method of the verdict."""

    @functools.wraps(function)
    def named(*args, **kwargs):
        record = _RUNNING.get()
        name = function.__name__.replace("_", " ")
        if record is not None and name not in record.tactics:
            record.tactics.append(name)
        return function(*args, **kwargs)

    return named


class Premise:
    """A statement that a derivation builds on. Reading it is noted: a premise that is never read is an error."""

    def __init__(self, identifier: str, statement):
        self.id = identifier
        self._statement = statement
        self.used = False

    @property
    def statement(self):
        """The whole statement."""
        self.used = True
        return self._statement

    @property
    def lhs(self):
        """Left side of an equation."""
        return self.equation.lhs

    @property
    def rhs(self):
        """Right side of an equation."""
        return self.equation.rhs

    @property
    def equation(self):
        """The statement, which must be one equation."""
        if not isinstance(self.statement, sp.Eq):
            raise DerivationError(f"{self.id} is not an equation: {self._statement}")
        return self._statement

    @property
    def parts(self):
        """The parts of a conjunction."""
        return self.statement.args if isinstance(self._statement, sp.And) else (self.statement,)

    def subs(self, *args, **kwargs):
        """The statement with something put in."""
        return self.statement.subs(*args, **kwargs)

    def of(self, symbol):
        """What the statement says `symbol`, f(t) or f(0) is; parts of a conjunction and tuples are searched."""
        found = {a: b for a, b in equations(self.statement) if not sp.sympify(b).has(a)}
        if symbol not in found:
            raise DerivationError(f"{self.id} does not say what {symbol} is: {self._statement}")
        return found[symbol]
