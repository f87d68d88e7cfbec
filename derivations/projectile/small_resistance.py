"""A limit theorem for inverse functions and its application: W(u e^u) as u comes to -1 from below."""

from sympy import Eq, Limit

from galileo_sym.derivations.projectile.notation import W_u, notation, s, u
from galileo_sym.ledger import Chapter, Domain, step, tell_chapter
from galileo_sym.tactics import limit_by_parameter

chapter = Chapter("projectile.small_resistance", notation, "A limit theorem for inverse functions and its application")


@chapter.derive("projectile.thm1.cor", Eq(Limit((W_u + 1) / (u + 1), u, -1, "-"), -1), Domain({}))
def corollary(support__s_param):
    """With u = u(s), W = u + s, the limit is one of elementary functions."""
    ratio = (W_u + 1) / (u + 1)
    u_of_s = support__s_param.of(u)
    in_s = ratio.subs(W_u, support__s_param.of(W_u)).subs(u, u_of_s)
    found = limit_by_parameter(in_s, u, -1, "-", s, u_of_s, 0)
    step("in the parameter", Eq(Limit(in_s, s, 0, "+"), found, evaluate=False))
    return Eq(Limit(ratio, u, -1, "-"), found, evaluate=False)


if __name__ == "__main__":
    tell_chapter(chapter.name)
