"""Points of synchronous curves: a size, of time and drag, times a shape, of friction; each made once, in pairs.

From the centre of circle (21) or (24) a bead at theta is seen at the angle 2 theta + theta_c: equal arcs are equal
steps of theta. With mu = cot(theta_max) its distance from A is D sin(theta_max - theta)/sin(theta_max), D that of the
lowest bead, so that nothing cancels: neither near A, nor where friction holds almost all beads.
"""

import operator

import numpy as np

from galileo_sym._front import _filled, _mask, _targets
from galileo_sym._types import as_operand, asked_dtype, common_dtype, is_foreign
from galileo_sym.generated._angle import angle, cosine, sine
from galileo_sym.generated._kernel import admit, clash, quiet, settle
from galileo_sym.generated._primitives import acot, phi2m
from galileo_sym.generated._scaled import Scaled, add, constant, div, load, mul, select, sub

NAMES = ("x", "y")
_USUAL = 400  # exponents of sizes and shapes that two doubles and their product surely hold
_TINY = -60  # exponent of angles that are their own sine


def curve(t, n, *, g, mu, gamma, names=NAMES, out=None, where=True, dtype=None, casting="same_kind"):
    """Return coordinates of points of synchronous curves, those of some names: a tuple of arrays.

    See `galileo_sym.chord.synchronous_curve`.
    """
    count = _count(n)
    operands = [as_operand(value) for value in (t, g, mu, gamma)]
    targets = _targets(out, len(names))
    for value in (*operands, *targets):
        if is_foreign(value) or isinstance(value, np.ma.MaskedArray):
            raise TypeError(f"curves are not made of {type(value).__name__}: pass arrays of NumPy without a mask")
    served = common_dtype(operands)
    wanted = asked_dtype(dtype) or served
    np.positive(np.empty(0, served), dtype=wanted, casting=casting)  # refuses casts as a ufunc does
    values = [found.astype(wanted, copy=False) for found in _coordinates(operands, count, names)]
    if out is None and where is True:
        return tuple(values)
    mask = _mask(where)
    if where is not True:
        targets = _filled(targets, [*values, mask], wanted)
    pairs = zip(values, targets, strict=True)
    return tuple(np.positive(one, out=target, where=mask, casting=casting) for one, target in pairs)


def _count(n):
    """A number of points."""
    try:
        count = operator.index(n)
    except TypeError:
        raise TypeError(f"n is {n!r}: give a whole number of points") from None
    if count < 1:
        raise ValueError(f"n is {count}: a curve has at least 1 point, A")
    return count


def _coordinates(operands, count, names):
    """The coordinates of some names as float64."""
    domains = ("nonnegative", "positive", "nonnegative", "nonnegative")
    (t, g, mu, gamma), void = admit(*((np.asarray(x)[..., None], d) for x, d in zip(operands, domains, strict=True)))
    undecided = {"y": clash(((t, g), (gamma,)))}
    undecided["x"] = undecided["y"] | clash(((t, g), (mu,)))
    with quiet():
        time = load(t)
        size = mul(mul(mul(time, time), load(g)), phi2m(mul(time, load(gamma))))
        shapes = _shapes(load(mu), count, names)
        plain = not np.any(void | undecided["x"]) and all(map(_is_usual, (size, *shapes)))
    shape = np.broadcast_shapes(size.hi.shape, shapes[0].hi.shape)
    found = []
    for name, one in zip(names, shapes, strict=True):
        if plain:
            found.append(np.multiply(np.ldexp(size.hi, size.e), np.ldexp(one.hi, one.e)))
        else:
            with quiet():
                product = mul(size, one)
            found.append(settle(product, np.broadcast_to(void, shape), np.broadcast_to(undecided[name], shape)))
    return found


def _is_usual(value):
    return bool(np.all((np.abs(value.e) < _USUAL) | (value.hi == 0.0)))


def _shapes(mu, count, names):
    """Coordinates of all points over the distance of the lowest bead, in pairs."""
    half = np.arange(count // 2 + 1, dtype=np.float64)
    widest = acot(mu)
    along, left = (div(mul(widest, load(steps)), load(np.float64(count))) for steps in (count - 2 * half, 2 * half))
    (sine_along, cosine_along), (sine_left, _) = _sine_cosine(along), _sine_cosine(left)
    away = div(sine_left, _sine_cosine(widest)[0])
    turned = {"x": sine_along, "y": cosine_along}
    place = np.arange(count)
    other = 2 * place > count
    nearest = np.where(other, count - place, place)
    shapes = []
    for name in names:
        hi, lo, e = (part[..., nearest] for part in mul(away, turned[name]))
        sign = np.where(other, -1.0, 1.0) if name == "x" else 1.0
        shapes.append(Scaled(sign * hi, sign * lo, e))
    return shapes


def _sine_cosine(value):
    """Sine and cosine of an angle from 0 to pi/2 that is a pair: of its first part, turned by the rest."""
    tiny = value.e < _TINY
    e = np.where(tiny, 0, value.e)
    turned = angle(np.where(tiny, 0.0, np.ldexp(value.hi, e)))
    s, c = sine(turned), cosine(turned)
    rest = Scaled(np.where(tiny, 0.0, value.lo), np.zeros_like(value.lo), e)
    whole = add(s, mul(c, rest)), sub(c, mul(s, rest))
    return select(tiny, value, whole[0]), select(tiny, constant(1.0), whole[1])
