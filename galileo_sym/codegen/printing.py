"""What both languages share: nodes as nested calls, operation counts and sources in words, undecided limits."""

from itertools import combinations

from galileo_sym.catalogue import stable
from galileo_sym.solvers import SOLVERS

PRIMITIVE_TEXT = "Operations: those of the primitive {}."
ROUTINE_TEXT = "Operations: as its cases need, at most a few dozen in pairs."


def call_text(node, prefix):
    """Return a node as nested calls, each operation with a prefix.

    Parameters
    ----------
    node : tuple, str or number
        A node of the schedule.
    prefix : str
        Put before each operation: ``""`` in Python, ``"gs_"`` in C.
    """
    if isinstance(node, str):
        return node
    if isinstance(node, int | float):
        return repr(node)
    operands = ", ".join(call_text(operand, prefix) for operand in node[1:])
    return f"{prefix}{node[0]}({operands})"


def counts_text(schedule):
    """Return the operations of a kernel in words."""
    return ", ".join(f"{count} {kind}" for kind, count in sorted(schedule.counts.items())) or "no operations"


def operations_text(schedule):
    """Return a sentence on the operations of a kernel."""
    return f"Operations: {counts_text(schedule)}."


def sources_text(function, force_set):
    """Return where a kernel comes from: its ledger entry and the printed equations behind it."""
    return f"{function.ledger_id(force_set)}, the stable form of {', '.join(function.sources(force_set))}"


def clash_pairs(function, force_set, output):
    """Return pairs of lists of this kernel's arguments: one of each list infinite at once leaves the limit undecided.

    They come from the groups of the output, of which an argument may belong to several: these agree about it. What the
    result does not depend on decides nothing.
    """
    arguments = function.arguments(force_set)
    if (function.full_name, force_set) in SOLVERS:
        present = {argument.name for argument in arguments}
    else:
        form = stable(function, force_set)[function.outputs.index(output)]
        symbols = {symbol.name for symbol in form.free_symbols}
        present = {argument.name for argument in arguments if argument.symbol in symbols}
    groups = [[name for name in group if name in present] for group in output.limits]
    pairs = []
    for one, other in combinations(groups, 2):
        pair = [name for name in one if name not in other], [name for name in other if name not in one]
        if all(pair):
            pairs.append(pair)
    return pairs


def _rid_of(pairs, force):
    """Pairs, in no order, of which no member is a force: one that is 0 is not infinite."""
    reduced = {tuple(frozenset(group) - {force} for group in pair) for pair in pairs}
    return {pair for pair in reduced if all(pair)}


def undecided_text(function, force_set, output, told, choose):
    """Return when the limit of an output is undecided; where a force is 0 in an array, as its absence has it.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
    output : galileo_sym.catalogue.Output
    told : callable
        The text of pairs, as from `clash_pairs`; of none, too.
    choose : callable
        The text of a choice, from the name of a force, the text where it is 0, and where it is not.
    """
    variants = {frozenset(names): key for key, (names, _) in function.variants.items()}

    def text(left, acting):
        pairs = clash_pairs(function, variants[frozenset(acting)], output)
        for place, force in enumerate(left):
            absent = clash_pairs(function, variants[frozenset(acting - {force})], output)
            if _rid_of(pairs, force) != _rid_of(absent, force):
                others = left[place + 1 :]
                return choose(force, text(others, acting - {force}), text(others, acting))
        return told(pairs)

    forces = function.variants[force_set][0]
    return text(list(forces), set(forces))
