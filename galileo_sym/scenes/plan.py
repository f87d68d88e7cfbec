"""The plan of a scene: what is computed, each thing once, over the axes it depends on.

A plan is data, the same for every back end:

- ``steps``, in the order they are computed. A step has a name, the axes it depends on, an operation and its operands:
  names of earlier steps, or what `LEAVES` says. Steps make scaled pairs, (hi + lo) 2^e with a relative error of about
  2^-100, but for the last ones of a factor (`ROUNDINGS`), which make doubles.
- ``results``, one for each output: the operation at its points and the factors it takes.

=========== ============================================== ==================================================
operation   operands                                       makes
=========== ============================================== ==================================================
load        name of an axis                                the pair of its values
constant    hi, lo, e                                      a folded constant as a pair
angle       name of an axis, or a double                   sine, cosine and sign of an angle
sine cosine angle                                          a pair
driving     angle, pair of mu                              cos - mu sin of its size; the bead rests where it is <= 0
mul div add pairs                                          a pair
sub sqrt    pairs, pair                                    a pair
scale       pair, k                                        the pair times 2^k
phi0m, ...  pair                                           the primitive of the pair (`PRIMITIVES`)
round       pair, value at rest, driving steps             a double, if a product of two such is sure to be normal;
                                                           the value at rest where one of the forces is <= 0
store       the same                                       a double, whatever its size
halves      pair                                           two doubles, the first of 26 bits: products are exact
parts       pair                                           two doubles, the first rounded to the nearest
=========== ============================================== ==================================================

Operations of results: ``product`` of two rounds; ``sum`` of (sign, halves, halves) and (sign, parts); ``copy`` of a
store; ``call`` of a public function, where no two factors separate the axes; ``number``, folded, without any work.
Where there is the extension, a sum is an ``fma`` for each product, a b + c of parts in one pass; else 7 of NumPy's.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from math import prod

from galileo_sym import _backend

PRIMITIVES = ("phi0m", "phi1m", "phi2m", "descent_factor", "flight_factor", "range_factor")
TRANSCENDENTAL = ("angle", *PRIMITIVES)
LEAVES = ("load", "constant", "angle")
ROUNDINGS = ("round", "halves", "parts", "store")
_FREE = ("load", "constant", "sine", "cosine", "scale", *ROUNDINGS)  # no arithmetic in any of these


@dataclass(frozen=True)
class Step:
    """One operation over some axes; ``text`` says what it gives."""

    name: str
    axes: tuple
    operation: str
    operands: tuple
    text: str


@dataclass(frozen=True)
class Result:
    """How an output is made at its points.

    ``axes`` are those it depends on; ``operands`` names of factors, or of each addend (sign, names); ``function`` is
    the public one that it is an output of, ``ufunc`` the name of what serves with ``arguments``; ``transcendental``
    counts the calls at a point of a public function that is called.
    """

    output: str
    axes: tuple
    operation: str
    operands: tuple
    function: str
    ufunc: str
    arguments: tuple
    transcendental: int
    text: str

    @property
    def name(self):
        """The output's."""
        return self.output


@dataclass(frozen=True)
class End:
    """Where an output stays after the motion: between 0 and ``limit`` (position), or at 0 (speed, ``limit`` is None).

    ``axes`` are those that the output depends on, with its end. A height has ``floor``: it is never less than 0.
    """

    output: str
    axes: tuple
    limit: Result | None
    floor: bool = False


@dataclass(frozen=True)
class Plan:
    """What a scene computes.

    ``over`` are its axes, ``constants`` (name, double), ``domains`` (name, domain) of all arguments of the system;
    ``arrival`` is the result for the time when the motion ends, and ``ends`` what ends then; None and empty otherwise.
    """

    system: str
    over: tuple
    constants: tuple
    domains: tuple
    steps: tuple
    results: tuple
    arrival: Result | None = None
    ends: tuple = ()

    @property
    def all_results(self):
        """The results, and before them what tells where and when they end."""
        return tuple(dict.fromkeys([*self.bounds, *self.results]))

    @property
    def bounds(self):
        """What tells when and where the motion ends."""
        arrival = [self.arrival] if self.arrival else []
        return tuple(dict.fromkeys([*arrival, *(end.limit for end in self.ends if end.limit)]))

    @property
    def companions(self):
        """Outputs that another one's call of the public function gives, too: by name that other one's."""
        first, found = {}, {}
        for result in self.results:
            if result.operation == "call" and result.axes == self.over:
                leader = first.setdefault(result.function, result.output)
                if leader != result.output:
                    found[result.output] = leader
        return found

    def points(self, axes, lengths):
        """Return how many elements there are over some axes."""
        return prod(lengths[axis] for axis in axes)

    def step_counts(self, step):
        """Return the operations of one element of a step, by kind: a Counter; the transcendental ones also as such."""
        counts = Counter() if step.operation in _FREE else Counter({step.operation: 1})
        if step.operation in TRANSCENDENTAL:
            counts["transcendental"] += 1
        return counts

    def result_counts(self, result):
        """Return the operations at one point of an output, by kind: a Counter; none if another one's call gives it."""
        if result.output in self.companions:
            return Counter()
        if result.operation == "product":
            return Counter(multiply=1)
        if result.operation == "call":
            return Counter(call=1, transcendental=result.transcendental)
        if result.operation == "sum":
            products = sum(len(addend) == 3 for addend in result.operands)
            if _backend.EXTENSION is not None:
                return Counter(fma=max(products, 1))
            return Counter(multiply=3 * products, add=products + 2 * (len(result.operands) - 1) + 1)
        return Counter()

    def cost(self, lengths):
        """Return the operations for axes of given lengths, by axes and kind: a dict of Counter.

        Parameters
        ----------
        lengths : dict of str to int
            Of every axis.
        """
        total = {}
        for step in self.steps:
            counts = self.step_counts(step)
            _charge(total, step.axes, counts, self.points(step.axes, lengths))
        for result in self.all_results:
            _charge(total, result.axes, self.result_counts(result), self.points(result.axes, lengths))
        return total


def needed(steps, results):
    """Return those of some steps that results take, and those that these take, in order."""
    wanted = {name for result in results for name in names_in(result.operands)}
    for step in reversed(steps):
        if step.name in wanted:
            wanted.update(names_in(step.operands))
    return tuple(step for step in steps if step.name in wanted)


def names_in(operands):
    """Return the names in nested operands: a set."""
    if isinstance(operands, str):
        return {operands}
    return set().union(*map(names_in, operands)) if isinstance(operands, tuple) else set()


def _charge(total, axes, counts, times):
    if counts:
        total.setdefault(axes, Counter()).update({kind: count * times for kind, count in counts.items()})
