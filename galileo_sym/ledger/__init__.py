"""The ledger: what is known, and how it was shown."""

from .analysis import Continuous, PowerSeries
from .book import Entry, Ledger, UnknownEntry
from .derivation import DerivationError, Premise, Step, step, tactic
from .domain import NONNEGATIVE, POSITIVE, REAL, Domain
from .notation import LENGTH, MASS, ONE, TIME, Notation
from .predicates import ExactlyOneRoot, Independent, StrictlyDecreasing, StrictlyIncreasing, TracesOnce, UniqueMaximum
from .quantified import ForAll
from .statement import Chapter, Erratum
from .tell import tell, tell_chain, tell_chapter
from .verdict import Kind, Verdict

__all__ = [
    "LENGTH", "MASS", "NONNEGATIVE", "ONE", "POSITIVE", "REAL", "TIME",
    "Chapter", "Continuous", "DerivationError", "Domain", "Entry", "Erratum", "ExactlyOneRoot", "ForAll", "Independent",
    "Kind", "Ledger", "Notation", "PowerSeries", "Premise", "Step", "StrictlyDecreasing", "StrictlyIncreasing",
    "TracesOnce", "UniqueMaximum", "UnknownEntry", "Verdict", "step", "tactic", "tell", "tell_chain", "tell_chapter",
]  # fmt: skip
