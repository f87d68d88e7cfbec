"""What the speed is held against: each target with what was measured, held or not; without a measurement, why."""

import math
from typing import NamedTuple

from .core import ARRAYS, BASE, SCALARS

OURS, SINGLE, NUMPY = "C", "C, float32", "NumPy"
LAMBDIFY, BOOST = "lambdify", "C, Boost's W"

# Times numpy.exp on as many doubles, at most.
PUBLIC = {
    "chord.descent_time drag": 6.0,
    "chord.descent_time drag tiny-drag": 6.0,
    "chord.descent_time friction_drag": 12.0,
    "chord.descent_time friction_drag tiny-drag": 12.0,
    "chord.distance drag": 10.0,
    "projectile.flight_time drag": 10.0,
    "projectile.horizontal_range drag": 15.0,
    "projectile.best_angle": 12.0,
    "lambert.w0": 8.0,
}
_TWO_FORMS = ("w0", "wm1", "w0_offset", "wm1_offset")
_ONE_VARIABLE = (
    *("phi1m", "phi2m", "descent_factor", "flight_factor", "range_factor", "best_sine", "best_angle"),
    *("max_range_factor", "exp_minus", "sin", "cos", "arctan"),
)
ALL = {
    **PUBLIC,
    "lambert.wm1": 8.0,
    **{f"special.{name}": 3.0 for name in _ONE_VARIABLE},
    **{f"special.{name}": 8.0 for name in _TWO_FORMS},
}
THAN_LAMBDIFY = 25.0
THAN_BOOST = dict.fromkeys(PUBLIC, 3.0) | {"lambert.w0": 2.0}
MOST_ULP = 1.0
SINGLE_GAIN = 1.7
THREADS_GAIN = 1.8
NUMPY_LOSS = 15.0
CALL_NS = 2000.0
IMPORT_MS = 20.0


class Target(NamedTuple):
    """A target.

    Attributes
    ----------
    text : str
    limit, measured : float
        NaN where it was not measured.
    unit : str
    held : bool or None
        None where it was not measured.
    """

    text: str
    limit: float
    measured: float
    unit: str
    held: object


def _at_most(text, limit, measured, unit):
    return Target(text, limit, measured, unit, None if math.isnan(measured) else measured <= limit)


def _at_least(text, limit, measured, unit):
    return Target(text, limit, measured, unit, None if math.isnan(measured) else measured >= limit)


class _Table:
    """Rows by case, contestant and layout."""

    def __init__(self, rows):
        self._rows = {(row.case, row.contestant, row.layout): row for row in rows}

    def ratio(self, case, contestant, layout=ARRAYS):
        row = self._rows.get((case, contestant, layout))
        return row.ratio.median if row else math.nan

    def ulp(self, case, contestant):
        row = self._rows.get((case, contestant, ARRAYS))
        return row.ulp if row else math.nan

    def times(self, case, slow, fast):
        """How many times as long one contestant takes as another."""
        return self.ratio(case, slow) / self.ratio(case, fast)

    def cases(self, contestant):
        return [case for case, name, layout in self._rows if name == contestant and layout == ARRAYS]


def of_rows(rows):
    """Targets of speed, gain and error, for the cases that were measured.

    Parameters
    ----------
    rows : list of Row

    Returns
    -------
    list of Target
    """
    table = _Table(rows)
    here = [case for case in ALL if case in table.cases(BASE)]
    found = [_at_most(f"{case}: time", ALL[case], table.ratio(case, OURS), "× exp") for case in here]
    for case in (case for case in PUBLIC if case in here):
        gain = table.times(case, LAMBDIFY, OURS)
        found.append(_at_least(f"{case}: faster than lambdify", THAN_LAMBDIFY, gain, "times"))
        gain = table.times(case, BOOST, OURS)
        found.append(_at_least(f"{case}: faster than C with Boost's W", THAN_BOOST[case], gain, "times"))
        found.append(_at_least(f"{case}: float32 gains", SINGLE_GAIN, table.times(case, OURS, SINGLE), "times"))
    for case in here:
        found.append(_at_most(f"{case}: NumPy back end loses", NUMPY_LOSS, table.times(case, NUMPY, OURS), "times"))
    wrong = [table.ulp(case, OURS) for case in table.cases(OURS)]
    found.append(_at_most("every case: error", MOST_ULP, max(wrong, default=math.nan), "ulp"))
    return found


def of_rest(scalings, latencies, imported):
    """Targets of threads, single calls and import.

    Parameters
    ----------
    scalings : list of Scaling
    latencies : dict of str to Spread
    imported : Import

    Returns
    -------
    list of Target
    """
    found = [
        _at_least(f"{one.case}: two threads, {one.way}", THREADS_GAIN, one.gain.median, "times")
        for one in scalings
        if one.way == "threads"
    ]
    slowest = max(((spread.median, key) for key, spread in latencies.items()), default=(math.nan, "none"))
    found.append(_at_most(f"slowest call with numbers ({slowest[1]})", CALL_NS, slowest[0], "ns"))
    found.append(_at_most("import beyond NumPy", IMPORT_MS, imported.ms.median, "ms"))
    heavy = ", ".join(imported.loaded) or "none"
    found.append(_at_most(f"heavy packages imported ({heavy})", 0.0, float(len(imported.loaded)), ""))
    return found


def with_numbers(rows):
    """Ratios to numpy.exp by case where the arguments after the positional ones are numbers."""
    table = _Table(rows)
    pairs = ((case, table.ratio(case, OURS, SCALARS)) for case in table.cases(OURS))
    return {case: ratio for case, ratio in pairs if not math.isnan(ratio)}
