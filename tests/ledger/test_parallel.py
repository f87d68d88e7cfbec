"""How entries are shared out among processes, and that it does not matter to the verdicts."""

import pytest

from galileo_sym.ledger import Ledger
from galileo_sym.ledger.parallel import TOGETHER, Shares


@pytest.mark.parametrize(("count", "owners"), [(0, 1), (1, 2), (37, 1), (37, 2), (37, 5), (3, 8)])
@pytest.mark.parametrize("greedy", [False, True])
def test_every_entry_is_handed_out_once(count, owners, greedy):
    ids = [f"entry {n}" for n in range(count)]
    shares = Shares(ids, owners)
    given, turn = [], 0
    while True:
        taken = shares.next(0 if greedy else turn % owners)
        if not taken:
            break
        assert len(taken) <= TOGETHER
        given += taken
        turn += 1
    assert sorted(given) == sorted(ids)
    assert not any(shares.next(owner) for owner in range(owners))


def test_a_process_begins_with_its_own_run_of_neighbours():
    shares = Shares([str(n) for n in range(20)], 2)
    assert shares.next(0)[0] == "0"
    assert shares.next(1)[0] == "10"
    assert shares.next(1)[0] == "14"


@pytest.mark.xdist_group("two processes")
def test_two_processes_give_the_verdicts_of_one(ledger):
    other = Ledger.load()
    chosen = other.select(["chord.galileo"])
    other.judge(chosen, 2)
    for entry in chosen:
        assert (entry.verdict.kind, entry.verdict.method) == (
            ledger[entry.id].verdict.kind,
            ledger[entry.id].verdict.method,
        )
