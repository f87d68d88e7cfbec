"""What a chapter declares: a printed statement, its assumptions, and how it is derived."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy.logic.boolalg import BooleanAtom

from .domain import Domain
from .inventory import Item, inventory
from .notation import Notation

NOT_PRINTED = ("stable", "beyond")  # first words of the ids that are in neither paper


@dataclass(frozen=True)
class Erratum:
    """Where the print is wrong, or lacks a condition.

    Attributes
    ----------
    ids : tuple of str
        Numbers in the list of errata, such as ("C1", "C2").
    text : str
        What must be corrected.
    printed : statement, or None
        The statement as printed, which is false somewhere in `domain`; None for wording and for missing data.
    domain : Domain, or None
        The assumptions as printed.
    """

    ids: tuple[str, ...]
    text: str
    printed: sp.Basic | None = None
    domain: Domain | None = None


@dataclass(frozen=True)
class Declaration:
    """One entry of a chapter, before anything is derived."""

    id: str
    item: Item
    notation: Notation
    printed: sp.Basic
    domain: Domain
    premises: tuple[str, ...] = ()
    function: Callable | None = None
    erratum: Erratum | None = None
    elsewhere: tuple[str, ...] = ()  # premises about another motion, whose symbols have other values there

    @property
    def doc(self) -> str:
        """The derivation's own words."""
        return inspect.getdoc(self.function) or "" if self.function else ""


class Chapter:
    """A section of a paper: its entries in order."""

    module: str | None = None  # the name of the module it was loaded from

    def __init__(self, name: str, notation: Notation, title: str):
        self.name = name
        self.notation = notation
        self.title = title
        self.declarations: dict[str, Declaration] = {}

    def given(self, identifier, statement, domain, *, premises=(), erratum=None):
        """Enter a law or a definition: a statement that is not derived."""
        item = self._item(identifier)
        if item.kind not in ("law", "definition"):
            raise ValueError(f"{identifier} is a {item.kind}: derive it (only laws and definitions are given)")
        return self._enter(
            Declaration(identifier, item, self.notation, statement, domain, tuple(premises), None, erratum)
        )

    def derive(self, identifier, printed, domain, *, premises=None, erratum=None, elsewhere=()):
        """Enter a statement with its derivation, a function of its premises.

        The names of the function's arguments are the premises' ids: ``eq19`` is chord.eq19 in the chord paper,
        ``claim__slides_iff`` is chord.claim.slides-iff, ``projectile__res3`` reaches into the other paper. Where one
        function serves several entries, `premises` names the ids instead, in the order of its arguments. Premises of
        `elsewhere` speak of another motion, so that their t_AB or s(t) is not this one's.
        """

        def enter(function):
            ids = premises or (self._premise_id(name) for name in inspect.signature(function).parameters)
            item = self._item(identifier)
            self._enter(
                Declaration(
                    identifier, item, self.notation, printed, domain, tuple(ids), function, erratum, tuple(elsewhere)
                )
            )
            return function

        return enter

    def _enter(self, declaration):
        if declaration.id in self.declarations:
            raise ValueError(f"{declaration.id} is declared twice in {self.name}")
        if isinstance(declaration.printed, BooleanAtom):
            raise ValueError(f"{declaration.id} says nothing: SymPy made it {declaration.printed}; use evaluate=False")
        self.declarations[declaration.id] = declaration
        return declaration.printed

    def _premise_id(self, name):
        identifier = name.replace("__", ".").replace("_", "-")
        first = identifier.split(".")[0]
        return identifier if first in ("chord", "projectile", *NOT_PRINTED) else f"{self.notation.paper}.{identifier}"

    def _item(self, identifier):
        known = inventory().get(identifier)
        if known is not None:
            return known
        kind = identifier.split(".")[0]
        if kind not in NOT_PRINTED:
            raise ValueError(f"{identifier} is not in the inventory of the papers: check the id")
        return Item(identifier, self.notation.paper, "not printed", self.title, kind, "", "", (), False)
