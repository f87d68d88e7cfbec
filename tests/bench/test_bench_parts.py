"""Parts of the benchmark: the table of cases, rounds and ratios, what a target says."""

import math
from itertools import pairwise

import numpy as np
import pytest

from galileo_sym import special
from galileo_sym.bench import growth, parallel, plot, targets
from galileo_sym.bench.accuracy import TooFewPoints, judge, take
from galileo_sym.bench.cases import SPECIAL, TINY_DRAG, TYPICAL, cases
from galileo_sym.bench.core import ARRAYS, Row, with_scalars
from galileo_sym.bench.report import number
from galileo_sym.bench.small import Import, importing
from galileo_sym.bench.timing import Job, Spread, against, interleaved, rotated, spread
from galileo_sym.catalogue import FUNCTIONS


def test_every_public_function_with_every_set_of_forces_is_a_case():
    found = {(case.full_name, case.force_set) for case in cases().values() if case.stratum == TYPICAL}
    public = {(name, force_set) for name, row in FUNCTIONS.items() for force_set in row.variants}
    assert found == public | {(f"{SPECIAL}.{name}", "") for name in special.__all__}
    tiny = {(case.full_name, case.force_set) for case in cases().values() if case.stratum == TINY_DRAG}
    assert tiny == {(name, f) for name, row in FUNCTIONS.items() for f in row.variants if "drag" in f}


@pytest.mark.parametrize("names", [targets.ALL, targets.THAN_BOOST, plot.PANELS, parallel.CASES, growth.CASES])
def test_what_is_named_is_a_case(names):
    assert set(names) <= set(cases())


def test_numbers_for_arrays_leave_every_point_a_result():
    for case in cases().values():
        if not case.positional or case.paper == SPECIAL:
            continue
        arguments = with_scalars(case, case.points(50))
        assert all(isinstance(arguments[name], float) for name in (*case.keywords, *case.forces))
        for at in range(50):
            point = {name: float(np.broadcast_to(x, 50)[at]) for name, x in arguments.items()}
            assert all(result.ball.is_finite() for result in case.exact(point)) or case.paper == "lambert"


def test_an_error_is_found_in_the_unit_of_the_format():
    case = cases()["projectile.flight_time drag"]
    for single, ulp in ((False, 2.0**-52), (True, 2.0**-23)):
        sample = take(case, 40, single)
        dtype = np.float32 if single else np.float64
        right = sample.exact[0].value.astype(dtype)
        assert judge((right,), sample).ulp <= 0.5
        wrong = (right * dtype(1 + 4 * ulp)).astype(dtype)
        assert 3.5 <= judge((wrong,), sample).ulp <= 8.6
        wrong[:10] = np.nan
        assert judge((wrong,), sample).lost == 0.25


def test_too_few_points_are_told(monkeypatch):
    case = cases()["projectile.flight_time drag"]
    monkeypatch.setattr(type(case), "outside", lambda self, point: True)
    with pytest.raises(TooFewPoints, match="only 0 of 5"):
        take(case, 5)


def test_every_job_is_called_in_every_round_and_the_order_turns():
    called = []
    groups = {place: {name: Job(lambda key=(place, name): called.append(key), 1) for name in "ab"} for place in (1, 2)}
    ends = []
    found = interleaved(groups, 3, lambda done, every, label: ends.append(len(called)))
    assert all(len(values) == 3 for jobs in found.values() for values in jobs.values())
    rounds = [list(dict.fromkeys(called[begin:end])) for begin, end in pairwise(ends)]
    assert rounds == [
        [(2, "b"), (2, "a"), (1, "b"), (1, "a")],
        [(1, "a"), (1, "b"), (2, "a"), (2, "b")],
    ]
    assert rotated([1, 2, 3], 4) == [2, 3, 1]


def test_ratios_are_those_of_each_round():
    found = against({"base": [1.0, 2.0, 4.0], "twice": [2.0, 4.0, 8.0]}, "base")
    assert found["twice"].ns == Spread(4.0, 3.0, 6.0)
    assert found["twice"].ratio == Spread(2.0, 2.0, 2.0)
    assert found["base"].ratio == Spread(1.0, 1.0, 1.0)


def _row(case, contestant, ratio, ulp=0.5):
    return Row(case, contestant, ARRAYS, 10, spread([ratio]), spread([ratio]), ulp, 0.0)


def test_targets_are_held_not_held_or_not_measured():
    case = "chord.distance drag"
    times = {"numpy.exp": 1.0, "C": 10.0, "lambdify": 249.0, "C, float32": 5.0, "NumPy": 151.0}
    found = targets.of_rows([_row(case, name, ratio) for name, ratio in times.items()])
    held = {one.text.removeprefix(f"{case}: "): one.held for one in found}
    assert held == {
        "time": True,
        "faster than lambdify": False,
        "faster than C with Boost's W": None,
        "float32 gains": True,
        "NumPy back end loses": False,
        "every case: error": True,
    }
    wrong = targets.of_rows([_row(case, "numpy.exp", 1.0), _row(case, "C", 10.1, 1.1)])
    assert [one.held for one in wrong if one.text.endswith((": time", ": error"))] == [False, False]


def test_threads_calls_and_imports_are_held_against_their_limits():
    def of(gain, ns, ms, loaded):
        scalings = [parallel.Scaling("case", "C", "threads", 10, spread([gain]), True)]
        found = targets.of_rest(scalings, {"call": spread([ns])}, Import(spread([ms]), loaded))
        return [one.held for one in found]

    assert of(1.8, 2000.0, 20.0, []) == [True] * 4
    assert of(1.79, 2001.0, 20.1, ["sympy"]) == [False] * 4


def test_importing_loads_nothing_heavy_and_a_failure_is_told(monkeypatch):
    assert importing(1).loaded == []
    monkeypatch.setattr("galileo_sym.bench.small._IMPORT", "import no_such_package_{heavy[0]}")
    with pytest.raises(RuntimeError, match="no_such_package"):
        importing(1)


@pytest.mark.parametrize(
    ("value", "text"),
    [(math.nan, "-"), (0.0, "0"), (0.4996, "0.500"), (12.345, "12.3"), (12345.6, "12346"), (3e-5, "3.0e-05")],
)
def test_numbers_are_written_with_three_digits(value, text):
    assert number(value) == text
