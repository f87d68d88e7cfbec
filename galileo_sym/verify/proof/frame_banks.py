"""Look-ups of a frame: the approximated function at what an argument stands for, with the proved errors."""

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from flint import arb, arb_poly

from . import rounding
from .approximation import piece_bounds
from .approximation_calculus import exact, precision
from .binary64 import DIGITS, RN, double_of_bits, exponent, power
from .dispatch import Bank
from .expansion import ARGUMENT, Expansion
from .frame_names import of_logarithm, rows_of, shown
from .pieces import NEAR, PAIR, PREFIX, centre_table, lookup, pieces, require_served
from .reals import enclosure
from .relative import folded, ratio
from .replay import Unproved, Value

FUNCTIONS = {"arctangent_tail": "arctangent", "omega_tail": "omega", "fall_tail": "fall_factor"}
TINY = power(-400)  # no x below this is looked up where a function vanishes
_REACHES = tuple(n * (1 + power(-20)) / 16 for n in (*range(8, 17), 20, 24, 32, 64, 128, 256))
_PARTS = 16  # of a piece at most, where only some of it is looked up
_CLOSE = power(-30)

# abs(x F'(x)/F(x)) and abs(F'(x)/F(x)) are at most this; None: not bounded so
CONDITIONS = {
    "sine": (1, None),  # x cot(x) <= 1
    "omega": (2, None),  # y/(1 + w), y = w + log(w) <= 2 w
    "fall_log": (1, None),  # y exp(y)/(sigma f), exp(y) <= sigma and y <= f
    "rise_factor": (1, None),  # 1 - p^2 exp(-tau)/(1 - exp(-tau))^2 >= 1 - (tau/2 / sinh(tau/2))^2
    "fall_factor": (2, None),  # p^2 (1 + sigma)/sigma^2 - 1, p^2 <= sigma^2 and <= 2 sigma
    "w0_ratio": (None, 3),  # dW/dq = 2 e q/(v exp(v)) with v = 1 + W, e q^2 <= v^2 exp(v)/2
    "wm1_branch": (
        None,
        8,
    ),  # (du/dq)/(1 + u) = 2 e q exp(u)/u/(1 + u), u = -1 - W, e q^2 <= u^2/2, u < 2.35 for q <= 1/2
    "wm1_middle": (1, None),  # 1/u, u = -1 - W >= 2 for m <= 1/8
}


@dataclass(frozen=True)
class Found:
    """A look-up: its two variables, the function's name and the free terms of its argument."""

    value: Value
    rest: Value
    function: str
    argument: Expansion


@dataclass(frozen=True)
class Errors:
    """What is proved of one piece of a bank; value and pair relative where the function vanishes, else absolute.

    low and high are bounds of the function; where it vanishes, of its quotient by x.
    """

    approximation: Fraction
    value: Fraction
    last: bool
    pair: Fraction
    low: Fraction
    high: Fraction
    vanishes: bool

    @cached_property
    def relative(self):
        """The same, relative."""
        if self.vanishes:
            return self
        return Errors(
            self.approximation, self.value / self.low, self.last, self.pair / self.low, self.low, self.high, False
        )


def natural(emitted, name):
    """Return the Bank that serves all that its pieces cover, but for what x + offset may round out of them."""
    function = emitted.functions[f"{PREFIX}{name}{NEAR}"]
    _, offset, first, drop = lookup(function)
    size = len(emitted.tables[centre_table(function)])
    begin, end = (double_of_bits((first + i) << drop) for i in (0, size))
    return Bank(name, begin - offset, end - rounding.ulp(end) - offset)


class Banks:
    """The approximations of one C file, their bounds proved when they are first needed.

    Parameters
    ----------
    emitted : Emitted
    """

    def __init__(self, emitted):
        self.emitted = emitted
        self._pieces, self._errors = {}, {}

    def pieces(self, bank, suffix, reach):
        """Return the pieces of a bank whose low parts have at most `reach` ulps of the argument."""
        key = bank, suffix, reach
        if key not in self._pieces:
            self._pieces[key] = pieces(self.emitted, bank, suffix, natural(self.emitted, bank), reach)
        return self._pieces[key]

    def errors(self, bank, suffix, piece, reach):
        """Return the Errors of one piece, or of a part of it."""
        key = bank, suffix, piece.index, piece.lower, piece.upper, reach
        if key not in self._errors:
            function = self.emitted.functions[f"{PREFIX}{bank}{suffix}"]
            found = rounding.on_piece(self.emitted, function, piece, reach, TINY)
            (bound,) = piece_bounds(FUNCTIONS.get(bank, bank), [piece])
            vanishes = rounding.vanishes(piece)
            unit = found.least if vanishes else Fraction(1)
            self._errors[key] = Errors(
                Fraction(bound.relative),
                found.value / unit,
                found.last,
                found.pair / unit,
                Fraction(0) if vanishes else Fraction(bound.smallest),
                power(DIGITS) if vanishes else Fraction(bound.largest),
                vanishes,
            )
        return self._errors[key]

    def look_up(self, replay, name, x, x_lo):
        """Return what a call gives in a replay.

        Parameters
        ----------
        replay : FrameReplay
        name : str
            The C function's.
        x, x_lo : Value
            Its arguments; x_lo is None where it takes none.

        Returns
        -------
        Found

        Raises
        ------
        RefusedSource, Unproved, Overflow
            If an argument may be outside the pieces, or a bound cannot be proved.
        """
        symbols, suffix = replay.symbols, PAIR if name.endswith(PAIR) else NEAR
        bank = name.removeprefix(PREFIX).removesuffix(suffix)
        low, high = symbols.range(x.rounded)
        function = self.emitted.functions[name]
        require_served(function, len(self.emitted.tables[centre_table(function)]), low, high)
        reach = _REACHES[0] if x_lo is None else _reach(symbols, x, x_lo)
        met = [part for p in self.pieces(bank, suffix, reach) for part in parts(p, low, high, reach)]
        errors = [self.errors(bank, suffix, piece, reach) for piece in met]
        if low < TINY and any(error.vanishes for error in errors):
            raise Unproved(f"{name} is looked up at less than 2^{exponent(TINY)}, where it vanishes")
        real = x.rounded if x_lo is None else folded(symbols, x.rounded + x_lo.rounded)
        argument = real.ideal()
        rows, left_out = of_logarithm(rows_of(symbols, argument), symbols.atoms[ARGUMENT][0])
        title = f"{FUNCTIONS.get(bank, bank)}({shown(rows)})"
        one = Expansion.of(Fraction(1))
        moved = _moved(symbols, FUNCTIONS.get(bank, bank), real - argument + symbols.fresh(left_out), argument)
        f = symbols.atom(*_range(met, errors, *symbols.range(real), 2 * symbols.largest(moved)), title)
        off = symbols.fresh(max(e.approximation for e in errors), marked=True)
        true = f * (one + moved) * (one + off)
        if any(e.vanishes for e in errors):
            value, pair = (
                f * symbols.fresh(2 * max(getattr(e.relative, part) for e in errors)) for part in ("value", "pair")
            )
        else:
            value, pair = (symbols.fresh(max(getattr(e, part) for e in errors)) for part in ("value", "pair"))
        if any(e.last for e in errors):
            hi = replay.rounded_as_it_is(true + value)
        else:
            hi = Value(true + value, true + value, power(-1074))
        rest = folded(symbols, true + pair - hi.rounded)
        return Found(hi, Value(rest, rest, power(-1074)), FUNCTIONS.get(bank, bank), argument)


def parts(piece, low, high, reach):
    """Return the parts of a piece in which an x from low to high may lie, about as wide as that range.

    Each holds its x + x_lo, too, as the piece does.
    """
    if piece.lower > high or low > piece.upper:
        return []
    count = 1
    while count < _PARTS and 2 * count * (high - low) <= piece.upper - piece.lower:
        count *= 2
    width, blur = (piece.upper - piece.lower) / count, reach * rounding.ulp(piece.upper)
    begins = [piece.lower + i * width for i in range(count)]
    return [
        replace(piece, lower=max(piece.lower, begin - blur), upper=min(piece.upper, begin + width + blur))
        for begin in begins
        if begin <= high and low <= begin + width
    ]


def _reach(symbols, x, x_lo):
    """Return how many ulps of x its low part has at most."""
    least, largest = RN(symbols.least(x.exact)), symbols.largest(x_lo.rounded)  # rounding is monotonic
    relative = ratio(symbols, x_lo.rounded, x.rounded)
    bounds = [] if relative is None else [relative * power(DIGITS)]
    if least:
        bounds.append(largest / rounding.ulp(least))
    for reach in _REACHES:
        if bounds and min(bounds) <= reach:
            return reach
    raise Unproved(f"a low part of more than {_REACHES[-1]} ulps")


def _moved(symbols, function, moved, argument):
    """Return the relative change of the function where its argument is moved, as a symbol."""
    if not moved.terms:
        return Expansion({})
    condition, slope = CONDITIONS.get(function, (None, None))
    bounds = []
    if condition is not None and (relative := ratio(symbols, moved, argument)) is not None and relative < _CLOSE:
        bounds.append(2 * condition * relative)
    if slope is not None and symbols.largest(moved) < _CLOSE:
        bounds.append(2 * slope * symbols.largest(moved))
    if not bounds:
        raise Unproved(f"{function} is looked up beside its argument, and its slope is not known here")
    return symbols.fresh(min(bounds))


def _range(met, errors, low, high, moved):
    """Return bounds of the function between two arguments, and of its value at others that are moved from these."""
    ends = []
    for piece, error in zip(met, errors, strict=True):
        start, stop = max(low, piece.lower), min(high, piece.upper)
        if start > stop:
            continue
        coefficients = piece.coefficients[error.vanishes :]
        with precision():
            middle, half = (start + stop) / 2 - piece.centre, exact((stop - start) / 2)
            shifted = arb_poly([exact(c) for c in coefficients])(arb_poly([exact(middle), 1])).coeffs()
            reach = sum((abs(c) * half**k for k, c in enumerate(shifted[1:], 1)), arb(0))
            least, _ = enclosure(shifted[0] - reach)
            _, greatest = enclosure(shifted[0] + reach)
        least = max(least / (1 + error.approximation), error.low)
        greatest = min(greatest / (1 - error.approximation), error.high)
        ends.append((least * start, greatest * stop) if error.vanishes else (least, greatest))
    return min(a for a, _ in ends) * (1 - moved), max(b for _, b in ends) * (1 + moved)
