"""Projectiles under gravity and linear resistance (Packel and Yuen, 2004).

SI units, angles in radians from the horizontal. Arguments are array-likes that broadcast; float64 and float32 in, the
same out; scalars give scalars. Outside the domain the result is NaN, with NumPy's 'invalid' floating-point error
state; NaN gives NaN without it. An infinite argument gives the limit, or NaN and 'invalid' where there is none. All
functions take ``out``, ``where``, ``dtype`` and ``casting`` as NumPy's ufuncs do.

Accuracy, for float64: measured within 1 ulp of the exact result at every point sampled, from the smallest arguments to
the largest, against enclosures in ball arithmetic (claimed bound: 1 ulp; `generated/certificates/`); errors of the
height, of the upward velocity and of the slope against the elevation are in ulp of the larger of their two terms, which
cancel at landing, at the apex and at the angle of greatest range.
"""

from galileo_sym._front import public

__all__ = [
    "best_angle",
    "flight_time",
    "horizontal_range",
    "launch_angles",
    "max_range",
    "position",
    "range_slope_k",
    "range_slope_theta",
    "velocity",
]

_flight_time = public("projectile.flight_time")
_horizontal_range = public("projectile.horizontal_range")
_position = public("projectile.position")
_velocity = public("projectile.velocity")
_range_slope_theta = public("projectile.range_slope_theta")
_range_slope_k = public("projectile.range_slope_k")
_max_range = public("projectile.max_range")
_best_angle = public("projectile.best_angle")
_launch_angles = public("projectile.launch_angles")


def flight_time(theta, *, v, g, k=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Time until a projectile is back at the height of its launch.

    Parameters
    ----------
    theta : array_like
        Elevation of the launch, in rad; ``0 <= theta <= pi/2``.
    v : array_like
        Launch speed, in m/s; > 0.
    g : array_like
        Acceleration of gravity, in m/s²; > 0.
    k : array_like, optional
        Linear resistance coefficient over mass, in 1/s; >= 0.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        Flight time in s.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    The impact time of the projectile paper, by its result (3), as 2 v sin θ/g times ``flight_factor``.

    Claimed bound: 1 ulp, measured.

    Examples
    --------
    >>> float(round(flight_time(0.5, v=10.0, g=9.81, k=1e-9), 5))
    0.97742
    """
    return _flight_time(theta, v, g, k, out, where, dtype, casting)


def horizontal_range(theta, *, v, g, k=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Horizontal distance at which a projectile is back at the height of its launch.

    Parameters
    ----------
    theta, v, g, k : array_like
        As for `flight_time`.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        Range in m.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    The range formula of the projectile paper, as 2 v² sin θ cos θ/g times ``range_factor``.

    Claimed bound: 1 ulp, measured.
    """
    return _horizontal_range(theta, v, g, k, out, where, dtype, casting)


def position(t, theta, *, v, g, k=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Position of a projectile, y up from the launch.

    Parameters
    ----------
    t : array_like
        Time since launch, in s; >= 0. Positions are not clipped at landing.
    theta, v, g, k : array_like
        As for `flight_time`.
    out, where, dtype, casting : optional
        ``out`` (a pair of arrays), ``where``, ``dtype``, ``casting``, as for a NumPy ufunc.

    Returns
    -------
    x, y : ndarray or scalar
        Coordinates in m.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    The solution of the equations of motion in the projectile paper, as v t cos θ φ₁(-kt) and
    v t sin θ φ₁(-kt) - g t² φ₂(-kt).

    Claimed bound: 1 ulp, measured; for y of the larger of its two terms, which cancel at landing.
    """
    return _position(t, theta, v, g, k, out, where, dtype, casting)


def velocity(t, theta, *, v, g, k=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Velocity of a projectile, y up.

    Parameters
    ----------
    t : array_like
        Time since launch, in s; >= 0. Velocities are not clipped at landing.
    theta, v, g, k : array_like
        As for `flight_time`.
    out, where, dtype, casting : optional
        ``out`` (a pair of arrays), ``where``, ``dtype``, ``casting``, as for a NumPy ufunc.

    Returns
    -------
    vx, vy : ndarray or scalar
        Velocity in m/s. Claimed bounds, held at every point sampled: vx within 1 ulp; vy within 1 ulp of the larger of
        its two terms, which cancel at the apex.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    The first integrals of the equations of motion in the projectile paper, as v cos θ exp(-kt) and
    v sin θ exp(-kt) - g t φ₁(-kt).

    Examples
    --------
    >>> vx, vy = velocity(0.25, 0.5, v=10.0, g=9.81, k=1e-9)
    >>> float(round(vx, 5)), float(round(vy, 5))
    (8.77583, 2.34176)
    """
    return _velocity(t, theta, v, g, k, out, where, dtype, casting)


def range_slope_theta(theta, *, v, g, k=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Derivative of the range with respect to the elevation.

    Parameters
    ----------
    theta, v, g, k : array_like
        As for `flight_time`.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        dR/dθ in m/rad: 2 v²/g at θ = 0, where the printed form is 0/0. Claimed bound, held at every point sampled:
        1 ulp of the larger of its two terms, which cancel at the angle of greatest range.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Part (f) of the Lemma of the projectile paper, as 2 v²/g ``range_factor`` (cos² θ ``range_balance`` - sin² θ), both
    at b = k v sin θ/g.

    Examples
    --------
    >>> float(round(range_slope_theta(0.5, v=10.0, g=9.81, k=1e-9), 5))
    11.01534
    """
    return _range_slope_theta(theta, v, g, k, out, where, dtype, casting)


def range_slope_k(theta, *, v, g, k=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Derivative of the range with respect to the resistance coefficient.

    Parameters
    ----------
    theta, v, g, k : array_like
        As for `flight_time`.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        dR/dk in m s, within 1 ulp (claimed bound, held at every point sampled); at k = 0 the limit
        -8 v³ sin² θ cos θ/(3 g²).

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Part (e) of the Lemma of the projectile paper, as -2 v³ sin² θ cos θ/g² times ``range_loss`` at b = k v sin θ/g.

    Examples
    --------
    >>> float(round(range_slope_k(0.5, v=10.0, g=9.81, k=1e-9), 5))
    -5.58935
    """
    return _range_slope_k(theta, v, g, k, out, where, dtype, casting)


def max_range(*, v, g, k=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Greatest range of a projectile, over all elevations.

    Parameters
    ----------
    v, g, k : array_like
        As for `flight_time`.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        Range at ``best_angle(k v/g)`` in m, within 1 ulp (claimed bound, held at every point sampled).

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    The range formula of the projectile paper at the angle of its Theorem 3, as v²/g times ``max_range_factor`` at
    α = k v/g.

    Examples
    --------
    >>> float(round(max_range(v=50.0, g=32.2, k=0.1), 5))
    67.72389
    """
    return _max_range(v, g, k, out, where, dtype, casting)


def best_angle(alpha, out=None, where=True, dtype=None, casting="same_kind"):
    """Elevation of greatest range.

    Parameters
    ----------
    alpha : array_like
        k v/g, the resistance at launch speed over the weight, dimensionless; >= 0.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        Elevation in rad: pi/4 at 0, decreasing to 0.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Theorem 3 of the projectile paper, both of its cases in one form.

    Claimed bound: 1 ulp, measured.
    """
    return _best_angle(alpha, out, where, dtype, casting)


def launch_angles(r, *, v, g, k=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Both elevations that reach a range.

    Parameters
    ----------
    r : array_like
        Range, in m; ``0 <= r <= max_range(v=v, g=g, k=k)``. Above: NaN and 'invalid'.
    v, g, k : array_like
        As for `flight_time`.
    out, where, dtype, casting : optional
        ``out`` (a pair of arrays), ``where``, ``dtype``, ``casting``, as for a NumPy ufunc.

    Returns
    -------
    low, high : ndarray or scalar
        Elevations in rad: ``0 <= low <= best_angle(k v/g) <= high <= pi/2``; 0 and pi/2 at r = 0, and twice the best
        angle where r is the float `max_range`.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Theorem 2 of the projectile paper: each range below the largest is reached at two elevations. Without resistance
    tan θ = ρ/(1 + √(1 - ρ²)), ρ = g r/v². With it, the time of flight z in units of v/g solves ρ² = z² φ₁² - z⁴ φ₂², a
    concave function of z² (φ₁, φ₂ at -kvz/g), and tan θ = z² φ₂/ρ.

    Within 1 ulp for every range below the largest, however close to it (measured), but for the low angle where it
    changes over 2⁴⁰ times as fast as the range: beside the largest range at k v/g above some 10⁶. There the error is
    below 2⁻⁴⁰ of what one ulp of the range does to the angle.

    Examples
    --------
    >>> low, high = launch_angles(8.0, v=10.0, g=9.81, k=0.1)
    >>> float(round(low, 6)), float(round(high, 6))
    (0.509443, 1.03057)
    """
    return _launch_angles(r, v, g, k, out, where, dtype, casting)
