"""The public functions that are verified: arguments, outputs and force sets, as one table."""

import math
from dataclasses import dataclass, field

CHORD_FORCES = {"free": (), "friction": ("mu",), "drag": ("gamma",), "friction_drag": ("mu", "gamma")}
PROJECTILE_FORCES = {"free": (), "drag": ("k",)}
ONE_LAW = {"all": ()}  # functions that have a single kernel, whose C name carries no suffix

CLAIMED_BOUND = 1.0

_POSITIVE = ("diameter", "g", "v")
_RIGHT_ANGLE = math.pi / 2
_ABOVE_BRANCH_POINT = -float.fromhex("0x1.78b56362cef37p-2")  # the least double above -1/e
_ANY = (-math.inf, math.inf)


@dataclass(frozen=True)
class Function:
    """What verification has to know of a public function.

    Attributes
    ----------
    paper, name : str
        The public module and the function in it.
    positional, keywords : tuple of str
        Arguments in the order of both languages; the force arguments follow them.
    force_sets : dict of str to tuple of str
        Each kernel's name and the force arguments it takes.
    outputs : tuple of str
        Names of the results, in order.
    bound : float
        The error it claims not to exceed, in ulp.
    unit : dict of str to str
        The unit of the error of an output that is not measured in ulps of the result.
    ranges : dict of str to (float, float)
        Least and greatest value of an argument that is not restricted as in all other functions.
    """

    paper: str
    name: str
    positional: tuple
    keywords: tuple
    force_sets: dict
    outputs: tuple
    bound: float = CLAIMED_BOUND
    unit: dict = field(default_factory=dict)
    ranges: dict = field(default_factory=dict)

    @property
    def full_name(self):
        return f"{self.paper}.{self.name}"

    def arguments(self, force_set):
        """Names of the arguments of one kernel, in order."""
        return (*self.positional, *self.keywords, *self.force_sets[force_set])

    def absent_forces(self, force_set):
        """Names of the force arguments the kernel does without; they are zero."""
        every = {name: None for names in self.force_sets.values() for name in names}
        return tuple(name for name in every if name not in self.force_sets[force_set])

    def outside(self, point):
        """Names of the arguments of a point, a dict of floats, that lie outside the function's domain."""
        angles = (-_RIGHT_ANGLE if self.paper == "chord" else 0.0, _RIGHT_ANGLE)
        least = {"theta": angles[0], **dict.fromkeys(_POSITIVE, math.ulp(0.0))}
        greatest = {"theta": angles[1]}
        usual = {n: (least.get(n, 0.0), greatest.get(n, math.inf)) for n in point}
        ranges = {**usual, **self.ranges}
        return [n for n, x in point.items() if not ranges[n][0] <= x <= ranges[n][1]]


_TABLE = (
    Function("chord", "descent_time", ("theta",), ("diameter", "g"), CHORD_FORCES, ("time",)),
    Function("chord", "distance", ("t", "theta"), ("g",), CHORD_FORCES, ("distance",)),
    Function("chord", "speed", ("t", "theta"), ("g",), CHORD_FORCES, ("speed",)),
    Function("chord", "max_angle", ("mu",), (), ONE_LAW, ("angle",)),
    Function("chord", "position", ("t", "theta"), ("g",), CHORD_FORCES, ("x", "y")),
    Function("chord", "synchronous_circle", ("t",), ("g",), CHORD_FORCES, ("X", "Y", "R")),
    Function("projectile", "flight_time", ("theta",), ("v", "g"), PROJECTILE_FORCES, ("time",)),
    Function("projectile", "horizontal_range", ("theta",), ("v", "g"), PROJECTILE_FORCES, ("range",)),
    Function(
        "projectile",
        "position",
        ("t", "theta"),
        ("v", "g"),
        PROJECTILE_FORCES,
        ("x", "y"),
        unit={"y": "ulp of the larger of its two terms"},
    ),
    Function(
        "projectile",
        "velocity",
        ("t", "theta"),
        ("v", "g"),
        PROJECTILE_FORCES,
        ("vx", "vy"),
        unit={"vy": "ulp of the larger of its two terms"},
    ),
    Function(
        "projectile",
        "range_slope_theta",
        ("theta",),
        ("v", "g"),
        PROJECTILE_FORCES,
        ("slope",),
        unit={"slope": "ulp of the larger of its two terms"},
    ),
    Function("projectile", "range_slope_k", ("theta",), ("v", "g"), PROJECTILE_FORCES, ("slope",)),
    Function("projectile", "max_range", (), ("v", "g"), PROJECTILE_FORCES, ("range",)),
    Function(
        "projectile",
        "launch_angles",
        ("r",),
        ("v", "g"),
        PROJECTILE_FORCES,
        ("low", "high"),
        unit=dict.fromkeys(
            ("low", "high"),
            "ulp of the exact result, or 2^-40 of what an ulp of the range does to it where that is more",
        ),
    ),
    Function("projectile", "best_angle", ("alpha",), (), ONE_LAW, ("angle",)),
    *(
        Function("lambert", name, ("x",), (), ONE_LAW, ("w",), ranges={"x": (_ABOVE_BRANCH_POINT, most)})
        for name, most in (("w0", math.inf), ("wm1", -math.ulp(0.0)))
    ),
    Function(
        "lambert",
        "linear_exponential_roots",
        ("a", "b", "c", "d"),
        (),
        ONE_LAW,
        ("t0", "tm1"),
        ranges=dict.fromkeys("abcd", _ANY),
    ),
)

FUNCTIONS = {function.full_name: function for function in _TABLE}
