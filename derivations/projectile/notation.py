"""Symbols of the projectile paper: y points up, theta is the elevation from the horizontal.

The paper uses some letters twice. Here y(t) is the height and y(u) the Lemma's W(u*exp(u)), R(theta) the range without
and R(k, theta) with resistance, U(k, theta) is u where k and theta are the independent variables, q is the argument x
of W, and tau, a_3 ... d_3 are the t, a ... d of the proof of Theorem 3.
"""

import functools

import sympy as sp
from mpmath import mp

from galileo_sym.ledger import LENGTH, ONE, POSITIVE, TIME, Notation

notation = Notation("projectile")
symbol, function = notation.symbol, notation.function

g = symbol("g", LENGTH / TIME**2, "gravity", positive=True)
v = symbol("v", LENGTH / TIME, "launch speed", positive=True)
k = symbol("k", 1 / TIME, "resistance for unit mass and speed", positive=True)
alpha = symbol("alpha", ONE, "k*v/g", positive=True)
alpha_0 = symbol("alpha_0", ONE, "k*v/g, which may be 0", nonnegative=True)
theta = symbol("theta", ONE, "elevation at launch, from the horizontal", real=True)
theta_max = symbol("theta_max", ONE, "elevation of the largest range", sp.Interval.open(0, sp.pi / 2), positive=True)
t = symbol("t", TIME, "time since launch; the unknown of result (3)", real=True)
a = symbol("a", 1 / TIME, "coefficient of t in result (3)", real=True, nonzero=True)
b = symbol("b", ONE, "constant term in result (3)", real=True)
c = symbol("c", ONE, "coefficient of the exponential in result (3)", real=True)
d = symbol("d", 1 / TIME, "exponent in result (3)", real=True, nonzero=True)
w = symbol("w", ONE, "argument of T(w) = w*exp(w)", real=True)
q = symbol("q", ONE, "argument of W", real=True)
u = symbol("u", ONE, "-1 - k*v*sin(theta)/g", negative=True)
s = symbol("s", ONE, "k times the impact time", positive=True)
r = symbol("r", LENGTH, "a range below the largest", nonnegative=True)
share = symbol("share", ONE, "r over the largest range", nonnegative=True)
delta = symbol("delta", ONE, "distance of an angle from pi/4", positive=True)
output = symbol("output", LENGTH / TIME, "what the Mathematica commands put out", real=True)
tau = symbol("tau", ONE, "1/(alpha**2 - 1 - u)", real=True)
a_3 = symbol("a_3", ONE, "a of result (3) in the proof of Theorem 3", positive=True)
b_3 = symbol("b_3", ONE, "b of result (3) in the proof of Theorem 3", real=True)
c_3 = symbol("c_3", ONE, "c of result (3) in the proof of Theorem 3", positive=True)
n = symbol("n", ONE, "order of a term of a power series", integer=True, nonnegative=True)
d_3 = symbol("d_3", ONE, "d of result (3) in the proof of Theorem 3", real=True, nonzero=True)

x = function("x", LENGTH, "horizontal coordinate")
y = function("y", LENGTH, "height y(t); the Lemma's y(u) = W(u*exp(u)) is a pure number")
v_x = function("v_x", LENGTH / TIME, "horizontal velocity")
v_y = function("v_y", LENGTH / TIME, "vertical velocity")
R = function("R", LENGTH, "horizontal range")
T = function("T", ONE, "w*exp(w)")
U = function("U", ONE, "u as a function of k and theta")
Theta = function("Theta", ONE, "theta_max as a function of alpha")
H = function("H", ONE, "(1 + w*exp(w + 1))/(w + 1)**2")

notation.dimensions[y(u)] = ONE

HALF_TURN = sp.Interval(0, sp.pi / 2)
BETWEEN = sp.Interval.open(0, sp.pi / 2)
RISING = sp.Interval.Lopen(0, sp.pi / 2)
BEYOND = sp.Interval.open(-sp.oo, -1)

W_u = sp.LambertW(u * sp.exp(u))
U_OF_THETA = -1 - k * v * sp.sin(theta) / g
SHOT = {g: POSITIVE, v: POSITIVE, k: POSITIVE}

# for trials: the Lemma's y and its derivatives, and the slopes of the range, in terms of W
Y = y(u)
SLOPE = sp.Derivative(Y, u)
CURVATURE = sp.Derivative(Y, (u, 2))
TRIAL_Y = {Y: W_u, SLOPE: sp.diff(W_u, u), CURVATURE: sp.diff(W_u, u, 2)}
TRIAL_RANGE = (v * sp.cos(theta) / k * (1 - W_u / u)).subs(u, U_OF_THETA)
TRIAL = {
    **TRIAL_Y,
    u: U_OF_THETA,
    R(k, theta): TRIAL_RANGE,
    **{sp.Derivative(R(k, theta), z): sp.diff(TRIAL_RANGE, z) for z in (k, theta)},
    **{sp.Derivative(U(k, theta), z): sp.diff(U_OF_THETA, z) for z in (k, theta)},
}


class StationaryAngle(sp.Function):
    """The elevation at which tan(theta)**2 + dy/du is 0, as a number for trials: a root search, not Theorem 3.

    Argument: alpha > 0. The root lies between 1/(4 + 4 alpha) and pi/4, and below (4 + 2 log(1 + alpha))/alpha.
    """

    nargs = 1
    is_real = True
    is_positive = True

    def fdiff(self, argindex=1):
        """By the implicit function theorem, from the condition that defines the angle."""
        (a,) = self.args
        curvature = sp.diff(W_u, u, 2).subs(u, -1 - a * sp.sin(self))
        return curvature * sp.sin(self) / (2 * sp.tan(self) / sp.cos(self) ** 2 - curvature * a * sp.cos(self))

    @staticmethod
    def mp_value(a):
        """The angle to the working precision of mpmath."""
        return +_stationary_angle(mp.mpf(a), mp.dps)

    def _eval_evalf(self, prec):
        with mp.workprec(prec):
            return sp.Float(self.mp_value(mp.mpmathify(self.args[0].evalf(mp.dps + 5))), precision=prec)


@functools.lru_cache(maxsize=1024)
def _stationary_angle(a, digits):
    def condition(log_angle):
        angle = mp.exp(log_angle)
        at = -1 - a * mp.sin(angle)
        inverse = mp.lambertw(at * mp.exp(at)).real
        return mp.log(mp.tan(angle) ** 2) - mp.log(a * mp.sin(angle) * inverse / ((inverse + 1) * at))

    lost = 3 * max(0, -int(mp.log10(a)))  # y + 1 loses twice the digits that alpha is below 1
    with mp.workdps(50 + lost):
        ends = mp.log(1 / (4 + 4 * a)), mp.log(min(mp.pi / 4, (4 + 2 * mp.log(1 + a)) / a))
        near = mp.findroot(condition, ends, solver="anderson", tol=mp.mpf(10) ** -50, maxsteps=200)
    with mp.workdps(digits + 40 + lost):
        pair = near, near * (1 + mp.mpf(10) ** -20)
        return mp.exp(mp.findroot(condition, pair, solver="secant", tol=mp.mpf(10) ** -(2 * digits + 20)))
