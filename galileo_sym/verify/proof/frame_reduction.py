"""Ranges that round to a multiple of log(2)/16 first: x = K log(2)/16 - T, K = 16 n + j, power = 2^-(n - before)."""

from dataclasses import dataclass, replace
from fractions import Fraction

from .binary64 import DIGITS, RN, grid, power
from .emitted import Call, Name, Number, RefusedSource
from .expansion import Expansion, Symbols
from .frame_cells import Plain, cut, plain, step
from .reals import Reals, table
from .replay import given

STEP = "log(2)/16"
_LEAST_NORMAL = 1022  # exp(-x) may be subnormal from this n on
INDEX = "j"


@dataclass(frozen=True)
class Rounding:
    """How a range begins: u = x steps + shift, rounded; power = 2^-(n - before)."""

    steps: Fraction
    shift: Fraction
    before: int


@dataclass(frozen=True)
class Reduced:
    """The x of a range for which K = 16 n + j with least <= n <= greatest; for every j if that is None.

    rest are bounds of T, where it is cut; None: the largest that a rounding to the nearest integer can leave.
    """

    rounding: Rounding
    ends: tuple
    j: object
    least: int
    greatest: int
    rest: object = None
    narrow = False

    @property
    def x(self):
        """Bounds of x."""
        symbols, _, known = self.start()
        low, high = symbols.range(known["x"].rounded)
        return max(low, self.ends[0]), min(high, self.ends[1])

    def halves(self):
        """Return cells that make up this one: by n, by j, by T."""
        if self.least < self.greatest:
            middle = (self.least + self.greatest) // 2
            return [replace(self, greatest=middle), replace(self, least=middle + 1)]
        if self.j is None:
            return [replace(self, j=j) for j in range(16)]
        if self.rest:
            return [replace(self, rest=ends) for ends in cut(*self.rest)]
        low, high = table()[STEP]
        K = 16 * self.least + self.j
        distance = min(abs(RN(low * K) - end * K) for end in (low, high))  # no double is closer to K log(2)/16
        reach = self._reach()
        return [replace(self, rest=ends) for ends in ((-reach, -distance), (distance, reach))]

    def _reach(self):
        """Return a bound of abs T."""
        off = max(abs(end - 1 / self.rounding.steps) for end in table()[STEP])
        return off * 16 * (self.greatest + 1) + Fraction(1, 2) / self.rounding.steps

    def start(self):
        """Return the symbols of a replay, its real numbers, and what is known beforehand: x, u and power."""
        symbols = Symbols(Fraction(0), Fraction(0))
        first, last = (0, 15) if self.j is None else (self.j, self.j)
        reals = Reals(symbols, range(first, last + 1))
        K = symbols.atom(Fraction(16 * self.least + first), Fraction(16 * self.greatest + last), "k")
        T = symbols.atom(*(self.rest or (-self._reach(), self._reach())), "t")
        x = reals.atom(STEP) * K - T
        low, high = symbols.range(x)
        scale = symbols.atom(power(-self.greatest), power(-self.least), "power")  # 2^-n
        known = {
            "x": given(x, step(max(low, self.ends[0]), min(high, self.ends[1]))),
            "u": given(Expansion.of(self.rounding.shift) + K, Fraction(1)),
            "power": given(
                scale * Expansion.of(power(self.rounding.before)), power(self.rounding.before - self.greatest)
            ),
        }
        return symbols, reals, known


@dataclass(frozen=True)
class Unreduced:
    """The x of a range for which K = 0: T = -x, power = 1."""

    rounding: Rounding
    lower: Fraction
    upper: Fraction
    j: int = 0

    @property
    def narrow(self):
        """Whether the ends are within a factor of two."""
        return self._plain().narrow

    @property
    def x(self):
        """Bounds of x."""
        return self.lower, self.upper

    def halves(self):
        """Return 0 alone and the rest, then by size."""
        return [replace(self, lower=cell.lower, upper=cell.upper) for cell in self._plain().halves()]

    def _plain(self):
        return Plain(self.lower, self.upper)

    def start(self):
        """As for the others."""
        symbols, _, known = self._plain().start()
        constants = {"u": self.rounding.shift, "power": Fraction(1)}
        known |= {name: given(Expansion.of(c), grid(c)) for name, c in constants.items()}
        return symbols, Reals(symbols, range(1)), known


def rounding_of(function):
    """Return how a range begins.

    Raises
    ------
    RefusedSource
        If it does not round to multiples of log(2)/16 as described.
    """
    lines = dict(function.statements)
    match [lines.get(name) for name in ("u", "k", INDEX, "power")]:
        case [
            Call("gs_fma", (Name("x"), Call("gs_v_of", (Number(steps),)), Call("gs_v_of", (Number(shift),)))),
            Call("gs_sub", (Name("u"), Call("gs_v_of", (Number(again),)))),
            Call("gs_low_index", (Name("u"),)),
            Call("gs_power", (Name("u"),)),
        ] if again == shift:
            before, odd = divmod(3 * power(DIGITS - 2) - shift, 16)
            if not odd and steps > 0:
                return Rounding(steps, shift, int(before))
    raise RefusedSource(f"{function.name} does not begin with a rounding to multiples of log(2)/16")


def reduced(function, served):
    """Return the cells of a range that begins so.

    The last bits of u = shift + K are those of K - 16 before, as the shift is 3 2^51 - 16 before: gs_low_index gives
    j, and gs_power 2^-(n - before) while that is a normal power of two.

    Raises
    ------
    RefusedSource
        If the range does not begin as described, or u may leave [2^52, 2^53).
    """
    found = rounding_of(function)
    low, high = plain(served).x
    first, last = (int(end * found.steps + Fraction(1, 2)) for end in (low, high))
    first, last = max(first - 1, 0), last + 1  # products are rounded
    if not power(52) <= found.shift + first or not found.shift + last < power(53):
        raise RefusedSource(f"{function.name}: adding {float(found.shift)} is no rounding to an integer here")
    least, greatest = first // 16, last // 16
    if not least - found.before >= 0 or not greatest - found.before <= _LEAST_NORMAL:
        raise RefusedSource(f"{function.name}: gs_power is no power of two here")
    cells, ends = [], (low, high)
    if least == 0:
        cells.append(Unreduced(found, low, (Fraction(1, 2) + power(-40)) / found.steps))
    normal = min(greatest, _LEAST_NORMAL - 1)
    if least == 0:
        cells += [Reduced(found, ends, j, 0, 0) for j in range(1, 16)]
    cells.append(Reduced(found, ends, None, max(least, 1), normal))
    return cells + [Reduced(found, ends, None, n, n) for n in range(normal + 1, greatest + 1)]
