"""Which range of a frame serves which argument: thresholds, parity and domain, read off the C."""

import math
import re
from dataclasses import dataclass
from fractions import Fraction

from .emitted import RefusedSource

_NUMBER = r"gs_v_of\((-?0x[0-9a-f.]+p[+-]?\d+|-?INFINITY)\)"
_PARITY = {  # the argument, and what becomes of r and of its rest
    "": ("x", "{}"),
    "odd": ("gs_abs(x)", "gs_flip({}, x)"),
    "even": ("gs_abs(x)", "{}"),
}


@dataclass(frozen=True)
class Range:
    """The function that serves begin <= x < end; end is infinite where infinity is served, too."""

    function: str
    begin: Fraction
    end: object


@dataclass(frozen=True)
class Frame:
    """A primitive: its ranges in the order of x, its parity, and its domain, of which the ends belong to it."""

    ranges: tuple
    parity: str
    low: object
    high: object


def _exact(text):
    if text.endswith("INFINITY"):
        return -math.inf if text.startswith("-") else math.inf
    return Fraction(float.fromhex(text))


def _value_pattern(name, argument, flipped):
    r, rest = re.escape(flipped.format("r")), re.escape(flipped.format("rest"))
    return re.compile(
        rf"x, \*lo: gs_v m = {re.escape(argument)}; gs_mask here = gs_within\(m, {_NUMBER}, {_NUMBER}\); gs_v rest; "
        rf"gs_v r = gs_{name}_range0\(gs_select\(here, m, {_NUMBER}\), &rest\); \*lo = {rest}; "
        rf"return gs_all\(here\) \? {r} : gs_{name}_outside\(x, {r}, lo\);"
    )


def _outside_patterns(name, argument, flipped):
    """Return those of the whole and of one range."""
    tail, rest = re.escape(flipped.format("tail")), re.escape(flipped.format("rest"))
    one = (
        rf"here = gs_(?:within\(m, {_NUMBER}, {_NUMBER}\)|at_least\(m, {_NUMBER}\)); "
        rf"tail = gs_{name}_range(\d+)\(gs_select\(here, m, {_NUMBER}\), &rest\); "
        rf"r = gs_select\(here, {tail}, r\); \*lo = gs_select\(here, {rest}, \*lo\); "
    )
    start = rf"x, r, \*lo: gs_v m = {re.escape(argument)}; gs_v tail; gs_v rest; gs_mask here; "
    nothing = "x, r, *lo: "
    end = rf"return gs_refuse_beyond\(x, {_NUMBER}, {_NUMBER}, r, lo\);"
    return re.compile(rf"(?:{start}(?P<ranges>(?:{one})+)|{re.escape(nothing)}){end}"), re.compile(one)


def _read(name, value, outside):
    """Return the parity, (begin, end) of every range by its number, later ones over earlier ones, and the domain."""
    for parity, (argument, flipped) in _PARITY.items():
        first = _value_pattern(name, argument, flipped).fullmatch(value)
        whole, one = _outside_patterns(name, argument, flipped)
        rest = whole.fullmatch(outside)
        if first and rest:
            found = [("0", _exact(first[1]), _exact(first[2]))]
            for begin, end, only, number, _ in one.findall(rest["ranges"] or ""):
                found.append((number, _exact(begin or only), _exact(end) if end else math.inf))
            return parity, found, tuple(map(_exact, rest.groups()[-2:]))
    raise RefusedSource(f"gs_{name}_value and gs_{name}_outside choose in a way that the proof does not know")


def _in_order(name, found):
    """Return the ranges in the order of x; where two meet, the later one in the C counts."""
    ranges = []
    for number, begin, end in found:
        kept = []
        for earlier in ranges:
            if begin <= earlier.begin and earlier.end <= end and earlier.end != math.inf:
                raise RefusedSource(f"{name}: range {number} hides {earlier.function}")
            if earlier.begin < begin < earlier.end and end == math.inf == earlier.end:
                kept.append(Range(earlier.function, earlier.begin, begin))
            elif end <= earlier.begin or earlier.end <= begin:
                kept.append(earlier)
            else:
                raise RefusedSource(f"{name}: range {number} overlaps {earlier.function}")
        ranges = [*kept, Range(f"gs_{name}_range{number}", begin, end)]
    return sorted(ranges, key=lambda served: served.begin)


def _frame(emitted, name):
    value, outside = (emitted.choosing.get(f"gs_{name}{suffix}", "there is none") for suffix in ("_value", "_outside"))
    parity, found, (low, high) = _read(name, value, outside)
    ranges = _in_order(name, found)
    least = max(Fraction(0), low) if parity else low
    if parity and low != -high:
        raise RefusedSource(f"{name}: an {parity} function on [{low}, {high}]")
    due = least
    for served in ranges:
        if served.begin != due:
            raise RefusedSource(f"{name}: {served.function} serves from {float(served.begin)}, {float(due)} is due")
        due = served.end
    if not (due > high or due == high == math.inf):
        raise RefusedSource(f"{name}: nothing serves {float(due)}, which is in its domain")
    numbers = {served.function for served in ranges}
    unserved = [f for f in emitted.functions if re.fullmatch(rf"gs_{name}_range\d+", f) and f not in numbers]
    if unserved or not numbers <= set(emitted.functions):
        raise RefusedSource(f"{name}: its ranges are {', '.join(sorted(numbers))}; never served: {', '.join(unserved)}")
    return Frame(tuple(ranges), parity, low, high)


def frames(emitted):
    """What serves each frame's primitive.

    Parameters
    ----------
    emitted : Emitted
        Of galileo_frames.h.

    Returns
    -------
    dict of str to Frame

    Raises
    ------
    RefusedSource
        If a function chooses in another way than the emitter writes, or there is a gap in the domain.
    """
    names = [name.removeprefix("gs_").removesuffix("_value") for name in emitted.choosing if name.endswith("_value")]
    return {name: _frame(emitted, name) for name in names}
