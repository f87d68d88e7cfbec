"""Small chapters to try the ledger on, with a notation of their own."""

from sympy import Eq

from galileo_sym.ledger import LENGTH, ONE, POSITIVE, TIME, Chapter, Domain, Ledger, Notation, step

notation = Notation("small")
p = notation.symbol("p", ONE, "a positive number", positive=True)
q = notation.symbol("q", ONE, "a number")
r = notation.symbol("r", ONE, "another number")
a = notation.symbol("a", LENGTH, "a length", positive=True)
b = notation.symbol("b", LENGTH, "another length")
h = notation.symbol("h", TIME, "a time", nonnegative=True)
f = notation.function("f", LENGTH, "a motion")

SOME = Domain({p: POSITIVE})
TWICE = Eq(q, 2 * p)


def chapter():
    """An empty chapter."""
    return Chapter("stable.small", notation, "a chapter of the tests")


def entry(printed, domain=SOME, result=None, *, steps=(), erratum=None):
    """The entry with this printed form, whose derivation tells these steps and returns `result` (else the print)."""
    made = chapter()

    @made.derive("stable.test.entry", printed, domain, erratum=erratum)
    def derivation():
        for statement in steps:
            step("on the way", statement)
        return printed if result is None else result

    return Ledger([made])["stable.test.entry"]
