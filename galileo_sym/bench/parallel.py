"""Two threads against one, on slices of long arrays, and through dask.array."""

from concurrent.futures import ThreadPoolExecutor
from importlib.util import find_spec
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from .contestants import PublicFunctions, public_call
from .timing import Job, against, interleaved

THREADS = 2
SLICES = 16  # more than threads, so that a thread that is held up does less
CASES = ("chord.descent_time friction_drag", "projectile.horizontal_range drag", "lambert.w0")
_ONE = "one thread"


class Scaling(NamedTuple):
    """How many times as fast as one thread a case is; `same` says whether the bits are those of one thread."""

    case: str
    contestant: str
    way: str
    count: int
    gain: tuple
    same: bool


def tiled(case, count, drawn):
    """Inputs of any number: some points are drawn, and repeated."""
    points = case.points(min(count, drawn))
    return {name: np.resize(x, count) for name, x in points.items()}


def _slices(arguments, count):
    ends = np.linspace(0, count, min(SLICES, count) + 1).astype(int)
    return [{name: x[begin:end] for name, x in arguments.items()} for begin, end in pairwise(ends)]


def _by_pool(contestant, case, arguments, count, pool):
    calls = [contestant.prepare(case, part) for part in _slices(arguments, count)]
    return lambda: list(pool.map(lambda call: call(), calls))


def _by_dask(contestant, case, arguments, count):
    """A call that computes a dask array of as many blocks by a pool of threads; public functions take such arrays."""
    import dask.array as da  # noqa: PLC0415 (an extra, and slow to import)

    blocks = {name: da.from_array(arguments[name], chunks=-(-count // SLICES)) for name in case.arguments}
    if isinstance(contestant, PublicFunctions):
        whole = public_call(case, blocks)()
    else:

        def of_block(*parts):
            return contestant.results(case, dict(zip(case.arguments, parts, strict=True)))[0]

        whole = da.map_blocks(of_block, *blocks.values(), dtype=float)
    return lambda: whole.compute(scheduler="threads", num_workers=THREADS)


def _joined(parts):
    return np.concatenate([part[0] if isinstance(part, tuple) else part for part in parts])


def measure(cases, contestant, count, rounds, drawn, tell):
    """Times of one thread over those of several.

    Parameters
    ----------
    cases : list of Case
    contestant : Contestant
    count : int
        Elements.
    rounds : int
    drawn : int
        Points that are drawn, and repeated.
    tell : callable
        Called with a sentence if dask is not there.

    Returns
    -------
    list of Scaling
    """
    if find_spec("dask") is None:
        tell("dask.array: not installed; pip install 'galileo-sym[all]'")
    found = []
    with ThreadPoolExecutor(THREADS) as pool, np.errstate(all="ignore"):
        for case in cases:
            arguments = tiled(case, count, drawn)
            ways = {
                _ONE: contestant.prepare(case, arguments),
                "threads": _by_pool(contestant, case, arguments, count, pool),
            }
            if find_spec("dask") is not None:
                ways["dask.array"] = _by_dask(contestant, case, arguments, count)
            whole = _joined([ways[_ONE]()])
            same = {"threads": np.array_equal(_joined(ways["threads"]()), whole, equal_nan=True)}
            if "dask.array" in ways:
                same["dask.array"] = np.array_equal(ways["dask.array"](), whole, equal_nan=True)
            samples = interleaved({case.key: {way: Job(call, count) for way, call in ways.items()}}, rounds)[case.key]
            for way, agrees in same.items():
                gain = against({_ONE: samples[_ONE], way: samples[way]}, way)[_ONE].ratio
                found.append(Scaling(case.key, contestant.name, way, count, gain, bool(agrees)))
    return found
