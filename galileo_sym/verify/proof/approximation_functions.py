"""The operations of the equations, on power series about a piece's centre and on a disc around it.

A formula of these operations is evaluated twice: on python-flint's `arb_series`, which gives its Taylor coefficients as
balls, and on a `Disc`, which gives a bound of its modulus and refuses what may be singular there.
"""

from dataclasses import dataclass

from flint import acb, arb, arb_poly


class NotAnalytic(ArithmeticError):
    """On the disc a function meets (or cannot be shown to avoid) a singularity."""


class Disc:
    """An analytic function on |u| <= radius, by what is needed to bound it.

    Attributes
    ----------
    value : arb_poly or acb
        A polynomial in u as long as only ring operations were applied, so that their dependence is not lost; else a
        ball that contains all values on the disc.
    radius : float
    """

    def __init__(self, value, radius):
        if isinstance(value, acb) and not value.is_finite():
            raise NotAnalytic("a function is not bounded on the disc")
        self.value, self.radius = value, radius

    def ball(self):
        """All values on the disc, as one complex ball."""
        if isinstance(self.value, acb):
            return self.value
        first, *others = self.value.coeffs() or [arb(0)]
        reach = sum((abs(c) * arb(self.radius) ** k for k, c in enumerate(others, 1)), arb(0)).upper()
        return _around(first, reach)

    def bound(self):
        """Upper bound of the modulus on the disc."""
        return self.ball().abs_upper()

    def _join(self, other, operation):
        theirs = other.value if isinstance(other, Disc) else arb_poly([other])
        if isinstance(self.value, arb_poly) and isinstance(theirs, arb_poly):
            return Disc(operation(self.value, theirs), self.radius)
        ball = other.ball() if isinstance(other, Disc) else acb(other)
        return Disc(operation(self.ball(), ball), self.radius)

    def __add__(self, other):
        return self._join(other, lambda a, b: a + b)

    def __mul__(self, other):
        return self._join(other, lambda a, b: a * b)

    def __sub__(self, other):
        return self._join(other, lambda a, b: a - b)

    def __rsub__(self, other):
        return self._join(other, lambda a, b: b - a)

    def __neg__(self):
        return 0 - self

    def __truediv__(self, other):
        return Disc(self.ball() / other.ball(), self.radius)

    def __rtruediv__(self, other):
        return Disc(acb(other) / self.ball(), self.radius)

    __radd__, __rmul__ = __add__, __mul__

    def entire(self, function):
        """Apply an entire function of a complex ball."""
        return Disc(function(self.ball()), self.radius)

    def right_half_plane(self, function):
        """Apply a function that is analytic where the real part is positive."""
        ball = self.ball()
        if not ball.real > 0:
            raise NotAnalytic("a logarithm or root of a number that may lie on the cut")
        return Disc(function(ball), self.radius)


def _around(centre, reach):
    return acb(centre + arb(0, reach), arb(0, reach))


def exp(w):
    """Exponential of a series or disc."""
    return w.entire(acb.exp) if isinstance(w, Disc) else w.exp()


def sin(w):
    """Sine of a series or disc."""
    return w.entire(acb.sin) if isinstance(w, Disc) else w.sin()


def cosh(w):
    """Hyperbolic cosine of a series or disc."""
    return w.entire(acb.cosh) if isinstance(w, Disc) else w.cosh()


def cos(w):
    """Cosine of a series or disc."""
    return w.entire(acb.cos) if isinstance(w, Disc) else w.cos()


def log(w):
    """Principal logarithm of a series or disc whose real part is positive."""
    return w.right_half_plane(acb.log) if isinstance(w, Disc) else w.log()


def sqrt(w):
    """Principal root of a series or disc whose real part is positive."""
    return w.right_half_plane(acb.sqrt) if isinstance(w, Disc) else w.sqrt()


@dataclass(frozen=True)
class Mean:
    """A function with a removable singularity at 0: the integral over [0, 1] of weight(t) kernel(t w), weight >= 0.

    Attributes
    ----------
    closed : callable
        Its closed form, 0/0 at w = 0; only used where w does not vanish.
    total : float
        Integral of the weight, the value at w = 0.
    kernel : callable
        Takes a `Disc`.
    """

    closed: object
    total: float
    kernel: object

    def __call__(self, w):
        """Value on a series (with constant term not 0) or on a disc."""
        if not isinstance(w, Disc):
            return self.closed(w)
        ball = w.ball()
        reached = acb(ball.real.union(0), ball.imag.union(0))  # all t w; a rectangle holds the averages of its numbers
        average = self.total * self.kernel(Disc(reached, w.radius))
        if ball.contains(0):
            return average
        return min(average, self.closed(w), key=lambda disc: float(disc.bound() - disc.ball().abs_lower()))


def _reciprocal(w):
    return 1 / (1 + w).right_half_plane(lambda ball: ball)


phi1 = Mean(lambda w: (exp(w) - 1) / w, 1.0, exp)  # weight 1
phi2 = Mean(lambda w: (exp(w) - 1 - w) / w / w, 0.5, exp)  # weight 1 - t
phi1_slope = Mean(lambda w: (1 + (w - 1) * exp(w)) / w / w, 0.5, exp)  # weight t
log_mean = Mean(lambda y: log(1 + y) / y, 1.0, _reciprocal)  # weight 1
log_lag = Mean(lambda y: ((1 + y) * log(1 + y) - y) / y / y, 0.5, _reciprocal)  # weight 1 - t
sinc = Mean(lambda w: sin(w) / w, 1.0, cos)  # weight 1
bump = Mean(lambda w: ((w - 2) * exp(w) + w + 2) / w / w / w, arb(1) / 6, exp)  # weight t (1 - t); the slope of phi2
bump_slope = Mean(  # weight t^2 (1 - t)
    lambda w: (((w - 4) * w + 6) * exp(w) - 2 * w - 6) / w / w / w / w, arb(1) / 12, exp
)
