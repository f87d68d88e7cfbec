"""Roots of a t + b + c exp(d t): decided exactly beside the double root, and accurate there, too."""

import shutil
import subprocess
import sys
from fractions import Fraction

import compiled
import numpy as np
import printed_forms
import pytest
from mpmath import mp, mpf

from galileo_sym import processor
from galileo_sym.generated import _elementary, _excess, _scaled, lambert

ROOTS = "gs_lambert_linear_exponential_roots_n"


def _hold(a, b, c, d):
    """Both back ends against the printed form: which roots there are, and where."""
    found = lambert.linear_exponential_roots(a, b, c, d)
    for result, other in zip(found, compiled.call(ROOTS, [a, b, c, d], 2), strict=True):
        assert np.array_equal(result.view(np.int64), other.view(np.int64))
    for i in range(a.size):
        exact = printed_forms.linear_exponential_roots(a[i], b[i], c[i], d[i])
        for result, root in zip(found, exact, strict=True):
            assert printed_forms.ulps(float(result[i]), root) <= 0.51, (a[i], b[i], c[i], d[i])
    return found


def test_all_neighbours_of_a_double_root():
    """b = 1 + i/2**52, c = -1 - j/2**52: the roots are 1e-16 to 1e-8 apart, or there are none."""
    i, j = (x.ravel().astype(float) for x in np.mgrid[-6:7, -6:7])
    off = (i != 0) | (j != 0)
    one = np.ones(off.sum())
    first, second = _hold(one, 1 + i[off] * 2.0**-52, -1 - j[off] * 2.0**-52, one)
    assert 0 < np.isnan(first).sum() < first.size
    assert np.array_equal(np.isnan(first), np.isnan(second))


@pytest.mark.parametrize("places", [-3, -1, 1, 3])
def test_the_last_places_before_a_double_root(places):
    rng = np.random.default_rng(places + 10)
    c, d = -(10.0 ** rng.uniform(-3, 3, 40)), 10.0 ** rng.uniform(-1, 1, 40)
    b = (1 + np.log(-c * d)) / d
    _hold(np.ones(40), b + places * np.spacing(b), c, d)


def test_where_a_over_d_is_no_double():
    """b = -c next to a/d: one root is 0, the other twice the rounding of a/d, or a few ulps of it."""
    a, d = (x.ravel().astype(float) for x in np.mgrid[3:20, 3:20])
    b = a / d + (np.arange(a.size) % 5 - 2) * np.spacing(a / d)
    apart = [Fraction(x) * Fraction(y) != z for x, y, z in zip(b, d, a, strict=True)]
    first, second = _hold(a[apart], b[apart], -b[apart], d[apart])
    assert first.size > 200
    assert np.all((first == 0) | (second == 0))


def test_double_roots_are_equal_and_exact():
    power = 2.0 ** np.arange(-40, 41, 8)
    found = lambert.linear_exponential_roots(3 * power, 3 * power, -3 * power, np.ones(power.size))
    assert all(np.all(root == 0) for root in found)


@pytest.mark.parametrize("equation", [(1, 1 + 2.0**-52, -1 - 2.0**-52, 1), (-3, -7, 0.25, 5), (1, -600, 2.0**-900, -1)])
def test_distance_from_the_double_root_in_integers(equation):
    values = np.array(equation, dtype=float).reshape(4, 1)
    found = _excess.excess(*values)
    with mp.workprec(1000):
        a, b, c, d = map(mpf, map(float, equation))
        exact = b * d / a - 1 - mp.log(abs(c * d / a))
        value = (mpf(float(found.hi[0])) + mpf(float(found.lo[0]))) * mpf(2) ** int(found.e[0])
        assert abs(value / exact - 1) < mpf(2) ** -104


def _value(pair, i):
    hi, lo, e = (np.broadcast_to(part, 200)[i] for part in pair)
    return (mpf(float(hi)) + mpf(float(lo))) * mpf(2) ** int(e)


@pytest.mark.parametrize(("name", "bits"), [("exponential", 94), ("logarithm", 96)])
def test_exponential_and_logarithm_are_good_to_a_pair(name, bits):
    rng = np.random.default_rng(3)
    wide = rng.choice([-1.0, 1.0], 200) * 10.0 ** rng.uniform(-20, 2.8, 200)
    x = wide if name == "exponential" else np.where(rng.random(200) < 0.5, 1 + 1e-3 * wide / 700, 10.0 ** (wide / 4))
    x = np.abs(x) if name == "logarithm" else x
    sign = np.copysign(1.0, x)
    argument = _scaled.load(np.abs(x))
    result = getattr(_elementary, name)(_scaled.Scaled(sign * argument.hi, argument.lo, argument.e))
    with mp.workprec(400):
        for i in range(200):
            exact = getattr(mp, {"exponential": "exp", "logarithm": "log"}[name])(mpf(float(x[i])))
            assert abs(_value(result, i) - exact) <= abs(exact) * mpf(2) ** -bits


_ALONE = """
import ctypes, sys
import numpy as np
library, target = ctypes.CDLL(sys.argv[1]), sys.argv[2]
columns = [np.ascontiguousarray(x) for x in np.load(target)]
results = np.empty((2, columns[0].size))
roots = [ctypes.c_double(), ctypes.c_double()]
for i, point in enumerate(zip(*columns)):
    library.gs_scaled_lambert_linear_exponential_roots(*map(ctypes.c_double, point), *map(ctypes.byref, roots))
    results[:, i] = [root.value for root in roots]
np.save(target, results)
"""


@pytest.mark.parametrize("march", ["x86-64-v3", "x86-64-v4"])
def test_bits_of_code_compiled_for_larger_machines(tmp_path, march):
    """gcc 12 once made an endless loop of the integers beside a double root, with -O3 and AVX-512."""
    needed = {"x86-64-v3": "avx2", "x86-64-v4": "avx512vl"}[march]
    gcc = shutil.which("gcc")
    if needed not in processor.features() or gcc is None:
        pytest.skip(f"no gcc, or this machine has no {needed}: code for {march} is not run")
    library, target = tmp_path / "libroots.so", tmp_path / "roots.npy"
    others = ("special_", "lanes", "chord", "projectile")
    sources = sorted(path for path in compiled.SOURCES.glob("*.c") if not path.name.startswith(others))
    flags = [*compiled.FLAGS, "-O3", f"-march={march}", "-DGS_PORTABLE", "-shared"]
    subprocess.run([gcc, *flags, *map(str, sources), "-o", str(library), "-lm"], check=True)
    i, j = (x.ravel().astype(float) for x in np.mgrid[-6:7, -6:7])
    columns = [np.ones(i.size), 1 + i * 2.0**-52, -1 - j * 2.0**-52, np.ones(i.size)]
    np.save(target, columns)
    subprocess.run([sys.executable, "-c", _ALONE, str(library), str(target)], check=True, timeout=60)
    expected = compiled.call(ROOTS, columns, 2)
    assert np.load(target).tobytes() == np.array(expected).tobytes()
