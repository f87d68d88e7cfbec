"""References of the launch angles against the closed form of the range, by Lambert W at 400 digits."""

import pytest
from mpmath import mp, mpf
from verify_ends import ends

from galileo_sym.verify.enclosure import nearest_float
from galileo_sym.verify.reference import reference

CASES = [
    {"v": 50.0, "g": 32.2, "k": 0.0},
    {"v": 50.0, "g": 32.2, "k": 1e-60},
    {"v": 50.0, "g": 32.2, "k": 0.25},
    {"v": 50.0, "g": 32.2, "k": 30.0},
    {"v": 1e200, "g": 1e-100, "k": 1e-100},
    {"v": 1.0, "g": 1.0, "k": 1e9},
]


@pytest.fixture(autouse=True)
def many_digits():
    with mp.workdps(400):
        yield


def range_at(theta, v, g, k):
    v, g, k = map(mpf, (v, g, k))
    if k == 0:
        return v**2 * mp.sin(2 * theta) / g
    u = -1 - k * v * mp.sin(theta) / g
    return v * mp.cos(theta) / k * (1 - mp.lambertw(u * mp.exp(u)).real / u)


def middle(enclosure):
    low, high = ends(enclosure)
    assert 0 <= high - low <= high * mpf(2) ** -90
    return (low + high) / 2


@pytest.mark.parametrize("shot", CASES)
@pytest.mark.parametrize("share", [1e-30, 0.3, 0.999, 1 - 2.0**-40])
def test_both_angles_have_the_range(shot, share):
    (largest,) = reference("projectile.max_range", shot)
    r = share * nearest_float(largest)
    angles = reference("projectile.launch_angles", {"r": r, **shot})
    low, high = map(middle, angles)
    alpha = mpf(shot["k"]) * mpf(shot["v"]) / mpf(shot["g"])
    best = mp.pi / 4
    if alpha:
        s = 1 + mp.lambertw((alpha**2 - 1) / mp.e).real
        best = mp.asin(alpha / mp.expm1(s))
    assert 0 < low < best < high < mp.pi / 2
    for angle, sign in zip(angles, (1, -1), strict=True):  # the range rises through r, and falls through it
        below, above = (sign * (range_at(theta, **shot) - mpf(r)) for theta in ends(angle))
        assert below < 0 < above
    assert abs(range_at(best, **shot) / middle(largest) - 1) < mpf(2) ** -85


def test_ends():
    shot = {"v": 10.0, "g": 10.0, "k": 0.0}
    assert [middle(e) for e in reference("projectile.launch_angles", {"r": 10.0, **shot})] == pytest.approx(
        [mp.pi / 4] * 2, rel=1e-25
    )
    zero, right = reference("projectile.launch_angles", {"r": 0.0, **shot, "k": 0.1})
    assert (middle(zero), mp.nstr(middle(right), 25)) == (0, mp.nstr(mp.pi / 2, 25))


@pytest.mark.parametrize("k", [0.0, 0.2])
def test_above_the_largest_range_there_is_no_reference(k, monkeypatch):
    monkeypatch.setattr("galileo_sym.verify.enclosure.LAST_PRECISION", 320)
    with pytest.raises(ArithmeticError, match="no certain reference"):
        reference("projectile.launch_angles", {"r": 10.1, "v": 10.0, "g": 10.0, "k": k})
