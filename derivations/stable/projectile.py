"""Stable forms of the projectile formulas: the value without resistance times a factor of one dimensionless number."""

from sympy import cos, sin, symbols

from galileo_sym.primitives import best_angle, flight_factor, phi1, phi2, range_factor

v, g, t, k, alpha = symbols("v g t k alpha", positive=True)
theta = symbols("theta", real=True)

_S, _C = sin(theta), cos(theta)
_b = k * v * _S / g
_z = k * t

STABLE = {
    "projectile.flight_time.free": {"flight_time": 2 * v * _S / g},
    "projectile.flight_time.drag": {"flight_time": 2 * v * _S / g * flight_factor(_b)},
    "projectile.horizontal_range.free": {"horizontal_range": 2 * v**2 * _S * _C / g},
    "projectile.horizontal_range.drag": {"horizontal_range": 2 * v**2 * _S * _C / g * range_factor(_b)},
    "projectile.position.free": {"x": v * t * _C, "y": v * t * _S - g * t**2 / 2},
    "projectile.position.drag": {"x": v * t * _C * phi1(-_z), "y": v * t * _S * phi1(-_z) - g * t**2 * phi2(-_z)},
    "projectile.best_angle": {"best_angle": best_angle(alpha)},
}
