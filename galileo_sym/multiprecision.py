"""The primitives at any precision, for plain mpmath numbers.

Each value comes from its defining equation written without cancellation, so that the working precision does not depend
on the size of the argument: 1e-300 and 1e300 cost the same as 1. A value defined by an equation is accepted only when
the equation changes sign between its neighbours at the asked precision; otherwise the precision is raised.
"""

from mpmath import mp, mpf

_GUARD_BITS = 40


def _phi1(z):
    """(exp(z) - 1)/z for real z, 1 at 0."""
    return mp.expm1(z) / z if z else mpf(1)


def _phi2(z):
    """(exp(z) - 1 - z)/z**2 for real z, 1/2 at 0: by its power series where the closed form cancels."""
    if abs(z) > 1:
        return (mp.expm1(z) - z) / z**2
    total = term = mpf(1) / 2
    k = 3
    while abs(term) > mp.eps * total / 4:
        term = term * z / k
        total += term
        k += 1
    return total


def _certain_root(function, slope, start):
    """Return the root x > 0 of an increasing function, by Newton steps, with a proved change of sign about it."""
    x = start
    for _ in range(200):
        step = function(x) / slope(x)
        x = x - step if step < x else x / 2
        if abs(step) <= abs(x) * mp.eps * 64:
            break
    width = mp.eps * 4096
    if not function(x * (1 - width)) < 0 < function(x * (1 + width)):
        raise ArithmeticError(f"no change of sign about {mp.nstr(x, 20)} at {mp.prec} bits; raise the precision")
    return x


def _descent_root(p):
    """tau > 0 with tau - 1 + exp(-tau) = p**2/2."""
    goal = p**2 / 2
    return _certain_root(lambda s: s**2 * _phi2(-s) - goal, lambda s: -mp.expm1(-s), 1 + goal if p > 2 else p * (1 + p))


def _flight_root(b):
    """T > 0 with T/(1 - exp(-T)) = 1 + b, in the form T phi2(-T)/phi1(-T) = b."""

    def slope(s):
        return mp.exp(-s) * _phi2(s) / _phi1(-s) ** 2

    return _certain_root(lambda s: s * _phi2(-s) / _phi1(-s) - b, slope, 2 * b if b < 1 else 1 + b)


def _best_root(a):
    """Return s > 0 with 1 + (s - 1) exp(s) = a**2, from the logarithm of s**2 exp(s) phi2(-s) = a**2."""
    goal = 2 * mp.log(a)

    def function(s):
        return 2 * mp.log(s) + s + mp.log(_phi2(-s)) - goal

    return _certain_root(function, lambda s: 1 / (s * _phi2(-s)), mp.sqrt(2) * a if a < 1 else 1 + goal)


def _omega_root(y):
    """w > 0 with w + log(w) = y."""
    return _certain_root(lambda w: w + mp.log(w) - y, lambda w: 1 + 1 / w, y - mp.log(y) if y > 2 else mpf(1))


def _w0_offset(x):
    """1 + W0(-exp(-1 - x)) = 1 - exp(-tau), for tau - 1 + exp(-tau) = x."""
    return -mp.expm1(-_descent_root(mp.sqrt(2 * x))) if x else mpf(0)


def _log_lag(s):
    """s - log(1 + s) for s > 0, with the bits that the subtraction costs."""
    with mp.extraprec(10 + 2 * max(0, -mp.mag(s))):
        return s - mp.log1p(s)


def _wm1_offset(x):
    """1 + W-1(-exp(-1 - x)) = -s, for s - log(1 + s) = x."""
    if not x:
        return mpf(0)
    p = mp.sqrt(2 * x)
    start = p + x * 2 / 3 if x < 1 else x + mp.log(1 + x) + 1
    return -_certain_root(lambda s: _log_lag(s) - x, lambda s: s / (1 + s), start)


def _branch_factor(r):
    """exp(-W0(x)) at r = sqrt(2 (1 + e x)): by the offset for x < 0, where -x = exp(-1 - y)."""
    square = r**2 / 2
    if square < 1:
        return mp.exp(1 - _w0_offset(-mp.log1p(-square)))
    return mp.exp(-mp.lambertw((square - 1) / mp.e).real)


def _best_sine(a):
    return a / mp.expm1(_best_root(a)) if a else mp.sqrt(mpf(1) / 2)


def _range_factor(b):
    return _flight_root(b) / (2 * b * (1 + b)) if b else mpf(1)


def _range_balance(b):
    """b exp(-T)/(T - b), which is phi2(-T)/phi2(T)."""
    if not b:
        return mpf(1)
    with mp.extraprec(max(0, mp.mag(b))):  # the exponential needs T to within an absolute error
        T = _flight_root(b)
        return _phi2(-T) / _phi2(T)


def _odd_part(T):
    """phi2(T) - phi2(-T), by its power series where it cancels."""
    if T > 1:
        return _phi2(T) - _phi2(-T)
    total = term = T / 3
    k = 4
    while term > mp.eps * total / 4:
        term = term * T**2 / (k * (k + 1))
        total += term
        k += 2
    return total


def _range_loss(b):
    """range_factor (1 - phi2(-T)/phi2(T))/b."""
    if not b:
        return mpf(4) / 3
    T = _flight_root(b)
    return T / (2 * b * (1 + b)) * _odd_part(T) / (_phi2(T) * b)


def _max_range_factor(a):
    """sqrt(1 - (1 + s) exp(-s))/a, which is s exp(-s/2) sqrt(phi2(s))/a."""
    if not a:
        return mpf(1)
    s = _best_root(a)
    return s * mp.sqrt(mp.exp(-s) * _phi2(s)) / a


_VALUES = {
    "phi1": _phi1,
    "phi2": _phi2,
    "descent_factor": lambda p: _descent_root(p) / p if p else mpf(1),
    "flight_factor": lambda b: _flight_root(b) / (2 * b) if b else mpf(1),
    "range_factor": _range_factor,
    "range_balance": _range_balance,
    "range_loss": _range_loss,
    "best_sine": _best_sine,
    "best_angle": lambda a: mp.asin(_best_sine(a)),
    "w0_offset": _w0_offset,
    "wm1_offset": _wm1_offset,
    "branch_factor": _branch_factor,
    "best_time": lambda a: _best_root(a) / a if a else mp.sqrt(2),
    "wright_omega": _omega_root,
    "max_range_factor": _max_range_factor,
    "exp": mp.exp,
    "acot": lambda x: mp.acot(x) if x else mp.pi / 2,
    "log1p": mp.log1p,
}


def mp_value(name, x):
    """Return a primitive at a real number, correct to about the precision of the mpmath context.

    Parameters
    ----------
    name : str
        ``phi1``, ``phi2`` or ``exp`` (x real), ``descent_factor``, ``flight_factor``, ``range_factor``,
        ``range_balance``, ``range_loss``, ``best_sine``, ``best_angle``, ``best_time``, ``max_range_factor``,
        ``w0_offset``, ``wm1_offset``, ``branch_factor``, ``acot``, ``log1p`` or ``wright_omega`` (x >= 0). All
        dimensionless; ``best_angle`` and ``acot`` in radians.
    x : real number
        Taken exactly.

    Returns
    -------
    mpmath.mpf
        The value, rounded once to ``mpmath.mp.prec`` from a computation with 40 bits more.

    Raises
    ------
    ValueError
        If x < 0 where the primitive is defined for x >= 0 only.
    """
    if name not in ("phi1", "phi2", "exp") and x < 0:
        raise ValueError(f"{name} is defined for arguments >= 0, not for {x}")
    with mp.extraprec(_GUARD_BITS):
        value = _VALUES[name](mpf(x))
    return +value
