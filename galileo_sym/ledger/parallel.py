"""Verdicts in several processes: each loads the ledger itself and derives what its entries need."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context

WORTH_A_PROCESS = 8  # entries; below that a second process takes longer to start than it saves

_LEDGER = None  # of a worker process


def verdicts_of(ids: list[str], processes: int, ledger) -> Iterator[tuple]:
    """Pairs (id, verdict with the premises taken as true), in any order."""
    if processes == 1 or ledger.package is None or len(ids) < WORTH_A_PROCESS:
        yield from ((i, ledger[i].own_verdict) for i in ids)
        return
    start = {"mp_context": get_context("spawn"), "initializer": _load, "initargs": (ledger.package,)}
    with ProcessPoolExecutor(processes, **start) as pool:
        waiting = [pool.submit(_judge, chunk) for chunk in _chunks(ids)]
        try:
            for done in as_completed(waiting):
                yield from done.result()
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _chunks(ids, size=4):
    """Neighbours share their premises, so they go together."""
    return [ids[i : i + size] for i in range(0, len(ids), size)]


def _load(package):
    global _LEDGER  # noqa: PLW0603 (one ledger for the life of a worker)
    _LEDGER = importlib.import_module("galileo_sym.ledger").Ledger.load(package)


def _judge(ids):
    return [(i, _LEDGER[i].own_verdict) for i in ids]
