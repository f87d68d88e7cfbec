"""Beads sliding from rest along chords from the top of a vertical circle (Aguiar, Soares and Tort, 2014).

SI units, angles in radians from the vertical. Arguments are array-likes that broadcast; float64 and float32 in, the
same out; scalars give scalars. Outside the domain the result is NaN, with NumPy's 'invalid' floating-point error
state; NaN gives NaN without it. An infinite argument gives the limit, or NaN and 'invalid' where there is none. All
functions take ``out``, ``where``, ``dtype`` and ``casting`` as NumPy's ufuncs do.

Accuracy, for float64: measured within 1 ulp of the exact result at every point sampled, from the smallest arguments to
the largest, against enclosures in ball arithmetic (claimed bound: 1 ulp; `generated/certificates/`); whether a bead
slides at all is decided by the exact sign of cos|theta| - mu sin|theta|.
"""

from importlib import import_module  # the curve loads the tables of the NumPy kernels: when it is asked for

from galileo_sym._front import public

__all__ = ["descent_time", "distance", "max_angle", "position", "speed", "synchronous_circle", "synchronous_curve"]

_descent_time = public("chord.descent_time")
_distance = public("chord.distance")
_speed = public("chord.speed")
_position = public("chord.position")
_synchronous_circle = public("chord.synchronous_circle")
_max_angle = public("chord.max_angle")


def descent_time(theta, *, diameter, g, mu=0.0, gamma=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Time a bead takes from the top of the circle to the end of its chord.

    Parameters
    ----------
    theta : array_like
        Angle of the chord from the vertical, in rad, signed; ``|theta| <= pi/2``.
    diameter : array_like
        Diameter of the circle, in m; > 0.
    g : array_like
        Acceleration of gravity, in m/s²; > 0.
    mu : array_like, optional
        Coefficient of sliding friction, equal to the static one; >= 0.
    gamma : array_like, optional
        Linear drag coefficient over mass, in 1/s; >= 0.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        Descent time in s; ``inf``, without a flag, where friction holds the bead (``|theta| >= theta_max``). Without
        friction it does not depend on `theta`: Galileo's paradox.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Equations (4), (17), (18), (36) and (43) of the chord paper, as sqrt(2 D/g cos θ/(cos θ - μ sin|θ|)) times
    ``descent_factor``.

    Claimed bound: 1 ulp, measured.

    Examples
    --------
    >>> float(round(descent_time(0.0, diameter=1.0, g=9.81, gamma=1e-8), 5))
    0.45152
    """
    return _descent_time(theta, diameter, g, mu, gamma, out, where, dtype, casting)


def distance(t, theta, *, g, mu=0.0, gamma=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Distance a bead has gone along its chord.

    Parameters
    ----------
    t : array_like
        Time since release, in s; >= 0. The chord has no end here: positions are not clipped at arrival.
    theta : array_like
        Angle of the chord from the vertical, in rad, signed; ``|theta| <= pi/2``.
    g : array_like
        Acceleration of gravity, in m/s²; > 0.
    mu : array_like, optional
        Coefficient of sliding friction, equal to the static one; >= 0.
    gamma : array_like, optional
        Linear drag coefficient over mass, in 1/s; >= 0.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        Distance in m; 0 where friction holds the bead.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Equations (1), (15), (29) and (41) of the chord paper, as g t²/2 (cos θ - μ sin|θ|) times 2 φ₂(-γt).

    Claimed bound: 1 ulp, measured.
    """
    return _distance(t, theta, g, mu, gamma, out, where, dtype, casting)


def speed(t, theta, *, g, mu=0.0, gamma=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Speed of a bead along its chord.

    Parameters
    ----------
    t : array_like
        Time since release, in s; >= 0. The chord has no end here: speeds are not clipped at arrival.
    theta, g, mu, gamma : array_like
        As for `distance`.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        Speed in m/s, within 1 ulp (claimed bound, held at every point sampled); 0 where friction holds the bead.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    The derivative of (1), (15), (29) and (41) of the chord paper, as g t (cos θ - μ sin|θ|) times φ₁(-γt).

    Examples
    --------
    >>> float(round(speed(1.0, 0.5, g=9.81, mu=0.2, gamma=1e-9), 5))
    7.66845
    """
    return _speed(t, theta, g, mu, gamma, out, where, dtype, casting)


def position(t, theta, *, g, mu=0.0, gamma=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Position of a bead, x to the right and y down from the top of the circle.

    Parameters
    ----------
    t, theta, g, mu, gamma : array_like
        As for `distance`.
    out, where, dtype, casting : optional
        ``out`` (a pair of arrays), ``where``, ``dtype``, ``casting``, as for a NumPy ufunc.

    Returns
    -------
    x, y : ndarray or scalar
        Coordinates in m: s sin θ and s cos θ; (0, 0) where friction holds the bead.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Equations (5), (6), (19), (20), and the coordinates of section 1 with (29) and (41) of the chord paper.

    Claimed bound: 1 ulp, measured.
    """
    return _position(t, theta, g, mu, gamma, out, where, dtype, casting)


def synchronous_circle(t, *, g, mu=0.0, gamma=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Circle on which beads released together from the top are found at one time.

    Parameters
    ----------
    t, g, mu, gamma : array_like
        As for `distance`.
    out, where, dtype, casting : optional
        ``out`` (three arrays), ``where``, ``dtype``, ``casting``, as for a NumPy ufunc.

    Returns
    -------
    X, Y, R : ndarray or scalar
        In m, y down: the centre is (-X, Y) for beads with theta > 0 and (X, Y) for those with theta < 0, the radius R.
        X >= 0, and 0 without friction.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Equations (10), (22), (32) and (45)-(47) of the chord paper.

    Claimed bound: 1 ulp, measured.
    """
    return _synchronous_circle(t, g, mu, gamma, out, where, dtype, casting)


def synchronous_curve(t, n, *, g, mu=0.0, gamma=0.0, out=None, where=True, dtype=None, casting="same_kind"):
    """Points of the curve on which beads released together from the top are found at one time.

    Parameters
    ----------
    t : array_like
        Time since release, in s; >= 0. Chords have no end here: the curve is not clipped at arrival.
    n : int
        Number of points, >= 1, all different.
    g : array_like
        Acceleration of gravity, in m/s²; > 0.
    mu : array_like, optional
        Coefficient of sliding friction, equal to the static one; >= 0.
    gamma : array_like, optional
        Linear drag coefficient over mass, in 1/s; >= 0.
    out, where, dtype, casting : optional
        ``out`` (a pair of arrays), ``where``, ``dtype``, ``casting``, as for a NumPy ufunc.

    Returns
    -------
    x, y : ndarray
        Coordinates in m, x to the right and y down from the top of the circle, of the shape of all arguments together
        and one axis more, of length `n`. The first point is the top, A; the others follow down the right arc and up
        the left one, at equal distances along the arcs, all the way round: the last point is as far from A as the
        second. For even `n` the point ``n//2`` is the lowest one, where the arcs meet. Points k and n - k are mirror
        images.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments, masked arrays and arrays of other libraries, and `n` that
        is no whole number.
    ValueError
        If `n` is less than 1, or arguments do not broadcast.

    Notes
    -----
    Circles (21) and (24) of the chord paper, with drag (32) and (45)-(47): x >= 0 on the first, x <= 0 on the second,
    one circle without friction. No bead is followed: equal arcs are equal steps of theta, and with
    theta_max = arctan(1/μ) a point is D sin(theta_max - theta)/sin(theta_max) away from A, D the distance of the
    lowest one.

    Measured error: at most 2 ulp of each coordinate.

    Examples
    --------
    >>> x, y = synchronous_curve([0.1, 0.2], 4, g=10.0)
    >>> y.round(3) + 0.0
    array([[0.   , 0.025, 0.05 , 0.025],
           [0.   , 0.1  , 0.2  , 0.1  ]])
    """
    options = {"out": out, "where": where, "dtype": dtype, "casting": casting}
    return import_module("galileo_sym._curve").curve(t, n, g=g, mu=mu, gamma=gamma, **options)


def max_angle(mu, out=None, where=True, dtype=None, casting="same_kind"):
    """Angle of the chord from the vertical from which on friction holds a bead at rest.

    Parameters
    ----------
    mu : array_like
        Coefficient of sliding friction, equal to the static one, dimensionless; >= 0.
    out, where, dtype, casting : optional
        As for a NumPy ufunc; `dtype` is float64 or float32.

    Returns
    -------
    ndarray or scalar
        arctan(1/mu) in rad, within 1 ulp (claimed bound, held at every point sampled): pi/2 at 0, decreasing to 0. The
        other functions do not compare with it: they decide by the exact sign of cos|theta| - mu sin|theta|.

    Raises
    ------
    TypeError
        For complex, extended-precision or object arguments.

    Notes
    -----
    Equation (13) of the chord paper, as the arccotangent of μ, which loses nothing for small or large μ.

    Examples
    --------
    >>> float(round(max_angle(0.5), 5))
    1.10715
    """
    return _max_angle(mu, out, where, dtype, casting)
