"""The plan of a scene out of the stable forms of its outputs."""

from __future__ import annotations

from dataclasses import replace

from galileo_sym.generated._functions import FUNCTIONS
from galileo_sym.generated._graphs import SYSTEMS
from galileo_sym.scenes import folding
from galileo_sym.scenes.forms import Term, calls_of, symbols_of, terms_of
from galileo_sym.scenes.plan import End, Plan, Result, needed
from galileo_sym.scenes.specialise import Specialiser

_OF_ANGLE = ("sine", "cosine", "driving")


def force_set(system, acting):
    """Return the key of the forms with some forces: ``free``, ``friction``, ``drag`` or ``friction_drag``."""
    forces = SYSTEMS[system]["forces"]
    return "_".join(force for force, argument in forces.items() if argument in acting) or "free"


# Where and when a motion ends, by system: the output that is the time of it; and by output its form there, or None.
_DIAMETER, _SINE, _COSINE = ("symbol", "diameter"), *(("call", f, ("symbol", "theta")) for f in ("sine", "cosine"))
_ARRIVAL = {"chord": "descent_time", "projectile": "flight_time"}
_LIMITS = {
    "chord": {
        "x": ("product", _DIAMETER, _COSINE, _SINE),
        "y": ("product", _DIAMETER, _COSINE, _COSINE),
        "distance": ("product", _DIAMETER, _COSINE),
        "speed": None,
    },
    "projectile": {"x": "range", "y": "floor", "vx": None, "vy": None},
}


def plan_of(system, over, constants, outputs, *, direct, ending=False, split=True):
    """Return the plan of a scene.

    Parameters
    ----------
    system : str
    over : tuple of str
        The axes.
    constants : dict of str to float
        The other arguments, without forces that do not act.
    outputs : tuple of str
    direct : bool
        Whether an output whose axes do not separate is left to the public function; else it has steps of its own.
    ending : bool, optional
        Whether nothing moves before the start, nor after arrival or landing.
    split : bool, optional
        Whether outputs are made of factors on fewer axes where there are such.

    Returns
    -------
    Plan
    """
    acting = tuple(a for a in SYSTEMS[system]["forces"].values() if a in over or a in constants)
    specialiser = Specialiser(over, constants)

    def result(output, split=False):
        return _result(specialiser, system, acting, output, direct, split)

    results = tuple(result(output, split) for output in outputs)
    arrival, ends = None, ()
    if ending and any(output in _LIMITS[system] for output in outputs):
        arrival = result(_ARRIVAL[system])
        ending_ones = [r for r in results if r.output in _LIMITS[system]]
        ends = tuple(_end(specialiser, system, r, arrival, result) for r in ending_ones)
    domains = {name: domain for name, (domain, _) in SYSTEMS[system]["arguments"].items()}
    plan = Plan(system, over, tuple(constants.items()), tuple(domains.items()), (), results, arrival, ends)
    return replace(plan, steps=needed(tuple(specialiser.made.values()), plan.all_results))


def _end(specialiser, system, result, arrival, of_output):
    """How an output ends."""
    form = _LIMITS[system][result.output]
    limit = None
    if form == "range":
        limit = of_output(form)
    elif isinstance(form, tuple):
        limit = _limit(specialiser, result, terms_of(form))
    axes = specialiser.union(result.axes, arrival.axes, limit.axes if limit else (), specialiser.axes_of({"t"}))
    return End(result.output, axes, limit, form == "floor")


def _limit(specialiser, result, terms):
    """The value of an output at the end of a chord."""
    axes = specialiser.axes_of(symbols_of(terms))
    row = {"at_rest": 0.0, "function": None}
    operation, operands, text = _made(specialiser, row, terms, axes, False, False)
    return Result(f"{result.output} at arrival", axes, operation, operands, None, None, (), 0, text)


def _result(specialiser, system, acting, output, direct, split):
    row = SYSTEMS[system]["outputs"][output]
    terms = terms_of(row["forms"][force_set(system, acting)])
    served = FUNCTIONS[row["function"]]
    ufuncs = served["ufuncs"][tuple(force for force in served["forces"] if force in acting)]
    arguments = (*row["arguments"], *(force for force in served["forces"] if force in acting))
    axes = specialiser.axes_of(symbols_of(terms))
    operation, operands, text = _made(specialiser, row, terms, axes, direct, split)
    return Result(
        output,
        axes if operation != "number" else (),
        operation,
        operands,
        row["function"],
        ufuncs[1 + row["index"]] if served["outputs"] > 1 else ufuncs[0],
        arguments,
        _transcendental(terms),
        text,
    )


def _transcendental(terms):
    """Transcendental calls in terms; sine, cosine and driving force of one angle are one."""
    return len({("angle", call[2]) if call[1] in _OF_ANGLE else call for call in calls_of(terms)})


def _made(specialiser, row, terms, axes, direct, split):
    """Operation of an output, its operands, and what it gives; as one value if it is not to be split into factors."""
    if folding.held(calls_of(terms), specialiser.constants):
        return "number", (row["at_rest"],), "at rest"
    if not axes:
        value = float(folding.fold(terms, specialiser.constants))
        return "number", (value,), f"{value:.6g}"
    if split:
        made = _sum(specialiser, terms, axes) if len(terms) > 1 else _product(specialiser, row, terms[0])
        if made:
            return made
    if direct:
        return "call", (), row["function"]
    whole = specialiser.sum(terms)
    return "copy", (_rounded(specialiser, row, whole, "store"),), specialiser.text(whole)


def _rounded(specialiser, row, node, operation):
    forces = specialiser.driving(node)
    return specialiser.step(operation, (node, row["at_rest"] if forces else None, *forces), specialiser.text(node))


def _product(specialiser, row, term):
    """Of two factors, each rounded once; None if a term has no two."""
    factors = specialiser.separated(specialiser.groups(term))
    if not factors:
        return None
    rounded = tuple(_rounded(specialiser, row, node, "round") for node in factors)
    return "product", rounded, " * ".join(map(specialiser.text, factors))


def _sum(specialiser, terms, axes):
    """Of products of factors in halves, and of terms on fewer axes; None if a term on all axes has no two factors."""
    addends, texts = [], []
    for term in sorted(terms, key=lambda term: term.coefficient < 0):
        sign, size = (-1 if term.coefficient < 0 else 1), Term(abs(term.coefficient), term.factors)
        groups = specialiser.groups(size)
        nodes = specialiser.separated(groups) if specialiser.union(*(a for a, _ in groups)) == axes else None
        if nodes is None:
            nodes, kind = (specialiser.term(size),), "parts"
            if specialiser.made[nodes[0]].axes == axes:
                return None
        else:
            kind = "halves"
        addends.append((sign, *(specialiser.step(kind, (node,), specialiser.text(node)) for node in nodes)))
        texts.append(("- " if sign < 0 else "+ ") + " * ".join(map(specialiser.text, nodes)))
    return "sum", tuple(addends), " ".join(texts).removeprefix("+ ")
