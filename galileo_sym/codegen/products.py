"""The factors of a stable form's products, and what several forms have in common."""

from collections import Counter

from sympy import Integer, Mul, exp


def powers_of(expression):
    """Exponents of a product's factors by their bases; an exponential is a base of its own, no power of e."""
    total = Counter()
    for factor in Mul.make_args(expression):
        if isinstance(factor, exp):
            total.update({factor: Integer(1)})
            continue
        for base, exponent in factor.as_powers_dict().items():
            inside = powers_of(base) if base.is_Mul else {base: Integer(1)}
            total.update({b: e * exponent for b, e in inside.items()})
    return total


def shared_factor(forms):
    """Return the product of the factors that all outputs have in common, without numbers; 1 if there is none."""
    powers = [powers_of(form) for form in forms if form != 0]
    if len(powers) < 2 or any(form.is_Add for form in forms):
        return Integer(1)
    common = {b: min(p[b] for p in powers) for b in powers[0] if not b.is_Number and all(b in p for p in powers)}
    return Mul(*(b**e for b, e in common.items()))
