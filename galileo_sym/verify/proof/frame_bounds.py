"""Bounds of the frames' primitives: each range cell by cell, halved until the bound is good or does not get better."""

from dataclasses import dataclass
from fractions import Fraction
from heapq import heappop, heappush
from itertools import count
from math import inf

from .approximation import Unproved as UnprovedApproximation
from .binary64 import DIGITS, LARGEST, SMALLEST, Overflow, power, ulp
from .bounds import Proved
from .emitted import RefusedSource
from .expansion import Expansion
from .frame_banks import Banks
from .frame_cells import beside, plain
from .frame_dispatch import frames
from .frame_forms import VALUES_AT_LEAST, omitted, terms_of
from .frame_points import LIMITS, error_at
from .frame_reduction import INDEX, reduced
from .frame_replay import FrameReplay
from .frame_selection import Undecided
from .reals import table
from .relative import scale
from .replay import Unproved

GOAL = Fraction(109, 200)  # ulp: a range as good as this is not cut further
DEPTH = 40
CUTS = 2000  # of a range at most
GAIN = power(-9)  # a cut that makes the bound better by less is in vain
VAIN = 4  # cuts in vain after which a cell is left
# ranges where sums with a real number cancel: its sign and how far it is felt
BESIDE = {
    "gs_cos_range0": ("pi/2", 1, Fraction(1)),
    "gs_w0_range0": ("1/e", -1, Fraction(1, 8)),
    "gs_wm1_range0": ("1/e", -1, Fraction(1, 8)),
}
CHOICES = 6  # comparisons that a cell may leave open
_HALF = Fraction(1, 2)


@dataclass(frozen=True)
class Judged:
    """What is proved of a cell: as in `bounds.Proved`."""

    approximation: Fraction
    rounding: Fraction
    total: Fraction
    pair: Fraction


def _split(symbols, expansion):
    """Return the terms with a marked symbol, and the others."""
    marked = {key: c for key, c in expansion.terms.items() if symbols.marked.intersection(key[1])}
    return Expansion(marked), Expansion({key: c for key, c in expansion.terms.items() if key not in marked})


def _judge(name, replay, cell):
    """Return the Judged of one replay."""
    symbols, hi, lo = replay.symbols, replay.returned, replay.values["lo"]
    if isinstance(lo, Exception):
        raise lo
    if not hi.rounded.terms:
        return _nothing(name, cell)
    ideal = hi.exact.ideal()
    terms = terms_of(symbols, ideal, cell.x)
    left_out = omitted(name, terms)
    if left_out is None:
        raise Unproved(f"{replay.name} computes {replay.shown(ideal)}: no form of {name}")
    if left_out > _HALF:
        raise Unproved(f"{replay.name}: too much is left out of {replay.shown(ideal)}")
    last = hi.exact.terms != hi.rounded.terms
    approximated, rounded = _split(symbols, hi.exact - ideal)
    pair = hi.rounded + lo.rounded - ideal
    found = []
    for unit in {(), scale(symbols, ideal)}:
        least = symbols.least(ideal.over(unit)) / (1 + left_out)
        if not least:
            continue
        parts = [symbols.largest(part.over(unit)) / least for part in (approximated, rounded, pair)]
        ulps = power(DIGITS) if unit else least / ulp(least)
        total = (parts[0] + parts[1]) * ulps + left_out * power(DIGITS) + _HALF * last
        found.append(Judged(parts[0] + left_out, parts[1] * ulps, total, parts[2]))
    if not found:
        raise Unproved(f"{replay.name}: the result may vanish")
    best = [min(getattr(row, part) for row in found) for part in Judged.__dataclass_fields__]
    return Judged(*best[:-1], best[-1] + left_out)


def _nothing(name, cell):
    """Return the Judged of a cell on which the result is 0."""
    low, high = cell.x
    value = VALUES_AT_LEAST[name](low) if name in VALUES_AT_LEAST and low else Fraction(0)
    if value >= SMALLEST or not (value or low == high == 0):
        raise Unproved(f"{name}: 0 from {float(low)} to {float(high)}")
    return Judged(Fraction(0), Fraction(0), value / SMALLEST, Fraction(0))


def _replays(emitted, function, banks, cell):
    """Return the replays of a cell: one for every way in which the comparisons may come out."""
    done, waiting = [], [()]
    while waiting:
        choices = waiting.pop()
        symbols, reals, known = cell.start()
        tables, index = _tables(emitted, cell)
        try:
            done.append(FrameReplay(function, symbols, known, tables, banks, reals, choices, index))
        except Undecided:
            if len(choices) == CHOICES:
                raise Unproved(f"{function.name}: more than {CHOICES} comparisons are open") from None
            waiting += [(*choices, True), (*choices, False)]
    return done


def _tables(emitted, cell):
    """Return what is picked on a cell, and the index's name."""
    return (emitted.tables, INDEX) if hasattr(cell, "j") else ({}, None)


def on_cell(name, emitted, function, banks, cell):
    """Return the Judged of a cell as it is, the worst of its replays."""
    found = [_judge(name, replay, cell) for replay in _replays(emitted, function, banks, cell)]
    return _worst(found)


def _worst(found):
    return Judged(*(max(getattr(row, part) for row in found) for part in Judged.__dataclass_fields__))


def _attempt(*arguments):
    """Return the Judged of a cell, or why there is none."""
    try:
        return on_cell(*arguments)
    except (Unproved, UnprovedApproximation, Overflow, RefusedSource) as cause:
        return cause


def on_range(name, emitted, function, banks, cells):
    """Return the Judged of a range: its cells are halved where nothing, or no good bound, is proved.

    Raises
    ------
    Unproved, RefusedSource, Overflow
        If on some cell nothing is proved, however small it is.
    """
    numbers, waiting = count(), []

    def add(cell, depth=0, above=inf, vain=0):
        judged = _attempt(name, emitted, function, banks, cell)
        total = judged.total if isinstance(judged, Judged) else inf
        vain += cell.narrow and total < inf and total > above - GAIN
        # what is not proved first, the deepest first
        heappush(waiting, (-total, -depth, next(numbers), cell, judged, vain))

    for cell in cells:
        add(cell)
    for cuts in count():
        total, depth, _, cell, judged, vain = waiting[0]
        proved = isinstance(judged, Judged)
        done = proved and (judged.total <= GOAL or vain == VAIN)
        halves = [] if done or -depth == DEPTH or cuts > CUTS else cell.halves()
        if not halves:
            break
        heappop(waiting)
        for half in halves:
            add(half, 1 - depth, -total, vain)
    if not proved:
        raise judged
    return _worst([row for *_, row, _ in waiting])


def _cells(name, function, served):
    """Return the cells that a range begins with."""
    if INDEX in dict(function.statements):
        return reduced(function, served)
    return beside(served, table(), *BESIDE[served.function]) if served.function in BESIDE else [plain(served)]


def _range(name, emitted, banks, served, high):
    """Return the Proved of one range."""
    function, one = emitted.functions[served.function], plain(served) if served.begin < inf else None
    judged = []
    if one and not (one.lower == one.upper and (name, one.lower) in LIMITS):
        judged.append(on_range(name, emitted, function, banks, _cells(name, function, served)))
    elif one:
        judged.append(Judged(Fraction(0), Fraction(0), error_at(name, function, 0), Fraction(0)))
    if served.end == high == inf:
        judged.append(Judged(Fraction(0), Fraction(0), error_at(name, function, inf), Fraction(0)))
    found = _worst(judged)
    lower, upper = one.x if one else (LARGEST, LARGEST)
    return Proved(served.function, None, lower, upper, found.approximation, found.rounding, found.total, found.pair)


def prove_frame(emitted, name, banks=None):
    """Prove the bounds of one frame's primitive.

    Parameters
    ----------
    emitted : Emitted
        Of galileo_frames.h.
    name : str
    banks : Banks, optional
        Those of the same file, which keep what is proved of them.

    Returns
    -------
    list of Proved
        Every range, in the order of x; piece is None.

    Raises
    ------
    RefusedSource, Unproved, Overflow
        If the C is outside the grammar, or something cannot be proved.
    """
    frame, banks = frames(emitted)[name], banks or Banks(emitted)
    last = frame.ranges[-1]
    return [_range(name, emitted, banks, served, frame.high if served is last else None) for served in frame.ranges]
