"""Replay of an emitted function: every operation on exact expansions, each rounding a new symbol of proved bound.

An operation's result is the exact result on its operands' expansions plus a symbol, bounded by the rounding error of
the largest magnitude in the range. gs_rest(a, b, s) and gs_product_rest(a, b, p) are what the rounding left, so the
symbol of s or p cancels exactly; their side conditions are proved, or the replay stops.
"""

from dataclasses import dataclass
from fractions import Fraction

from .binary64 import DIGITS, LARGEST, SMALLEST, grid
from .emitted import Call, Name, Number
from .expansion import Expansion
from .relative import error_of, no_less

_NO_GRID = Fraction(0)


class Unproved(Exception):
    """A side condition of an operation could not be proved; the message says which."""


@dataclass(frozen=True, eq=False)
class Value:
    """A double during the replay, compared by identity.

    exact is its expansion before its own rounding, rounded the one after; step is a power of two of which it is a
    multiple (None: it is 0); origin is the operation and operands that it is the rounding of; fixed is the double
    itself where it is known.
    """

    exact: Expansion
    rounded: Expansion
    step: object
    origin: tuple = ()
    fixed: object = None


def given(expansion, step=SMALLEST):
    """Return a value that no operation made: a constant, or the argument."""
    return Value(expansion, expansion, step)


def common(a, b):
    """Return a power of two of which sums are multiples, if one operand is of a and the other of b; None is of 0."""
    return min((step for step in (a, b) if step is not None), default=None)


def _product(a, b):
    return None if a is None or b is None else a * b


class Replay:
    """The values of one function where the argument of its expansions is in a range.

    Parameters
    ----------
    function : Function
        As parsed.
    symbols : Symbols
        The range of the argument of expansions.
    parameters : dict of str to Value
        What the parameters are in that range, and what is known of variables beforehand.
    tables : dict of str to Fraction
        What each table holds for the piece.
    index : str, optional
        The name of the number of the piece.

    Raises
    ------
    Unproved
        If a side condition is not proved.
    Overflow
        If an operation may overflow.
    """

    def __init__(self, function, symbols, parameters, tables, index=None):
        self.symbols, self.tables, self.index = symbols, tables, index
        self.values = dict(parameters)
        self.name = function.name
        for self.line, expression in function.statements:
            if self.line != index and self.line not in parameters:
                self.values[self.line] = self.statement(expression)
        self.line = "return"
        self.returned = self.value(function.returned)

    def _stop(self, why):
        raise Unproved(f"{self.name}, {self.line}: {why}")

    def statement(self, expression):
        """Return what a line defines."""
        return self.value(expression)

    def value(self, expression):
        """Return the value of an expression."""
        if isinstance(expression, Name):
            if expression.name not in self.values:
                self._stop(f"{expression.name} is no value")
            return self.values[expression.name]
        if not isinstance(expression, Call):
            return self._stop("a bare number where a value is due")
        if expression.operation in ("gs_v_of", "gs_pick"):
            return self.constant(self._constant(expression))
        if expression.operation not in self.OPERATIONS:
            self._stop(f"{expression.operation} makes no value")
        operands = [self.value(argument) for argument in expression.arguments]
        return self.OPERATIONS[expression.operation](self, *operands)

    def constant(self, exact):
        """Return a constant of the C as a value."""
        return given(Expansion.of(exact), grid(exact))

    def _constant(self, expression):
        """Return the number that a call stands for: written out, or picked from a table by the number of the piece."""
        first, *rest = expression.arguments
        if expression.operation == "gs_v_of" and isinstance(first, Number):
            return first.value
        if rest == [Name(self.index)] and isinstance(first, Name) and first.name in self.tables:
            return self.tables[first.name]
        return self._stop(f"{expression.operation} of no constant")

    def _rounded(self, exact, step, *origin):
        """Return the rounding of an exact result that is a multiple of step (None: it is 0)."""
        largest = self.symbols.largest(exact)
        fits = step is None or (step >= SMALLEST and largest <= min(step * 2**DIGITS, LARGEST))
        if fits:
            return Value(exact, exact, step, origin)
        return Value(exact, exact + error_of(self.symbols, exact), SMALLEST, origin)

    def _sum(self, a, b, exact, origin):
        """Return a rounded sum; exact where one operand is 0, or a common grid holds every digit."""
        if a.step is None or b.step is None:
            return Value(exact, exact, common(a.step, b.step), origin)
        return self._rounded(exact, common(a.step, b.step), *origin)

    def add(self, a, b):
        """a + b."""
        return self._sum(a, b, a.rounded + b.rounded, ("gs_add", a, b))

    def sub(self, a, b):
        """a - b; exact where b/2 <= a <= 2 b (Sterbenz)."""
        exact = a.rounded - b.rounded
        sides = (b.rounded + exact + exact, b.rounded - exact, b.rounded)  # 2 a - b, 2 b - a, b
        if all(self.symbols.range(side)[0] >= 0 for side in sides):
            return Value(exact, exact, common(a.step, b.step), ("gs_sub", a, b))
        return self._sum(a, b, exact, ("gs_sub", a, b))

    def mul(self, a, b):
        """a b."""
        return self._rounded(a.rounded * b.rounded, _product(a.step, b.step), "gs_mul", a, b)

    def div(self, a, b):
        """a / b, for a divisor that is one exact term."""
        inverse = b.rounded.inverse()
        if inverse is None or not self.symbols.least(b.rounded):
            self._stop("the divisor is not one exact term away from 0")
        return self._rounded(a.rounded * inverse, _NO_GRID, "gs_div", a, b)

    def fma(self, a, b, c):
        """a b + c, rounded once."""
        step = common(_product(a.step, b.step), c.step)
        return self._rounded(a.rounded * b.rounded + c.rounded, step, "gs_fma", a, b, c)

    def fms(self, a, b, c):
        """a b - c, rounded once."""
        step = common(_product(a.step, b.step), c.step)
        return self._rounded(a.rounded * b.rounded - c.rounded, step, "gs_fms", a, b, c)

    def fnma(self, a, b, c):
        """c - a b, rounded once."""
        step = common(_product(a.step, b.step), c.step)
        return self._rounded(c.rounded - a.rounded * b.rounded, step, "gs_fnma", a, b, c)

    def min(self, a, b):
        """The smaller, where it is the same one over the whole range."""
        for one, other in ((a, b), (b, a)):
            if self.symbols.range(one.rounded)[1] <= self.symbols.range(other.rounded)[0]:
                return one
        return self._stop("which operand of gs_min is smaller is not proved")

    def rest(self, a, b, s):
        """The exact rest of s = RN(a + b): Dekker's fast two-sum, which needs abs a >= abs b, or a = 0."""
        if s.origin not in (("gs_add", a, b), ("gs_add", b, a)):
            self._stop("gs_rest of what is not the rounded sum of its operands")
        if self.symbols.largest(a.rounded) and not no_less(self.symbols, a.rounded, b.rounded):
            largest, least = self.symbols.largest(b.rounded), self.symbols.least(a.rounded)
            return self.unordered_rest(a, b, s, f"{float(least):.6g} and {float(largest):.6g}")
        exact = a.rounded + b.rounded - s.rounded
        return Value(exact, exact, common(a.step, b.step) or SMALLEST)

    def unordered_rest(self, _a, _b, _s, sizes):
        """What gs_rest is where its condition fails: not proved."""
        self._stop(f"gs_rest needs abs a >= abs b: {sizes}")

    def sum_rest(self, a, b, s):
        """The exact rest of s = RN(a + b), whichever is larger: Knuth's two-sum."""
        if s.origin not in (("gs_add", a, b), ("gs_add", b, a)):
            self._stop("gs_sum_rest of what is not the rounded sum of its operands")
        exact = a.rounded + b.rounded - s.rounded
        return Value(exact, exact, common(a.step, b.step) or SMALLEST)

    def product_rest(self, a, b, p):
        """The exact rest of p = RN(a b), but for half the least subnormal where the product's last digits underflow."""
        if p.origin not in (("gs_mul", a, b), ("gs_mul", b, a)):
            self._stop("gs_product_rest of what is not the rounded product of its operands")
        exact = a.rounded * b.rounded - p.rounded
        step = _product(a.step, b.step)
        whole = step is None or step >= SMALLEST
        error = self.symbols.fresh(0 if whole else SMALLEST / 2)
        return Value(exact, exact + error, max(step or SMALLEST, SMALLEST))


Replay.OPERATIONS = {
    "gs_add": Replay.add,
    "gs_sub": Replay.sub,
    "gs_mul": Replay.mul,
    "gs_div": Replay.div,
    "gs_fma": Replay.fma,
    "gs_fms": Replay.fms,
    "gs_fnma": Replay.fnma,
    "gs_min": Replay.min,
    "gs_rest": Replay.rest,
    "gs_sum_rest": Replay.sum_rest,
    "gs_product_rest": Replay.product_rest,
}
