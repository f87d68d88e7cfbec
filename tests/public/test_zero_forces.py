"""A force that is 0 in an array acts as one that is left out, where arguments are infinite, too."""

import itertools

import numpy as np
import pytest

from galileo_sym import chord, projectile
from galileo_sym.catalogue import FUNCTIONS

pytestmark = pytest.mark.usefixtures("back_end")
VALUES = (0.0, 5e-324, 1.0, 1e300, np.inf)


@pytest.mark.parametrize("name", [name for name, f in FUNCTIONS.items() if f.forces])
def test_zeros_in_arrays_are_as_scalars(name):
    emitted = FUNCTIONS[name]
    function = getattr({"chord": chord, "projectile": projectile}[emitted.paper], emitted.name)
    lists = [(0.3,) if argument == "theta" else VALUES for argument in (*emitted.positional, *emitted.keywords)]
    grid = np.array(list(itertools.product(*lists))).T
    positional, keywords = grid[: len(emitted.positional)], grid[len(emitted.positional) :]
    named = dict(zip(emitted.keywords, keywords, strict=True))
    for forces in itertools.product((0.0, 1.0, np.inf), repeat=len(emitted.forces)):
        plain = dict(zip(emitted.forces, forces, strict=True))
        full = {force: np.full(grid.shape[1], value) for force, value in plain.items()}
        with np.errstate(all="ignore"):
            assert np.array_equal(
                function(*positional, **named, **plain), function(*positional, **named, **full), equal_nan=True
            ), forces
