"""The stable forms: proved equal to the printed ones, and to their limits where the drag vanishes."""

import pytest
import sympy as sp

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.ledger import Kind, Ledger, tell

pytestmark = pytest.mark.xdist_group("projectile")

STABLE = [e.id for e in Ledger.load().select(["stable"])]


@pytest.mark.parametrize("identifier", STABLE)
def test_entry_is_proved(ledger, identifier):
    entry = ledger[identifier]
    assert entry.verdict.kind is Kind.PROVED, tell(entry)


@pytest.mark.parametrize("name", [n for n in FUNCTIONS if n.startswith("chord.")])
def test_every_emitted_variant_has_a_twin(name):
    for forces in FUNCTIONS[name].variants:
        assert FUNCTIONS[name].ledger_id(forces) in STABLE


@pytest.mark.parametrize("identifier", [i for i in STABLE if i.startswith("stable.chord.") and "drag" in i])
def test_a_twin_with_drag_has_its_limit(identifier):
    assert identifier.endswith(".at-zero") or f"{identifier}.at-zero" in STABLE


@pytest.mark.parametrize("identifier", [i for i in STABLE if i.endswith(".at-zero")])
def test_the_limit_is_one_of_value_and_of_slope(ledger, identifier):
    printed = ledger[identifier].printed
    inner = [limit.args[0] for limit in printed.atoms(sp.Limit)]
    assert len(inner) == 2
    assert sum(isinstance(e, sp.Derivative) for e in inner) == 1
    assert all(limit.args[2] == 0 for limit in printed.atoms(sp.Limit))
