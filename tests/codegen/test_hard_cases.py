"""The hard cases of tests/data: the same bits from every version, binary64 within 0.55 ulp, the nearest binary32."""

import ctypes
import math
import sys
from fractions import Fraction
from pathlib import Path

import compiled
import numpy as np
import pytest

from galileo_sym.primitives.kernels import KERNELS

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))

from exhaustive import certain, libraries, results, wc_files  # noqa: E402

BOUND = Fraction(55, 100)  # ulp


def values(name, x):
    """{version: values} of all versions there are."""
    found = {}
    for suffix in ("plain", *libraries.suffixes()):
        value = np.empty_like(x)
        function = getattr(compiled.library(), f"gs_{name}_n{'f' * (x.dtype == np.float32)}_{suffix}")
        function.restype = None
        function(ctypes.c_size_t(x.size), ctypes.c_void_p(x.ctypes.data), ctypes.c_void_p(value.ctypes.data))
        found[suffix] = value
    return found


@pytest.mark.parametrize("name", KERNELS)
def test_the_file_is_complete(name):
    """All thresholds, a worst case between each two, and what the exhaustive run found hardest."""
    known = set(wc_files.read(name))
    assert set(wc_files.ends(name)) <= known, "run `make hard-cases`"
    assert all(any(low <= sign * x <= high for x in known) for low, high, sign in wc_files.sizes(name))
    row = results.kept()["exhaustive"].get(name, {"inputs": {"hard": []}})
    assert {certain.of_bits(int(bits, 16)) for bits in row["inputs"]["hard"]} <= known, "run `make hard-cases`"


@pytest.mark.parametrize("name", KERNELS)
def test_binary64(name):
    x = np.array(wc_files.read(name))
    plain, *others = values(name, x).values()
    assert all(np.array_equal(plain.view(np.uint64), other.view(np.uint64)) for other in others)
    for a, value in zip(x, plain, strict=True):
        allowed = BOUND * Fraction(math.ulp(value))
        assert certain.sign(name, a, Fraction(value) - allowed) > 0, a.hex()
        assert certain.sign(name, a, Fraction(value) + allowed) < 0, a.hex()


@pytest.mark.parametrize("name", KERNELS)
def test_binary32(name):
    x = wc_files.floats(wc_files.read(name))
    plain, *others = values(name, x).values()
    assert all(np.array_equal(plain.view(np.uint32), other.view(np.uint32)) for other in others)
    assert x.size > 10
    for a, value in zip(x, plain, strict=True):
        assert certain.is_nearest(name, float(a), float(value)), float(a).hex()
