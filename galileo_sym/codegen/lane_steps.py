"""A schedule's steps as forms on vectors take them: below a ceiling, and what solves in two parts."""

from galileo_sym.codegen.hoisting import names_in
from galileo_sym.codegen.schedule import Schedule, schedule

_TOLD = "{}_told"


def told_name(function, symbol):
    """Return the name of an argument as it is loaded: another one where a ceiling is to be looked at first."""
    return _TOLD.format(symbol) if function.ceiling and function.ceiling.argument == symbol else symbol


def _below(function, plan):
    """Steps with the ceiling's argument taken after all that does not depend on it: `below` tells lanes apart."""
    symbol = function.ceiling.argument
    before, after, found = [], [], {symbol}
    for name, node in plan.steps:
        if not found.isdisjoint(names_in(node)):
            found.add(name)
        (after if name in found else before).append((name, node))
    return [*before, ("most", plan.limit.most), (symbol, ("below", _TOLD.format(symbol), "most")), *after]


def _parted(steps):
    """Steps with what a solver needs of the resistance alone by itself, so that it can stand before a loop."""
    out = []
    for name, node in steps:
        if node[0] == "launch":
            _, _, reach, resistance = node
            out += [("shot", ("shot", resistance)), (name, ("launch", reach, "shot"))]
        else:
            out.append((name, node))
    return out


def _routine(function, force_set):
    """The one step of what the templates compute."""
    name = function.routine.split(".")[0].removeprefix("_")
    symbols = [a.symbol for a in function.arguments(force_set)]
    return Schedule(
        loads=symbols, steps=[(name, (name, *symbols))], results=[f"{name}.{o.name}" for o in function.outputs]
    )


def lane_schedule(function, force_set):
    """Plan one form.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.

    Returns
    -------
    galileo_sym.codegen.schedule.Schedule
        That of the scaled form, with other steps.
    """
    if function.routine:
        return _routine(function, force_set)
    plan = schedule(function, force_set)
    if plan.limit:
        plan.steps = _below(function, plan)
    plan.steps = _parted(plan.steps)
    return plan
