"""Certificate of scenes: errors against certain references, for all forces and sets of outputs, by NumPy and by C."""

from __future__ import annotations

import datetime
import json
import sys
import warnings
from itertools import combinations
from pathlib import Path

import numpy as np

from galileo_sym.files import write_whole
from galileo_sym.generated._graphs import SYSTEMS
from galileo_sym.scene_strata import ENDING, ENDS, SIDE, STRATA, draw_scene, exact, exact_ended, strata
from galileo_sym.scenes import Scene
from galileo_sym.scenes.compiled import Compiled
from galileo_sym.scenes.results import force_set
from galileo_sym.verify.back_ends import generated_folder
from galileo_sym.verify.measure import as_hex, from_hex
from galileo_sym.verify.ulp import rounded_up, ulp_error

BOUND = 2.0  # ulp: one more than the public functions; of the larger term where there are two, as there
SEED = 2014
POINTS = 128
_TITLE = (
    "scenes over t and theta, all outputs at once; other sets of outputs have the same bits;"
    " arrived, before 0, at rest: of motions that end, speeds at times that differ from the end's by more than 2**-50"
)
REMEDY = "run `galileo-sym verify scenes --update` and review what changes"


def variants():
    """Return system and force arguments of all sets of forces."""
    return [
        (system, forces)
        for system, row in SYSTEMS.items()
        for size in range(len(row["forces"]) + 1)
        for forces in combinations(row["forces"].values(), size)
    ]


def _back_ends(scene):
    """NumPy, and C where there is a compiler."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        made = scene.compile()
    return {"numpy": scene, **({"c": made} if isinstance(made, Compiled) else {})}


def measure(system, forces, stratum, points, seed, recorded=None):
    """Return the largest error of a sample: a dictionary as certificates hold it.

    Parameters
    ----------
    system, forces, stratum
        As for `draw_scene`.
    points : int
        How many points of the grid are held against references.
    seed : int
    recorded : dict, optional
        A point with all constants that is tried, too.
    """
    place = [*map(ord, f"{system} {forces} {stratum}")]
    draw = np.random.default_rng([seed, *place])
    constants, axes = draw_scene(system, forces, stratum, draw)
    worst = {"measured": 0.0, "output": None, "worst": {}}
    cells = draw.choice(SIDE * SIDE, min(points, SIDE * SIDE), replace=False)
    ends = STRATA[stratum].ends
    served = _worst_of(system, ends, constants, axes, [divmod(int(cell), SIDE) for cell in cells], worst)
    if recorded:
        fixed = {name: value for name, value in recorded.items() if name not in axes}
        _worst_of(system, ends, fixed, {name: np.array([recorded[name]]) for name in axes}, [(0, 0)], worst)
    worst["measured"] = rounded_up(worst["measured"])
    return {"bound": BOUND, **worst, "points": len(cells), "back_ends": served}


def _scene(system, ends, constants):
    """All outputs of a motion that goes on, or those that end."""
    outputs = ENDING[system] if ends else tuple(SYSTEMS[system]["outputs"])
    return Scene(system, over=("t", "theta"), outputs=outputs, until=ENDS[system] if ends else "forever", **constants)


def _worst_of(system, ends, constants, axes, cells, worst):
    """Enter the largest error at some points of a grid, of a motion that ends or not; returns the back ends' names."""
    scene, enclosed = _scene(system, ends, constants), exact_ended if ends else exact
    outputs = scene.outputs
    back_ends = _back_ends(scene)
    with np.errstate(all="ignore"):
        found = [one(**axes) for one in back_ends.values()]
    for i, j in cells:
        point = {**constants, "t": float(axes["t"][i]), "theta": float(axes["theta"][j])}
        for k, output in enumerate(outputs):
            enclosure = enclosed(system, output, point)
            if enclosure is None:
                continue
            error = max(ulp_error(values[k][i, j], enclosure) for values in found)
            if error >= worst["measured"]:
                worst.update(measured=error, output=output, worst=point)
    return list(back_ends)


def subsets_that_differ(system, forces, ends, seed):
    """Return how many sets of outputs there are, and those with other bits than all outputs at once have."""
    constants, axes = draw_scene(system, forces, "arrived" if ends else "typical", np.random.default_rng(seed))
    axes = {name: values[::5] for name, values in axes.items()}
    scene = _scene(system, ends, constants)
    outputs = scene.outputs
    whole = dict(zip(outputs, scene(**axes), strict=True))
    chosen = [names for size in range(1, len(outputs)) for names in combinations(outputs, size)]
    differing = [
        names
        for names in chosen
        if not all(map(np.array_equal, scene.with_outputs(names)(**axes), (whole[name] for name in names)))
    ]
    return len(chosen) + 1, differing


def path():
    """Return where the certificate is kept."""
    return Path(generated_folder()) / "certificates" / "scenes.json"


def _recorded():
    """What the committed certificate holds, by place; nothing if there is none or it cannot be read."""
    try:
        rows = json.loads(path().read_text(encoding="utf-8"))["rows"]
        return {
            (row["system"], row["forces"], row["stratum"]): {**row, "worst": from_hex(row["worst"])} for row in rows
        }
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return {}


def verify(points=POINTS, seed=SEED, update=False, date=None):
    """Measure all sets of forces, and hold them against the bound and the certificate.

    Parameters
    ----------
    points : int
        Points of each set of forces and stratum.
    seed : int
    update : bool
        Renew the certificate if all held.
    date : str, optional
        Day to write into it; today by default.

    Returns
    -------
    rows : list of dict
    problems : list of str
        Empty if all held.
    """
    known, rows, problems = _recorded(), [], []
    for system, forces in variants():
        name = force_set(system, forces)
        counts = {}
        for ends in (False, True):
            counts[ends], differing = subsets_that_differ(system, forces, ends, seed)
            problems += [f"{system} {name}: {', '.join(names)} alone have other bits" for names in differing]
        for stratum in strata(forces):
            record = known.get((system, name, stratum))
            if record is None and not update:
                problems.append(f"{system} {name} {stratum}: not in the certificate; {REMEDY}")
            row = measure(system, forces, stratum, points, seed, record and record["worst"])
            rows.append(
                {"system": system, "forces": name, "stratum": stratum, "subsets": counts[STRATA[stratum].ends], **row}
            )
            if row["measured"] > BOUND:
                problems.append(f"{system} {name} {stratum}: {row['output']} errs by {row['measured']} ulp")
    rows = [{**row, "worst": as_hex(row["worst"])} for row in rows]
    if update and not problems:
        date = date or datetime.date.today().isoformat()
        content = {"what": _TITLE, "date": date, "seed": seed, "rows": rows}
        write_whole(path(), (json.dumps(content, indent=2) + "\n").encode())
    return rows, problems


def tell(rows, problems, file=None):
    """Print the rows and problems, and whether all held."""
    file = file or sys.stdout
    for row in rows:
        place = f"scenes  {row['system']:<10}  {row['forces']:<13}  {row['stratum']:<8}"
        print(f"{place}  {row['points']} points  {row['subsets']} sets of outputs  ≥ {row['measured']:.3g}"
              f" ({row['output']})  {row['bound']:g}  {' '.join(row['back_ends'])}", file=file)  # fmt: skip
    for problem in problems:
        print(f"problem: {problem}", file=file)
    print(f"scenes: {f'{len(problems)} problems' if problems else 'all held'}", file=file)
