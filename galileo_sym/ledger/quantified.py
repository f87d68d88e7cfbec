"""Statements about every value of a variable: what a hypothesis supposes, what a theorem concludes."""

from __future__ import annotations

from .predicates import Claim, spread

POINTS = 5  # across the interval: the other variables have many values, too


class ForAll(Claim):
    """``ForAll(statement, x, interval)``: the statement holds for every x in the interval."""

    def trials(self):
        statement, x, interval = self.args
        return [(statement, {x: place}) for place in spread(interval, POINTS)]

    def check_dimensions(self, agree):
        _, x, interval = self.args
        agree(x, *(end for end in (interval.start, interval.end) if end.is_finite is not False))
