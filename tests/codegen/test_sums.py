"""Sums of two products over grids: the same bits from every version, the ufunc and NumPy; digits are kept."""

import ctypes
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from compiled import SOURCES, compilers

from galileo_sym import _backend
from galileo_sym.codegen.kernels import runnable
from galileo_sym.generated._scaled import Scaled
from galileo_sym.libraries import FLAGS, kept_library
from galileo_sym.scenes.factors import halved_factor
from galileo_sym.scenes.points import _sum_at_once, _sum_in_passes

PLAIN = '#define GS_LANES 1\n#define GS_SUFFIX _plain\n#include "sums.h"\n'
DRAW = np.random.default_rng(9)


def factors(shapes):
    """Four factors in two parts, over arrays of some shapes."""
    found = []
    for shape in shapes:
        hi = DRAW.uniform(0.5, 1.0, shape)
        found.append(halved_factor(Scaled(hi, hi * DRAW.uniform(-(2.0**-54), 2.0**-54, shape), np.int32(0))))
    return [*found[:2], found[2]._replace(parts=tuple(-part for part in found[2].parts)), found[3]]


def by_numpy(found, shape):
    """The sums by the operations of NumPy, the stand-in for the extension."""
    target = np.empty(shape)
    _sum_in_passes([(1, found[:2]), (1, found[2:])], target)
    return target


def parts_of(found):
    return [part for factor in found for part in factor.parts]


@pytest.mark.parametrize("compiler", compilers())
def test_every_version_has_the_same_bits(compiler, tmp_path):
    """Whatever varies, and however many elements are left for the last vector."""
    (tmp_path / "plain.c").write_text(PLAIN)
    extension = SOURCES.parent / "extension"
    sources = [tmp_path / "plain.c", extension / "sums_avx2.c", extension / "sums_avx512.c"]
    library = ctypes.CDLL(str(kept_library(sources, [compiler], [*FLAGS, f"-I{SOURCES}"])))
    for varying, n in product(range(16), (1, 7, 8, 19)):
        found = factors([n if varying >> k & 1 else 1 for k in range(4)])
        expected, parts = by_numpy(found, n), [np.ascontiguousarray(part) for part in parts_of(found)]
        places = (ctypes.c_void_p * 8)(*(part.ctypes.data for part in parts))
        for version in set(runnable()) - {"fma"}:
            out = np.full(n + 1, np.nan)
            getattr(library, f"gs_sums_{version}")(
                ctypes.c_size_t(n), varying, places, ctypes.c_void_p(out.ctypes.data)
            )
            np.testing.assert_array_equal(out[:n], expected, strict=True)
            assert np.isnan(out[n])


@pytest.mark.skipif(_backend.EXTENSION is None, reason="no compiled extension")
def test_the_ufunc_has_the_same_bits_whatever_the_layout():
    sums = _backend.EXTENSION._sum_of_products
    for shapes in (
        [(5, 1), (1, 300), (5, 1), ()],
        [(300,)] * 4,
        [(), (), (7, 40), (40,)],
        [()] * 4,
        [(3, 1), (0,)] * 2,
    ):
        found = factors(shapes)
        expected = by_numpy(found, np.broadcast_shapes(*shapes))
        np.testing.assert_array_equal(sums(*parts_of(found)), expected)
        single = np.empty(expected.shape, np.float32)
        np.testing.assert_array_equal(sums(*parts_of(found), out=single, casting="same_kind"), expected.astype("f4"))
    found = factors([(600,)] * 4)
    expected, parts = by_numpy(found, 600), parts_of(found)
    every_third = [np.repeat(part, 3)[::3] for part in parts]
    np.testing.assert_array_equal(sums(*(part[::-1] for part in every_third), out=np.empty(1200)[::2]), expected[::-1])
    np.testing.assert_array_equal(sums(*parts, out=parts[3]), expected)


@pytest.mark.parametrize("way", [_sum_in_passes, *([_sum_at_once] if _backend.EXTENSION else [])])
def test_sums_keep_their_digits_where_they_cancel(way):
    """d is the pair next to -a b/c, so that of the sum nothing is left but its rounding."""
    found = factors([(1,), (200,), (1,), (200,)])
    (a,), b, (c,), _ = ([sum(map(Fraction, parts)) for parts in zip(*f.parts, strict=True)] for f in found)
    d = [-a * one / c for one in b]
    hi = np.array([float(one) for one in d])
    lo = np.array([float(one - Fraction(high)) for one, high in zip(d, hi, strict=True)])
    found[3] = halved_factor(Scaled(hi, lo, np.int32(0)))
    sums = np.empty(200)
    way([(1, found[:2]), (1, found[2:])], sums)
    for value, one, other in zip(sums, b, zip(hi, lo, strict=True), strict=True):
        assert abs(Fraction(value) - a * one - c * sum(map(Fraction, other))) <= Fraction(2) ** -76 * abs(a * one)
