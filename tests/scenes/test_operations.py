"""Steps by the extension: the bits of the NumPy modules, whatever the size of the numbers and the layout."""

import numpy as np
import pytest

from galileo_sym import _backend
from galileo_sym.generated import _angle, _scaled
from galileo_sym.scenes import operations
from galileo_sym.scenes.plan import PRIMITIVES

pytestmark = pytest.mark.skipif(_backend.EXTENSION is None, reason="no compiled extension: NumPy does all steps")

DRAW = np.random.default_rng(5)
EDGES = [0.0, 5e-324, 2.0**-1022, 2.0**-500, 1.0, 1.5, 2.0**499, 2.0**500, 1.7e308, np.inf]
NUMBERS = np.concatenate([EDGES, 10.0 ** DRAW.uniform(-3.0, 3.0, 40), 2.0 ** DRAW.uniform(-1000.0, 1000.0, 40)])
ANGLES = np.concatenate([[0.0, 1e-300, 2.0**-61, np.pi / 4, np.pi / 2], DRAW.uniform(0.0, np.pi / 2, 40)])
ANGLES = np.concatenate([ANGLES, -ANGLES, np.arctan(1 / 0.36) + np.arange(-4, 5) * 2.0**-52])
ONE = _scaled.load(NUMBERS[:, None])
OTHER = _scaled.mul(_scaled.load(NUMBERS[10:]), _scaled.load(1.0 + DRAW.uniform(0.0, 1.0, 80)))
TURNED = _angle.angle(ANGLES[:, None])
MU = _scaled.load(np.array([0.0, 0.36, 1e-200, 1e200]))
MANY = _scaled.Scaled(*(np.ascontiguousarray(x) for x in np.broadcast_arrays(*_scaled.mul(ONE, OTHER))))
OPERANDS = {
    "load": [(NUMBERS,), (NUMBERS[::-3],)],
    "angle": [(ANGLES,), (ANGLES[7],)],
    "driving": [(TURNED, MU), (_angle.angle(ANGLES[:50]), _scaled.load(np.float64(0.36)))],
    **{name: [(ONE, OTHER), (OTHER, OTHER)] for name in ("mul", "div", "add", "sub")},
    **{name: [(MANY,), (OTHER,)] for name in ("sqrt", *PRIMITIVES)},
    **{name: [(MANY, 0.0), (OTHER, 0.0)] for name in ("round",)},
    **{name: [(MANY,), (_scaled.Scaled(MANY.hi, MANY.lo, MANY.e % 900 - 450),)] for name in ("halves", "parts")},
}


def numbers_of(value):
    """All arrays of what a step gives."""
    return [part for one in value for part in numbers_of(one)] if isinstance(value, tuple) else [value]


@pytest.mark.parametrize("name", OPERANDS)
def test_the_bits_are_those_of_numpy(name):
    assert operations.OPERATIONS[name] is not operations.BY_NUMPY[name]
    for operands in OPERANDS[name]:
        with np.errstate(all="ignore"):
            found, expected = (
                numbers_of(made[name](*operands)) for made in (operations.OPERATIONS, operations.BY_NUMPY)
            )
        for one, other in zip(found, expected, strict=True):
            if other is None:
                assert one is None
                continue
            np.testing.assert_array_equal(one, other)
            if np.asarray(other).dtype.kind == "f":
                np.testing.assert_array_equal(np.signbit(one), np.signbit(other))


def test_where_the_bead_rests_the_value_at_rest_is_in_range():
    turned, mu = _angle.angle(ANGLES[:50]), _scaled.load(np.float64(0.36))
    for made in (operations.OPERATIONS, operations.BY_NUMPY):
        force = made["driving"](turned, mu)
        factor = made["round"](_scaled.scale(made["mul"](force, force), 5000), np.inf, force)
        assert np.all(np.isinf(factor.parts[0][force.held]))
        np.testing.assert_array_equal(factor.odd, ~force.held)
