"""Symbols of what the chord paper leaves open: the paper's, and those of the second root and of pure numbers."""

from galileo_sym.derivations.chord.notation import notation as printed
from galileo_sym.ledger import LENGTH, ONE, TIME

notation = printed.extended()
symbol, function = notation.symbol, notation.function

ago = symbol("ago", TIME, "time before the release", positive=True)
t_minus = symbol("t_minus", TIME, "the root of (30) before the release", real=True)
instant = symbol("instant", TIME, "any time, before the release or after", real=True)
push = symbol("push", 1 / TIME, "a drag that pushes: -gamma", positive=True)
j = symbol("j", ONE, "gamma times a root of (30)", real=True)
z = symbol("z", ONE, "t/sqrt(2*D/g), the time as a pure number", nonnegative=True)
tau_AB = symbol("tau_AB", ONE, "t_AB/sqrt(2*D/g), the descent time as a pure number", positive=True)
order = symbol("order", ONE, "order of a term of a Taylor series", integer=True, nonnegative=True)
p_n = symbol("p_n", ONE, "gamma times the descent time with friction and without drag", positive=True)

s_back = function("s_back", LENGTH, "distance from A so long before the release, under the same law")
S = function("S", ONE, "s/D, the distance as a pure number")
