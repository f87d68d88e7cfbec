"""Linear equations of motion solved by their Taylor series: recurrence, general term, sum. No solver is called."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from galileo_sym.ledger import DerivationError, step, tactic
from galileo_sym.ledger.equivalence import is_zero


@dataclass(frozen=True)
class LinearLaw:
    """The highest derivative as level + the sum of coefficients[j] times the derivative of order j, all constant."""

    coefficients: tuple
    level: sp.Expr

    @property
    def order(self) -> int:
        """Order of the equation."""
        return len(self.coefficients)

    def derivatives(self, start):
        """Derivatives at one time, without end, from those below the order: each is given by the ones before it."""
        known = list(start)
        level = self.level
        yield from known
        while True:
            known.append(level + sum(a * d for a, d in zip(self.coefficients, known[-self.order :], strict=True)))
            level = 0  # the derivative of a constant
            yield known[-1]


def read_linear_law(equation: sp.Eq, unknown) -> LinearLaw:
    """Read a linear equation of motion with constant coefficients.

    Raises
    ------
    DerivationError
        It is of another kind.
    """
    time = unknown.args[0]
    orders = [d.derivative_count for d in equation.atoms(sp.Derivative) if d.expr == unknown]
    if not orders:
        raise DerivationError(f"{equation} has no derivative of {unknown}")
    names = sp.symbols(f"d:{max(orders) + 1}", cls=sp.Dummy)
    plain = {unknown.diff(time, j): names[j] for j in range(max(orders), 0, -1)} | {unknown: names[0]}
    left = sp.expand((equation.lhs - equation.rhs).subs(plain))
    try:
        polynomial = sp.Poly(left, *names)
    except sp.PolynomialError:
        raise DerivationError(f"{equation} is not linear in {unknown}") from None
    lead = polynomial.coeff_monomial(names[-1])
    if polynomial.total_degree() > 1 or lead == 0 or any(c.has(time) for c in polynomial.coeffs()):
        raise DerivationError(f"{equation} is not linear in {unknown} with constant coefficients")
    *lower, level = (sp.simplify(-polynomial.coeff_monomial(m) / lead) for m in (*names[:-1], 1))
    return LinearLaw(tuple(lower), level)


def initial_values(law: LinearLaw, unknown, start: dict):
    """Derivatives at time 0 below the order of a law, from {s(0): ..., Subs(s'(t), t, 0): ...}."""
    time = unknown.args[0]
    wanted = [unknown.diff(time, j).subs(time, 0) for j in range(law.order)]
    missing = [w for w in wanted if w not in start]
    if missing:
        raise DerivationError(f"no initial value is given for {missing}")
    return [sp.sympify(start[w]) for w in wanted]


@dataclass(frozen=True)
class MotionSeries:
    """A polynomial in the time, and the general term of all later powers."""

    time: sp.Symbol
    head: sp.Expr
    first: int
    term: sp.Expr
    index: sp.Symbol

    def rate(self) -> MotionSeries:
        """The derivative, term by term."""
        slope = sp.powsimp(sp.diff(self.term, self.time))
        return MotionSeries(self.time, sp.diff(self.head, self.time), self.first, slope, self.index)


@tactic
def taylor_of_motion(equation: sp.Eq, unknown, start: dict, index) -> MotionSeries:
    """The Taylor series about time 0 of the solution of a law, with its term of symbolic order.

    The law gives each derivative from the ones before. After the constant force has acted, in the derivative of the
    order of the law, two successive ones have a constant ratio, if only the highest of the lower ones is in the law.

    Parameters
    ----------
    equation : Eq
    unknown : applied function
    start : dict
        Initial values.
    index : Symbol
        Integer; the order of a term.

    Raises
    ------
    DerivationError
        The law is not linear with constant coefficients, the recurrence has more than two terms, or the series does
        not converge at all times.
    """
    law, time = read_linear_law(equation, unknown), unknown.args[0]
    if any(law.coefficients[:-1]):
        raise DerivationError(f"the recurrence of {equation} has more than two terms")
    values = law.derivatives(initial_values(law, unknown, start))
    known = [next(values) for _ in range(law.order + 1)]
    powers = [d * time**j / sp.factorial(j) for j, d in enumerate(known)]
    ratio = law.coefficients[-1]
    if ratio == 0:  # no later derivative is different from 0
        return MotionSeries(time, sum(powers), law.order + 1, sp.S.Zero, index)
    head, j = sum(powers[:-1]), sp.Dummy("j", integer=True)
    growth = sp.product(ratio / (j + 1), (j, law.order, index - 1))
    lead = known[-1] / (sp.factorial(law.order) * ratio**law.order)
    term = lead * sp.simplify(growth * ratio**law.order / ratio**index) * (ratio * time) ** index
    after = term.subs(index, index + 1)
    if is_zero(sp.combsimp(after / term) - ratio * time / (index + 1)) is None:
        raise DerivationError(f"{term} does not satisfy the recurrence of {equation}")
    if sp.limit(ratio * time / (index + 1), index, sp.oo) != 0:
        raise DerivationError(f"the series of {equation} does not converge at all times")
    step("each term from the one before", sp.Eq((index + 1) * after, ratio * time * term, evaluate=False))
    return MotionSeries(time, head, law.order, term, index)


@tactic
def sum_of_series(series: MotionSeries):
    """Sum a series whose later terms are those of the exponential series."""
    index = series.index
    if series.term == 0:
        return series.head
    powers = [p for p in series.term.atoms(sp.Pow) if p.exp.has(index) and p.base.has(series.time)]
    if len(powers) != 1:
        raise DerivationError(f"{series.term} is not a multiple of one power")
    base, exponent = powers[0].as_base_exp()
    name, count = sp.Dummy("z", positive=True), sp.Dummy("n", integer=True, nonnegative=True)
    plain = series.term.xreplace({powers[0]: name**exponent}).subs(index, count)
    constant, varying = plain.as_independent(count, as_Add=False)
    total = constant * sp.simplify(sp.summation(varying, (count, series.first, sp.oo)))
    if total.has(sp.Sum, sp.Piecewise):
        raise DerivationError(f"no sum found of {series.term}")
    return series.head + sp.expand(total).subs(name, base)
