"""The primitives in closed form by Lambert W, for samples: the precision doubles until two values agree."""

from mpmath import mp, mpf

_AGREE = 40  # digits
_MOST = 20000


def _offset(p, branch):
    """1 + W(-exp(-1 - p^2/2)), with the sign that makes it positive."""
    value = 1 + mp.lambertw(-mp.exp(-1 - p * p / 2), branch).real
    return value if branch == 0 else -value


def _descent(p):
    return p * p / 2 + _offset(p, 0)


def _flight(b):
    y = 1 + b
    return y + mp.lambertw(-y * mp.exp(-y)).real


def _best(a):
    return 1 + mp.lambertw((a * a - 1) / mp.e).real


def _ratio(q):
    x = (q * q / 2 - 1) / mp.e
    return mp.lambertw(x).real / x


CLOSED = {
    "phi1m": lambda z: -mp.expm1(-z) / z,
    "phi2m": lambda z: (z + mp.expm1(-z)) / z**2,
    "descent_factor": lambda p: _descent(p) / p,
    "rise_factor": lambda p: -mp.expm1(-_descent(p)) / p,
    "fall_factor": lambda p: _offset(p, -1) / p,
    "flight_factor": lambda b: _flight(b) / (2 * b),
    "range_factor": lambda b: -mp.expm1(-_flight(b)) / (2 * b),
    "best_sine": lambda a: a / mp.expm1(_best(a)),
    "best_angle": lambda a: mp.asin(a / mp.expm1(_best(a))),
    "max_range_factor": lambda a: mp.sqrt(1 - (1 + _best(a)) * mp.exp(-_best(a))) / a,
    "w0_ratio": _ratio,
    "exp_minus": lambda z: mp.exp(-z),
    "sin": mp.sin,
    "cos": mp.cos,
    "arctan": mp.atan,
    "w0": lambda x: mp.lambertw(x).real,
    "wm1": lambda x: mp.lambertw(x, -1).real,
    "w0_offset": lambda x: 1 + mp.lambertw(-mp.exp(-1 - x)).real,
    "wm1_offset": lambda x: 1 + mp.lambertw(-mp.exp(-1 - x), -1).real,
}


class NoReference(Exception):
    """There is no reference for a primitive, or none at an argument."""


def _value(name, x):
    """Return the closed form at the precision of now, or None where it is 0/0."""
    try:
        return CLOSED[name](mpf(x)) if x else None
    except ZeroDivisionError:
        return None


def reference(name, x):
    """The value of a primitive, certain to 40 digits.

    Parameters
    ----------
    name : str
        A key of `CLOSED`.
    x : float
        Not 0.

    Returns
    -------
    mpf

    Raises
    ------
    NoReference
        If there is no definition of that name, or its values do not settle.
    """
    if name not in CLOSED:
        raise NoReference(f"{name} has no definition in references.py, so it cannot be sampled")
    digits, before = 60, None
    while digits < _MOST:
        with mp.workdps(digits):
            value = _value(name, x)
            if before is not None and value and abs(value - before) <= abs(value) * mpf(10) ** -_AGREE:
                return value
        before, digits = value, 2 * digits
    raise NoReference(f"{name} at {x!r}: no two values agree to {_AGREE} digits below {_MOST}")
