"""Bounds of the rounding error: above what happens, close to it, and larger or refused where the C is spoiled."""

import random
from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace

import pytest
from kernels_of_one import kernels_of, spoiled

from galileo_sym.verify.proof import rounding
from galileo_sym.verify.proof.binary64 import LARGEST, RN, Overflow, ulp
from galileo_sym.verify.proof.dispatch import primitives
from galileo_sym.verify.proof.emitted import Call, Name, RefusedSource, parse
from galileo_sym.verify.proof.expansion import Expansion, Symbols
from galileo_sym.verify.proof.pieces import NEAR, PAIR, pieces
from galileo_sym.verify.proof.replay import Replay, Unproved, given

NAME = "descent_factor"
TEXT = kernels_of(NAME)
PHI2M = kernels_of("phi2m")
CLOSE = 8

# each operation on exact rationals, rounded as binary64: an evaluator that shares nothing with the replay
ROUNDED = {
    "gs_add": lambda a, b: RN(a + b),
    "gs_sub": lambda a, b: RN(a - b),
    "gs_mul": lambda a, b: RN(a * b),
    "gs_div": lambda a, b: RN(a / b),
    "gs_fma": lambda a, b, c: RN(a * b + c),
    "gs_fnma": lambda a, b, c: RN(c - a * b),
    "gs_min": min,
    "gs_rest": lambda a, b, s: RN(RN(a - s) + b),
    "gs_product_rest": lambda a, b, p: RN(a * b - p),
}


def run(function, tables, index, **values):
    """Run a function in binary64; returns (hi, lo), lo being 0 where there is none."""

    def value(expression):
        if isinstance(expression, Name):
            return values[expression.name]
        first = expression.arguments[0]
        if expression.operation == "gs_v_of":
            return first.value
        if expression.operation == "gs_pick":
            return tables[first.name][index]
        return ROUNDED[expression.operation](*map(value, expression.arguments))

    for name, expression in function.statements:
        if not (isinstance(expression, Call) and expression.operation == "gs_piece"):
            values[name] = value(expression)
    return value(function.returned), values.get("lo", Fraction(0))


def horner(piece, x):
    total = Fraction(0)
    for coefficient in reversed(piece.coefficients):
        total = total * (x - piece.centre) + coefficient
    return total


@pytest.mark.parametrize("suffix", [NEAR, PAIR])
def test_the_bound_is_above_what_happens_and_close_to_it(suffix):
    emitted, draw, ratios = parse(TEXT), random.Random(3), []
    function = emitted.functions[f"gs_{NAME}{suffix}"]
    for piece, bound in zip(pieces(emitted, NAME, suffix), rounding.near(emitted, NAME, suffix), strict=True):
        errors = []
        for _ in range(40):
            x = RN(piece.lower + ulp(piece.upper) + (piece.upper - piece.lower) * Fraction(draw.random()))
            x = min(x, RN(piece.upper) - ulp(piece.upper))
            x_lo = RN(ulp(x) * Fraction(draw.uniform(-0.5, 0.5))) if suffix == PAIR else Fraction(0)
            hi, lo = run(function, emitted.tables, piece.index, x=x, x_lo=x_lo)
            errors.append(abs(hi + lo - horner(piece, x + x_lo)))
            assert hi == RN(hi + lo)
            assert abs(hi - horner(piece, x + x_lo)) <= bound.value + ulp(hi) / 2
        assert max(errors) <= bound.pair
        ratios.append(bound.pair / max(errors))
    assert max(ratios) < CLOSE


@pytest.mark.parametrize("name", ["descent_factor", "phi1m", "phi2m", "flight_factor"])
def test_the_bound_of_the_far_form_is_above_what_happens(name):
    emitted, draw = parse(kernels_of(name)), random.Random(4)
    function = emitted.functions[f"gs_{name}_far"]
    found = rounding.far(emitted, name, primitives(emitted)[name].far_from)
    assert found[0].lower == primitives(emitted)[name].far_from
    assert found[-1].upper == LARGEST
    assert all(a.upper == b.lower for a, b in pairwise(found))
    for bound in [*found[:8], *draw.sample(found, 20), *found[-8:]]:
        for _ in range(20):
            x = RN(bound.lower + (bound.upper - bound.lower) * Fraction(draw.random()))
            hi, _ = run(function, {}, 0, x=x)
            exact = sum(coefficient * x**power for power, coefficient in bound.terms.items())
            assert bound.least <= exact <= bound.largest
            assert abs(hi - exact) <= bound.pair <= bound.value + bound.last * ulp(exact)
            assert abs(hi - exact) <= bound.value + (ulp(hi) / 2 if bound.last else 0)


def totals(text, name=NAME, suffix=PAIR):
    """The rounding errors of every piece, in ulps, and those of the pair."""
    found = rounding.near(parse(text), name, suffix)
    return [bound.value / ulp(bound.least) for bound in found], [bound.pair for bound in found]


SAME = totals(TEXT)


def noticed(text):
    """Whether on some piece the bound rises by a hundredth of an ulp, or that of the pair twofold."""
    values, pairs = totals(text)
    risen = any(new > old + Fraction(1, 100) for new, old in zip(values, SAME[0], strict=True))
    return risen or any(new > 2 * old for new, old in zip(pairs, SAME[1], strict=True))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("gs_fma(d, t_lo, p_rest)", "gs_add(p_rest, gs_v_of(0x0p+0))"),  # the correction of t dropped
        ("gs_add(t_rest, gs_pick(gs_descent_factor_c1_lo, i))", "gs_pick(gs_descent_factor_c1_lo, i)"),
        ("gs_add(t_rest, gs_pick(gs_descent_factor_c1_lo, i))", "gs_add(t_rest, gs_v_of(0x0p+0))"),
        ("gs_add(p_all, gs_pick(gs_descent_factor_c0_lo, i))", "p_all"),
        ("gs_add(s_rest, s_lo)", "s_lo"),
        ("gs_product_rest(d, t, p)", "gs_sub(gs_mul(d, t), p)"),  # the fma as a product and a sum
        ("gs_fma(q3, d, gs_pick(gs_descent_factor_c2, i))", "gs_add(gs_mul(q3, gs_v_of(0x1p+0)), q3)"),
        ("gs_fma(q4, d, gs_pick(gs_descent_factor_c3, i))", "gs_fma(q4, d, gs_pick(gs_descent_factor_c4, i))"),
        ("gs_pick(gs_descent_factor_c12, i)", "gs_pick(gs_descent_factor_c11, i)"),
        ("gs_fma(x_lo, slope, p_lo)", "gs_add(gs_v_of(0x0p+0), p_lo)"),  # the low part of x ignored
        ("gs_fma(x_lo, slope, p_lo)", "gs_fma(x_lo, h, p_lo)"),
        ("(s, e, r);\n    return r;", "(s, e, r);\n    return s;"),
    ],
)
def test_a_spoiled_operation_raises_the_bound(old, new):
    assert noticed(spoiled(TEXT, old, new))


def test_a_fused_step_taken_apart_raises_the_bound():
    apart = "gs_add(gs_mul(q3, d), gs_pick(gs_descent_factor_c2, i))"
    values, _ = totals(spoiled(TEXT, "gs_fma(q3, d, gs_pick(gs_descent_factor_c2, i))", apart))
    assert all(new > old for new, old in zip(values, SAME[0], strict=True))


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("gs_rest(c1, h, t)", "gs_rest(h, c1, t)", "gs_rest needs abs a >= abs b"),
        ("gs_rest(c0, p, s)", "gs_rest(p, c0, s)", "gs_rest needs abs a >= abs b"),
        ("gs_rest(s, e, r)", "gs_rest(e, s, r)", "gs_rest needs abs a >= abs b"),
        ("gs_rest(c0, p, s)", "gs_rest(c0, p, t)", "not the rounded sum"),
        ("gs_rest(c0, p, s)", "gs_rest(c0, h, s)", "not the rounded sum"),
        ("gs_add(c0, p)", "gs_sub(c0, p)", "not the rounded sum"),
        ("gs_product_rest(d, t, p)", "gs_product_rest(d, h, p)", "not the rounded product"),
        ("gs_product_rest(d, t, p)", "gs_product_rest(d, t, t)", "not the rounded product"),
        ("gs_mul(q2, d)", "gs_div(q2, d)", "not one exact term away from 0"),
        ("gs_mul(q2, d)", "gs_min(q2, d)", "which operand of gs_min is smaller"),
        ("gs_pick(gs_descent_factor_c2, i)", "gs_pick(gs_descent_factor_c2, u)", "gs_pick of no constant"),
        ("0x1.8000000000000p-3, 0x1.4000000000000p-2", "0x1.999999999999ap-5, 0x1.4p-2", "piece 1: x - centre is not"),
    ],
)
def test_a_side_condition_that_fails_is_an_error(old, new, why):
    with pytest.raises(Unproved, match=why):
        totals(spoiled(TEXT, old, new))


def test_a_difference_is_exact_within_a_factor_of_two_only():
    """Sterbenz: centre/2 <= x <= 2 centre; where x may be less, its difference from the centre may be rounded."""
    digits = Fraction(1, 2**60)
    for lower, exact in ((Fraction(1, 2), True), (Fraction(1, 2) - digits, False)):
        symbols = Symbols(lower - 1, Fraction(1))
        x = given(Expansion.of(Fraction(1)) + Expansion.argument(), digits)
        difference = Replay.sub(
            SimpleNamespace(symbols=symbols, _sum=lambda *_: None), x, given(Expansion.of(Fraction(1)))
        )
        assert (difference is not None) == exact


def test_an_operation_that_may_overflow_is_an_error():
    with pytest.raises(Overflow):
        totals(spoiled(TEXT, "gs_mul(q2, d)", "gs_mul(gs_mul(q2, gs_v_of(0x1p+1023)), gs_v_of(0x1p+10))"))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("gs_fnma(y, finite, gs_v_of(0x1.0000000000000p+0))", "gs_sub(y, y)"),  # the division's rest dropped
        ("gs_fma(less, y, y)", "gs_add(gs_mul(less, gs_v_of(0x1p+0)), y)"),
    ],
)
def test_a_spoiled_far_form_raises_the_bound_or_is_another_form(old, new):
    emitted, other = parse(PHI2M), parse(spoiled(PHI2M, old, new))
    first = LARGEST / 2**60  # the last binades: all errors are there
    bounds = [rounding.far(c, "phi2m", first) for c in (emitted, other)]
    before, after = (max(bound.value / ulp(bound.least) for bound in found) for found in bounds)
    assert after > before + Fraction(1, 4) or bounds[0][0].terms != bounds[1][0].terms


def test_a_parameter_that_is_not_known_is_refused():
    with pytest.raises(RefusedSource, match="takes x, y"):
        totals(TEXT.replace("gs_v x_lo", "gs_v y").replace("x_lo", "y"))


def test_expansions_cancel_exactly_and_are_bounded_from_both_sides():
    symbols = Symbols(Fraction(-1), Fraction(3))
    d, error = Expansion.argument(), symbols.fresh(Fraction(1, 8))
    total = (d + error) * (d - error) + error * error
    assert total.terms == (d * d).terms
    assert symbols.range(total) == (0, 9)
    assert symbols.range(d + error + error) == (-1 - Fraction(1, 4), 3 + Fraction(1, 4))
    assert symbols.least(total + Expansion.of(Fraction(2))) == 2
    assert symbols.least(d) == 0
    assert (d * d * Expansion.of(Fraction(4))).inverse().powers() == {-2: Fraction(1, 4)}
    assert (d + error).inverse() is None
