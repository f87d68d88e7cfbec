"""Inputs that are always tried: the papers' own scenes, and inputs known to defeat other codes."""

import math

_TENTHS_OF_TAU = (0.2, 0.4, 0.6, 0.8, 1.0)
_SHARES_OF_RIGHT_ANGLE = (-0.65, -0.5, -0.25, 0.0, 0.1, 0.3, 0.5, 0.65)


def _chord_scene(mu, gamma_tau):
    """Figures 2, 3, 5 and 7: D = 1 m, g = 9.81 m/s2, times in fifths of tau = sqrt(2 D/g)."""
    tau = math.sqrt(2.0 / 9.81)
    return [
        {
            "theta": share * (math.pi / 2),
            "t": part * tau,
            "diameter": 1.0,
            "g": 9.81,
            "mu": mu,
            "gamma": gamma_tau / tau,
        }
        for part in _TENTHS_OF_TAU
        for share in _SHARES_OF_RIGHT_ANGLE
    ]


def _projectile_scene(rates):
    """Figure 4: v = 50, g = 32.2 (feet), several k."""
    return [
        {
            "theta": angle / 10,
            "t": part * 3.1 * math.ldexp(angle, -4),
            "v": 50.0,
            "g": 32.2,
            "k": k,
            "r": 0.99 * part * 2500.0 / (32.2 + 50.0 * k),
        }
        for k in rates
        for angle in range(1, 16, 2)
        for part in _TENTHS_OF_TAU
    ]


def _impact_scene():
    """The impact equation of figure 4, -k t - u + u exp(-k t) = 0 with u = -1 - (k v/g) sin(theta)."""
    lifts = [(k, -1.0 - k * 50.0 / 32.2 * share) for k in (0.1, 0.5, 2.0) for share in (0.1, 0.5, 0.9)]
    return [{"a": -k, "b": -u, "c": u, "d": -k} for k, u in lifts]


def _descent_scene():
    """(30) in the form t - (1 + c)/gamma + exp(-gamma t)/gamma = 0, both roots, with c = gamma**2 D/g."""
    rates = (0.01, 0.1, 0.5, 1.0, 4.0)
    return [{"a": 1.0, "b": -(1 / k + k / 9.81), "c": 1 / k, "d": -k} for k in rates]


_DESCENT_ARGUMENTS = [{"x": -math.exp(-1.0 - rate * rate / 9.81)} for rate in (0.1, 0.5, 1.0, 3.0, 10.0)]

SCENES = {
    ("chord", "free"): _chord_scene(0.0, 0.0),
    ("chord", "friction"): _chord_scene(0.50, 0.0),
    ("chord", "drag"): _chord_scene(0.0, 0.50),
    ("chord", "friction_drag"): _chord_scene(0.36, 0.50),
    ("chord", "all"): [{"mu": mu} for mu in (0.0, 0.1, 0.36, 0.5, 1.0, 2.0)],
    ("projectile", "free"): _projectile_scene((0.0,)),
    ("projectile", "drag"): _projectile_scene((0.1, 0.25, 0.5, 1.0, 2.0)),
    ("projectile", "all"): [{"alpha": k * 50.0 / 32.2} for k in (0.0, 0.05, 0.1, 0.25, 0.5, 0.644, 1.0, 2.0, 5.0)],
    ("lambert.w0", "all"): [{"x": x} for x in (0.0, 1.0, math.e, 10.0)] + _DESCENT_ARGUMENTS,
    ("lambert.wm1", "all"): _DESCENT_ARGUMENTS,
    ("lambert.linear_exponential_roots", "all"): _impact_scene() + _descent_scene(),
}

_LEVEL = {"theta": 0.0, "diameter": 1.0, "g": 9.81}
_THROW = {"theta": 0.5, "v": 10.0, "g": 9.81}


def _exact(**arguments):
    """A point of hexadecimal floats."""
    return {name: float.fromhex(text) for name, text in arguments.items()}


KNOWN_HARD = {
    ("chord.descent_time", "drag"): [
        {**_LEVEL, "gamma": 1e-8},
        {**_LEVEL, "gamma": 1e-200},
        {"theta": 0.0, "diameter": 1e250, "g": 1e250, "gamma": 1e100},
        {"theta": 0.0, "diameter": 1e-200, "g": 1e200, "gamma": 1.0},
        {"theta": 0.0, "diameter": 1e200, "g": 1e-200, "gamma": 1e-150},
    ],
    ("chord.descent_time", "friction_drag"): [
        {"theta": 1.1071487177940904, "diameter": 1.0, "g": 9.81, "mu": 0.5, "gamma": 1.0},
    ],
    ("chord.distance", "drag"): [
        {"t": 1.0, "theta": 0.5, "g": 9.81, "gamma": 1e-9},
        {"t": 1.0, "theta": 0.5, "g": 9.81, "gamma": 1e-170},
        {"t": 1e250, "theta": 0.5, "g": 1e-300, "gamma": 1e250},
    ],
    # the worst of 100000 points a stratum, where friction nearly holds the bead
    ("chord.distance", "friction_drag"): [
        _exact(
            t="0x1.bfba09a9cc79ap-1",
            theta="0x1.e77414af7180cp-2",
            g="0x1.73e1415a7f4b6p+4",
            mu="0x1.f00561e9e4060p+0",
            gamma="0x1.da02ed08b4230p-2",
        ),
    ],
    ("chord.position", "friction"): [
        _exact(
            t="0x1.354617dbc9b7cp+2",
            theta="-0x1.03d5e3e642e93p+0",
            g="0x1.35d5fe14f3ee2p+3",
            mu="0x1.3dabe44ede616p-1",
        ),
    ],
    ("chord.position", "friction_drag"): [
        _exact(
            t="0x1.deb920e87da68p-1",
            theta="0x1.b030f6a8e62a9p-1",
            g="0x1.40230aa4bab38p+2",
            mu="0x1.c6a7acae1615ap-1",
            gamma="0x1.05b769b3b9cfcp+2",
        ),
    ],
    ("chord.speed", "drag"): [
        {"t": 1.0, "theta": 0.5, "g": 9.81, "gamma": 1e-9},
        {"t": 1e250, "theta": 0.5, "g": 1e-250, "gamma": 1e-250},
        {"t": 1e250, "theta": 0.5, "g": 1e250, "gamma": 1e250},
    ],
    ("chord.max_angle", "all"): [{"mu": mu} for mu in (5e-324, 1e-16, 1.0 - 2.0**-53, 1e16, 1.7e308)],
    ("projectile.velocity", "drag"): [
        {**_THROW, "t": 0.5, "k": 1e-9},
        {**_THROW, "t": 1e250, "v": 1e250, "g": 1e-250, "k": 1e-250},
        {**_THROW, "t": 745.0, "k": 1.0},
        {**_THROW, "t": 1400.0, "v": 1e300, "k": 1.0},
    ],
    ("projectile.range_slope_theta", "drag"): [
        {**_THROW, "k": 1e-9},
        {"theta": math.pi / 4, "v": 1e150, "g": 1e10, "k": 1e-250},
        {"theta": 1e-250, "v": 1e250, "g": 1e10, "k": 1e250},
    ],
    ("projectile.range_slope_k", "drag"): [
        {**_THROW, "k": 1e-9},
        {"theta": 0.5, "v": 1e250, "g": 1e250, "k": 1e-250},
        {"theta": 0.5, "v": 1e250, "g": 1e250, "k": 1e20},
    ],
    ("projectile.max_range", "drag"): [
        {"v": 10.0, "g": 9.81, "k": 1e-9},
        {"v": 1e250, "g": 1e250, "k": 1e-250},
        {"v": 1e250, "g": 1e-250, "k": 1e250},
    ],
    ("projectile.flight_time", "drag"): [{**_THROW, "k": 1e-9}, {**_THROW, "k": 1e-8}],
    ("projectile.horizontal_range", "drag"): [{**_THROW, "k": 1e-9}, {**_THROW, "k": 1e-8}],
    ("projectile.position", "drag"): [{**_THROW, "t": 0.5, "k": 1e-9}],
    ("lambert.w0", "all"): [{"x": x} for x in (-0.3678794411714423, 5e-324, -5e-324, 1.7976931348623157e308)],
    ("lambert.wm1", "all"): [{"x": x} for x in (-0.3678794411714423, -5e-324)],
    ("lambert.linear_exponential_roots", "all"): [
        dict(zip("abcd", coefficients, strict=True))
        for coefficients in (
            (1.0, 2.0, -1.0, 1.0),
            (1.0, 1.0, -1.0, 1.0),
            (1.0, 1.0 + 2.0**-52, -1.0 - 2.0**-52, 1.0),
            (1.0, 1.0, -1.0 - 2.0**-52, 1.0),
            (1.0, -1e300, 3.0, 1.0),
            (1.0, 1e300, -3.0, 1.0),
            (1e250, 1.0, -1e-300, 1e250),
            (1e-300, 1e200, -1e300, 1e150),
        )
    ],
    ("projectile.launch_angles", "drag"): [
        {"r": 1e-300, "v": 10.0, "g": 9.81, "k": 0.1},
        {"r": 0.0, "v": 10.0, "g": 9.81, "k": 0.1},
        {"r": 1e250, "v": 1e250, "g": 1e-250, "k": 1e-100},
        {"r": 1e-250, "v": 1e-120, "g": 1e-10, "k": 1e100},
        {"r": 0.99999, "v": 1e100, "g": 1e-100, "k": 1e100},
        {"r": 8.0, "v": 10.0, "g": 9.81, "k": 1e-200},
    ],
    ("projectile.best_angle", "all"): [{"alpha": alpha} for alpha in (1.0 + 2.0**-52, 1.0, 1.5e-8, 1e155, 1e200)],
}
