"""The ledger: every entry of every chapter, derived when it is asked for."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator, Mapping
from functools import cached_property
from graphlib import CycleError, TopologicalSorter

from galileo_sym.names import UnknownEntry, choose

from .check import environment, judge, refutation, run
from .compare import compare
from .parallel import verdicts_of
from .statement import Chapter, Declaration
from .verdict import Kind, Verdict


class Entry:
    """One statement of a paper, with what is known about it. Everything is derived on first access."""

    def __init__(self, declaration: Declaration, ledger: Ledger, chapter: Chapter):
        self.declaration = declaration
        self.chapter = chapter
        self._ledger = ledger

    def __repr__(self):
        return f"<Entry {self.id}>"

    @property
    def id(self) -> str:
        return self.declaration.id

    @property
    def paper(self) -> str:
        return self.declaration.item.paper

    @property
    def kind(self) -> str:
        """What the paper makes of it: law, definition, equation, claim, lemma, theorem, limit; or stable, beyond."""
        return self.declaration.item.kind

    @property
    def label(self) -> str:
        """Where it is printed."""
        return self.declaration.item.label

    @property
    def doc(self) -> str:
        """How it is derived, in words."""
        return self.declaration.doc

    @property
    def printed(self):
        """The statement, transcribed from the paper (corrected, if there is an erratum)."""
        return self.declaration.printed

    @property
    def assumptions(self):
        """The conditions under which it holds, as one SymPy Boolean."""
        return self.declaration.domain.condition

    @property
    def premises(self) -> tuple[str, ...]:
        """Ids of the statements it is derived from."""
        return self.declaration.premises

    @cached_property
    def _outcome(self):
        return run(self.declaration, {i: self._ledger[i].result for i in self.premises})

    @property
    def result(self):
        """The derived statement; None if the derivation failed (the verdict says why)."""
        return self._outcome.result

    @property
    def steps(self) -> tuple:
        """The steps of the derivation, each with `.text` and `.statement`."""
        return self._outcome.steps

    @cached_property
    def _environment(self):
        return environment(self.declaration, self._outcome, {i: self._ledger[i].result for i in self.premises})

    @cached_property
    def own_verdict(self) -> Verdict:
        """The verdict with the premises taken as true."""
        below = {i: self._ledger[i] for i in self.premises}
        premises = {i: e.result for i, e in below.items()}
        return judge(self.declaration, self._outcome, premises, {i: e.declaration.domain for i, e in below.items()})

    @cached_property
    def verdict(self) -> Verdict:
        """proved, certified, checked, refuted, vacuous, error, law or definition."""
        verdicts = {i: self._ledger[i].verdict for i in self.premises}
        shaky = [f"{i} is {v.kind.value}" for i, v in verdicts.items() if not v.kind.sound]
        return Verdict(Kind.ERROR, "; ".join(shaky), self.own_verdict.seconds) if shaky else self.own_verdict

    @property
    def erratum(self):
        """Where the print is wrong (`ids`, `text`, `printed`), or None."""
        return self.declaration.erratum

    @cached_property
    def erratum_verdict(self) -> Verdict | None:
        """The verdict of the statement as printed: refuted. None where nothing printed is false."""
        return self.erratum and refutation(self.erratum, self.declaration, self._environment)

    def recall(self, own: Verdict, printed: Verdict | None) -> None:
        """Take over what was found elsewhere: the verdict on the entry, and that on the printed slip."""
        vars(self).update(own_verdict=own, erratum_verdict=printed)

    def compare(self, statement) -> Verdict:
        """Hold another statement against the derived one, as equivalence under the assumptions.

        Parameters
        ----------
        statement : sympy Boolean, or str
            Symbols are matched by name.

        Returns
        -------
        Verdict
            proved; refuted, with a counterexample; or checked, if neither a difference nor a proof was found.
        """
        if self.result is None:
            return Verdict(Kind.ERROR, f"{self.id} has no derived statement: {self.verdict.method}")
        return compare(statement, self.result, self.declaration, self._environment)


class Ledger(Mapping):
    """All entries by id, in the order of the chapters. `Ledger.load()` reads the chapters and derives nothing."""

    package: str | None = None  # where it was loaded from, for worker processes to do the same

    def __init__(self, chapters: list[Chapter]):
        self.chapters = {c.name: c for c in chapters}
        self._entries = {i: Entry(d, self, c) for c in chapters for i, d in c.declarations.items()}
        total = sum(len(c.declarations) for c in chapters)
        if len(self._entries) != total:
            raise ValueError("an id is declared in two chapters")
        self._check_premises()

    def _check_premises(self):
        for entry in self._entries.values():
            missing = [p for p in entry.premises if p not in self._entries]
            if missing:
                raise ValueError(f"{entry.id} builds on {', '.join(missing)}, which no chapter declares")
        try:
            self._order = tuple(TopologicalSorter({i: e.premises for i, e in self._entries.items()}).static_order())
        except CycleError as problem:
            raise ValueError(f"derived from itself: {' <- '.join(problem.args[1])}") from None

    @classmethod
    def load(cls, package: str = "galileo_sym.derivations") -> Ledger:
        """Read every chapter below a package."""
        made = cls(_chapters(package))
        made.package = package
        return made

    def __getitem__(self, identifier: str) -> Entry:
        try:
            return self._entries[identifier]
        except KeyError:
            raise UnknownEntry(identifier, [*self._entries, *self.chapters]) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)

    def select(self, names: list[str]) -> list[Entry]:
        """Entries by id or by chapter (``chord.galileo``, or ``chord`` for all of that paper's); all for no names."""
        return [self._entries[i] for i in choose(names, {i: e.chapter.name for i, e in self._entries.items()})]

    def judge(self, entries: list[Entry], processes: int = 1, progress=None) -> None:
        """Bring about the verdicts of some entries, and of all they are derived from.

        Parameters
        ----------
        processes : int
            Entries are independent once their premises are taken as true, so they can be tried in parallel.
        progress : callable, optional
            Called with (done, total, id) as verdicts come in.
        """
        todo = [e for e in self.with_premises(entries) if "own_verdict" not in vars(e)]
        for done, (identifier, *verdicts) in enumerate(verdicts_of([e.id for e in todo], processes, self), 1):
            self[identifier].recall(*verdicts)
            if progress:
                progress(done, len(todo), identifier)

    def in_order(self) -> list[Entry]:
        """All entries, each after its premises."""
        return [self._entries[i] for i in self._order]

    def with_premises(self, entries: list[Entry]) -> list[Entry]:
        """Some entries, and all that they stand on."""
        found: dict[str, Entry] = {}
        waiting = list(entries)
        while waiting:
            entry = waiting.pop()
            if entry.id not in found:
                found[entry.id] = entry
                waiting += [self[i] for i in entry.premises]
        return [e for e in self._entries.values() if e.id in found]


def _chapters(package):
    root = importlib.import_module(package)
    found = []
    for module in pkgutil.walk_packages(root.__path__, package + "."):
        chapter = getattr(importlib.import_module(module.name), "chapter", None)
        if isinstance(chapter, Chapter):
            chapter.module = module.name
            found.append(chapter)
    return found
