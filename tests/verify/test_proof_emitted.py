"""The parser of the emitted C: it reads every line that is compiled, and refuses what is outside its grammar."""

import math
import random
import re
import struct
from fractions import Fraction

import pytest
from kernels_of_one import EMITTED, KERNELS, kernels_of, spoiled

from galileo_sym.verify.proof.binary64 import LARGEST, RN, SMALLEST, Overflow, double_of_bits, rounding_error, ulp
from galileo_sym.verify.proof.dispatch import primitives
from galileo_sym.verify.proof.emitted import RefusedSource, parse
from galileo_sym.verify.proof.meanings import require_meanings
from galileo_sym.verify.proof.pieces import lookup, pieces

NAME = "descent_factor"
TEXT = kernels_of(NAME)
TWO_BANKS = kernels_of("range_factor")
HEADER = (EMITTED / "galileo_vector.h").read_bytes().decode()
H = "    const gs_v h = "
NEAR = "static inline gs_v gs_descent_factor_near("
BEFORE_R = ");\n    const gs_v r"
ONES = ", ".join(["0x1p+0"] * 15)


def test_every_table_and_every_line_is_read():
    emitted = parse(KERNELS)
    assert len(emitted.tables) == KERNELS.count("GS_TABLE(")
    bodies = dict(re.findall(r"^static \w+ gs_v (\w+)\(.*?\)\n\{\n(.*?)^\}", KERNELS, re.DOTALL | re.MULTILINE))
    assert set(bodies) == {*emitted.functions, *emitted.choosing}
    for name, function in emitted.functions.items():
        assert len(function.statements) + 1 == bodies[name].count("\n"), name


def test_numbers_are_exact():
    values = parse(f"GS_TABLE(t) = {{-0x1.8000000000001p-3, {ONES}}};").tables["t"]
    assert values == (-Fraction(3 * 2**51 + 1, 2**55), *[Fraction(1)] * 15)


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("gs_mul(q2, d)", "gs_hypot(q2)", "gs_hypot of 1 arguments is no operation of the grammar"),
        ("gs_mul(q2, d)", "gs_mul(q2, d, d)", "gs_mul of 3 arguments"),
        ("gs_mul(q2, d)", "q2 * d", "BinaryOp is no operation"),
        ("gs_mul(q2, d)", "gs_mul(q1, d)", "q1 is used before it is defined"),
        (H, f"    const gs_v q2 = q3;\n{H}", "q2 is defined twice"),
        (H, "    gs_v h = ", "neither a constant declaration nor a store"),
        (
            "    const gs_v h = ",
            "    if (1) return q2;\n    const gs_v h = ",
            "neither a constant declaration nor a store",
        ),
        ("    *lo = gs_rest(s, e, r);\n", "", "lo is never written"),
        ("    *lo = gs_rest(s, e, r);\n", "    *lo = e;\n    *lo = gs_rest(s, e, r);\n", "lo is written twice"),
        (H, f"#define gs_mul gs_add\n{H}", "could change what is compiled"),
        ("gs_v_of(0x1.4000000000000p-1)", "gs_v_of(0.625)", "0.625 is no hexadecimal double"),
        ("GS_TABLE(gs_descent_factor_c2) = {\n", "GS_TABLE(gs_descent_factor_c2) = {0x1p+0,\n", "no full list"),
        (
            "static inline gs_v gs_descent_factor_near(",
            "gs_v z;\nstatic inline gs_v gs_descent_factor_near(",
            "neither",
        ),
        ("(gs_v x, gs_v *lo)", "(double x, gs_v *lo)", "a parameter of type double"),
        ("gs_v_of(0x1.4000000000000p-1)", "gs_v_of(0x1.40000000000001p-1)", "is not a double"),
        ("gs_all(here) ? r", "gs_all(here) && r ? r", "BinaryOp in a function that chooses"),
        ("gs_mul(q2, d)", "gs_mul(q2, d", "emitted C"),
    ],
)
def test_what_is_outside_the_grammar_is_refused(old, new, why):
    with pytest.raises(RefusedSource, match=re.escape(why)):
        parse(spoiled(TEXT, old, new))


@pytest.mark.parametrize(
    ("text", "old", "new", "why"),
    [
        (TEXT, "gs_within(x, gs_v_of(0x0.0p+0)", "gs_within(x, gs_v_of(0x1.0p-9)", "begins what is left"),
        (TEXT, "gs_at_least(x, gs_v_of(0x1.2c", "gs_at_least(x, gs_v_of(0x1.3c", "does not know"),
        (
            TEXT,
            "gs_v_of(0x1.2c00000000000p+3));\n    const gs_v r",
            "gs_v_of(0x1.28p+3));\n    const gs_v r",
            "elsewhere",
        ),
        (TEXT, "gs_all(here) ? r :", "gs_all(beyond) ? r :", "does not know"),
        (TEXT, "_far(gs_select(beyond, x,", "_far(gs_select(here, x,", "does not know"),
        (TEXT, "gs_descent_factor_far(gs_v x)", "gs_rise_factor_far(gs_v x)", "no primitive stands on"),
        (TWO_BANKS, "gs_within(x, gs_v_of(0x1.e0", "gs_within(x, gs_v_of(0x1.f0", "begins what is left"),
        (TWO_BANKS, "r = gs_select(here, tail, r);", "r = gs_select(here, r, tail);", "does not know"),
    ],
)
def test_a_choice_with_a_gap_or_of_another_form_is_refused(text, old, new, why):
    primitives(parse(text))
    with pytest.raises(RefusedSource, match=why):
        primitives(parse(spoiled(text, old, new)))


@pytest.mark.parametrize("name", ["descent_factor", "flight_factor"])
def test_every_argument_lies_in_the_piece_that_is_looked_up(name):
    emitted, draw = parse(kernels_of(name)), random.Random(1)
    for bank in primitives(emitted)[name].banks:
        _, offset, first, drop = lookup(emitted.functions[f"gs_{bank.name}_near"])
        found, begin, end = pieces(emitted, bank.name), float(bank.begin), float(bank.end)
        edges = [float(edge) for piece in found[1:] for edge in (piece.lower, piece.upper)]
        x = [begin, math.nextafter(end, 0), *(draw.uniform(begin, end) for _ in range(200))]
        for edge in edges:
            x += [edge, math.nextafter(edge, 0), math.nextafter(edge, math.inf)]
        for at in (at for at in x if begin <= at < end):
            bits = struct.unpack("<q", struct.pack("<d", at + float(offset)))[0]
            piece = found[(bits >> drop) - first]
            for moved in (-1, 0, 1):
                assert piece.lower <= max(0, Fraction(at) + moved * ulp(Fraction(at)) / 2) <= piece.upper


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("0x1.4000000000000p-1)", "0x1.6p-1)", "outside its 16 pieces"),
        (", 4089, 50)", ", 4088, 50)", "outside its 16 pieces"),
        (", 4089, 50)", ", 4089, 51)", "outside its 16 pieces"),
        ("gs_piece(u,", "gs_piece(x,", "no look-up"),
        ("gs_sub(x, gs_pick(gs_descent_factor_centre, i))", "gs_sub(x, u)", "0 subtractions of a centre"),
    ],
)
def test_a_wrong_look_up_is_refused(old, new, why):
    with pytest.raises(RefusedSource, match=why):
        pieces(parse(spoiled(TEXT, old, new)), NAME)


@pytest.mark.parametrize(
    ("old", "new", "operation"),
    [
        ("gs_add(gs_sub(a, s), b)", "gs_add(gs_sub(b, s), a)", "gs_rest for all"),
        ("return fma(a, b, c);", "return a * b + c;", "gs_fma in plain C"),
        ("_mm512_fmadd_pd", "_mm512_fnmadd_pd", "gs_fma with AVX-512"),
        ("_mm256_add_pd(a, b)", "_mm256_sub_pd(a, b)", "gs_add with AVX2"),
        ("(gs_bits(shifted) >> drop) - first", "(gs_bits(shifted) >> drop) + first", "gs_piece in plain C"),
        ("#include <math.h>", "#define gs_add(a, b) (a)\n#include <math.h>", "gs_add is a macro"),
        ("typedef __m256d gs_v;", "typedef __m256 gs_v;", "no vector of __m256d"),
        ("static const double name[16]\n", "static const float name[16]\n", "GS_TABLE"),
    ],
)
def test_another_meaning_of_an_operation_is_refused(old, new, operation):
    require_meanings(HEADER)
    with pytest.raises(RefusedSource, match=operation):
        require_meanings(spoiled(HEADER, old, new))


def test_rounding_and_ulps_are_those_of_binary64():
    draw = random.Random(2)
    for _ in range(500):
        bits = draw.randrange(1, 0x7FE << 52)
        value = struct.unpack("<d", struct.pack("<q", bits))[0]
        assert double_of_bits(bits) == Fraction(value)
        assert ulp(Fraction(value)) == Fraction(math.ulp(value))
        exact = Fraction(value) * Fraction(draw.randrange(2**60, 2**61), 2**61)
        assert abs(RN(exact) - exact) <= rounding_error(Fraction(value)) <= ulp(Fraction(value)) / 2
    assert rounding_error(Fraction(1)) == Fraction(1, 2**54)
    assert rounding_error(Fraction(1) + SMALLEST) == Fraction(1, 2**53)
    assert rounding_error(SMALLEST / 5) == SMALLEST / 5
    assert rounding_error(LARGEST) == ulp(LARGEST) / 2
    with pytest.raises(Overflow):
        rounding_error(LARGEST + ulp(LARGEST) / 2)
