"""The projectile chapters: every entry proved, errata refuted, and false variants of the results recognised."""

import pytest
import sympy as sp
from sympy import E, Eq, LambertW, Ne, Piecewise, asin, exp

from galileo_sym.ledger import Kind, Ledger, tell
from galileo_sym.ledger.inventory import inventory

pytestmark = pytest.mark.xdist_group("projectile")  # what one entry derives, the next need not

ENTRIES = {entry.id: entry for entry in Ledger.load().select(["projectile"])}
IDS = list(ENTRIES)

a, b, c, d, t = sp.symbols("a b c d t")
alpha, theta_max = sp.symbols("alpha theta_max")
W_a = LambertW((alpha**2 - 1) / E)
Q = c * d * exp(-b * d / a) / a


def _sound(entry):
    kind = entry.verdict.kind
    return kind is Kind.PROVED if entry.declaration.function else kind.value == entry.kind


@pytest.mark.parametrize("identifier", IDS)
def test_entry_is_proved(ledger, identifier):
    entry = ledger[identifier]
    assert _sound(entry), tell(entry)


@pytest.mark.parametrize("identifier", [i for i in IDS if ENTRIES[i].declaration.item.errata])
def test_erratum_is_recorded_and_the_print_refuted(ledger, identifier):
    entry = ledger[identifier]
    assert entry.erratum is not None
    assert entry.erratum.ids == entry.declaration.item.errata
    if entry.erratum.printed is not None:
        assert entry.erratum_verdict.kind is Kind.REFUTED
        assert entry.erratum_verdict.counterexample


@pytest.mark.parametrize("identifier", ["projectile.res3", "projectile.thm3", "projectile.impact.time"])
def test_steps_are_told(ledger, identifier):
    assert len(ledger[identifier].steps) >= 3


def test_every_other_statement_of_the_paper_is_there():
    wanted = {i for i in inventory() if i.startswith("projectile.") and not i.startswith("projectile.fig")}
    assert wanted <= set(IDS)


CASE_1 = asin(1 / (E - 1))


def _theorem(general, special=CASE_1):
    return Eq(theta_max, Piecewise((general, Ne(alpha, 1)), (special, True)))


SAME = {
    "result 3, multiplied by d": ("projectile.res3", Eq(d * t + d * b / a, -LambertW(Q))),
    "result 3, as text": ("projectile.res3", "Eq(t, -b/a - W(c*d*exp(-b*d/a)/a)/d)"),
    "theorem 3, as printed": ("projectile.thm3", _theorem(asin(alpha * W_a / (alpha**2 - 1 - W_a)))),
    "theorem 3, divided by W": ("projectile.thm3", _theorem(asin(alpha / ((alpha**2 - 1) / W_a - 1)))),
    "theorem 3, by e^(1 + W)": ("projectile.thm3", _theorem(asin(alpha / (exp(1 + W_a) - 1)))),
    "impact time, in two terms": ("projectile.impact.time", "Eq(t, W(u*exp(u))/k - u/k)"),
}  # fmt: skip

W_plus, W_other = LambertW((alpha**2 + 1) / E), LambertW((alpha**2 - 1) / E, -1)
FALSE = {
    "result 3, sign of d": ("projectile.res3", Eq(t, -b / a + LambertW(-c * d * exp(b * d / a) / a) / d)),
    "result 3, sign of W": ("projectile.res3", Eq(t, -b / a + LambertW(Q) / d)),
    "result 3, other branch": ("projectile.res3", Eq(t, -b / a - LambertW(Q, -1) / d)),
    "result 3, without exponential": ("projectile.res3", Eq(t, -b / a - LambertW(c * d / a) / d)),
    "theorem 3, alpha^2 + 1": ("projectile.thm3", _theorem(asin(alpha * W_plus / (alpha**2 + 1 - W_plus)))),
    "theorem 3, alpha^2 + 1 outside W": ("projectile.thm3", _theorem(asin(alpha * W_a / (alpha**2 + 1 - W_a)))),
    "theorem 3, alpha^2 + 1 inside W": ("projectile.thm3", _theorem(asin(alpha * W_plus / (alpha**2 - 1 - W_plus)))),
    "theorem 3, other branch": ("projectile.thm3", _theorem(asin(alpha * W_other / (alpha**2 - 1 - W_other)))),
    "theorem 3, case 1": ("projectile.thm3", _theorem(asin(alpha * W_a / (alpha**2 - 1 - W_a)), asin(1 / (E + 1)))),
    "impact time, other branch": ("projectile.impact.time", "Eq(t, (-u + LambertW(u*exp(u), -1))/k)"),
    "height, gravity upwards": (
        "projectile.drag.y",
        "Eq(y(t), (k*t*g - g + k*v*sin(theta) - exp(-k*t)*(k*v*sin(theta) - g))/k**2)",
    ),
    "lemma (f), cosine alone": (
        "projectile.lemma.f",
        "Eq(Derivative(R(k, theta), theta), -v/k*sin(theta)*(1 - y(u)/u)*(1 + Derivative(y(u), u)*cos(theta)))",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("identifier", "statement"), SAME.values(), ids=SAME)
def test_rearranged_statement_is_proved(ledger, identifier, statement):
    assert ledger[identifier].compare(statement).kind is Kind.PROVED


@pytest.mark.parametrize(("identifier", "statement"), FALSE.values(), ids=FALSE)
def test_false_variant_is_refuted_with_a_counterexample(ledger, identifier, statement):
    verdict = ledger[identifier].compare(statement)
    assert verdict.kind is Kind.REFUTED
    assert verdict.counterexample


def test_second_root_of_result_3_is_told(ledger):
    told = [step.statement for step in ledger["projectile.res3"].steps]
    roots = [s for s in told if isinstance(s, sp.Implies) and any(len(w.args) == 2 for w in s.atoms(LambertW))]
    assert len(roots) == 1
