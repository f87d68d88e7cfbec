"""The equation a t + b + c e^(d t) = 0: coefficients read off, and the roots on both real branches of W."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from galileo_sym.ledger import DerivationError, step, tactic
from galileo_sym.ledger.equivalence import is_zero


@dataclass(frozen=True)
class Coefficients:
    """a, b, c, d of the equation a t + b + c e^(d t) = 0, with a and d not 0."""

    a: sp.Expr
    b: sp.Expr
    c: sp.Expr
    d: sp.Expr

    def items(self):
        """Pairs of a coefficient's name and its value."""
        return (("a", self.a), ("b", self.b), ("c", self.c), ("d", self.d))


@tactic
def read_coefficients(equation: sp.Eq, unknown) -> Coefficients:
    """Read a, b, c, d off an equation.

    Raises
    ------
    DerivationError
        The equation is not of the form a t + b + c e^(d t) = 0, or a or d is 0.
    """
    left = sp.expand(equation.lhs - equation.rhs, power_exp=False)
    exponentials = sorted((e for e in left.atoms(sp.exp) if e.has(unknown)), key=str)
    if len(exponentials) != 1:
        raise DerivationError(f"{equation} has {len(exponentials)} exponentials of {unknown}, not one")
    exponential = sp.Dummy("exponential")
    polynomial = sp.Poly(left.xreplace({exponentials[0]: exponential}), unknown, exponential)
    exponent = sp.Poly(exponentials[0].args[0], unknown)
    if set(polynomial.monoms()) - {(1, 0), (0, 0), (0, 1)} or exponent.degree() != 1:
        raise DerivationError(f"{equation} is not a*t + b + c*exp(d*t) = 0 in {unknown}")
    a, b, c = (polynomial.coeff_monomial(m) for m in (unknown, 1, exponential))
    d, shift = exponent.coeff_monomial(unknown), exponent.coeff_monomial(1)
    for coefficient, name in ((a, "a"), (d, "d")):
        if coefficient == 0:
            raise DerivationError(f"the coefficient {name} of {equation} is 0: result (3) needs a*d != 0")
    return Coefficients(a, b, c * sp.exp(shift), d)


@tactic
def root_of_product(product: sp.Eq, branch: sp.Eq, value) -> sp.Eq:
    """From z e^z = Q and q = W(q) e^(W(q)) to z = W(Q), one of the branches.

    Parameters
    ----------
    product : Eq
        Eq(z*exp(z), Q).
    branch : Eq
        Eq(q, W(q)*exp(W(q))), what W is.
    value : Symbol
        The q of `branch`.

    Returns
    -------
    Eq
        Eq(z, W(Q)).
    """
    argument = product.rhs
    z = next((e.args[0] for e in sp.Mul.make_args(product.lhs) if isinstance(e, sp.exp)), None)
    if z is None or is_zero(product.lhs - z * sp.exp(z)) is None:
        raise DerivationError(f"the left side of {product} is not z*exp(z)")
    known = branch.rhs.subs(value, argument)
    inverse = next((e.args[0] for e in sp.Mul.make_args(known) if isinstance(e, sp.exp)), None)
    if inverse is None or known != inverse * sp.exp(inverse) or branch.lhs != value:
        raise DerivationError(f"{branch} does not say that W(q)*exp(W(q)) is q")
    return sp.Eq(z, inverse, evaluate=False)


@tactic
def solve_linear_exponential(result3: sp.Eq, names, equation: sp.Eq, unknown, exists) -> sp.Eq:
    """Apply result (3) to an equation, on the branch that it is given for.

    Parameters
    ----------
    result3 : Eq
        Eq(t, -b/a - W(c*d*exp(-b*d/a)/a)/d).
    names : sequence of the symbols (t, a, b, c, d) of `result3`
    equation : Eq
    unknown : Symbol
    exists : Ge
        Proved: the argument of W is at least -1/e.

    Returns
    -------
    Eq
        Eq(unknown, root).

    Raises
    ------
    DerivationError
        `exists` is not about the argument of W, or the root misses the equation.
    """
    coefficients = read_coefficients(equation, unknown)
    put = dict(zip(names, (unknown, *(value for _, value in coefficients.items())), strict=True))
    root = simplify_inside(result3.rhs.subs(put, simultaneous=True))
    (w,) = root.atoms(sp.LambertW)
    require_real(w, exists)
    check_root(equation, unknown, root)
    return sp.Eq(unknown, root, evaluate=False)


def require_real(w, exists):
    """Raise unless `exists` says that the argument of W is at least -1/e, where W is real."""
    told = isinstance(exists, sp.Ge) and is_zero(exists.lhs - w.args[0]) and is_zero(exists.rhs + sp.exp(-1))
    if not told:
        raise DerivationError(f"{exists} is not the condition for {w} to be real")


def simplify_inside(expr):
    """Simplify the arguments of W, then the whole, which leaves W alone."""
    tidy = {w: w.func(sp.simplify(sp.powsimp(w.args[0])), *w.args[1:]) for w in expr.atoms(sp.LambertW)}
    return sp.expand(expr.xreplace(tidy), deep=False)


@tactic
def check_root(equation: sp.Eq, unknown, root, when=sp.true):
    """Put a root back into its equation; it is told as a step, under the condition `when` on which the root is real."""
    back = equation.lhs.subs(unknown, root) - equation.rhs.subs(unknown, root)
    if is_zero(back) is None:
        raise DerivationError(f"{unknown} = {root} does not solve {equation}: {back} is left")
    solved = sp.Eq(equation.lhs.subs(unknown, root), equation.rhs, evaluate=False)
    if when == sp.true:
        return step(f"put {unknown} back in", solved)
    return step(f"put the other {unknown} in, where it is real", sp.Implies(when, solved))


def other_branch(expr):
    """The same expression with the branch W_{-1} in the place of W."""
    return expr.replace(lambda e: isinstance(e, sp.LambertW) and len(e.args) == 1, lambda e: sp.LambertW(e.args[0], -1))
