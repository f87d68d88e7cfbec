"""Piecewise polynomials: the grid, the error they state, and the refusal of too low a degree."""

from itertools import pairwise

import pytest
from mpmath import mp, mpf

from galileo_sym.primitives.fit import fit, fit_piece, piece_bounds, pieces_up_to
from galileo_sym.primitives.tables import TABLES, TOLERANCE, angle_rows, constants, pieces, series_rows


def test_pieces_cover_the_range_without_gaps():
    count = pieces_up_to(43.0)
    bounds = [piece_bounds(i) for i in range(count)]
    assert bounds[0][0] == 0.0
    assert bounds[-1][1] == 43.0
    assert all(a[1] == b[0] for a, b in pairwise(bounds))
    assert all(lower <= centre < upper for lower, upper, centre in bounds)


def test_a_range_that_ends_inside_a_piece_is_refused():
    with pytest.raises(ValueError, match="not the end of a piece"):
        pieces_up_to(42.3)


def test_too_low_a_degree_is_refused():
    with pytest.raises(ArithmeticError, match="raise the degree"):
        fit(mp.exp, 1.0, 3, TOLERANCE)


def test_first_piece_is_exact_at_zero():
    piece = fit_piece(mp.exp, 0, 12)
    assert piece.centre == 0.0
    assert piece.coefficients[:2] == (1.0, 0.0)


@pytest.mark.parametrize("name", TABLES)
def test_table_against_the_function_between_the_points_it_was_checked_at(name):
    table = TABLES[name]
    with mp.workdps(40):
        for index, piece in list(enumerate(pieces(name)))[:: max(1, table.count // 6)]:
            lower, upper, centre = piece_bounds(index)
            assert centre == piece.centre
            x = mpf(lower) + (mpf(upper) - lower) * mpf("0.3819")
            c0, c0_lo, c1, c1_lo, *rest = map(mpf, piece.coefficients)
            value = mp.polyval([*reversed(rest), c1 + c1_lo, c0 + c0_lo], x - centre)
            assert abs(value / table.value(x) - 1) < TOLERANCE


@pytest.mark.parametrize("name", [n for n, t in TABLES.items() if t.far])
def test_far_form_takes_over_within_the_tolerance(name):
    table = TABLES[name]
    far = table.far
    with mp.workdps(40):
        for x in (mpf(table.x_max), mpf(table.x_max) * 3, mpf("1e40")):
            value = mpf(2) ** far.shift * x**far.power * (1 + far.correction * x**-far.order)
            assert abs(value / table.value(x) - 1) < mpf(2) ** -57


def test_constants_are_unevaluated_sums():
    with mp.workdps(60):
        assert abs(sum(map(mpf, constants()["half_pi"])) - mp.pi / 2) < mpf("1e-60")
        assert abs(sum(map(mpf, constants()["log_2"])) - mp.log(2)) < mpf("1e-40")
        for i, (sine, cosine) in enumerate(angle_rows()):
            assert abs(sum(map(mpf, sine)) - mp.sin(mpf(i) / 64)) < mpf("1e-47")
            assert abs(sum(map(mpf, cosine)) - mp.cos(mpf(i) / 64)) < mpf("1e-47")
        assert abs(sum(map(mpf, series_rows("sinc", 2)[1])) - mpf(1) / 120) < mpf("1e-49")
        assert abs(sum(map(mpf, series_rows("cosm1", 3)[2])) + mpf(1) / 720) < mpf("1e-49")
