"""Stable forms of the chord formulas: the drag-free value times a factor of one dimensionless number."""

from sympy import cos, sin, sqrt, symbols

from galileo_sym.primitives import descent_factor, driving, phi2

D, g, t, mu, gamma = symbols("D g t mu gamma", positive=True)
theta = symbols("theta", real=True)

_n = driving(theta, mu)
_drag = 2 * phi2(-gamma * t)
_fall = g * t**2 / 2
_time = sqrt(2 * D / g)
_slow_time = sqrt(2 * D * cos(theta) / (g * _n))
_oblique = sqrt(1 + mu**2)


def _position(distance):
    return {"x": distance * sin(theta), "y": distance * cos(theta)}


STABLE = {
    "chord.descent_time.free": {"descent_time": _time},
    "chord.descent_time.friction": {"descent_time": _slow_time},
    "chord.descent_time.drag": {"descent_time": _time * descent_factor(gamma * _time)},
    "chord.descent_time.friction_drag": {"descent_time": _slow_time * descent_factor(gamma * _slow_time)},
    "chord.distance.free": {"distance": _fall * cos(theta)},
    "chord.distance.friction": {"distance": _fall * _n},
    "chord.distance.drag": {"distance": _fall * cos(theta) * _drag},
    "chord.distance.friction_drag": {"distance": _fall * _n * _drag},
    "chord.position.free": _position(_fall * cos(theta)),
    "chord.position.friction": _position(_fall * _n),
    "chord.position.drag": _position(_fall * cos(theta) * _drag),
    "chord.position.friction_drag": _position(_fall * _n * _drag),
    "chord.synchronous_circle.free": {"X": 0 * g, "Y": _fall / 2, "R": _fall / 2},
    "chord.synchronous_circle.friction": {"X": mu * _fall / 2, "Y": _fall / 2, "R": _oblique * _fall / 2},
    "chord.synchronous_circle.drag": {"X": 0 * g, "Y": _fall * _drag / 2, "R": _fall * _drag / 2},
    "chord.synchronous_circle.friction_drag": {
        "X": mu * _fall * _drag / 2,
        "Y": _fall * _drag / 2,
        "R": _oblique * _fall * _drag / 2,
    },
}
