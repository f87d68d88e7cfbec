"""W and the roots of a t + b + c exp(d t) = 0: known values, the edges of the contract, flags, limits."""

import math

import numpy as np
import pytest

from galileo_sym import lambert, projectile
from galileo_sym.lambert import linear_exponential_roots as roots
from galileo_sym.lambert import w0, wm1

pytestmark = pytest.mark.usefixtures("back_end")

NEAREST = -0.36787944117144233  # to -1/e, and 1.2e-17 below it
LEAST = math.nextafter(NEAREST, 0.0)
NAN = math.nan


def same(found, expected):
    return all(
        a == b or (math.isnan(a) and math.isnan(b))
        for a, b in zip(np.atleast_1d(found), np.atleast_1d(expected), strict=True)
    )


def test_values():
    assert w0(1.0) == 0.5671432904097838
    assert w0(math.e) == 1.0
    assert w0(LEAST) == -0.9999999846957459
    assert wm1(LEAST) == -1.0000000153042543
    assert wm1(-5e-324) == -751.0615595398791
    assert roots(1, 2, -1, 1) == (-1.8414056604369606, 1.1461932206205825)
    assert type(w0(np.float32(1))) is np.float32
    assert w0(np.float32(1)) == np.float32(w0(1.0))


@pytest.mark.parametrize("branch", [w0, wm1])
def test_below_the_branch_point(branch):
    for x in (NEAREST, -1.0, -math.inf):
        with pytest.raises(RuntimeWarning, match="invalid value"):
            branch(x)
        with np.errstate(invalid="ignore"):
            assert math.isnan(branch(x))


def test_ends_of_both_branches():
    with np.errstate(all="raise"):
        assert math.isnan(w0(NAN))
        assert math.isnan(wm1(NAN))
        assert w0(math.inf) == math.inf
        assert math.copysign(1.0, w0(-0.0)) == -1.0
        assert math.copysign(1.0, w0(0.0)) == 1.0
    with np.errstate(divide="raise"), pytest.raises(FloatingPointError, match="divide by zero"):
        wm1(0.0)
    with np.errstate(divide="ignore"):
        assert same(wm1(np.array([-0.0, 0.0, -0.2])), [-math.inf, -math.inf, -2.5426413577735265])
    with np.errstate(invalid="ignore"):
        assert math.isnan(wm1(1e-300))


# One of a, c, d is 0: no second root, and no flag.
@pytest.mark.parametrize(
    ("equation", "expected"),
    [
        ((2, 3, 0, 5), -1.5),
        ((2, 3, 0, 0), -1.5),
        ((2, 3, 7, 0), -5.0),
        ((2, 1e308, 1e308, 0), -1e308),
        ((0, 3, -3, 2), 0.0),
        ((0, 3, -6, 2), math.log(0.5) / 2),
        ((0, 1, -1 - 2**-52, 1), -(2.0**-52) + 2.0**-105),
        ((0, 3, 6, 2), NAN),
        ((0, 0, 6, 2), NAN),
    ],
)
def test_degenerate_equations(equation, expected):
    with np.errstate(all="raise"):
        assert same(roots(*equation), (expected, NAN))


@pytest.mark.parametrize(
    "equation",
    [(0, 1, 1, 0), (0, 1, 0, 1), (0, 0, 0, 0), (math.inf, 1, -math.inf, 1), (1, -math.inf, math.inf, 1)],
)
def test_no_equation_for_t_is_invalid(equation):
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match="invalid"):
        roots(*equation)
    with np.errstate(invalid="ignore"):
        assert same(roots(*equation), (NAN, NAN))


def test_a_double_root_and_none():
    with np.errstate(all="raise"):
        assert roots(1, 1, -1, 1) == (0.0, 0.0)
        assert roots(-4, 2, -2, -2) == (0.0, 0.0)
        assert same(roots(1, 1, -1 - 2**-52, 1), (NAN, NAN))
        assert same(roots(1, math.nextafter(1, 0), -1, 1), (NAN, NAN))
        below, above = roots(1, 1 + 2**-52, -1, 1)
        assert -2.2e-8 < below < -2.1e-8
        assert 2.1e-8 < above < 2.2e-8
        assert same(roots(1, NAN, -1, 1), (NAN, NAN))


def test_a_root_at_0_is_exact_on_its_branch():
    assert roots(1, 2, -2, 1)[1] == 0.0
    assert roots(1, 0.5, -0.5, 1)[0] == 0.0
    assert same(roots(1, -0.1, 0.1, 3), (0.0, NAN))


@pytest.mark.parametrize(
    ("equation", "expected"),
    [
        ((math.inf, 1, 2, 1), (0.0, NAN)),
        ((math.inf, 1, -2, -1), (0.0, NAN)),
        ((math.inf, 1, -2, 1), (0.0, math.inf)),
        ((1, math.inf, 2, 1), (-math.inf, NAN)),
        ((1, -math.inf, 2, 1), (math.inf, NAN)),
        ((1, -math.inf, -2, 1), (NAN, NAN)),
        ((1, 2, math.inf, 1), (-math.inf, NAN)),
        ((1, 2, -math.inf, 1), (NAN, NAN)),
        ((1, 2, -3, math.inf), (-2.0, 0.0)),
        ((1, -2, 3, math.inf), (0.0, NAN)),
    ],
)
def test_limits_come_without_a_flag(equation, expected):
    with np.errstate(all="raise"):
        assert same(roots(*equation), expected)


@pytest.mark.parametrize(
    ("equation", "expected"),
    [
        ((1, -1e300, 3, 1), (689.6769156095456, NAN)),
        ((1, 1e300, -3, 1), (-1e300, 689.6769156095456)),
        ((1, 1e-300, -3e-300, 1), (2e-300, 696.222585024823)),
        ((1e250, 1, -1e-300, 1e250), (-1e-250, 6.973242113793527e-248)),
    ],
)
def test_nothing_overflows(equation, expected):
    with np.errstate(over="raise", invalid="raise", divide="raise"):
        assert roots(*equation) == pytest.approx(expected, rel=1e-12, nan_ok=True)


def test_the_impact_time_is_a_root():
    """Figure 4 of the projectile paper: launch by W-1, landing by W0."""
    k, theta, v, g = 0.5, 0.9, 50.0, 32.2
    u = -1 - k * v * math.sin(theta) / g
    landing, launch = roots(-k, -u, u, -k)
    assert launch == 0.0
    assert landing == pytest.approx(projectile.flight_time(theta, v=v, g=g, k=k), rel=1e-14)


def test_like_a_numpy_function():
    x = np.array([[0.5, 1.0], [2.0, 3.0]])
    out = np.empty((2, 2))
    assert lambert.w0(x, out=out, where=x > 0.75) is out
    assert np.array_equal(out[x > 0.75], w0(x)[x > 0.75])
    t0, tm1 = roots(1.0, x[:, :1], -x[0], 1)
    assert t0.shape == tm1.shape == (2, 2)
    assert t0.dtype == np.float64
    assert t0[1, 0] == roots(1.0, 2.0, -0.5, 1.0)[0]
    with pytest.raises(TypeError):
        roots(1, 2, 1j, 1)
    with pytest.raises(TypeError):
        w0(x.astype(complex))
