"""Theorem 1 and the limits for small resistance, against root finding and the closed form at 60 digits and more."""

import mpmath
import pytest
import sympy as sp
from mpmath import mp
from sympy import Implies, LambertW, Limit, Piecewise, exp

from galileo_sym.derivations.projectile import analytic_notation as theorem
from galileo_sym.ledger import DerivationError, ForAll, Kind
from galileo_sym.ledger.local import HoldsBeside
from galileo_sym.ledger.numeric import holds
from galileo_sym.tactics import entire_series, modus_ponens, said_of

pytestmark = pytest.mark.xdist_group("projectile")

# f, the place of its extremum, and its order there
FUNCTIONS = {
    "cosine and a cube": (lambda x: mp.cos(x) + x**3, 0, 2),
    "rational": (lambda x: x**2 / (1 - x), 0, 2),
    "cosh of order 4": (lambda x: 3 * mp.cosh(x) - 3 * x**2 / 2 - x**5, 0, 4),
    "x^4 e^x": (lambda x: 1 - x**4 * mp.exp(x), 0, 4),
    "order 6 about 1": (lambda x: (x - 1) ** 6 * (2 + mp.sin(x)), 1, 6),
}


def _reflection(f, place, x):
    """y > place with f(y) = f(x), by bisection: f is monotone there."""
    guess = (place + (place - x) * mp.mpf("0.9"), place + (place - x) * mp.mpf("1.1"))
    return mp.findroot(lambda y: f(y) - f(x), guess, solver="anderson", tol=mp.mpf(10) ** -180)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_theorem_1_and_the_next_coefficient(ledger, name):
    f, place, order = FUNCTIONS[name]
    with mp.workdps(200):
        coefficients = mp.taylor(f, place, order + 1)
        step = mp.mpf(10) ** -8
        turn = (_reflection(f, place, place - step) - place) / -step
    values = {theorem.a(order): coefficients[order], theorem.a(order + 1): coefficients[order + 1]}
    assert all(abs(c) < 1e-40 for c in coefficients[1:order])
    assert abs(coefficients[order]) > 1e-3
    first = next(e for e in sp.And.make_args(ledger["projectile.thm1"].result.args[1]) if e.has(Limit)).rhs
    second = ledger["beyond.thm1.next-coefficient"].result.rhs.subs(theorem.N, order).subs(values)
    assert abs(turn - first) < 1e-7
    assert abs((turn - first) / -step - second) < 1e-6


def test_an_inflexion_is_outside_the_theorem(ledger):
    w, q = sp.symbols("w q", real=True)
    cube = {theorem.f(w): w**3 * exp(w), theorem.g(q): q, theorem.y(w): w}
    cube[theorem.a(theorem.i)] = entire_series(w**3 * exp(w), w, 0, theorem.i).args[3]
    told = said_of(ledger["projectile.thm1"].result, cube, {theorem.x_0: sp.S.Zero, theorem.x: w, theorem.N: 3})
    extremum = next(e for e in told.args[0].args if type(e) is theorem.LocalExtremum)
    assert not holds(extremum, {})
    with pytest.raises(DerivationError, match="LocalExtremum"):
        modus_ponens(told, [e for e in told.args[0].args if e != extremum])


@pytest.mark.parametrize(
    ("inverse", "turn", "supposed", "concluded"),
    [
        (sp.sqrt, lambda w: -w, True, True),
        (lambda q: -sp.sqrt(q), lambda w: w, False, False),  # undoes f on the other side
        (lambda q: sp.sqrt(q) * (1 + q * (1 - 4 * q)), lambda w: -w, False, True),  # undoes f at 0 and 1/2 alone
        (sp.sqrt, lambda w: -2 * w, False, False),
    ],
)
def test_the_hypotheses_are_about_every_value(ledger, inverse, turn, supposed, concluded):
    w = sp.Symbol("w", real=True)
    parabola = {theorem.f(w): w**2, theorem.g(theorem.q): inverse(theorem.q), theorem.y(w): turn(w)}
    parabola[theorem.a(theorem.i)] = sp.KroneckerDelta(theorem.i, 2)
    numbers = {theorem.x_0: sp.S.Zero, theorem.N: sp.Integer(2), theorem.h: sp.S.Half}
    told = said_of(ledger["projectile.thm1"].result, parabola, {theorem.x: w, **numbers})
    hypotheses, conclusion = told.args
    general = [e for e in hypotheses.args if isinstance(e, ForAll) and not e.has(sp.Sum)]
    assert all(holds(e, {}) for e in general) is supposed
    returns = next(e for e in conclusion.args if isinstance(e, HoldsBeside))
    assert holds(returns, {}) is concluded


def test_the_order_of_an_inflexion_is_odd(ledger):
    """The implication is about every order: for an odd one its hypothesis fails, the conclusion too."""
    even = ledger["projectile.thm1.N-even"]
    extremum, parity = even.result.args
    w = sp.Symbol("w", real=True)
    for order in (1, 2, 3, 4):
        claim = said_of(extremum, {theorem.f(w): w**order * exp(w)}, {theorem.x: w, theorem.x_0: sp.S.Zero})
        assert holds(claim, {}) == holds(parity, {theorem.N: sp.Integer(order)}) == (order % 2 == 0)


def test_a_corner_has_another_limit():
    """f = -x before 0 and 2x behind has y = -x/2, but no power series: the theorem does not apply."""
    w = sp.Symbol("w", real=True)
    corner = Piecewise((-w, w < 0), (2 * w, True))
    series = sp.Eq(corner, sp.Sum(theorem.a(theorem.i) * w**theorem.i, (theorem.i, 0, sp.oo)))
    with pytest.raises(DerivationError):
        entire_series(corner, w, 0, theorem.i)
    with pytest.raises(DerivationError):
        modus_ponens(Implies(series, theorem.EXTREMUM), [theorem.EXTREMUM])


@pytest.mark.parametrize("name", ["projectile.thm1.cor", "projectile.limit.value2", "projectile.mathematica.limit"])
def test_limits_at_minus_1_which_sympy_gets_wrong(ledger, name):
    limit, value = ledger[name].result.args
    ratio, u, *_ = limit.args
    assert ratio.has(LambertW)
    with mp.workdps(60):
        place = -1 - mp.mpf(10) ** -20
        w = mp.lambertw(place * mp.exp(place)).real
        near = {"projectile.thm1.cor": (w + 1) / (place + 1)}.get(name, (w - place) / (place * (place + 1)))
    assert abs(near - value) < 1e-15
    assert sp.limit(ratio, u, -1, "-").is_infinite  # wrong, and why no limit here goes through LambertW


def _range(k, theta):
    v, g = 50, mp.mpf(161) / 5
    u = -1 - k * v * mp.sin(theta) / g
    return v * mp.cos(theta) / k * (1 - mp.lambertw(u * mp.exp(u)).real / u)


@pytest.mark.parametrize("theta", ["0", "3/10", "11/10", "pi/2"])
def test_range_without_resistance(ledger, theta):
    entry = ledger["projectile.limit.nodrag"]
    symbols = entry.declaration.notation.symbols
    point = {symbols["v"]: 50, symbols["g"]: sp.Rational(161, 5), symbols["theta"]: sp.sympify(theta)}
    with mp.workdps(160):
        near = _range(mp.mpf(10) ** -25, mpmath.mpf(sp.N(sp.sympify(theta), 160)))
        assert abs(near - sp.N(entry.result.rhs.subs(point), 40)) < 1e-18
    assert holds(entry.assumptions, {**point, symbols["k"]: sp.S.One})


def test_slope_at_0_for_every_k(ledger):
    entry = ledger["projectile.support.slope-at-0"]
    symbols = entry.declaration.notation.symbols
    value = entry.result.rhs.subs({symbols["v"]: 50, symbols["g"]: sp.Rational(161, 5)})
    with mp.workdps(120):
        step = mp.mpf(10) ** -25
        for k in ("0.01", "0.5", "20"):
            assert abs(_range(mp.mpf(k), step) / step - sp.N(value, 40)) < 1e-18


def test_level_shots_are_left_out_where_the_print_divides_by_0(ledger):
    for name in ("projectile.limit.inv-k", "projectile.limit.range-rewrite"):
        assert ledger[name].erratum_verdict.kind is Kind.REFUTED
