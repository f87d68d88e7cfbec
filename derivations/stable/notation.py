"""Symbols of the removable singularities: the dimensionless numbers of the primitives, and the parameter s."""

from galileo_sym.ledger import ONE, Notation

notation = Notation("stable")

s = notation.symbol("s", ONE, "gamma or k times the time of arrival", positive=True)
z = notation.symbol("z", ONE, "gamma*t or k*t", positive=True)
p = notation.symbol("p", ONE, "gamma times the descent time without drag", positive=True)
b = notation.symbol("b", ONE, "k*v*sin(theta)/g", positive=True)
a = notation.symbol("a", ONE, "k*v/g", positive=True)
