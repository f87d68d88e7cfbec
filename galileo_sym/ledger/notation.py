"""The symbols of a paper: each with its assumptions, its physical dimension and its meaning."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

MASS, LENGTH, TIME = sp.symbols("mass length time", positive=True)
ONE = sp.S.One


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

    def symbol(self, name: str, dimension, meaning: str, **assumptions) -> sp.Symbol:
        """Declare a symbol, e.g. ``symbol("g", LENGTH / TIME**2, "gravity", positive=True)``."""
        self._claim(name)
        made = sp.Symbol(name, **(assumptions or {"real": True}))
        self.symbols[name] = made
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

    def _claim(self, name):
        if name in self.symbols or name in self.functions:
            raise ValueError(f"the name {name!r} is taken in the notation of {self.paper}: choose another")

    def adopt(self, statement):
        """Read a statement of a user's in this notation: parse text, and take symbols by name.

        Parameters
        ----------
        statement : sympy Boolean, or str
            For example ``Eq(x, t*v)`` or its text.
        """
        names = {**self.symbols, **self.functions, "W": sp.LambertW}
        if isinstance(statement, str):
            statement = sp.sympify(statement, locals=names)
        statement = sp.sympify(statement)
        foreign = {s: self.symbols[s.name] for s in statement.atoms(sp.Symbol) if self._differs(s)}
        statement = statement.xreplace(foreign)
        for applied in statement.atoms(sp.core.function.AppliedUndef):
            ours = self.functions.get(applied.func.__name__)
            if ours is not None and ours != applied.func:
                statement = statement.replace(applied.func, ours)
        return statement

    def _differs(self, symbol):
        return symbol.name in self.symbols and self.symbols[symbol.name] != symbol
