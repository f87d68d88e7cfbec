"""Taylor expansions, and the inverse of a function near its minimum by undetermined coefficients."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic

from .breaks import JUMPING


@tactic
def taylor(expr, variable, point, degree):
    """The Taylor polynomial of an expression about a point, in powers of (variable - point)."""
    if expr.has(*JUMPING, sp.Abs):
        raise DerivationError(f"{expr} need not have derivatives of every order")
    terms = []
    for k in range(degree + 1):
        slope = sp.simplify(sp.diff(expr, variable, k).subs(variable, point))
        if slope.is_finite is not True:
            raise DerivationError(f"derivative {k} of {expr} at {variable} = {point} is {slope}")
        terms.append(slope / sp.factorial(k) * (variable - point) ** k)
    return sp.Add(*terms)


@tactic
def revert_minimum(polynomial, offset, root):
    """Solve f(offset) - f(0) = c2*root^2 for the offset, near a minimum of f, by undetermined coefficients.

    With f = c0 + c2*h^2 + ... + cN*h^N + o(h^N) and c2 > 0 there is one solution on each side of the minimum,
    h = ±p + a2*p^2 + ... + o(p^(N-1)), p = sqrt((f - c0)/c2).

    Parameters
    ----------
    polynomial : expression
        f up to h^N.
    offset, root : symbols h and p

    Returns
    -------
    pair
        The series in `root` for h > 0 and for h < 0.

    Raises
    ------
    DerivationError
        f is not known beyond h^2, or has no minimum with a positive second derivative at h = 0.
    """
    known = sp.Poly(polynomial, offset)
    degree, c2 = known.degree(), known.coeff_monomial(offset**2)
    if degree < 3 or known.coeff_monomial(offset) != 0 or not c2.is_positive:
        raise DerivationError(f"{polynomial} has no minimum at {offset} = 0, or is not known beyond the square")
    shape = polynomial - known.coeff_monomial(1) - c2 * root**2
    return tuple(_match(shape, offset, root, sign * root, degree) for sign in (1, -1))


def _match(shape, offset, root, series, degree):
    """Add the terms root^2 ... root^(degree - 1), one by one, so that the powers of the root in `shape` cancel."""
    for k in range(2, degree):
        unknown = sp.Dummy("a")
        left = sp.Poly(sp.expand(shape.subs(offset, series + unknown * root**k)), root)
        (value,) = sp.solve(left.coeff_monomial(root ** (k + 1)), unknown)
        series += value * root**k
    return series
