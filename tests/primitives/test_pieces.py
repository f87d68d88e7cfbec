"""The pieces of the approximations: partition, fit, and the committed coefficients."""

import math
import random
from fractions import Fraction

import pytest
from mpmath import mp, mpf

from galileo_sym.primitives import approximations, pieces, remake
from galileo_sym.primitives.approximations import APPROXIMATIONS
from galileo_sym.primitives.kernels import BANKED
from galileo_sym.primitives.pieces import COUNT, Partition


@pytest.mark.parametrize("name", APPROXIMATIONS)
def test_a_piece_is_found_by_the_leading_bits(name):
    """The index that the emitted code computes is that of the piece whose bounds hold x."""
    partition = APPROXIMATIONS[name].partition
    rng = random.Random(name)
    for index in range(COUNT):
        lower, upper = partition.bounds(index)
        for x in (lower, rng.uniform(lower, upper), upper - (upper - lower) * 2**-40):
            assert (pieces.bits_of(x + partition.offset) >> partition.drop) - partition.first == index
        assert index == 0 or partition.bounds(index - 1)[1] == lower
        assert lower <= partition.centre(index) < upper


@pytest.mark.parametrize("name", APPROXIMATIONS)
def test_the_distance_to_the_centre_is_exact_at_the_ends_of_a_piece(name):
    """Also for the doubles just below a bound that the rounding of x + offset puts into the next piece."""
    partition = APPROXIMATIONS[name].partition
    for index in range(1, COUNT):
        lower, upper = partition.bounds(index)
        centre = partition.centre(index)
        below = lower
        while (
            pieces.bits_of(math.nextafter(below, 0.0) + partition.offset) >> partition.drop
        ) - partition.first == index:
            below = math.nextafter(below, 0.0)
        for x in (below, math.nextafter(below, 1e9), lower, math.nextafter(lower, 1e9), math.nextafter(upper, 0.0)):
            assert Fraction(x - centre) == Fraction(x) - Fraction(centre)


def test_an_offset_off_the_grid_is_refused():
    """Piece 0 would not begin at 0."""
    with pytest.raises(ValueError, match="bits after the leading one"):
        Partition(0.6).first  # noqa: B018


def test_banks_follow_one_another():
    """No gap between the approximations of a primitive."""
    for kernel in BANKED.values():
        ends = [0.0, *(APPROXIMATIONS[bank].partition.end for bank in kernel.banks)]
        assert ends[:-1] == [APPROXIMATIONS[bank].partition.begin for bank in kernel.banks]
        assert kernel.end == ends[-1]


# one that starts at 0, one that does not, one of the scaled layer; `make tables` remakes all
@pytest.mark.parametrize("name", ["descent_factor", "phi2m_tail", "scaled/descent_factor"])
def test_the_coefficients_are_made_again_to_the_byte(name, capsys):
    """The committed files are what the fit gives."""
    assert remake.main(["--check", name]) == 0
    assert f"{name}: same" in capsys.readouterr().out


def test_a_wrong_coefficient_is_told(monkeypatch, tmp_path, capsys):
    """`--check` notices one changed digit, and writes nothing."""
    text = approximations.path_of("phi2m_tail").read_text(encoding="utf-8")
    changed = tmp_path / "phi2m_tail.txt"
    changed.write_text(text[:-8] + ("0" if text[-8] != "0" else "1") + text[-7:], encoding="utf-8")
    before = changed.read_bytes()
    monkeypatch.setattr(approximations, "path_of", lambda name: changed)
    assert remake.main(["--check", "phi2m_tail"]) == 1
    assert "phi2m_tail: differs" in capsys.readouterr().out
    assert changed.read_bytes() == before


def test_too_low_a_degree_is_refused(monkeypatch):
    """A fit that is not good enough is an error, not a worse table."""
    low = approximations.Approximation("low", mp.exp, 1.0, 5, "exp(x)")
    monkeypatch.setitem(approximations.APPROXIMATIONS, "low", low)
    with pytest.raises(ArithmeticError, match="raise the degree 5"):
        approximations.fit("low")


def test_the_fit_of_a_known_function():
    """1 + log(1 + x) at points that the fit has not seen, and exactly 1 at 0."""
    partition = Partition(1.0)

    def logarithm(x):
        return 1 + mp.log1p(x)

    with mp.workdps(50):
        for index in (0, 1, 7, 15):
            piece = pieces.fit_piece(logarithm, partition, index, 16)
            lower, upper = map(mpf, partition.bounds(index))
            for share in ("0.013", "0.377", "0.871"):
                x = lower + (upper - lower) * mpf(share)
                assert abs(piece.value(x) / logarithm(x) - 1) < 2.0**-57
        assert pieces.fit_piece(logarithm, partition, 0, 14).coefficients[:2] == (1.0, 0.0)
