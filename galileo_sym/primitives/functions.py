"""The one-variable functions behind every stable form, as SymPy functions.

Each knows its value at the removable singularity, its derivative, its closed form (``rewrite(LambertW)`` or
``rewrite(exp)``), and its numerical value at any precision. Definitions: design section 5.
"""

# ruff: noqa: N801 (named as the mathematical functions are, like those of SymPy)

import mpmath
from sympy import Abs, Float, Function, LambertW, Rational, S, asin, cos, exp, pi, sign, sin, sqrt
from sympy.core.function import ArgumentIndexError

from galileo_sym.multiprecision import mp_value


class Primitive(Function):
    """A real function of one dimensionless number, smooth at 0.

    Class attributes: ``at_zero``, the value at the removable singularity; ``latex_name``, the printed name.
    """

    nargs = 1
    at_zero = None
    latex_name = None
    is_real = True

    @classmethod
    def eval(cls, x):
        """Return the value at 0, where the closed form is 0/0."""
        return cls.at_zero if x.is_zero else None

    @classmethod
    def mp_value(cls, x):
        """Return the value at an mpmath number, to the working precision."""
        return mp_value(cls.__name__, x)

    def _eval_evalf(self, prec):
        x = self.args[0]._eval_evalf(prec + 10)
        if x is None or not x.is_Float:
            return None
        with mpmath.mp.workprec(prec):
            return Float._new(mp_value(type(self).__name__, mpmath.mpf(x._mpf_))._mpf_, prec)

    def fdiff(self, argindex=1):
        """Return the derivative, in terms of the primitives themselves."""
        if argindex != 1:
            raise ArgumentIndexError(self, argindex)
        return self._derivative(self.args[0])

    def _latex(self, printer, exp=None):
        power = f"^{{{exp}}}" if exp else ""
        return rf"{self.latex_name}{power}\left({printer._print(self.args[0])}\right)"


class phi1(Primitive):
    """phi1(z) = (exp(z) - 1)/z, phi1(0) = 1: the first exponential integrator function.

    With z = -gamma t it is the factor by which drag reduces a speed, chord (29); with z = -k t that of the projectile.
    """

    at_zero = S.One
    latex_name = r"\varphi_1"
    is_positive = True

    @staticmethod
    def _derivative(z):
        return phi1(z) - phi2(z)

    def _eval_rewrite_as_exp(self, z, **kwargs):
        return (exp(z) - 1) / z


class phi2(Primitive):
    """phi2(z) = (exp(z) - 1 - z)/z**2, phi2(0) = 1/2: the second exponential integrator function.

    2 phi2(-gamma t) is the factor by which drag reduces a distance along a chord, chord (29).
    """

    at_zero = S.Half
    latex_name = r"\varphi_2"
    is_positive = True

    @staticmethod
    def _derivative(z):
        return (phi1(z) - 2 * phi2(z)) / z

    def _eval_rewrite_as_exp(self, z, **kwargs):
        return (exp(z) - 1 - z) / z**2


class descent_factor(Primitive):
    """descent_factor(p) = tau/p with tau - 1 + exp(-tau) = p**2/2, tau >= 0; 1 at p = 0.

    The descent time with drag over the one without, at p = gamma t0; chord (30), (36), (42), (43).
    """

    at_zero = S.One
    latex_name = r"\operatorname{descent}"
    is_positive = True

    @staticmethod
    def _derivative(p):
        factor = descent_factor(p)
        return (1 / (factor - p / 2) - factor) / p

    def _eval_rewrite_as_LambertW(self, p, **kwargs):
        return (1 + p**2 / 2 + LambertW(-exp(-1 - p**2 / 2))) / p


class flight_factor(Primitive):
    """flight_factor(b) = T/(2 b) with T = (1 + b)(1 - exp(-T)), T >= 0; 1 at b = 0.

    The flight time with resistance over that without, at b = k v sin(theta)/g; projectile, impact time by result (3).
    """

    at_zero = S.One
    latex_name = r"\operatorname{flight}"
    is_positive = True

    @staticmethod
    def _derivative(b):
        F = flight_factor(b)
        return (1 / ((1 + b) * (2 * F - 1)) - 1) * F / b

    def _eval_rewrite_as_LambertW(self, b, **kwargs):
        return (1 + b + LambertW(-(1 + b) * exp(-1 - b))) / (2 * b)


class range_factor(Primitive):
    """range_factor(b) = (1 - exp(-T))/(2 b) with T = (1 + b)(1 - exp(-T)), T >= 0; 1 at b = 0.

    The range with resistance over the one without, at b = k v sin(theta)/g; projectile, range formula.
    """

    at_zero = S.One
    latex_name = r"\operatorname{range}"
    is_positive = True

    @staticmethod
    def _derivative(b):
        return (flight_factor(b).fdiff() - range_factor(b)) / (1 + b)

    def _eval_rewrite_as_LambertW(self, b, **kwargs):
        return flight_factor(b).rewrite(LambertW) / (1 + b)


class range_balance(Primitive):
    """range_balance(b) = b exp(-T)/(T - b) with T = (1 + b)(1 - exp(-T)), T >= 0; 1 at b = 0.

    The square of the tangent of the elevation at which the range is largest for its b = k v sin(theta)/g; it is -dy/du
    of the projectile's Lemma (b), and exp(-T)/(2 flight_factor(b) - 1).
    """

    at_zero = S.One
    latex_name = r"\operatorname{balance}"
    is_positive = True

    @staticmethod
    def _derivative(b):
        excess = 2 * flight_factor(b) - 1  # (T - b)/b
        steepness = 2 * range_factor(b) / excess  # dT/db
        return range_balance(b) * (1 / b - steepness - (steepness - 1) / (b * excess))

    def _eval_rewrite_as_LambertW(self, b, **kwargs):
        w = LambertW(-(1 + b) * exp(-1 - b))
        return -b * w / ((1 + b) * (1 + w))


class range_loss(Primitive):
    """range_loss(b) = range_factor(b) (1 - range_balance(b))/b, the slope of -range_factor; 4/3 at b = 0.

    What the range loses with resistance, at b = k v sin(theta)/g; projectile, Lemma (e).
    """

    at_zero = Rational(4, 3)
    latex_name = r"\operatorname{loss}"
    is_positive = True

    @staticmethod
    def _derivative(b):
        balance = range_balance(b)
        return -(range_loss(b) * (2 - balance) + range_factor(b) * balance.fdiff()) / b

    def _eval_rewrite_as_LambertW(self, b, **kwargs):
        return self._eval_rewrite_as_range_balance(b).rewrite(LambertW)

    def _eval_rewrite_as_range_balance(self, b, **kwargs):
        return range_factor(b) * (1 - range_balance(b)) / b


class best_sine(Primitive):
    """best_sine(a) = a/(exp(s) - 1) with 1 + (s - 1) exp(s) = a**2, s >= 0; 1/sqrt(2) at a = 0.

    The sine of the angle of greatest range at a = k v/g; projectile, Theorem 3 (both cases in one form).
    """

    at_zero = sqrt(2) / 2
    latex_name = r"\operatorname{bestsine}"
    is_positive = True

    @staticmethod
    def _derivative(a):
        s = 1 + LambertW((a**2 - 1) * exp(-1))
        return best_sine(a) / a - 2 * best_sine(a) ** 2 / s

    def _eval_rewrite_as_LambertW(self, a, **kwargs):
        return a / (exp(1 + LambertW((a**2 - 1) * exp(-1))) - 1)


class best_angle(Primitive):
    """best_angle(a) = asin(best_sine(a)), in radians; pi/4 at a = 0. Projectile, Theorem 3."""

    at_zero = pi / 4
    latex_name = r"\theta_{\max}"
    is_positive = True

    @staticmethod
    def _derivative(a):
        return best_sine(a).fdiff() / sqrt(1 - best_sine(a) ** 2)

    def _eval_rewrite_as_LambertW(self, a, **kwargs):
        return asin(best_sine(a).rewrite(LambertW))

    def _eval_rewrite_as_asin(self, a, **kwargs):
        return asin(best_sine(a))


class best_time(Primitive):
    """best_time(a) = s/a with 1 + (s - 1) exp(s) = a**2, s >= 0; sqrt(2) at a = 0.

    The time of flight at the angle of greatest range in units of v/g, at a = k v/g; projectile, Theorem 3.
    """

    at_zero = sqrt(2)
    latex_name = r"\operatorname{besttime}"
    is_positive = True

    @staticmethod
    def _derivative(a):
        time = best_time(a)
        return (2 * exp(-a * time) / time - time) / a

    def _eval_rewrite_as_LambertW(self, a, **kwargs):
        return (1 + LambertW((a**2 - 1) * exp(-1))) / a


class max_range_factor(Primitive):
    """max_range_factor(a) = sqrt(1 - (1 + s) exp(-s))/a with 1 + (s - 1) exp(s) = a**2, s >= 0; 1 at a = 0.

    The greatest range with resistance over that without, v**2/g, at a = k v/g; projectile, Theorem 3 in the range.
    """

    at_zero = S.One
    latex_name = r"\operatorname{maxrange}"
    is_positive = True

    @staticmethod
    def _derivative(a):
        fading = best_sine(a) / (a + best_sine(a))  # exp(-s)
        return (fading**2 / max_range_factor(a) - max_range_factor(a)) / a

    def _eval_rewrite_as_LambertW(self, a, **kwargs):
        s = 1 + LambertW((a**2 - 1) * exp(-1))
        return sqrt(1 - (1 + s) * exp(-s)) / a


class driving(Function):
    """driving(theta, mu) = cos(theta) - mu sin(|theta|): gravity along the chord less friction, over m g; chord (12).

    A bead slides from rest where it is positive, that is for |theta| < theta_max of chord (13).
    """

    nargs = 2
    is_real = True

    @classmethod
    def eval(cls, theta, mu):
        """Return the value where one of the two forces is absent; theta and -theta are the same."""
        if theta.is_zero:
            return S.One
        if mu.is_zero:
            return cos(theta)
        return cls(-theta, mu) if theta.could_extract_minus_sign() else None

    def fdiff(self, argindex=1):
        """Return the derivative with respect to theta (1) or mu (2)."""
        theta, mu = self.args
        slopes = {1: -sin(theta) - mu * sign(theta) * cos(theta), 2: -sin(Abs(theta))}
        if argindex not in slopes:
            raise ArgumentIndexError(self, argindex)
        return slopes[argindex]

    @staticmethod
    def mp_value(theta, mu):
        """Return the value at mpmath numbers, to the working precision."""
        return mpmath.cos(theta) - mu * mpmath.sin(abs(theta))

    def _eval_rewrite_as_cos(self, theta, mu, **kwargs):
        return cos(theta) - mu * sin(Abs(theta))

    def _eval_evalf(self, prec):
        theta, mu = self.args
        return (cos(theta) - mu * sin(Abs(theta)))._eval_evalf(prec)

    def _latex(self, printer, exp=None):
        power = f"^{{{exp}}}" if exp else ""
        arguments = ", ".join(printer._print(a) for a in self.args)
        return rf"\operatorname{{driving}}{power}\left({arguments}\right)"


FUNCTIONS = {
    cls.__name__: cls
    for cls in (
        phi1,
        phi2,
        descent_factor,
        flight_factor,
        range_factor,
        range_balance,
        range_loss,
        best_sine,
        best_angle,
        best_time,
        max_range_factor,
        driving,
    )
}
