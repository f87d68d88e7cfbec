"""The symbols of a paper: each with its assumptions, its physical dimension and its meaning."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean

from .predicates import ExactlyOneRoot, Independent, StrictlyDecreasing, StrictlyIncreasing, UniqueMaximum

MASS, LENGTH, TIME = sp.symbols("mass length time", positive=True)
ONE = sp.S.One

CLAIMS = {c.__name__: c for c in (ExactlyOneRoot, Independent, StrictlyDecreasing, StrictlyIncreasing, UniqueMaximum)}


def _parse(text, names):
    try:
        return sp.sympify(text, locals=names)
    except (sp.SympifyError, TypeError, AttributeError) as problem:
        raise ValueError(f"cannot read {text!r} as a statement: {problem}") from None


@dataclass
class Notation:
    """The vocabulary of one paper.

    Symbols are looked up by name when a statement comes from outside, so a name means one thing in a paper.
    """

    paper: str
    symbols: dict[str, sp.Symbol] = field(default_factory=dict)
    functions: dict[str, type] = field(default_factory=dict)
    dimensions: dict[object, sp.Expr] = field(default_factory=dict)
    meanings: dict[str, str] = field(default_factory=dict)
    ranges: dict[sp.Symbol, sp.Interval] = field(default_factory=dict)

    def symbol(self, name: str, dimension, meaning: str, inside=None, **assumptions) -> sp.Symbol:
        """Declare a symbol, e.g. ``symbol("g", LENGTH / TIME**2, "gravity", positive=True)``.

        `inside` is the open interval of its values, if the sign is not all that is known of it.
        """
        self._claim(name)
        made = sp.Symbol(name, **(assumptions or {"real": True}))
        self.symbols[name] = made
        if inside is not None:
            self.ranges[made] = inside
        self.dimensions[made] = sp.sympify(dimension)
        self.meanings[name] = meaning
        return made

    def function(self, name: str, dimension, meaning: str, **assumptions):
        """Declare an unknown real function, e.g. the distance ``s`` in ``s(t)``."""
        self._claim(name)
        made = sp.Function(name, **(assumptions or {"real": True}))
        self.functions[name] = made
        self.dimensions[made] = sp.sympify(dimension)
        self.meanings[name] = meaning
        return made

    def extended(self) -> Notation:
        """A notation of its own with all of this vocabulary, to which more can be added."""
        tables = (self.symbols, self.functions, self.dimensions, self.meanings, self.ranges)
        return Notation(self.paper, *(dict(table) for table in tables))

    def _claim(self, name):
        if name in self.symbols or name in self.functions:
            raise ValueError(f"the name {name!r} is taken in the notation of {self.paper}: choose another")

    def adopt(self, statement, like=sp.true):
        """Read a statement of a user's in this notation: parse text, and take symbols by name.

        Parameters
        ----------
        statement : sympy Boolean, or str
            For example ``Eq(x, t*v)`` or its text.
        like : sympy Boolean
            A statement of ours; where it has f(t) once, a bare symbol f of the user's is read as that.

        Raises
        ------
        ValueError, TypeError
            The text cannot be read, or it is no statement.
        """
        applied = {}
        for f in like.atoms(AppliedUndef):
            applied.setdefault(f.func.__name__, set()).add(f)
        bare = {name for name in applied if name not in self.symbols}
        if isinstance(statement, str):
            called = {n: f for n, f in self.functions.items() if re.search(rf"\b{n}\s*\(", statement)}
            names = {**self.symbols, **{n: sp.Symbol(n) for n in bare}, **called, "W": sp.LambertW}
            statement = _parse(statement, {**CLAIMS, **names})
        if not isinstance(statement, bool | Boolean):
            raise TypeError(f"not a statement: {statement!r}; give an equation, an inequality or a claim, or its text")
        statement = sp.sympify(statement)
        table = {s: self.symbols[s.name] for s in statement.atoms(sp.Symbol) if self._differs(s)}
        for symbol in statement.atoms(sp.Symbol):
            if symbol.name in bare and len(applied[symbol.name]) == 1:
                table[symbol] = next(iter(applied[symbol.name]))
        statement = statement.xreplace(table)
        for theirs in statement.atoms(AppliedUndef):
            ours = self.functions.get(theirs.func.__name__)
            if ours is not None and ours != theirs.func:
                statement = statement.replace(theirs.func, ours)
        return statement

    def _differs(self, symbol):
        return symbol.name in self.symbols and self.symbols[symbol.name] != symbol
