"""Primitives that take more than a look-up: lines for each range of the argument, around the approximations."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Range:
    """[begin, end), or [begin, inf] if end is infinite, and the lines that there compute ``r`` and ``lo``.

    ``lines`` are for x + x_lo; `lines.alone` makes those for x of them.
    ``instead`` is the argument that other lanes are given: one that raises no flag; begin by default.
    ``fewer`` are the lines that compute ``r`` for binary32, in plain arithmetic; by default those that are left of
    ``lines`` without what is there for ``lo``.
    """

    begin: float
    end: float
    lines: tuple
    instead: float = None
    fewer: tuple = ()

    @property
    def harmless(self):
        """An argument that raises no flag."""
        return self.begin if self.instead is None else self.instead


@dataclass(frozen=True)
class Frame:
    """A primitive: the first of its ranges is the typical one; the others are looked at only if some lane needs them.

    ``domain`` is the least and the greatest argument, beyond which the value is NaN; ``pair_domain`` the same as pairs,
    where these differ. At ``pole``, 0 or None, the value is infinite, and public functions raise 'divide by zero'.
    ``parity`` is "odd" or "even" for a function whose ranges are of abs(x). ``banks`` are the approximations that the
    lines look up, ``tables`` other tables of 16 values.
    """

    name: str
    doc: str
    banks: tuple
    ranges: tuple
    domain: tuple
    parity: str = ""
    tables: dict = field(default_factory=dict)
    pair_domain: tuple = ()
    pole: float = None

    @property
    def ends(self):
        """The least and the greatest argument as pairs."""
        return self.pair_domain or tuple((v, 0.0) for v in self.domain)

    @property
    def thresholds(self):
        """Where one form gives way to the next."""
        return tuple(r.begin for r in self.ranges) + tuple(v for v in self.domain if abs(v) < float("inf"))
