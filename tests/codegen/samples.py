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


_BRANCH_POINT = 0.3678794411714423


def _of_branch(rng, n, width, domain):
    """Arguments of W on either side of 0, or on its lower branch; some close to the branch point."""
    close = -_BRANCH_POINT * (1 - 10.0 ** rng.uniform(-16, 0, n))
    small = -_BRANCH_POINT * 10.0 ** rng.uniform(-width, 0, n)
    large = 10.0 ** rng.uniform(-width, width, n) if domain == "branch" else small
    return np.choose(rng.integers(0, 3, n), [close, small, large])


def arguments(function, force_set, n, width, seed):
    """Return one array for each argument of a kernel, log-uniform over 10**-width to 10**width."""
    rng = np.random.default_rng(seed)
    drawn = {}
    for argument in function.arguments(force_set):
        if argument.name == "theta":
            drawn["theta"] = _angles(rng, n, argument.domain == "chord angle")
        elif argument.name == "mu":
            drawn["mu"] = _frictions(rng, n, width, drawn.get("theta", np.full(n, 0.7)))
        elif argument.domain in ("branch", "lower branch"):
            drawn[argument.name] = _of_branch(rng, n, width, argument.domain)
        elif argument.domain == "real":
            drawn[argument.name] = rng.choice([-1.0, 1.0], n) * 10.0 ** rng.uniform(-width, width, n)
        else:
            drawn[argument.name] = 10.0 ** rng.uniform(-width, width, n)
    if "r" in drawn:
        drawn["r"] = _ranges(rng, n, **drawn)
    return drawn


def _ranges(rng, n, r, v, g, k=0.0):
    """Shares of v**2/(g + k v), which is below the largest range, of any size or close to 1."""
    exponent = 2 * np.log10(v) - np.log10(g + k * v)
    share = np.choose(rng.integers(0, 2, n), [np.minimum(r, 1.0), 1 - 10.0 ** rng.uniform(-9, 0, n)])
    return share * 10.0 ** np.clip(exponent - 1e-9, -290, 300)


def awkward(function, force_set, n, seed, dtype):
    """Ordinary arguments with others strewn among them: 0, tiny, huge, infinite, NaN, beyond the domain."""
    rng = np.random.default_rng(seed)
    odd = np.array([0.0, -0.0, 5e-324, 1e-300, 1e-200, 1e-31, 1e31, 1e200, 1e308, np.inf, np.nan, -1.0, np.pi / 2, 2.0])
    values = []
    for value in arguments(function, force_set, n, 8, seed=seed).values():
        struck = rng.random(n) < 0.06
        with np.errstate(over="ignore", under="ignore"):
            values.append(np.where(struck, rng.choice(odd, n), value).astype(dtype))
    return values


def plain_results(results, least, missing=False):
    """Where all results are finite and far from the smallest numbers: these raise no flag, nor does a constant 0.

    ``missing`` says that NaN is an answer, too: that there is none.
    """
    sizes = np.where(missing & np.isnan(results), 1.0, np.abs(results))
    sizes = sizes[sizes.max(axis=1) != 0]
    return np.all((sizes > least) & (sizes < 1 / least), axis=0)
