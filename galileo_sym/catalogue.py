"""The functions worth emitting: arguments with units and domain, force sets, outputs, ledger ids."""

from dataclasses import dataclass, field, replace
from functools import cache

from sympy import And, Symbol, Tuple, cos, exp, sin, sqrt

from galileo_sym.ledger import Ledger
from galileo_sym.primitives import driving, phi1


@dataclass(frozen=True)
class Argument:
    """A public argument: its symbol in the ledger, unit, domain (a key of the emitted domain table) and meaning."""

    name: str
    symbol: str
    unit: str
    domain: str
    doc: str


WITHIN_1 = "within 1 ulp at every point sampled (claimed bound: 1 ulp; generated/certificates)"
_ROOTS_WITHIN_1 = "within 0.51 ulp at every point sampled (claimed bound: 1 ulp; generated/certificates)"
_ANGLES_WITHIN_1 = (
    f"{WITHIN_1};\nbeside the largest range at k v/g over 10^6, where an angle changes over 2^40 times as fast as the\n"
    "range, its error is below 2^-40 of what one ulp of the range does to it"
)


@dataclass(frozen=True)
class Output:
    """A public result.

    ``at_rest`` is its value where friction holds the bead (None: no such state). ``limits`` groups the arguments by
    where the result goes as they grow: arguments of two groups infinite at once leave it undecided, unless one group
    holds both.
    """

    name: str
    unit: str
    doc: str
    at_rest: float | None = None
    limits: tuple = ()


@dataclass(frozen=True)
class Ceiling:
    """The largest value of an argument for which there is a result, where all outputs are one number.

    ``most`` and ``there`` name the functions of the same paper that give the value and the number.
    """

    argument: str
    most: str
    there: str


@dataclass(frozen=True)
class Function:
    """A public function.

    ``positional`` and ``keywords`` are argument names; ``variants`` maps each force set to its force arguments and its
    printed equations (ledger ids). ``routine`` names the function (template.function) that evaluates the whole stable
    form, where that is a matter of cases (an equation to be solved is one of ``solvers``). ``primitive`` names the
    one-variable function that is the whole stable form: its kernels serve. ``domains`` gives the arguments whose domain
    is not that of the table.
    """

    paper: str
    name: str
    doc: str
    positional: tuple
    keywords: tuple
    variants: dict
    outputs: tuple
    accuracy: str = WITHIN_1
    routine: str | None = None
    primitive: str | None = None
    domains: dict = field(default_factory=dict)
    ceiling: Ceiling | None = None

    @property
    def full_name(self):
        """``paper.name``."""
        return f"{self.paper}.{self.name}"

    @property
    def forces(self):
        """Names of all force arguments, in order."""
        return max((names for names, _ in self.variants.values()), key=len)

    def arguments(self, force_set):
        """Return the arguments of one variant, in order."""
        names = (*self.positional, *self.keywords, *self.variants[force_set][0])
        found = (ARGUMENTS[self.paper][name] for name in names)
        return tuple(replace(one, domain=self.domains.get(one.name, one.domain)) for one in found)

    def ledger_id(self, force_set):
        """Return the ledger id of the stable form of one variant."""
        return f"stable.{self.full_name}" + (f".{force_set}" if force_set else "")

    def sources(self, force_set):
        """Return the ledger ids of the printed equations of one variant."""
        return self.variants[force_set][1]


def _arguments(*rows):
    return {name: Argument(name, symbol, unit, domain, doc) for name, symbol, unit, domain, doc in rows}


ARGUMENTS = {
    "chord": _arguments(
        ("t", "t", "s", "nonnegative", "time since release"),
        ("theta", "theta", "rad", "chord angle", "angle of the chord from the vertical, signed, |theta| <= pi/2"),
        ("diameter", "D", "m", "positive", "diameter of the circle"),
        ("g", "g", "m/s^2", "positive", "acceleration of gravity"),
        ("mu", "mu", "1", "nonnegative", "coefficient of sliding friction"),
        ("gamma", "gamma", "1/s", "nonnegative", "drag coefficient over mass"),
    ),
    "projectile": _arguments(
        ("t", "t", "s", "nonnegative", "time since launch"),
        ("theta", "theta", "rad", "elevation", "elevation of the launch from the horizontal, 0 <= theta <= pi/2"),
        ("v", "v", "m/s", "positive", "launch speed"),
        ("g", "g", "m/s^2", "positive", "acceleration of gravity"),
        ("k", "k", "1/s", "nonnegative", "resistance coefficient over mass"),
        ("r", "r", "m", "nonnegative", "range, at most the largest one"),
        ("alpha", "alpha", "1", "nonnegative", "k v/g, resistance at launch speed over weight"),
    ),
    "lambert": _arguments(
        ("x", "q", "1", "branch", "argument of W"),
        ("a", "a", "1/s", "real", "coefficient of t"),
        ("b", "b", "1", "real", "constant term"),
        ("c", "c", "1", "real", "coefficient of the exponential"),
        ("d", "d", "1/s", "real", "rate in the exponential"),
    ),
}

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


_OF_EITHER_SIGN = {"theta", *(argument.symbol for argument in ARGUMENTS["lambert"].values())}


def _symbol(name):
    return Symbol(name, real=True) if name in _OF_EITHER_SIGN else Symbol(name, positive=True)


_D, _g, _t, _v, _k, _r, _mu, _theta = (_symbol(s) for s in ("D", "g", "t", "v", "k", "r", "mu", "theta"))

# Intermediate results that emitted code names: factored out of any product that contains them, the first that fits.
NAMED = {
    "lambert": {},
    "chord": {
        "t0": (sqrt(_D * cos(_theta) / (_g * driving(_theta, _mu))), sqrt(_D / _g)),
        "fall": (_g * _t**2,),
    },
    "projectile": {
        "rise": (_v * sin(_theta) / _g,),
        "reach": (_v * _t * phi1(-_k * _t), _v * _t),
        "fall": (_g * _t**2,),
        "fade": (exp(-_k * _t),),
    },
}


# Pure numbers that functions with a ceiling are computed from; alpha is 0 where k is absent.
PURE = {"rho": _g * _r / _v**2, "alpha": _k * _v / _g}


class NotDerived(ValueError):
    """A stable form has no derivation that reaches it."""


@cache
def ledger():
    """Return the ledger, loaded once in a process; its entries are derived only where asked for."""
    return Ledger.load()


def stable(function, force_set):
    """Return the stable form of one variant.

    Parameters
    ----------
    function : Function
    force_set : str
        A key of ``function.variants``.

    Returns
    -------
    tuple of sympy.Expr
        One for each output, in symbols of the ledger's names; or the statement itself, if it is an equation to solve.

    Raises
    ------
    KeyError
        If the ledger has no such entry.
    NotDerived
        If its derivation failed: what is emitted is what was derived.
    """
    entry = ledger()[function.ledger_id(force_set)]
    statement = entry.result
    if statement is None:
        raise NotDerived(f"{entry.id} could not be derived: run `galileo-sym derive {entry.id}` to see why")
    if isinstance(statement, And):
        return (in_catalogue_symbols(statement),)
    forms = statement.rhs if isinstance(statement.rhs, Tuple) else (statement.rhs,)
    return tuple(map(in_catalogue_symbols, forms))


def in_catalogue_symbols(form):
    """Return an expression of the ledger in the symbols that are emitted: of the same names, angles real."""
    return form.xreplace({s: _symbol(s.name) for s in form.free_symbols})
