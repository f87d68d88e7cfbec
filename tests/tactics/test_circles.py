"""Circles read off, and arcs traced once: a wrong interval, offset or region is refused."""

import pytest
import sympy as sp
from sympy import Eq, Ge, Gt, Interval, Le, Lt, cos, pi, sin, sqrt

from galileo_sym.ledger import DerivationError, TracesOnce
from galileo_sym.ledger.derivation import recording
from galileo_sym.tactics import (
    read_circle,
    sine_maximum,
    trace_circle,
)

x, y, r = sp.symbols("x y r", real=True)
p = sp.Symbol("p", positive=True)
refused = pytest.raises(DerivationError)


def _eq(left, right):
    return Eq(left, right, evaluate=False)


rho = sp.Symbol("rho", nonnegative=True)
ABOVE = {
    "point": (rho * sin(2 * r), rho + rho * cos(2 * r)),
    "interval": Interval.open(-pi / 2, pi / 2),
    "equation": _eq(x**2 + (y - rho) ** 2, rho**2),
    "region": Gt(y, 0),
    "facts": {rho: Gt(rho, 0)},
}


class TestCircles:
    CIRCLE = _eq(x**2 + y**2 + 2 * p * x - 6 * y, sp.S.Zero)

    def test_centre_and_radius(self):
        seen = read_circle(_eq(3 * self.CIRCLE.lhs, sp.S.Zero), x, y)
        assert seen.centre == (-p, 3)
        assert seen.radius.equals(sqrt(p**2 + 9))

    @pytest.mark.parametrize(
        "curve", [x**2 + 2 * y**2 - 1, x**2 + y**2 + x * y - 1, x**2 - y**2, x**3 + y**2, x + y, x**2 + y**2 + x**2 * y]
    )
    def test_what_is_not_a_circle(self, curve):
        with pytest.raises(DerivationError, match="not a circle"):
            read_circle(_eq(curve, sp.S.Zero), x, y)

    UNIT = _eq(x**2 + (y - 1) ** 2, sp.S.One)
    POINT = (sin(2 * r), 1 + cos(2 * r))

    def _trace(self, **other):
        given = {
            "point": self.POINT,
            "interval": Interval(-pi / 2, pi / 2),
            "equation": self.UNIT,
            "region": sp.true,
            "offset": sp.S.Zero,
            "inverse": sp.atan(x / y),
            "facts": {},
        } | other
        with recording():
            return trace_circle(
                given["point"],
                r,
                given["interval"],
                given["equation"],
                given["region"],
                (x, y),
                given["inverse"],
                given["offset"],
                facts=given["facts"],
            )

    def test_a_whole_turn_and_each_half(self):
        assert isinstance(self._trace(), TracesOnce)
        assert isinstance(self._trace(interval=Interval(0, pi / 2), region=Ge(x, 0)), TracesOnce)
        assert isinstance(self._trace(interval=Interval(-pi / 2, 0), region=Le(x, 0)), TracesOnce)

    @pytest.mark.parametrize(
        "changed",
        [
            {"interval": Interval(0, pi / 2)},
            {"interval": Interval(-pi, pi)},
            {"interval": Interval(0, pi / 2), "region": Le(x, 0)},
            {"interval": Interval(0, pi / 4), "region": Ge(x, 0)},
            {"interval": Interval(pi / 8, pi / 2), "region": Ge(x, 0)},
            {"region": Ge(y, 0)},
            {"inverse": sp.atan(y / x)},
            {"inverse": sp.Integer(42)},
            {"equation": _eq(x**2 + y**2, sp.S.One), "point": (sin(2 * r), cos(2 * r))},  # the angle is not that at A
            {"offset": pi / 7},
            {"equation": _eq(x**2 + (y - 1) ** 2, sp.Integer(2))},
            {"equation": _eq(x**2 + (y - 2) ** 2, sp.S.One)},
            {"point": (sin(2 * r), 1 - cos(2 * r))},
            {"point": (cos(2 * r), 1 + sin(2 * r))},
            {"point": (sin(r), 1 + cos(r))},
        ],
        ids=str,
    )
    def test_a_wrong_interval_offset_or_circle_is_refused(self, changed):
        with refused:
            self._trace(**changed)

    def test_all_but_the_point_on_the_axis(self):
        claim = self._trace(**ABOVE)
        assert claim.args[2:5] == (ABOVE["interval"], ABOVE["equation"], Gt(y, 0))

    @pytest.mark.parametrize(
        "changed",
        [
            {"interval": Interval(-pi / 2, pi / 2)},
            {"interval": Interval.Ropen(-pi / 2, pi / 2)},
            {"interval": Interval.open(-pi / 2, 0)},
            {"region": Lt(y, 0)},
            {"region": Ge(y, 0)},
            {"facts": {}},
            {"facts": {rho: Ge(rho, 0, evaluate=False)}},
            {"facts": {rho: Lt(rho, 0, evaluate=False)}},
            {"facts": {rho: Gt(p, 0, evaluate=False)}},
            {"facts": {}, "interval": Interval(-pi / 2, pi / 2), "region": sp.true},
            {"point": (p * sin(2 * r), 3 + p * cos(2 * r)), "equation": _eq(x**2 + (y - 3) ** 2, p**2)},
        ],
        ids=str,
    )
    def test_what_is_not_all_but_one_point_is_refused(self, changed):
        with refused:
            self._trace(**ABOVE | changed)

    def test_the_widest_point(self):
        acute = Interval.open(0, pi / 2)
        assert sine_maximum(p * sin(2 * r + x), r, x, (0, (pi - 2 * x) / 2), acute).equals((pi / 2 - x) / 2)
        for wave, ends in ((-p, (0, pi / 2 - x)), (p * r, (0, pi / 2 - x)), (p, (0, pi / 2)), (p, (x, pi / 2 - x))):
            with refused:
                sine_maximum(wave * sin(2 * r + x), r, x, ends, acute)
        with pytest.raises(DerivationError, match="several times"):
            sine_maximum(sin(2 * r - 2 * pi), r, -2 * pi, (0, 5 * pi / 2), Interval(-2 * pi, 0))
