"""Certificate of scenes: errors against certain references, for all forces and sets of outputs, by NumPy and by C."""

from __future__ import annotations

import datetime
import json
import sys
import warnings
from itertools import combinations
from pathlib import Path

import numpy as np

from galileo_sym import projectile
from galileo_sym.files import write_whole
from galileo_sym.generated._graphs import SYSTEMS
from galileo_sym.scenes import Scene
from galileo_sym.scenes.compiled import Compiled
from galileo_sym.scenes.results import force_set
from galileo_sym.verify.back_ends import generated_folder
from galileo_sym.verify.measure import as_hex, from_hex
from galileo_sym.verify.reference import reference
from galileo_sym.verify.ulp import rounded_up, ulp_error

BOUND = 2.0  # ulp: one more than the public functions; of the larger term where there are two, as there
SEED = 2014
POINTS = 128
_SIDE = 16  # values of each axis
_HALF_PI = np.pi / 2
_TITLE = "scenes over t and theta, all outputs at once; other sets of outputs have the same bits"
REMEDY = "run `galileo-sym verify scenes --update` and review what changes"


def _typical(draw, name):
    ranges = {"t": (-3.0, 1.5), "g": (0.0, 2.0), "v": (0.0, 3.0), "diameter": (-1.0, 2.0)}
    return 10.0 ** draw.uniform(*ranges.get(name, (-2.0, 0.5)))


def _extreme(draw, name):
    return 2.0 ** draw.uniform(-300.0, 300.0)


def _angles(draw, system, most):
    """Angles up to the one from which a bead rests, some of them next to it, next to 0 or next to a right angle."""
    beside = np.nextafter(most, 0.0) - np.arange(5) * 2.0**-52
    away = most * (1.0 - 2.0 ** draw.uniform(-47.0, -4.0, 4))
    tiny = 2.0 ** draw.uniform(-900.0, -8.0, 3)
    plain = most * draw.uniform(0.0, 1.0, _SIDE - 12)
    found = np.concatenate([beside[:5], away, tiny, plain])
    return found * draw.choice([-1.0, 1.0], found.size) if system == "chord" else found


def draw_scene(system, forces, stratum, draw):
    """Return constants and axes of a scene.

    Parameters
    ----------
    system : str
    forces : tuple of str
        Arguments of the forces that act.
    stratum : str
        A key of ``STRATA``.
    draw : numpy.random.Generator
    """
    one = STRATA[stratum]
    needed = {name for row in SYSTEMS[system]["outputs"].values() for name in row["arguments"]} - {"t", "theta"}
    constants = {name: float(one(draw, name)) for name in sorted({*needed, *forces})}
    if "mu" in constants:
        constants["mu"] = float(_typical(draw, "mu"))
    most = float(np.arctan2(1.0, constants["mu"])) if "mu" in constants else _HALF_PI
    theta = _angles(draw, system, most)
    t = np.array([one(draw, "t") for _ in range(_SIDE)])
    if system == "projectile":  # half of them at landing, where heights cancel
        given = {name: constants[name] for name in ("v", "g", *forces)}
        with np.errstate(all="ignore"):
            landing = projectile.flight_time(theta, **given)
        t = np.where(np.isfinite(landing) & (np.arange(_SIDE) % 2 == 0), landing, t)
    return constants, {"t": t, "theta": theta}


STRATA = {"typical": _typical, "extreme": _extreme}


def variants():
    """Return system and force arguments of all sets of forces."""
    return [
        (system, forces)
        for system, row in SYSTEMS.items()
        for size in range(len(row["forces"]) + 1)
        for forces in combinations(row["forces"].values(), size)
    ]


def exact(system, output, point):
    """Return a certain enclosure of an output at a point, given with all constants."""
    row = SYSTEMS[system]["outputs"][output]
    names = (*row["arguments"], *SYSTEMS[system]["forces"].values())
    return reference(row["function"], {name: float(point.get(name, 0.0)) for name in names})[row["index"]]


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
    cells = draw.choice(_SIDE * _SIDE, min(points, _SIDE * _SIDE), replace=False)
    served = _worst_of(system, constants, axes, [divmod(int(cell), _SIDE) for cell in cells], worst)
    if recorded:
        fixed = {name: value for name, value in recorded.items() if name not in axes}
        _worst_of(system, fixed, {name: np.array([recorded[name]]) for name in axes}, [(0, 0)], worst)
    worst["measured"] = rounded_up(worst["measured"])
    return {"bound": BOUND, **worst, "points": len(cells), "back_ends": served}


def _worst_of(system, constants, axes, cells, worst):
    """Enter the largest error at some points of a grid; returns the names of the back ends."""
    outputs = tuple(SYSTEMS[system]["outputs"])
    scene = Scene(system, over=("t", "theta"), outputs=outputs, until="forever", **constants)
    back_ends = _back_ends(scene)
    with np.errstate(all="ignore"):
        found = [one(**axes) for one in back_ends.values()]
    for i, j in cells:
        point = {**constants, "t": float(axes["t"][i]), "theta": float(axes["theta"][j])}
        for k, output in enumerate(outputs):
            enclosure = exact(system, output, point)
            error = max(ulp_error(values[k][i, j], enclosure) for values in found)
            if error >= worst["measured"]:
                worst.update(measured=error, output=output, worst=point)
    return list(back_ends)


def subsets_that_differ(system, forces, seed):
    """Return how many sets of outputs there are, and those with other bits than all outputs at once have."""
    constants, axes = draw_scene(system, forces, "typical", np.random.default_rng(seed))
    axes = {name: values[::5] for name, values in axes.items()}
    outputs = tuple(SYSTEMS[system]["outputs"])
    scene = Scene(system, over=("t", "theta"), outputs=outputs, until="forever", **constants)
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
        count, differing = subsets_that_differ(system, forces, seed)
        problems += [f"{system} {name}: {', '.join(names)} alone have other bits" for names in differing]
        for stratum in STRATA:
            record = known.get((system, name, stratum))
            if record is None and not update:
                problems.append(f"{system} {name} {stratum}: not in the certificate; {REMEDY}")
            row = measure(system, forces, stratum, points, seed, record and record["worst"])
            rows.append({"system": system, "forces": name, "stratum": stratum, "subsets": count, **row})
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
