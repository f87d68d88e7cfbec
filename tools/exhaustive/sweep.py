"""All inputs of a primitive in blocks, over the processes there are, resumed where an earlier run stopped."""

import json
import time
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context

from exhaustive import certain, libraries
from galileo_sym.files import write_whole

ALL = 1 << 32
BLOCK = 1 << 24


def block_result(name, tested, reference, first, count):
    """Judge one block, and settle by Arb what the reference leaves open.

    Returns
    -------
    dict
        Counts ``right``, ``refused``, ``by_arb``; lists of input bits ``hard`` (settled by Arb), ``wrong``,
        ``unsettled``, ``differing`` with the whole ``counts`` of these three; ``nearest`` and its input; ``seconds``.
    """
    begin = time.perf_counter()
    found = libraries.judged(name, tested, reference, first, count)
    wrong, hard, unsettled = found.inputs("wrong"), [], []
    for bits in found.inputs("undecided"):
        try:
            x, y = certain.of_bits(bits), certain.of_bits(libraries.value_of(name, tested, bits))
            (hard if certain.is_nearest(name, x, y) else wrong).append(bits)
        except certain.Unsettled:
            unsettled.append(bits)
    over = found.undecided - len(found.inputs("undecided"))  # too many to settle
    return {
        "right": found.right,
        "refused": found.refused,
        "hard": hard,
        "wrong": wrong,
        "unsettled": unsettled,
        "differing": found.inputs("differing"),
        "counts": {
            "wrong": found.wrong + len(wrong) - len(found.inputs("wrong")),
            "unsettled": len(unsettled) + over,
            "differing": found.differing,
        },
        "nearest": [found.nearest, found.nearest_input],
        "seconds": time.perf_counter() - begin,
    }


class State:
    """Blocks that are done, in a file that is replaced whole; what is of other sources is dropped."""

    def __init__(self, path, key):
        self.path, self.key, self.blocks = path, key, {}
        if path and path.exists():
            kept = json.loads(path.read_text(encoding="utf-8"))
            if kept["key"] == key:
                self.blocks = {int(first): result for first, result in kept["blocks"].items()}

    def add(self, first, result):
        """Add a block and write the file."""
        self.blocks[first] = result
        if self.path:
            write_whole(self.path, json.dumps({"key": self.key, "blocks": self.blocks}).encode())


def total(name, blocks):
    """Add up the results of blocks."""
    kinds = ("wrong", "unsettled", "differing")
    return {
        "primitive": name,
        "right": sum(b["right"] for b in blocks),
        "refused": sum(b["refused"] for b in blocks),
        "by_arb": sum(len(b["hard"]) for b in blocks),
        **{kind: sum(b["counts"][kind] for b in blocks) for kind in kinds},
        "inputs": {kind: sorted(i for b in blocks for i in b[kind]) for kind in ("hard", *kinds)},
        "nearest": min(b["nearest"] for b in blocks),
        "seconds": round(sum(b["seconds"] for b in blocks), 1),
    }


def sweep(name, tested, reference, sources, span=(0, ALL), state=None, processes=1, progress=None):
    """Try every input in a span.

    Parameters
    ----------
    name : str
        A primitive.
    tested, reference : path
        The compiled libraries.
    sources : str
        Digest of the C that `tested` was compiled from.
    span : (int, int)
        Bits of the first input and of the one after the last, multiples of 256.
    state : Path, optional
        File of the blocks that are done.
    processes : int
    progress : callable, optional
        Called with (blocks done, blocks, label).

    Returns
    -------
    dict
        As `total`.
    """
    firsts = range(span[0], span[1], BLOCK)
    key = [sources, libraries.reference_digest(), libraries.narrower(), BLOCK]
    kept = State(state, json.loads(json.dumps(key)))
    waiting = [first for first in firsts if first not in kept.blocks]
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
        jobs = {
            pool.submit(block_result, name, tested, reference, first, min(BLOCK, span[1] - first)): first
            for first in waiting
        }
        for job in as_completed(jobs):
            kept.add(jobs[job], job.result())
            if progress:
                progress(len(firsts) - len(waiting) + sum(j.done() for j in jobs), len(firsts), name)
    return total(name, [kept.blocks[first] for first in firsts])
