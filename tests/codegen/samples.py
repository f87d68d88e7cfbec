"""Random arguments over all magnitudes, for each kernel."""

import math

import numpy as np

HALF_PI = math.pi / 2


def _angles(rng, n, signed):
    plain = rng.uniform(0, HALF_PI, n)
    tiny = 10.0 ** rng.uniform(-300, 0, n)
    steep = HALF_PI - 10.0 ** rng.uniform(-16, 0, n)
    angles = np.choose(rng.integers(0, 3, n), [plain, tiny, steep]).clip(0, HALF_PI)
    return np.where(signed & (rng.random(n) < 0.5), -angles, angles)


def _frictions(rng, n, width, theta):
    """Coefficients of any size, some that just let a bead slide, and some within ulps of the one that holds it."""
    limit = 1 / np.tan(np.abs(theta).clip(1e-290))
    anything = 10.0 ** rng.uniform(-width, width, n)
    below = limit * rng.uniform(0, 1, n)
    close = limit * (1 + rng.integers(-64, 65, n) * 2.0**-52)
    return np.choose(rng.integers(0, 3, n), [anything, below, close])


def arguments(function, force_set, n, width, seed):
    """Return one array for each argument of a kernel, log-uniform over 10**-width to 10**width."""
    rng = np.random.default_rng(seed)
    drawn = {}
    for argument in function.arguments(force_set):
        if argument.name == "theta":
            drawn["theta"] = _angles(rng, n, argument.domain == "chord angle")
        elif argument.name == "mu":
            drawn["mu"] = _frictions(rng, n, width, drawn.get("theta", np.full(n, 0.7)))
        else:
            drawn[argument.name] = 10.0 ** rng.uniform(-width, width, n)
    return drawn
