"""A plan in words: what each step gives, over which axes, with how many operations."""

from collections import Counter

from galileo_sym.generated._graphs import SYSTEMS
from galileo_sym.scenes.results import force_set

_HEADS = ("name", "over", "operations", "gives")
_ONCE = "once"
_FMA = "fma: a b + c of numbers in two parts, in one pass: 3 multiplications and 4 additions of doubles"
_MADE = {
    "product": "{}",
    "sum": "{}, from parts, so that no digits are lost where it cancels",
    "copy": "{}",
    "call": "by the public function {}",
    "number": "{}, folded",
}


def explained(plan, lengths):
    """Return a plan as a table of its steps and outputs, and the totals by axes.

    Parameters
    ----------
    plan : Plan
    lengths : dict of str to int, or None
        Of every axis; None for the operations of one element of each step.
    """
    times = lengths or dict.fromkeys(plan.over, 1)
    rows = [_HEADS]
    for step in plan.steps:
        done = _counted(plan.step_counts(step)) or step.operation
        rows.append((step.name, _over(step.axes), done, step.text))
    for result in plan.all_results:
        text = _MADE[result.operation].format(result.text)
        leader = plan.companions.get(result.output)
        done = f"with {leader}" if leader else _counted(plan.result_counts(result))
        rows.append((result.output, _over(result.axes), done, text))
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    lines = [f"{a:<{widths[0]}}  {b:<{widths[1]}}  {c:<{widths[2]}}  {d}".rstrip() for a, b, c, d in rows]
    totals = _totals(plan, times, lengths is not None)
    notes = [_FMA] if any("fma" in plan.result_counts(result) for result in plan.all_results) else []
    return "\n".join([headline(plan, lengths), "", *lines, "", *totals, *notes])


def headline(plan, lengths):
    """Return the system, forces, outputs, axes and constants of a plan."""
    acting = {*plan.over, *dict(plan.constants)}
    forces = force_set(plan.system, acting).replace("_", " and ")
    axes = [f"{axis} ({lengths[axis]})" if lengths else axis for axis in plan.over]
    units = {name: unit for name, (_, unit) in SYSTEMS[plan.system]["arguments"].items()}
    constants = [f"{name} = {value!r} {units[name]}" for name, value in plan.constants]
    outputs = ", ".join(result.output for result in plan.results)
    return f"{plan.system}, {forces}: {outputs} over {' x '.join(axes)}" + "".join(f"\n  {text}" for text in constants)


def _over(axes):
    return " x ".join(axes) or _ONCE


def _counted(counts):
    found = [f"{count} {kind}" for kind, count in sorted(counts.items()) if kind != "transcendental"]
    return ", ".join(found)


def _totals(plan, lengths, known):
    """A line for each set of axes, and one for all."""
    costs = plan.cost(lengths)
    lines = [f"{_over(axes)}: {_line(counts)}" for axes, counts in costs.items()]
    title = "in all" if known else "an element"
    if plan.arrival:
        title += ", at most, as times when nothing moves are left out"
    return [f"{title}:", *(f"  {line}" for line in lines), f"  total: {_line(sum(costs.values(), Counter()))}"]


def _line(counts):
    found = _counted(counts) or "nothing"
    return f"{found}; {counts['transcendental']} transcendental"
