"""What of a schedule depends on arrays, and what can be computed once before."""

from dataclasses import dataclass, field


@dataclass
class Hoisted:
    """Assignments before a loop over arrays, those in it, each a (name, node), and the results' nodes."""

    before: list = field(default_factory=list)
    each: list = field(default_factory=list)
    results: list = field(default_factory=list)


def operands_of(node):
    """Return the operands of a node that are nodes."""
    return () if isinstance(node, str) else tuple(o for o in node[1:] if isinstance(o, str | tuple))


def names_in(*nodes):
    """Return the names in nodes."""
    return {n for node in nodes for n in ([node] if isinstance(node, str) else names_in(*operands_of(node)))}


class _Hoister:
    def __init__(self, varying):
        self.varying, self.named, self.found = set(varying), {}, Hoisted()

    def varies(self, node):
        """Whether a node depends on an array."""
        return not self.varying.isdisjoint(names_in(node))

    def left(self, node):
        """A node of the loop, with names, given once, for what in it does not vary."""
        if not isinstance(node, tuple) or node[0] == "constant":
            return node
        if self.varies(node):
            return (node[0], *map(self.left, node[1:]))
        if node not in self.named:
            self.named[node] = f"once{len(self.named) + 1}"
            self.found.before.append((self.named[node], node))
        return self.named[node]

    def assign(self, name, node):
        """Put an assignment where it belongs."""
        if self.varies(node):
            self.found.each.append((name, self.left(node)))
            self.varying.add(name)
        else:
            self.found.before.append((name, node))


def hoisted(steps, results, varying):
    """Divide what is computed.

    Parameters
    ----------
    steps : list of (str, node)
        Assignments in order.
    results : list of node
    varying : iterable of str
        Names of what is an array.

    Returns
    -------
    Hoisted
    """
    hoister = _Hoister(varying)
    for name, node in steps:
        hoister.assign(name, node)
    hoister.found.results = list(map(hoister.left, results))
    return hoister.found
