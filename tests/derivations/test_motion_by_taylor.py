"""Closed forms of motion against their laws: integrated step by step with bounded remainders, at 45 digits."""

import mpmath
import pytest
import sympy as sp
from sympy import And, Rational, sqrt

from galileo_sym.derivations.chord.notation import g as g_chord
from galileo_sym.derivations.chord.notation import gamma, mu, s
from galileo_sym.derivations.chord.notation import t as t_chord
from galileo_sym.derivations.chord.notation import theta as theta_chord
from galileo_sym.derivations.projectile.notation import g, k, t, theta, v, x, y
from galileo_sym.tactics import start_of
from galileo_sym.tactics.taylor_steps import taylor_integrate

pytestmark = pytest.mark.xdist_group("motion by taylor")

DIGITS = 45
BEAD, CHORD = s(t_chord), "chord.setup"
X, Y, SHOT = x(t), y(t), "projectile.setup"

# law, where its initial values are, the unknown, the closed form, and that of the velocity if it is printed
CLOSED = {
    "eq1": ("chord.law.frictionless", CHORD, BEAD, "chord.eq1", None),
    "eq15": ("chord.eq12", CHORD, BEAD, "chord.eq15", None),
    "eq15, theta < 0": ("chord.eq14", CHORD, BEAD, "beyond.taylor.chord.eq15.left", None),
    "eq29": ("chord.eq28", CHORD, BEAD, "chord.eq29", None),
    "eq41": ("chord.eq40", CHORD, BEAD, "chord.eq41", None),
    "eq41, theta < 0": ("chord.claim.negative-theta-sign", CHORD, BEAD, "chord.claim.negative-theta-sign", None),
    "x": ("projectile.law.nodrag.x", SHOT, X, "projectile.nodrag.x", None),
    "y": ("projectile.law.nodrag.y", SHOT, Y, "projectile.nodrag.y", None),
    "x with drag": ("projectile.law.drag.x", SHOT, X, "projectile.drag.x", "projectile.drag.vx"),
    "y with drag": ("projectile.law.drag.y", SHOT, Y, "projectile.drag.y", "projectile.drag.vy"),
}
TIMES = [Rational(1, 7), 1, Rational(5, 2)]
# g, drag, friction, launch speed, |angle|: moderate, hardly any drag, and stiff (drag times the last time is 50)
SETS = {
    "moderate": (Rational(981, 100), Rational(3, 4), Rational(1, 5), 7, Rational(3, 5)),
    "small drag": (sqrt(2), Rational(1, 10**6), Rational(1, 3), Rational(1, 9), Rational(1, 50)),
    "stiff": (Rational(981, 100), 20, Rational(1, 2), 50, Rational(11, 10)),
}


def _part(statement, wanted):
    return next(e for e in (statement.args if isinstance(statement, And) else (statement,)) if wanted(e))


def _values(name, unknown, closed):
    gravity, drag, friction, speed, angle = SETS[name]
    if unknown != BEAD:
        return {g: gravity, k: drag, v: speed, theta: angle}
    return {g_chord: gravity, gamma: drag, mu: friction, theta_chord: -angle if "0" in closed else angle}


def _integrated(ledger, closed, values, digits=DIGITS):
    law, setup, unknown, *_ = CLOSED[closed]
    equation = _part(ledger[law].printed, lambda e: e.has(unknown.diff(unknown.args[0], 2)))
    start = start_of(ledger[setup].printed.args, unknown)
    return taylor_integrate(equation, unknown, start, values, TIMES, digits)


def _exact(expression, values, time):
    return mpmath.mpf(sp.N(expression.subs(values).subs(time), DIGITS + 60)._mpf_)


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize("closed", CLOSED)
def test_the_closed_form_lies_in_the_enclosures(ledger, closed, name):
    *_, unknown, place, velocity = CLOSED[closed]
    clock = unknown.args[0]
    values = _values(name, unknown, closed)
    path = _part(ledger[place].printed, lambda e: e.lhs == unknown).rhs
    speed = ledger[velocity].printed.rhs if velocity else sp.diff(path, clock)
    for time, state in zip(TIMES, _integrated(ledger, closed, values), strict=True):
        with mpmath.workdps(DIGITS + 60):
            for expression, enclosure in zip((path, speed), state, strict=True):
                exact = _exact(expression, values, {clock: time})
                assert exact in enclosure
                assert mpmath.mpf(enclosure.delta) <= abs(exact) * mpmath.mpf(10) ** -DIGITS


WRONG = {
    "eq29": lambda path: path.subs(gamma, gamma * (1 + Rational(1, 10**40))),
    "eq41": lambda path: path.subs(mu, -mu),
    "y with drag": lambda path: path + Rational(1, 10**40),
    "x with drag": lambda path: path.subs(k, k + Rational(1, 10**40)),
}


@pytest.mark.parametrize("closed", WRONG)
def test_a_closed_form_that_is_wrong_in_the_40th_digit_does_not(ledger, closed):
    *_, unknown, place, _ = CLOSED[closed]
    values = _values("moderate", unknown, closed)
    path = WRONG[closed](ledger[place].printed.rhs)
    time, state = TIMES[1], _integrated(ledger, closed, values)[1]
    with mpmath.workdps(DIGITS + 60):
        assert _exact(path, values, {unknown.args[0]: time}) not in state[0]


def test_a_law_with_another_sign_is_noticed(ledger):
    law, setup, unknown, place, _ = CLOSED["y with drag"]
    equation = ledger[law].printed.subs(k, -k)
    values = _values("moderate", unknown, "y with drag")
    start = start_of(ledger[setup].printed.args, unknown)
    (state,) = taylor_integrate(equation, unknown, start, values, TIMES[:1], DIGITS)
    with mpmath.workdps(DIGITS + 60):
        assert _exact(ledger[place].printed.rhs, values, {t: TIMES[0]}) not in state[0]


def test_the_series_is_an_independent_derivation(ledger):
    """Every printed closed form stands again among the entries derived by series, from the law and the start alone."""
    again = {e.printed for e in ledger.values() if e.id.startswith("beyond.taylor.")}
    for _, _, _, *printed in CLOSED.values():
        for identifier in filter(None, printed):
            statement = ledger[identifier].printed
            assert any(_same(e, f) for e in again for f in sp.And.make_args(statement)), identifier


def test_no_closed_form_is_a_premise_of_its_series(ledger):
    closed = {i for _, _, _, *printed in CLOSED.values() for i in printed} - {"chord.claim.negative-theta-sign"}
    for e in ledger.values():
        assert not (e.id.startswith("beyond.taylor.") and closed & set(e.premises))


def _same(one, other):
    return one.lhs == other.lhs and sp.simplify(one.rhs - other.rhs) == 0
