"""The table of public functions."""

from .functions import WITHIN_1, Ceiling, Function, Output

_ROOTS_WITHIN_1 = "within 0.51 ulp at every point sampled (claimed bound: 1 ulp; generated/certificates)"
_ANGLES_WITHIN_1 = (
    f"{WITHIN_1};\nbeside the largest range at k v/g over 10^6, where an angle changes over 2^40 times as fast as the\n"
    "range, its error is below 2^-40 of what one ulp of the range does to it"
)

_FORCES = {"free": (), "friction": ("mu",), "drag": ("gamma",), "friction_drag": ("mu", "gamma")}
_RESISTANCE = {"free": (), "drag": ("k",)}


def _variants(forces, *sources):
    return {name: (arguments, ids) for (name, arguments), ids in zip(forces.items(), sources, strict=True)}


_SPEED = (("t", "g"), ("t", "gamma"))
_ALONG_CHORD = (("t", "g"), ("gamma",))
_ACROSS_CIRCLE = (("t", "g", "mu"), ("gamma",))

_TABLE = (
    Function(
        "chord",
        "descent_time",
        "Time a bead released from rest takes along a chord from the top of a vertical circle.",
        ("theta",),
        ("diameter", "g"),
        _variants(_FORCES, ("chord.eq4",), ("chord.eq17", "chord.eq18"), ("chord.eq36",), ("chord.eq43",)),
        (Output("time", "s", "descent time", float("inf"), (("diameter", "gamma"), ("g",))),),
    ),
    Function(
        "chord",
        "distance",
        "Distance a bead released from rest has gone along a chord.",
        ("t", "theta"),
        ("g",),
        _variants(_FORCES, ("chord.eq1",), ("chord.eq15",), ("chord.eq29",), ("chord.eq41",)),
        (Output("distance", "m", "distance from the top", 0.0, _ALONG_CHORD),),
    ),
    Function(
        "chord",
        "speed",
        "Speed along a chord of a bead released from rest.",
        ("t", "theta"),
        ("g",),
        _variants(_FORCES, ("chord.eq1",), ("chord.eq15",), ("chord.eq29",), ("chord.eq41",)),
        (Output("speed", "m/s", "speed", 0.0, _SPEED),),
    ),
    Function(
        "chord",
        "position",
        "Position of a bead released from rest at the top, x to the right and y down.",
        ("t", "theta"),
        ("g",),
        _variants(
            _FORCES,
            ("chord.eq5", "chord.eq6"),
            ("chord.eq19", "chord.eq20"),
            ("chord.setup", "chord.eq29"),
            ("chord.setup", "chord.eq41"),
        ),
        (
            Output("x", "m", "horizontal coordinate, of the sign of theta", 0.0, _ALONG_CHORD),
            Output("y", "m", "depth below the top", 0.0, _ALONG_CHORD),
        ),
    ),
    Function(
        "chord",
        "synchronous_circle",
        "Circle on which beads released together are found: centre (-X, Y) for theta > 0, (X, Y) for theta < 0.",
        ("t",),
        ("g",),
        _variants(
            _FORCES,
            ("chord.eq9", "chord.eq10"),
            ("chord.eq21", "chord.eq22"),
            ("chord.eq31", "chord.eq32"),
            ("chord.eq45", "chord.eq46", "chord.eq47"),
        ),
        (
            Output("X", "m", "distance of the centre from the vertical, X >= 0", None, _ACROSS_CIRCLE),
            Output("Y", "m", "depth of the centre below the top", None, _ALONG_CHORD),
            Output("R", "m", "radius", None, _ACROSS_CIRCLE),
        ),
    ),
    Function(
        "chord",
        "max_angle",
        "Angle from the vertical from which on friction holds a bead at rest.",
        ("mu",),
        (),
        {"": ((), ("chord.eq13",))},
        (Output("angle", "rad", "angle from which on a bead stays at rest; pi/2 without friction"),),
    ),
    Function(
        "projectile",
        "flight_time",
        "Time until a projectile is back at the height of its launch.",
        ("theta",),
        ("v", "g"),
        _variants(_RESISTANCE, ("projectile.nodrag.impact",), ("projectile.impact.time",)),
        (Output("time", "s", "flight time", None, (("v",), ("g",))),),
    ),
    Function(
        "projectile",
        "horizontal_range",
        "Horizontal distance at which a projectile is back at the height of its launch.",
        ("theta",),
        ("v", "g"),
        _variants(_RESISTANCE, ("projectile.nodrag.range",), ("projectile.range.exp",)),
        (Output("range", "m", "range", None, (("v",), ("g", "k"))),),
    ),
    Function(
        "projectile",
        "position",
        "Position of a projectile launched from the origin, y up.",
        ("t", "theta"),
        ("v", "g"),
        _variants(
            _RESISTANCE,
            ("projectile.nodrag.x", "projectile.nodrag.y"),
            ("projectile.drag.x", "projectile.drag.y"),
        ),
        (
            Output("x", "m", "horizontal distance", None, (("v",), ("k",))),
            Output("y", "m", "height above the launch", None, (("v",), ("t", "g"), ("k",))),
        ),
        f"{WITHIN_1};\nerrors of y are in ulp of the larger of its two terms, which cancel at landing",
    ),
    Function(
        "projectile",
        "velocity",
        "Velocity of a projectile, y up.",
        ("t", "theta"),
        ("v", "g"),
        _variants(
            _RESISTANCE,
            ("projectile.nodrag.x", "projectile.nodrag.y"),
            ("projectile.drag.vx", "projectile.drag.vy"),
        ),
        (
            Output("vx", "m/s", "horizontal velocity", None, (("v",), ("t", "k"))),
            Output("vy", "m/s", "upward velocity", None, (("v",), ("t", "g"), ("t", "k"))),
        ),
        f"{WITHIN_1};\nerrors of vy are in ulp of the larger of its two terms, which cancel at the apex",
    ),
    Function(
        "projectile",
        "range_slope_theta",
        "Derivative of the range with respect to the elevation.",
        ("theta",),
        ("v", "g"),
        _variants(_RESISTANCE, ("projectile.nodrag.range",), ("projectile.lemma.f",)),
        (Output("slope", "m/rad", "dR/dtheta", None, (("v",), ("g", "k"))),),
        f"{WITHIN_1};\nerrors are in ulp of the larger of its two terms, which cancel at the angle of greatest range",
    ),
    Function(
        "projectile",
        "range_slope_k",
        "Derivative of the range with respect to the resistance coefficient; without resistance its limit.",
        ("theta",),
        ("v", "g"),
        _variants(_RESISTANCE, ("projectile.lemma.e",), ("projectile.lemma.e",)),
        (Output("slope", "m s", "dR/dk", None, (("v",), ("g", "k"))),),
    ),
    Function(
        "projectile",
        "max_range",
        "Greatest range, over all elevations.",
        (),
        ("v", "g"),
        _variants(_RESISTANCE, ("projectile.nodrag.claim.max-pi4",), ("projectile.thm3", "projectile.range.u")),
        (Output("range", "m", "greatest range", None, (("v",), ("g", "k"))),),
    ),
    Function(
        "projectile",
        "launch_angles",
        "Both elevations that reach a range; where it is the largest one, the best angle twice.",
        ("r",),
        ("v", "g"),
        _variants(_RESISTANCE, ("projectile.nodrag.claim.pairs",), ("projectile.thm2.a", "projectile.range.exp")),
        (
            Output("low", "rad", "elevation of the low shot", None, (("v",), ("g", "k"))),
            Output("high", "rad", "elevation of the high shot", None, (("v",), ("g", "k"))),
        ),
        _ANGLES_WITHIN_1,
        ceiling=Ceiling("r", "max_range", "best_angle"),
    ),
    Function(
        "projectile",
        "best_angle",
        "Elevation of greatest range, for a given ratio of resistance to weight.",
        ("alpha",),
        (),
        {"": ((), ("projectile.thm3",))},
        (Output("angle", "rad", "elevation of greatest range"),),
        primitive="best_angle",
    ),
    Function(
        "lambert",
        "w0",
        "Principal real branch of the Lambert W function: the w >= -1 with w exp(w) = x.",
        ("x",),
        (),
        {"": ((), ("projectile.res1",))},
        (Output("w", "1", "W0(x), >= -1"),),
        primitive="w0",
    ),
    Function(
        "lambert",
        "wm1",
        "Lower real branch of the Lambert W function: the w <= -1 with w exp(w) = x; -inf at 0, a pole.",
        ("x",),
        (),
        {"": ((), ("projectile.def.W",))},
        (Output("w", "1", "W-1(x), <= -1"),),
        primitive="wm1",
        domains={"x": "lower branch"},
    ),
    Function(
        "lambert",
        "linear_exponential_roots",
        "Real roots of a t + b + c exp(d t) = 0, by both branches of W; NaN for a root that does not exist.",
        ("a", "b", "c", "d"),
        (),
        {"": ((), ("projectile.res3", "beyond.real-roots.two", "beyond.real-roots.one"))},
        (Output("t0", "s", "root by W0"), Output("tm1", "s", "root by W-1")),
        f"{_ROOTS_WITHIN_1}, beside a double root, too",
        routine="roots.linear_exponential_roots",
    ),
)

FUNCTIONS = {function.full_name: function for function in _TABLE}
