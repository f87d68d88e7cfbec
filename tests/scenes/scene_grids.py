"""Systems, forces and axes that the tests of scenes share."""

from itertools import combinations

import numpy as np

from galileo_sym import Scene

CONSTANTS = {"chord": {"g": 9.81, "diameter": 1.7}, "projectile": {"g": 9.81, "v": 31.7}}
FORCES = {
    "chord": {
        "free": {},
        "friction": {"mu": 0.36},
        "drag": {"gamma": 0.7},
        "friction_drag": {"mu": 0.36, "gamma": 0.7},
    },
    "projectile": {"free": {}, "drag": {"k": 0.3}},
}
OUTPUTS = {
    "chord": ("x", "y", "distance", "speed", "descent_time", "X", "Y", "R"),
    "projectile": ("x", "y", "vx", "vy", "flight_time", "range"),
}
TIMES = np.array([0.0, 2.0**-1074, 1e-160, 3e-9, 0.1, 0.57, 1.3, 3.1, 44.0, 1e154, 1e250])
ANGLES = {
    "chord": np.array([-np.pi / 2, -1.2, -0.3, -1e-200, 0.0, 1e-9, 0.7, 1.2, 1.2247, 1.5, np.pi / 2]),
    "projectile": np.array([0.0, 1e-300, 1e-9, 0.1, 0.3, 0.785, 1.1, 1.5, 1.57, np.pi / 2]),
}
CASES = [(system, force_set) for system, sets in FORCES.items() for force_set in sets]


def scene(system, force_set, outputs, over=("t", "theta"), until="forever", **more):
    """A scene of constants above, those given and of a set of forces."""
    constants = {**CONSTANTS[system], **FORCES[system][force_set], **more}
    return Scene(
        system, over=over, outputs=outputs, until=until, **{k: v for k, v in constants.items() if k not in over}
    )


def axes(system):
    """Times and angles."""
    return {"t": TIMES, "theta": ANGLES[system]}


def subsets(system):
    """Sets of one, of two, and of all outputs but one: what two share shows in pairs."""
    names = OUTPUTS[system]
    return [chosen for size in (1, 2, len(names) - 1) for chosen in combinations(names, size)]
