"""The tactics of the chord and stable chapters: each does what it says, and refuses what it cannot show."""

import pytest
import sympy as sp
from sympy import And, Eq, Ge, Gt, Interval, LambertW, Le, Limit, Lt, Rational, cos, exp, oo, pi, sin, sqrt

from galileo_sym.ledger import DerivationError, StrictlyDecreasing, StrictlyIncreasing, TracesOnce
from galileo_sym.ledger.derivation import recording
from galileo_sym.primitives import descent_factor, phi2
from galileo_sym.tactics import (
    arguments_reversed,
    at_rest,
    elementary_limit,
    eliminate,
    eliminate_angle,
    first_order,
    implicit_derivative,
    integrate_from_zero,
    introduce,
    inverse_between,
    isolate,
    ladder,
    least_value,
    limit_along,
    limit_by_parameter,
    monotone_by_slope,
    not_negative,
    positive_before_root,
    read_circle,
    sign_by_factors,
    sine_maximum,
    solve_motion,
    start_of,
    substitute,
    trace_circle,
    undo,
    values_ordered,
)

x, y, r, z = sp.symbols("x y r z", real=True)
p, q, k, g = sp.symbols("p q k g", positive=True)
t = sp.Symbol("t", nonnegative=True)
s = sp.Function("s")
f = sp.Function("f")
VELOCITY = s(t).diff(t)
refused = pytest.raises(DerivationError)


def _eq(left, right):
    return Eq(left, right, evaluate=False)


class TestMotion:
    FALL = _eq(s(t).diff(t, 2), g - k * VELOCITY)

    def test_a_fall_with_drag_from_rest(self):
        """Held against a solution found by hand."""
        found = solve_motion(self.FALL, s(t), at_rest(s(t)))
        assert sp.simplify(found.rhs - (g * t / k - g / k**2 * (1 - exp(-k * t)))) == 0

    def test_the_initial_values_count(self):
        thrown = solve_motion(self.FALL, s(t), {s(0): p, VELOCITY.subs(t, 0): q}).rhs
        assert sp.simplify(thrown.subs(t, 0) - p) == 0
        assert sp.simplify(sp.diff(thrown, t).subs(t, 0) - q) == 0
        assert sp.simplify(thrown - solve_motion(self.FALL, s(t), at_rest(s(t))).rhs) != 0

    def test_a_solver_that_misses_is_caught(self, monkeypatch):
        wrong = {"equation": g * t**2 / 2, "start": 1 + g * t / k - g / k**2 * (1 - exp(-k * t))}
        for expression in wrong.values():
            monkeypatch.setattr(sp, "dsolve", lambda *_, e=expression, **__: Eq(s(t), e))
            with refused:
                solve_motion(self.FALL, s(t), at_rest(s(t)))

    def test_a_speed_at_the_start_that_is_missed_is_caught(self, monkeypatch):
        drifting = g * t / k - g / k**2 * (1 - exp(-k * t)) + (1 - exp(-k * t))
        monkeypatch.setattr(sp, "dsolve", lambda *_, **__: Eq(s(t), drifting))
        with refused:
            solve_motion(self.FALL, s(t), at_rest(s(t)))

    def test_the_start_is_found_among_equations(self):
        rest = [Eq(x, s(t)), Eq(s(0), 0), Eq(VELOCITY.subs(t, 0), q)]
        assert start_of(rest, s(t)) == {s(0): 0, VELOCITY.subs(t, 0): q}

    def test_integration_from_zero(self):
        assert integrate_from_zero(_eq(VELOCITY, g * t), s(t)).rhs.equals(g * t**2 / 2)
        with refused:
            integrate_from_zero(_eq(s(t), g * t), s(t))


class TestElimination:
    def test_a_line_from_two_equations(self):
        assert eliminate([_eq(x, 2 * r), _eq(y, 3 * r)], (r,), (x, y)).lhs.equals(3 * x - 2 * y)

    def test_an_angle_gives_the_unit_circle(self):
        found = eliminate_angle(_eq(x, sin(r)), _eq(y, cos(r)), r, (x, y))
        assert sp.expand(found.lhs / sp.Poly(found.lhs, x).LC() - (x**2 + y**2 - 1)) == 0

    def test_a_spurious_factor_must_be_named(self):
        equations = [_eq(x * (x - y) * 2, r), _eq(r, sp.S.Zero)]
        with pytest.raises(DerivationError, match="more than one factor"):
            eliminate(equations, (r,), (x, y))
        assert eliminate(equations, (r,), (x, y), spurious={x: "x > 0"}).lhs.equals(x - y)

    def test_a_factor_that_does_not_occur_cannot_be_removed(self):
        with pytest.raises(DerivationError, match="do not occur"):
            eliminate([_eq(x, r), _eq(y, r)], (r,), (x, y), spurious={x + y: "never"})

    @pytest.mark.parametrize("equations", [[_eq(x, r)], [_eq(x, r), _eq(y, r), _eq(x, 2 * r)]])
    def test_too_few_or_too_many_equations(self, equations):
        with pytest.raises(DerivationError, match="equations are left"):
            eliminate(equations, (r,), (x, y))


class TestSolving:
    def test_assumptions_choose_the_root(self):
        assert isolate(_eq(p**2, 4 * q), p).rhs.equals(2 * sqrt(q))

    def test_a_second_root_must_be_named(self):
        with pytest.raises(DerivationError, match="say which to drop"):
            isolate(_eq(x**2, 3 * x), x)
        assert isolate(_eq(x**2, 3 * x), x, drop={0: "the start"}).rhs == 3

    def test_a_root_that_is_none_cannot_be_dropped(self):
        with pytest.raises(DerivationError, match="not among"):
            isolate(_eq(x**2, 3 * x), x, drop={1: "none"})

    def test_no_root(self):
        with refused:
            isolate(_eq(p, -q - 1), p)

    def test_hidden_parts_come_back(self):
        c = sp.Symbol("c", positive=True)
        root = isolate(_eq(q, p**2 * cos(r)), p, hide={cos(r): c}).rhs
        assert sp.simplify(root**2 - q / cos(r)) == 0
        assert root.subs({q: 2, r: 1}).is_positive

    def test_substitution_on_both_sides(self):
        assert substitute(_eq(p * q, q**2), {q: 2}) == _eq(2 * p, sp.Integer(4))


class TestSigns:
    @pytest.mark.parametrize("true", [exp(z) - 1 - z, sp.sinh(z) - z, z * exp(z) + z - 2 * exp(z) + 2, z - 1 + exp(-z)])
    def test_the_ladder_climbs(self, true):
        assert ladder(true, z) == Gt(true, 0, evaluate=False)

    @pytest.mark.parametrize(
        "false",
        [
            exp(z) - 1 - 2 * z,
            1 - z,
            z - 1,
            -exp(z),
            z - sp.sinh(z),
            z**2 / 2 - exp(z) + 1 + z + z**3 / 6,
            sp.S.Zero,
            z**2 - z / 10**9,
            exp(-z) - Rational(1, 10**9),
        ],
    )
    def test_the_ladder_does_not_climb_what_is_false(self, false):
        with pytest.raises(DerivationError, match="no proof"):
            ladder(false, z)

    def test_factors_of_known_sign(self):
        assert sign_by_factors(-p * (x - y), {x - y: Lt(x, y)}) == 1
        assert sign_by_factors(-p * (x - y), {x - y: Gt(x, y)}) == -1

    @pytest.mark.parametrize("facts", [{}, {x - y: Ge(x, y)}])
    def test_an_open_sign_is_not_guessed(self, facts):
        with pytest.raises(DerivationError, match="does not follow"):
            sign_by_factors(p * (x - y), facts)

    def test_a_fact_about_something_else_is_refused(self):
        with pytest.raises(DerivationError, match="says nothing"):
            sign_by_factors(p * (x - y), {x - y: Gt(x, 2 * y)})

    def test_not_negative(self):
        assert not_negative(p * (x - y), {x - y: Ge(x, y)}) == Ge(p * (x - y), 0, evaluate=False)
        for facts in ({}, {x - y: Le(x, y)}):
            with refused:
                not_negative(p * (x - y), facts)

    def test_monotony_by_the_slope(self):
        whole, turn = Interval.open(0, oo), Interval.Ropen(0, sp.atan(1 / k))
        assert monotone_by_slope(1 / p, p, whole) == StrictlyDecreasing(1 / p, p, whole)
        assert monotone_by_slope(1 + q * sp.tan(x), x, turn) == StrictlyIncreasing(1 + q * sp.tan(x), x, turn)
        for function, variable, where in (
            (p + 1 / p, p, whole),
            (-1 / x, x, Interval(-1, 1)),  # a pole between
            (sp.tan(x), x, Interval(0, pi)),
            (sp.tan(x), x, Interval(0, pi / 2)),
            (sp.tan(2 * x), x, Interval(0, 1)),
        ):
            with refused:
                monotone_by_slope(function, variable, where)

    def test_values_are_ordered_as_the_function_goes(self):
        rising, falling = (kind(x**3, x, Interval(0, 9)) for kind in (StrictlyIncreasing, StrictlyDecreasing))
        assert values_ordered(rising, 1, 2) == Lt(1, 8, evaluate=False)
        assert values_ordered(falling, 1, 2) == Lt(8, 1, evaluate=False)
        assert values_ordered(rising, 0, p, [Lt(p, 9)]) == Lt(0, p**3, evaluate=False)
        for low, high, known in (
            (2, 1, ()),
            (-1, 2, ()),
            (1, 10, ()),
            (0, p, ()),
            (q, p, [Lt(p, 9)]),
            (p, p, [Lt(p, 9)]),
        ):
            with refused:
                values_ordered(rising, low, high, known)

    def test_positive_before_the_root(self):
        falling = StrictlyDecreasing(1 - x**2, x, Interval(0, 9))
        inside = [Ge(y, 0), Le(y, 9)]
        assert positive_before_root(falling, 1, y, inside) == sp.Equivalent(Gt(1 - y**2, 0), Lt(y, 1))
        for root, place in ((1, y), (-1, 0)):
            with pytest.raises(DerivationError, match="not shown to lie"):
                positive_before_root(falling, root, place)
        with pytest.raises(DerivationError, match="vanish"):
            positive_before_root(falling, 2, y, inside)
        with pytest.raises(DerivationError, match="decreasing"):
            positive_before_root(StrictlyIncreasing(x - 1, x, Interval(0, 9)), 1, y, inside)

    FALLING = StrictlyDecreasing(exp(-x), x, Interval(0, oo))
    BELOW, IMAGE = Lt(exp(-p), q, evaluate=False), _eq(exp(-k), q)

    def test_arguments_are_reversed(self):
        assert arguments_reversed(self.FALLING, self.BELOW, p, self.IMAGE, k) == Lt(k, p, evaluate=False)

    @pytest.mark.parametrize(
        "changed",
        [
            {"claim": StrictlyIncreasing(exp(-x), x, Interval(0, oo))},
            {"claim": StrictlyDecreasing(exp(-2 * x), x, Interval(0, oo))},
            {"claim": StrictlyDecreasing(exp(-x), x, Interval(1, oo))},
            {"below": Lt(exp(-k), q, evaluate=False)},
            {"image": _eq(exp(-k), p)},
        ],
        ids=["rising", "another function", "outside the interval", "about another place", "another value"],
    )
    def test_arguments_are_not_reversed_without_ground(self, changed):
        given = {"claim": self.FALLING, "below": self.BELOW, "image": self.IMAGE} | changed
        with refused:
            arguments_reversed(given["claim"], given["below"], p, given["image"], k)

    def test_a_place_may_be_shown_to_lie_inside(self):
        beyond = StrictlyDecreasing(exp(-x), x, Interval(1, oo))
        facts = [Le(1, p, evaluate=False), Le(1, k, evaluate=False)]
        assert arguments_reversed(beyond, self.BELOW, p, self.IMAGE, k, facts) == Lt(k, p, evaluate=False)
        for short in (facts[:1], [Le(1, p, evaluate=False), Ge(1, k, evaluate=False)]):
            with pytest.raises(DerivationError, match="not shown to lie"):
                arguments_reversed(beyond, self.BELOW, p, self.IMAGE, k, short)


class TestLimits:
    def test_elementary(self):
        assert elementary_limit((exp(z) - 1 - z) / z**2, z, 0) == Rational(1, 2)

    @pytest.mark.parametrize("w", [LambertW(z), LambertW(z, -1), 1 + LambertW(-exp(-1 - z))])
    def test_a_limit_through_w_is_refused(self, w):
        with pytest.raises(DerivationError, match="LambertW"):
            elementary_limit(w / z, z, 0)

    def test_along_a_path(self):
        path = sqrt(2 * (p - 1 + exp(-p)))
        assert limit_by_parameter(p / path, x, 0, "+", p, path, 0) == 1

    @pytest.mark.parametrize(("path", "direction"), [(1 + p, "+"), (p, "-"), (-p, "+"), (p**0, "+")])
    def test_a_path_that_goes_elsewhere_is_refused(self, path, direction):
        known = _eq(Limit(f(x), x, 0, direction), sp.S.One)
        with refused:
            limit_along(known, p, path, 0)

    def test_a_known_limit_along_a_path(self):
        assert limit_along(_eq(Limit(f(x), x, -1, "-"), q), p, -1 - p, 0) == q


ABOVE = {
    "point": (p * sin(2 * r), p + p * cos(2 * r)),
    "interval": Interval.open(-pi / 2, pi / 2),
    "equation": _eq(x**2 + (y - p) ** 2, p**2),
    "region": Gt(y, 0),
    "positive": Lt(0, 2 * p, evaluate=False),
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
            "positive": None,
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
                positive=given["positive"],
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
            {"positive": None},
            {"positive": Lt(0, y, evaluate=False)},
            {"positive": Lt(2 * p, 0, evaluate=False)},
            {"positive": Ge(p, 0, evaluate=False)},
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


class TestFactors:
    DESCENT = 1 / k + k * p / g + LambertW(-exp(-1 - k**2 * p / g)) / k
    FACTOR = descent_factor(k * sqrt(2 * p / g))

    def test_w_is_taken_out(self):
        form = introduce(self.DESCENT, self.FACTOR)
        assert form.equals(sqrt(2 * p / g) * self.FACTOR)
        assert not form.has(LambertW)

    @pytest.mark.parametrize("factor", [descent_factor(k * sqrt(p / g)), descent_factor(2 * k * sqrt(2 * p / g))])
    def test_a_factor_at_another_argument_is_refused(self, factor):
        with refused:
            introduce(self.DESCENT, factor)

    def test_another_branch_is_refused(self):
        other = self.DESCENT.xreplace({w: LambertW(w.args[0], -1) for w in self.DESCENT.atoms(LambertW)})
        with refused:
            introduce(other, self.FACTOR)

    def test_an_exponential_is_taken_out(self):
        fallen = t / k - (1 - exp(-k * t)) / k**2
        assert introduce(fallen, phi2(-k * t), closed=exp).equals(t**2 * phi2(-k * t))
        for factor in (phi2(k * t), phi2(-2 * k * t)):
            with refused:
                introduce(fallen, factor, closed=exp)

    def test_first_order(self):
        slope = Rational(1, 6)
        assert first_order(p * descent_factor(q * k), k, {descent_factor: slope}) == (p, p * q / 6)
        value, wrong = first_order(p * descent_factor(q * k), k, {descent_factor: slope / 2})
        assert (value, wrong) == (p, p * q / 12)

    @pytest.mark.parametrize("argument", [q * k**2, 1 + k, exp(k)])
    def test_first_order_needs_an_argument_proportional_to_the_force(self, argument):
        with pytest.raises(DerivationError, match="not a multiple"):
            first_order(descent_factor(argument), k, {descent_factor: Rational(1, 6)})


class TestInverses:
    RISING = StrictlyIncreasing(x * exp(x), x, Interval(-1, oo))
    ROUND = _eq(LambertW(y) * exp(LambertW(y)), y)

    def test_w_undoes_f_where_it_takes_its_values(self):
        found = undo(self.RISING, self.ROUND, Ge(LambertW(y), -1, evaluate=False), z)
        assert found == sp.Equivalent(_eq(LambertW(z * exp(z)), z), Ge(z, -1, evaluate=False))

    def test_w_undoes_nothing_beyond(self):
        for claim, trip in (
            (StrictlyIncreasing(x * exp(x), x, Interval(0, oo)), self.ROUND),
            (self.RISING, _eq(2 * LambertW(y) * exp(LambertW(y)), y)),
        ):
            with refused:
                undo(claim, trip, Ge(LambertW(y), -1, evaluate=False), z)

    def test_bounds_of_the_inverse(self):
        bounds = And(Gt(q, x * exp(x), evaluate=False).subs(x, -1), Lt(q, 0, evaluate=False), evaluate=False)
        sides = And(Gt(y, -exp(-1), evaluate=False), Lt(y, 0, evaluate=False), evaluate=False)
        values = Ge(LambertW(y), -1, evaluate=False)
        assert inverse_between(self.RISING, self.ROUND, values, y, 0, sides).args
        with refused:
            inverse_between(self.RISING, self.ROUND, values, y, 0, bounds)

    def test_the_derivative_of_w(self):
        w = f(x)
        found = implicit_derivative(_eq(w * exp(w), x), w, x)
        assert found.rhs.equals(exp(-w) / (1 + w))
        with refused:
            implicit_derivative(_eq(x**2, sp.S.One), w, x)

    def test_least_value(self):
        falls, rises = StrictlyDecreasing(x**2, x, Interval(-oo, 0)), StrictlyIncreasing(x**2, x, Interval(0, oo))
        assert least_value(falls, rises) == Ge(x**2, 0, evaluate=False)
        gap = StrictlyIncreasing(x**2, x, Interval(1, oo))
        other = StrictlyIncreasing(x**4, x, Interval(0, oo))
        for pair in ((falls, gap), (falls, other), (rises, falls), (falls, falls)):
            with refused:
                least_value(*pair)
