"""Symbols of what the projectile paper leaves open: the paper's, and those of slopes, hills and pure numbers."""

import sympy as sp

from galileo_sym.derivations.projectile.notation import notation as printed
from galileo_sym.ledger import LENGTH, ONE, TIME

notation = printed.extended()
symbol, function = notation.symbol, notation.function

STEEPEST = sp.Interval.open(-sp.pi / 2, sp.pi / 2)

beta = symbol("beta", ONE, "elevation of a slope through the launch point", STEEPEST, real=True)
lift = symbol("lift", ONE, "sin(theta - beta)/cos(beta)", positive=True)
h = symbol("h", LENGTH, "height of the launch above the ground", nonnegative=True)
eta = symbol("eta", ONE, "k**2*h/g", nonnegative=True)
time = symbol("time", TIME, "time of flight to a slope, or from a hill", real=True)
reach = symbol("reach", LENGTH, "range along a slope, or from the foot of a hill", real=True)
z = symbol("z", ONE, "g*t/v, the time as a pure number", real=True)
rho = symbol("rho", ONE, "g*R/v**2, the range as a pure number", real=True)
x_e = symbol("x_e", LENGTH, "abscissa of a point of the envelope of trajectories", positive=True)
y_e = symbol("y_e", LENGTH, "height of a point of the envelope of trajectories", real=True)
sigma = symbol("sigma", ONE, "sine of the elevation", positive=True)
order = symbol("order", ONE, "order of a term of a Taylor series", integer=True, nonnegative=True)

X = function("X", ONE, "g*x/v**2, the abscissa as a pure number")
Y = function("Y", ONE, "g*y/v**2, the height as a pure number")
