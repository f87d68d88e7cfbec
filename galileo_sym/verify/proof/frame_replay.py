"""Replay of a range of a frame: the operations around the look-ups, on expansions in several atoms.

Square roots, quotients of sums, exponents and mantissas, and the approximated functions become atoms of their own; an
approximation's result is its function there, with the errors that were proved of it. Where the range of the argument
leaves open which operand is selected, both cases are replayed.
"""

from dataclasses import replace
from fractions import Fraction

from .approximation import Unproved as UnprovedApproximation
from .binary64 import DIGITS, RN, SMALLEST, Overflow, grid, power, root_bound, ulp
from .emitted import Call, LookUp, RefusedSource
from .expansion import Expansion
from .frame_names import rows_of, shown
from .frame_selection import Selection
from .relative import dominant, error_of, folded, no_less, ratio, underflow_of
from .replay import Replay, Unproved, Value, common, given

_NORMAL = power(-1022)
_NOTHING = power(-100)
_SMALL = power(-30)  # perturbations below this are expanded to second order
_MOST = 10000  # terms of a product, many times what they are on narrow cells


class FrameReplay(Selection):
    """As `Replay`, for a range of a frame.

    Parameters
    ----------
    function : Function
    symbols : Symbols
    parameters : dict of str to Value
    tables : dict of str to Fraction
    banks : Banks
        The approximations that are looked up.
    reals : Reals
    choices : tuple of bool
        How the comparisons that the ranges leave open come out, one after the other.
    index : str, optional
    """

    def __init__(self, function, symbols, parameters, tables, banks, reals, choices, index=None):
        self.banks, self.reals = banks, reals
        self._atoms, self._power = {}, parameters.get("power")
        self.looked_up, self._constants = [], {}
        super().__init__(function, symbols, parameters, tables, index, choices)

    def statement(self, expression):
        """Return what a line defines, or why that is not proved: it may be selected away."""
        try:
            return self.value(expression)
        except (Unproved, UnprovedApproximation, RefusedSource, Overflow) as cause:
            if isinstance(expression, LookUp):
                self.values[expression.rest] = cause
            return cause

    def value(self, expression):
        """Return the value of an expression, a mask, or the result of a look-up."""
        match expression:
            case LookUp():
                return self._look_up(expression)
            case Call("gs_select", (mask, chosen, other)):
                return self.value(chosen if self.value(mask).holds else other)
        found = super().value(expression)
        if isinstance(found, Exception):
            raise found
        return found

    def constant(self, exact):
        """Return a constant; a part of a real number by that number."""
        if exact not in self._constants:
            self._constants[exact] = self._constant_value(exact)
        return self._constants[exact]

    def _constant_value(self, exact):
        if isinstance(exact, float):
            self._stop("infinity where a finite number is due")
        if isinstance(exact, tuple):
            return given(self.reals.picked(exact), min(grid(value) for value in exact if value))
        return given(self.reals.expansion(exact) or Expansion.of(exact), grid(exact))

    def _rounded(self, exact, step, *origin):
        exact = folded(self.symbols, exact)
        low, high = self.symbols.range(exact)
        largest = max(abs(low), abs(high))
        if largest <= SMALLEST / 2:
            return Value(exact, Expansion({}) if largest else exact, None, origin)
        fits = step is None or (step >= SMALLEST and largest <= step * 2**DIGITS)
        if fits:
            return Value(exact, exact, step, origin)
        if largest >= power(1024):
            raise Overflow("an operation may overflow")
        if low > 0 or high < 0:
            near, far = RN(low), RN(high)
            if near == far:  # rounding is monotonic
                error = self.symbols.fresh(max(abs(near - low), abs(near - high)))
                return Value(exact, exact + error, grid(near), origin, near)
            step = ulp(min(abs(near), abs(far)))
        else:
            step = SMALLEST
        return Value(exact, exact + error_of(self.symbols, exact), step, origin)

    def rounded_as_it_is(self, exact):
        """Return the rounding of an exact result of unknown digits."""
        return self._rounded(exact, Fraction(0))

    def _scaled(self, a, factor):
        """Return a times plus or minus a power of two; None if digits may be lost."""
        size = abs(factor.fixed or self.symbols.least(factor.rounded))
        whole = a.step is None or a.step * size >= SMALLEST
        if not whole and self.symbols.least(a.rounded * factor.rounded) < _NORMAL:
            return None
        step = a.step if a.step is None else max(a.step * size, SMALLEST)
        return Value(a.exact * factor.rounded, a.rounded * factor.rounded, step, ("gs_mul", a, factor))

    def _is_power_of_two(self, value):
        if value is self._power:
            return True
        fixed = value.fixed
        if fixed is None and value.exact is value.rounded:
            low, high = self.symbols.range(value.rounded)
            fixed = low if low == high else None
        return bool(fixed) and grid(fixed) == abs(fixed)

    def mul(self, a, b):
        """a b; exact where one is a power of two and nothing underflows."""
        for one, other in ((a, b), (b, a)):
            if self._is_power_of_two(other) and (scaled := self._scaled(one, other)):
                return scaled
        bound = self.symbols.largest(a.rounded) * self.symbols.largest(b.rounded)
        if 0 < bound <= SMALLEST / 2:
            return Value(self.symbols.fresh(bound), Expansion({}), None, ("gs_mul", a, b))
        return super().mul(a, b)

    def sub(self, a, b):
        """a - b; exact for b within a factor of two of a, and for the parts of a sum that was rounded."""
        if not a.rounded.terms and a.step is None:
            return Value(-b.exact, -b.rounded, b.step, ("gs_sub", a, b))
        if not b.rounded.terms:
            return replace(a, origin=("gs_sub", a, b))
        exact = a.rounded - b.rounded
        step = common(a.step, b.step)
        match b.origin, a.origin:
            case (("gs_sub", one, other), _) if one is a and no_less(self.symbols, a.rounded, other.rounded):
                return Value(exact, exact, step, ("part", other, b))  # Dekker
            case (_, ("part", other, _)) if other is b:
                return Value(exact, exact, step)
        close = ratio(self.symbols, exact, b.rounded)
        if close is not None and close <= Fraction(1, 2):  # Sterbenz
            return Value(exact, exact, step, ("gs_sub", a, b))
        return super().sub(a, b)

    def add(self, a, b):
        """a + b; exact where one is 0."""
        for one, other in ((a, b), (b, a)):
            if not one.rounded.terms:
                return replace(other, origin=("gs_add", a, b))
        return super().add(a, b)

    def _fused(self, a, b, c, sign, origin):
        """Return plus or minus a b, and c, rounded once."""
        if len(a.rounded.terms) * len(b.rounded.terms) > _MOST:
            self._stop("the cell is too wide: there are too many terms")
        product = a.rounded * b.rounded * Expansion.of(Fraction(sign))
        if not product.terms:
            return c
        step = None if a.step is None or b.step is None else a.step * b.step
        return self._rounded(product + c.rounded, common(step, c.step), *origin)

    def fma(self, a, b, c):
        """a b + c, rounded once."""
        return self._fused(a, b, c, 1, ("gs_fma", a, b, c))

    def fnma(self, a, b, c):
        """c - a b, rounded once."""
        return self._fused(a, b, c, -1, ("gs_fnma", a, b, c))

    def fms(self, a, b, c):
        """a b - c, rounded once."""
        minus = Value(-c.exact, -c.rounded, c.step)
        return self._fused(a, b, minus, 1, ("gs_fms", a, b, c))

    def _perturbed(self, part, whole):
        """Return part/whole, with a bound of it; the whole is one term without symbols, the part small."""
        ((monomial, _), coefficient), *_ = whole.terms.items()
        relative = part.over(monomial) * Expansion.of(1 / coefficient)
        small = relative.ideal()
        relative = relative - small + self.symbols.fresh(self.symbols.largest(small))
        return relative, self.symbols.largest(relative)

    def _term(self, value):
        """Return the free terms of a value's expansion as one term: a new atom if they are several."""
        ideal = value.rounded.ideal()
        main = dominant(self.symbols, ideal)
        single = Expansion({(main, ()): ideal.terms.get((main, ()), Fraction(0))})
        others = ratio(self.symbols, ideal - single, single) if single.terms else None
        if others is not None and others < _NOTHING:
            return single, value.rounded
        if value not in self._atoms:
            low, high = self.symbols.range(ideal)
            if low <= 0 <= high:
                self._stop("a divisor, or what a root is taken of, may vanish")
            self._atoms[value] = self.symbols.atom(low, high, f"({self.shown(ideal)})")
        atom = self._atoms[value]
        return atom, atom + (value.rounded - ideal)

    def _inverse(self, b):
        """Return 1/b: to second order in what is small."""
        whole, rounded = self._term(b)
        small, bound = self._perturbed(rounded - whole, whole)
        if bound > _SMALL:
            self._stop("the divisor is known too badly")
        series = Expansion.of(Fraction(1)) - small + self.symbols.fresh(2 * bound * bound)
        return whole.inverse() * series

    def div(self, a, b):
        """a / b."""
        if not self.symbols.least(b.rounded):
            self._stop("the divisor may vanish")
        exact = folded(self.symbols, a.rounded * self._inverse(b))
        if (
            self._is_power_of_two(b)
            and (inverse := b.rounded.inverse())
            and (scaled := self._scaled(a, given(inverse)))
        ):
            return scaled
        return self._rounded(exact, Fraction(0), "gs_div", a, b)

    def sqrt(self, a):
        """The square root, of 0 or of what keeps away from it."""
        if not a.rounded.terms:
            return a
        whole, rounded = self._term(a)
        low, high = self.symbols.range(whole)
        if not low > 0:
            self._stop("a root of what may not be positive")
        text = self.shown(whole)
        name = f"sqrt{text}" if text.startswith("(") else f"sqrt({text})"
        root = self.symbols.atom(root_bound(low, False), root_bound(high, True), name)
        small, bound = self._perturbed(rounded - whole, root * root)
        series = (
            Expansion.of(Fraction(1)) + small * Expansion.of(Fraction(1, 2)) + self.symbols.fresh(bound * bound / 4)
        )
        return self._rounded(folded(self.symbols, root * series), Fraction(0), "gs_sqrt", a)

    def product_rest(self, a, b, p):
        """a b - p: exact after a product, a quotient or a root, but for what underflows; else rounded once."""
        match p.origin, a.origin:
            case (("gs_mul", one, other), _) if {id(one), id(other)} == {id(a), id(b)}:
                exact = a.rounded * b.rounded - p.rounded
            case (_, ("gs_div", one, other)) if one is p and other is b:
                exact = (a.rounded - a.exact) * self._term(b)[1]
            case (_, ("gs_sqrt", one)) if one is p and a is b:
                exact = (a.rounded + a.exact) * (a.rounded - a.exact)
            case _:
                return self.fms(a, b, p)
        exact = folded(self.symbols, exact)
        step = None if a.step is None or b.step is None else a.step * b.step
        if step is None or step >= SMALLEST:
            return Value(exact, exact, step)
        return Value(exact, exact + underflow_of(self.symbols, exact), SMALLEST)

    def sum_rest(self, a, b, s):
        """The exact rest of s = RN(a + b), whichever is larger."""
        if s.origin not in (("gs_add", a, b), ("gs_add", b, a)):
            self._stop("gs_sum_rest of what is not the rounded sum of its operands")
        exact = folded(self.symbols, a.rounded + b.rounded - s.rounded)
        return Value(exact, exact, common(a.step, b.step))

    def _look_up(self, call):
        """Return the result of an approximation, and note its rest."""
        x, *low = map(self.value, call.arguments)
        x_lo = low[0] if low else None
        found = self.banks.look_up(self, call.function, x, x_lo)
        self.values[call.rest] = found.rest
        self.looked_up.append(found)
        return found.value

    def shown(self, expansion):
        """Return the free terms of an expansion as text."""
        return shown(rows_of(self.symbols, expansion))


FrameReplay.OPERATIONS = Replay.OPERATIONS | {
    f"gs_{name}": getattr(FrameReplay, name)
    for name in (
        *("add", "sub", "mul", "div", "fma", "fms", "fnma", "min", "max", "product_rest", "sum_rest", "sqrt", "abs"),
        *("flip", "at_least", "less", "exponent", "mantissa"),
    )
}
