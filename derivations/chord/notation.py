"""Symbols of the chord paper: y points down, theta is measured from the vertical and signed."""

import sympy as sp

from galileo_sym.ledger import LENGTH, MASS, ONE, TIME, Notation

ACCELERATION = LENGTH / TIME**2

ACUTE = sp.Interval.open(0, sp.pi / 2)

notation = Notation("chord")
symbol, function = notation.symbol, notation.function

g = symbol("g", ACCELERATION, "gravity", positive=True)
D = symbol("D", LENGTH, "diameter AC of the circle", positive=True)
m = symbol("m", MASS, "mass of the bead", positive=True)
mu = symbol("mu", ONE, "coefficient of sliding friction", positive=True)
gamma = symbol("gamma", 1 / TIME, "drag force for unit mass and speed", positive=True)
theta = symbol("theta", ONE, "angle from the vertical AC to the chord AB, positive to the right", real=True)
t = symbol("t", TIME, "time since release", nonnegative=True)
x = symbol("x", LENGTH, "horizontal coordinate, to the right", real=True)
y = symbol("y", LENGTH, "vertical coordinate, downwards", real=True)
s_AB = symbol("s_AB", LENGTH, "length of the chord AB", positive=True)
s_BC = symbol("s_BC", LENGTH, "length of the chord BC", positive=True)
t_AB = symbol("t_AB", TIME, "descent time along AB", positive=True)
t_BC = symbol("t_BC", TIME, "descent time along BC", positive=True)
t_AC = symbol("t_AC", TIME, "time of fall along AC", positive=True)
tau = symbol("tau", TIME, "time of free fall along AC", positive=True)
theta_max = symbol("theta_max", ONE, "angle from which on a bead stays at rest", ACUTE, positive=True)
theta_c = symbol("theta_c", ONE, "angle of the line on which the centre moves", ACUTE, positive=True)
xt = symbol("xt", ONE, "x rescaled by the time-dependent length", real=True)
yt = symbol("yt", ONE, "y rescaled by the time-dependent length", real=True)
N = symbol("N", MASS * ACCELERATION, "normal force of the chord on the bead", nonnegative=True)
F_g = symbol("F_g", MASS * ACCELERATION, "force of gravity along the chord, downwards", real=True)
F_f = symbol("F_f", MASS * ACCELERATION, "force of friction along the chord, upwards", nonnegative=True)
F_d = symbol("F_d", MASS * ACCELERATION, "force of drag along the chord, upwards", real=True)
n = symbol("n", ONE, "1 - mu*tan(Abs(theta))", positive=True)
p = symbol("p", ONE, "gamma times the descent time without drag", positive=True)
w = symbol("w", ONE, "argument of F(w) = w*exp(w)", real=True)
q = symbol("q", ONE, "value of F", real=True)
c = symbol("c", ONE, "gamma^2*D/g", positive=True)
h = symbol("h", ONE, "distance of w from -1, where F is least", positive=True)
zeta = symbol("zeta", ONE, "gamma times a time", real=True)
slope_right = symbol("slope_right", ONE, "slope of the right arc where it meets the left one", real=True)
slope_left = symbol("slope_left", ONE, "slope of the left arc where it meets the right one", real=True)
xt_r, yt_r = (symbol(f"{c}_r", ONE, f"{c} of the centre of the right circle", real=True) for c in ("xt", "yt"))
xt_l, yt_l = (symbol(f"{c}_l", ONE, f"{c} of the centre of the left circle", real=True) for c in ("xt", "yt"))
rho_r, rho_l = (symbol(f"rho_{c}", ONE, "radius of a rescaled circle", positive=True) for c in ("r", "l"))
apart = symbol("apart", ONE, "distance of two rescaled centres", nonnegative=True)
sigma = symbol("sigma", ONE, "sign of theta", real=True)

s = function("s", LENGTH, "distance from A along the chord")
R = function("R", LENGTH, "radius of the synchronous circle", nonnegative=True)
X = function("X", LENGTH, "distance of the centre from the vertical", nonnegative=True)
Y = function("Y", LENGTH, "depth of the centre", nonnegative=True)
x_c = function("x_c", LENGTH, "x of the centre of a synchronous circle")
y_c = function("y_c", LENGTH, "y of the centre of a synchronous circle")
F = function("F", ONE, "w*exp(w)")
W_0 = function("W_0", ONE, "principal real branch of Lambert W")
W_1 = function("W_1", ONE, "the other real branch of Lambert W, W_(-1)")
