"""Verdicts on entries: kept ones where the content is unchanged, new ones in as many processes as there are cores."""

from __future__ import annotations

import os

from galileo_sym.kept import index_key
from galileo_sym.ledger import Entry, Kind, Ledger, Verdict
from galileo_sym.ledger.fingerprint import fingerprints
from galileo_sym.rows import as_row
from galileo_sym.sources import everything
from galileo_sym.store import Store

WORKERS = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def judged(names: list[str], store: Store, *, fresh: bool = False, progress=None) -> tuple[Ledger, list[Entry]]:
    """The ledger, and the entries named, with verdicts on these and on all that they are derived from.

    Parameters
    ----------
    names : list of str
        Ids and chapters; all entries for none.
    store : Store
        Where verdicts are looked up by content, and kept.
    fresh : bool
        Derive all anew.
    progress : callable, optional
        Called with (done, total, id) as verdicts come in.
    """
    sources = everything()
    ledger = Ledger.load()
    entries = ledger.select(names)
    needed = ledger.with_premises(entries)
    prints = fingerprints(ledger) if ledger.package else {}
    known = {} if fresh else store.get(prints[e.id] for e in needed if e.id in prints)
    for entry in needed:
        if prints.get(entry.id) in known:
            _recall(entry, known[prints[entry.id]])
    ledger.judge(needed, WORKERS, progress)
    rows = {prints[e.id]: as_row(e) for e in needed if e.id in prints and prints[e.id] not in known}
    lasting = {key: row for key, row in rows.items() if row["verdict"] != Kind.ERROR.value}
    if prints and everything() == sources:  # sources that changed meanwhile may have been read in part
        chapters = {e.id: e.chapter.name for e in ledger.values()}
        store.put({**lasting, index_key(sources): {"chapters": chapters, "fingerprints": prints}})
    return ledger, entries


def _recall(entry, row):
    erratum = row.get("erratum")
    printed = None
    if erratum and erratum["printed"]:
        printed = Verdict(Kind(erratum["printed"]), erratum["method"], 0.0, erratum["counterexample"])
    entry.recall(Verdict(Kind(row["verdict"]), row["method"], row["seconds"], row["counterexample"]), printed)
