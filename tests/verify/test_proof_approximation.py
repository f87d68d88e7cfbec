"""Proved bounds of the approximation error: above every sample, close to it, and not to be had for what is wrong."""

from dataclasses import replace
from fractions import Fraction
from math import ulp
from pathlib import Path

import pytest
from closed_forms import CLOSED_FORMS, closed_form
from flint import acb, arb, arb_poly, arb_series
from mpmath import cos, mp, mpf, pi

from galileo_sym.primitives.approximations import APPROXIMATIONS, coefficients
from galileo_sym.verify.proof.approximation import Unproved, approximation_bound, piece_bounds
from galileo_sym.verify.proof.approximation_calculus import (
    Analytic,
    analytic,
    largest,
    precision,
    quotient_bound,
    span,
)
from galileo_sym.verify.proof.approximation_equations import EQUATIONS, Equation
from galileo_sym.verify.proof.approximation_far import FAR_FORMS, far_bound
from galileo_sym.verify.proof.approximation_functions import (
    Disc,
    NotAnalytic,
    log,
    log_lag,
    log_mean,
    phi1,
    phi1_slope,
    phi2,
    sinc,
    sqrt,
)
from galileo_sym.verify.proof.emitted import read
from galileo_sym.verify.proof.pieces import Piece

KERNELS = Path(__file__).parents[2] / "generated/c/galileo_kernels.h"
CONTINUED = {
    "phi1m_tail": "phi1m",
    "phi2m_tail": "phi2m",
    "range_tail": "range_factor",
    "fall_tail": "fall_factor",
    "omega_start": "omega",
    "omega_tail": "omega",
    "arctangent_tail": "arctangent",
}
POINTS = {  # elsewhere none or not positive, or so small that a short piece is not
    "wm1_branch": (2.0**-6, 0.25, 0.5),
    "wm1_middle": (0.0078125, 0.03125, 0.125),
    "log": (1.25, 2.5, 40.0),
    "sine": (0.25, 0.5, 1.25),
    "arctangent": (0.25, 1.25, 40.0),
}
CLAIM = 2.0**-57
SAMPLES = 18
CLOSE = 12


def _number(value):
    return mpf(value.numerator) / value.denominator


def _committed(bank):
    """The pieces of the committed coefficients, which are made for primitives that are not emitted yet, too."""
    partition = APPROXIMATIONS[bank].partition
    found = []
    for i, piece in enumerate(coefficients(bank)):
        c0, c0_lo, c1, c1_lo, *others = map(Fraction, piece.coefficients)
        lower, upper = map(Fraction, partition.bounds(i))
        found.append(Piece(i, lower, upper, Fraction(piece.centre), (c0 + c0_lo, c1 + c1_lo, *others)))
    return found


def _sampled(name, piece):
    """The largest relative error seen on a piece, and the least and largest value."""
    lower, upper = _number(piece.lower), _number(piece.upper)
    polynomial = [_number(c) for c in reversed(piece.coefficients)]
    errors, values = [], []
    for j in range(SAMPLES):
        x = (lower + upper) / 2 + (upper - lower) / 2 * cos(pi * (j + mpf(1) / 2) / SAMPLES)
        values.append(closed_form(name, x))
        errors.append(abs(mp.polyval(polynomial, x - _number(piece.centre)) / values[-1] - 1))
    return max(errors), min(values), max(values)


@pytest.mark.parametrize("bank", sorted(APPROXIMATIONS))
def test_bound_is_above_a_sample_at_60_digits_and_close_to_it(bank):
    name, polynomials = CONTINUED.get(bank, bank), _committed(bank)
    bounds = piece_bounds(name, polynomials)
    assert len(bounds) == len(polynomials) == 16
    for piece, bound in zip(polynomials, bounds, strict=True):
        with mp.workdps(60):
            error, least, most = _sampled(name, piece)
        assert error <= bound.relative <= CLOSE * error
        assert bound.relative < CLAIM
        assert bound.smallest <= least
        assert most <= bound.largest
        assert bound.largest <= 1.01 * most * (1 + (most - least) / least)


def test_emitted_tables_are_judged_as_parsed():
    emitted = read(KERNELS)
    bounds = approximation_bound("phi2m", emitted, "phi2m_tail")
    assert [bound.piece for bound in bounds] == list(range(16))
    assert all(bound.relative < CLAIM for bound in bounds)
    assert bounds[0].low <= 26.25
    assert bounds[-1].high >= 446.25
    with pytest.raises(Unproved, match="phi2m_tail"):
        approximation_bound("phi2m_tail", emitted)


def _point(name, x):
    """A very short piece around x, with the closed form's value there for its polynomial."""
    with mp.workdps(40):
        value = Fraction(str(closed_form(name, mpf(x))))
    short = Fraction(1, 2**120)
    return Piece(0, Fraction(x) - short, Fraction(x) + short, Fraction(x), (value,))


@pytest.mark.parametrize("name", sorted(EQUATIONS))
def test_every_equation_has_its_primitive_as_root(name):
    assert name in CLOSED_FORMS
    for x in POINTS.get(name, (2.0**-6, 1.25, 40.0)):
        (bound,) = piece_bounds(name, [_point(name, x)])
        assert bound.relative < 2.0**-115


@pytest.mark.parametrize("name", sorted(EQUATIONS))
@pytest.mark.parametrize("wrong", [Fraction(1, 2**45), Fraction(-1, 2**45)])
def test_an_error_is_found_in_full_and_the_value_is_enclosed(name, wrong):
    piece = _point(name, POINTS.get(name, (1.25,))[-1])
    (bound,) = piece_bounds(name, [replace(piece, coefficients=(piece.coefficients[0] * (1 + wrong),))])
    assert abs(wrong) <= bound.relative <= abs(wrong) * (1 + 2.0**-30)
    assert bound.smallest <= piece.coefficients[0] <= bound.largest


@pytest.mark.parametrize("name", ["descent_factor", "fall_factor", "wm1_branch"])
def test_least_value_is_one(name):
    first, second = piece_bounds(name, _committed(name)[:2])
    assert first.smallest == 1 < second.smallest


@pytest.mark.parametrize("name", ["sine", "arctangent"])
def test_what_is_0_at_0_must_be_so(name):
    first = _committed(name)[0]
    with pytest.raises(Unproved, match="not 0 where the primitive is"):
        piece_bounds(name, [replace(first, coefficients=(Fraction(1, 2**80), *first.coefficients[1:]))])


def test_two_roots_in_the_neighbourhood_are_refused(monkeypatch):
    apart = 2.0**-42

    def two_roots(x, f):
        return (f - 1) * (f - 1 - apart), f * (2 * f - 2 - apart)

    monkeypatch.setitem(EQUATIONS, "phi1m", Equation(two_roots))
    piece = Piece(0, Fraction(0), Fraction(1), Fraction(0), (1 + Fraction(1, 2**60),))
    with pytest.raises(Unproved, match="not shown to be unique"):
        piece_bounds("phi1m", [piece])


@pytest.mark.parametrize("name", sorted(EQUATIONS))
@pytest.mark.parametrize("wrong", [Fraction(1, 2**30), Fraction(-1, 2**30), Fraction(1, 2), Fraction(-2)])
def test_no_other_value_passes(name, wrong):
    piece = _point(name, POINTS.get(name, (1.25,))[-1])
    with pytest.raises(Unproved):
        piece_bounds(name, [replace(piece, coefficients=(piece.coefficients[0] * (1 + wrong),))])


def test_the_other_root_is_refused():
    angle, short = _point("best_angle", 1.25), _point("w0_ratio", 0.25)
    with mp.workdps(40):
        beyond = Fraction(str(pi)) - angle.coefficients[0]
        lower_branch = Fraction(str(mp.exp(-mp.lambertw(mpf(0.25) ** 2 - 1 / mp.e, -1).real)))
    with pytest.raises(Unproved, match="interval in which the root is unique"):
        piece_bounds("best_angle", [replace(angle, coefficients=(beyond,))])
    with pytest.raises(Unproved, match="is needed"):
        piece_bounds("w0_ratio", [replace(short, coefficients=(lower_branch,))])


@pytest.mark.parametrize("name", ["descent_factor", "range_factor", "w0_ratio"])
@pytest.mark.parametrize(("power", "ulps"), [(0, 1), (1, 2**4), (2, 2**9), (3, 2**14)])
def test_last_bits_of_a_coefficient_count(name, power, ulps):
    for piece in _committed(name)[4::4]:
        (before,) = piece_bounds(name, [piece])
        changed = list(piece.coefficients)
        step = Fraction(ulp(float(changed[power]))) * ulps
        changed[power] += step
        (after,) = piece_bounds(name, [replace(piece, coefficients=tuple(changed))])
        reach = float(step * ((piece.upper - piece.lower) / 2) ** power) / before.largest
        assert after.relative >= reach - before.relative
        assert after.relative > CLAIM


def test_a_dropped_low_part_is_noticed():
    polynomials, made = _committed("descent_factor")[1:], coefficients("descent_factor")[1:]
    low = [Fraction(piece.coefficients[1]) for piece in made]
    weakened = [
        replace(piece, coefficients=(piece.coefficients[0] - dropped, *piece.coefficients[1:]))
        for piece, dropped in zip(polynomials, low, strict=True)
    ]
    bounds = piece_bounds("descent_factor", weakened)
    assert all(bound.relative >= abs(dropped) / 2 / bound.largest for bound, dropped in zip(bounds, low, strict=True))
    assert sum(bound.relative > CLAIM for bound in bounds) > 10


def test_pieces_that_change_places_are_refused():
    first, second = _committed("phi1m")[3:5]
    with pytest.raises(Unproved, match="phi1m, piece 3"):
        piece_bounds("phi1m", [replace(first, coefficients=second.coefficients)])


def test_a_wrong_equation_is_noticed(monkeypatch):
    polynomials = _committed("flight_factor")
    with pytest.raises(Unproved):
        piece_bounds("range_factor", polynomials)

    def slightly_wrong(x, f):
        residual, slope = EQUATIONS["phi1m"].terms(x, f)
        return residual * (1 + 2.0**-20) - phi2(-x) * 2.0**-50, slope

    monkeypatch.setitem(EQUATIONS, "flight_factor", Equation(slightly_wrong))
    with pytest.raises(Unproved):
        piece_bounds("flight_factor", polynomials)
    monkeypatch.setitem(EQUATIONS, "phi1m", Equation(lambda x, f: (f - phi1(-x) - phi2(-x) * 2.0**-52, f)))
    assert all(bound.relative > 2.0**-54 for bound in piece_bounds("phi1m", _committed("phi1m")))


def _far_error(name, x):
    form = sum(_number(c) * x**power for power, c in FAR_FORMS[name].terms.items())
    return abs(form / closed_form(name, x) - 1)


@pytest.mark.parametrize("name", sorted(FAR_FORMS))
def test_far_bound_holds_from_its_beginning_on_and_is_close_there(name):
    with mp.workdps(90):
        for begin in (5, Fraction(75, 8)):
            bound, errors = far_bound(name, begin), [_far_error(name, _number(begin) * k) for k in (1, 1.25, 2)]
            assert max(errors) == errors[0] <= bound <= 2 * errors[0]
    with pytest.raises(ValueError, match="x > 1"):
        far_bound(name, Fraction(1))


def _line(at_zero, slope):
    return arb_poly([at_zero, slope])


def test_tails_are_above_what_is_left_out():
    with precision():
        found = analytic(lambda u: phi1(1 / (u + 2.5)) + sqrt(u + 3), _line(0, 1))
        for u in (-1, -0.5, 0.25, 1):
            w = 1 / (arb(u) + 2.5)
            missing = (w.exp() - 1) / w + (arb(u) + 3).sqrt() - found.polynomial(arb(u))
            assert abs(missing) <= found.tail
        assert found.tail < 2.0**-80


@pytest.mark.parametrize("formula", [lambda u: 1 / (u + 1.25), lambda u: log(u + 1.25), lambda u: sqrt(u + 1.25)])
def test_a_singularity_near_the_piece_is_refused(formula):
    with precision(), pytest.raises(NotAnalytic):
        analytic(formula, _line(0, 1))


def test_radii_of_coefficients_count_as_tail():
    with precision():
        found = analytic(lambda u: u * 2, _line(arb(0, 2.0**-10), 1))
        assert found.tail >= 2.0**-9
        assert all(c.is_exact() for c in found.polynomial.coeffs())


def test_a_shortened_series_is_refused():
    with precision(), pytest.raises(NotAnalytic):
        analytic(lambda u: u if isinstance(u, Disc) else arb_series(u.coeffs(), 5), _line(2, 1))


@pytest.mark.parametrize("mean", [phi1, phi2, phi1_slope, log_mean, log_lag, sinc])
@pytest.mark.parametrize("centre", [-0.125, 0.0, 0.5, 3.0])
def test_an_average_holds_its_closed_form(mean, centre):
    with precision():
        values = mean(Disc(_line(centre, 0.125), 2)).ball()
        for direction in (acb(1), acb(0, 1), acb(-0.6, 0.8)):
            w = centre + direction / 4
            assert values.contains(mean.closed(Disc(w, 2)).ball())


def test_tails_enter_quotients():
    def constant(value, tail):
        return Analytic(arb_poly([value]), arb(tail))

    with precision():
        assert quotient_bound(constant(0, 1), constant(2, 0)) >= 0.5
        assert quotient_bound(constant(3, 0), constant(2, 1)) >= 3
        assert quotient_bound(constant(1, 0), constant(-2, 1)) >= 1
        assert quotient_bound(constant(1, 0), constant(1, 1)) is None


def test_quotients_and_spans_are_bounded():
    with precision():
        u = _line(0, 1)
        top, bottom = analytic(lambda u: u * u - u, u), analytic(lambda u: u + 3, u)
        assert 1 <= quotient_bound(top, bottom) <= 2
        assert quotient_bound(bottom, top) is None
        assert 2 <= largest(top.polynomial) <= 2.01
        low, high = span(top.polynomial)
        assert low <= -0.25
        assert high >= 2
        assert span(bottom.polynomial) == (2, 4)
