"""Other statements held against the derived ones: what differs is refuted at a point that shows it."""

import pytest
import sympy as sp
from sympy import Eq, LambertW, cos, exp, sin, sqrt, tan

from galileo_sym.derivations.chord.notation import D, R, X, Y, g, gamma, mu, s, t, t_AB, theta, x, y
from galileo_sym.ledger import Kind
from galileo_sym.tactics import other_branch

pytestmark = pytest.mark.xdist_group("compare")

K = g * t**2 / 4


def circle(sign, k=K, growth=1 + mu**2):
    return Eq((x + sign * mu * k) ** 2 + (y - k) ** 2, k**2 * growth)


def _numbers(verdict):
    return {name: sp.Float(value) for name, value in verdict.counterexample.items()}


@pytest.mark.parametrize(("identifier", "sign"), [("chord.eq21", 1), ("chord.eq24", -1)])
def test_a_changed_sign_of_mu_is_refuted_where_the_bead_is(ledger, identifier, sign):
    """The counterexample lies on the derived circle, and off the other one: computed here by hand."""
    verdict = ledger[identifier].compare(circle(-sign))
    assert verdict.kind is Kind.REFUTED
    v = _numbers(verdict)
    k = v["g"] * v["t"] ** 2 / 4
    size = k**2 * (1 + v["mu"] ** 2)
    right, wrong = ((v["x"] + side * v["mu"] * k) ** 2 + (v["y"] - k) ** 2 - size for side in (sign, -sign))
    assert abs(right) < 1e-9 * size
    assert abs(wrong) > 1e-7 * size


def _negated(equation):
    return Eq(equation.lhs, -equation.rhs, evaluate=False)


def _doubled(equation):
    return Eq(equation.lhs, 2 * equation.rhs, evaluate=False)


def _higher(equation):
    return Eq(equation.lhs, equation.rhs * (1 + mu if equation.has(mu) else sp.Rational(3, 2)), evaluate=False)


def _nearly(equation):
    return Eq(equation.lhs, equation.rhs * (1 + sp.Rational(1, 10**30)), evaluate=False)


SAMPLES = ("eq1", "eq4", "eq9", "eq11", "eq12", "eq15", "eq17", "eq18", "eq21", "eq22", "eq24", "eq26", "eq27")
SAMPLES += ("eq29", "eq30", "eq31", "eq32", "eq36", "eq40", "eq41", "eq42", "eq43", "eq45", "eq46", "eq47")
CHANGES = {"negated": _negated, "doubled": _doubled, "rescaled": _higher, "in digit 30": _nearly}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
@pytest.mark.parametrize("number", SAMPLES)
def test_a_changed_side_is_refuted(ledger, number, change):
    entry = ledger[f"chord.{number}"]
    verdict = entry.compare(change(entry.printed))
    assert verdict.kind is Kind.REFUTED
    assert verdict.counterexample


WRONG = {
    "t^3 in (1)": ("eq1", Eq(s(t), g * t**3 / 2 * cos(theta))),
    "sine in (1)": ("eq1", Eq(s(t), g * t**2 / 2 * sin(theta))),
    "theta halved in (9)": ("eq9", Eq(x**2 + (y - K / 2) ** 2, (K / 2) ** 2)),
    "y swapped with x in (9)": ("eq9", Eq(y**2 + (x - K) ** 2, K**2)),
    "sine and cosine swapped in (12)": ("eq12", Eq(s(t).diff(t, 2), g * (sin(theta) - mu * cos(theta)))),
    "first derivative in (12)": ("eq12", Eq(s(t).diff(t), g * (cos(theta) - mu * sin(theta)))),
    "(14) for (12)": ("eq12", Eq(s(t).diff(t, 2), g * (cos(theta) + mu * sin(theta)))),
    "(18) for (17)": ("eq17", Eq(t_AB, sqrt((2 * D / g) / (1 + mu * tan(theta))))),
    "no root in (17)": ("eq17", Eq(t_AB, (2 * D / g) / (1 - mu * tan(theta)))),
    "sine for tangent in (17)": ("eq17", Eq(t_AB, sqrt((2 * D / g) / (1 - mu * sin(theta))))),
    "(9) for (21)": ("eq21", Eq(x**2 + (y - K) ** 2, K**2)),
    "mu not squared in (21)": ("eq21", circle(1, growth=1 + mu)),
    "depth with t in (21)": ("eq21", circle(1, k=g * t**3 / 4)),
    "mu not squared in (22)": ("eq22", Eq(R(t), K * sqrt(1 + mu))),
    "sign of the drag in (29)": ("eq29", Eq(s(t), (g / gamma * t - g / gamma**2 * (1 - exp(gamma * t))) * cos(theta))),
    "gamma not squared in (29)": ("eq29", Eq(s(t), (g / gamma * t - g / gamma * (1 - exp(-gamma * t))) * cos(theta))),
    "W_(-1) in (36)": ("eq36", other_branch),
    "gamma not squared in (36)": (
        "eq36",
        Eq(t_AB, 1 / gamma + gamma * D / g + LambertW(-exp(-1 - gamma * D / g)) / gamma),
    ),
    "no e^-1 in (36)": (
        "eq36",
        Eq(t_AB, 1 / gamma + gamma * D / g + LambertW(-exp(-(gamma**2) * D / g)) / gamma),
    ),
    "W_(-1) in (43)": ("eq43", other_branch),
    "1 + mu tan in (43)": ("eq43", lambda printed: printed.subs(mu, -mu)),
    "free fall for (45)": ("eq45", Eq(Y(t), K)),
    "mu^2 in (46)": ("eq46", Eq(X(t), mu**2 * Y(t))),
    "1 - mu^2 in (47)": ("eq47", Eq(R(t), sqrt(1 + mu**3) * Y(t))),
    "monotony swapped": (
        "claim.F-monotone",
        lambda printed: sp.And(*(p.func(-p.args[0], *p.args[1:]) for p in printed.args)),
    ),
    "an open bound": ("claim.F-minimum", lambda printed: sp.And(*(_strict(p) for p in printed.args))),
}


def _strict(part):
    return sp.Gt(*part.args, evaluate=False) if isinstance(part, sp.GreaterThan) else part


@pytest.mark.parametrize(("number", "statement"), WRONG.values(), ids=WRONG)
def test_a_wrong_version_is_refuted(ledger, number, statement):
    entry = ledger[f"chord.{number}"]
    other = statement(entry.printed) if callable(statement) else statement
    assert other != entry.printed
    verdict = entry.compare(other)
    assert verdict.kind is Kind.REFUTED
    assert verdict.counterexample


RIGHT = {
    "(1) as a polynomial": ("eq1", Eq(2 * s(t) - g * t**2 * cos(theta), 0)),
    "(4) squared out": ("eq4", Eq(t_AB, sqrt(2) * sqrt(D) / sqrt(g))),
    "(9) expanded": ("eq9", Eq(x**2 + y**2, g * t**2 / 2 * y)),
    "(17) over the cosine": ("eq17", Eq(t_AB, sqrt(2 * D * cos(theta) / (g * (cos(theta) - mu * sin(theta)))))),
    "(21) expanded": ("eq21", Eq(2 * (x**2 + y**2), g * t**2 * (y - mu * x))),
    "(21) with sides swapped": ("eq21", Eq(K**2 * (1 + mu**2), (x + mu * K) ** 2 + (y - K) ** 2)),
    "(22) in one root": ("eq22", Eq(R(t), g / 4 * sqrt(t**4 * (1 + mu**2)))),
    "(29) over gamma^2": ("eq29", Eq(gamma**2 * s(t), g * cos(theta) * (gamma * t - 1 + exp(-gamma * t)))),
    "(36) over gamma": (
        "eq36",
        Eq(gamma * t_AB, 1 + gamma**2 * D / g + LambertW(-exp(-1) * exp(-(gamma**2) * D / g))),
    ),
    "(46) turned round": ("eq46", Eq(mu * Y(t), X(t))),
}


@pytest.mark.parametrize(("number", "statement"), RIGHT.values(), ids=RIGHT)
def test_a_true_rearrangement_is_proved(ledger, number, statement):
    assert ledger[f"chord.{number}"].compare(statement).kind is Kind.PROVED


TEXT = {
    "Eq(2*(x**2 + y**2), g*t**2*(y - mu*x))": Kind.PROVED,
    "Eq(2*(x**2 + y**2), g*t**2*(y + mu*x))": Kind.REFUTED,
}


@pytest.mark.parametrize(("text", "kind"), TEXT.items())
def test_text_is_read_in_the_notation_of_the_paper(ledger, text, kind):
    assert ledger["chord.eq21"].compare(text).kind is kind


def test_text_may_use_functions_and_w(ledger):
    text = "Eq(t_AB, 1/gamma + gamma*D/g + W(-exp(-1 - gamma**2*D/g){})/gamma)"
    assert ledger["chord.eq36"].compare(text.format("")).kind is Kind.PROVED
    assert ledger["chord.eq36"].compare(text.format(", -1")).kind is Kind.REFUTED
    assert ledger["chord.eq1"].compare("Eq(s(t), g*t**2*cos(theta)/2)").kind is Kind.PROVED


def test_symbols_are_taken_by_name(ledger):
    x, y, g, t, mu = sp.symbols("x y g t mu")
    plain = Eq(2 * (x**2 + y**2), g * t**2 * (y - mu * x))
    assert ledger["chord.eq21"].compare(plain).kind is Kind.PROVED
    assert ledger["chord.eq21"].compare(plain.subs(mu, -mu)).kind is Kind.REFUTED
    function = sp.Function("s")
    theta = sp.Symbol("theta")
    assert ledger["chord.eq1"].compare(Eq(function(t), g * t**2 / 2 * sp.cos(theta))).kind is Kind.PROVED


@pytest.mark.parametrize("number", ["eq1", "eq9", "eq12", "eq17", "eq21", "eq36", "eq43", "eq44"])
def test_an_equation_says_more_than_true(ledger, number):
    entry = ledger[f"chord.{number}"]
    assert entry.compare(sp.true).kind is Kind.REFUTED
    assert entry.compare(sp.false).kind is Kind.REFUTED


WEAKER = {
    "square of (1)": ("eq1", lambda e: Eq(e.lhs**2, e.rhs**2)),
    "bound for (1)": ("eq1", lambda e: sp.Ge(e.lhs, 0)),
    "(12) or its mirror image": ("eq12", lambda e: Eq(e.lhs**2, e.rhs**2)),
    "bound for (17)": ("eq17", lambda e: sp.Gt(e.lhs, e.rhs / 2)),
    "(4) or anything": ("eq4", lambda e: sp.Or(e, sp.Gt(t_AB, e.rhs))),
    "(10) without t": ("eq10", lambda e: sp.Ge(e.lhs, 0)),
    "(21) times a factor": ("eq21", lambda e: Eq((e.lhs - e.rhs) * (x - y), 0)),
    "(8) for (21)": ("eq21", lambda e: Eq(2 * cos(theta) ** 2, 1 + cos(2 * theta))),
    "(21) as a disc": ("eq21", lambda e: sp.Le(e.lhs, e.rhs)),
}


@pytest.mark.parametrize(("number", "weaken"), WEAKER.values(), ids=WEAKER)
def test_a_weaker_statement_is_refuted(ledger, number, weaken):
    """It follows from the derived one, and holds where that does not."""
    entry = ledger[f"chord.{number}"]
    verdict = entry.compare(weaken(entry.printed))
    assert verdict.kind is Kind.REFUTED
    assert verdict.method.startswith("the other statement holds here")


@pytest.mark.parametrize(
    "number", ["claim.W-branches", "claim.principal-branch", "claim.centre-accel", "claim.centres-radius"]
)
def test_a_part_of_a_statement_is_not_the_whole(ledger, number):
    entry = ledger[f"chord.{number}"]
    for part in entry.result.args:
        assert entry.compare(part).kind is not Kind.PROVED


@pytest.mark.parametrize("identifier", ["chord.law.friction", "chord.law.frictionless", "chord.setup", "chord.eq34"])
def test_laws_and_definitions_compare_with_themselves(ledger, identifier):
    entry = ledger[identifier]
    assert entry.verdict.kind in (Kind.LAW, Kind.DEFINITION)
    assert entry.compare(entry.printed).kind is Kind.PROVED


def test_a_law_with_a_changed_sign_is_refuted(ledger):
    assert ledger["chord.law.frictionless"].compare(Eq(s(t).diff(t, 2), -g * cos(theta))).kind is Kind.REFUTED
    assert ledger["chord.eq34"].compare("Eq(F(w), w*exp(-w))").kind is Kind.REFUTED


def test_a_stranger_is_an_error_not_a_verdict(ledger):
    verdict = ledger["chord.eq21"].compare(Eq(x, sp.Symbol("stranger")))
    assert verdict.kind is Kind.ERROR
    assert "stranger" in verdict.method
