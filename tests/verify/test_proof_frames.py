"""The frames' proof: bounds above what happens, and every part of the C that is spoiled raises one or is refused."""

import random
import re
from fractions import Fraction
from itertools import pairwise
from math import inf

import pytest
from kernels_of_one import FRAMES, frame_of, spoiled
from mpmath import mp, mpf

from galileo_sym.verify.proof import frame_points
from galileo_sym.verify.proof.binary64 import RN, Overflow, power
from galileo_sym.verify.proof.emitted import RefusedSource, parse
from galileo_sym.verify.proof.expansion import Expansion, Symbols
from galileo_sym.verify.proof.frame_banks import Banks, parts
from galileo_sym.verify.proof.frame_bounds import on_cell
from galileo_sym.verify.proof.frame_cells import Beside, Plain, beside, cut
from galileo_sym.verify.proof.frame_dispatch import frames
from galileo_sym.verify.proof.frame_reduction import Unreduced, reduced
from galileo_sym.verify.proof.pieces import Piece
from galileo_sym.verify.proof.reals import Reals, table
from galileo_sym.verify.proof.relative import error_of, folded, ratio
from galileo_sym.verify.proof.replay import Unproved

BANKS = {
    "exp_minus": (),
    "sin": ("sine",),
    "cos": ("sine",),
    "arctan": ("arctangent", "arctangent_tail"),
    "w0": ("w0_ratio", "log", "omega"),
    "wm1": ("wm1_branch", "wm1_middle", "log", "fall_factor", "fall_tail"),
    "w0_offset": ("rise_factor",),
    "wm1_offset": ("fall_factor", "log", "fall_log"),
    "best_angle": ("best_angle", "log", "omega", "omega_tail"),
    "max_range_factor": ("max_range_factor", "log", "omega"),
}
LEAST_GAIN = power(-9)  # ulp: what a spoiled line must add at least


def plain(low, high):
    return Plain(Fraction(low), Fraction(high))


def total(text, name, number, cell):
    """The proved total of one range on one cell, in ulps."""
    emitted = parse(text)
    function = emitted.functions[f"gs_{name}_range{number}"]
    if cell is None:
        served = next(s for s in frames(emitted)[name].ranges if s.function == function.name)
        cell = reduced(function, served)[-50 if number else 3]
    return on_cell(name, emitted, function, Banks(emitted), cell).total


QUARTER = Beside("pi/2", 1, Fraction(1, 2**50), Fraction(1, 2**40))
BRANCH = Beside("1/e", -1, Fraction(1, 2**40), Fraction(1, 2**39))

# a primitive, its range, where, and what is spoiled there
SPOILED = [
    ("sin", 0, plain(1.0, 1.01), "gs_fma(d, t_lo, p_rest)", "p_rest"),
    ("cos", 0, QUARTER, "gs_add(y_rest, gs_v_of(-0x1.f1976b7ed8fbcp-110))", "y_rest"),
    ("cos", 0, QUARTER, "gs_sub(y0_rest, x)", "y0_rest"),
    ("arctan", 2, plain(70, 71), "-0x1.2492492492492p-3", "-0x1.2492492492492p-2"),
    ("arctan", 2, plain(70, 71), "gs_fma(a3, square, y_rest)", "gs_mul(a3, square)"),
    ("arctan", 2, plain(70, 71), "p+100)", "p+6)"),  # the double of infinity too early
    ("exp_minus", 0, None, "gs_fma(c, h, p_rest)", "gs_mul(c, h)"),
    ("exp_minus", 0, None, "gs_fma(c_lo, t, c_lo)", "gs_mul(c_lo, t)"),
    ("exp_minus", 0, None, "0x1.cf79abc9e3b3ap-44", "0x1.cf79abd9e3b3ap-44"),
    ("exp_minus", 0, None, "0x1.5555555555555p-3", "0x1.5555555555555p-4"),
    ("exp_minus", 1, None, "gs_add(g_rest, hi_lo)", "hi_lo"),
    ("w0", 0, plain(1, 1.1), "gs_fma(x, f_lo, w_e0)", "w_e0"),
    ("w0", 0, plain(1, 1.1), "gs_sub(q_e0, delta_lo)", "q_e0"),
    ("w0", 0, BRANCH, "gs_add(sum_rest, gs_v_of(-0x1.ca8a4270fadf5p-57))", "sum_rest"),
    ("w0", 1, plain(100, 110), "gs_fma(y_k, gs_v_of(0x1.ef35793c76730p-45), y_part_lo)", "y_part_lo"),
    ("w0", 1, plain(100, 110), "gs_sum_rest(y_whole, y_part, y_s)", "gs_rest(y_part, y_whole, y_s)"),
    ("wm1", 2, plain(-0.006, -0.0055), "gs_sub(p_e0, twice_lo)", "p_e0"),
    ("wm1", 2, plain(-0.006, -0.0055), "-0x1.0000000000000p-1000", "-0x1.0000000000000p-10"),
    ("wm1", 3, plain(-1e-100, -1e-101), "gs_sub(y_k0, gs_v_of(0x1.0000000000000p+6))", "y_k0"),
    ("w0_offset", 0, plain(1, 1.1), "gs_fma(f, p_lo, w_e1)", "w_e1"),
    ("w0_offset", 0, plain(1, 1.1), "gs_pick(gs_rise_factor_c1_lo, i)", "gs_pick(gs_rise_factor_c0_lo, i)"),
    ("w0_offset", 1, plain(1e-300, 1e-299), "p-54", "p-53"),
    ("wm1_offset", 2, plain(200, 210), "gs_add(w_rest, f_lo)", "w_rest"),
    ("best_angle", 1, plain(200, 201), "gs_fnma(sine_q, d_lo, sine_e1)", "sine_e1"),
    (
        "best_angle",
        1,
        plain(20, 20.1),
        "0x1.5555555555555p-3));\n    const gs_v share",
        "0x1.5555555555p-3));\n    const gs_v share",
    ),
    ("max_range_factor", 1, plain(20, 20.1), "gs_sub(top_e0, left_lo)", "top_e0"),
    # what is subnormal is rounded, and the sum once more
    (
        "max_range_factor",
        2,
        plain(2.0**1020, 1.1 * 2.0**1020),
        "gs_fma(minus, q_e0, q)",
        "gs_add(q, gs_mul(minus, q_e0))",
    ),
]


@pytest.mark.parametrize(("name", "number", "cell", "old", "new"), SPOILED)
def test_what_is_spoiled_raises_the_bound_or_is_refused(name, number, cell, old, new):
    text = frame_of(name, *BANKS[name])
    before = total(text, name, number, cell)
    assert Fraction(49, 100) <= before < Fraction(6, 10)
    try:
        after = total(spoiled(text, old, new), name, number, cell)
    except (Unproved, RefusedSource, Overflow):
        return
    assert after > before + LEAST_GAIN


@pytest.mark.parametrize(
    ("name", "old", "new", "why"),
    [
        (
            "arctan",
            "gs_at_least(m, gs_v_of(0x1.fe00000000000p+5))",
            "gs_at_least(m, gs_v_of(0x1.ff00000000000p+5))",
            "is due",
        ),
        ("arctan", "gs_flip(r, x), lo)", "r, lo)", "does not know"),
        ("arctan", "gs_select(here, gs_flip(tail, x), r)", "gs_select(here, tail, r)", "does not know"),
        ("sin", "gs_v_of(0x1.921fb54442d19p+0)", "gs_v_of(0x1.921fb54442d18p+0)", "nothing serves"),
        ("sin", "gs_v_of(-0x1.921fb54442d18p+0)", "gs_v_of(0x0.0p+0)", "an odd function"),
        (
            "w0",
            "gs_refuse_beyond(x, gs_v_of(-0x1.78b56362cef37p-2)",
            "gs_refuse_beyond(x, gs_v_of(-0x1.0p+0)",
            "is due",
        ),
        ("wm1", "gs_wm1_range4(gs_select", "gs_wm1_range3(gs_select", "never served"),
    ],
)
def test_thresholds_parity_and_domain_are_read_and_fit(name, old, new, why):
    text = frame_of(name, *BANKS[name])
    assert name in frames(parse(text))
    with pytest.raises(RefusedSource, match=why):
        frames(parse(spoiled(text, old, new)))


@pytest.mark.parametrize(
    ("name", "number", "cell", "old", "new"),
    [
        ("sin", 0, plain(2.0**-30, 2.0**-29), "p-250", "p-20"),  # x itself where it is no sine
        ("sin", 0, plain(2.0**-460, 2.0**-450), "p-250", "p-500"),  # nearer to 0 than the bank is proved
        ("w0", 1, plain(10, 11), "gs_omega_near_pair(y", "gs_omega_near_pair(y_s"),
        ("max_range_factor", 1, plain(4, 4.1), "gs_add(less, off)", "gs_sub(less, off)"),
    ],
)
def test_what_is_used_outside_its_range_is_refused(name, number, cell, old, new):
    with pytest.raises((Unproved, RefusedSource)):
        total(spoiled(frame_of(name, *BANKS[name]), old, new), name, number, cell)


def test_a_power_of_the_wrong_sixteenth_is_no_small_error():
    text = frame_of("exp_minus")
    table_of = re.search(r"GS_TABLE\(gs_exp_minus_sixteenth\) = \{(.*?)\};", text, re.DOTALL)[1]
    third, fourth = re.findall(r"0x[^,\s]+", table_of)[3:5]
    swapped = text.replace(third, "?").replace(fourth, third).replace("?", fourth)
    assert total(text, "exp_minus", 0, None) < Fraction(51, 100)
    with pytest.raises((Unproved, RefusedSource)):
        total(swapped, "exp_minus", 0, None)


def test_a_last_bit_of_a_coefficient_raises_the_bound():
    text, cell = frame_of("w0_offset", "rise_factor"), plain(1, 1.1)
    before = total(text, "w0_offset", 0, cell)
    c0 = re.search(r"GS_TABLE\(gs_rise_factor_c0\) = \{.*?\};", text, re.DOTALL)[0]
    moved = re.sub(r"[0-9a-f](?=p[+-])", lambda digit: f"{int(digit[0], 16) ^ 1:x}", c0)
    assert total(spoiled(text, c0, moved), "w0_offset", 0, cell) > before + Fraction(1, 4)


def test_every_argument_and_its_rest_is_in_a_part_of_its_piece():
    piece, reach = Piece(0, Fraction(1), Fraction(2), Fraction(3, 2), (Fraction(1),)), Fraction(1)
    for low, high in (map(Fraction, ends) for ends in ((1.0, 2.0), (1.25, 1.26), (1.999, 3.0), (0.5, 1.0))):
        found = parts(piece, low, high, reach)
        assert all(1 <= part.lower < part.upper <= 2 for part in found)
        assert found[0].lower <= max(low - power(-52), 1)
        assert found[-1].upper >= min(high + power(-52), 2)
        assert all(a.upper >= b.lower + 2 * power(-52) for a, b in pairwise(found))
        assert sum(part.upper - part.lower for part in found) < 3 * (high - low) + Fraction(1, 8)
    assert parts(piece, Fraction(3), Fraction(4), reach) == []


def test_terms_of_one_error_are_added_before_they_are_bounded():
    symbols = Symbols(Fraction(1), Fraction(2))
    x, one, error = Expansion.argument(), Expansion.of(Fraction(1)), symbols.fresh(power(-50))
    assert symbols.range((one - x) * error) == (-power(-50), power(-50))
    assert symbols.range((one - x) * error + x) == (1 - power(-50), 2 + power(-50))


def test_limits_are_met_and_missed():
    functions = parse(FRAMES).functions
    assert frame_points.error_at("w0", functions["gs_w0_range2"], inf) == 0
    assert frame_points.error_at("wm1", functions["gs_wm1_range4"], 0) == 0
    assert 0 < frame_points.error_at("arctan", functions["gs_arctan_range2"], inf) <= Fraction(1, 2)
    with pytest.raises(Unproved, match="is due"):
        frame_points.error_at("w0", functions["gs_w0_offset_range2"], inf)
    with pytest.raises(Unproved, match="is looked up"):
        frame_points.error_at("best_sine", functions["gs_best_sine_range0"], inf)


def test_every_argument_is_on_the_cell_of_what_the_c_rounds_it_to():
    emitted, draw = parse(FRAMES), random.Random(5)
    served = frames(emitted)["exp_minus"].ranges
    for one in served[:2]:
        cells = reduced(emitted.functions[one.function], one)
        rounding = cells[0].rounding
        for _ in range(200):
            x = Fraction(draw.uniform(float(one.begin), float(one.end)))
            K = RN(x * rounding.steps + rounding.shift) - rounding.shift
            n, j = divmod(int(K), 16)
            found = [
                cell
                for cell in cells
                if (K == 0 if isinstance(cell, Unreduced) else cell.least <= n <= cell.greatest and cell.j in (None, j))
            ]
            assert len(found) == 1
            low, high = found[0].x
            assert low <= x <= high
            if K:
                symbols = found[0].start()[0]
                T = table()["log(2)/16"][0] * K - x
                assert symbols.atoms[next(n for n, name in symbols.names.items() if name == "t")][1] >= abs(T)


def test_cells_hold_every_double_of_a_range():
    served = frames(parse(FRAMES))["cos"].ranges[0]
    last, close, rest = beside(served, table(), "pi/2", 1, Fraction(1))
    assert last.lower == last.upper == RN(table()["pi/2"][0])
    assert rest.lower == 0
    assert close.x[0] <= rest.upper < close.x[1] < last.lower
    for lower, upper in ((Fraction(1), Fraction(64)), (Fraction(-3), Fraction(-1, 2)), (Fraction(3), Fraction(5))):
        first, second = Plain(lower, upper).halves()
        assert (first.lower, second.upper) == (lower, upper)
        assert second.lower - first.upper in (power(n) for n in range(-60, 0))
    assert cut(Fraction(0), Fraction(2))[0] == (0, 0)


def test_a_real_number_is_the_sum_of_its_doubles_whatever_these_are():
    symbols = Symbols(Fraction(1), Fraction(2))
    reals = Reals(symbols)
    parts = [Fraction(float.fromhex(text)) for text in ("0x1.921fb54442d18p+0", "0x1.1a62633145c07p-54")]
    sums = sum((reals.expansion(part) for part in parts), Expansion({}))
    with mp.workdps(60):
        left = abs(mp.pi / 2 - sum(mpf(p.numerator) / p.denominator for p in parts))
        assert float(symbols.largest(sums - reals.atom("pi/2"))) == pytest.approx(float(left), rel=1e-6)
    assert reals.expansion(Fraction(3, 2)) is None


def test_small_terms_are_folded_into_a_bound_that_holds_them():
    symbols = Symbols(Fraction(1, 2**40), Fraction(2**40))
    x, errors = Expansion.argument(), [symbols.fresh(power(-n)) for n in (53, 60, 100)]
    whole = x * (Expansion.of(Fraction(1)) + errors[0]) * (Expansion.of(Fraction(1)) + errors[1]) + x * errors[2]
    short = folded(symbols, whole)
    assert len(short.terms) == 4 < len(whole.terms)
    assert symbols.largest((whole - x).over(((0, 1),))) <= symbols.largest((short - x).over(((0, 1),)))
    assert symbols.largest((short - whole).over(((0, 1),))) < power(-95)
    assert ratio(symbols, x * errors[0], x) == power(-53)
    assert symbols.largest(error_of(symbols, x).over(((0, 1),))) == power(-53)
    with pytest.raises(Overflow):
        error_of(symbols, x * Expansion.of(power(1000)))
