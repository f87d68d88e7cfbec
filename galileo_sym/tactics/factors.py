"""From a printed closed form to its stable twin: the primitives put in for what cancels."""

from __future__ import annotations

import sympy as sp

from galileo_sym.ledger import DerivationError, tactic
from galileo_sym.ledger.equivalence import is_zero


@tactic
def introduce(expr, factor, *, closed=sp.LambertW):
    """Write an expression with a primitive in place of its Lambert W, or its exponential.

    Parameters
    ----------
    expr : expression
        As printed.
    factor : primitive at its argument, such as descent_factor(gamma*t0)
    closed : LambertW or exp
        What the closed form of the primitive is solved for: it is linear in it, or has one solution.

    Raises
    ------
    DerivationError
        Nothing in the expression is what the closed form has.
    """
    form = sp.expand(factor.rewrite(closed))
    hard = list(form.atoms(closed))
    if len(hard) != 1:
        raise DerivationError(f"the closed form of {factor} has {len(hard)} times {closed.__name__}: {form}")
    inner = hard[0]
    targets = [a for a in expr.atoms(type(inner)) if _same(a, inner)]
    if not targets:
        raise DerivationError(f"{expr} has no {inner}")
    return sp.factor_terms(sp.expand(expr.xreplace(dict.fromkeys(targets, _solved(form, inner, factor)))))


def _solved(form, inner, factor):
    """What `inner` is, where the closed form has the value `factor`."""
    name, value = sp.Dummy("inner", real=True), sp.Dummy("value", positive=True)
    named = form.xreplace({inner: name})
    slope = sp.diff(named, name)
    if not slope.has(name):
        return (factor - named.subs(name, 0)) / slope
    roots = sp.solve(named - value, name)
    if len(roots) != 1:
        raise DerivationError(f"{form} has the value {factor} for {len(roots)} values of {inner}")
    return roots[0].subs(value, factor)


def _same(one, other):
    """Whether two applications of a function have one value: the same argument, on the same branch."""
    return one.args[1:] == other.args[1:] and is_zero(one.args[0] - other.args[0]) is not None


@tactic
def first_order(expr, force, slopes: dict):
    """Value and first derivative of a stable form where a force vanishes.

    Parameters
    ----------
    expr : expression
        Products of powers and of primitives whose arguments are multiples of `force`.
    slopes : dict
        Proved derivatives of the primitives at 0: {descent_factor: 1/6, ...}.

    Returns
    -------
    pair
        The value at force = 0, and the derivative with respect to it.
    """
    primitives = [f for f in expr.atoms(sp.Function) if f.func in slopes]
    expansions = {}
    for f in primitives:
        argument = f.args[0]
        if not sp.simplify(argument / force).is_constant(force):
            raise DerivationError(f"the argument of {f} is not a multiple of {force}")
        expansions[f] = f.func(0) + slopes[f.func] * argument
    near = sp.expand(expr.xreplace(expansions))
    return sp.simplify(near.subs(force, 0)), sp.simplify(sp.diff(near, force).subs(force, 0))


def limits_at_zero(form, force, value, slope) -> sp.And:
    """The statement that a form tends to a value as a force vanishes, and its derivative to a slope."""
    return sp.And(
        sp.Eq(sp.Limit(form, force, 0, "+"), value, evaluate=False),
        sp.Eq(sp.Limit(sp.Derivative(form, force), force, 0, "+"), slope, evaluate=False),
    )


@tactic
def twin_at_zero(expr, force, facts: dict, closed) -> sp.And:
    """Value and first derivative of a stable form where a force vanishes, told of its closed form.

    Parameters
    ----------
    expr : expression
        The stable form.
    facts : dict
        What was proved of each primitive at 0, as `limits_at_zero` of its closed form: {descent_factor: And(...)}.
    closed : LambertW or exp
        What the closed forms are written with.
    """
    slopes = {primitive: _proved_slope(fact) for primitive, fact in facts.items()}
    value, slope = first_order(expr, force, slopes)
    form = expr.replace(lambda e: e.func in facts, lambda e: e.rewrite(closed))
    return limits_at_zero(form, force, value, slope)


def _proved_slope(fact):
    """The derivative of a primitive P at 0, from its limit along P(x) or, told by exp(-x), along P(-x)."""
    told = next(e for e in fact.args if e.lhs.has(sp.Derivative))
    toward = -1 if told.lhs.has(sp.exp) and not told.lhs.has(sp.LambertW) else 1
    return toward * told.rhs
