"""What scenes save: operations and time beside the call point by point, NumPy's own products and lambdify, in one run.

    python tools/scene_speed.py [--points N] [--rounds R] [--write]

Times are the least of R interleaved rounds, ratios are of one run: shared machines are noisy. Operations are counted in
pairs of doubles or at points, as `Scene.explain` does; before: those of all steps at each point.
"""

import argparse
import datetime
import platform
import time
import warnings
from collections import Counter
from pathlib import Path

import numpy as np

from galileo_sym import Scene, _backend, chord, projectile
from galileo_sym.files import write_whole
from galileo_sym.scenes.c_source import source
from galileo_sym.typed_in import compiled_formula

PAGE = Path(__file__).resolve().parent.parent / "docs" / "scene_speed.md"
HEAD = """# Speed of scenes

Made by `python tools/scene_speed.py --write` on {date}, on a shared {machine} machine, with the {back_end} back end:
compare ratios. Grids are of {points} x {points} points, written into given arrays.
"""
FORCES = {
    "chord": {
        "free": {},
        "friction": {"mu": 0.36},
        "drag": {"gamma": 0.5},
        "friction_drag": {"mu": 0.36, "gamma": 0.5},
    },
    "projectile": {"free": {}, "drag": {"k": 0.2}},
}
OUTPUTS = {
    "chord": {"position": ("x", "y"), "distance": ("distance",), "speed": ("speed",)},
    "projectile": {"position": ("x", "y"), "velocity": ("vx", "vy")},
}
CONSTANTS = {"chord": {"g": 9.81}, "projectile": {"g": 9.81, "v": 30.0}}
MODULES = {"chord": chord, "projectile": projectile}


def interleaved(calls, rounds):
    """Return the least time of each call, in seconds; the rounds go through all of them in turn."""
    least = dict.fromkeys(calls, np.inf)
    for _ in range(rounds):
        for name, call in calls.items():
            start = time.perf_counter()
            call()
            least[name] = min(least[name], time.perf_counter() - start)
    return least


def axes(points, system):
    """Times and angles."""
    return {"t": np.linspace(0.01, 2.0, points), "theta": np.linspace(-1.2 if system == "chord" else 0.0, 1.2, points)}


def scene(system, force_set, outputs):
    """A scene over times and angles."""
    given = {**CONSTANTS[system], **FORCES[system][force_set]}
    return Scene(system, over=("t", "theta"), outputs=outputs, **given)


def pointwise(system, name, force_set, given, out):
    """A call of the public function at every point."""
    constants = {**CONSTANTS[system], **FORCES[system][force_set]}
    function = getattr(MODULES[system], name)
    return lambda: function(given["t"][:, None], given["theta"], **constants, out=out if len(out) > 1 else out[0])


def before_and_after(shown, points):
    """Operations a point: of all steps at each of them, and as the scene has them; transcendental ones, too."""
    plan = shown.separate_plan
    all_steps = sum((plan.step_counts(step) for step in plan.steps if step.axes), Counter())
    all_steps += sum((plan.result_counts(result) for result in plan.results), Counter())
    total = sum((Counter(counts) for counts in shown.cost(t=points, theta=points).values()), Counter())
    return [
        (count["transcendental"] / n, (count.total() - count["transcendental"]) / n)
        for count, n in ((all_steps, 1), (total, points**2))
    ]


def spindle(points, rounds):
    """Friction and drag, x and y: beside two outer products, the public call, and lambdify."""
    given = axes(points, "chord")
    out = np.empty((points, points)), np.empty((points, points))
    shown = scene("chord", "friction_drag", ("x", "y"))
    made, row, column = shown.compile(), given["t"], given["theta"]
    alone = shown.with_outputs("x")
    formula = compiled_formula("chord.position", "friction_drag")
    values = {"t": row[:, None], "theta": column, "g": 9.81, "mu": 0.36, "gamma": 0.5}

    def typed():
        with np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            formula(*values.values())

    times = interleaved(
        {
            "scene": lambda: shown(**given, out=out),
            "compiled scene": lambda: made(**given, out=out),
            "two np.multiply.outer": lambda: (np.multiply.outer(row, column), np.multiply.outer(row, column)),
            "two np.multiply.outer into arrays": lambda: [np.multiply.outer(row, column, out=array) for array in out],
            "one output": lambda: alone(**given, out=out[0]),
            "public function, point by point": pointwise("chord", "position", "friction_drag", given, out),
            "lambdify of the printed formula": typed,
        },
        rounds,
    )
    lines = ["", "## The spindle: friction and drag, x and y", "", "| | ms | times the scene |", "|---|---|---|"]
    lines += [f"| {name} | {1e3 * t:.3g} | {t / times['scene']:.3g} |" for name, t in times.items()]
    text = source(shown.separate_plan, "spindle")
    lines += ["", f"Emitted as C it has {len(text.splitlines())} lines.", "", "```"]
    return [*lines, *shown.explain(t=points, theta=points).splitlines(), "```"]


def galileo(points, rounds):
    """The descent time of many chords with drag alone: one number."""
    theta = np.linspace(-1.5, 1.5, points**2)
    shown = Scene("chord", over="theta", outputs="descent_time", g=9.81, gamma=0.5, diameter=1.0)
    times = interleaved(
        {
            "scene": lambda: shown(theta=theta),
            "public": lambda: chord.descent_time(theta, g=9.81, gamma=0.5, diameter=1.0),
        },
        rounds,
    )
    return [
        "",
        f"Descent time of {points**2} chords with drag alone: folded once, {len(shown.plan.steps)} steps in a call;"
        f" {times['public'] / times['scene']:.3g} times as fast as the public function.",
    ]


def table(points, rounds):
    """All sets of forces and common sets of outputs."""
    lines = ["", "## Forces and outputs", "", "Operations a point: transcendental + others.", ""]
    lines += [
        "| system | forces | outputs | before | after | ms before | ms after | compiled |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for system, sets in FORCES.items():
        given = axes(points, system)
        for force_set in sets:
            for name, outputs in OUTPUTS[system].items():
                shown = scene(system, force_set, outputs)
                out = tuple(np.empty((points, points)) for _ in outputs)
                made = shown.compile()
                calls = {
                    "before": pointwise(system, name, force_set, given, out),
                    "after": lambda s=shown, g=given, o=out: s(**g, out=o),
                    "compiled": lambda s=made, g=given, o=out: s(**g, out=o),
                }
                times = interleaved(calls, rounds)
                (t0, n0), (t1, n1) = before_and_after(shown, points)
                counts = f"{t0:.3g} + {n0:.3g} | {t1:.3g} + {n1:.3g}"
                ms = " | ".join(f"{1e3 * times[call]:.3g}" for call in ("before", "after", "compiled"))
                lines.append(f"| {system} | {force_set} | {', '.join(outputs)} | {counts} | {ms} |")
    return lines


def main():
    """Measure, print, and write the page where that is asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=1000, metavar="N", help="along each axis")
    parser.add_argument("--rounds", type=int, default=9, metavar="R", help="interleaved rounds")
    parser.add_argument("--write", action="store_true", help="renew docs/scene_speed.md")
    options = parser.parse_args()
    head = HEAD.format(
        date=datetime.date.today().isoformat(),
        machine=platform.machine(),
        back_end=_backend.NAME,
        points=options.points,
    )
    lines = [head.rstrip("\n")]
    for part in (spindle, galileo, table):
        lines += part(options.points, options.rounds)
    text = "\n".join(lines) + "\n"
    print(text, end="")
    if options.write:
        write_whole(PAGE, text.encode())


if __name__ == "__main__":
    main()
