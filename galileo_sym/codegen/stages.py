"""A loop over vectors divided into several over a group of them, so that none waits for a long chain of operations.

A processor looks ahead by some hundred operations. A formula of more, each of which waits for the one before, leaves it
idle: the sine, then quotients and roots, then a primitive. Divided at these places the chains are short, and those of
several vectors overlap; what one loop leaves to the next stays in the nearest cache. Primitives have loops of their
own, where arguments of one range can be served together.
"""

from dataclasses import dataclass, field

from galileo_sym.codegen.factors import FACTORS
from galileo_sym.codegen.hoisting import names_in, operands_of

_OF_ANGLES = {"angle", "sine", "cosine", "sine_of", "cosine_of", "driving"}
_SLOW = {"div", "sqrt"}
_LATE = {"phi0m", "below", "arctangent", "shot", "launch", "roots"}  # lanes may fail, or what is made is no number


@dataclass
class Stage:
    """One loop: assignments, each a (name, node); names that it takes of earlier loops, and leaves to later ones.

    ``calls`` are the primitives of what it leaves, made when it is done: each (name, primitive, name of the argument).
    """

    steps: list
    taken: list = field(default_factory=list)
    left: list = field(default_factory=list)
    calls: list = field(default_factory=list)


def operations_in(*nodes):
    """The operations in nodes."""
    return {n for node in nodes if not isinstance(node, str) for n in (node[0], *operations_in(*operands_of(node)))}


class _Caller:
    """Names for calls of primitives."""

    def __init__(self):
        self.calls = {}

    def without(self, node):
        """A node in which names stand for calls."""
        if isinstance(node, str) or node[0] == "constant":
            return node
        if node[0] == "range_balance":
            node = ("mul", ("phi0m", node[1]), ("grown_balance", node[1]))
        if node[0] not in FACTORS:
            return (node[0], *(self.without(o) if isinstance(o, str | tuple) else o for o in node[1:]))
        return self.calls.setdefault(node, f"factor{len(self.calls) + 1}")


def _early(steps, wanted):
    """The names of the steps that some names need."""
    found = set(wanted)
    for name, node in reversed(steps):
        if name in found:
            found |= names_in(node)
    return found & {name for name, _ in steps}


def divided(steps, results):
    """Divide what a loop computes.

    Parameters
    ----------
    steps : list of (str, node)
        Assignments in order.
    results : list of node

    Returns
    -------
    (list of Stage, list of node)
        The last stage makes the results, given as it makes them.
    """
    caller = _Caller()
    steps = [(name, caller.without(node)) for name, node in steps]
    results = list(map(caller.without, results))
    calls = []
    for (factor, argument), name in caller.calls.items():
        given = argument in {name for name, _ in steps}
        if not given:
            steps.insert(0, (f"{name}_of", argument))
        calls.append((name, factor, argument if given else f"{name}_of"))
    early = _early(steps, {argument for _, _, argument in calls})
    loops, waiting, slow, late = ([], [], []), set(), set(), {name for name, _, _ in calls}
    for name, node in steps:
        operations, names = operations_in(node), names_in(node)
        if name not in early and (names & late or operations & _LATE):
            place = 2
        elif names & slow or (names & waiting and operations & _SLOW):
            place = 1
        else:
            place = 0 if name in early or names & waiting or operations & (_OF_ANGLES | _SLOW) else 2
        loops[place].append((name, node))
        {0: waiting, 1: slow, 2: late}[place].add(name)
    return _linked([Stage(loop) for loop in loops[:2] if loop] + [Stage(loops[2])], calls, results), results


def _linked(stages, calls, results):
    """Stages with what one leaves to another."""
    if calls:
        stages[-2].calls = calls
    made = [{name for name, _ in stage.steps} | {name for name, _, _ in stage.calls} for stage in stages]
    needed = [names_in(*(node for _, node in stage.steps)) for stage in stages]
    needed[-1] |= names_in(*results)
    arguments = {argument for _, _, argument in calls}
    for i, stage in enumerate(stages):
        stage.taken = sorted(set().union(*made[:i]) & needed[i])
        later = set().union(*needed[i + 1 :]) | (arguments if i < len(stages) - 1 else set())
        stage.left = [name for name, _ in stage.steps if name in later]
    return stages
