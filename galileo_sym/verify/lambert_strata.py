"""Strata of W and of the roots of a t + b + c exp(d t) = 0."""

import math

from flint import fmpq

from .enclosure import logarithm, number, with_bits
from .sampling import grid_end, step
from .stratum import Stratum

_LEAST = float.fromhex("0x1.78b56362cef37p-2")  # the greatest double below 1/e
_NEAR = 64
_BITS = 400


def _beside_branch_point(draw):
    """From the last doubles before the branch point to an eighth away from it."""
    return _LEAST - draw.integer(0, _NEAR) * 2.0**-54 if draw.chance(0.4) else _LEAST * (1 - draw.magnitude(-53, -3))


def _grid_argument(draw):
    """An x where sqrt(2 (1 + e x)), or log(x), is close to an end of an interval of a table."""
    if draw.chance(0.5):
        return math.exp(min(grid_end(draw), 700.0))
    root = draw.integer(1, 24) / 8.0
    return step((root * root / 2.0 - 1.0) / math.e + 2.0, draw.integer(-4, 4)) - 2.0


def _only(name, draw):
    return Stratum(name, (), lambda stream, has: {"x": draw(stream)})


W0 = (
    _only("typical", lambda draw: draw.magnitude(-4, 8)),
    _only("negative", lambda draw: -draw.uniform(0.0, _LEAST)),
    _only("near-branch-point", lambda draw: -_beside_branch_point(draw)),
    _only("tiny", lambda draw: draw.sign() * draw.magnitude(-1074, -4)),
    _only("huge", lambda draw: draw.magnitude(8, 1024)),
    _only("interval-ends", lambda draw: max(_grid_argument(draw), -_LEAST)),
)
WM1 = (
    _only("typical", lambda draw: -draw.uniform(0.001, _LEAST)),
    _only("near-branch-point", lambda draw: -_beside_branch_point(draw)),
    _only("tiny", lambda draw: -draw.magnitude(-1074, -4)),
    _only("interval-ends", lambda draw: -math.exp(-1.0 - min(grid_end(draw), 38.0) ** 2 / 2.0)),
    _only("switch", lambda draw: -step(0.26, draw.integer(-_NEAR, _NEAR))),
)


def _signed(draw, low, high):
    return draw.sign() * draw.magnitude(low, high)


def _equation(draw, **given):
    """Coefficients of ordinary size and any sign, save those given."""
    return {**{name: _signed(draw, -3, 4) for name in "abcd"}, **given}


def _opposite(draw, **given):
    """An equation with c d/a < 0, that may have two roots."""
    drawn = _equation(draw, **given)
    sign = math.copysign(1.0, drawn["a"]) * math.copysign(1.0, drawn["d"])
    return {**drawn, "c": -sign * abs(drawn["c"])}


@with_bits(_BITS)
def _double_constant(a, c, d):
    """The float nearest the b of a double root: b d/a = 1 + log(-c d/a), for c d/a < 0."""
    a, c, d = (fmpq(*x.as_integer_ratio()) for x in (a, c, d))
    return float((1 + logarithm(number(-c * d / a))) * number(a / d))


def _two_roots(draw):
    """Both roots exist: b d/a is beyond its value for a double root."""
    drawn = _opposite(draw)
    b = _double_constant(drawn["a"], drawn["c"], drawn["d"])
    return {**drawn, "b": b + drawn["a"] / drawn["d"] * draw.magnitude(-8, 6)}


def _near_double(draw):
    """b within a few places of a double root, or at any binary distance from it, on both sides."""
    drawn = _opposite(draw)
    b = _double_constant(drawn["a"], drawn["c"], drawn["d"])
    if draw.chance(0.5):
        places = draw.integer(-4, 4)
        return {**drawn, "b": math.copysign(step(abs(b), places), b)}
    return {**drawn, "b": b * (1.0 + draw.sign() * draw.magnitude(-50, -4))}


def _about_0(draw):
    """b within a few places of -c: one root is near 0, or is 0."""
    drawn = _equation(draw)
    return {**drawn, "b": -math.copysign(step(abs(drawn["c"]), draw.integer(-4, 4)), drawn["c"])}


def _about_the_double_root(draw):
    """b = a/d and c = -a/d, up to a few places: the roots run together at 0, exactly so for powers of two."""
    a, d = math.ldexp(draw.sign(), draw.integer(-9, 9)), math.ldexp(draw.sign(), draw.integer(-9, 9))
    if draw.chance(0.5):
        a, d = a * draw.integer(3, 99), d * draw.integer(3, 99)
    b, c = (math.copysign(step(abs(a / d), draw.integer(-8, 8)), a / d * sign) for sign in (1.0, -1.0))
    return {"a": a, "b": b, "c": c, "d": d}


def _large_w(draw):
    """b d/a = -2**20 ... -2**900: W is huge, and -b/a - W/d cancels to a logarithm."""
    drawn = _equation(draw)
    sign = math.copysign(1.0, drawn["a"]) * math.copysign(1.0, drawn["d"])
    return {**drawn, "b": -sign * draw.magnitude(20, 900), "c": sign * abs(drawn["c"])}


def _large_exponent(draw):
    """b d/a = 2**6 ... 2**900: the exponential of it over- and underflows."""
    drawn = _equation(draw)
    sign = math.copysign(1.0, drawn["a"]) * math.copysign(1.0, drawn["d"])
    return {**drawn, "b": sign * draw.magnitude(6, 900)}


def _extreme(draw):
    """Coefficients of any size with b d/a and c d/a of any size, as far as the roots can be represented."""
    return {name: _signed(draw, -830, 830) for name in "abcd"}


def _range_ends(draw):
    """Roots among the subnormals, or close to overflow: ordinary b and c, extreme a and d of one size."""
    low, high = (1000, 1020) if draw.chance(0.5) else (-1022, -1010)
    return _equation(draw, a=_signed(draw, low, high), d=_signed(draw, low, high))


def _degenerate(draw):
    """c = 0, d = 0 or a = 0."""
    return _equation(draw, **{"acd"[draw.integer(0, 2)]: 0.0})


def _logarithm_near_0(draw):
    """a = 0 and -b/c close to 1."""
    return {**_about_0(draw), "a": 0.0}


def _of_equation(name, draw):
    return Stratum(name, (), lambda stream, has: draw(stream))


ROOTS = (
    _of_equation("typical", _equation),
    _of_equation("two-roots", _two_roots),
    _of_equation("near-double", _near_double),
    _of_equation("about-the-double-root", _about_the_double_root),
    _of_equation("about-0", _about_0),
    _of_equation("small-kappa", lambda draw: _equation(draw, b=_signed(draw, -900, -4), c=_signed(draw, -900, -4))),
    _of_equation("large-W", _large_w),
    _of_equation("large-exponent", _large_exponent),
    _of_equation("extreme", _extreme),
    _of_equation("range-ends", _range_ends),
    _of_equation("degenerate", _degenerate),
    _of_equation("logarithm-near-0", _logarithm_near_0),
)

TABLES = {"lambert.w0": W0, "lambert.wm1": WM1, "lambert.linear_exponential_roots": ROOTS}
