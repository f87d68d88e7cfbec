"""Hold measurements against claims and records: one row for each stratum and back end."""

from dataclasses import asdict, dataclass, replace

import numpy as np

from .functions import FUNCTIONS
from .measure import Sample, as_hex, evaluate, measure, same_bits
from .screening import Rounded
from .ulp import rounded_up

OK = "ok"


@dataclass(frozen=True)
class Row:
    """One line of the report.

    Attributes
    ----------
    function, force_set, stratum : str
        Where.
    back_end : str
        Which back end, or several that agree to the bit.
    points : int
        How many were tried, besides a recorded worst input.
    measured : float
        Largest error found, rounded up; the true maximum is at least about that.
    output : str
        The output it is of.
    worst : dict of str to str
        The input it occurs at, in hex.
    bound : float
        The claim.
    verdict : str
        "ok", or what is wrong; of a contender, what share of its results is no number.
    compared : bool
        Whether it is a contender's, shown for comparison and not judged; `measured` is then over its finite results.
    """

    function: str
    force_set: str
    stratum: str
    back_end: str
    points: int
    measured: float
    output: str
    worst: dict
    bound: float
    verdict: str
    compared: bool = False

    @property
    def failed(self):
        """Whether it keeps verification from holding."""
        return self.verdict != OK and not self.compared

    def as_dict(self):
        return asdict(self)


def _verdict(measurement, bound, record):
    """What a measurement means for a claim and, if there is one, an earlier record."""
    if not measurement.error <= bound:
        return "exceeds its bound"
    if record is not None and measurement.recorded_error > record["measured"]:
        return "worse than recorded"
    return OK


def _failure(sample, back_end, verdict, bound):
    task = sample.task
    return Row(
        task.function,
        task.force_set,
        task.stratum,
        back_end,
        sample.size,
        float("inf"),
        "",
        as_hex(sample.point(0)),
        bound,
        verdict,
    )


def judge(sample, back_ends, record):
    """Measure every back end on a sample and judge it.

    Parameters
    ----------
    sample : Sample
        Points with references; the recorded worst input last, if there is a record.
    back_ends : list
        Objects with `name` and `evaluate`; those that agree with the first to the bit are one row.
    record : dict or None
        What the certificate says of this stratum.

    Returns
    -------
    rows : list of Row
        One for each group of back ends that agree.
    worst : Measurement or None
        The largest error over all back ends, None if one of them failed.
    """
    task = sample.task
    function = FUNCTIONS[task.function]
    bound = function.bound if record is None else record["bound"]
    agreeing, rows, measurements = [], [], []
    first = None
    for back_end in back_ends:
        try:
            results = evaluate(sample, back_end)
        except Exception as cause:  # any failure of a back end is a finding, and the other strata still count
            rows.append(_failure(sample, back_end.name, f"{type(cause).__name__}: {cause}", bound))
            continue
        if first is not None and same_bits(first, results):
            agreeing.append(back_end.name)
            continue
        measurement = measure(sample, results)
        measurements.append((back_end.name, measurement, _verdict(measurement, bound, record)))
        if first is None:
            first = results
    for position, (name, measurement, verdict) in enumerate(measurements):
        names = [name, *agreeing] if position == 0 else [name]
        rows.append(
            Row(
                task.function,
                task.force_set,
                task.stratum,
                " = ".join(names),
                sample.size,
                rounded_up(measurement.error),
                measurement.output,
                as_hex(measurement.worst),
                bound,
                verdict,
            )
        )
    failed = len(rows) > len(measurements)
    worst = None if failed else max((measurement for _, measurement, _ in measurements), key=lambda one: one.error)
    return rows, worst


def compare(sample, contender):
    """Measure a contender on a sample, for comparison.

    Parameters
    ----------
    sample : Sample
        Points with references.
    contender : object
        With `name` and `evaluate`.

    Returns
    -------
    Row
    """
    task = sample.task
    results = evaluate(sample, contender)
    finite = np.logical_and.reduce([np.isfinite(values) for values in results])[: sample.size]
    kept = np.flatnonzero(finite)
    arguments = {name: values[kept] for name, values in sample.arguments.items()}
    exact = tuple(Rounded(*(column[kept] for column in output)) for output in sample.exact)
    part = Sample(replace(task, recorded=None), arguments, exact)
    found = measure(part, tuple(values[kept] for values in results)) if len(kept) else None
    return Row(
        task.function,
        task.force_set,
        task.stratum,
        contender.name,
        sample.size,
        rounded_up(found.error) if found else float("inf"),
        found.output if found else "",
        as_hex(found.worst) if found else {},
        float("inf"),
        f"for comparison; {1 - len(kept) / sample.size:.0%} no finite number",
        compared=True,
    )
