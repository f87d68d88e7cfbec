"""What each range of a frame computes but for errors, and why that is the primitive: forms in the names of a replay.

A form gives the terms {text: coefficient} that the free part of a result must have, and a bound of what it leaves out.
The functions in it are those that the approximations were held against; nothing here is evaluated but the bounds.
"""

import re
from dataclasses import dataclass
from fractions import Fraction
from math import comb, factorial

from .approximation_calculus import exact, precision
from .binary64 import exponent, power
from .frame_names import rows_of
from .reals import enclosure

_SMALL = power(-200)


@dataclass(frozen=True)
class Terms:
    """The free part of a result, {text: coefficient}; bounds of x, of the atoms by name, of monomials by text."""

    rows: dict
    x: tuple
    atoms: dict
    largest: dict


def terms_of(symbols, expansion, x):
    """Return the free terms of an expansion by their text."""
    atoms = {symbols.names[number]: ends for number, ends in symbols.atoms.items()}
    ideal = expansion.ideal().terms
    largest = {}
    for monomial, _ in ideal:
        text = symbols.shown(monomial)
        largest[text] = max(largest.get(text, 0), *map(abs, symbols.range_of(monomial)))
    return Terms(rows_of(symbols, expansion), x, atoms, largest)


def only(expected, omitted=None):
    """A form of given terms, {text: coefficient}; of one of coefficient 1 by its text."""
    expected = {expected: 1} if isinstance(expected, str) else expected

    def form(terms):
        if terms.rows != expected:
            return None
        return omitted(terms) if omitted else Fraction(0)

    return form


def _at_zero(terms):
    """Nothing is left out at x = 0 alone."""
    return Fraction(0 if terms.x == (0, 0) else 1)


def _itself(terms):
    """What an odd function f(x) = x - c x^3 ..., c <= 1/2, leaves of x."""
    largest = max(map(abs, terms.x))
    return largest * largest if largest <= _SMALL else Fraction(1)


def _arctangent(terms):
    """pi/2 - (y - y^3/3 + ...), y = 1/x, whose terms alternate and fall; beyond what is cut off, pi/2 less that."""
    low, coefficients = terms.x[0], dict(terms.rows)
    if coefficients.pop("pi/2", None) != 1:
        return None
    if set(coefficients) == {""}:
        return abs(coefficients[""]) + 1 / low
    found = 1 / (11 * low**11)
    for k in range(1, 10, 2):  # a coefficient that is lost in the rounding of the one before it is 0
        found += abs(coefficients.pop(f"x^-{k}", 0) - Fraction((-1) ** ((k + 1) // 2), k)) / low**k
    return None if coefficients else found  # the value is above 1


_SIXTEENTH = "2^(-j/16)"


def _exponential(terms):
    """2^(-j/16) power exp(T), power = 2^-n, exp by its series; where K = 0, and j, T = -x."""
    coefficients = dict(terms.rows)
    stem = next((text for text in (f"{_SIXTEENTH} power", _SIXTEENTH) if coefficients.pop(text, None) == 1), None)
    if stem is None:
        return None
    variable, sign = ("x", -1) if stem == _SIXTEENTH else ("t", 1)
    size = max(map(abs, terms.atoms[variable]))
    found, degree = Fraction(0), len(coefficients)
    for k in range(1, degree + 1):
        text = f"{stem} {variable}{f'^{k}' if k > 1 else ''}"
        if text not in coefficients:
            return None
        found += abs(coefficients[text] - Fraction(sign**k, factorial(k))) * size**k
    if not size < Fraction(1, 4):
        return None
    # the value is at least exp(-size) > 3/4 of the first term
    return (found + 2 * size ** (degree + 1) / factorial(degree + 1)) * Fraction(4, 3)


def _exp_minus(x):
    """Upper bound of exp(-x)."""
    with precision():
        return enclosure((-exact(x)).exp())[1]


def _tiny_offset(sign):
    """sqrt(2 x): 1 + W0 = p (1 - p/3 ...) >= p (1 - p), -1 - W-1 = p (1 + p/3 ...) <= p (1 + p), p = sqrt(2 x)."""

    def form(terms):
        ((text, coefficient),) = terms.rows.items() if len(terms.rows) == 1 else [("", 0)]
        found = re.fullmatch(r"sqrt\((\d+) x\)", text)
        if not found or sign * coefficient < 0 or coefficient * coefficient * int(found[1]) != 2:
            return None
        high = terms.x[1]
        return power((exponent(high) + 4) // 2) if high else Fraction(0)

    return form


def _one(terms):
    """1 + W0(-exp(-1 - x)) >= 1 - exp(-x)."""
    off = _exp_minus(terms.x[0])
    return off / (1 - off)


def _w0_series(terms):
    """x - x^2 + 3/2 x^3 - 8/3 x^4 + 125/24 x^5 ..., whose terms n^(n - 1)/n! x^n fall like (e x)^n."""
    size, coefficients = max(map(abs, terms.x)), dict(terms.rows)
    if coefficients.pop("x", None) != 1 or not size < Fraction(1, 8):
        return None
    found = 8 * size**4  # of x, which is less than twice the value
    for n in range(2, 5):
        true = Fraction((-n) ** (n - 1), factorial(n))
        found += abs(coefficients.pop(f"x^{n}", 0) - true) * size ** (n - 1)
    return None if coefficients else 2 * found


def _past(terms):
    """fall_log(y) - y = log(1 + (1 + fall_log(y))/exp(y)) is between 0 and 1, and so is the difference of two."""
    return 2 / terms.x[0]


def _no_share(terms):
    """Less than 2^12/x^2 of the divisor a^2 - 1 - w, w <= 2 log(a) < 1420."""
    return power(12) / max(terms.x[0], 1) ** 2


def _no_square(terms):
    """sqrt(1 - v) >= 1 - v, v = (2 + w) w/(a^2 - 1) <= 1422^2/(a^2 - 1)."""
    return power(22) / terms.x[0] ** 2


_OMEGA = "omega(-1 + log(1 - x^-2) + 2 log(x))"
_DIVISOR = f"(-1 {_OMEGA} x^-1 + x + -1 x^-1)"


def _arcsine(terms):
    """asin(s) = s + s^3/6 + ..., s = w/(a - (1 + w)/a), or w/a but for what that leaves out."""
    for divisor, left_out in ((_DIVISOR, Fraction(0)), ("x", _no_share(terms))):
        texts = [_product((_OMEGA, n), (divisor, -n)) for n in range(1, 30, 2)]
        coefficients = dict(terms.rows)
        if coefficients.pop(texts[0], None) != 1:
            continue
        size, found = terms.largest[texts[0]], left_out
        if not size < Fraction(1, 4):
            return None
        for k, text in enumerate(texts[1:], 1):
            found += abs(coefficients.pop(text, 0) - Fraction(comb(2 * k, k), 4**k * (2 * k + 1))) * size ** (2 * k)
        return None if coefficients else found + size**30
    return None


def _product(*powers):
    return " ".join(sorted(atom if k == 1 else f"{atom}^{k}" for atom, k in powers))


_ROOT, _BRANCH, _FALL = "sqrt(2 x)", "sqrt(1/e + x)", "sqrt(-2 + -2 log(-x))"
_W0_BESIDE = {f"1/e + x w0_ratio({_BRANCH})": 1, f"1/e w0_ratio({_BRANCH})": -1}
_LEFT = f"sqrt(1 + -2 (-1 + x^2)^-1 {_OMEGA} + -1 (-1 + x^2)^-1 {_OMEGA}^2)"

# what a primitive's ranges may compute, and what that leaves out
FORMS = {
    "exp_minus": (_exponential,),
    "sin": (only("sine(x)"), only("x", _itself)),
    "cos": (only("sine(pi/2 - x)"), only("sine(pi/2 + -1 x)"), only("sine(pi/2)", _at_zero)),
    "arctan": (only("arctangent(x)"), only("x", _itself), _arctangent),
    # (1 + s) = 2 + w, exp(s) = (a^2 - 1)/w where w + log(w) = 2 log(a) - 1 + log(1 - 1/a^2)
    "best_sine": (
        only("best_sine(x)"),
        only("best_sine(0)", _at_zero),
        only(f"{_DIVISOR}^-1 {_OMEGA}"),
        only(f"{_OMEGA} x^-1", _no_share),
    ),
    "best_angle": (only("best_angle(x)"), only("best_angle(0)", _at_zero), _arcsine),
    "max_range_factor": (
        only("max_range_factor(x)"),
        only("max_range_factor(0)", _at_zero),
        only(f"{_LEFT} x^-1"),
        only(f"sqrt(1 + -2 {_OMEGA} x^-2 + -1 {_OMEGA}^2 x^-2) x^-1", _no_square),
        only("sqrt(1) x^-1", _no_square),
        only("x^-1", _no_square),
    ),
    "w0": (
        only(f"w0_ratio({_BRANCH}) x"),
        only(_W0_BESIDE),
        _w0_series,
        only("omega(log(x))"),
    ),
    "wm1": (
        only({f"wm1_branch({_BRANCH})": -1}),
        only({"wm1_middle(-1 x)": -1}),
        only({"": -1, f"fall_factor({_FALL}) {_FALL}": -1}),
    ),
    "w0_offset": (only(f"rise_factor({_ROOT}) {_ROOT}"), _tiny_offset(1), only("", _one)),
    "wm1_offset": (
        only({f"fall_factor({_ROOT}) {_ROOT}": -1}),
        _tiny_offset(-1),
        only({"fall_log(log(x))": -1, "x": -1}),
        only({"fall_log(60)": -1, "": 60, "log(x)": -1, "x": -1}, _past),
    ),
}

# upper bounds of a primitive at x and beyond, where the result may be 0
VALUES_AT_LEAST = {"exp_minus": _exp_minus}


def omitted(name, terms):
    """Return a bound of abs(form/primitive - 1).

    Parameters
    ----------
    name : str
        The primitive.
    terms : Terms

    Returns
    -------
    Fraction or None
        None if the terms are those of no form of the primitive.
    """
    found = [bound for form in FORMS[name] if (bound := form(terms)) is not None]
    return min(found, default=None)
