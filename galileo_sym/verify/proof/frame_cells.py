"""The arguments of a range of a frame as cells: what stands for x on each, and how a cell is halved."""

from dataclasses import dataclass
from fractions import Fraction
from math import inf

from .binary64 import LARGEST, RN, SMALLEST, before, exponent, grid, power, ulp
from .expansion import ARGUMENT, Expansion, Symbols
from .reals import Reals
from .replay import given

_WIDE = 4  # a cell whose ends have a larger quotient is cut at a power of two


class _Interval:
    @property
    def narrow(self):
        """Whether the ends are within a factor of two."""
        low, high = sorted((abs(self.lower), abs(self.upper)))
        return high <= 2 * low


@dataclass(frozen=True)
class Plain(_Interval):
    """lower <= x <= upper."""

    lower: Fraction
    upper: Fraction

    def start(self):
        """Return the symbols of a replay, its real numbers, and what is known beforehand: x at least."""
        symbols = Symbols(self.lower, self.upper)
        if self.lower < self.upper:
            return symbols, Reals(symbols), {"x": given(Expansion.argument(), step(self.lower, self.upper))}
        reals = Reals(symbols, x=self.lower)
        x = (reals.expansion(self.lower) or Expansion.argument()) if self.lower else Expansion({})
        return symbols, reals, {"x": given(x, grid(self.lower))}

    def halves(self):
        """Return two or three cells that hold every double of this one; a cut belongs to the part away from 0."""
        ends = cut(self.lower, self.upper)
        if len(ends) == 2 and ends[0][1] == ends[1][0]:
            (low, middle), (_, high) = ends
            middle = RN(middle)
            inner = before(abs(middle))
            ends = [(low, inner), (middle, high)] if middle > 0 else [(low, middle), (-inner, high)]
        return [Plain(*pair) for pair in ends if pair[0] <= pair[1]]

    @property
    def x(self):
        """Bounds of x."""
        return self.lower, self.upper


@dataclass(frozen=True)
class Beside(_Interval):
    """x = sign (real - d), lower <= d <= upper: the arguments close to a real number, where sums with it cancel."""

    real: str
    sign: int
    lower: Fraction
    upper: Fraction

    def start(self):
        """As for a plain cell."""
        symbols = Symbols(self.lower, self.upper)
        symbols.names[ARGUMENT] = f"{self.real} - x" if self.sign > 0 else f"{self.real} + x"
        reals = Reals(symbols)
        x = (reals.atom(self.real) - Expansion.argument()) * Expansion.of(Fraction(self.sign))
        return symbols, reals, {"x": given(x, step(*symbols.range(x)))}

    def halves(self):
        """As for a plain cell."""
        return [Beside(self.real, self.sign, *ends) for ends in cut(self.lower, self.upper)]

    @property
    def x(self):
        """Bounds of x."""
        symbols, _, known = self.start()
        return symbols.range(known["x"].rounded)


def step(lower, upper):
    """Return a power of two of which every double between two others is a multiple."""
    return ulp(min(abs(lower), abs(upper))) if lower * upper > 0 else SMALLEST


def cut(lower, upper):
    """Return ranges that make up one: at 0, which is one of them, else at a power of two, else in the middle."""
    if lower <= 0 <= upper:
        return [(lower, -SMALLEST)] * (lower < 0) + [(Fraction(0), Fraction(0))] + [(SMALLEST, upper)] * (upper > 0)
    least, greatest = sorted((abs(lower), abs(upper)))
    whole = power(exponent(greatest))
    if greatest > _WIDE * least:
        middle = power((exponent(least) + exponent(greatest) + 1) // 2)
    else:
        middle = whole if least < whole < greatest else (least + greatest) / 2
    return [(lower, middle), (middle, upper)] if lower > 0 else [(lower, -middle), (-middle, upper)]


def plain(served):
    """Return the one cell of a range; the last argument is the greatest double below its end."""
    upper = LARGEST if served.end == inf else _before(served.end)
    return Plain(served.begin, upper)


def _before(value):
    """Return the greatest double below a double."""
    if value > 0:
        return before(value)
    return -SMALLEST if value == 0 else value - ulp(value)


def beside(served, reals, real, sign, far):
    """Return the cells of a range that ends or begins beside a real number, times sign.

    The last double before it is a cell of its own, so is what lies within `far`, held by d, and so is the rest.
    """
    whole, (low, high) = plain(served), reals[real]
    if sign > 0:  # d = real - x
        last, limit = whole.upper, low - far
        close = Beside(real, sign, low - before(last), high - max(limit, whole.lower))
        rest = [Plain(whole.lower, limit)] * (limit > whole.lower)
    else:
        last, limit = whole.lower, far - high
        close = Beside(real, sign, low - before(-last), high + min(limit, whole.upper))
        rest = [Plain(limit, whole.upper)] * (limit < whole.upper)
    return [Plain(last, last), close, *rest]
