"""Both real branches of the Lambert W function, and the real roots of a t + b + c exp(d t) = 0 (Packel and Yuen, 2004).

Arguments are array-likes that broadcast; float64 and float32 in, the same out; scalars give scalars. Outside the domain
the result is NaN, with NumPy's 'invalid' floating-point error state; NaN gives NaN without it. All functions take
``out``, ``where``, ``dtype`` and ``casting`` as NumPy's ufuncs do.

Accuracy, for float64: within 0.53 ulp of the exact result at every point sampled, from the smallest arguments to the
largest, the branch point and double roots included (claimed bound: 1 ulp; `generated/certificates/`). In C both
branches are proved within 0.55 ulp for every argument (`docs/proofs.md`).
"""

from galileo_sym._front import public

__all__ = ["linear_exponential_roots", "w0", "wm1"]

_w0 = public("lambert.w0")
_wm1 = public("lambert.wm1")
_linear_exponential_roots = public("lambert.linear_exponential_roots")


def w0(x, out=None, where=True, dtype=None, casting="same_kind"):
    """Principal real branch of the Lambert W function: the w >= -1 with w exp(w) = x.

    Parameters
    ----------
    x : array_like
        Dimensionless; ``x >= -1/e``. The double nearest -1/e lies below it, and gives NaN.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        W0(x): -1 at the branch point, 0 at 0 (of its sign), infinite at infinity.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Result (1) of the projectile paper; the primitive `galileo_sym.special.w0`, whose float32 results are correctly
    rounded. Claimed bound: 1 ulp (0.53 at every point sampled).

    Examples
    --------
    >>> float(w0(1.0))
    0.5671432904097838
    """
    return _w0(x, out, where, dtype, casting)


def wm1(x, out=None, where=True, dtype=None, casting="same_kind"):
    """Lower real branch of the Lambert W function: the w <= -1 with w exp(w) = x.

    Parameters
    ----------
    x : array_like
        Dimensionless; ``-1/e <= x <= 0``. The double nearest -1/e lies below it, and gives NaN.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        W-1(x): -1 at the branch point, decreasing; -inf at 0, with NumPy's 'divide by zero' error state.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    The other real branch of result (1) of the projectile paper; the primitive `galileo_sym.special.wm1`, whose float32
    results are correctly rounded. Claimed bound: 1 ulp (0.51 at every point sampled).

    Examples
    --------
    >>> float(wm1(-0.2))
    -2.5426413577735265
    """
    return _wm1(x, out, where, dtype, casting)


def linear_exponential_roots(a, b, c, d, out=None, where=True, dtype=None, casting="same_kind"):
    """Real roots of a t + b + c exp(d t) = 0, by both branches of the Lambert W function.

    Parameters
    ----------
    a, d : array_like
        Coefficient of t and rate in the exponential, in the inverse unit of t; of either sign.
    b, c : array_like
        Constant term and coefficient of the exponential, dimensionless; of either sign.
    out, where, dtype, casting : optional
        ``out`` (a pair of arrays), ``where``, ``dtype``, ``casting``, as for a NumPy ufunc.

    Returns
    -------
    t0, tm1 : ndarray or scalar
        Roots by W0 and by W-1, in this order whatever their size; NaN, without a flag, for a root that does not exist.
        One root (by W0) if c d/a > 0; two, one or none if c d/a < 0: that is decided exactly, and both are equal at a
        double root. Without the exponential's curvature t0 is the only root: -b/a for c = 0, -(b + c)/a for d = 0,
        log(-b/c)/d for a = 0.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Result (3) of the projectile paper, completed by its second root: t = -b/a - W(X)/d, X = (c d/a) exp(-b d/a). X is
    formed only where it is ordinary: log|c d/a| - b d/a takes its place, so that nothing overflows. Claimed bound:
    1 ulp (0.51 at every point sampled), whatever the condition numbers |b d/a|/|(1 + W) d t|, |W|/|(1 + W) d t|,
    1/|1 + W| and |W|/|1 + W| of b, c, a and d: they are large beside a double root, or where a root is near 0. NaN and
    'invalid' for a = d = 0, a = c = 0, and where two arguments are infinite.

    Examples
    --------
    >>> [float(t) for t in linear_exponential_roots(1.0, 2.0, -1.0, 1.0)]
    [-1.8414056604369606, 1.1461932206205825]
    """
    return _linear_exponential_roots(a, b, c, d, out, where, dtype, casting)
