"""What is known about a statement, and how it was shown."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType


class Kind(Enum):
    """The possible verdicts (design, section 3)."""

    PROVED = "proved"  # symbolically, from the premises
    CERTIFIED = "certified"  # by rigorous interval arithmetic
    CHECKED = "checked"  # agreement in numbers alone: not a proof
    REFUTED = "refuted"  # false at a point inside the assumptions
    VACUOUS = "vacuous"  # the assumptions leave no point to try
    ERROR = "error"  # the derivation failed
    LAW = "law"  # a law of physics: not derived
    DEFINITION = "definition"  # a convention: not derived

    @property
    def sound(self) -> bool:
        """Whether a derivation may build on a statement with this verdict."""
        return self in _SOUND


_SOUND = frozenset({Kind.PROVED, Kind.CERTIFIED, Kind.LAW, Kind.DEFINITION})


@dataclass(frozen=True)
class Verdict:
    """The outcome of a derivation or a comparison.

    Attributes
    ----------
    kind : Kind
    method : str
        How it was shown, or why it failed.
    seconds : float
        Time taken.
    counterexample : mapping of str to str, or None
        Values of the variables at which a refuted statement fails.
    """

    kind: Kind
    method: str = ""
    seconds: float = 0.0
    counterexample: Mapping[str, str] | None = None

    def __post_init__(self):
        if self.counterexample is not None:
            object.__setattr__(self, "counterexample", MappingProxyType(dict(self.counterexample)))

    def __reduce__(self):
        """Pickle the counterexample as a plain dict: verdicts come back from worker processes."""
        return Verdict, (self.kind, self.method, self.seconds, self.counterexample and dict(self.counterexample))

    @property
    def holds(self) -> bool:
        """True for proved, certified, law and definition."""
        return self.kind.sound

    def __str__(self):
        where = ""
        if self.counterexample:
            where = " at " + ", ".join(f"{k} = {v}" for k, v in self.counterexample.items())
        return f"{self.kind.value}: {self.method}{where}" if self.method else f"{self.kind.value}{where}"
