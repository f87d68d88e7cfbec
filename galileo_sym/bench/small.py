"""What counts for single calls: the latency of the public functions with numbers, and what importing them costs."""

import json
import subprocess
import sys
from typing import NamedTuple

import numpy as np

from .contestants import public_call
from .timing import Job, interleaved, spread

HEAVY = ("sympy", "mpmath", "scipy", "flint")
_IMPORT = """
import json, sys, time
import numpy
begin = time.perf_counter()
import galileo_sym.chord, galileo_sym.projectile
spent = time.perf_counter() - begin
print(json.dumps([spent, [name for name in {heavy} if name in sys.modules]]))
"""


class Import(NamedTuple):
    """Milliseconds beyond importing NumPy, and what else was loaded of what is slow to load."""

    ms: tuple
    loaded: list


def latency(cases, rounds):
    """Nanoseconds of a call of a public function with Python numbers.

    Parameters
    ----------
    cases : list of Case
    rounds : int

    Returns
    -------
    dict of str to Spread
        By key of the case.
    """
    jobs = {}
    for case in cases:
        point = {name: float(x[0]) for name, x in case.points(1).items()}
        jobs[case.key] = {"": Job(public_call(case, point), 1)}
    with np.errstate(all="ignore"):
        samples = interleaved(jobs, rounds)
    return {key: spread(found[""]) for key, found in samples.items()}


def importing(rounds):
    """What `import galileo_sym.chord, galileo_sym.projectile` costs in a fresh process that has NumPy.

    Raises
    ------
    RuntimeError
        If the process fails.
    """
    spent, loaded = [], set()
    for _ in range(rounds):
        command = [sys.executable, "-c", _IMPORT.format(heavy=HEAVY)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"importing the numeric modules fails: {done.stderr.splitlines()[-1:]}")
        seconds, names = json.loads(done.stdout)
        spent.append(1e3 * seconds)
        loaded |= set(names)
    return Import(spread(spent), sorted(loaded))
