"""The primitives of x + x_lo, in C and NumPy, and those of x in NumPy: as good as they say, within their domain."""

import ctypes
import subprocess

import compiled
import numpy as np
import pytest
from mpmath import mp, mpf
from special_points import ITSELF, LIMITS, points, reference

from galileo_sym.codegen.pairs import PAIRS
from galileo_sym.generated import special
from galileo_sym.primitives.elementary import HALF_PI
from galileo_sym.primitives.kernels import BANKED, KERNELS
from galileo_sym.primitives.lambert_frames import INVERSE_E, INVERSE_E_LO
from galileo_sym.primitives.lines import Line, alone

SHIM = """#define GS_LANES 1
#include <fenv.h>
#include "galileo_pairs.h"
#define TRIED(name)                                                                                       \\
    void single_##name(size_t n, const double *x, double *r, double *lo);                                 \\
    void pair_##name(size_t n, const double *x, const double *x_lo, double *r, double *lo);               \\
    int flags_##name(double x, double x_lo);                                                              \\
    void pair_##name(size_t n, const double *x, const double *x_lo, double *r, double *lo)                \\
    {                                                                                                     \\
        for (size_t i = 0; i < n; i++)                                                                    \\
            r[i] = gs_##name##_pair(x[i], x_lo[i], lo + i);                                               \\
    }                                                                                                     \\
    int flags_##name(double x, double x_lo)                                                               \\
    {                                                                                                     \\
        volatile double r, lo;                                                                            \\
        double rest;                                                                                      \\
        feclearexcept(FE_ALL_EXCEPT);                                                                     \\
        r = gs_##name##_pair(x, x_lo, &rest);                                                             \\
        lo = rest;                                                                                        \\
        (void)r, (void)lo;                                                                                \\
        return fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) != 0;                                \\
    }
#define SINGLE(name)                                                                                      \\
    void single_##name(size_t n, const double *x, double *r, double *lo)                                  \\
    {                                                                                                     \\
        for (size_t i = 0; i < n; i++)                                                                    \\
            r[i] = gs_##name##_value(x[i], lo + i);                                                       \\
    }
"""
pytestmark = pytest.mark.xdist_group("pairs")  # compiled once
CLAIM = mpf(2) ** -57
LEAST = 2.0**-922  # smaller values have no room for a rest
UNSETTLED = 2.0**-900  # below, the rest of an offset is up to three quarters of an ulp
LAST = {"exp_minus": 638.0}  # beyond, the rest is not kept
FIRST = dict.fromkeys(
    ["range_loss", "grown_balance"], 1e-25
)  # nearer to 0 the reference takes W of thousands of digits
LARGEST = np.finfo(float).max
VALUES = [name for name in PAIRS if not name.startswith("exp_") or name in KERNELS]
FINAL_PAIRS = {  # pairs beyond the doubles of the domain
    "w0": [(-INVERSE_E, -INVERSE_E_LO), (-INVERSE_E, 1.5e-17), (-INVERSE_E, 2.7e-17)],
    "wm1": [(-INVERSE_E, -INVERSE_E_LO), (-INVERSE_E, 1.5e-17), (-INVERSE_E, 2.7e-17)],
    "sin": [(HALF_PI[0], HALF_PI[1]), (-HALF_PI[0], -HALF_PI[1]), (HALF_PI[0], -1e-16)],
    "cos": [(HALF_PI[0], 6.1e-17), (-HALF_PI[0], -6.1e-17), (HALF_PI[0], -1e-16)],
}


@pytest.fixture(scope="module")
def shims(tmp_path_factory):
    """The pair functions, by each compiler there is."""
    if not compiled.compilers():
        pytest.skip("no C compiler on PATH: the C back end is not tested")
    folder, found = tmp_path_factory.mktemp("pairs"), []
    source = folder / "pairs.c"
    source.write_text(SHIM + "".join(f"TRIED({n})\n" for n in PAIRS) + "".join(f"SINGLE({n})\n" for n in KERNELS))
    for compiler in compiled.compilers():
        target = folder / f"lib{compiler}.so"
        flags = [*compiled.FLAGS, f"-I{compiled.SOURCES}", "-shared"]
        subprocess.run([compiler, *flags, str(source), "-o", str(target), "-lm"], check=True)
        found.append(ctypes.CDLL(str(target)))
    return found


def _called(function, *arguments):
    arrays = [np.ascontiguousarray(a, dtype=np.float64) for a in arguments]
    r, lo = np.empty_like(arrays[0]), np.empty_like(arrays[0])
    function.restype = None
    function(ctypes.c_size_t(r.size), *(ctypes.c_void_p(a.ctypes.data) for a in (*arrays, r, lo)))
    return r, lo


def _pairs(name, count):
    """Arguments with rests of all sizes up to half an ulp."""
    rng = np.random.default_rng(3)
    x = points(name, count)
    x = x[(abs(x) < LAST.get(name, np.inf)) & (abs(x) > FIRST.get(name, 1e-290))]
    x_lo = np.spacing(abs(x)) * rng.uniform(-0.5, 0.5, x.size) * rng.choice([1.0, 1.0, 1e-4], x.size)
    inside = [lower < a < upper for a in x for lower, upper in [PAIRS[name].domain]]
    extra = FINAL_PAIRS.get(name, [])
    return [np.concatenate([np.array(a)[inside], [p[k] for p in extra]]) for k, a in enumerate((x, x_lo))]


def _judge(name, x, x_lo, r, lo, hi_bound):
    for a, b, h, k in zip(x, x_lo, r, lo, strict=True):
        exact = reference(name, a, b)
        ulp = float(np.spacing(abs(h)))
        settled = 0.75 if name.endswith("_offset") and a < UNSETTLED else hi_bound
        with mp.workdps(60):
            assert abs(mpf(float(h)) - exact) <= settled * ulp, (a, b)
            assert abs(k) <= settled * ulp, (a, b)
            if abs(h) >= LEAST:
                assert abs(mpf(float(h)) + float(k) - exact) <= CLAIM * abs(exact), (a, b)


@pytest.mark.parametrize("name", VALUES)
def test_pairs_in_c(name, shims):
    x, x_lo = _pairs(name, 120)
    first, *others = [_called(getattr(shim, f"pair_{name}"), x, x_lo) for shim in shims]
    _judge(name, x, x_lo, *first, 0.55)
    for other in others:
        assert all(np.array_equal(a, b) for a, b in zip(first, other, strict=True))


@pytest.mark.parametrize("name", VALUES)
def test_pairs_in_numpy(name):
    x, x_lo = _pairs(name, 120)
    _judge(name, x, x_lo, *getattr(special, f"{name}_pair")(x, x_lo), 0.6)


@pytest.mark.parametrize("name", KERNELS)
def test_single_numbers_in_numpy(name, shims):
    """Within 0.6 ulp, hi + lo good to 2^-57, and seldom another double than that of C."""
    x = _pairs(name, 150)[0]
    x = x[(x >= KERNELS[name].domain[0]) & (x <= KERNELS[name].domain[1])]
    _judge(name, x, 0.0 * x, *getattr(special, name)(x), 0.6)
    x = points(name, 4000)
    value, of_c = getattr(special, name)(x)[0], _called(getattr(shims[0], f"single_{name}"), x)[0]
    assert np.mean(value != of_c) < 0.01
    assert (abs(value - of_c) <= np.spacing(abs(of_c))).all()


def _single_and_pair(name, x):
    """What is to have the same bits: the functions of x, and those of x + 0."""
    return getattr(special, name)(x), getattr(special, f"{name}_pair")(x, 0.0 * x)


@pytest.mark.parametrize("name", KERNELS)
def test_a_rest_of_0_changes_no_bit(name, shims):
    """What is left of the lines where x_lo is 0 has the same result; beyond its pieces C gives a single x no rest."""
    x = np.concatenate([points(name, 500), [0.0, -0.0]])
    x = x[x != KERNELS[name].pole]
    for a, b in zip(*_single_and_pair(name, x), strict=True):
        assert np.array_equal(np.where(a == 0.0, 0.0, a).view(np.int64), np.where(b == 0.0, 0.0, b).view(np.int64))
    if name in BANKED:
        x = x[x < BANKED[name].end]
    single = _called(getattr(shims[0], f"single_{name}"), x)
    for a, b in zip(single, _called(getattr(shims[0], f"pair_{name}"), x, 0.0 * x), strict=True):
        assert np.array_equal(a, b)


@pytest.mark.parametrize("name", VALUES)
def test_edges_and_flags(name, shims):
    (lower, _), (upper, _) = PAIRS[name].ends
    step = 1e-20
    good = [x for x in (0.0, 5e-324, 1e-300, 0.3, 1.0, 50.0, 1e10, 1e200, LARGEST, np.inf) if lower < x < upper]
    good = [(x, 0.0) for x in good] + [(v, lo) for v, lo in PAIRS[name].ends]
    bad = [(v, lo - step * (v < upper) + step * (v == upper)) for v, lo in PAIRS[name].ends if np.isfinite(v)]
    bad += [(x, 0.0) for x in (-np.inf, np.inf, -1.0, -5e-324) if not lower <= x <= upper]
    for shim in shims:
        flags = getattr(shim, f"flags_{name}")
        flags.argtypes = [ctypes.c_double, ctypes.c_double]
        assert [p for p in good if flags(*p)] == []
        assert [p for p in bad if not flags(*p)] == []
        assert flags(np.nan, 0.0) == 0
        assert np.isnan(_called(getattr(shim, f"pair_{name}"), *zip(*bad, strict=True))[0]).all() if bad else True
    paired = getattr(special, f"{name}_pair")
    with np.errstate(all="raise", under="ignore"):
        assert not np.isnan(paired(*np.array(good).T)[0]).any()
        assert np.isnan(paired(np.nan, 0.0)[0])
        for p in bad:
            with pytest.raises(FloatingPointError):
                paired(*p)
    at_zero, at_infinity = LIMITS[name]
    for function in (lambda x: paired(x, 0.0), getattr(special, name)):
        if at_zero is not ITSELF:
            with np.errstate(divide="ignore"):  # a pole
                assert function(0.0)[0] == function(-0.0)[0] == at_zero
        else:
            assert [np.signbit(function(x)[0]) for x in (0.0, -0.0)] == [False, True]
        if upper == np.inf:
            assert function(np.inf)[0] == at_infinity


def test_the_exponential_beyond_the_smallest_double(shims):
    """exp(-x) as (hi + lo) 2^-m."""
    x = np.random.default_rng(5).uniform(0.0, 2.0**15, 300)
    x_lo = np.spacing(x) * 0.4
    of_c = [_called(getattr(shims[0], f"pair_{name}"), x, x_lo) for name in ("exp_mantissa", "exp_exponent")]
    of_numpy = [special.exp_mantissa_pair(x, x_lo), special.exp_exponent_pair(x, x_lo)]
    for (hi, lo), (m, nothing) in (of_c, of_numpy):
        assert (nothing == 0.0).all()
        assert ((hi > 0.5) & (hi < 1.03)).all()
        for a, b, h, k, e in zip(x, x_lo, hi, lo, m, strict=True):
            with mp.workdps(60):
                exact = mp.ldexp(mp.exp(-(mpf(float(a)) + float(b))), int(e))
                assert abs(mpf(float(h)) + float(k) - exact) <= CLAIM * exact, a
    for function in (special.exp_mantissa_pair, special.exp_exponent_pair):
        assert [float(part) for part in function(np.inf, 0.0)] == [0.0, 0.0]


def test_an_operation_without_a_rule_for_0_is_refused():
    with pytest.raises(ValueError, match="x_lo is 0 has no rule"):
        alone([Line("r", "sqrt", ("x_lo",)), Line("lo", "copy", (0.0,))])
