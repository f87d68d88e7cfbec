"""How the free part of an expansion is named: its terms as text, logarithms put together from exponent and mantissa."""

import re
from fractions import Fraction

_EXPONENT = re.compile(r"exponent\((?P<of>.*)\) log\(2\)")
_SCALED = re.compile(r"(?P<factor>-?\d+) x")


def rows_of(symbols, expansion):
    """Return {text: coefficient} of the terms free of symbols."""
    rows = {}
    for (monomial, _), c in expansion.ideal().terms.items():
        text = symbols.shown(monomial)  # the same text is the same number
        rows[text] = rows.get(text, 0) + c
    for text in list(rows):
        if found := _EXPONENT.fullmatch(text):
            _put_together(rows, text, found["of"])
    return rows


def _put_together(rows, exponent, of):
    """Put log(m 2^k) for k log(2) + log(m), and log(x) + n log(2) for log(2^n x)."""
    mantissa = f"log(mantissa({of}))"
    if rows.get(mantissa) != rows[exponent]:
        return
    coefficient = rows.pop(exponent)
    del rows[mantissa]
    scaled = _SCALED.fullmatch(of)
    if scaled:
        factor = Fraction(scaled["factor"])
        twos, of = abs(factor).numerator.bit_length() - 1, "-x" if factor < 0 else "x"
        if abs(factor) != 1 << twos:
            of = scaled.group()
        else:
            rows["log(2)"] = rows.get("log(2)", 0) + coefficient * twos
            if not rows["log(2)"]:
                del rows["log(2)"]
    rows[f"log({of})"] = rows.get(f"log({of})", 0) + coefficient


def shown(rows):
    """Return such rows as one text."""
    found = [text if text and c == 1 else f"{c} {text}".strip() for text, c in sorted(rows.items())]
    return " + ".join(found) or "0"


def of_logarithm(rows, low):
    """Put log(1 - x^-2) for its series in an argument 2 log(x) - 1 - x^-2 - x^-4/2 - ..., x >= low.

    Returns
    -------
    tuple
        The rows, and a bound of what the series leaves out; the rows as they are, and 0, for any other argument.
    """
    rest = {text: c for text, c in rows.items() if not re.fullmatch(r"x\^-\d*[02468]", text)}
    if rest != {"log(x)": 2, "": -1} or not low > 1:
        return rows, Fraction(0)
    z, left_out, last = 1 / (low * low), Fraction(0), 0
    for text, c in rows.items():
        if text not in rest:
            k = int(text.removeprefix("x^-")) // 2
            left_out, last = left_out + abs(c + Fraction(1, k)) * z**k, max(last, k)
    given = {int(text.removeprefix("x^-")) // 2 for text in rows if text not in rest}
    left_out += sum((z**k / k for k in range(1, last) if k not in given), Fraction(0))
    return rest | {"log(1 - x^-2)": 1}, left_out + z ** (last + 1) / (1 - z)
