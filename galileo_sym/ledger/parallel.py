"""Verdicts in several processes: each loads the ledger itself and derives what its entries need."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from itertools import pairwise
from multiprocessing import get_context

WORTH_A_PROCESS = 8  # entries; below that a second process takes longer to start than it saves
TOGETHER = 4  # entries handed out at a time

_LEDGER = None  # of a worker process


def verdicts_of(ids: list[str], processes: int, ledger) -> Iterator[tuple]:
    """Triples (id, verdict with the premises taken as true, verdict of the printed slip), in any order."""
    processes = min(processes, len(ids) // WORTH_A_PROCESS)
    if processes <= 1 or ledger.package is None:
        yield from (_findings(ledger[i]) for i in ids)
        return
    start = {"mp_context": get_context("spawn"), "initializer": _load, "initargs": (ledger.package,)}
    pools = [ProcessPoolExecutor(1, **start) for _ in range(processes)]
    shares = Shares(ids, processes)
    try:
        waiting = {}
        for owner, pool in enumerate(pools):
            waiting[pool.submit(_judge, shares.next(owner))] = owner
        while waiting:
            done, _ = wait(waiting, return_when=FIRST_COMPLETED)
            for future in done:
                owner = waiting.pop(future)
                yield from future.result()
                more = shares.next(owner)
                if more:
                    waiting[pools[owner].submit(_judge, more)] = owner
    finally:
        for pool in pools:
            pool.shutdown(wait=False, cancel_futures=True)


class Shares:
    """A run of neighbours for each process, as they share premises; who is done takes from the end of the longest."""

    def __init__(self, ids: list[str], owners: int):
        cuts = [round(n * len(ids) / owners) for n in range(owners + 1)]
        self._left = [ids[a:b] for a, b in pairwise(cuts)]

    def next(self, owner: int) -> list[str]:
        """What `owner` is to do next; nothing is left if it is empty."""
        own = self._left[owner]
        if own:
            self._left[owner] = own[TOGETHER:]
            return own[:TOGETHER]
        longest = max(range(len(self._left)), key=lambda n: len(self._left[n]))
        taken = self._left[longest][-TOGETHER:]
        self._left[longest] = self._left[longest][: -len(taken) or None]
        return taken


def _load(package):
    global _LEDGER  # noqa: PLW0603 (one ledger for the life of a worker)
    _LEDGER = importlib.import_module("galileo_sym.ledger").Ledger.load(package)


def _judge(ids):
    return [_findings(_LEDGER[i]) for i in ids]


def _findings(entry):
    return entry.id, entry.own_verdict, entry.erratum_verdict
