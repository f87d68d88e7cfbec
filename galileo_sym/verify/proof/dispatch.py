"""Which emitted form serves which x: the ranges of the banks of pieces and of the far form, read off the C."""

import re
from dataclasses import dataclass
from fractions import Fraction

from .emitted import RefusedSource

_DOUBLE = r"gs_v_of\((0x[0-9a-f.]+p[+-]?\d+)\)"
_VALUE = re.compile(
    rf"x, \*lo: gs_mask here = gs_within\(x, {_DOUBLE}, {_DOUBLE}\); "
    rf"gs_v r = gs_(?P<bank>\w+)_near\(gs_select\(here, x, {_DOUBLE}\), lo\); "
    r"return gs_all\(here\) \? r : gs_(?P<name>\w+)_outside\(x, r, lo\);"
)
_BANK = (
    rf"gs_mask here = gs_within\(x, {_DOUBLE}, {_DOUBLE}\); "
    rf"tail = gs_(\w+)_near\(gs_select\(here, x, {_DOUBLE}\), &rest\); "
    r"r = gs_select\(here, tail, r\); \*lo = gs_select\(here, rest, \*lo\); "
)
_OUTSIDE = re.compile(
    rf"x, r, \*lo: gs_v tail; gs_v rest; (?P<banks>(?:{_BANK})*)"
    rf"gs_mask beyond = gs_at_least\(x, (?P<beyond>{_DOUBLE})\); "
    rf"tail = gs_(?P<name>\w+)_far\(gs_select\(beyond, x, (?P=beyond)\)\); "
    r"rest = gs_v_of\(0\.0\); \*lo = gs_select\(beyond, rest, \*lo\); "
    r"return gs_refuse_negative\(x, gs_select\(beyond, tail, r\), lo\);"
)


@dataclass(frozen=True)
class Bank:
    """A function of sixteen pieces, and the [begin, end) that it serves."""

    name: str
    begin: Fraction
    end: Fraction


@dataclass(frozen=True)
class Served:
    """The banks of a primitive, one after the other from 0 on, and where its far form begins."""

    banks: tuple
    far_from: Fraction


def _exact(text):
    return Fraction(float.fromhex(text))


def _match(pattern, emitted, name, suffix):
    function = f"gs_{name}{suffix}"
    text = emitted.choosing.get(function, "there is none")
    found = pattern.fullmatch(text)
    if not found or found["name"] != name:
        raise RefusedSource(f"{function} chooses in a way that the proof does not know: {text}")
    return found


def _served(emitted, name):
    first, rest = (_match(p, emitted, name, suffix) for p, suffix in ((_VALUE, "_value"), (_OUTSIDE, "_outside")))
    rows = [(first[1], first[2], first["bank"], first[4]), *re.findall(_BANK, rest["banks"])]
    banks = []
    for begin, end, function, instead in rows:
        due = banks[-1].end if banks else Fraction(0)
        if _exact(begin) != due or _exact(instead) != due or _exact(end) <= due:
            raise RefusedSource(f"{name}: {function} serves [{begin}, {end}), where {float(due)} begins what is left")
        banks.append(Bank(function, due, _exact(end)))
    far_from = _exact(re.search(_DOUBLE, rest["beyond"])[1])
    if far_from != banks[-1].end:
        raise RefusedSource(f"{name}: the last bank ends at {float(banks[-1].end)}, the far form begins elsewhere")
    return Served(tuple(banks), far_from)


def primitives(emitted):
    """What serves each primitive.

    Parameters
    ----------
    emitted : Emitted

    Returns
    -------
    dict of str to Served
        By the primitive's name, such as "descent_factor", in the order of the file.

    Raises
    ------
    RefusedSource
        If a function chooses in another way than the emitter writes, there is a gap or an overlap, or a function is
        left that serves nothing.
    """
    names = [name.removeprefix("gs_").removesuffix("_value") for name in emitted.choosing if name.endswith("_value")]
    found = {name: _served(emitted, name) for name in names}
    banks = [bank.name for served in found.values() for bank in served.banks]
    known = {f"gs_{bank}{suffix}" for bank in banks for suffix in ("_near", "_near_pair")}
    known |= {f"gs_{name}_far" for name in names}
    unserved = [name for name in emitted.functions if name not in known]
    chosen = {f"gs_{name}{suffix}" for name in names for suffix in ("_value", "_outside")}
    unserved += [name for name in emitted.choosing if name not in chosen]
    if unserved or not names:
        raise RefusedSource(f"functions that no primitive stands on: {', '.join(unserved) or 'there is no primitive'}")
    return found


def bank(emitted, name):
    """Return the Bank of this name."""
    for served in primitives(emitted).values():
        for found in served.banks:
            if found.name == name:
                return found
    raise RefusedSource(f"no primitive stands on {name}")
