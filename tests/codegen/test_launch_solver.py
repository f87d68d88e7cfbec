"""The solver of the launch angles: its starts and steps, for every resistance and up to the largest range."""

import numpy as np
import pytest
from mpmath import mp, mpf

from galileo_sym.generated import _launch
from galileo_sym.generated._decay import decay
from galileo_sym.generated._elevation import elevation
from galileo_sym.generated._primitives import best_time
from galileo_sym.generated._scaled import constant, div, load, mul, sub
from galileo_sym.generated._scaled_projectile import launch_angles_drag_balance as balance


def value(a, i):
    hi, lo, e = (np.broadcast_to(part, np.broadcast_shapes(*(np.shape(p) for p in a)))[i] for part in a)
    return (mpf(float(hi)) + mpf(float(lo))) * mpf(2) ** int(e)


def grid():
    """Resistances alpha over all sizes, and shares eta**2 that the square of the range is below its maximum."""
    alpha = np.concatenate([[0.0], 10.0 ** np.linspace(-3, 5, 97), 10.0 ** np.linspace(-300, 300, 25)])
    eta = np.concatenate([np.linspace(0.02, 0.98, 25), 2.0 ** -np.arange(6, 27), 1 - 2.0 ** -np.arange(6, 53)])
    a, e = (x.ravel() for x in np.meshgrid(alpha, eta))
    kept = ~((a > 1e5) & (e < 1e-6))  # there the condition is that of 1 - k r/v
    return load(a[kept]), load(e[kept])


def moved(z, level, low, alpha):
    return _launch._moved(z, _launch._step(balance(z, alpha), level, low))


@pytest.mark.parametrize("low", [True, False])
def test_three_steps_suffice_and_two_do_not(low):
    alpha, eta = grid()
    z_best = best_time(alpha)
    top = balance(z_best, alpha)
    level = mul(top.square, mul(sub(constant(1.0), eta), _launch.add(constant(1.0), eta)))
    with np.errstate(all="ignore"):
        z = [_launch._starts(top, z_best, alpha, level)[0 if low else 1]]
        for _ in range(5):
            z.append(moved(z[-1], level, low, alpha))
    off = [np.abs(_launch.plain(div(sub(x, z[-1]), z[-1]))[0]) for x in z]
    away = np.minimum(np.abs(_launch.plain(div(sub(z_best, z[-1]), z[-1]))[0]), 1.0)
    assert np.max(off[0] / away) < 0.12
    assert np.max(off[1] / away) < 4e-4
    assert 2.0**-60 < np.max(off[2]) < 2.0**-33
    assert np.max(off[3]) < 2.0**-66


def test_decay_to_96_bits():
    s = np.concatenate([10.0 ** np.linspace(-300, 300, 61), np.linspace(0.01, 80, 61), [75.0, np.nextafter(75.0, 0)]])
    found = decay(load(s))
    with mp.workdps(400):
        for i, x in enumerate(map(mpf, s.tolist())):
            lost = -mp.expm1(-x) if x > 1e-100 else x - x**2 / 2
            lag = x - lost if x > 1e-100 else x**2 / 2 - x**3 / 6
            assert abs(value(found.first, i) * x / lost - 1) < mpf(2) ** -96
            assert abs(value(found.second, i) * x**2 / lag - 1) < mpf(2) ** -96
            assert abs(value(found.fading, i) - mp.exp(-x)) < mp.exp(-x) * mpf(2) ** -96 + (x >= 75) * mpf(2) ** -108


def test_elevation_to_65_bits():
    t = np.concatenate([10.0 ** np.linspace(-300, 300, 61), np.tan(np.arange(1, 202) / 128)])
    found = elevation(load(t), constant(1.0))
    turned = elevation(constant(1.0), load(t))
    with mp.workdps(400):
        for i, x in enumerate(map(mpf, t.tolist())):
            assert abs(value(found, i) / mp.atan(x) - 1) < mpf(2) ** -65
            assert abs(value(turned, i) / mp.atan(1 / x) - 1) < mpf(2) ** -65


def test_a_step_solves_a_parabola():
    """Without resistance F = Z - Z**2/4: one step from anywhere."""
    zero, level = load(np.zeros(3)), load(np.array([0.1, 0.5, 0.9]))
    z = load(np.array([0.5, 1.2, 1.4]))
    for low, sign in ((True, -1), (False, 1)):
        found = moved(z, level, low, zero)
        for i in range(3):
            with mp.workdps(60):
                assert abs(value(found, i) ** 2 / (2 + sign * 2 * mp.sqrt(1 - value(level, i))) - 1) < mpf(2) ** -98


def test_a_step_beyond_the_reach_of_the_parabola_goes_to_its_vertex():
    above = load(np.array([1.25]))
    found = moved(load(np.array([1.0])), above, True, load(np.zeros(1)))
    with mp.workdps(60):
        assert abs(value(found, 0) ** 2 - 2) < mpf(2) ** -98
