"""`galileo-sym verify`: sample, measure, hold against the certificates, renew those on request."""

import datetime
import os
import sys
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from itertools import islice
from multiprocessing import get_context

from galileo_sym.libraries import CompilationError

from . import certificate, report
from .back_ends import NumpyFunctions, available_back_ends, generated_folder
from .judge import compare, judge
from .measure import Task, VacuousStratumError, take_sample
from .renewal import RefusedUpdateError, renew, require_sound_update
from .selection import UnknownNameError, select_functions, select_strata

DEFAULT_POINTS = 512
DEFAULT_SEED = 2014
_PROCESSES = 2
_AHEAD = 3  # samples a process that are drawn or wait to be judged
_WORTH_A_PROCESS = 4000  # points; below that a second process takes longer to start than it saves


def samples(tasks, processes):
    """Samples of all tasks as (position, sample), in any order; references in several processes if it pays.

    Parameters
    ----------
    tasks : sequence of Task
    processes : int
    """
    if processes == 1 or sum(task.points for task in tasks) < _WORTH_A_PROCESS:
        for position, task in enumerate(tasks):
            yield position, take_sample(task)
        return
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
        waiting, running = iter(enumerate(tasks)), {}
        try:
            while True:
                # no more than this at a time, so that samples cannot pile up
                for position, task in islice(waiting, _AHEAD * processes - len(running)):
                    running[pool.submit(take_sample, task)] = position
                if not running:
                    break
                for done in wait(running, return_when=FIRST_COMPLETED).done:
                    yield running.pop(done), done.result()
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _chosen_back_ends(given, notes, problems):
    if given is not None:
        return given
    try:
        return available_back_ends(notes.append)
    except CompilationError as cause:
        problems.append(str(cause))
        return [NumpyFunctions()]


def run(
    names=(),
    points=DEFAULT_POINTS,
    seed=DEFAULT_SEED,
    update=False,
    json_output=False,
    strata=(),
    *,
    progress=None,
    back_ends=None,
    contenders=(),
    certificates=None,
    processes=None,
    out=None,
    err=None,
    date=None,
):
    """Measure the errors of the public functions and hold them against the certificates.

    Parameters
    ----------
    names : sequence of str
        Functions by full name, or papers; all if empty.
    points : int
        Points a stratum (strata that are lists have their own number).
    seed : int
        Of the draw; the same seed gives the same points everywhere.
    update : bool
        Renew the certificates of the functions that hold. A recorded worst input that is still worse stays recorded.
        Refused if a certificate would be left with holes, or a record replaced by one of fewer points.
    json_output : bool
        Print one JSON object instead of the table.
    strata : sequence of str
        Strata to measure; all if empty.
    progress : callable, optional
        Called with (strata done, strata in all, what was done last).
    back_ends : list, optional
        Objects with `name` and `evaluate`; by default NumPy and, if there is a compiler, C.
    contenders : sequence, optional
        Objects like the back ends, measured at the same points for comparison, not judged; `serves(function)` says
        whether one has the function of that full name.
    certificates : Path, optional
        Folder of the certificates; that of the emitted code by default.
    processes : int, optional
        For the references; by default 2, or 1 on a single core. With more than one, a calling script needs the usual
        ``if __name__ == "__main__"`` guard.
    out, err : text files, optional
        Standard output and standard error by default.
    date : str, optional
        Day to write into renewed certificates; today by default.

    Returns
    -------
    int
        0 if all held; 1 if an error exceeds its bound, a recorded worst input errs more than recorded, back ends
        differ in bits that must not, the C does not compile or load, or a certificate is missing or does not fit; 2 on
        unknown names, a number of points below 1, or an update that is refused.
    """
    out = sys.stdout if out is None else out
    err = sys.stderr if err is None else err
    try:
        functions = select_functions(names)
        chosen = select_strata(functions, strata)
    except UnknownNameError as cause:
        print(f"galileo-sym verify: {cause}", file=err)
        return 2
    if points < 1:
        print(f"galileo-sym verify: --points must be at least 1, got {points}", file=err)
        return 2
    folder = generated_folder() / "certificates" if certificates is None else certificates
    notes, problems, records = [], [], {}
    for name in functions:
        found, faults = certificate.read(folder, name)
        records.update({(name, *place): record for place, record in found.items()})
        (notes if update else problems).extend(faults)
    try:
        if update:
            require_sound_update(chosen, records, points, DEFAULT_POINTS)
    except RefusedUpdateError as cause:
        print(f"galileo-sym verify: {cause}", file=err)
        return 2
    back_ends = _chosen_back_ends(back_ends, notes, problems)
    problems.extend(f"certificate {name} belongs to no function; delete it" for name in certificate.stale(folder))
    if not json_output:
        print("\n".join(notes), file=out, end="\n" if notes else "")

    tasks = [Task(*place, points, seed, records[place]["worst"] if place in records else None) for place in chosen]
    outcomes = {}
    processes = processes or min(_PROCESSES, os.cpu_count() or 1)
    try:
        for done, (position, sample) in enumerate(samples(tasks, processes), 1):
            place = chosen[position]
            # an update accepts a recorded input that errs more than before, up to the bound
            found, worst = judge(sample, back_ends, None if update else records.get(place))
            beside = [compare(sample, one) for one in contenders if one.serves(place[0])]
            outcomes[place] = found + beside, worst
            if progress is not None:
                progress(done, len(tasks), f"{place[0]} [{place[1]}] {place[2]}")
    except VacuousStratumError as cause:
        problems.append(str(cause))
    outcomes = {place: outcomes[place] for place in chosen if place in outcomes}
    rows = [row for found, _ in outcomes.values() for row in found]
    date = datetime.date.today().isoformat() if date is None else date
    updated = [] if problems or not update else renew(folder, outcomes, records, back_ends, seed, date)
    held = not problems and not any(row.failed for row in rows)
    if json_output:
        print(report.as_json(rows, problems, notes, seed, held), file=out)
    else:
        print(report.table(rows), file=out)
        print(report.summary(rows, problems, updated), file=out)
    return 0 if held else 1
