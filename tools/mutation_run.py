"""Mutation tests of every entry: mutants of its statement and of its premises. Exits with 1 if any survives.

Without names all entries are tried, and the committed result is renewed; names of entries or chapters try those alone
and write nothing. `--missing` tries the entries that the committed result lacks, and adds them to it; it remains that
of the sources of the last whole run. `--stale` tries nothing and says whether it is that of the present ones.
"""

import argparse
import json
import os
import sys
import time
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "tests" / "derivations"), str(ROOT / "tools")]

from mutation import try_premises, try_statements  # noqa: E402 (it stands with the tests)
from mutation_report import joined, page, result_of, sources, surviving, told  # noqa: E402

from galileo_sym.ledger import Ledger  # noqa: E402

RESULT = ROOT / "tests" / "derivations" / "mutation_result.json"
PAGE = ROOT / "docs" / "mutation.md"
RUN = 4  # neighbours tried in one go, since they share premises

_LEDGER = None  # of a worker process


def start_worker():
    """Read the ledger once for the life of a worker."""
    global _LEDGER  # noqa: PLW0603
    _LEDGER = Ledger.load()


def try_entries(ids):
    """All trials of some entries, as plain data."""
    trials = [t for i in ids for t in (*try_statements(_LEDGER, i), *try_premises(_LEDGER, i))]
    return [t.as_dict() for t in trials]


def run(ids, processes):
    """The trials of all entries, in the ledger's order, with a line of progress."""
    found, begin = {}, time.monotonic()
    shares = [ids[i : i + RUN] for i in range(0, len(ids), RUN)]
    start = {"mp_context": get_context("spawn"), "initializer": start_worker}
    with ProcessPoolExecutor(processes, **start) as pool:
        waiting = {pool.submit(try_entries, share): n for n, share in enumerate(shares)}
        for done, future in enumerate(as_completed(waiting), 1):
            found[waiting[future]] = future.result()
            tell_progress(done, len(shares), found.values(), begin)
    return [t for n in sorted(found) for t in found[n]], clock(begin)


def tell_progress(done, total, found, begin):
    """Renew the line of progress on a terminal; elsewhere say a line now and then."""
    trials = [t for share in found for t in share]
    left = sum(t["outcome"] == "surviving" for t in trials)
    line = f"{100 * done // total:3d} %  {len(trials)} mutants, {left} surviving, {clock(begin)}"
    if sys.stderr.isatty():
        print(f"\r{line}", end="\n" if done == total else "", file=sys.stderr, flush=True)
    elif done % 10 == 0 or done == total:
        print(line, file=sys.stderr, flush=True)


def clock(begin):
    """Minutes and seconds since."""
    minutes, seconds = divmod(int(time.monotonic() - begin), 60)
    return f"{minutes}:{seconds:02d}"


def main(arguments=None) -> int:
    """Try, tell, write; the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="entries or chapters; all if none is given")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--stale", action="store_true", help="only say whether the committed result is up to date")
    parser.add_argument("--missing", action="store_true", help="only the entries that the committed result lacks")
    chosen = parser.parse_args(arguments)
    if chosen.missing and chosen.names:
        parser.error("--missing takes no names")
    committed = json.loads(RESULT.read_text(encoding="utf-8"))
    if chosen.stale:
        stale = committed["sources"] != sources()
        print("the committed mutation result is of other sources: run `make mutants`" if stale else "up to date")
        return int(stale)
    before = sources()
    ids = [e.id for e in Ledger.load().select(chosen.names)]
    if chosen.missing:
        everything, ids = ids, [i for i in ids if i not in committed["entries"]]
    trials, wall = run(ids, chosen.processes)
    result = {**result_of(trials, ids, wall, chosen.processes), "sources": before}
    print(told(result))
    if chosen.missing:
        result = joined(committed, result, everything)
    if not chosen.names:
        RESULT.write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        PAGE.write_text(page(result), encoding="utf-8")
    return int(surviving(result) > 0)


if __name__ == "__main__":
    sys.exit(main())
